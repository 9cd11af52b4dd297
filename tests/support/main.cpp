#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "support/skip.hpp"

int main(int argc, char** argv) {
  // Catch2's status is how many checks failed, which may be that of a skipped test.
  if (Catch::Session().run(argc, argv) != 0) return 1;
  return manifuzz::test::is_anything_skipped ? manifuzz::test::kSkippedStatus : 0;
}
