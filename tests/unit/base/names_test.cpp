#include <array>
#include <vector>

#include <catch2/catch.hpp>

#include "base/text.hpp"

using namespace manifuzz;

namespace {

constexpr std::array<std::string_view, 5> kWords{"sliver", "slivers", "generic", "near_parallel",
                                                 "near_collinear"};

std::string_view meant(std::string_view word) {
  return nearest(word, kWords).value_or("nothing");
}

}  // namespace

TEST_CASE("each kind of slip is one slip, two neighbours swapped as well") {
  for (const std::string_view slip : {"abcd", "ab", "axc", "acb"}) {
    CAPTURE(slip);
    constexpr std::array<std::string_view, 1> words{"abc"};
    CHECK(nearest(slip, words) == "abc");
  }
  constexpr std::array<std::string_view, 1> words{"abc"};
  CHECK_FALSE(nearest("cba", words));
  CHECK_FALSE(nearest("axx", words));
}

TEST_CASE("the nearest word is the one with the fewest slips, the first of equals") {
  CHECK(meant("slivr") == "sliver");
  CHECK(meant("silver") == "sliver");
  CHECK(meant("slivesr") == "sliver");
  CHECK(meant("slivres") == "slivers");
  CHECK(meant("Generic") == "generic");
  CHECK(meant("near-parallel") == "near_parallel");
}

TEST_CASE("a beginning means its word where there is only one with it") {
  CHECK(meant("g") == "generic");
  CHECK(meant("near_p") == "near_parallel");
  CHECK(meant("near_") == "nothing");
  CHECK(meant("") == "nothing");
}

TEST_CASE("more than a third of the characters wrong means nothing") {
  CHECK(meant("sxixxr") == "nothing");
  CHECK(meant("boxes") == "nothing");
  CHECK(meant(std::string(1'000'000, 's')) == "nothing");
}

TEST_CASE("what there is follows the nearest word where it is short, and alone otherwise") {
  CHECK(no_such("regime", "slivr", kWords) ==
        "there is no regime 'slivr'; did you mean 'sliver'? There are sliver, slivers, generic, "
        "near_parallel, near_collinear");
  CHECK(no_such("regime", "boxes", kWords).starts_with("there is no regime 'boxes'; there are sl"));
  std::vector<std::string_view> many(20, "something");
  many.push_back("generic");
  CHECK(no_such("regime", "genric", many) ==
        "there is no regime 'genric'; did you mean 'generic'?");
  CHECK(no_such("regime", "\x1b[31m", kWords).find("\\x1b[31m") != std::string::npos);
}

TEST_CASE("what is chosen by name comes once, in the order in which it is named") {
  struct Named {
    std::string_view name;
  };
  constexpr std::array<Named, 3> list{{{"sliver"}, {"generic"}, {"sliver"}}};
  const auto chosen = [&](const std::vector<std::string>& names) {
    return chosen_by_name(list, names, "regime", "--regime");
  };
  CHECK(chosen({"generic", "sliver", "generic"}) == std::vector{&list[1], &list[0]});
  CHECK(chosen({}) == std::vector{&list[0], &list[1], &list[2]});
  CHECK_THROWS_WITH(chosen({"generic", "slivr"}),
                    "--regime: there is no regime 'slivr'; did you mean 'sliver'? There are "
                    "sliver, generic");
}

TEST_CASE("what is counted is in the plural unless there is one") {
  CHECK(counted(0, "case") == "0 cases");
  CHECK(counted(1, "case") == "1 case");
  CHECK(counted(2, "body", "bodies") == "2 bodies");
  CHECK(counted(1, "body", "bodies") == "1 body");
  CHECK(times_in_words(1) == "once");
  CHECK(times_in_words(2) == "2 times");
}
