#include "oracle/exact/curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace manifuzz::exact {
namespace {

template <class Number>
RootSum<Number> sum_of(const Root<Number>& one, const Root<Number>& two = {},
                       const Root<Number>& three = {}) {
  return {one, two, three};
}

/// The vertex of a side that lies farthest in a direction of the world, the first of equals.
/// `direction` is called with a number type.
template <class Direction>
int farthest(const StoredPair& pair, Side side, const Direction& direction) {
  int best = 0;
  for (int i = 1; i < pair[side].polygon.count; ++i) {
    const int s = decide_from_doubles([&]<class Number>() {
      return sum_of(
          Root<Number>{dot(direction.template operator()<Number>(),
                           vertex<Number>(pair, side, i) - vertex<Number>(pair, side, best))});
    });
    if (s > 0) best = i;
  }
  return best;
}

std::vector<FaceOf> all_faces(const StoredPair& pair) {
  std::vector<FaceOf> faces;
  for (const Side side : {Side::a, Side::b}) {
    for (int i = 0; i < pair[side].polygon.count; ++i) faces.push_back({side, i});
  }
  return faces;
}

/// Whether two faces of W have one direction.
bool faces_alike(const StoredPair& pair, FaceOf one, FaceOf another) {
  const int is_ahead = decide_from_doubles([&]<class Number>() {
    return sum_of(Root<Number>{
        dot(outward_from_a<Number>(pair, one), outward_from_a<Number>(pair, another))});
  });
  const int turn = decide_from_doubles([&]<class Number>() {
    const Point<Number> p = outward_from_a<Number>(pair, one);
    const Point<Number> q = outward_from_a<Number>(pair, another);
    return sum_of(Root<Number>{p.x * q.y - p.y * q.x});
  });
  return is_ahead > 0 && turn == 0;
}

template <class Number>
Point<Number> minus(const Point<Number>& p) {
  return {-p.x, -p.y};
}

}  // namespace

Along::Along(const Truth& truth, const Vector2<double>& normal) : truth_(&truth), normal_(normal) {
  assert(normal.allFinite() && !normal.isZero(0));
  farthest_of_a_ =
      farthest(pair(), Side::a, [&]<class Number>() { return this->normal<Number>(); });
  nearest_of_b_ =
      farthest(pair(), Side::b, [&]<class Number>() { return minus(this->normal<Number>()); });
  ahead_ = faces_ahead();
}

double Along::depth() const {
  using Fine = Approximate<DoubleDouble>;
  const Point<Fine> n = this->normal<Fine>();
  return leading((scaled_support<Fine>() / sqrt(dot(n, n)) + total_radius<Fine>(pair())).value);
}

int Along::compare_depth(double length) const {
  return decide_from_doubles([&]<class Number>() {
    const Point<Number> n = this->normal<Number>();
    return sum_of(Root<Number>{scaled_support<Number>()},
                  Root<Number>{total_radius<Number>(pair()) - Number(length), dot(n, n)});
  });
}

int Along::compare_reach(double length) const {
  int least = 1;
  for (const double turn : {1.0, -1.0}) {
    const auto tangent = [&]<class Number>() {
      const Point<Number> n = this->normal<Number>();
      return Point<Number>{-Number(turn) * n.y, Number(turn) * n.x};
    };
    const int a = farthest(pair(), Side::a, tangent);
    const int b = farthest(pair(), Side::b, [&]<class Number>() {
      return minus(tangent.template operator()<Number>());
    });
    const int reaches = decide_from_doubles([&]<class Number>() {
      const Point<Number> n = this->normal<Number>();
      return sum_of(Root<Number>{dot(
                        tangent.template operator()<Number>(),
                        vertex<Number>(pair(), Side::a, a) - vertex<Number>(pair(), Side::b, b))},
                    Root<Number>{Number(-length), dot(n, n)});
    });
    least = std::min(least, reaches);
  }
  return least;
}

/// Those, and faces whose lines it crosses beyond.
std::vector<FaceOf> Along::faces_ahead() const {
  std::vector<FaceOf> ahead;
  for (const FaceOf& face : all_faces(pair())) {
    const int s = decide_from_doubles([&]<class Number>() {
      return sum_of(
          Root<Number>{dot(outward_from_a<Number>(pair(), face), this->normal<Number>())});
    });
    if (s > 0) ahead.push_back(face);
  }
  return ahead;
}

double Along::gap() const {
  if (!meets()) return -std::numeric_limits<double>::infinity();
  using Fine = Approximate<DoubleDouble>;
  const Point<Fine> n = this->normal<Fine>();
  double least = std::numeric_limits<double>::infinity();
  for (const FaceOf& face : ahead_) {
    const Fine rise = dot(outward_from_a<Fine>(pair(), face), n);
    const Fine scaled = scaled_separation<Fine>(pair(), face, truth_->support(face));
    least = std::min(least, leading((-scaled / rise * sqrt(dot(n, n))).value));
  }
  return least + (pair().a.polygon.radius + pair().b.polygon.radius);
}

/// W's faces ahead, each moved out by `slide` times the sine of its angle to the normal, as sliding
/// B both ways moves the outermost of them, and in where it is negative.
int Along::compare_ahead(double length, double slide) const {
  int least = 1;
  for (const FaceOf& face : ahead_) {
    const auto turn = [&]<class Number>() {
      const Point<Number> n = this->normal<Number>();
      const Point<Number> out = outward_from_a<Number>(pair(), face);
      return n.x * out.y - n.y * out.x;
    };
    const double side = decide_from_doubles([&]<class Number>() {
                          return sum_of(Root<Number>{turn.template operator()<Number>()});
                        }) < 0
                            ? -1
                            : 1;
    // -separation |n| / rise + R - length, times the rise.
    const int s = decide_from_doubles([&]<class Number>() {
      const Point<Number> n = this->normal<Number>();
      const Number rise = dot(outward_from_a<Number>(pair(), face), n);
      const Number scaled = scaled_separation<Number>(pair(), face, truth_->support(face));
      return sum_of(Root<Number>{-scaled, dot(n, n)},
                    Root<Number>{(total_radius<Number>(pair()) - Number(length)) * rise},
                    Root<Number>{Number(side * slide) * turn.template operator()<Number>()});
    });
    least = std::min(least, s);
  }
  return least;
}

int Along::compare_gap(double length, double slide) const {
  if (!meets(slide)) return -1;
  return std::min(compare_ahead(length, slide), compare_depth(length));
}

int Along::compare_least_gap(double length, double slide) const {
  if (compare_reach(slide) < 0) return -1;
  return compare_ahead(length, -slide);
}

namespace {

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
      face_(truth.greatest()),
      is_apart_(skin == Skin::round && truth.compare_separation(0) > 0) {
  // Cores that are apart are nearest at the face of the greatest separation, or at two vertices.
  if (is_apart_) vertices_ = NearestVertices(truth).find();
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
  if (vertices_) {
    using Fine = Approximate<DoubleDouble>;
    const Point<Fine> towards_b = turned_back(pair().a, between_vertices<Fine>());
    const Fine length = sqrt(dot(towards_b, towards_b));
    normals.emplace_back(leading((towards_b.x / length).value),
                         leading((towards_b.y / length).value));
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

Vector2<double> PenetrationCurve::unit_normal(FaceOf face) const {
  const auto normal = true_normal<Approximate<DoubleDouble>>(pair(), face);
  return {leading(normal.x.value), leading(normal.y.value)};
}

}  // namespace manifuzz::exact
