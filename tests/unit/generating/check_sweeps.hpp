#pragma once

#include <functional>
#include <map>
#include <string_view>

#include <catch2/catch.hpp>

#include "exact/curve.hpp"
#include "generating/drafts.hpp"
#include "generating/sweep.hpp"

namespace manifuzz {

/// By a sweep's name, whether its knob does what it says, measured from the stored floats.
using Knobs = std::map<std::string_view, std::function<bool(const PairCase&, double)>>;

/// The distance of the surfaces where they are nearest; negative: how deep they overlap.
inline double gap_of(const PairCase& pair) {
  return exact::separation_of(exact::Truth(pair)) - total_radius(pair);
}

/// Every step of every sweep of round shapes, or of every other, draws so many valid pairs, the
/// knob turned as it says; a quarter of them touch.
inline void check_sweeps(bool is_round, const Knobs& knobs, int cases) {
  for (const Sweep& sweep : sweeps()) {
    if (sweep.is_round != is_round) continue;
    for (const double x : sweep.values) {
      CAPTURE(sweep.name, x);
      int invalid = 0;
      int off = 0;
      int touching = 0;
      for (int i = 0; i < cases; ++i) {
        const PairCase pair = draw_case(1, sweep, x, static_cast<std::uint64_t>(i));
        invalid += revalidated(pair) ? 0 : 1;
        off += knobs.at(sweep.name)(pair, x) ? 0 : 1;
        touching += gap_of(pair) <= 0 ? 1 : 0;
      }
      CHECK(invalid == 0);
      CHECK(off == 0);
      CHECK(touching >= cases / 4);
    }
  }
}

}  // namespace manifuzz
