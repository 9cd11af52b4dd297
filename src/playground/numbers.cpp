#include "playground/numbers.hpp"

#include <limits>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "judging/bounds.hpp"
#include "judging/by_curve.hpp"
#include "judging/judge.hpp"
#include "own_colliders/own_colliders.hpp"
#include "playground/steps.hpp"

namespace manifuzz::playground {
namespace {

using Numbers = std::span<const double, kCaseNumbers>;

float rounded(double value) {
  return static_cast<float>(value);
}

Vector2<float> vector_at(const Numbers& numbers, int index) {
  return {rounded(numbers[index]), rounded(numbers[index + 1])};
}

int count_of(const Numbers& numbers, int first) {
  const double count = numbers[first];
  return count >= 1 && count <= kMaxVertices ? static_cast<int>(count) : 0;
}

std::array<Vector2<float>, kMaxVertices> vertices_of(const Numbers& numbers, int first) {
  std::array<Vector2<float>, kMaxVertices> vertices;
  for (int i = 0; i < kMaxVertices; ++i) vertices[i] = vector_at(numbers, first + 7 + 2 * i);
  return vertices;
}

Body body_of(const Numbers& numbers, int first) {
  const auto vertices = vertices_of(numbers, first);
  const std::span<const Vector2<float>> corners(vertices.data(),
                                                static_cast<std::size_t>(count_of(numbers, first)));
  const Rounding rounding = numbers[first + 1] != 0 ? Rounding::round : Rounding::mitre;
  return {make_polygon<float>(corners, rounded(numbers[first + 2]), rounding),
          {vector_at(numbers, first + 3), vector_at(numbers, first + 5)}};
}

/// Appends to the row.
class Row {
 public:
  explicit Row(const Pose<double>& pose_a) : turn_(pose_a.rotation) {}

  void add(double value) { numbers_.push_back(value); }
  /// A vector as it is.
  void add(const Vector2<double>& v) {
    add(v.x());
    add(v.y());
  }
  /// A place or direction of A's frame, in the world's directions.
  void add_turned(const Vector2<double>& v) { add(Vector2<double>(rotate<double>(turn_, v))); }
  void add(const Feature& feature) {
    add(feature.index + (feature.kind == Feature::Kind::face ? kMaxVertices : 0.0));
  }
  void add(const clipping::ClipEdge<double>& edge) {
    for (const auto& end : edge) {
      add_turned(end.position);
      add(end.reference);
      add(end.incident);
    }
  }

  std::vector<double> take() { return std::move(numbers_); }

 private:
  Vector2<double> turn_;
  std::vector<double> numbers_;
};

void add_separations(const Steps& steps, Row& row) {
  for (const std::size_t side : {0, 1}) {
    row.add(static_cast<double>(steps.separations[side].size()));
    for (const auto& of_face : steps.separations[side]) {
      row.add(of_face.separation);
      row.add(of_face.deepest);
    }
    row.add(steps.greatest[side].value_or(-1));
  }
}

void add_steps(const Steps& steps, Row& row) {
  add_separations(steps, row);
  row.add(steps.nearest ? 1 : 0);
  const auto nearest = steps.nearest.value_or(clipping::NearestPlaces<double>{});
  row.add_turned(nearest.on_a);
  row.add_turned(nearest.on_b);
  row.add(nearest.features.a);
  row.add(nearest.features.b);
  row.add(steps.features ? 1 : 0);
  const auto features = steps.features.value_or(clipping::ContactFeatures{});
  row.add(features.reference_side == Side::b ? 1 : 0);
  row.add(features.reference);
  row.add(features.incident);
  row.add_turned(steps.outward);
  row.add(steps.margin);
  row.add(steps.whole);
  for (const SideClip& clip : steps.side_clips) {
    row.add_turned(clip.corner);
    row.add_turned(clip.inward);
    row.add(clip.leaves ? 1 : 0);
    row.add(clip.edge);
  }
  for (const double in_front : steps.in_front) row.add(in_front);
  row.add(steps.is_replaced ? 1 : 0);
}

/// The bucket of what a collider of a whole manifold answers, which is added to the row.
std::string add_answer(const exact::Truth& truth, const Collider& collider, Row& row) {
  const Answer answer = collider.collide(truth.pair());
  const Judgement judgement = judge_alone(exact::unowned(truth), {collider.declaration, answer});
  const Manifold<double> manifold = *manifold_in(answer);
  row.add(is_unexplained(judgement.bucket.verdict) ? 0 : 1);
  row.add(judgement.of_subject.magnitude);
  row.add(manifold.count);
  row.add(manifold.reference == Side::b ? 1 : 0);
  row.add(world_normal(truth.pair(), manifold.normal));
  for (const ContactPoint<double>& point : manifold.points) {
    row.add(exact::seen_from_a(truth.pair(), point.position));
    row.add(point.depth);
    row.add(point.features.a);
    row.add(point.features.b);
  }
  return to_string(judgement.bucket);
}

void add_curve(const exact::Truth& truth, const Declaration& declaration, Row& row) {
  const PairCase& pair = truth.pair();
  const exact::PenetrationCurve curve(truth, exact::skin_of(truth));
  row.add(curve.least());
  const double bound = bounds(pair, declaration).separation;
  const auto minima = curve.minima(std::isfinite(bound) ? bound : 0);
  row.add(static_cast<double>(minima.size()));
  for (const auto& normal : minima) row.add(world_normal(pair, normal));
  const std::vector<double> angles = exact::angles_to_draw(exact::place_roughly(pair));
  row.add(static_cast<double>(angles.size()));
  for (const double angle : angles) {
    const Vector2<double> normal{std::cos(angle), std::sin(angle)};
    row.add(angle);
    row.add(exact::Along(truth, local_normal(pair, normal)).depth());
  }
}

}  // namespace

std::optional<std::string> defect_of(Numbers numbers) {
  for (const Side side : {Side::a, Side::b}) {
    const int first = side == Side::a ? 0 : kBodyNumbers;
    const auto vertices = vertices_of(numbers, first);
    const std::span<const Vector2<float>> corners(
        vertices.data(), static_cast<std::size_t>(count_of(numbers, first)));
    const std::string_view name = side == Side::a ? "A" : "B";
    if (const auto defect = find_shape_defect(corners, rounded(numbers[first + 2]))) {
      return fmt::format("{}: {}", name, describe(*defect));
    }
    if (!vector_at(numbers, first + 3).allFinite()) {
      return fmt::format("{}: its position must be finite", name);
    }
    if (!is_unit_rotation(vector_at(numbers, first + 5))) {
      return fmt::format("{}: its rotation must be a cosine and a sine, of length 1", name);
    }
  }
  return std::nullopt;
}

PairCase pair_of(Numbers numbers) {
  return {body_of(numbers, 0), body_of(numbers, kBodyNumbers)};
}

Told tell(const PairCase& pair) {
  static const Collider clip64 = make_clip64();
  static const Collider gjk64 = make_gjk64();
  const auto placed = clipping::placed_pair<double>(pair);
  const Steps steps =
      steps_of(placed.a, transform(relative_pose(placed.pose_a, placed.pose_b), placed.b));
  const exact::Truth truth(pair);
  Row row(placed.pose_a);
  row.add(static_cast<double>(steps.way));
  row.add(total_radius(pair));
  row.add(exact::separation_of(truth));
  row.add(standing(truth).touching ? 1 : 0);
  add_steps(steps, row);
  Told told;
  told.buckets = add_answer(truth, clip64, row) + '\n';
  told.buckets += add_answer(truth, gjk64, row);
  add_curve(truth, clip64.declaration, row);
  told.numbers = row.take();
  return told;
}

}  // namespace manifuzz::playground
