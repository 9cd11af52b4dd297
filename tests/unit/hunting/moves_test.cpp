#include "hunting/moves.hpp"

#include <catch2/catch.hpp>

#include "exact/truth.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "hunting/breeding.hpp"

using namespace manifuzz;

namespace {

std::vector<Move> all_moves() {
  std::vector<Move> all;
  for (const auto moves : {moves_of_numbers(), moves_of_shapes(), moves_of_places()}) {
    all.insert(all.end(), moves.begin(), moves.end());
  }
  return all;
}

/// The case of that number among the regimes'.
PairCase drawn(std::uint64_t number) {
  return generate(9, regimes()[number % regimes().size()], number);
}

}  // namespace

TEST_CASE("every move makes valid cases that are others, from cases of any kind") {
  for (const Move& move : all_moves()) {
    CAPTURE(move.name);
    int made = 0;
    for (std::uint64_t number = 0; number < 600; ++number) {
      Random random(3, move.name, number);
      const PairCase parent = drawn(number);
      PairCase child = parent;
      move.make(random, child, drawn(number + 1));
      REQUIRE(child.a.polygon.count >= 1);
      REQUIRE(child.b.polygon.count >= 1);
      REQUIRE(child.a.polygon.count <= kMaxVertices);
      REQUIRE(child.b.polygon.count <= kMaxVertices);
      const auto valid = revalidated(child);
      if (valid && *valid != parent) ++made;
    }
    CHECK(made > 20);
  }
}

TEST_CASE("a move is made again by the same random numbers") {
  for (const Move& move : all_moves()) {
    CAPTURE(move.name);
    for (std::uint64_t number = 0; number < 50; ++number) {
      std::array<PairCase, 2> children{drawn(number), drawn(number)};
      for (PairCase& child : children) {
        Random random(3, move.name, number);
        move.make(random, child, drawn(number + 1));
      }
      // What is no number is equal to nothing.
      const auto first = revalidated(children[0]);
      if (first) CHECK(first == revalidated(children[1]));
    }
  }
}

TEST_CASE("what is bred has the normals of its vertices, whatever was left of its parent") {
  for (std::uint64_t number = 0; number < 20000; ++number) {
    Random random(3, "bred", number);
    const auto child = bred(random, drawn(number), drawn(number + 1), {});
    if (!child) continue;
    const auto valid = revalidated(*child);
    REQUIRE(valid);
    for (const Side side : {Side::a, Side::b}) {
      const auto& [shape, anew] = std::pair((*child)[side].polygon, (*valid)[side].polygon);
      for (int i = 0; i < shape.face_count(); ++i) {
        REQUIRE(same_bits(shape.normals[i], anew.normals[i]));
      }
    }
  }
}

TEST_CASE("laying a face on a face makes many contacts whose ends are cut") {
  const Move* lay_on = nullptr;
  for (const Move& move : moves_of_places()) {
    if (move.name == "lay_on") lay_on = &move;
  }
  REQUIRE(lay_on != nullptr);
  int touching = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    Random random(3, "laid", number);
    PairCase child = generate(9, *find_regime("generic"), number);
    lay_on->make(random, child, child);
    const auto valid = revalidated(child);
    if (valid && exact::Truth(*valid).compare_contact(0) <= 0) ++touching;
  }
  CHECK(touching > 100);
}

TEST_CASE("closing a gap makes most of what is apart touch, and leaves what overlaps") {
  int apart = 0;
  int closed = 0;
  for (std::uint64_t number = 0; number < 400; ++number) {
    Random random(3, "gap", number);
    const PairCase pair = generate(9, *find_regime("generic"), number);
    PairCase child = pair;
    close_gap(random, child);
    if (exact::Truth(pair).compare_contact(0) <= 0) {
      REQUIRE(child == pair);
      continue;
    }
    ++apart;
    if (exact::Truth(child).compare_contact(0) <= 0) ++closed;
  }
  CAPTURE(apart, closed);
  CHECK(apart > 40);
  CHECK(2 * closed > apart);
}
