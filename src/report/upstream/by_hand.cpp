#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "report/upstream/parts.hpp"

namespace manifuzz {
namespace {

/// Shapes in the world, and what is nearest of them.
class Drawn {
 public:
  explicit Drawn(const PairCase& pair)
      : pair_(pair), truth_(pair), curve_(truth_, exact::skin_of(truth_)) {
    placed_ = exact::place_roughly(pair);
  }

  std::string words() const {
    const auto nearest = curve_.nearest_vertices();
    return curve_.are_cores_apart() && nearest ? between(*nearest) : behind(curve_.face());
  }

 private:
  std::string at(Side side, int vertex) const {
    const Vector2<double> place =
        placed_[side].vertices[vertex] + pair_.a.pose.position.cast<double>();
    // Floats have seven digits, places in the world may need more.
    const bool is_far = std::max(std::abs(place.x()), std::abs(place.y())) >= 1e4;
    return fmt::format("({:.{}g}, {:.{}g})", place.x() + 0.0, is_far ? 10 : 7, place.y() + 0.0,
                       is_far ? 10 : 7);
  }

  static char name(Side side) { return side == Side::a ? 'A' : 'B'; }

  std::string corner(Side side, int vertex) const {
    const int count = pair_[side].polygon.count;
    const std::string_view what = count == 1 ? "centre" : count == 2 ? "end" : "vertex";
    return fmt::format("{}'s {} {}", name(side), what, at(side, vertex));
  }

  /// What the radii, if any, make of a distance.
  std::string with_radii(double distance) const {
    const double radius = total_radius(pair_);
    const double gap = distance - radius;
    const std::string result = gap > 0    ? "so they are " + short_figure(gap) + " apart"
                               : gap == 0 ? "so they just touch"
                                          : "so they overlap by " + short_figure(-gap);
    if (radius == 0) return result;
    return fmt::format("the radii sum to {}, {}", short_figure(radius), result);
  }

  std::string between(const std::array<int, 2>& nearest) const {
    const double distance = exact::separation_of(truth_);
    return fmt::format("{} and {} are nearest, at distance {}; {}.", corner(Side::a, nearest[0]),
                       corner(Side::b, nearest[1]), short_figure(distance), with_radii(distance));
  }

  std::string behind(exact::FaceOf face) const {
    const exact::RoughPolygon& on = placed_[face.side];
    const Side opposing = other(face.side);
    const int vertex = truth_.support(face);
    const double separation = truth_.separation(face);
    const Vector2<double>& out = on.normals[face.index];
    return fmt::format(
        "the face of {} from {} to {} has the outward normal ({:.7g}, {:.7g}), and {}, the "
        "farthest back along it, is {} it; {}{}.",
        name(face.side), at(face.side, face.index), at(face.side, on.next(face.index)),
        out.x() + 0.0, out.y() + 0.0, corner(opposing, vertex),
        separation == 0
            ? "on"
            : short_figure(std::abs(separation)) + (separation > 0 ? " in front of" : " behind"),
        with_radii(separation), separation > 0 ? "" : ": no face of either has less");
  }

  const PairCase& pair_;
  exact::Truth truth_;
  exact::PenetrationCurve curve_;
  exact::RoughPair placed_{};
};

}  // namespace

std::string checked_by_hand(const PairCase& pair) {
  return Drawn(pair).words();
}

}  // namespace manifuzz
