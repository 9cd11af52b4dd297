#include <algorithm>
#include <cassert>
#include <limits>

#include "exact/curve.hpp"

namespace manifuzz::exact {
namespace {

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

/// W's faces that look along the normal; the ray leaves W through one of them.
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
      return cross(this->normal<Number>(), outward_from_a<Number>(pair(), face));
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

}  // namespace manifuzz::exact
