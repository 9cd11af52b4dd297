#include "judging/by_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "judging/extent.hpp"
#include "judging/mitred_contact.hpp"
#include "judging/round_contact.hpp"
#include "oracle/exact/witness.hpp"

namespace manifuzz {
namespace {

using exact::Along;
using exact::Height;
using exact::PenetrationCurve;

/// An answer in the curve's terms: what it says of the pair as a whole.
struct Said {
  bool touches = false;
  std::optional<Vector2<double>> normal;
  double depth = 0;  ///< of the deepest point, or of the pair
  const Manifold<double>* manifold = nullptr;
};

int deepest_of(const Manifold<double>& manifold) {
  return manifold.count > 1 && manifold.points[1].depth > manifold.points[0].depth ? 1 : 0;
}

Said said_by(const Answer& answer) {
  if (const auto* const penetration = std::get_if<Penetration>(&answer)) {
    return {penetration->touches, penetration->normal, penetration->depth, nullptr};
  }
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr || manifold->count == 0) return {};
  return {true, manifold->normal, manifold->points[deepest_of(*manifold)].depth, manifold};
}

/// Where points lie that are claimed to lie there, as shares of A's top and B's bottom. A clip's
/// are on the incident core, of round shapes on the incident surface.
std::vector<Height> heights_of(PointsAt points, const PairCase& pair) {
  const auto radius_a = static_cast<double>(pair.a.polygon.radius);
  const auto radius_b = static_cast<double>(pair.b.polygon.radius);
  switch (points) {
    case PointsAt::midpoint:
      return {{0.5, 0.5, (radius_a - radius_b) / 2}};
    case PointsAt::surface_a:
      return {{1, 0, radius_a}};
    case PointsAt::surface_b:
      return {{0, 1, -radius_b}};
    case PointsAt::clip:
      if (is_round(pair)) return {{1, 0, radius_a}, {0, 1, -radius_b}};
      [[fallthrough]];
    default:
      return {{1, 0, 0}, {0, 1, 0}};
  }
}

class ByCurve {
 public:
  /// `tolerance`: how far it may stop short of the least depth, a world length.
  ByCurve(const exact::Truth& truth, const Declaration& declaration, const Said& said,
          const CurveBounds& bounds, double tolerance = 0)
      : truth_(truth),
        declaration_(declaration),
        said_(said),
        bounds_(bounds),
        tolerance_(tolerance),
        curve_(truth, exact::skin_of(truth)),
        nearest_(truth, curve_, bounds_.touching, bounds_.normal) {}

  bool is_reversed() const {
    if (!said_.normal || said_.normal->isZero(0)) return false;
    const Along back(truth_, -*said_.normal);
    return is_minimal(back) && is_depth(back, said_.depth);
  }

  CurveJudgement judge() {
    if (!touches_as_it_should() || !said_.normal) return result_;
    const double off_unit = std::abs(said_.normal->norm() - 1);
    if (!(off_unit <= bounds_.normal)) return found(Kind::normal, off_unit, bounds_.normal);
    const Along along(truth_, *said_.normal);
    result_.excess = curve_.excess(along);
    result_.consistent = is_depth(along, said_.depth);
    // Across a gap any normal will do.
    if (said_.touches && said_.depth >= 0) result_.minimal = is_minimal(along);
    const bool is_right = *result_.consistent && result_.minimal.value_or(true);
    if (!is_right && is_reversed()) return found(Kind::reversed, 2, bounds_.normal);
    if (*result_.consistent && !is_right && is_least(curve_, along)) {
      return found(Kind::normal, nearest_.error(*said_.normal), nearest_.bound());
    }
    if (!*result_.consistent)
      return found(Kind::inconsistent, depth_error(along), bounds_.consistency);
    if (!result_.minimal.value_or(true))
      return found(Kind::not_minimal, std::abs(*result_.excess), bounds_.minimality);
    if (said_.manifold == nullptr) return result_;
    result_.witness = has_witnesses(along);
    if (!*result_.witness) return found(Kind::witness, witness_error(along), bounds_.along);
    if (declaration_.claims != Claims::manifold) return result_;
    const Bounds of_clip = bounds(truth_.pair(), declaration_, truth_.extent());
    const auto second =
        is_round_ ? second_point_mismatch(truth_, declaration_, of_clip, *said_.manifold)
                  : extent_mismatch(truth_, declaration_, of_clip, tolerance_, *said_.manifold);
    return second ? found(second->kind, second->magnitude, second->bound) : result_;
  }

 private:
  CurveJudgement found(Kind kind, double magnitude, double bound) {
    result_.kind = kind;
    result_.magnitude = magnitude;
    result_.bound = bound;
    return result_;
  }

  bool touches_as_it_should() {
    const bool must = curve_.compare_least(bounds_.touching + declaration_.least_depth) > 0;
    const bool may = curve_.compare_least(-bounds_.touching - declaration_.speculative) >= 0;
    if (said_.touches ? may : !must || may_be_missed()) return true;
    found(said_.touches ? Kind::phantom_contact : Kind::missed_contact, std::abs(curve_.least()),
          bounds_.touching);
    return false;
  }

  /// Whether no contact is right though skins touch, since there is no place for a point.
  bool may_be_missed() const {
    return declaration_.claims <= Claims::point && !is_round_ &&
           may_touch_beyond_skins(truth_, curve_, bounds_.minimality, bounds_.along);
  }

  /// The overlap that a depth stands for: of a pair the depth along the normal, of points the
  /// deepest on any line along it.
  bool is_gap_claimed(const Along& along) const {
    return !is_round_ && said_.manifold != nullptr && along.meets(slide());
  }
  /// How far two places that a point names may pass each other.
  double slide() const { return 2 * (bounds_.along + tolerance_); }
  double depth_error(const Along& along) const {
    if (nearest_.decides()) return std::abs(said_.depth - curve_.least());
    return std::abs(said_.depth -
                    (is_gap_claimed(along) && along.meets() ? along.gap() : along.depth()));
  }
  bool is_depth(const Along& along, double depth) const {
    // No tolerance excuses a depth that is too large.
    const double least = depth - bounds_.consistency;
    const double most = depth + bounds_.consistency + tolerance_;
    if (is_distance(depth)) return true;
    if (nearest_.decides()) return false;
    if (is_gap_claimed(along)) {
      const bool is_gap =
          along.compare_gap(least, slide()) >= 0 && along.compare_least_gap(most, slide()) <= 0;
      if (is_gap || total_radius(truth_.pair()) == 0) return is_gap;  // skins reach past cores
    }
    return along.compare_depth(least) >= 0 && along.compare_depth(most) <= 0;
  }

  /// Mitred pairs have depths at faces' normals alone: less than the least is no face's either.
  bool is_least(const PenetrationCurve& curve, const Along& along) const {
    return curve.compare_excess(along, bounds_.minimality + tolerance_) <= 0 &&
           curve.compare_excess(along, -bounds_.minimality) >= 0;
  }
  /// Of cores that do not overlap by more than rounding, D*, whatever the normal.
  bool is_distance(double depth) const {
    return may_be_apart() && curve_.compare_least(depth - bounds_.touching) >= 0 &&
           curve_.compare_least(depth + bounds_.touching + tolerance_) <= 0;
  }

  bool may_be_apart() const {
    return is_round_ && (!truth_.has_faces() || truth_.compare_separation(-bounds_.touching) >= 0);
  }

  bool is_minimal(const Along& along) const {
    if (nearest_.may_be_near() && nearest_.error(along.local_normal()) <= nearest_.bound())
      return true;
    if (nearest_.must_be_near()) return false;
    if (is_least(curve_, along)) return true;
    // A bias lets a side's best face stand though one of the other's has less depth.
    const TieBias& bias = declaration_.tie_bias;
    if (bias.is_none() || !truth_.has_faces(Side::a) || !truth_.has_faces(Side::b)) return false;
    return std::ranges::any_of(std::array{Side::a, Side::b}, [&](Side side) {
      return may_be_reference(truth_, bias, side, bounds_.touching) &&
             is_least(PenetrationCurve(truth_, truth_.greatest(side)), along);
    });
  }

  /// How far a place may be from a point's line: with radii, clips reach past cores by as much.
  double reach() const {
    return bounds_.along + tolerance_ + (is_round_ ? 0 : total_radius(truth_.pair()));
  }
  /// How far a point is from where both are, at least, or a depth from the deepest overlap.
  double witness_error(const Along& along) const {
    const exact::RoughPair placed = exact::place_roughly(truth_.stored());
    const Vector2<double> turn = truth_.pair().a.pose.rotation.cast<double>();
    double most = depth_error(along);
    for (int i = 0; i < said_.manifold->count; ++i) {
      const Vector2<double> at = rotate<double>(turn, said_.manifold->points[i].position);
      for (const Side side : {Side::a, Side::b}) {
        const exact::RoughPolygon& polygon = placed[side];
        for (int k = 0; k < polygon.count; ++k) {
          most = std::max(
              most, polygon.normals[k].dot(at - polygon.vertices[k]) - total_radius(truth_.pair()));
        }
      }
    }
    return most;
  }

  bool is_where_claimed(const ContactPoint<double>& point) const {
    return declaration_.points != PointsAt::vertex ||
           exact::is_at_vertex(truth_, point.position,
                               bounds_.across + tolerance_ + total_radius(truth_.pair()));
  }

  bool has_witnesses(const Along& along) const {
    const auto heights = heights_of(declaration_.points, truth_.pair());
    const Manifold<double>& manifold = *said_.manifold;
    const int deepest = deepest_of(manifold);
    bool is_deepest_found = false;
    for (int i = 0; i < manifold.count; ++i) {
      const ContactPoint<double>& point = manifold.points[i];
      exact::PointClaim claim{.position = point.position,
                              .heights = heights,
                              .gap_least = point.depth,
                              .gap_most = point.depth,
                              .along = reach(),
                              .across = bounds_.across + tolerance_,
                              .slack = bounds_.consistency + tolerance_};
      exact::PointClaim as_deepest = claim;
      // Two rounded depths say which is the deepest; of nearest places their distance has said it.
      if (!nearest_.decides()) as_deepest.shortfall = bounds_.minimality + tolerance_;
      if (declaration_.shares_depth) {
        is_deepest_found = is_deepest_found || is_witness(truth_, along, as_deepest);
        claim.gap_least = std::min(point.depth, -declaration_.speculative);
      } else if (i == deepest) {
        claim = as_deepest;
        is_deepest_found = true;
      }
      if (!is_witness(truth_, along, claim) || !is_where_claimed(point)) return false;
    }
    return is_deepest_found;
  }

  const exact::Truth& truth_;
  const Declaration& declaration_;
  const Said& said_;
  CurveBounds bounds_;
  double tolerance_;
  PenetrationCurve curve_;
  NearestNormal nearest_;
  bool is_round_ = is_round(truth_.pair());
  CurveJudgement result_;
};

}  // namespace

double tolerance_of(const exact::Truth& truth, const Declaration& declaration) {
  const Tolerance& tolerance = declaration.tolerance;
  if (tolerance.is_none()) return 0;
  const double least = PenetrationCurve(truth, exact::skin_of(truth)).least();
  return tolerance.absolute + tolerance.relative * std::abs(least);
}

CurveBounds curve_bounds(const PairCase& pair, const Declaration& declaration, double extent) {
  const Bounds of_clip = bounds(pair, declaration, extent);
  const double turned = of_clip.normal * (extent + total_radius(pair));
  return {.consistency = of_clip.separation + turned,
          .minimality = 2 * of_clip.separation + turned,
          .along = of_clip.position + of_clip.separation,
          .across = of_clip.position,
          .touching = of_clip.separation,
          .normal = of_clip.normal};
}

CurveJudgement judge_by_curve(const exact::Truth& truth, const Declaration& declaration,
                              const Answer& answer, const CurveBounds& bounds) {
  const Said said = said_by(answer);
  const CurveJudgement strictly = ByCurve(truth, declaration, said, bounds).judge();
  const double tolerance = tolerance_of(truth, declaration);
  if (strictly.kind == Kind::none || tolerance == 0) return strictly;
  CurveJudgement judgement = ByCurve(truth, declaration, said, bounds, tolerance).judge();
  judgement.is_by_tolerance = judgement.kind == Kind::none;
  return judgement;
}

std::optional<AlongNormal> said_along(const Answer& answer) {
  const Said said = said_by(answer);
  return said.normal ? std::optional(AlongNormal{*said.normal, said.depth}) : std::nullopt;
}

bool touches(const Answer& answer) {
  return said_by(answer).touches;
}

bool is_reversed(const exact::Truth& truth, const ColliderAnswer& given) {
  const Said said = said_by(given.answer);
  const CurveBounds bounds = curve_bounds(truth.pair(), given.declaration, truth.extent());
  return said.touches && ByCurve(truth, given.declaration, said, bounds).is_reversed();
}

}  // namespace manifuzz
