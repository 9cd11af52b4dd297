#include "judging/bucket.hpp"

#include <set>

#include <catch2/catch.hpp>

using namespace manifuzz;

TEST_CASE("every bucket has an index of its own and comes back from it") {
  std::set<std::string> names;
  for (std::size_t i = 0; i < kBucketCount; ++i) {
    CHECK(index_of(bucket_at(i)) == i);
    names.insert(to_string(bucket_at(i)));
  }
  CHECK(names.size() == kBucketCount);
}

TEST_CASE("a bucket's name says who, what, how, why and where") {
  const Bucket bucket{Fault::oracle, Verdict::known, Kind::missed_contact, TieClass::reference,
                      Side::b};
  CHECK(to_string(bucket) == "oracle/known/missed_contact/reference/b");
}

TEST_CASE("unexplained is what nobody explains, and failures are the subject's") {
  CHECK(is_unexplained(Verdict::oracle_wrong));
  CHECK(is_unexplained(Verdict::timed_out));
  CHECK_FALSE(is_unexplained(Verdict::known));
  CHECK_FALSE(is_unexplained(Verdict::tie));
  CHECK_FALSE(is_failure({.fault = Fault::oracle, .verdict = Verdict::oracle_wrong}));
  CHECK(is_failure({.fault = Fault::both, .verdict = Verdict::both_wrong}));
  CHECK(is_failure({.fault = Fault::subject, .verdict = Verdict::crashed}));
}
