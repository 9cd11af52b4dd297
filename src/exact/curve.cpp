#include "exact/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace manifuzz::exact {
namespace {

/// Whether two faces of W have one direction.
bool faces_alike(const StoredPair& pair, FaceOf one, FaceOf another) {
  const int is_ahead = decide_from_doubles([&]<class Number>() {
    return sum_of(Root<Number>{
        dot(outward_from_a<Number>(pair, one), outward_from_a<Number>(pair, another))});
  });
  const int turn = decide_from_doubles([&]<class Number>() {
    return sum_of(Root<Number>{
        cross(outward_from_a<Number>(pair, one), outward_from_a<Number>(pair, another))});
  });
  return is_ahead > 0 && turn == 0;
}

/// Two vertices that are nearest to each other: neither has a neighbour that is nearer along the
/// line through both.
class NearestVertices {
 public:
  explicit NearestVertices(const Truth& truth)
      : pair_(truth.stored()),
        placed_(place_roughly(pair_)),
        error_(kErrorOfProduct * truth.extent() * truth.extent()) {}

  std::optional<std::array<int, 2>> find() const {
    for (int a = 0; a < placed_.a.count; ++a) {
      for (int b = 0; b < placed_.b.count; ++b) {
        if (are_nearest({a, b})) return std::array{a, b};
      }
    }
    return std::nullopt;
  }

 private:
  // The difference of two placed vertices is off by less than 10 u E as a vector, and no longer
  // than 2 E: a product of two of them is off by 2 (10 u E) (2 E) + 2 u (2 E)^2 = 48 u E^2.
  static constexpr double kErrorOfProduct = 0x1p-47;  // 64 u

  bool are_nearest(const std::array<int, 2>& of) const {
    return is_farthest(Side::a, of) && is_farthest(Side::b, of);
  }

  /// Whether a side's vertex is the farthest one towards the other side's.
  bool is_farthest(Side side, const std::array<int, 2>& of) const {
    const int own = of[static_cast<std::size_t>(side)];
    const int opposing = of[static_cast<std::size_t>(other(side))];
    const auto& polygon = pair_[side].polygon;
    const auto is_farther = [&](int neighbour) {
      const auto& rough = placed_[side].vertices;
      const Vector2<double> apart = placed_[other(side)].vertices[opposing] - rough[own];
      const double product = apart.dot(rough[neighbour] - rough[own]);
      if (std::abs(product) > error_) return product > 0;
      return decide_from_doubles([&]<class Number>() {
               const Point<Number> at = vertex<Number>(pair_, side, own);
               return sum_of(Root<Number>{dot(vertex<Number>(pair_, other(side), opposing) - at,
                                              vertex<Number>(pair_, side, neighbour) - at)});
             }) > 0;
    };
    return !is_farther(polygon.next(own)) && !is_farther(polygon.previous(own));
  }

  const StoredPair& pair_;
  RoughPair placed_;
  double error_;
};

}  // namespace

PenetrationCurve::PenetrationCurve(const Truth& truth, Skin skin)
    : truth_(&truth),
      face_(truth.has_faces() ? truth.greatest() : FaceOf{}),
      is_apart_(skin == Skin::round && (!truth.has_faces() || truth.compare_separation(0) >= 0)) {
  if (!is_apart_) return;
  // Cores that are apart are nearest at the face of the greatest separation, or at two vertices:
  // faces of segments on one line do not say how far these are apart.
  vertices_ = NearestVertices(truth).find();
  if (!vertices_) return;
  are_at_one_place_ = decide_from_doubles([&]<class Number>() {
                        const Point<Number> between = between_vertices<Number>();
                        return sum_of(Root<Number>{dot(between, between)});
                      }) == 0;
  if (are_at_one_place_ && truth.has_faces()) vertices_.reset();
  is_apart_ = vertices_ || truth.compare_separation(0) > 0;
}

template <class Number>
PenetrationCurve::Apart<Number> PenetrationCurve::apart() const {
  if (!vertices_) {
    const Number squared = square<Number>(pair(), face_);
    return {{scaled_separation<Number>(pair(), face_, truth_->support(face_)), squared}, squared};
  }
  const Point<Number> between = between_vertices<Number>();
  return {{Number(1.0), dot(between, between)}, Number(1.0)};
}

template <class Number>
Point<Number> PenetrationCurve::between_vertices() const {
  return vertex<Number>(pair(), Side::b, (*vertices_)[1]) -
         vertex<Number>(pair(), Side::a, (*vertices_)[0]);
}

double PenetrationCurve::least() const {
  using Fine = Approximate<DoubleDouble>;
  const auto [root, divisor] = apart<Fine>();
  return leading(
      (total_radius<Fine>(pair()) - root.coefficient * sqrt(root.radicand) / divisor).value);
}

int PenetrationCurve::compare_least(double length) const {
  return decide_from_doubles([&]<class Number>() {
    const auto [root, divisor] = apart<Number>();
    return sum_of(Root<Number>{(total_radius<Number>(pair()) - Number(length)) * divisor},
                  Root<Number>{-root.coefficient, root.radicand});
  });
}

int PenetrationCurve::compare_excess(const Along& along, double bound) const {
  // D(n) - R = support / |n|, D* - R = -root / divisor; times |n|^2 and the divisor.
  return decide_from_doubles([&]<class Number>() {
    const auto [root, divisor] = apart<Number>();
    const Point<Number> n = along.normal<Number>();
    const Number squared = dot(n, n);
    return sum_of(Root<Number>{along.scaled_support<Number>() * divisor, squared},
                  Root<Number>{root.coefficient * squared, root.radicand},
                  Root<Number>{-Number(bound) * squared * divisor});
  });
}

std::vector<Vector2<double>> PenetrationCurve::minima(double bound) const {
  std::vector<Vector2<double>> normals;
  if (vertices_ && are_at_one_place_) {
    normals.emplace_back(1, 0);
    return normals;
  }
  if (vertices_) {
    // Corners may be as near to each other as no pair of doubles tells.
    const Point<Rational> towards_b = turned_back(pair().a, between_vertices<Rational>());
    const Rational most = std::max<Rational>(abs(towards_b.x), abs(towards_b.y));
    const Vector2<double> direction(static_cast<double>(Rational(towards_b.x / most)),
                                    static_cast<double>(Rational(towards_b.y / most)));
    normals.emplace_back(direction / direction.norm());
    return normals;
  }
  normals.push_back(unit_normal(face_));
  if (is_apart_) return normals;
  std::vector<FaceOf> found{face_};
  for (const FaceOf& face : all_faces(pair())) {
    if (truth_->compare_separations(face, face_, -bound) < 0) continue;
    const bool is_known = std::ranges::any_of(
        found, [&](const FaceOf& known) { return faces_alike(pair(), face, known); });
    if (is_known) continue;
    found.push_back(face);
    normals.push_back(unit_normal(face));
  }
  return normals;
}

double separation_of(const Truth& truth) {
  if (skin_of(truth) == Skin::mitred) return leading(truth.fine_separation(truth.greatest()));
  return total_radius(truth.pair()) - PenetrationCurve(truth, Skin::round).least();
}

Vector2<double> PenetrationCurve::unit_normal(FaceOf face) const {
  const auto normal = true_normal<Approximate<DoubleDouble>>(pair(), face);
  return {leading(normal.x.value), leading(normal.y.value)};
}

std::vector<double> angles_to_draw(const RoughPair& placed) {
  std::vector<double> all;
  for (int i = 0; i < 180; ++i) all.push_back(i * std::numbers::pi / 90);
  const auto add = [&all](const Vector2<double>& normal) {
    const double angle = std::atan2(normal.y(), normal.x());
    all.push_back(angle < 0 ? angle + 2 * std::numbers::pi : angle);
  };
  for (int i = 0; i < placed.a.count; ++i) add(placed.a.normals[i]);
  for (int j = 0; j < placed.b.count; ++j) add(-placed.b.normals[j]);
  std::ranges::sort(all);
  return all;
}

}  // namespace manifuzz::exact
