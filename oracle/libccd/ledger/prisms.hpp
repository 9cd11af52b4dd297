#pragma once

#include "external/external_collider.hpp"
#include "oracle/libccd/ledger/simplex.hpp"
#include "oracle/libccd/prism.hpp"

namespace manifuzz::ledger_of {

/// The prisms that libccd is asked about, for its steps as the ledger repeats them.
class CcdPrisms {
 public:
  CcdPrisms(const PairCase& pair, const manifuzz_libccd::HalfHeights& heights)
      : pair_(c_body(pair.a), c_body(pair.b), heights) {}

  /// __ccdSupport.
  CcdVector support(const CcdVector& along) const {
    return farthest(pair_.a, along) - farthest(pair_.b, along * -1.0);
  }
  /// The difference of both centres, as center gives them.
  CcdVector middle() const {
    const auto [ax, ay] = pair_.a.middle();
    const auto [bx, by] = pair_.b.middle();
    return CcdVector{ax, ay, 0} - CcdVector{bx, by, 0};
  }

 private:
  static CcdVector farthest(const manifuzz_libccd::Prism& prism, const CcdVector& along) {
    const auto& [x, y] = prism.farthest(along.x(), along.y());
    return {x, y, along.z() < 0 ? -prism.half_height : prism.half_height};
  }

  manifuzz_libccd::PrismPair pair_;
};

}  // namespace manifuzz::ledger_of
