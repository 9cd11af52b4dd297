#include "hunting/conditions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace manifuzz {
namespace {

/// 10^-20 to 10^20: compared with, so that no logarithm's last digit decides.
constexpr std::array kPowersOfTen{
    1e-20, 1e-19, 1e-18, 1e-17, 1e-16, 1e-15, 1e-14, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7,
    1e-6,  1e-5,  1e-4,  1e-3,  1e-2,  1e-1,  1e0,   1e1,   1e2,   1e3,   1e4,   1e5,  1e6,  1e7,
    1e8,   1e9,   1e10,  1e11,  1e12,  1e13,  1e14,  1e15,  1e16,  1e17,  1e18,  1e19, 1e20};

constexpr int kPowerOfOne = 20;  ///< where 1 stands

// Where the decades of each figure begin: shares of roundoff are told apart, sizes both ways
// from 1.
constexpr int kOfShare = -10;
constexpr int kOfRatio = -7;
constexpr int kOfDistance = -2;

std::uint8_t aspect_bin(const ConvexPolygon<float>& shape) {
  return shape.count < kMinVertices ? 0 : decade(aspect_of(shape), kOfRatio);
}

std::uint8_t radius_bin(const ConvexPolygon<float>& shape) {
  if (shape.count == 1) return kBins - 1;
  return decade(static_cast<double>(shape.radius) / core_size(shape), kOfRatio);
}

/// The last of an odd multiple of 45 degrees, the first of a quarter turn, else how far it is from
/// either: the lesser of cosine, sine, and their difference.
std::uint8_t turn_bin(const Vector2<float>& rotation) {
  const double cosine = std::abs(static_cast<double>(rotation.x()));
  const double sine = std::abs(static_cast<double>(rotation.y()));
  if (cosine == sine) return kBins - 1;
  return decade(std::min({cosine, sine, std::abs(cosine - sine)}), kOfShare);
}

std::uint8_t label(int value) {
  return static_cast<std::uint8_t>(std::clamp(value, 0, kBins - 1));
}

/// The greatest separation of any other face of the reference's side, if it has one.
std::optional<double> second_of_side(const exact::Truth& truth, const exact::FaceOf& reference) {
  std::optional<double> second;
  const int faces = truth.pair()[reference.side].polygon.face_count();
  for (int i = 0; i < faces; ++i) {
    if (i == reference.index) continue;
    const double separation = truth.separation(exact::FaceOf{reference.side, i});
    if (!second || separation > *second) second = separation;
  }
  return second;
}

/// From an end that is not cut to the nearest side plane, the nearer of both ends.
double margin_of(const exact::Clip& clip) {
  double margin = std::numeric_limits<double>::infinity();
  for (int end = 0; end < 2; ++end) {
    const double along = clip.along[end].value;
    margin = std::min({margin, std::abs(along), std::abs(clip.width.value - along)});
  }
  return margin / clip.width.value;
}

/// The share of the edge, from its nearer end, at which it is cut; nothing where it is not.
double crossing_of(const exact::Clip& clip) {
  const double first = clip.along[0].value;
  const double whole = clip.along[1].value - first;
  double least = 0;
  for (const exact::Cut cut : {exact::Cut::before, exact::Cut::beyond}) {
    if (clip.misses() || (clip.cuts[0] != cut && clip.cuts[1] != cut)) continue;
    const double plane = cut == exact::Cut::before ? 0 : clip.width.value;
    const double share = std::abs((plane - first) / whole);
    const double nearer = std::min(share, std::abs(1 - share));
    least = least > 0 ? std::min(least, nearer) : nearer;
  }
  return least;
}

void add_clip(const exact::Clip& clip, double face_length, double size, Conditions& of) {
  of[Condition::incident_edge] = label(1 + clip.incident);
  of[Condition::cuts] =
      label(1 + 3 * static_cast<int>(clip.cuts[0]) + static_cast<int>(clip.cuts[1]));
  of[Condition::tilt] = decade(clip.tangent, kOfShare);
  of[Condition::slab_margin] = decade(margin_of(clip), kOfShare);
  of[Condition::crossing_share] = decade(crossing_of(clip), kOfShare);
  of[Condition::incident_length] = decade(clip.edge_length / size, kOfRatio);
  of[Condition::length_ratio] = decade(std::abs(1 - clip.edge_length / face_length), kOfShare);
  const auto kept =
      std::ranges::count_if(points_of(clip), [](const auto& point) { return point.depth() >= 0; });
  of[Condition::points] = label(static_cast<int>(kept));
}

void add_reference(const exact::Truth& truth, double size, Conditions& of) {
  const exact::FaceOf reference = truth.greatest();
  const ConvexPolygon<float>& shape = truth.pair()[reference.side].polygon;
  of[Condition::reference_side] = label(1 + static_cast<int>(reference.side));
  of[Condition::reference_face] = label(1 + reference.index);
  const Vector2<double> face = shape.vertices[shape.next(reference.index)].cast<double>() -
                               shape.vertices[reference.index].cast<double>();
  const double face_length = std::sqrt(face.dot(face));
  of[Condition::reference_length] = decade(face_length / size, kOfRatio);
  const double separation = truth.separation(reference);
  if (const auto second = second_of_side(truth, reference)) {
    of[Condition::lead_in_side] = decade(std::max(separation - *second, 0.0) / size, kOfShare);
  }
  const Side other_side = other(reference.side);
  if (!truth.has_faces(other_side)) return;
  const double lead = separation - truth.separation(other_side);
  of[Condition::lead_of_side] = decade(std::max(lead, 0.0) / size, kOfShare);
  const int incident = truth.incident_edges(reference, 0).front();
  add_clip(truth.clip(reference, incident), face_length, size, of);
}

}  // namespace

std::uint8_t decade(double figure, int least) {
  if (!(figure > 0)) return 0;
  const auto begin = kPowersOfTen.begin() + (least + kPowerOfOne);
  const auto above = std::upper_bound(begin, begin + (kBins - 2), figure);
  return static_cast<std::uint8_t>(1 + (above - begin));
}

double aspect_of(const ConvexPolygon<float>& shape) {
  double least = std::numeric_limits<double>::infinity();
  double greatest = 0;
  for (int i = 0; i < shape.face_count(); ++i) {
    const Vector2<double> normal = shape.normals[i].cast<double>();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Vector2<float>& corner : shape.corners()) {
      const double along = normal.dot(corner.cast<double>());
      low = std::min(low, along);
      high = std::max(high, along);
    }
    least = std::min(least, high - low);
    greatest = std::max(greatest, high - low);
  }
  return least / greatest;
}

double core_size(const ConvexPolygon<float>& shape) {
  return size(shape) - (shape.is_round() ? 2 * static_cast<double>(shape.radius) : 0);
}

Conditions conditions_of(const exact::Truth& truth) {
  const PairCase& pair = truth.pair();
  const double size = truth.size();
  Conditions of;
  of[Condition::count_a] = label(pair.a.polygon.count);
  of[Condition::count_b] = label(pair.b.polygon.count);
  of[Condition::corners] =
      label(2 * (pair.a.polygon.is_round() ? 1 : 0) + (pair.b.polygon.is_round() ? 1 : 0));
  of[Condition::size_ratio] =
      decade(manifuzz::size(pair.a.polygon) / manifuzz::size(pair.b.polygon), kOfRatio);
  const auto radius_a = static_cast<double>(pair.a.polygon.radius);
  const auto radius_b = static_cast<double>(pair.b.polygon.radius);
  of[Condition::radius_ratio] = radius_b > 0 ? decade(radius_a / radius_b, kOfRatio) : label(0);
  of[Condition::radius_of_a] = radius_bin(pair.a.polygon);
  of[Condition::radius_of_b] = radius_bin(pair.b.polygon);
  of[Condition::aspect_of_a] = aspect_bin(pair.a.polygon);
  of[Condition::aspect_of_b] = aspect_bin(pair.b.polygon);
  of[Condition::turn_of_a] = turn_bin(pair.a.pose.rotation);
  of[Condition::turn_of_b] = turn_bin(pair.b.pose.rotation);
  const Vector2<double> at = pair.a.pose.position.cast<double>();
  of[Condition::distance] = decade(std::sqrt(at.dot(at)) / size, kOfDistance);
  of[Condition::scale] = decade(size, kOfRatio);
  if (!truth.has_faces()) return of;
  const double overlap = total_radius(pair) - truth.separation();
  of[Condition::gap] = decade(std::abs(overlap) / size, kOfShare);
  of[Condition::depth] = decade(std::max(overlap, 0.0) / size, kOfShare);
  add_reference(truth, size, of);
  return of;
}

}  // namespace manifuzz
