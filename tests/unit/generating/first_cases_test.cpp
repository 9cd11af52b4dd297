#include <map>
#include <string>
#include <string_view>

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "generating/sweep.hpp"
#include "unit/generating/case_hash.hpp"
#include "unit/generating/small_corpus.hpp"

namespace manifuzz {

TEST_CASE("the first cases of each regime are bit for bit what they were") {
  // To change a regime on purpose, paste the hash that the failure prints; those of `ulp` and
  // `corpus`, which move other regimes' cases, change with it. A hash that changes with the
  // compiler or the machine is a bug.
  const std::map<std::string, std::string> golden = {
      {"generic", "98834236d23adc19"},
      {"boxes", "911cb9da12db8e58"},
      {"regular", "679aac22d6d1b5d8"},
      {"grid", "99a60550e0ac3c95"},
      {"sliver", "1b4a69ba07c41aee"},
      {"near_parallel", "6e0e11de963d21b5"},
      {"tied_faces", "638abccf1b3de17b"},
      {"micro_edge", "d2ed99f89f7d5863"},
      {"near_collinear", "31a32e10def43356"},
      {"corner_corner", "649ce9a1c0b6e3a5"},
      {"corner_face", "bb8dce84fe9148ca"},
      {"touching", "eb20e54925834bc5"},
      {"deep", "29776fc28841f9c4"},
      {"tie_bias", "f3f6f1c3169c58a3"},
      {"separated", "579e7b1c31406715"},
      {"far_from_origin", "6ee00097a1a2948b"},
      {"scaled", "509a0a8648d09a4f"},
      {"off_unit", "51e82fb94ea3edf9"},
      {"ulp", "cf7cb4e8e07e12fb"},
      {"corpus", "9144724f259f122d"},
      {"circles", "7e38ec3c5b35282a"},
      {"capsules", "bafd272d1c23e444"},
      {"round_corners", "f8da78ff2f99fbb5"},
      {"mixed_shapes", "7d3041bf014d7765"},
      {"in_line", "e48e5a43cf516b0b"},
      {"tilted_edges", "6c9256e3372d1ed5"},
      {"voronoi_lines", "f76c9dbfb3d3df61"},
      {"cores_touch", "47508374b67a18b1"},
      {"large_radii", "9622507cf20682a6"},
      {"side_planes", "c3d009699729a6b5"},
  };
  const auto corpus = small_corpus();
  for (const Regime& regime : regimes()) {
    CaseHash hash;
    for (std::uint64_t i = 0; i < 256; ++i) hash.add(generate(42, regime, i, {corpus, {}}));
    const std::string name(regime.name);
    const auto expected = golden.find(name);
    INFO("regime " << name);
    CHECK(hash.hex() == (expected == golden.end() ? "" : expected->second));
  }
}

TEST_CASE("the first cases of each sweep are bit for bit what they were") {
  // To change a sweep on purpose, paste the hash that the failure prints, and store its breaking
  // points again. A hash that changes with the compiler or the machine is a bug.
  const std::map<std::string_view, std::string> golden = {
      {"distance", "c0aa03de83d5f4f1"},
      {"angle", "6370690dd5abe54d"},
      {"aspect", "0899ff3e32d1a2ee"},
      {"small", "3831534cd9d550d1"},
      {"large", "03f8b0eea29fa4ef"},
      {"ratio", "e444017b58eabdab"},
      {"depth", "944b0495316b66e8"},
      {"collinear", "ffea2c33373151c2"},
      {"chamfer", "083da3a838faa01f"},
      {"off_unit", "44cdbc561b1edbf5"},
      {"tie", "f3b06f1e16679e24"},
      {"touch", "2e938dfd98980353"},
      {"corner", "fa99844b775bc5ce"},
      {"capsule_angle", "2699158075a26457"},
      {"roundness", "ced26ec3b0470ce2"},
      {"core_distance", "083d3b051e2ce461"},
      {"round_distance", "ee2147115c00b702"},
  };
  for (const Sweep& sweep : sweeps()) {
    CaseHash hash;
    for (const double x : sweep.values) {
      for (std::uint64_t i = 0; i < 16; ++i) hash.add(draw_case(42, sweep, x, i));
    }
    CAPTURE(sweep.name);
    const auto expected = golden.find(sweep.name);
    CHECK(hash.hex() == (expected == golden.end() ? "" : expected->second));
  }
}

}  // namespace manifuzz
