#include "support/skip.hpp"

#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "support/run_program.hpp"

// What a test program ends with where a test was skipped.

using namespace manifuzz::test;

namespace {

int status_of(const std::string& name) {
  return run_program({std::filesystem::read_symlink("/proc/self/exe").string(), name}).status;
}

}  // namespace

TEST_CASE("skips", "[.asked]") {
  skip("it is asked to");
}

TEST_CASE("skips and fails", "[.asked]") {
  skip("it is asked to");
  for (int i = 0; i < kSkippedStatus; ++i) CHECK(is_anything_skipped == false);
}

TEST_CASE("a test that is skipped in part and fails has failed, and is not counted as skipped") {
  CHECK(status_of("skips") == kSkippedStatus);
  CHECK(status_of("skips and fails") == 1);
}
