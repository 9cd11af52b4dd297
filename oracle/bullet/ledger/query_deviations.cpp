#include "oracle/bullet/ledger/query_deviations.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/curve.hpp"
#include "judging/faults/differences.hpp"
#include "judging/faults/replayed.hpp"
#include "oracle/bullet/ledger/deviations.hpp"
#include "oracle/bullet/ledger/repeated_query.hpp"

namespace manifuzz {
namespace {

using ledger_of::BulletAnswer;
using ledger_of::BulletEpaEnd;
using ledger_of::is_answered;
using ledger_of::is_repeated;
using ledger_of::NormalOf;
using ledger_of::QueryEnd;
using ledger_of::RepeatedQuery;

/// Where no corner is nearer along the axis p than p, but for the share e of its square, p is from
/// the nearest place q by |p - q|^2 <= |p|^2 - p . q <= e |p|^2.
bool is_within_relative_error(const Deviation& d) {
  constexpr double share = 1e-6;  // REL_ERROR2
  const Vector2<double> normal = world_normal(d.right.pair(), d.got.normal);
  const Vector2<double> least = replayed::least_normal_near(d, normal);
  return (normal - least).norm() <= std::sqrt(share) + d.right.bounds.normal;
}

/// Whether the face is inside of the difference, and nothing is farther along its normal than it is
/// by more than EPA_ACCURACY, so that they are no deeper along it than that beyond the least depth.
bool is_chord_within_accuracy(const Deviation& d, const RepeatedQuery& query) {
  constexpr double accuracy = 1e-4;
  const double bound = d.right.bounds.separation;
  const double least = ledger_of::least_depth(d);
  const double deep = exact::Along(*d.right.truth, d.got.normal).depth();
  return static_cast<double>(query.epa.depth) <= least + bound && deep <= least + accuracy + bound;
}

bool is_of_own_axis(const RepeatedQuery& query) {
  return query.answer.is_axis_deeper || query.answer.normal_of == NormalOf::query;
}

bool is_of_epa(const RepeatedQuery& query, BulletEpaEnd end) {
  return query.answer.normal_of == NormalOf::solver && !query.answer.is_axis_deeper &&
         query.epa.end == end;
}

/// The answer with the normal and the depth of the face that EPA ended at.
replayed::Contact contact_of_face(const Deviation& d, const RepeatedQuery& query) {
  const Vector2<double> outwards(static_cast<double>(query.epa.normal.x()),
                                 static_cast<double>(query.epa.normal.y()));
  const Vector2<double> turn = d.right.pair().a.pose.rotation.cast<double>();
  const ledger_of::Space& on_b = query.answer.on_b;
  return {rotate<double>(turn, outwards).normalized(),
          {{Vector2<float>(on_b.x(), on_b.y()).cast<double>(),
            static_cast<double>(query.epa.depth) * outwards.norm()}}};
}

}  // namespace

bool is_of_solver(const Deviation& d, BulletAsked asked) {
  return is_repeated(d, asked, [](const RepeatedQuery& query) {
    return query.answer.normal_of == NormalOf::solver && !query.answer.is_axis_deeper;
  });
}

bool is_of_query(const Deviation& d, BulletAsked asked) {
  return is_repeated(d, asked, [](const RepeatedQuery&) { return true; });
}

template <BulletAsked asked>
bool axis_of_touching_cores(const Deviation& d) {
  return is_repeated(d, asked, [](const RepeatedQuery& query) {
    return is_of_own_axis(query) && query.answer.loop.end == QueryEnd::at_origin;
  });
}

template <BulletAsked asked>
bool stopped_at_near_corner(const Deviation& d) {
  return is_repeated(d, asked,
                     [](const RepeatedQuery& query) { return query.deciding().is_by_threshold; });
}

template <BulletAsked asked>
bool stopped_at_rounded_point(const Deviation& d) {
  return is_repeated(
      d, asked, [](const RepeatedQuery& query) { return query.deciding().is_closest_rounded; });
}

template <BulletAsked asked>
bool stopped_by_relative_error(const Deviation& d) {
  return is_repeated(d, asked, [&](const RepeatedQuery& query) {
    const QueryEnd end = query.deciding().end;
    const bool is_of_rounded_corner =
        query.answer.normal_of == NormalOf::query &&
        is_nearest_corner_rounded(d.right.pair(), asked, query.answer.loop);
    if (end == QueryEnd::no_closer || is_of_rounded_corner) {
      return d.kind == Kind::normal && is_within_relative_error(d);
    }
    return end == QueryEnd::little_closer || end == QueryEnd::no_less;
  });
}

template <BulletAsked asked>
bool stopped_at_flat_simplex(const Deviation& d) {
  return is_repeated(d, asked, [](const RepeatedQuery& query) {
    return query.deciding().end == QueryEnd::degenerate;
  });
}

template <BulletAsked asked>
bool point_of_displaced_query(const Deviation& d) {
  if (!ledger_of::is_of_points(d.kind)) return false;
  return is_repeated(d, asked, [](const RepeatedQuery& query) {
    constexpr float roundings = 4 * std::numeric_limits<float>::epsilon();
    const ledger_of::Space beside = query.directions.beside.normal;
    return query.answer.normal_of == NormalOf::solver && !query.answer.is_axis_deeper &&
           (beside - query.directions.direction.normalized()).norm() > roundings;
  });
}

template <BulletAsked asked>
bool distance_of_displaced_query(const Deviation& d) {
  return is_repeated(d, asked, [](const RepeatedQuery& query) {
    return query.answer.normal_of == NormalOf::solver && !query.answer.is_axis_deeper;
  });
}

template <BulletAsked asked>
bool axis_taken_back(const Deviation& d) {
  return is_repeated(d, asked,
                     [](const RepeatedQuery& query) { return query.answer.is_axis_deeper; });
}

template <BulletAsked asked>
bool axis_turned_by_roundings(const Deviation& d) {
  if (d.got.count == 0) return false;
  return is_repeated(d, asked, [&](const RepeatedQuery& query) {
    if (!is_of_own_axis(query)) return false;
    const double roundings = 4 * d.right.bounds.separation;
    const auto length = static_cast<double>(query.answer.loop.axis.norm());
    const exact::PenetrationCurve curve(*d.right.truth, exact::skin_of(*d.right.truth));
    return std::ranges::any_of(curve.minima(roundings), [&](const Vector2<double>& normal) {
      return (d.got.normal - normal).norm() * length <= roundings;
    });
  });
}

template <BulletAsked asked>
bool normal_turned_back(const Deviation& d) {
  return is_repeated(d, asked, [](const RepeatedQuery& query) {
    return query.answer.is_turned && !query.answer.is_axis_deeper;
  });
}

bool epa_at_invalid_hull(const Deviation& d) {
  return is_repeated(d, BulletAsked::epa, [](const RepeatedQuery& query) {
    return is_of_epa(query, BulletEpaEnd::invalid_hull);
  });
}

bool epa_beside_face(const Deviation& d) {
  return is_repeated(d, BulletAsked::epa, [](const RepeatedQuery& query) {
    return is_of_epa(query, BulletEpaEnd::accuracy_reached) && query.epa.is_beside_face;
  });
}

bool epa_at_chord(const Deviation& d) {
  const bool is_of_points = ledger_of::is_of_points(d.kind);
  if (total_radius(d.right.pair()) == 0 || (!is_of_points && d.kind != Kind::normal)) return false;
  return is_repeated(d, BulletAsked::epa, [&](const RepeatedQuery& query) {
    return is_of_epa(query, BulletEpaEnd::accuracy_reached) && !query.epa.is_beside_face &&
           (is_of_points || is_chord_within_accuracy(d, query));
  });
}

bool epa_at_inner_face(const Deviation& d) {
  if (total_radius(d.right.pair()) > 0) return false;
  return is_repeated(d, BulletAsked::epa, [&](const RepeatedQuery& query) {
    const double short_of = ledger_of::least_depth(d) - static_cast<double>(query.epa.depth);
    return is_of_epa(query, BulletEpaEnd::accuracy_reached) && !query.epa.is_beside_face &&
           short_of > d.right.bounds.separation;
  });
}

bool epa_finds_apart(const Deviation& d) {
  return is_repeated(d, BulletAsked::epa, [](const RepeatedQuery& query) {
    return query.answer.normal_of == NormalOf::solver_apart;
  });
}

bool epa_below_least_distance(const Deviation& d) {
  return below_gjk_distance(d) && is_repeated(d, BulletAsked::epa, [](const RepeatedQuery& query) {
           return query.epa.is_near;
         });
}

bool epa_without_axis(const Deviation& d) {
  return d.got.count == 0 && is_repeated(d, BulletAsked::epa, [](const RepeatedQuery& query) {
           return query.answer.is_solver_asked && query.answer.normal_of == NormalOf::nobody &&
                  query.answer.normal.isZero(0);
         });
}

bool epa_normal_between_places(const Deviation& d) {
  return is_repeated(d, BulletAsked::epa, [&](const RepeatedQuery& query) {
    return is_of_epa(query, BulletEpaEnd::accuracy_reached) &&
           replayed::is_right_answer(d, declaration_of_epa(), contact_of_face(d, query));
  });
}

bool corner_before_first(const Deviation& d) {
  const ledger_of::BulletPair hulls = ledger_of::flat_hulls_of(d.right.pair());
  if (!ledger_of::is_intersection_of_memory(hulls)) return false;
  return std::ranges::any_of(std::array{true, false}, [&](bool do_intersect) {
    RepeatedQuery query;
    query.answer =
        ledger_of::ask_detector_told(do_intersect, hulls, ledger_of::solve_by_directions,
                                     &query.directions, ledger_of::farthest_square_of(hulls));
    return is_answered(d, query);
  });
}

bool epa_falls_back(const Deviation& d) {
  return is_repeated(d, BulletAsked::epa, [](const RepeatedQuery& query) {
    return is_of_epa(query, BulletEpaEnd::fall_back);
  });
}

// The functions of each way to ask.
#define MANIFUZZ_BULLET_ASKED(asked)                                             \
  template bool axis_of_touching_cores<BulletAsked::asked>(const Deviation&);    \
  template bool stopped_at_near_corner<BulletAsked::asked>(const Deviation&);    \
  template bool stopped_at_rounded_point<BulletAsked::asked>(const Deviation&);  \
  template bool stopped_by_relative_error<BulletAsked::asked>(const Deviation&); \
  template bool stopped_at_flat_simplex<BulletAsked::asked>(const Deviation&);   \
  template bool point_of_displaced_query<BulletAsked::asked>(const Deviation&);  \
  template bool axis_taken_back<BulletAsked::asked>(const Deviation&);           \
  template bool axis_turned_by_roundings<BulletAsked::asked>(const Deviation&);  \
  template bool normal_turned_back<BulletAsked::asked>(const Deviation&);
MANIFUZZ_BULLET_ASKED(epa)
MANIFUZZ_BULLET_ASKED(directions)
MANIFUZZ_BULLET_ASKED(flat)
#undef MANIFUZZ_BULLET_ASKED
template bool distance_of_displaced_query<BulletAsked::directions>(const Deviation&);
template bool distance_of_displaced_query<BulletAsked::flat>(const Deviation&);

}  // namespace manifuzz
