#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <catch2/catch.hpp>

#include "base/text.hpp"
#include "exact/truth.hpp"
#include "generating/sweep.hpp"
#include "unit/generating/check_sweeps.hpp"

namespace manifuzz {
namespace {

constexpr double kUlp = 0x1p-23;
constexpr double kBox2dBias = 0.0005;

/// A polygon in the world, as seen from A's position, in double.
struct Placed {
  std::vector<Vector2<double>> vertices;

  std::size_t next(std::size_t i) const { return (i + 1) % vertices.size(); }
  Vector2<double> face(std::size_t i) const { return vertices[next(i)] - vertices[i]; }
};

Placed placed(const PairCase& pair, Side side) {
  const Body& body = pair[side];
  const double c = body.pose.rotation.x();
  const double s = body.pose.rotation.y();
  Vector2<double> apart(0, 0);
  if (side == Side::b) {
    apart = pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
  }
  Placed result;
  for (const auto& v : body.polygon.corners()) {
    const double x = v.x();
    const double y = v.y();
    result.vertices.emplace_back(c * x - s * y + apart.x(), s * x + c * y + apart.y());
  }
  return result;
}

double length(const Vector2<double>& v) {
  return std::hypot(v.x(), v.y());
}

/// The tangent of the angle between two directions, either way.
double tangent(const Vector2<double>& u, const Vector2<double>& v) {
  return std::abs(cross(u, v) / u.dot(v));
}

/// How far the nearest of what `visit` is called with lies from `wanted`.
class Nearest {
 public:
  explicit Nearest(double wanted) : wanted_(wanted) {}
  void see(double value) { off_ = std::min(off_, std::abs(value - wanted_)); }
  double off() const { return off_; }

 private:
  double wanted_;
  double off_ = std::numeric_limits<double>::infinity();
};

double larger_aspect(const PairCase& pair) {
  double aspect = 0;
  for (const Side side : {Side::a, Side::b}) {
    const Placed polygon = placed(pair, side);
    double thickness = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      double farthest = 0;
      for (const auto& v : polygon.vertices) {
        farthest =
            std::max(farthest, cross(polygon.face(i), Vector2<double>(v - polygon.vertices[i])));
      }
      thickness = std::min(thickness, farthest / length(polygon.face(i)));
    }
    aspect = std::max(aspect, diameter(pair[side].polygon) / thickness);
  }
  return aspect;
}

double least_turn(const PairCase& pair) {
  double least = std::numeric_limits<double>::infinity();
  for (const Side side : {Side::a, Side::b}) {
    const Placed polygon = placed(pair, side);
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      const Vector2<double> after = polygon.face(polygon.next(i));
      if (polygon.face(i).dot(after) > 0) least = std::min(least, tangent(polygon.face(i), after));
    }
  }
  return least;
}

/// As a share of its polygon's diameter.
double shortest_face(const PairCase& pair) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const Side side : {Side::a, Side::b}) {
    const Placed polygon = placed(pair, side);
    for (std::size_t i = 0; i < polygon.vertices.size(); ++i) {
      shortest = std::min(shortest, length(polygon.face(i)) / diameter(pair[side].polygon));
    }
  }
  return shortest;
}

/// Looks where both faces at a vertex of one polygon lean alike from another's face, but for a
/// tangent.
void see_leans(const Placed& of, const Placed& to, Nearest& nearest) {
  for (std::size_t i = 0; i < of.vertices.size(); ++i) {
    for (std::size_t k = 0; k < to.vertices.size(); ++k) {
      const Vector2<double> before = to.face(k) / length(to.face(k));
      const Vector2<double> after = to.face(to.next(k)) / length(to.face(to.next(k)));
      nearest.see(tangent(before + after, of.face(i)));
    }
  }
}

/// How far an end of an edge lies, along a face, from the face's ends.
void see_ends(const Placed& of, const Placed& to, Nearest& nearest) {
  for (std::size_t i = 0; i < of.vertices.size(); ++i) {
    const Vector2<double> along = of.face(i) / length(of.face(i));
    for (const auto& v : to.vertices) {
      for (const std::size_t end : {i, of.next(i)}) {
        nearest.see(std::abs(along.dot(v - of.vertices[end])));
      }
    }
  }
}

bool is_share(double value, double of, double off) {
  return std::abs(value - of) <= off * of;
}

/// Whether the knob does what it says, measured from the stored floats.
const Knobs kKnobs{
    {"distance",
     [](const PairCase& pair, double x) {
       return is_share(length(pair.a.pose.position.cast<double>()), x, 1e-6);
     }},
    {"angle",
     [](const PairCase& pair, double x) {
       Nearest nearest(x);
       const Placed a = placed(pair, Side::a);
       const Placed b = placed(pair, Side::b);
       for (std::size_t i = 0; i < a.vertices.size(); ++i) {
         for (std::size_t k = 0; k < b.vertices.size(); ++k) {
           nearest.see(tangent(a.face(i), b.face(k)));
         }
       }
       return nearest.off() <= 0.01 * x;
     }},
    {"aspect",
     [](const PairCase& pair, double x) {
       const double aspect = larger_aspect(pair);
       return aspect >= 0.5 * x && aspect <= 3 * x;
     }},
    {"small",
     [](const PairCase& pair, double x) { return size(pair) >= 0.4 * x && size(pair) <= 3 * x; }},
    {"large",
     [](const PairCase& pair, double x) { return size(pair) >= 0.4 * x && size(pair) <= 3 * x; }},
    {"ratio",
     [](const PairCase& pair, double x) {
       const double larger = std::max(diameter(pair.a.polygon), diameter(pair.b.polygon));
       return is_share(larger / size(pair), x, 1e-3);
     }},
    {"depth",
     [](const PairCase& pair, double x) {
       return is_share(-exact::Truth(pair).separation() / size(pair), x, 0.02);
     }},
    {"collinear",
     [](const PairCase& pair, double x) { return is_share(least_turn(pair), x, 0.02); }},
    {"chamfer",
     [](const PairCase& pair, double x) {
       const double share = shortest_face(pair);
       return share >= 0.2 * x && share <= 3 * x;
     }},
    {"off_unit",
     [](const PairCase& pair, double x) {
       const auto off = [&](const Body& body) {
         const Vector2<double> r = body.pose.rotation.cast<double>();
         return std::abs(std::abs(r.dot(r) - 1) - x);
       };
       return off(pair.a) <= 2e-7 && off(pair.b) <= 2e-7;
     }},
    {"tie",
     [](const PairCase& pair, double x) {
       const exact::Truth truth(pair);
       const double lead = truth.separation(Side::b) - truth.separation(Side::a);
       Nearest nearest(x * kUlp);
       nearest.see(std::abs(lead));
       nearest.see(std::abs(lead - kBox2dBias));
       nearest.see(std::abs(lead + kBox2dBias));
       see_leans(placed(pair, Side::a), placed(pair, Side::b), nearest);
       see_leans(placed(pair, Side::b), placed(pair, Side::a), nearest);
       return nearest.off() <= 0.1 * kUlp;
     }},
    {"touch",
     [](const PairCase& pair, double x) {
       const double gap = exact::Truth(pair).separation() - total_radius(pair);
       return std::abs(std::abs(gap) - x * kUlp) <= 0.1 * kUlp;
     }},
    {"corner",
     [](const PairCase& pair, double x) {
       Nearest nearest(x * kUlp);
       see_ends(placed(pair, Side::a), placed(pair, Side::b), nearest);
       see_ends(placed(pair, Side::b), placed(pair, Side::a), nearest);
       return nearest.off() <= 0.2 * kUlp;
     }},
};

}  // namespace

TEST_CASE(
    "every step of every sweep of polygons draws valid pairs, and its knob does what it says") {
  check_sweeps(false, kKnobs, 100);
}

TEST_CASE("sweeps have 20 steps or more, each once, from benign to absurd") {
  std::set<std::string_view> names;
  for (const Sweep& sweep : sweeps()) {
    CAPTURE(sweep.name);
    CHECK(names.insert(sweep.name).second);
    CHECK(find_by_name(sweeps(), sweep.name) == &sweep);
    CHECK(sweep.values.size() >= 20);
    const bool falls = sweep.values.front() > sweep.values.back();
    for (std::size_t i = 1; i < sweep.values.size(); ++i) {
      CHECK((sweep.values[i] < sweep.values[i - 1]) == falls);
      CHECK(sweep.values[i] != sweep.values[i - 1]);
    }
    CHECK_FALSE(sweep.description.empty());
    CHECK_FALSE(sweep.unit.empty());
  }
  CHECK(find_by_name(sweeps(), "none") == nullptr);
}

TEST_CASE("knobs are the doubles nearest to their decimals") {
  CHECK(decades({1, 2, 5}, 0, 2) == std::vector<double>{1, 2, 5, 10, 20, 50, 100});
  CHECK(decades({10, 5, 2}, 0, -2) == std::vector<double>{1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01});
  CHECK(find_by_name(sweeps(), "small")->values.back() == 1e-18);
  CHECK(find_by_name(sweeps(), "large")->values.back() == 1e18);
  CHECK(find_by_name(sweeps(), "depth")->values.back() == 1e-9);
  CHECK(powers_of_two_to_zero(2) == std::vector<double>{4, 2, 1, 0});
}

TEST_CASE("a case depends on the seed, the sweep's name, its knob and its index") {
  const Sweep& sweep = *find_by_name(sweeps(), "distance");
  const PairCase pair = draw_case(1, sweep, 100, 7);
  CHECK(draw_case(1, sweep, 100, 7) == pair);
  CHECK_FALSE(draw_case(2, sweep, 100, 7) == pair);
  CHECK_FALSE(draw_case(1, sweep, 100, 8) == pair);
  CHECK_FALSE(draw_case(1, sweep, 200, 7) == pair);
  Sweep renamed = sweep;
  renamed.name = "another";
  CHECK_FALSE(draw_case(1, renamed, 100, 7) == pair);
}

}  // namespace manifuzz
