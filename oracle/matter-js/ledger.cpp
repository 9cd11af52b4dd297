#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engines/engine.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/matter-js/replay.hpp"

// matter-js: its operations are repeated, and have to give the answer.

namespace manifuzz {
namespace {

using ledger_of::BodyOfMatter;
using ledger_of::CollisionOfMatter;

/// Whether that is the answer.
bool is_answer_of_matter(const Deviation& d, const CollisionOfMatter& found) {
  const PairCase& pair = d.right.pair();
  const Bounds& bounds = d.right.bounds;
  if (d.got.count != static_cast<int>(found.points.size())) return false;
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  if ((rotate<double>(turn, d.got.normal) - found.normal).norm() > bounds.normal) return false;
  return std::ranges::all_of(found.points, [&](const Vector2<double>& place) {
    return std::any_of(d.got.points.begin(), d.got.points.begin() + d.got.count,
                       [&](const ContactPoint<double>& point) {
                         return (to_world(pair, point.position) - place).norm() <=
                                    bounds.position &&
                                std::abs(point.depth - found.depth) <= bounds.separation;
                       });
  });
}

/// What it finds, if that is the answer.
std::optional<CollisionOfMatter> found_by_matter(const Deviation& d) {
  for (CollisionOfMatter& found :
       ledger_of::collisions_of_matter(d.right.pair(), d.right.bounds.separation)) {
    if (is_answer_of_matter(d, found)) return std::move(found);
  }
  return std::nullopt;
}

/// As matter-js.mjs declares it.
Declaration as_declared_by_matter() {
  return {.scalar = ScalarType::float64,
          .frame = RoundingFrame::world,
          .takes_angles = true,
          .clips = false,
          .points = PointsAt::vertex,
          .shares_depth = true};
}

/// Whether it tries a body's axis along this, either way.
bool is_tried(const ledger_of::BodyOfMatter& body, const Vector2<double>& along) {
  return std::ranges::any_of(
      body.axes, [&](const Vector2<double>& axis) { return axis == along || axis == -along; });
}

/// Whether it would be right if it tried every face's axis, along one that it does not try.
bool is_right_with_all_axes(const Deviation& d, const CollisionOfMatter& found) {
  const auto mended = ledger_of::collisions_of_matter(d.right.pair(), d.right.bounds.separation,
                                                      ledger_of::AxesOfMatter::all);
  if (mended.empty() || is_tried(found.a, mended[0].normal) ||
      is_tried(found.b, mended[0].normal)) {
    return false;
  }
  replayed::Contact contact{mended[0].normal, {}};
  for (const Vector2<double>& at : mended[0].points) {
    contact.points.push_back({at, mended[0].depth});
  }
  return replayed::is_right_answer(d, as_declared_by_matter(), contact);
}

bool is_about_points(Kind kind) {
  return kind == Kind::witness || kind == Kind::count || kind == Kind::extent;
}

/// Whether its two vertices of a side are the ends of an edge.
bool are_ends_of(const ledger_of::SupportsOfMatter& supports, const exact::StoredPolygon& polygon,
                 int edge) {
  const std::array<int, 2> forwards{edge, polygon.next(edge)};
  const std::array<int, 2> backwards{polygon.next(edge), edge};
  return supports.index == forwards || supports.index == backwards;
}

/// Whether both sides' supports are the edges that a right clip is made of.
bool are_right_edges(const Deviation& d, const CollisionOfMatter& found) {
  return std::ranges::any_of(d.right.candidates, [&](const exact::Clip* clip) {
    const Side side = clip->reference.side;
    const auto& of_reference = side == Side::a ? found.of_a : found.of_b;
    const auto& of_incident = side == Side::a ? found.of_b : found.of_a;
    return are_ends_of(of_reference, (*clip->pair)[side].polygon, clip->reference.index) &&
           are_ends_of(of_incident, (*clip->pair)[other(side)].polygon, clip->incident);
  });
}

/// Along the tangent, from where to where a body is as far along a direction as it reaches.
std::array<double, 2> reach_along(const BodyOfMatter& body, const Vector2<double>& direction,
                                  const Vector2<double>& tangent, double bound) {
  double most = -INFINITY;
  for (const Vector2<double>& v : body.vertices) most = std::max(most, direction.dot(v));
  std::array<double, 2> range{INFINITY, -INFINITY};
  for (const Vector2<double>& v : body.vertices) {
    if (direction.dot(v) < most - bound) continue;
    range = {std::min(range[0], tangent.dot(v)), std::max(range[1], tangent.dot(v))};
  }
  return range;
}

/// Whether no point is where both bodies reach farthest into each other.
bool is_deepest_left_out(const Deviation& d, const CollisionOfMatter& found) {
  const double bound = 2 * d.right.bounds.separation;
  const Vector2<double> tangent(-found.normal.y(), found.normal.x());
  const auto of_a = reach_along(found.a, found.normal, tangent, bound);
  const auto of_b = reach_along(found.b, Vector2<double>(-found.normal), tangent, bound);
  return std::ranges::none_of(found.points, [&](const Vector2<double>& point) {
    const double place = tangent.dot(point);
    return place >= std::max(of_a[0], of_b[0]) - bound &&
           place <= std::min(of_a[1], of_b[1]) + bound;
  });
}

/// Whether a point is a neighbour that lies behind the other end of its edge: on the side of its
/// body that is turned away from the other one.
bool is_neighbour_behind(const CollisionOfMatter& found) {
  const auto is_behind = [&](const BodyOfMatter& body, const ledger_of::SupportsOfMatter& supports,
                             const Vector2<double>& outwards) {
    const auto count = body.vertices.size();
    const auto first = static_cast<std::size_t>(supports.index[0]);
    const auto second = static_cast<std::size_t>(supports.index[1]);
    const std::size_t edge = (first + 1) % count == second ? first : second;
    return body.normals[edge].dot(outwards) <= 0 &&
           std::ranges::find(found.points, body.vertices[second]) != found.points.end();
  };
  return is_behind(found.a, found.of_a, found.normal) ||
         is_behind(found.b, found.of_b, Vector2<double>(-found.normal));
}

/// The normal has the sign that the centres give, which is not that of the least overlap.
bool normal_by_matter_centres(const Deviation& d) {
  if (is_about_points(d.kind)) return false;
  const auto found = found_by_matter(d);
  return found && found->is_turned;
}

/// A face whose gradient is another's to three decimals has less overlap than the axis taken, or
/// would be right in its place.
bool axes_merged_by_matter(const Deviation& d) {
  if (is_about_points(d.kind)) return false;
  const auto found = found_by_matter(d);
  if (!found) return false;
  const double least =
      std::min(ledger_of::least_overlap(found->a, found->b, found->a.normals).overlap,
               ledger_of::least_overlap(found->b, found->a, found->b.normals).overlap);
  return least < found->depth - d.right.bounds.separation || is_right_with_all_axes(d, *found);
}

/// No support vertex of either is inside the other: the point is A's.
bool vertex_outside_by_matter(const Deviation& d) {
  if (!is_about_points(d.kind)) return false;
  const auto found = found_by_matter(d);
  return found && found->is_none_inside;
}

/// The deepest vertex is not inside the other, or was not asked: nobody is as deep as is said.
bool deepest_left_out_by_matter(const Deviation& d) {
  if (d.kind != Kind::witness) return false;
  const auto found = found_by_matter(d);
  return found && !found->is_none_inside && is_deepest_left_out(d, *found);
}

/// Too few points, too near each other, or one on a far side: beside the deepest vertex the deeper
/// of its neighbours is taken, which is not the end of the edge that faces the other body.
bool neighbour_by_depth_of_matter(const Deviation& d) {
  if (!is_about_points(d.kind)) return false;
  const auto found = found_by_matter(d);
  if (!found || found->is_none_inside) return false;
  return d.kind == Kind::witness ? is_neighbour_behind(*found) : !are_right_edges(d, *found);
}

/// With the right edges too few points, or too near each other: their ends that are inside the
/// other body are given, and no place where an edge is cut.
bool vertices_inside_alone_by_matter(const Deviation& d) {
  if (d.kind != Kind::count && d.kind != Kind::extent) return false;
  const auto found = found_by_matter(d);
  return found && !found->is_none_inside && are_right_edges(d, *found);
}

constexpr LedgerRow kMatterJsRows[] = {
    {"normal-by-centres", normal_by_matter_centres},
    {"axes-merged", axes_merged_by_matter},
    {"vertex-outside", vertex_outside_by_matter},
    {"deepest-left-out", deepest_left_out_by_matter},
    {"neighbour-by-depth", neighbour_by_depth_of_matter},
    {"vertices-inside-alone", vertices_inside_alone_by_matter},
};

}  // namespace

Engine engine_matter_js() {
  return {.name = "matter-js", .ledger = {{"matter-js", kMatterJsRows}}};
}

}  // namespace manifuzz
