#include "engines/engine.hpp"

#include "oracle/libccd/ledger/rows.hpp"
#include "oracle/libccd/libccd_pass.hpp"

namespace manifuzz {

Engine engine_libccd() {
  Engine engine{.name = "libccd", .ledger = libccd_ledger()};
#ifdef MANIFUZZ_WITH_CCD
  engine.passes = {{"libccd-gjk", "libccd-gjk", "closest points", libccd_gjk_pass},
                   {"libccd-mpr", "libccd-mpr", "closest points", libccd_mpr_pass}};
#endif
  return engine;
}

}  // namespace manifuzz
