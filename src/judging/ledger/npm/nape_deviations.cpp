#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "judging/ledger/npm/npm_deviations.hpp"

// nape in JavaScript.

namespace manifuzz {
namespace {

constexpr double kEpsilonOfNape = 1e-8;  // nape.Config.epsilon
constexpr double kSquareOfNape = kEpsilonOfNape * kEpsilonOfNape;

/// ZPP_Polygon.splice_collinear_real: a corner within epsilon of the next goes, and then each whose
/// sides' cross product is below epsilon, until there is none.
std::vector<Vector2<double>> spliced_by_nape(std::vector<Vector2<double>> corners) {
  const auto at = [&](std::size_t i) -> const Vector2<double>& {
    return corners[i % corners.size()];
  };
  const auto erase = [&](std::size_t i) {
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i % corners.size()));
  };
  for (std::size_t i = 0; i < corners.size();) {
    const Vector2<double> apart = at(i) - at(i + 1);
    if (apart.x() * apart.x() + apart.y() * apart.y() < kSquareOfNape) {
      erase(i);
    } else {
      ++i;
    }
  }
  for (bool is_removed = true; is_removed && !corners.empty();) {
    is_removed = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector2<double> a = at(i + 1) - at(i);
      const Vector2<double> b = at(i + 2) - at(i + 1);
      const double cross = b.y() * a.x() - b.x() * a.y();
      if (cross * cross >= kSquareOfNape) continue;
      // The first is erased from before this one.
      const bool is_first = i + 1 == corners.size();
      erase(i + 1);
      is_removed = true;
      if (is_first) --i;
    }
  }
  return corners;
}

/// The corners that it keeps of a shape, as the case has them; the adapter hands them over as much
/// longer as the rotation is longer than unit.
std::vector<Vector2<double>> kept_of(const Body& body) {
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  const double length = std::sqrt(rotation.x() * rotation.x() + rotation.y() * rotation.y());
  std::vector<Vector2<double>> corners;
  for (int i = 0; i < body.polygon.count; ++i) {
    corners.emplace_back(length * body.polygon.vertices[i].cast<double>());
  }
  const std::vector<Vector2<double>> kept = spliced_by_nape(corners);
  std::vector<Vector2<double>> stored;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (std::ranges::find(kept, corners[i]) == kept.end()) continue;
    stored.emplace_back(body.polygon.vertices[static_cast<int>(i)].cast<double>());
  }
  return stored;
}

bool is_used(const exact::StoredPolygon& used, const std::vector<Vector2<double>>& kept) {
  return std::ranges::equal(kept,
                            std::span(used.vertices).first(static_cast<std::size_t>(used.count)));
}

/// Whether two places are within its epsilon, and the answer is what it gives of such.
bool is_axis_of_nape(const Deviation& d, Side circle, const Vector2<double>& centre,
                     const Vector2<double>& corner) {
  const PairCase& pair = d.right.pair();
  const double bound = 2 * d.right.bounds.separation;
  if ((centre - corner).norm() > kEpsilonOfNape + bound) return false;
  const Vector2<double> at =
      to_world(pair, d.got.points[0].position) - pair.a.pose.position.cast<double>();
  return (at - centre).norm() <= bound + d.right.bounds.position &&
         pair[circle].polygon.count == 1 &&
         std::abs(d.got.points[0].depth - total_radius(pair)) <= bound;
}

/// An end of the incident edge that is given as it is, though it is beyond a side plane by no more
/// than epsilon of the edge; the answer with the place where it is cut.
bool is_right_if_clipped(const Deviation& d, const exact::Clip& clip) {
  Manifold<double> mended = d.got;
  bool is_mended = false;
  const exact::RoughPair placed = exact::place_roughly(*clip.pair);
  const Vector2<double> turn = d.right.pair().a.pose.rotation.cast<double>();
  for (const exact::ClipPoint& cut : points_of(clip)) {
    if (!cut.crossing) continue;
    const Vector2<double>& corner =
        placed[other(clip.reference.side)].vertices[clip.vertex(cut.end)];
    const double beyond = (corner - rotate<double>(turn, cut.position())).norm();
    if (beyond > kEpsilonOfNape * clip.edge_length + d.right.bounds.separation) continue;
    for (int i = 0; i < mended.count; ++i) {
      ContactPoint<double>& point = mended.points[i];
      if ((rotate<double>(turn, point.position) - corner).norm() > d.right.bounds.position)
        continue;
      point = {cut.position(), cut.depth(), cut.features};
      is_mended = true;
    }
  }
  return is_mended && mismatch(mended, clip, d.right).kind == Kind::none;
}

}  // namespace

bool corners_spliced_by_nape(const Deviation& d) {
  if (d.kind != Kind::altered_shape) return false;
  const PairCase& pair = d.right.pair();
  const exact::StoredPair& used = d.right.truth->stored();
  return is_used(used.a.polygon, kept_of(pair.a)) && is_used(used.b.polygon, kept_of(pair.b));
}

bool axis_within_nape_epsilon(const Deviation& d) {
  if (d.got.count != 1) return false;
  const PairCase& pair = d.right.pair();
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  const Vector2<double> normal = rotate<double>(turn, d.got.normal);
  if (std::abs(std::abs(normal.x()) - 1) > d.right.bounds.normal ||
      std::abs(normal.y()) > d.right.bounds.normal) {
    return false;
  }
  const exact::RoughPair placed = exact::place_roughly(pair);
  for (const Side side : {Side::a, Side::b}) {
    const exact::RoughPolygon& of = placed[other(side)];
    if (std::any_of(of.vertices.begin(), of.vertices.begin() + of.count,
                    [&](const Vector2<double>& corner) {
                      return is_axis_of_nape(d, side, placed[side].vertices[0], corner);
                    })) {
      return true;
    }
  }
  return false;
}

bool unclipped_within_nape_epsilon(const Deviation& d) {
  return (d.kind == Kind::position || d.kind == Kind::depth) &&
         std::ranges::any_of(d.right.candidates, [&](const exact::Clip* clip) {
           return is_right_if_clipped(d, *clip);
         });
}

}  // namespace manifuzz
