#include "engines/engine.hpp"

#include <array>

#include "oracle/bullet/bullet_cached.hpp"
#include "oracle/bullet/bullet_pass.hpp"
#include "oracle/bullet/ledger/displaced_entries.hpp"
#include "oracle/bullet/ledger/entries.hpp"
#include "oracle/bullet/ledger/epa_entries.hpp"
#include "oracle/bullet/ledger/perturbed_entries.hpp"
#include "oracle/bullet/ledger/query_entries.hpp"
#include "oracle/bullet/ledger/rounded_entries.hpp"
#include "oracle/bullet/sequence_ledger.hpp"

namespace manifuzz {

namespace {

constexpr std::array kLedger =
    joined(ledger_of::kOfBullet, ledger_of::kOfBulletEpa, ledger_of::kOfBulletQuery,
           ledger_of::kOfBulletDisplaced, ledger_of::kOfBulletPerturbed,
           ledger_of::kOfBulletPerturbedEpa, ledger_of::kOfBulletRounded);

}  // namespace

Engine engine_bullet() {
  Engine engine{.name = "bullet", .ledger = kLedger, .sequence_ledger = bullet_sequence_ledger()};
#ifdef MANIFUZZ_WITH_BULLET
  engine.keepers = {{"bullet-cached", make_bullet_cached}};
  engine.passes = {{"bullet-epa", "bullet-epa", "closest points", bullet_epa_pass},
                   {"bullet-minkowski", "bullet-minkowski", "", bullet_minkowski_pass},
                   {"bullet-perturbed", "bullet-perturbed", "perturbed", bullet_perturbed_pass}};
#endif
  return engine;
}

}  // namespace manifuzz
