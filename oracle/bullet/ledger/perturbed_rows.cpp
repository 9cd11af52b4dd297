#include <array>
#include <cmath>
#include <utility>

#include "judging/by_curve.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/perturbed.hpp"
#include "oracle/bullet/ledger/rows.hpp"

// btConvexConvexAlgorithm with turned shapes is repeated in its own floats: the answer is what the
// repeated one gives, and without the named part of it, and none less, it would be right.

namespace manifuzz {
namespace {

using ledger_of::PerturbedParts;

/// The parts of it that may be left out.
enum PerturbedFault : unsigned { kTurnedQueries = 1, kReplacedPoint = 2, kRefreshedPoints = 4 };

/// What oracle/bullet/perturbed.cpp declares.
Declaration declaration_of_perturbed() {
  Declaration declaration = ledger_of::declaration_of_epa();
  declaration.claims = Claims::manifold;
  declaration.one_point_enough = true;
  return declaration;
}

ledger_of::PerturbedAnswer repeat_without(const Deviation& d, unsigned faults) {
  return ledger_of::ask_perturbed(ledger_of::prisms_of(d.right.pair()),
                                  PerturbedParts{.has_turned = (faults & kTurnedQueries) == 0,
                                                 .is_refreshed = (faults & kRefreshedPoints) == 0,
                                                 .does_replace = (faults & kReplacedPoint) == 0});
}

bool is_repeated_with_turns(const Deviation& d) {
  return replayed::is_same_answer(d, ledger_of::seen_in_plane(repeat_without(d, 0).points));
}

/// Whether the answer is the repeated one, and would be right without this part.
bool is_by_part(const Deviation& d, PerturbedFault fault) {
  constexpr unsigned all = kTurnedQueries | kReplacedPoint | kRefreshedPoints;
  if (!is_repeated_with_turns(d)) return false;
  const Declaration declaration = declaration_of_perturbed();
  return replayed::is_needed(fault, all, [&](unsigned mended) {
    const auto right = repeat_without(d, mended);
    return replayed::is_right_answer(d, declaration, ledger_of::seen_in_plane(right.points));
  });
}

/// Which query found the deepest point.
int query_of_deepest(const Deviation& d) {
  const auto answer = repeat_without(d, 0);
  const ledger_of::BulletPoint* const deepest = ledger_of::deepest_of(answer.points);
  return deepest == nullptr ? 0 : deepest->query;
}

/// Whether a query's axis is that of cores that touch or have corners near to each other, of a flat
/// simplex, or of a closest point that roundings keep from the origin: a corner beyond it, which
/// the simplex has already or is given, leaves the distance as it was.
bool is_axis_faulty(const ledger_of::QueryLoop& loop) {
  using ledger_of::QueryEnd;
  return loop.end == QueryEnd::at_origin || loop.end == QueryEnd::degenerate ||
         loop.end == QueryEnd::no_less || loop.is_by_threshold || loop.is_closest_rounded;
}

/// Whether the first query's normal came about by what is wrong with bullet-epa: a faulty axis, a
/// second GJK, or an EPA that ended otherwise than within its accuracy.
bool is_first_normal_faulty(const ledger_of::PerturbedAnswer& answer) {
  const ledger_of::BulletAnswer& first = answer.first;
  if (first.normal_of == ledger_of::NormalOf::query || first.is_axis_deeper) {
    return is_axis_faulty(first.loop);
  }
  return first.normal_of == ledger_of::NormalOf::solver_apart ||
         answer.epa.end != ledger_of::BulletEpaEnd::accuracy_reached;
}

/// A turned query's point took the place of a right one nearby.
bool point_replaced_by_turned(const Deviation& d) {
  return is_by_part(d, kReplacedPoint);
}

/// refreshContactPoints moved, measured or left out a point.
bool changed_by_refresh(const Deviation& d) {
  return is_by_part(d, kRefreshedPoints);
}

/// The deepest point is a turned query's: its normal, and what was measured along it.
bool normal_of_turned_query(const Deviation& d) {
  return query_of_deepest(d) > 0 && is_by_part(d, kTurnedQueries);
}

/// The deepest is the first query's, and the other a turned query's.
bool point_of_turned_query(const Deviation& d) {
  return query_of_deepest(d) == 0 && is_by_part(d, kTurnedQueries);
}

/// The first query's normal is upright, by a fault of that query's that the entries on bullet-epa
/// name, and so the shapes are turned out of the plane.
bool turned_out_of_plane(const Deviation& d) {
  const auto answer = repeat_without(d, 0);
  const ledger_of::Space& normal = answer.first.normal;
  return std::abs(normal.z()) > std::hypot(normal.x(), normal.y()) &&
         is_first_normal_faulty(answer) &&
         replayed::is_same_answer(d, ledger_of::seen_in_plane(answer.points));
}

/// The first query's answer, without turned ones, is wrong too, by what a row of bullet-epa looks
/// for.
template <std::size_t kRow>
bool of_first_query(const Deviation& d) {
  if (!is_repeated_with_turns(d)) return false;
  const auto alone = repeat_without(d, kTurnedQueries | kRefreshedPoints);
  const Manifold<double> first =
      replayed::in_frame_of_a(d.right.pair(), ledger_of::seen_in_plane(alone.points));
  PartialManifold answer;
  answer.manifold = first;
  const Kind kind = judge_by_curve(*d.right.truth, declaration_of_perturbed(), answer).kind;
  return kind != Kind::none && bullet_epa_rows()[kRow].explains({d.right, first, kind});
}

/// All rows, those of bullet-epa in this order.
template <std::size_t... kRow>
auto rows_with_first_query(std::index_sequence<kRow...> /*order*/) {
  return std::array{LedgerRow{"replaced", point_replaced_by_turned},
                    LedgerRow{"refreshed", changed_by_refresh},
                    LedgerRow{"turned-normal", normal_of_turned_query},
                    LedgerRow{"turned-point", point_of_turned_query},
                    LedgerRow{bullet_epa_rows()[kRow].cause, of_first_query<kRow>}...,
                    LedgerRow{"out-of-plane", turned_out_of_plane}};
}

}  // namespace

LedgerRows bullet_perturbed_ledger() {
  // axis-of-roundings is looked for before gjk-apart.
  static const std::array rows = rows_with_first_query(
      std::index_sequence<0, 1, 2, 3, 4, 5, 6, 12, 7, 8, 9, 10, 11, 13, 14, 15, 16>());
  return {"bullet-perturbed", rows};
}

}  // namespace manifuzz
