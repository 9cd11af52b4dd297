#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "exact/curve.hpp"
#include "report/picture/drawing.hpp"
#include "report/round_truth.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kHeightMin = 280;
constexpr double kFrameGap = 14;     // between frames
constexpr double kWholeShare = 0.6;  // of the width, where there are closer views
constexpr double kMargin = 56;       // around the scene, for labels

/// Something that a picture must show, and how large it must come out.
struct Interest {
  Point focus{0, 0};
  double length = 0;
  double pixels_min = 0;    // to be seen
  double share_wanted = 0;  // of a closer view's smaller side
  bool is_depth = false;
  bool is_overlap = false;
};

PlacedFace placed_face(const exact::RoughPair& polygons, Side side, int face) {
  const exact::RoughPolygon& polygon = polygons[side];
  const Feature feature{Feature::Kind::face, static_cast<unsigned char>(face)};
  return {side, feature, {polygon.vertices[face], polygon.vertices[polygon.next(face)]}};
}

PlacedFace placed_vertex(const exact::RoughPair& polygons, Side side, int vertex) {
  const Point& at = polygons[side].vertices[vertex];
  return {side, {Feature::Kind::vertex, static_cast<unsigned char>(vertex)}, {at, at}};
}

/// From the incident skin below a point of the incident edge, along the reference face's normal.
DepthBar bar_at(const Scene& scene, const Point& position, double depth, Side reference,
                const Point& outward) {
  const Point skin = position - scene.radius(other(reference)) * outward;
  return {skin, skin + depth * outward, depth};
}

/// The vertex of a polygon that lies farthest against a direction.
Point farthest_against(const exact::RoughPolygon& polygon, const Point& direction) {
  return *std::min_element(
      polygon.vertices.data(), polygon.vertices.data() + polygon.count,
      [&](const Point& p, const Point& q) { return direction.dot(p) < direction.dot(q); });
}

/// The true deepest point: of the clip, or the vertex that lies farthest behind the reference face.
DepthBar deepest_bar(const Scene& scene, const PairCase& pair, const exact::Clip* candidate) {
  const Side side = scene.reference.side;
  if (candidate != nullptr) {
    const auto& points = candidate->points;
    const bool second = candidate->count > 1 && points[1].depth() > points[0].depth();
    const exact::ClipPoint& point = points[second ? 1 : 0];
    return bar_at(scene, exact::seen_from_a(pair, point.position()), point.depth(), side,
                  scene.outward);
  }
  const Point deepest = farthest_against(scene.polygons[other(side)], scene.outward);
  const double separation = scene.outward.dot(deepest - scene.reference.segment.first);
  return bar_at(scene, deepest, total_radius(pair) - separation, side, scene.outward);
}

/// Shows of round shapes the face, or A's vertex, where the cores are nearest, and the depth there.
void show_nearest(Scene& scene, const PairCase& pair, const exact::Truth& truth) {
  const exact::PenetrationCurve curve(truth, exact::Skin::round);
  const auto vertices = curve.nearest_vertices();
  const Side side = vertices ? Side::a : curve.face().side;
  scene.reference = vertices ? placed_vertex(scene.polygons, side, (*vertices)[0])
                             : placed_face(scene.polygons, side, curve.face().index);
  const Point a_to_b = world_normal(pair, curve.minima(0).front());
  scene.outward = side == Side::a ? a_to_b : Point(-a_to_b);
  const Point deepest = vertices ? scene.polygons.b.vertices[(*vertices)[1]]
                                 : farthest_against(scene.polygons[other(side)], scene.outward);
  scene.deepest = bar_at(scene, deepest, curve.least(), side, scene.outward);
}

void add_right(Scene& scene, const PairCase& pair, const Manifold<double>& manifold) {
  for (int i = 0; i < manifold.count; ++i) {
    scene.right.push_back(exact::seen_from_a(pair, manifold.points[i].position));
  }
}

void add_points(Scene& scene, const PairCase& pair, const DeclaredAnswer& asked, bool is_subject) {
  for (int i = 0; i < asked.count(); ++i) {
    const Manifold<double>& manifold = *asked.manifold();
    const ContactPoint<double>& point = manifold.points[i];
    if (!point.position.allFinite()) continue;
    const Point normal = world_normal(pair, manifold.normal);
    const Point position = exact::seen_from_a(pair, point.position);
    const Point direction = unit_or_zero(normal);
    const Point outward = manifold.reference == Side::a ? direction : Point(-direction);
    DepthBar bar = bar_at(scene, position, point.depth, manifold.reference, outward);
    if (scene.is_round) bar = {position, position + point.depth * outward, point.depth};
    scene.points.push_back({is_subject, position, normal, bar});
  }
}

/// Around a polygon and its skin.
Box box_of(const Scene& scene, Side side) {
  return box_around(scene.polygons[side].corners()).grown(scene.radius(side));
}

/// The width of a polygon where it is thinnest, and the corner there.
Interest thickness(const exact::RoughPolygon& polygon) {
  Interest thinnest{{0, 0}, std::numeric_limits<double>::infinity(), 4, 0.25};
  for (int face = 0; face < polygon.count; ++face) {
    const Point& normal = polygon.normals[face];
    const Point farthest = farthest_against(polygon, normal);
    const double width = normal.dot(polygon.vertices[face] - farthest);
    if (width >= thinnest.length) continue;
    thinnest.length = width;
    thinnest.focus = farthest + width / 2 * normal;
  }
  return thinnest;
}

/// The width of what both shapes cover, where it is thinnest; about its middle. None where it is
/// about as wide as it is deep, and seen where the depth is, or no wider than its own roundings.
std::optional<Interest> thin_overlap(const Scene& scene) {
  const Box whole = scene.whole(0);
  const double tolerance = 1e-3 * std::max(whole.width, whole.height);
  const auto shape = [&](Side side) { return scene.shape(side, whole, tolerance); };
  const Region overlap = intersection(shape(Side::a), shape(Side::b));
  double thinnest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < overlap.size(); ++i) {
    const Point& corner = overlap[i];
    const Point along = unit_or_zero(overlap[(i + 1) % overlap.size()] - corner);
    double width = 0;
    for (const Point& p : overlap) width = std::max(width, cross<double>(along, p - corner));
    if (width > 0) thinnest = std::min(thinnest, width);
  }
  const Point middle = middle_of(overlap);
  const double resolved = 8 * std::numeric_limits<double>::epsilon() * length(middle);
  if (!(thinnest > resolved && thinnest < std::abs(scene.deepest.depth) / 2)) return std::nullopt;
  return Interest{middle, thinnest, 4, 0.25, false, true};
}

/// The largest first.
std::vector<Interest> interests(const Scene& scene) {
  std::vector<Interest> all;
  const std::optional<Interest> overlap = thin_overlap(scene);
  if (overlap) all.push_back(*overlap);
  // A shape as thin as the overlap, or nearly, is seen where the overlap is.
  const auto add_thickness = [&](const Interest& thinnest) {
    if (!overlap || thinnest.length > 2 * overlap->length) all.push_back(thinnest);
  };
  const auto add = [&](const Segment& segment, double length, double pixels, double share) {
    all.push_back({(segment.first + segment.second) / 2, length, pixels, share});
  };
  const auto add_face = [&](const Segment& face) {
    add(face, length(face.second - face.first), 20, 0.4);
  };
  for (const Side side : kSides) {
    const Box box = box_of(scene, side);
    all.push_back({box.center(), length({box.width, box.height}), 30, 0.6});
    const bool is_thick = scene.polygons[side].count >= kMinVertices;
    if (scene.radius(side) <= 0 && is_thick) add_thickness(thickness(scene.polygons[side]));
  }
  add_face(scene.reference.segment);
  if (scene.incident) add_face(scene.incident->segment);
  if (scene.deepest.depth != 0) {
    // A closer look than a quarter of the bound would show rounding alone.
    const double depth = std::max(std::abs(scene.deepest.depth), scene.rounding / 4);
    add({scene.deepest.from, scene.deepest.to}, depth, 14, 0.25);
    all.back().is_depth = true;
  }
  // What rounding makes no longer than nothing cannot be looked at more closely.
  std::erase_if(all, [](const Interest& interest) { return !(interest.length > 0); });
  std::ranges::stable_sort(all, std::ranges::greater(), &Interest::length);
  return all;
}

/// What is in none of the views.
std::vector<Interest> unseen(const std::vector<Interest>& all, const std::vector<View>& views) {
  std::vector<Interest> left;
  for (const Interest& interest : all) {
    const bool seen = std::ranges::any_of(views, [&](const View& view) {
      return interest.length * view.scale >= interest.pixels_min &&
             view.frame.contains(view.place(interest.focus));
    });
    if (!seen) left.push_back(interest);
  }
  return left;
}

View view_of(const Box& scene, const Box& frame) {
  return {frame, scene.center(),
          std::min((frame.width - 2 * kMargin) / scene.width,
                   (frame.height - 2 * kMargin) / scene.height)};
}

}  // namespace

Box Scene::whole(double reach) const {
  std::vector<Point> places;
  for (const Side side : kSides) {
    const Box box = box_of(*this, side);
    places.insert(places.end(), {Point(box.x, box.y), Point(box.right(), box.bottom())});
  }
  const Box shapes = box_around(places);
  const Box about = shapes.grown(reach * std::max(shapes.width, shapes.height));
  const auto add = [&](const Point& p) {
    if (about.contains(p)) places.push_back(p);
  };
  for (const Point& point : right) add(point);
  for (const DrawnPoint& point : points) add(point.position);
  return box_around(places);
}

Scene make_scene(const PairCase& pair, std::span<const DeclaredAnswer> answers) {
  const Admissible admitted = admissible(pair, answers[0].declaration);
  const exact::Clip* const candidate = candidate_to_show(admitted, answers[0]);
  Scene scene;
  scene.polygons = exact::place_roughly(pair);
  scene.is_round = is_round(pair);
  scene.radii = {pair.a.polygon.radius, pair.b.polygon.radius};
  scene.rims = rims_of(pair, scene.polygons);
  const exact::Truth& truth = *admitted.truth;
  scene.depth = std::abs(exact::separation_of(truth) - total_radius(pair));
  scene.rounding = admitted.bounds.separation;
  if (scene.is_round) {
    show_nearest(scene, pair, truth);
    const auto manifolds = manifolds_to_show(admitted, answers[0].declaration);
    if (!manifolds.empty()) add_right(scene, pair, manifolds.back());
  } else {
    const auto [side, face] = candidate ? candidate->reference : truth.greatest();
    scene.reference = placed_face(scene.polygons, side, face);
    scene.outward = scene.polygons[side].normals[face];
    scene.deepest = deepest_bar(scene, pair, candidate);
  }
  if (candidate) {
    scene.incident =
        placed_face(scene.polygons, other(candidate->reference.side), candidate->incident);
    add_right(scene, pair, true_manifold(*candidate));
  }
  for (std::size_t i = 0; i < answers.size(); ++i) add_points(scene, pair, answers[i], i == 0);
  return scene;
}

Region View::place(const Region& region) const {
  Region placed;
  for (const Point& point : region) placed.push_back(place(point));
  return placed;
}

Rim View::place(const Rim& rim) const {
  Rim placed;
  for (const RimCorner& corner : rim) {
    placed.push_back({place(corner.center), corner.radius * scale, direction(corner.from),
                      direction(corner.to)});
  }
  return placed;
}

std::vector<View> choose_views(const Scene& scene, double x, double y, double width) {
  const Box shown = scene.whole(1);
  const std::vector<Interest> all = interests(scene);
  const double wanted = (width - 2 * kMargin) * shown.height / shown.width + 2 * kMargin;
  std::vector<View> views{view_of(shown, {x, y, width, std::clamp(wanted, kHeightMin, 440.0)})};
  // One closer view if that shows all, else two.
  for (const std::size_t closer : {1U, 2U}) {
    if (unseen(all, views).empty()) return views;
    const double height = closer == 1 ? 440 : 470;
    const double left = kWholeShare * (width - kFrameGap);
    const double half = closer == 1 ? height : (height - kFrameGap) / 2;
    views = {view_of(shown, {x, y, left, height})};
    for (double top = y; views.size() <= closer; top += half + kFrameGap) {
      const std::vector<Interest> hidden = unseen(all, views);
      if (hidden.empty()) break;
      auto next = hidden.begin();
      if (views.size() == 2) {
        next = std::ranges::find(hidden, true, &Interest::is_depth);
        if (next == hidden.end()) next = std::ranges::find(hidden, true, &Interest::is_overlap);
        if (next == hidden.end()) --next;
      }
      const Box frame{x + left + kFrameGap, top, width - left - kFrameGap, half};
      views.push_back(
          {frame, next->focus, next->share_wanted * std::min(frame.width, half) / next->length});
    }
  }
  return views;
}

}  // namespace manifuzz
