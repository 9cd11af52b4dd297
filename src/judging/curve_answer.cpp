#include "judging/curve_answer.hpp"

#include <algorithm>
#include <array>

#include "judging/turned_faces.hpp"

namespace manifuzz {

using exact::Along;
using exact::Height;
using exact::PenetrationCurve;

Said said_by(const Answer& answer) {
  if (const auto* const penetration = std::get_if<Penetration>(&answer)) {
    return {penetration->touches, penetration->normal, penetration->depth, nullptr};
  }
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr || manifold->count == 0) return {};
  return {true, manifold->normal, manifold->points[deepest_of(*manifold)].depth, manifold};
}

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

CurveBounds with_turned_faces(const exact::Truth& truth, const Said& said,
                              const CurveBounds& bounds) {
  if (bounds.world_vertex == 0 || !truth.has_faces()) return bounds;
  const Bounds of_faces{.separation = bounds.touching, .world_vertex = bounds.world_vertex};
  const TurnedFaces faces(truth, of_faces);
  const exact::RoughPair placed = exact::place_roughly(truth.stored());
  const Vector2<double> normal = rotate<double>(truth.pair().a.pose.rotation.cast<double>(),
                                                said.normal.value_or(Vector2<double>(0, 0)));
  double turn = 0;
  double off = 0;
  for (const exact::FaceOf face : exact::all_faces(truth.stored())) {
    const double sign = face.side == Side::a ? 1 : -1;
    const double of_face = face_turn(of_faces, truth.stored(), face);
    const Vector2<double> apart = normal - sign * placed[face.side].normals[face.index];
    if (apart.norm() > bounds.normal + of_face) continue;
    turn = std::max(turn, of_face);
    off = std::max(off, faces.off(face));
  }
  const double greatest = truth.separation();
  const double preferred = greatest - faces.lowest();  // a face that looks worse than it is
  CurveBounds result = bounds;
  result.direction += turn;
  result.consistency += off;
  result.minimality += off + preferred;
  result.along += off;
  result.across += off;
  result.touching += std::max(faces.highest() - greatest, preferred);
  return result;
}

bool CurveAnswer::touches_as_it_should() const {
  const bool must = curve_.compare_least(bounds_.touching + declaration_.least_depth) > 0;
  const bool may = curve_.compare_least(-bounds_.touching - declaration_.speculative) >= 0;
  return said_.touches ? may : !must || may_be_missed();
}

namespace {

/// Whether mitred skins that touch may do so where no contact point can be: along the normal of a
/// face that has the least depth, to within `minimality`, the deepest places are farther apart
/// along the tangent than both skins reach, less `along` each; world lengths. bounds.md, "Corners
/// of mitred skins".
bool may_touch_beyond_skins(const exact::Truth& truth, const exact::PenetrationCurve& curve,
                            double minimality, double along) {
  if (truth.compare_separation(0) <= 0) return false;
  const double slide = 2 * std::max(total_radius(truth.pair()) - along, 0.0);
  return std::ranges::any_of(curve.minima(minimality), [&](const Vector2<double>& normal) {
    return exact::Along(truth, normal).compare_gap(curve.least() - minimality, slide) < 0;
  });
}

}  // namespace

/// Whether no contact is right though skins touch, since there is no place for a point.
bool CurveAnswer::may_be_missed() const {
  return declaration_.claims <= Claims::point && !is_round_ &&
         may_touch_beyond_skins(truth_, curve_, bounds_.minimality, bounds_.along);
}

bool CurveAnswer::is_reversed() const {
  if (!said_.normal || said_.normal->isZero(0)) return false;
  const Along back(truth_, -*said_.normal);
  return is_minimal(back) && is_depth(back, said_.depth);
}

/// Whether the overlap that a depth stands for is that along the normal, or, of points, the deepest
/// on any line along it.
bool CurveAnswer::is_gap_claimed(const Along& along) const {
  return !is_round_ && said_.manifold != nullptr && along.meets(slide());
}

double CurveAnswer::depth_error(const Along& along) const {
  if (nearest_.decides()) return std::abs(said_.depth - curve_.least());
  return std::abs(said_.depth -
                  (is_gap_claimed(along) && along.meets() ? along.gap() : along.depth()));
}

bool CurveAnswer::is_depth(const Along& along, double depth) const {
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
bool CurveAnswer::is_least(const PenetrationCurve& curve, const Along& along) const {
  return curve.compare_excess(along, bounds_.minimality + tolerance_) <= 0 &&
         curve.compare_excess(along, -bounds_.minimality) >= 0;
}

/// Whether G hardly depends on where rounding puts B along the tangent: where corners pass each
/// other it jumps, and a depth may be any of the G between, at no share of a bound.
bool CurveAnswer::is_gap_steady(const Along& along) const {
  const double little = bounds_.consistency / 16;
  return along.meets() && along.compare_gap(along.gap() + little, slide()) <= 0 &&
         along.compare_least_gap(along.gap() - little, slide()) >= 0;
}

double CurveAnswer::depth_share(const Along& along) const {
  const auto share = [&](double of, double bound) { return std::abs(said_.depth - of) / bound; };
  const double of_least = share(curve_.least(), bounds_.touching);
  if (nearest_.decides()) return of_least;
  double least = share(along.depth(), bounds_.consistency);
  if (is_gap_claimed(along)) {
    if (!is_gap_steady(along)) return 0;
    const double of_gap = depth_error(along) / bounds_.consistency;
    least = total_radius(truth_.pair()) == 0 ? of_gap : std::min(least, of_gap);
  }
  return may_be_apart() ? std::min(least, of_least) : least;
}

double CurveAnswer::normal_share(const Along& along) const {
  const double of_excess = std::abs(along.depth() - curve_.least()) / bounds_.minimality;
  if (!nearest_.may_be_near()) return of_excess;
  const double of_error = nearest_.error(along.local_normal()) / nearest_.bound();
  return nearest_.must_be_near() ? of_error : std::min(of_error, of_excess);
}

/// Where cores do not overlap by more than rounding, D* is right whatever the normal.
bool CurveAnswer::is_distance(double depth) const {
  return may_be_apart() && curve_.compare_least(depth - bounds_.touching) >= 0 &&
         curve_.compare_least(depth + bounds_.touching + tolerance_) <= 0;
}

bool CurveAnswer::may_be_apart() const {
  return is_round_ && (!truth_.has_faces() || truth_.compare_separation(-bounds_.touching) >= 0);
}

bool CurveAnswer::is_minimal(const Along& along) const {
  if (nearest_.may_be_near() && nearest_.is_near(along.local_normal())) return true;
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
double CurveAnswer::reach() const {
  return bounds_.along + tolerance_ + (is_round_ ? 0 : total_radius(truth_.pair()));
}

bool CurveAnswer::is_where_claimed(const ContactPoint<double>& point) const {
  return declaration_.points != PointsAt::vertex ||
         exact::is_at_vertex(truth_, point.position,
                             bounds_.across + tolerance_ + total_radius(truth_.pair()));
}

bool CurveAnswer::has_witnesses(const Along& along) const {
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
                            .slack = bounds_.consistency + tolerance_,
                            .narrow = bounds_.narrow};
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

}  // namespace manifuzz
