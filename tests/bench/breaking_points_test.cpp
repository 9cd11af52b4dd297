#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "engines/colliders.hpp"
#include "generating/sweep.hpp"
#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

using namespace manifuzz;

namespace {

std::string stored_path() {
  return (test::source_dir() / "tests" / "bench" / "breaking_points.json").string();
}

}  // namespace

TEST_CASE("no breaking point has moved down") {
  const auto outcome = test::run_manifuzz({"stress", "--quick", "--baseline", stored_path()});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.status == 0);
}

TEST_CASE("a breaking point is stored for every sweep, and faults for every walk, of ours") {
  const auto stored = nlohmann::json::parse(test::text_of(stored_path()));
  for (const ColliderEntry& entry : colliders()) {
    if (!entry.is_ours) continue;
    CAPTURE(entry.name);
    for (const Sweep& sweep : sweeps()) {
      CHECK(stored.at("sweeps").at(std::string(sweep.name)).contains(entry.name));
    }
    for (const Walk& walk : walks()) {
      CHECK(stored.at("walks").at(std::string(walk.name)).contains(entry.name));
    }
  }
}
