#include "judging/faults/seen_along.hpp"
#include "oracle/chipmunk/deviations.hpp"

// Faults of Chipmunk 7 and its ports that a replay tells: it gives the answer, which is wrong as it
// gives it too, and a right one with the fault mended, alone or with as few others as will do.

namespace manifuzz {
namespace {

/// The faults without which a port might do otherwise with this pair.
unsigned faults_of(const munk::Port& port, const PairCase& pair) {
  unsigned faults = 0;
  const auto add = [&](munk::Fault fault, bool is_of_case) {
    if (is_of_case) faults |= static_cast<unsigned>(fault);
  };
  add(munk::Fault::world, !pair.a.pose.position.isZero(0));
  add(munk::Fault::ends, true);
  add(munk::Fault::support_edge, true);
  add(munk::Fault::distance, ledger_of::is_swapped(pair));
  add(munk::Fault::polygon_radius, port.of_polygon != munk::Port{}.of_polygon);
  add(munk::Fault::length, port.to_length != munk::kChipmunk.to_length);
  return faults;
}

bool is_by(munk::Fault fault, const munk::Port& port, const Deviation& d) {
  if (!munk::is_given_by(port, d)) return false;
  const PairCase& pair = d.right.pair();
  if (munk::is_right(d, munk::found_by(port, pair))) return false;
  const unsigned all = faults_of(port, pair);
  return replayed::is_needed(static_cast<unsigned>(fault), all, [&](unsigned faults) {
    return munk::is_right(d, munk::found_by(munk::mended(port, faults), pair));
  });
}

}  // namespace

bool wrong_support_edge(const munk::Port& port, const Deviation& d) {
  return neighbours_nearly_parallel(d) || is_by(munk::Fault::support_edge, port, d);
}

bool rounded_in_the_world(const munk::Port& port, const Deviation& d) {
  return is_by(munk::Fault::world, port, d);
}

bool end_of_long_edge(const munk::Port& port, const Deviation& d) {
  return is_by(munk::Fault::ends, port, d);
}

bool normal_without_length(const munk::Port& port, const Deviation& d) {
  return d.got.count > 0 && d.got.normal.isZero(0) && munk::is_given_by(port, d);
}

}  // namespace manifuzz
