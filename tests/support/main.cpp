#define CATCH_CONFIG_RUNNER
#include <catch2/catch.hpp>

#include "support/skip.hpp"

int main(int argc, char** argv) {
  const int status = Catch::Session().run(argc, argv);
  return status == 0 && manifuzz::test::is_anything_skipped ? manifuzz::test::kSkippedStatus
                                                            : status;
}
