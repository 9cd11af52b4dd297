#include "measure/digest.hpp"

#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "kernel/target.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

constexpr std::uint64_t kCases = 600;  // of each regime: more than two batches

Digest digest_of(const Collider& collider, std::uint64_t seed = 1) {
  Interruption interruption;
  return digest({collider, seed, kCases}, interruption, [](std::uint64_t) {});
}

/// The hash of each regime.
std::vector<std::uint64_t> hashes_of(const Collider& collider) {
  std::vector<std::uint64_t> hashes;
  for (const RegimeDigest& regime : digest_of(collider).regimes) hashes.push_back(regime.hash);
  return hashes;
}

/// The collider with its answers changed.
template <class Change>
Collider changed(Collider collider, const Change& change) {
  collider.collide = [collide = collider.collide, change](const PairCase& pair) {
    Answer answer = collide(pair);
    auto& manifold = std::get<Manifold<double>>(answer);
    if (manifold.count > 0) change(manifold);
    return answer;
  };
  return collider;
}

}  // namespace

TEST_CASE("kernels have the digest of the clean code, on every instruction set") {
  const std::vector<std::uint64_t> clip = hashes_of(make_clip());
  const std::vector<std::uint64_t> clip64 = hashes_of(make_clip64());
  CHECK(clip != clip64);
  for (const std::string& target : kernel::targets()) {
    CAPTURE(target);
    kernel::use_target(target);
    CHECK(hashes_of(make_pair()) == clip);
    CHECK(hashes_of(make_batch()) == clip);
    CHECK(hashes_of(make_batch64()) == clip64);
  }
  kernel::use_target(kernel::targets().front());
}

// Any machine and compiler: a change of it changes the bits of somebody's contacts.
TEST_CASE("the digest of the clean code is what it was") {
  CHECK(digest_of(make_pair()).hash == 0xb7169ca2dee79955ULL);
  CHECK(digest_of(make_batch64()).hash == 0x43e6e53ee62902e7ULL);
  CHECK(digest_of(make_clip()).hash == 0xb7169ca2dee79955ULL);
  CHECK(digest_of(make_clip64()).hash == 0x43e6e53ee62902e7ULL);
}

TEST_CASE("a digest changes with every bit of an answer, and with the seed") {
  const Collider clip = make_clip();
  const Digest plain = digest_of(clip);
  CHECK(digest_of(clip, 2).hash != plain.hash);
  const auto is_seen = [&](const auto& change) {
    const Digest other = digest_of(changed(clip, change));
    bool all = other.hash != plain.hash;
    for (std::size_t i = 0; i < plain.regimes.size(); ++i) {
      const bool has_contacts = plain.regimes[i].contacts > 0;
      all = all && (other.regimes[i].hash != plain.regimes[i].hash) == has_contacts;
    }
    return all;
  };
  CHECK(is_seen([](Manifold<double>& m) { m.normal.x() = std::nextafter(m.normal.x(), 2); }));
  CHECK(is_seen([](Manifold<double>& m) {
    m.points[0].position.y() = std::nextafter(m.points[0].position.y(), 1e300);
  }));
  CHECK(is_seen([](Manifold<double>& m) {
    m.points[m.count - 1].depth = std::nextafter(m.points[m.count - 1].depth, 1e300);
  }));
  CHECK(is_seen([](Manifold<double>& m) { m.reference = other(m.reference); }));
  CHECK(is_seen([](Manifold<double>& m) { --m.count; }));
  CHECK(is_seen([](Manifold<double>& m) { ++m.points[0].features.b.index; }));
  CHECK(is_seen([](Manifold<double>& m) {
    auto& kind = m.points[0].features.a.kind;
    kind = kind == Feature::Kind::face ? Feature::Kind::vertex : Feature::Kind::face;
  }));
}

TEST_CASE("a digest counts the answers that have points") {
  const Digest result = digest_of(make_clip());
  REQUIRE(result.regimes.size() == regimes().size());
  for (const RegimeDigest& of_regime : result.regimes) {
    CHECK((of_regime.contacts == 0) == (of_regime.regime == "separated"));
    CHECK(of_regime.contacts <= kCases);
  }
}

TEST_CASE("an interrupted digest tells nothing") {
  Interruption stopped({.begins = Interruption::State::stopped});
  CHECK_THROWS_WITH(digest({make_clip(), 1, kCases}, stopped, [](std::uint64_t) {}),
                    "digest: interrupted; nothing is told");
}
