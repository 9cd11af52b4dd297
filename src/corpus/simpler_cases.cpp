#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "corpus/clearer_cases.hpp"
#include "corpus/plain_cases.hpp"
#include "corpus/shrink.hpp"
#include "generating/drafts.hpp"

namespace manifuzz {
namespace {

using Cases = rc::Seq<PairCase>;
using MaybeCase = std::optional<PairCase>;

void remove_vertex(ConvexPolygon<float>& polygon, int vertex) {
  for (int i = vertex; i + 1 < polygon.count; ++i) polygon.vertices[i] = polygon.vertices[i + 1];
  --polygon.count;
}

/// From round pairs down to capsules, segments and circles.
Cases without_a_vertex(const PairCase& pair) {
  const int count_a = pair.a.polygon.count;
  return each_case(count_a + pair.b.polygon.count, [pair, count_a](int i) -> MaybeCase {
    PairCase smaller = pair;
    const Side side = i < count_a ? Side::a : Side::b;
    const int least = is_round(pair) ? 1 : kMinVertices;
    if (smaller[side].polygon.count == least) return std::nullopt;
    remove_vertex(smaller[side].polygon, side == Side::a ? i : i - count_a);
    return smaller;
  });
}

/// In round pairs a shape of a plainer kind: one of its faces as a segment or a capsule, or one of
/// its vertices as a circle, of radius 1 where it has none.
Cases of_a_plainer_kind(const PairCase& pair) {
  const int kinds = is_round(pair) ? 2 : 0;
  return each_case(2 * kinds * kMaxVertices, [pair](int i) -> MaybeCase {
    PairCase plainer = pair;
    ConvexPolygon<float>& shape = plainer[i % 2 == 0 ? Side::a : Side::b].polygon;
    const int count = 1 + i / (2 * kMaxVertices);
    const int vertex = i / 2 % kMaxVertices;
    if (vertex >= shape.count || count >= shape.count) return std::nullopt;
    shape.vertices = {shape.vertices[vertex], shape.vertices[shape.next(vertex)]};
    shape.count = count;
    if (count == 1 && shape.radius == 0) shape.radius = 1;
    return plainer;
  });
}

Pose<double> widened(const Pose<float>& pose) {
  return {pose.position.cast<double>(), pose.rotation.cast<double>()};
}

/// The body stays where it is: its rotation, and its position but for `kept`, are worked into the
/// vertices.
void work_pose_into_vertices(Body& body, const Vector2<float>& kept) {
  Pose<double> worked = widened(body.pose);
  worked.position -= kept.cast<double>();
  for (int i = 0; i < body.polygon.count; ++i) {
    Vector2<float>& vertex = body.polygon.vertices[i];
    vertex = transform<double>(worked, vertex.cast<double>()).cast<float>();
  }
  body.pose = {kept, {1, 0}};
}

PairCase seen_from_a(PairCase pair) {
  const Pose<double> relative = relative_pose(widened(pair.a.pose), widened(pair.b.pose));
  const Vector2<double> unit =
      relative.rotation / std::sqrt(relative.rotation.dot(relative.rotation));
  pair.a.pose = {};
  pair.b.pose = {relative.position.cast<float>(), unit.cast<float>()};
  return pair;
}

constexpr std::array<std::array<float, 2>, 6> kPlainRotations{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {0.8F, 0.6F}, {0.6F, 0.8F}}};

Cases with_plainer_poses(const PairCase& pair) {
  std::vector<PairCase> plainer{seen_from_a(pair)};
  for (const Side side : {Side::a, Side::b}) {
    const auto changed = [&]() -> Body& { return plainer.emplace_back(pair)[side]; };
    work_pose_into_vertices(changed(), {0, 0});
    work_pose_into_vertices(changed(), pair[side].pose.position);
    changed().pose.position = {0, 0};
    changed().polygon.radius = 0;
    changed().polygon.radius = 1;
    changed().polygon.rounding = Rounding::mitre;
    for (const auto& rotation : kPlainRotations)
      changed().pose.rotation = {rotation[0], rotation[1]};
  }
  return rc::seq::fromContainer(std::move(plainer));
}

/// Moves a polygon's vertices, and both polygons' alike, so that one vertex lies at zero.
Cases with_a_vertex_at_zero(const PairCase& pair) {
  const int count_a = pair.a.polygon.count;
  const int count = count_a + pair.b.polygon.count;
  return each_case(count, [pair, count_a](int i) -> MaybeCase {
    PairCase moved = pair;
    const Vector2<float> origin =
        i < count_a ? pair.a.polygon.vertices[i] : pair.b.polygon.vertices[i - count_a];
    for (const Side side : {Side::a, Side::b}) {
      for (auto& vertex : moved[side].polygon.vertices) vertex -= origin;
    }
    return moved;
  });
}

/// Both polygons seen in a mirror, x turned to -x, their vertices counter-clockwise again.
PairCase mirrored(PairCase pair) {
  for (const Side side : {Side::a, Side::b}) {
    Body& body = pair[side];
    auto& vertices = body.polygon.vertices;
    std::reverse(vertices.begin(), vertices.begin() + body.polygon.count);
    for (auto& vertex : vertices) vertex.x() = -vertex.x();
    body.pose.position.x() = -body.pose.position.x();
    body.pose.rotation.y() = -body.pose.rotation.y();
  }
  return pair;
}

PairCase turned_by_quarter(PairCase pair) {
  for (const Side side : {Side::a, Side::b}) {
    for (auto& vertex : pair[side].polygon.vertices) vertex = counter_clockwise_quarter(vertex);
    pair[side].pose.position = counter_clockwise_quarter(pair[side].pose.position);
  }
  return pair;
}

/// A case in other words: swapped, mirrored, turned, its vertices counted from elsewhere.
/// Which of them still fail alike is for the predicate to say.
Cases symmetric_images(const PairCase& pair) {
  std::vector<PairCase> images;
  for (const PairCase& start : {pair, PairCase{pair.b, pair.a}}) {
    for (PairCase image : {start, mirrored(start)}) {
      for (int quarters = 0; quarters < 4; ++quarters) {
        images.push_back(image);
        image = turned_by_quarter(image);
      }
    }
  }
  for (const Side side : {Side::a, Side::b}) {
    PairCase image = pair;
    for (int i = 1; i < pair[side].polygon.count; ++i) {
      renumber(image[side].polygon);
      images.push_back(image);
    }
  }
  return rc::seq::fromContainer(std::move(images));
}

Cases plainest(const PairCase& pair) {
  const std::vector<PairCase>& plain = plain_cases(pair);
  return each_case(static_cast<int>(plain.size()),
                   [&plain](int i) -> MaybeCase { return plain[static_cast<std::size_t>(i)]; });
}

constexpr int kDigitsMax = 8;

/// All numbers, or one polygon's, to fewer digits: to one, to two, ...
Cases with_fewer_digits(const PairCase& pair) {
  return each_case(3 * kDigitsMax, [pair](int i) -> MaybeCase {
    PairCase rounded = pair;
    const int digits = 1 + i / 3;
    const std::size_t of_a = 2 * static_cast<std::size_t>(pair.a.polygon.count) + 3;
    const std::vector<float*> numbers = free_numbers(rounded);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      const bool chosen = i % 3 == 0 || (i % 3 == 1) == (k < of_a);
      if (chosen) *numbers[k] = rounded_to_digits(*numbers[k], digits);
    }
    return rounded;
  });
}

/// All lengths multiplied by a power of ten or two, digits kept: sizes near 1 read best.
Cases with_plainer_size(const PairCase& pair) {
  constexpr std::array kFactors{1e16F, 1e8F,  1e4F,  1e2F, 1e1F, 1e-1F,
                                1e-2F, 1e-4F, 1e-8F, 2.0F, 0.5F, 0.25F};
  return each_case(static_cast<int>(kFactors.size()), [pair, kFactors](int i) -> MaybeCase {
    PairCase scaled = pair;
    for (float* number : free_numbers(scaled)) {
      const int digits = significant_digits(*number);
      if (digits > 0) *number = rounded_to_digits(*number * kFactors[i], digits);
    }
    return scaled;
  });
}

/// One number changed: to zero, to fewer digits, to ten times or half of it, or one unit of its
/// last digit nearer to zero.
Cases with_one_number_simpler(const PairCase& pair) {
  PairCase copy = pair;
  const int numbers = static_cast<int>(free_numbers(copy).size());
  constexpr int kChanges = kDigitsMax + 4;
  return each_case(numbers * kChanges, [pair](int i) -> MaybeCase {
    PairCase changed = pair;
    float& number = *free_numbers(changed)[static_cast<std::size_t>(i / kChanges)];
    if (number == 0) return std::nullopt;
    const int change = i % kChanges;
    if (change == 0) {
      number = 0;
    } else if (change <= kDigitsMax) {
      number = rounded_to_digits(number, change);
    } else if (change == kDigitsMax + 1) {
      number = rounded_to_digits(number * 10, significant_digits(number));
    } else if (change == kDigitsMax + 2) {
      number = rounded_to_digits(number / 2, significant_digits(number));
    } else {
      number = nearer_to_zero(number);
    }
    return changed;
  });
}

}  // namespace

PairCase without_negative_zeros(PairCase pair) {
  for (float* number : free_numbers(pair)) *number += 0.0F;
  for (const Side side : {Side::a, Side::b}) pair[side].pose.rotation.array() += 0.0F;
  return pair;
}

namespace {

/// The proposals that are valid and simpler than the pair.
Cases simpler_of(Cases proposals, const PairCase& pair) {
  const Complexity limit = complexity(pair);
  return rc::seq::mapMaybe(std::move(proposals), [limit](const PairCase& proposal) {
    const MaybeCase valid = revalidated(without_negative_zeros(proposal));
    return valid && complexity(*valid) < limit ? rc::Maybe<PairCase>(*valid)
                                               : rc::Maybe<PairCase>(rc::Nothing);
  });
}

}  // namespace

rc::Seq<PairCase> like_changes(const PairCase& pair) {
  return rc::seq::concat(of_a_plainer_kind(pair), without_a_vertex(pair), with_plainer_poses(pair),
                         with_fewer_digits(pair), with_a_vertex_at_zero(pair),
                         with_plainer_size(pair), symmetric_images(pair));
}

rc::Seq<PairCase> simpler_neighbours(const PairCase& pair) {
  return simpler_of(rc::seq::concat(like_changes(pair), with_one_number_simpler(pair)), pair);
}

rc::Seq<PairCase> simpler_cases(const PairCase& pair) {
  return simpler_of(rc::seq::concat(plainest(pair), of_a_plainer_kind(pair), without_a_vertex(pair),
                                    with_plainer_poses(pair), with_ordinary_numbers(pair),
                                    with_a_clearer_lead(pair), with_fewer_digits(pair),
                                    with_a_vertex_at_zero(pair), with_plainer_size(pair),
                                    with_one_number_simpler(pair), symmetric_images(pair)),
                    pair);
}

}  // namespace manifuzz
