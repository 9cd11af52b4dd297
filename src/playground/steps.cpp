#include "playground/steps.hpp"

namespace manifuzz::playground {
namespace {

using Shape = ConvexPolygon<double>;
using clipping::FaceSeparation;

void add_separations(const Shape& a, const Shape& b, Steps& steps) {
  for (const Side side : {Side::a, Side::b}) {
    const Shape& shape = side == Side::a ? a : b;
    const Shape& opposing = side == Side::a ? b : a;
    auto& of_side = steps.separations[static_cast<std::size_t>(side)];
    for (int i = 0; i < shape.face_count(); ++i) {
      of_side.push_back(clipping::face_separation(shape, i, opposing));
    }
    if (of_side.empty()) continue;
    constexpr double no_limit = std::numeric_limits<double>::infinity();
    steps.greatest[static_cast<std::size_t>(side)] =
        clipping::greatest_separation(shape, opposing, no_limit).face;
  }
}

const FaceSeparation<double>& greatest(const Steps& steps, Side side) {
  const auto index = static_cast<std::size_t>(side);
  return steps.separations[index][*steps.greatest[index]];
}

/// The three clips of the features, as far as each leaves something.
void add_clips(const Shape& a, const Shape& b, Steps& steps) {
  const bool from_a = steps.features->reference_side == Side::a;
  const Shape& reference = from_a ? a : b;
  const Shape& incident = from_a ? b : a;
  const int face_index = steps.features->reference;
  const Vector2<double> along = counter_clockwise_quarter(steps.outward);
  steps.whole = clipping::whole_edge(incident, steps.features->incident, face_index);
  clipping::ClipEdge<double> edge = steps.whole;
  const std::array<int, 2> corners = {face_index, reference.next(face_index)};
  bool leaves = true;
  for (const std::size_t i : {0, 1}) {
    SideClip& clip = steps.side_clips[i];
    clip.corner = reference.vertices[corners[i]];
    clip.inward = i == 0 ? along : Vector2<double>(-along);
    leaves = leaves && clipping::clip<double>(edge, steps.whole, clip.inward, clip.corner,
                                              steps.margin, corners[i], steps.features->incident);
    clip.leaves = leaves;
    clip.edge = edge;
  }
  for (const std::size_t i : {0, 1}) {
    steps.in_front[i] = steps.outward.dot(edge[i].position - reference.vertices[face_index]);
  }
}

void add_faces(const Shape& a, const Shape& b, Steps& steps) {
  steps.way = Way::faces;
  const FaceSeparation<double>& of_a = greatest(steps, Side::a);
  const FaceSeparation<double>& of_b = greatest(steps, Side::b);
  const bool take_b = of_b.separation > of_a.separation;
  steps.outward = take_b ? b.normals[of_b.face] : a.normals[of_a.face];
  steps.features = take_b ? clipping::ContactFeatures{Side::b, of_b.face,
                                                      clipping::incident_edge(a, steps.outward)}
                          : clipping::ContactFeatures{Side::a, of_a.face,
                                                      clipping::incident_edge(b, steps.outward)};
  steps.margin = clipping::slab_margin(a, b);
  add_clips(a, b, steps);
  Manifold<double> clipped = clipping::clip_features(a, b, *steps.features);
  if (are_round(a, b)) clipping::put_on_surface(a, b, clipped);
  steps.is_replaced = !(clipped == steps.manifold);
}

/// The edges that two shapes give where they are nearest, and their clip, where both give one.
void add_cores(const Shape& a, const Shape& b, const clipping::NearestPlaces<double>& nearest,
               const Vector2<double>& normal, Steps& steps) {
  steps.way = Way::cores;
  steps.nearest = nearest;
  const auto edge_a = clipping::edge_at<double>(a, nearest.features.a, normal, SecondPoint{});
  const auto edge_b = clipping::edge_at<double>(b, nearest.features.b, -normal, SecondPoint{});
  const Side side = steps.manifold.reference;
  steps.outward = side == Side::a ? normal : Vector2<double>(-normal);
  if (!edge_a || !edge_b) return;
  steps.features = side == Side::a ? clipping::ContactFeatures{side, *edge_a, *edge_b}
                                   : clipping::ContactFeatures{side, *edge_b, *edge_a};
  add_clips(a, b, steps);
}

}  // namespace

Steps steps_of(const Shape& a, const Shape& b) {
  Steps steps;
  steps.manifold = clipping::collide_in_frame(a, b);
  add_separations(a, b, steps);
  const double total_radius = a.radius + b.radius;
  double separation = -std::numeric_limits<double>::infinity();
  for (const Side side : {Side::a, Side::b}) {
    if (steps.greatest[static_cast<std::size_t>(side)]) {
      separation = std::max(separation, greatest(steps, side).separation);
    }
  }
  if (separation > total_radius) return steps;
  if (clipping::is_circle(a) || clipping::is_circle(b)) {
    if (steps.manifold.count > 0) steps.way = Way::circle;
    return steps;
  }
  const FaceSeparation<double>& of_a = greatest(steps, Side::a);
  const FaceSeparation<double>& of_b = greatest(steps, Side::b);
  const double roundoff = clipping::separation_roundoff(a, b);
  if (are_round(a, b) && !clipping::do_cores_overlap(a, b, of_a, of_b, roundoff)) {
    const auto nearest = clipping::nearest_places(a, b, of_a, of_b, roundoff);
    const auto normal = clipping::nearest_normal(a, b, of_a, of_b, nearest, roundoff);
    if (normal) {
      if (steps.manifold.count > 0) add_cores(a, b, nearest, *normal, steps);
      return steps;
    }
  }
  add_faces(a, b, steps);
  return steps;
}

}  // namespace manifuzz::playground
