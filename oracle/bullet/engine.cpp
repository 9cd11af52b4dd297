#include "engines/engine.hpp"

#include "oracle/bullet/bullet_cached.hpp"
#include "oracle/bullet/bullet_pass.hpp"
#include "oracle/bullet/ledger/rows.hpp"

namespace manifuzz {

Engine engine_bullet() {
  Engine engine{.name = "bullet",
                .ledger = bullet_query_ledger(),
                .sequence_ledger = {bullet_sequence_ledger()}};
  engine.ledger.push_back(bullet_perturbed_ledger());
#ifdef MANIFUZZ_WITH_BULLET
  engine.keepers = {{"bullet-cached", make_bullet_cached}};
  engine.passes = {{"bullet-epa", "bullet-epa", "closest points", bullet_epa_pass},
                   {"bullet-minkowski", "bullet-minkowski", "", bullet_minkowski_pass},
                   {"bullet-perturbed", "bullet-perturbed", "perturbed", bullet_perturbed_pass}};
#endif
  return engine;
}

}  // namespace manifuzz
