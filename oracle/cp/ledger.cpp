
#include "engines/engine.hpp"
#include "oracle/chipmunk/deviations.hpp"
#include "oracle/chipmunk/replay.hpp"

// cp, whose other faults are Chipmunk's own.

namespace manifuzz {
namespace {

bool is_wrong_as_chipmunk(const Deviation& d) {
  if (!is_round(d.right.pair())) {
    return normal_of_rounded_vertices(d) || neighbours_nearly_parallel(d);
  }
  return sign_of_swapped_distance(d) || sign_of_polygon_radius(d) ||
         direction_to_place_on_segment(d) || direction_between_corners(d) ||
         segment_normal_not_unit(d) || normal_across_corner_on_corner(d) ||
         normal_across_collinear(d) || depth_by_crossing(d);
}

/// A normal that is shorter than unit as 1e-15 beside the length that it is divided by makes
/// it, and right else, or wrong in a way of Chipmunk's.
bool normal_short_by_cp(const Deviation& d) {
  if (!munk::is_given_by(munk::kCp, d)) return false;
  const munk::Found found = munk::found_by(munk::kChipmunk, d.right.pair());
  if (munk::is_right(d, found)) return true;
  // Beside it something of Chipmunk's may be wrong, which alone is not what was given.
  const replayed::Contact contact = munk::contact_of(found, d.got.reference);
  const Manifold<double> mended = replayed::in_frame_of_a(d.right.pair(), contact);
  const Kind kind = mended.count == 0 ? Kind::missed_contact : d.kind;
  if (!is_wrong_as_chipmunk({d.right, mended, kind})) return false;
  const bool is_short = d.kind == Kind::normal && d.got.normal.norm() <= 1 - d.right.bounds.normal;
  return is_short || !is_wrong_as_chipmunk(d);
}

constexpr LedgerRow kFirstOfCp[] = {{"short-normal", normal_short_by_cp}};

}  // namespace

Engine engine_cp() {
  static const auto others =
      rows_but_for({"direction-between-corners", "epa-of-equal-corners"}, kRowsOfMunk);
  return {.name = "cp",
          .ledger = {{"cp", kFirstOfCp}, {"cp", others}, {"cp", kReplayedRowsOf<munk::kCp>}}};
}

}  // namespace manifuzz
