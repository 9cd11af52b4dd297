#include "oracle/chipmunk/deviations.hpp"
#include "oracle/chipmunk/replay.hpp"

// Faults of Chipmunk 7 and its ports that a replay tells: it gives the answer, and a right one with
// the fault mended, alone or with as few others as will do.

namespace manifuzz {
namespace {

/// The port that gives this answer to the case; nullptr where none does.
const munk::Port* port_that_gives(const Deviation& d) {
  for (const munk::Port* const port : {&munk::kChipmunk, &munk::kMunk, &munk::kCp}) {
    if (munk::is_given_by(*port, d)) return port;
  }
  return nullptr;
}

bool is_by(const Deviation& d, munk::Fault fault) {
  const munk::Port* const port = port_that_gives(d);
  if (port == nullptr) return false;
  return replayed::is_needed(static_cast<unsigned>(fault), munk::kAllFaults, [&](unsigned faults) {
    return munk::is_right(d, munk::found_by(munk::mended(*port, faults), d.right.pair()));
  });
}

}  // namespace

bool wrong_support_edge(const Deviation& d) {
  return neighbours_nearly_parallel(d) || is_by(d, munk::Fault::support_edge);
}

bool rounded_in_the_world(const Deviation& d) {
  return is_by(d, munk::Fault::world);
}

bool end_of_long_edge(const Deviation& d) {
  return is_by(d, munk::Fault::ends);
}

bool normal_without_length(const Deviation& d) {
  return d.got.count > 0 && d.got.normal.isZero(0) && port_that_gives(d) != nullptr;
}

}  // namespace manifuzz
