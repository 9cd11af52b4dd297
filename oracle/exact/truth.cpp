#include "oracle/exact/truth.hpp"

#include <cassert>
#include <cmath>
#include <limits>

#include "geometry/lanes.hpp"

namespace manifuzz::exact {
namespace {

// With u = 2^-53 and E the extent, rotations being unit to 1e-5. As a vector, a placed vertex is
// off by 1.42 u of its reach from two products, u from their sum, u E from the sum with a position
// that is off by u of its length: the difference of two by less than 10 u E. The face's edge is a
// rounded difference, turned by two products and a sum, made unit by a root of a sum of squares and
// a division: off by less than 8 u in all. The dot of both adds 2 u E: together 20 u E, and half as
// much again for good measure. The dot of two normals is off by 8 u + 8 u + 2 u.
constexpr double kErrorOfSeparation = 0x1p-48;  // 32 u

RoughPolygon place(const StoredBody& body, const Vector2<double>& position) {
  const StoredPolygon& polygon = body.polygon;
  const Vector2<double> rotation = body.pose.rotation.cast<double>();
  RoughPolygon placed;
  placed.count = polygon.count;
  for (int i = 0; i < placed.count; ++i) {
    const Vector2<double>& corner = polygon.vertices[i];
    const Vector2<double> edge = polygon.vertices[polygon.next(i)] - corner;
    const Vector2<double> outward = rotate<double>(rotation, clockwise_quarter(edge));
    placed.vertices[i] = rotate<double>(rotation, corner) + position;
    placed.normals[i] = outward / std::sqrt(outward.dot(outward));
  }
  return placed;
}

StoredBody stored(const Body& body) {
  StoredBody result{.polygon = {.vertices = {},
                                .count = body.polygon.count,
                                .radius = static_cast<double>(body.polygon.radius)},
                    .pose = body.pose};
  for (int i = 0; i < body.polygon.count; ++i) {
    result.polygon.vertices[i] = body.polygon.vertices[i].cast<double>();
  }
  return result;
}

StoredBody stored(const Body& body, const UsedVertices& used) {
  assert(used.count >= kMinVertices && used.count <= kMaxVertices);
  StoredBody result = stored(body);
  result.polygon.count = used.count;
  result.polygon.vertices = used.all;
  return result;
}

/// With the floats nearest to what is stored; as floats they may be no polygons, and their normals
/// mean nothing.
PairCase nearest(PairCase pair, const StoredPair& shapes) {
  for (const Side side : {Side::a, Side::b}) {
    const StoredPolygon& from = shapes[side].polygon;
    ConvexPolygon<float>& polygon = pair[side].polygon;
    polygon.count = from.count;
    for (int i = 0; i < from.count; ++i) polygon.vertices[i] = from.vertices[i].cast<float>();
  }
  return pair;
}

/// More than rounding to float may take from an extent.
constexpr double kExtentSlack = 1 + 0x1p-20;

}  // namespace

StoredPair stored(const PairCase& pair) {
  return {stored(pair.a), stored(pair.b)};
}

StoredPair stored(const PairCase& pair, const UsedShapes& used) {
  return {stored(pair.a, used.a), stored(pair.b, used.b)};
}

RoughPair place_roughly(const StoredPair& pair) {
  return {place(pair.a, {0, 0}),
          place(pair.b, pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>())};
}

namespace {

/// Of each face of a polygon; all of them at once meet each vertex of the other.
LaneArray separations(const RoughPolygon& polygon, const RoughPolygon& opposing) {
  LaneArray corner_x{};
  LaneArray corner_y{};
  LaneArray normal_x{};
  LaneArray normal_y{};
  for (int i = 0; i < polygon.count; ++i) {
    corner_x[i] = polygon.vertices[i].x();
    corner_y[i] = polygon.vertices[i].y();
    normal_x[i] = polygon.normals[i].x();
    normal_y[i] = polygon.normals[i].y();
  }
  Lanes least(std::numeric_limits<double>::infinity());
  for (int j = 0; j < opposing.count; ++j) {
    const Lanes apart_x = Lanes(opposing.vertices[j].x()) - Lanes(corner_x);
    const Lanes apart_y = Lanes(opposing.vertices[j].y()) - Lanes(corner_y);
    least = min(least, Lanes(normal_x) * apart_x + Lanes(normal_y) * apart_y);
  }
  return least.array();
}

}  // namespace

Separations separations(const RoughPair& placed, double extent) {
  Separations result;
  result.error = kErrorOfSeparation * extent;
  for (const Side side : {Side::a, Side::b}) {
    const RoughPolygon& polygon = placed[side];
    auto& of_face = result.of_face[static_cast<std::size_t>(side)];
    of_face = separations(polygon, placed[other(side)]);
    result.greatest[static_cast<std::size_t>(side)] =
        *std::max_element(of_face.begin(), of_face.begin() + polygon.count);
  }
  return result;
}

namespace {

std::size_t at(Side side) {
  return static_cast<std::size_t>(side);
}

/// The sign of a value known to within `error`, or else of the exact sum.
template <class Expression>
int decide_from(double value, double error, const Expression& expression) {
  if (std::abs(value) > error) return value > 0 ? 1 : -1;
  return decide(expression);
}

/// The sign of (distance of p's vertex in front of p's face) - share (the same of q) - offset.
int compare_distances(const StoredPair& pair, const FaceAndVertex& p, const FaceAndVertex& q,
                      double offset, double share = 1) {
  if (p == q && share == 1) return offset > 0 ? -1 : offset < 0 ? 1 : 0;
  return decide([&]<class Number>() {
    const Number square_of_p = square<Number>(pair, p.face);
    const Number square_of_q = square<Number>(pair, q.face);
    return RootSum<Number>{
        {{scaled_separation<Number>(pair, p.face, p.vertex), square_of_q},
         {Number(-share) * scaled_separation<Number>(pair, q.face, q.vertex), square_of_p},
         {-Number(offset), square_of_p * square_of_q}}};
  });
}

/// The sign of (distance of p's vertex in front of p's face) - (radii total radii + offset).
int compare_distance(const StoredPair& pair, const FaceAndVertex& p, int radii, double offset) {
  return decide([&]<class Number>() {
    const Number length = Number(radii) * total_radius<Number>(pair) + Number(offset);
    return RootSum<Number>{{{scaled_separation<Number>(pair, p.face, p.vertex), Number(1.0)},
                            {-length, square<Number>(pair, p.face)},
                            {}}};
  });
}

}  // namespace

Truth::Truth(const PairCase& pair)
    : pair_(pair),
      stored_(exact::stored(pair)),
      size_(manifuzz::size(pair)),
      extent_(manifuzz::extent(pair)),
      placed_(place_roughly(stored_)),
      rough_(separations(placed_, extent_)) {}

Truth::Truth(const PairCase& pair, const UsedShapes& used)
    : stored_(exact::stored(pair, used)),
      size_(manifuzz::size(pair)),
      placed_(place_roughly(stored_)) {
  pair_ = nearest(pair, stored_);
  extent_ = manifuzz::extent(pair_) * kExtentSlack;
  rough_ = separations(placed_, extent_);
}

int Truth::rough_sign(double value, double offset) const {
  const double error = 2 * rough_.error + 0x1p-51 * std::abs(offset);
  return value > error ? 1 : value < -error ? -1 : 0;
}

int Truth::support(FaceOf face) const {
  std::optional<int>& known = support_[at(face.side)][face.index];
  if (known) return *known;
  const Side opposing = other(face.side);
  const RoughPolygon& polygon = placed_[opposing];
  const Vector2<double>& normal = placed_[face.side].normals[face.index];
  int deepest = 0;
  for (int j = 1; j < polygon.count; ++j) {
    const double deeper = normal.dot(polygon.vertices[deepest] - polygon.vertices[j]);
    const int s = decide_from(deeper, rough_.error, [&]<class Number>() {
      return RootSum<Number>{
          {{dot(outward<Number>(stored_, face),
                vertex<Number>(stored_, opposing, deepest) - vertex<Number>(stored_, opposing, j))},
           {},
           {}}};
    });
    if (s > 0) deepest = j;
  }
  known = deepest;
  return deepest;
}

DoubleDouble Truth::fine_separation(FaceOf face) const {
  using Fine = Approximate<DoubleDouble>;
  return (scaled_separation<Fine>(stored_, face, support(face)) / sqrt(square<Fine>(stored_, face)))
      .value;
}

FaceAndVertex Truth::deepest(FaceOf face) const {
  return {face, support(face)};
}

FaceOf Truth::greatest(Side side) const {
  std::optional<int>& known = greatest_[at(side)];
  if (!known) {
    const double contends = separation(side) - 2 * rough_.error;
    for (int i = 0; i < pair_[side].polygon.count; ++i) {
      if (separation(FaceOf{side, i}) < contends) continue;
      if (!known ||
          compare_distances(stored_, deepest({side, i}), deepest({side, *known}), 0) > 0) {
        known = i;
      }
    }
  }
  return {side, *known};
}

int Truth::compare_separation(int radii, double offset) const {
  const double length = radii * manifuzz::total_radius(pair_) + offset;
  if (const int s = rough_sign(separation() - length, length)) return s;
  return std::max(compare_distance(stored_, deepest(greatest(Side::a)), radii, offset),
                  compare_distance(stored_, deepest(greatest(Side::b)), radii, offset));
}

int Truth::compare_separation(double offset) const {
  return compare_separation(0, offset);
}

int Truth::compare_contact(double offset) const {
  return compare_separation(1, offset);
}

int Truth::compare_lead_of_b(double offset) const {
  return compare_lead(Side::b, 1, offset);
}

int Truth::compare_lead(Side side, double share, double offset) const {
  const Side opposing = other(side);
  const double lead = separation(side) - share * separation(opposing) - offset;
  if (const int s = rough_sign(lead, offset)) return s;
  return compare_distances(stored_, deepest(greatest(side)), deepest(greatest(opposing)), offset,
                           share);
}

int Truth::compare_separations(FaceOf face, FaceOf another, double offset) const {
  if (const int s = rough_sign(separation(face) - separation(another) - offset, offset)) return s;
  return compare_distances(stored_, deepest(face), deepest(another), offset);
}

int Truth::compare_with_greatest(FaceOf face, double offset) const {
  if (const int s = rough_sign(separation(face) - separation(face.side) - offset, offset)) return s;
  return compare_separations(face, greatest(face.side), offset);
}

std::vector<int> Truth::incident_edges(FaceOf reference, double bound) const {
  const Side opposing = other(reference.side);
  const int count = pair_[opposing].polygon.count;
  const Vector2<double>& normal = placed_[reference.side].normals[reference.index];
  std::array<double, kMaxVertices> dots{};
  for (int j = 0; j < count; ++j) dots[j] = normal.dot(placed_[opposing].normals[j]);
  const double least = *std::min_element(dots.begin(), dots.begin() + count);

  // dot_j - dot_k - bound, times the lengths of all three faces.
  const auto compare = [&](int j, int k, double offset) {
    const double apart = dots[j] - dots[k] - offset;
    if (std::abs(apart) > 3 * kErrorOfDot) return apart > 0 ? 1 : -1;
    return decide([&]<class Number>() {
      const auto out = outward<Number>(stored_, reference);
      const FaceOf edge_j{opposing, j};
      const FaceOf edge_k{opposing, k};
      const Number square_j = square<Number>(stored_, edge_j);
      const Number square_k = square<Number>(stored_, edge_k);
      return RootSum<Number>{
          {{dot(out, outward<Number>(stored_, edge_j)), square_k},
           {-dot(out, outward<Number>(stored_, edge_k)), square_j},
           {-Number(offset), square<Number>(stored_, reference) * square_j * square_k}}};
    });
  };
  int best = -1;
  for (int j = 0; j < count; ++j) {
    if (dots[j] > least + 2 * kErrorOfDot) continue;
    if (best < 0 || compare(j, best, 0) < 0) best = j;
  }
  std::vector<int> edges;
  for (int j = 0; j < count; ++j) {
    if (j == best || compare(j, best, bound) <= 0) edges.push_back(j);
  }
  return edges;
}

const Clip& Truth::clip(FaceOf reference, int incident) const {
  for (const auto& made : clips_) {
    if (made->reference == reference && made->incident == incident) return *made;
  }
  return *clips_.emplace_back(
      std::make_unique<const Clip>(exact::clip(stored_, reference, incident)));
}

}  // namespace manifuzz::exact
