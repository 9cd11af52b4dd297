#include <algorithm>
#include <array>

#include "engines/engine.hpp"
#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/cute_c2/manifold.hpp"

// cute_c2: its operations are repeated in its own scalar and order, and give the answer; with the
// named fault mended they give a right one.

namespace manifuzz {
namespace {

using as_cute::FaultOfCute;
using replayed::has;

constexpr unsigned kFaultsOfCute = 255;

/// As cute/adapter.rs declares it.
Declaration as_declared_by_cute(unsigned mended) {
  constexpr double kRelative = 0.95F;  // kRelTol
  constexpr double kAbsolute = 0.01F;  // kAbsTol
  Declaration declaration;
  declaration.frame = RoundingFrame::world;
  declaration.tie_bias = {kAbsolute / kRelative, 1 - 1 / kRelative, Side::b};
  declaration.min_vertices = 1;
  if (has(mended, FaultOfCute::one_point)) declaration.second_point = SecondPoint::never();
  return declaration;
}

/// The engine's operations on a case, once more.
class ByCute {
 public:
  explicit ByCute(const Deviation& deviation)
      : deviation_(deviation), given_(as_cute::by_cute(deviation.right.pair(), 0)) {}

  const as_cute::CuteAnswer& given() const { return given_; }
  bool is_same_answer() const { return replayed::is_same_answer(deviation_, given_.contact); }
  /// Whether polygons' answer is right with the face's own normal in place of the one that it
  /// clipped along.
  bool is_right_with_own_normal() const {
    if (given_.own_normal.isZero(0)) return false;
    const replayed::Contact contact{given_.own_normal, given_.contact.points};
    return is_same_answer() &&
           replayed::is_right_answer(deviation_, as_declared_by_cute(0), contact);
  }
  bool needs(FaultOfCute fault) const {
    return is_same_answer() &&
           replayed::is_needed(static_cast<unsigned>(fault), kFaultsOfCute,
                               [&](unsigned mended) { return is_right(mended); });
  }

 private:
  bool is_right(unsigned mended) const {
    const bool is_inside = has(mended, FaultOfCute::inside) && is_rounded_distance();
    constexpr auto inside = static_cast<unsigned>(FaultOfCute::inside);
    as_cute::CuteAnswer answer =
        as_cute::by_cute(deviation_.right.pair(), is_inside ? mended : mended & ~inside);
    const bool is_nearest = has(mended, FaultOfCute::nearest_places);
    if (is_nearest && answer.way != as_cute::Way::nearest) return false;
    if (has(mended, FaultOfCute::inside) && !(is_inside && has_polygon())) {
      return !is_nearest && is_right_inside(mended, answer);
    }
    if (is_nearest) {
      mend(answer.contact);
      answer.contact.points[0].at = answer.on_core + answer.out * answer.contact.normal;
    }
    return replayed::is_right_answer(deviation_, as_declared_by_cute(mended), answer.contact) ||
           (is_nearest && is_right_at_end(mended, answer.contact));
  }

  /// The least depth, and its normal.
  void mend(replayed::Contact& contact) const {
    contact.normal = replayed::least_normal_near(deviation_, contact.normal);
    contact.points[0].depth = ledger_of::least_depth(deviation_);
  }

  bool has_polygon() const {
    const PairCase& pair = deviation_.right.pair();
    return std::max(pair.a.polygon.count, pair.b.polygon.count) > 2;
  }

  /// Whether cores overlap, and the roundings of c2GJK's places make a distance that is not below
  /// the radii: no contact.
  bool is_rounded_distance() const {
    return given_.way == as_cute::Way::apart &&
           ledger_of::least_depth(deviation_) >= total_radius(deviation_.right.pair()) &&
           static_cast<double>(given_.distance) <= deviation_.right.bounds.separation;
  }

  /// Whether capsules' answer at no distance is right, any of the cores' ends moved to its surface.
  bool is_right_inside(unsigned mended, const as_cute::CuteAnswer& answer) const {
    const bool is_at_none = answer.distance == 0 || is_rounded_distance();
    if (!is_at_none || answer.way == as_cute::Way::face || has_polygon()) return false;
    replayed::Contact contact{answer.contact.normal, {{}}};
    mend(contact);
    return is_right_at_end(mended, contact);
  }

  /// With its point on the surface beyond some vertex of a core, or the place on it that is nearest
  /// to a vertex of the other.
  bool is_right_at_end(unsigned mended, replayed::Contact contact) const {
    const PairCase& pair = deviation_.right.pair();
    return std::ranges::any_of(std::array{Side::a, Side::b}, [&](Side side) {
      const double out =
          (side == Side::a ? 1 : -1) * static_cast<double>(pair[side].polygon.radius);
      return std::ranges::any_of(ledger_of::nearest_places(pair, side), [&](const auto& place) {
        contact.points[0].at = place + out * contact.normal;
        return replayed::is_right_answer(deviation_, as_declared_by_cute(mended), contact);
      });
    });
  }

  const Deviation& deviation_;
  as_cute::CuteAnswer given_;
};

/// Whether the nearest places are off by no more than their roundings, whatever those make of the
/// direction between both; or are as near as the nearest, to roundings of a distance; or corners
/// that c2GJK takes for the nearest since they are nearer than epsilon.
bool is_off_by_roundings(const Deviation& d, const as_cute::CuteAnswer& answer) {
  if (answer.way != as_cute::Way::nearest) return false;
  const Vector2<double>& normal = answer.contact.normal;
  const double bound = 4 * d.right.bounds.separation;
  const Vector2<double> off = normal - replayed::least_normal_near(d, normal);
  if (off.norm() * static_cast<double>(answer.distance) <= bound || answer.is_within_epsilon) {
    return true;
  }
  if (normal.isZero(0)) return false;
  const exact::Along along(*d.right.truth, local_normal(d.right.pair(), normal));
  return along.depth() - ledger_of::least_depth(d) <= bound;
}

/// One of these.
template <FaultOfCute kFault>
bool fault_of_cute(const Deviation& d) {
  const ByCute replayed(d);
  if (kFault == FaultOfCute::nearest_places && !is_off_by_roundings(d, replayed.given())) {
    return false;
  }
  if (kFault == FaultOfCute::placed_vertices && replayed.is_right_with_own_normal()) return true;
  return replayed.needs(kFault);
}

/// No contact of polygons: of features that tie in float one is kept that misses.
bool tied_features_in_cute(const Deviation& d) {
  return no_contact_on_tied_features(d) && ByCute(d).is_same_answer();
}

constexpr LedgerRow kCuteC2Rows[] = {
    {"placed-vertices", fault_of_cute<FaultOfCute::placed_vertices>},
    {"bias", fault_of_cute<FaultOfCute::bias>},
    {"open-planes", fault_of_cute<FaultOfCute::open_planes>},
    {"inside", fault_of_cute<FaultOfCute::inside>},
    {"nearest-places", fault_of_cute<FaultOfCute::nearest_places>},
    {"two-frames", fault_of_cute<FaultOfCute::two_frames>},
    {"on-core", fault_of_cute<FaultOfCute::on_core>},
    {"one-point", fault_of_cute<FaultOfCute::one_point>},
    {"tied-features", tied_features_in_cute},
};

}  // namespace

Engine engine_cute_c2() {
  return {.name = "cute_c2", .ledger = {{"cute_c2", kCuteC2Rows}}};
}

}  // namespace manifuzz
