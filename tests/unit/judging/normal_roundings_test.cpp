#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

#include "base/random.hpp"
#include "judging/judge.hpp"
#include "judging/manifold_error.hpp"
#include "own_colliders/own_colliders.hpp"

// How far its own roundings take the normal that clip64 reports of a face of B: bounds.md, "How
// much of a normal's bound `clip64` takes".

using namespace manifuzz;

namespace {

constexpr double kBound = 12;  ///< of a normal, in roundoffs

/// In units of roundoffs, of what is at most as long as 1: half of the last place.
double half_place(double of) {
  if (of == 0) return 0;
  const double top = std::abs(of) * (1 + 1e-12);  // a power of two counts as what is above it
  return top >= 1 ? 0.5 : std::ldexp(0.5, std::ilogb(top) + 1);
}

Vector2<double> at_angle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

/// Both rotations, the face's normal in B's frame, and a direction in A's frame: angles.
struct Angles {
  double of_a, of_b, of_normal, direction;
};

/// What each rounding adds to the reported normal's error along the direction, at most.
class Effects {
 public:
  explicit Effects(const Angles& at) {
    const double turn = at.of_b - at.of_a;
    const double reported = turn + at.of_normal;
    const double across = std::abs(std::sin(at.direction - reported));
    // A part's own error is turned by what it is multiplied with; A's is mirrored, too.
    add_unit(at_angle(at.of_a), at_angle(at.of_a + reported - at.direction), across);
    add_unit(at_angle(at.of_b), at_angle(at.of_b - reported + at.direction), across);
    add_unit(at_angle(at.of_normal), at_angle(at.of_normal - reported + at.direction), across);
    add_product(at_angle(-at.of_a), at_angle(at.of_b), at_angle(at.direction - at.of_normal));
    add_product(at_angle(turn), at_angle(at.of_normal), at_angle(at.direction));
  }

  double sum() const {
    double sum = 0;
    for (const double most : most_) sum += most;
    return sum;
  }
  /// From independent roundings, each anywhere between its bounds alike.
  double variance() const {
    double sum = 0;
    for (const double most : most_) sum += most * most / 3;
    return sum;
  }

 private:
  /// `unit_direction`: of two quotients what is across, for the length is mended; a last rounding.
  void add_unit(const Vector2<double>& n, const Vector2<double>& direction, double across) {
    most_.push_back(across * std::abs(n.y()) * half_place(n.x()));
    most_.push_back(across * std::abs(n.x()) * half_place(n.y()));
    add(half_place(n.x()), direction.x());
    add(half_place(n.y()), direction.y());
  }
  /// Products of the parts of two unit vectors, and their sums.
  void add_product(const Vector2<double>& r, const Vector2<double>& v,
                   const Vector2<double>& direction) {
    const Vector2<double> product = rotate<double>(r, v);
    for (const double x : {r.x() * v.x(), r.y() * v.y()}) add(half_place(x), direction.x());
    for (const double y : {r.x() * v.y(), r.y() * v.x()}) add(half_place(y), direction.y());
    add(half_place(product.x()), direction.x());
    add(half_place(product.y()), direction.y());
  }
  void add(double most, double along) { most_.push_back(most * std::abs(along)); }

  std::vector<double> most_;
};

double sum_of(const Angles& at) {
  return Effects(at).sum();
}

double deviation_of(const Angles& at) {
  return std::sqrt(Effects(at).variance());
}

/// The angles at which `figure` is greatest, as far as a search finds them: the best of drawn ones,
/// moved by less and less.
Angles greatest(double (*figure)(const Angles&)) {
  struct Found {
    Angles at;
    double value;
  };
  Random random(1, "angles", 0);
  std::vector<Found> found;
  const auto add = [&](const Angles& middle, double within) {
    Angles at = middle;
    for (double* const angle : {&at.of_a, &at.of_b, &at.of_normal, &at.direction}) {
      *angle += random.uniform(-within, within);
    }
    found.push_back({at, figure(at)});
  };
  const auto keep_best = [&] {
    std::ranges::stable_sort(found, std::ranges::greater{}, &Found::value);
    found.resize(20);
  };
  for (int i = 0; i < 20'000; ++i) add({}, std::numbers::pi);
  keep_best();
  for (double within = 0.2; within > 1e-4; within *= 0.8) {
    for (int best = 0; best < 20; ++best) {
      for (int i = 0; i < 20; ++i) add(found[static_cast<std::size_t>(best)].at, within);
    }
    keep_best();
  }
  return found.front().at;
}

ConvexPolygon<float> triangle(Random& random, double angle) {
  std::array<Vector2<float>, 3> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double turned = angle + (static_cast<double>(i) - 1) * 2 * std::numbers::pi / 3;
    const double off = random.uniform(-0.004, 0.004);
    corners[i] = (random.uniform(1, 1.01) * at_angle(turned + off)).cast<float>();
  }
  return make_polygon<float>(corners);
}

/// A corner of A a little behind a face of B, all near those angles.
PairCase corner_on_face(Random& random, const Angles& at) {
  const double reported = at.of_b - at.of_a + at.of_normal;
  const double of_b = at.of_b + random.uniform(-0.004, 0.004);
  const double of_a = at.of_a + random.uniform(-0.004, 0.004);
  PairCase pair;
  pair.a.polygon = triangle(random, reported + std::numbers::pi);
  pair.b.polygon = triangle(random, at.of_normal + std::numbers::pi / 3);
  pair.a.pose.rotation = at_angle(of_a).cast<float>();
  pair.b.pose.rotation = at_angle(of_b).cast<float>();
  pair.a.pose.position = (1.45 * at_angle(at.of_b + at.of_normal)).cast<float>();
  return pair;
}

}  // namespace

TEST_CASE("roundings of a normal of clip64 add up to six tenths of its bound") {
  CHECK(sum_of(greatest(sum_of)) == Approx(7.2).margin(0.05));
  const Angles widest = greatest(deviation_of);
  CHECK(deviation_of(widest) == Approx(0.90).margin(0.01));
}

TEST_CASE("normals of clip64 spread as independent roundings do") {
  const Collider clip64 = make_clip64();
  const Angles widest = greatest(deviation_of);
  constexpr int cases = 4000;
  double squares = 0;
  double most = 0;
  Random random(2, "corners", 0);
  for (int i = 0; i < cases; ++i) {
    const PairCase pair = corner_on_face(random, widest);
    const Admissible right = admissible(pair, clip64.declaration);
    ClipFiguresCache figures;
    const auto manifold = std::get<Manifold<double>>(clip64.collide(pair));
    const auto measured = error_if_right(manifold, right, figures);
    REQUIRE(measured);
    REQUIRE(measured->clip->reference.side == Side::b);
    const double off = kBound * measured->of_bound.normal;
    squares += off * off;
    most = std::max(most, off);
  }
  Angles across = widest;
  across.direction += std::numbers::pi / 2;
  const double expected = cases * (Effects(widest).variance() + Effects(across).variance());
  CAPTURE(most);
  CHECK(squares / expected == Approx(1).margin(0.15));
  CHECK(most < 5);
}
