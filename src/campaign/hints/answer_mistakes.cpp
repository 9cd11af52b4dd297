#include "campaign/hints/answer_mistakes.hpp"

#include <functional>

namespace manifuzz {
namespace {

using Vector = Vector2<double>;

/// Where an answer names a normal and depths, with both mapped; points are put in order anew.
struct Mapped {
  std::function<Vector(const Vector& normal)> normal{};
  std::function<double(double depth)> depth{};
  std::function<Vector(const Vector& position)> position{};
};

void map(Manifold<double>& manifold, const Mapped& by) {
  if (by.normal) manifold.normal = by.normal(manifold.normal);
  for (int i = 0; i < std::clamp(manifold.count, 0, 2); ++i) {
    ContactPoint<double>& point = manifold.points[i];
    if (by.depth) point.depth = by.depth(point.depth);
    if (by.position) point.position = by.position(point.position);
  }
  order_points(manifold);
}

MaybeUndone mapped(const AskedCase& asked, const Mapped& by) {
  Undone undone{asked.declaration, asked.answer};
  if (auto* const whole = std::get_if<Manifold<double>>(&undone.answer)) {
    if (whole->count < 1) return std::nullopt;
    map(*whole, by);
  } else if (auto* const partial = std::get_if<PartialManifold>(&undone.answer)) {
    if (partial->manifold.count < 1) return std::nullopt;
    map(partial->manifold, by);
  } else if (auto* const less = std::get_if<Penetration>(&undone.answer)) {
    if (!less->normal) return std::nullopt;
    if (by.normal) less->normal = by.normal(*less->normal);
    if (by.depth) {
      less->depth = by.depth(less->depth);
      less->touches = less->depth >= 0;
    }
  } else {
    return std::nullopt;
  }
  return undone;
}

/// Maps figures in the world; what goes there and back is rounded there.
MaybeUndone mapped_in_world(const AskedCase& asked, const std::function<Vector(Vector)>& direction,
                            const std::function<Vector(Vector)>& place) {
  const PairCase& pair = asked.pair();
  Mapped by;
  if (direction) {
    by.normal = [&](const Vector& normal) {
      return local_normal(pair, direction(world_normal(pair, normal)));
    };
  }
  if (place) {
    by.position = [&](const Vector& position) {
      return to_local(pair.a.pose, place(to_world(pair, position)));
    };
  }
  MaybeUndone undone = mapped(asked, by);
  if (undone) undone->declaration.frame = RoundingFrame::world;
  return undone;
}

}  // namespace

MaybeUndone with_normal_turned_about(const AskedCase& asked) {
  return mapped(asked, {.normal = [](const Vector& normal) { return Vector(-normal); }});
}

MaybeUndone with_depths_negated(const AskedCase& asked) {
  return mapped(asked, {.depth = [](double depth) { return -depth; }});
}

MaybeUndone with_separations_as_depths(const AskedCase& asked) {
  const double radii = total_radius(asked.pair());
  return mapped(asked, {.depth = [=](double separation) { return radii - separation; }});
}

MaybeUndone with_radii_added_to_depths(const AskedCase& asked) {
  const double radii = total_radius(asked.pair());
  if (radii == 0) return std::nullopt;
  return mapped(asked, {.depth = [=](double depth) { return depth + radii; }});
}

MaybeUndone with_radii_taken_from_depths(const AskedCase& asked) {
  const double radii = total_radius(asked.pair());
  if (radii == 0) return std::nullopt;
  return mapped(asked, {.depth = [=](double depth) { return depth - radii; }});
}

MaybeUndone with_y_negated(const AskedCase& asked) {
  const auto negated = [](const Vector& v) { return Vector(v.x(), -v.y()); };
  return mapped_in_world(asked, negated, negated);
}

MaybeUndone from_frame_of(Side side, InFrame what, const AskedCase& asked) {
  const Pose<double> pose{asked.pair()[side].pose.position.cast<double>(),
                          asked.pair()[side].pose.rotation.cast<double>()};
  const auto place = [&](const Vector& local) { return transform(pose, local); };
  const auto direction = [&](const Vector& local) {
    return Vector(rotate(pose.rotation, local) / pose.rotation.norm());
  };
  if (what == InFrame::positions) return mapped_in_world(asked, {}, place);
  if (what == InFrame::normal) return mapped_in_world(asked, direction, {});
  return mapped_in_world(asked, direction, place);
}

MaybeUndone from_world(const AskedCase& asked) {
  MaybeUndone undone = mapped(asked, {.position = [&](const Vector& world) {
                                return to_local(asked.pair().a.pose, world);
                              }});
  if (undone) undone->declaration.frame = RoundingFrame::world;
  return undone;
}

}  // namespace manifuzz
