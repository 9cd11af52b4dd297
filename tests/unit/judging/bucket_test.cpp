#include "judging/bucket.hpp"

#include <limits>
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
  Bucket bucket{Fault::oracle, Verdict::known, Kind::missed_contact, TieClass::reference, Side::b};
  CHECK(to_string(bucket) == "oracle/known/missed_contact/reference/b");
  bucket.error_class = ErrorClass::gross;
  CHECK(to_string(bucket) == "oracle/known/missed_contact/reference/b/gross");
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

TEST_CASE(
    "an error is gross above a hundredth of the size, and else rounding up to a thousand bounds") {
  CHECK(class_of(Kind::depth, 1000 * 0x1p-20, 0x1p-20) == ErrorClass::rounding);
  CHECK(class_of(Kind::depth, 1001 * 0x1p-20, 0x1p-20) == ErrorClass::fine);
  CHECK(class_of(Kind::depth, 0.01, 1e-7) == ErrorClass::fine);
  CHECK(class_of(Kind::depth, 0.011, 1e-7) == ErrorClass::gross);
  CHECK(class_of(Kind::depth, 0.5, 1e-3) == ErrorClass::gross);
  CHECK(class_of(Kind::depth, 0.009, 1e-5) == ErrorClass::rounding);
  CHECK(class_of(Kind::depth, std::numeric_limits<double>::quiet_NaN(), 1) == ErrorClass::gross);
  CHECK(class_of(Kind::features, 0, 1) == ErrorClass::fine);
}
