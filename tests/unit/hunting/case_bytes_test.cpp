#include "hunting/case_bytes.hpp"

#include <bit>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "generating/drafts.hpp"
#include "generating/regime.hpp"

using namespace manifuzz;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encoded(const PairCase& pair) {
  Bytes bytes(kCaseBytes);
  encode_case(pair, std::span<std::uint8_t, kCaseBytes>(bytes));
  return bytes;
}

PairCase case_of_number(std::uint64_t number) {
  return generate(4, regimes()[number % regimes().size()], number);
}

}  // namespace

TEST_CASE("a case comes back from its bytes, bit for bit") {
  for (std::uint64_t number = 0; number < 5000; ++number) {
    const PairCase pair = case_of_number(number);
    const auto again = decode_case(encoded(pair));
    REQUIRE(again);
    CHECK(*again == pair);
    CHECK(encoded(*again) == encoded(pair));  // signs of zeros, too
  }
}

TEST_CASE("the layout of a case's bytes is the one that is documented") {
  PairCase pair = case_of_number(0);
  pair.b.polygon = make_polygon<float>(
      std::array{Vector2<float>(0, 0), Vector2<float>(2, 0), Vector2<float>(1, 3)}, 0.5F,
      Rounding::round);
  pair.b.pose = {{7, -9}, {0, 1}};
  const Bytes bytes = encoded(pair);
  const auto number_at = [&](std::size_t at) {
    std::uint32_t bits = 0;
    for (std::size_t i = 4; i > 0; --i) bits = bits << 8 | bytes[kBodyBytes + at + i - 1];
    return std::bit_cast<float>(bits);
  };
  REQUIRE(bytes.size() == 176);
  CHECK(bytes[88] == 3);
  CHECK(bytes[89] == 1);
  CHECK(number_at(4 + 8) == 2);
  CHECK(number_at(4 + 20) == 3);
  CHECK(number_at(4 + 24) == 0);  // there is no fourth vertex
  CHECK(number_at(68) == 0.5F);
  CHECK(number_at(72) == 7);
  CHECK(number_at(76) == -9);
  CHECK(number_at(80) == 0);
  CHECK(number_at(84) == 1);
}

TEST_CASE("any bytes are a valid case or none") {
  rc::check([](const Bytes& bytes) {
    if (bytes.size() != kCaseBytes) RC_ASSERT(!decode_case(bytes));
  });
  rc::check([] {
    // Mostly a case's, so that some are valid, and some nearly.
    Bytes bytes = encoded(case_of_number(*rc::gen::inRange(0, 1000)));
    for (int left = *rc::gen::inRange(0, 4); left > 0; --left) {
      bytes[*rc::gen::inRange<std::size_t>(0, kCaseBytes)] = *rc::gen::arbitrary<std::uint8_t>();
    }
    const auto pair = decode_case(bytes);
    RC_CLASSIFY(pair.has_value());
    if (!pair) return;
    RC_ASSERT(revalidated(*pair) == pair);
    RC_ASSERT(decode_case(encoded(*pair)) == pair);
  });
  rc::check([] {
    const auto bytes = *rc::gen::container<Bytes>(kCaseBytes, rc::gen::arbitrary<std::uint8_t>());
    if (const auto pair = decode_case(bytes)) RC_ASSERT(revalidated(*pair) == pair);
  });
}

TEST_CASE("bytes of another length, and of what is no case, are none") {
  const Bytes good = encoded(case_of_number(1));
  REQUIRE(decode_case(good));
  for (const std::size_t size : {0, 1, 88, 175}) {
    CHECK_FALSE(decode_case(std::span(good).first(size)));
  }
  Bytes longer = good;
  longer.push_back(0);
  CHECK_FALSE(decode_case(longer));
  for (const auto& [at, byte] : {std::pair(0, 0), {0, 9}, {88, 255}, {1, 2}, {89, 7}}) {
    Bytes bad = good;
    bad[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(byte);
    CHECK_FALSE(decode_case(bad));
  }
  for (const std::size_t at : {4, 68, 72, 80}) {  // of a vertex, radius, position, rotation
    Bytes bad = good;
    for (std::size_t i = 0; i < 4; ++i) bad[at + i] = 0xFF;  // not a number
    CHECK_FALSE(decode_case(bad));
  }
}
