#include "exact/truth.hpp"

#include <cmath>

namespace manifuzz::exact {
namespace {

/// With the floats nearest to what is stored; as floats they may be no polygons, and their normals
/// mean nothing.
PairCase nearest(PairCase pair, const StoredPair& shapes, const UsedShapes& used) {
  for (const Side side : {Side::a, Side::b}) {
    const StoredPolygon& from = shapes[side].polygon;
    ConvexPolygon<float>& polygon = pair[side].polygon;
    polygon.count = from.count;
    if (used[side].round_radius) {
      polygon.radius = *used[side].round_radius;
      polygon.rounding = Rounding::round;
    }
    for (int i = 0; i < from.count; ++i) polygon.vertices[i] = from.vertices[i].cast<float>();
  }
  return pair;
}

/// More than rounding to float may take from an extent.
constexpr double kExtentSlack = 1 + 0x1p-20;

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

Truth::Truth(const PairCase& pair) : pair_(pair), rough_(separations(pair)) {}

Truth::Truth(const PairCase& pair, const UsedShapes& used)
    : stored_(exact::stored(pair, used)), size_(manifuzz::size(pair)) {
  pair_ = nearest(pair, *stored_, used);
  rough_ = separations(*stored_, manifuzz::extent(pair_) * kExtentSlack);
}

double Truth::size() const {
  if (!size_) size_ = manifuzz::size(pair_);
  return *size_;
}

double Truth::size_at_least() const {
  if (size_) return *size_;
  const auto across = [](const ConvexPolygon<float>& polygon) {
    const Vector2<double> d =
        polygon.vertices[polygon.count / 2].cast<double>() - polygon.vertices[0].cast<double>();
    return d.dot(d);
  };
  return std::sqrt(std::min(across(pair_.a.polygon), across(pair_.b.polygon)));
}

int Truth::rough_sign(double value, double offset) const {
  const double error = 2 * rough_.error + 0x1p-51 * std::abs(offset);
  return value > error ? 1 : value < -error ? -1 : 0;
}

int Truth::support(FaceOf face) const {
  std::optional<std::uint8_t>& known = support_[at(face.side)][face.index];
  if (known) return *known;
  const Side opposing = other(face.side);
  const RoughPolygon& polygon = placed()[opposing];
  const Vector2<double>& normal = placed()[face.side].normals[face.index];
  int deepest = 0;
  for (int j = 1; j < polygon.count; ++j) {
    const double deeper = normal.dot(polygon.vertices[deepest] - polygon.vertices[j]);
    const int s = decide_from(deeper, rough_.error, [&]<class Number>() {
      return RootSum<Number>{
          {{dot(outward<Number>(stored(), face), vertex<Number>(stored(), opposing, deepest) -
                                                     vertex<Number>(stored(), opposing, j))},
           {},
           {}}};
    });
    if (s > 0) deepest = j;
  }
  known = static_cast<std::uint8_t>(deepest);
  return deepest;
}

DoubleDouble Truth::fine_separation(FaceOf face) const {
  using Fine = Approximate<DoubleDouble>;
  return (scaled_separation<Fine>(stored(), face, support(face)) /
          sqrt(square<Fine>(stored(), face)))
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
          compare_distances(stored(), deepest({side, i}), deepest({side, *known}), 0) > 0) {
        known = i;
      }
    }
  }
  return {side, *known};
}

int Truth::compare_separation(int radii, double offset) const {
  const double length = radii * manifuzz::total_radius(pair_) + offset;
  if (const int s = rough_sign(separation() - length, length)) return s;
  int greater = -1;
  for (const Side side : {Side::a, Side::b}) {
    if (!has_faces(side)) continue;
    greater = std::max(greater, compare_distance(stored(), deepest(greatest(side)), radii, offset));
  }
  return greater;
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
  return compare_distances(stored(), deepest(greatest(side)), deepest(greatest(opposing)), offset,
                           share);
}

int Truth::compare_separations(FaceOf face, FaceOf another, double offset) const {
  if (const int s = rough_sign(separation(face) - separation(another) - offset, offset)) return s;
  return compare_distances(stored(), deepest(face), deepest(another), offset);
}

int Truth::compare_with_greatest(FaceOf face, double offset) const {
  if (const int s = rough_sign(separation(face) - separation(face.side) - offset, offset)) return s;
  return compare_separations(face, greatest(face.side), offset);
}

std::vector<int> Truth::incident_edges(FaceOf reference, double bound) const {
  const Side opposing = other(reference.side);
  const int count = pair_[opposing].polygon.count;
  const Vector2<double>& normal = placed()[reference.side].normals[reference.index];
  std::array<double, kMaxVertices> dots{};
  for (int j = 0; j < count; ++j) dots[j] = normal.dot(placed()[opposing].normals[j]);
  const double least = *std::min_element(dots.begin(), dots.begin() + count);

  // dot_j - dot_k - bound, times the lengths of all three faces.
  const auto compare = [&](int j, int k, double offset) {
    const double apart = dots[j] - dots[k] - offset;
    if (std::abs(apart) > 3 * kErrorOfDot) return apart > 0 ? 1 : -1;
    return decide([&]<class Number>() {
      const auto out = outward<Number>(stored(), reference);
      const FaceOf edge_j{opposing, j};
      const FaceOf edge_k{opposing, k};
      const Number square_j = square<Number>(stored(), edge_j);
      const Number square_k = square<Number>(stored(), edge_k);
      return RootSum<Number>{
          {{dot(out, outward<Number>(stored(), edge_j)), square_k},
           {-dot(out, outward<Number>(stored(), edge_k)), square_j},
           {-Number(offset), square<Number>(stored(), reference) * square_j * square_k}}};
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
      std::make_unique<const Clip>(exact::clip(stored(), reference, incident)));
}

}  // namespace manifuzz::exact
