#include <cmath>

#include <catch2/catch.hpp>

#include "corpus/corpus.hpp"
#include "judging/faults/replayed.hpp"
#include "oracle/p2-es/replay.hpp"
#include "oracle/repeated_pairs.hpp"

// The ledger's predicates on jbox2d, cp, matter-js, p2, Rapier and Godot: what the named fault
// makes of a pair is explained, and what is wrong otherwise is not.

using namespace manifuzz;
using namespace manifuzz::test;
using test::explains;

namespace {

PairCase pair_of(const char* line) {
  return parse_case(line, FormatKey::optional).pair();
}

}  // namespace

TEST_CASE("of an edge's sides jbox2d tries the one towards the centroid") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains("jbox2d-edge-front", pair, got, Kind::not_minimal);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[0.05,-0.5],[0.62,0]]},"b":{"vertices":[[0.3,1],[0.3,-1]],"rounding":"round"}})");
  const Vector2<double> corner(0.62F, 0);
  CHECK(is_it(pair, one_point({1, 0}, corner, 0.32)));
  CHECK_FALSE(is_it(pair, one_point({1, 0}, corner, 0.33)));
  CHECK_FALSE(is_it(pair, one_point({0, 1}, corner, 0.32)));
  // This one's centroid is on the nearer side, too.
  pair.b.pose.position.x() = -0.1F;
  CHECK_FALSE(is_it(pair, one_point({1, 0}, corner, 0.42)));
}

TEST_CASE("jbox2d has no normal between an edge's end and a corner") {
  const auto is_it = [](const PairCase& pair) {
    return explains("jbox2d-edge-corners", pair, {}, Kind::missed_contact);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[0.4,-0.8]],"radius":0.1,"rounding":"round"},"b":{"vertices":[[0,0.005],[0.5,0.2],[-0.4,0.6]]}})");
  CHECK(is_it(pair));
  // The end is in front of the face: whoever misses that has another fault.
  pair.b.pose.position.x() = -0.2F;
  pair.b.pose.position.y() = -0.08F;
  CHECK_FALSE(is_it(pair));
}

TEST_CASE("jbox2d clips an edge by a face though its end and a corner are nearest") {
  // Right are two points along the line between them.
  const PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[0.07,0.01],[0.1,0.3],[-0.1,0.05]]},
          "b":{"vertices":[[0,0],[3.2,-1.1]],"radius":0.1,"rounding":"round","position":[0,-0.017]}})");
  const auto is_it = [&](const Manifold<double>& got) {
    return explains("jbox2d-edge-corners", pair, got, Kind::inconsistent);
  };
  const Vector2<double> of_face(0.1414213478565216, -0.9899494647979736);
  const Vector2<double> at(-0.011588144187139493, 0.0811170126394547);
  CHECK(is_it(one_point(of_face, at, 0.08194056153297424)));
  CHECK_FALSE(is_it(one_point(of_face, at, 0.083)));
  CHECK_FALSE(is_it(one_point({0, -1}, at, 0.08194056153297424)));
}

TEST_CASE("Box2D takes a centre within epsilon of a polygon to be inside") {
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    const Manifold<double> got =
        one_point(normal, {0.0027621358738203483, 0.0011441563849414749}, depth);
    return explains("box2d-face-within-epsilon", pair, got, Kind::normal);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[0,0.00390625],[-0.00390625,0]],"radius":0.00390625},
          "b":{"vertices":[[0,0.0039062924]],"radius":0.00390625,"rounding":"round"}})");
  const Vector2<double> normal(-0.7071067690849304, 0.7071067690849304);
  const double depth = 0.007812470197677612;
  CHECK(is_it(pair, normal, depth));
  CHECK_FALSE(is_it(pair, {0, 1}, depth));
  CHECK_FALSE(is_it(pair, normal, 2 * depth));
  // In front of a face it is that face's normal, which is right.
  pair.b.polygon.vertices[0] = {1.0e-8F, 0.001F};
  CHECK_FALSE(is_it(pair, {1, 0}, depth));
}

TEST_CASE("Box2D's normal of an edge shorter than epsilon is as short") {
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    const Manifold<double> got =
        one_point(normal, {0.00037648447323590517, 0.0011781248031184077}, depth);
    return explains("box2d-tiny-reference-face", pair, got, Kind::normal);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0.00037648447,0.0011781248]],"radius":0.00390625,"rounding":"round"},
          "b":{"vertices":[[0.0005921875,0.0010902345],[0.00059217366,0.0010902005]],"radius":0.00390625,"rounding":"round"}})");
  const Vector2<double> normal(3.3993273973464966e-08, -1.3853423297405243e-08);
  CHECK(is_it(pair, normal, 9.893344823930228e-18));
  CHECK_FALSE(is_it(pair, {0, 1}, 9.893344823930228e-18));
  CHECK_FALSE(is_it(pair, normal, 0.001));
  pair.b.polygon.vertices[1] = {0.00059F, 0.001F};
  CHECK_FALSE(is_it(pair, normal, 9.893344823930228e-18));
  const PairCase beside_triangle = pair_of(
      R"({"a":{"vertices":[[0,8e-08],[-2e-08,7.6e-08],[5e-09,2e-08]],"radius":0},
          "b":{"vertices":[[0,0],[0,4e-08]],"radius":6e-08,"rounding":"round"}})");
  CHECK(is_it(beside_triangle, {3.999999975690116e-08, 0}, 9.769962793982985e-23));
}

TEST_CASE("Chipmunk's normal is across a chord of roundings where corners lie on corners") {
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    Manifold<double> got = one_point(normal, {0, 0.0013107247650623322}, depth);
    got.count = 2;
    got.points[1] = got.points[0];
    return explains("chipmunk-direction-between-corners", pair, got, Kind::not_minimal,
                    ScalarType::float64);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[0,1]],"radius":0.0013107248,"rounding":"round","rotation":[1,1e-45]},
          "b":{"vertices":[[0,0],[0,1]],"radius":0.0013107248,"rounding":"round","rotation":[1,-1e-45]}})");
  const double depth = 0.0026214495301246643;
  CHECK(is_it(pair, {0, -1}, depth));
  CHECK_FALSE(is_it(pair, {0, 1}, depth));
  CHECK_FALSE(is_it(pair, {0, -1}, 2 * depth));
  pair.b.pose.position.x() = 0.001F;
  CHECK_FALSE(is_it(pair, {0, -1}, depth));
}

TEST_CASE("cp compares normals that are short by unlike amounts") {
  const auto is_it = [](const PairCase& pair) {
    return explains("cp-short-normal", pair, {}, Kind::missed_contact, ScalarType::float64);
  };
  CHECK(is_it(pair_of(
      R"({"a":{"vertices":[[0,0],[0.038081173,0.002492658],[0.039978694,0.010542572],[0.0049486617,0.028575469]]},
          "b":{"vertices":[[-0.4849146,-1.4115728],[-0.20161723,-1.7546937],[0.29815322,-1.8543302],[0.9318895,-1.121641],
                           [0.58678687,0],[0,9.282374e-09],[-0.17714061,0],[-0.5396071,-0.5268654]],
               "position":[0.08286252,0.00029898123]}})")));
  CHECK_FALSE(is_it(test::squares_side_by_side()));
}

TEST_CASE("@box2d/core's face is short in its polygon's own frame, however far that is") {
  const PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[187.5,1.875e+18],[0,2.5e+18]],"radius":6.8112783e+16,"rotation":[0,1]},
          "b":{"vertices":[[0,0],[-6.25e-06,2.5e-22],[-6.25e+18,0]],"radius":6.8112783e+16,
               "position":[-1.25e+18,1.875e+18],"rotation":[0,1]}})");
  const auto is_it = [&](double length, double depth) {
    Manifold<double> got = one_point({length, 0}, {0, 0}, depth);
    got.reference = Side::b;
    return explains("box2d-core-normal-of-short-face", pair, got, Kind::normal,
                    ScalarType::float64);
  };
  CHECK(is_it(6.24999984211172e-06, 5321158.279976232));
  CHECK_FALSE(is_it(6.24999984211172e-06, 1e8));
}

TEST_CASE("matter-js may find a vertex on an outline inside or not") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains("matter-js-deepest-left-out", pair, got, Kind::witness, ScalarType::float64);
  };
  // B's deepest corner is on A's lower side, but for roundings.
  const PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,1],[-0.8660254,-0.5],[0.8660254,-0.5]],"position":[-0.8155299,2.3866813]},
          "b":{"vertices":[[0,1],[-1,0],[0,-1],[1,0]],"position":[0.81676316,2.3866813],"rotation":[-0.5,0.8660254]}})");
  const Vector2<double> normal(0.86602540767034475, 0.49999999326941313);
  const double depth = 0.086392729623635311;
  const Vector2<double> of_a(0.8660254F, -0.5);
  CHECK(is_it(pair, one_point(normal, of_a, depth)));
  CHECK_FALSE(is_it(pair, one_point(normal, of_a - Vector2<double>(0.01, 0), depth)));
  CHECK_FALSE(is_it(pair, one_point(normal, of_a, 2 * depth)));
  PairCase lower = pair;
  lower.b.pose.position.y() += 0.01F;
  CHECK_FALSE(is_it(lower, one_point(normal, of_a, depth)));
}

TEST_CASE("a short capsule's direction is that of rounded ends in p2") {
  const auto is_it = [](const PairCase& pair, const Manifold<double>& got) {
    return explains("p2-es-edge-of-rounded-ends", pair, got, Kind::normal);
  };
  const PairCase pair = pair_of(
      R"({"a":{"vertices":[[0.09638,0.3016]],"radius":1,"rounding":"round"},
          "b":{"vertices":[[0.1516,0.2791],[0.15159647,0.27909133]],"radius":1,"rounding":"round"}})");
  const auto found = ledger_of::circle_contact_of_p2(pair);
  REQUIRE(found);
  const Manifold<double> got =
      replayed::in_frame_of_a(pair, {found->normal, {{found->at, found->depth}}});
  CHECK(is_it(pair, got));
  Manifold<double> turned = got;
  turned.normal = rotate<double>({std::cos(1e-3), std::sin(1e-3)}, got.normal);
  CHECK_FALSE(is_it(pair, turned));
  // A long one's ends are as good.
  PairCase longer = pair;
  longer.b.polygon.vertices[1] = {-0.20140F, -0.58790F};
  CHECK_FALSE(is_it(longer, got));
}

TEST_CASE("Rapier's contact is lost where EPA ends on a chord through the origin") {
  const auto is_it = [](const PairCase& pair) {
    return explains("rapier2d-contact-epa-chord", pair, {}, Kind::missed_contact);
  };
  CHECK(is_it(pair_of(
      R"({"a":{"vertices":[[-3,1],[0,0],[-2,1]],"position":[7.5,1.5],"rotation":[-1,0]},
          "b":{"vertices":[[-4,2],[-2,-3],[1,-5],[3,3],[3,4],[0,4]],"position":[10.5,-4],"rotation":[-1,0]}})")));
  CHECK_FALSE(is_it(test::squares_side_by_side()));
}

TEST_CASE("Rapier's GJK ends within its tolerance whatever corners it refused") {
  const auto is_it = [](const PairCase& pair) {
    return explains("rapier2d-contact-touching-within-tolerance", pair, {}, Kind::missed_contact);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[-0.6726914,-0.66787684],[0.4082755,1.8122087],[-0.8978041,0.02760892]],
               "radius":0.5240132,"rounding":"round","position":[12.462757,-5.4828544],"rotation":[-0.39088184,-0.92044085]},
          "b":{"vertices":[[-0.8538687,0.33142766],[0.8538687,-0.33142766]],"radius":0.47124678,"rounding":"round",
               "position":[14.357399,-5.270971],"rotation":[0.7880677,-0.61558855]}})");
  CHECK(is_it(pair));
  pair.b.pose.position.x() -= 0.1F;
  CHECK_FALSE(is_it(pair));
}

TEST_CASE("Rapier takes a circle's centre within epsilon of a capsule's core to be on it") {
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    const Manifold<double> got =
        one_point(normal, {-0.00017470659804530442, -9.31322503561205e-08}, depth);
    return explains("rapier2d-contact-centre-on-surface", pair, got, Kind::inconsistent);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0]],"radius":0.00017470661,"rounding":"round"},
          "b":{"vertices":[[0,9.375e-08],[0,0.018747909]],"radius":0.00017470661,"rounding":"round"}})");
  const Vector2<double> normal(-0.9999999403953552, -0.0005330779822543263);
  CHECK(is_it(pair, normal, 0.00034941325429826975));
  CHECK_FALSE(is_it(pair, {0, 1}, 0.00034941325429826975));
  CHECK_FALSE(is_it(pair, normal, 0.00035));
  pair.b.pose.position.y() = 1e-6F;
  CHECK_FALSE(is_it(pair, normal, 0.00034941325429826975));
}

TEST_CASE("Rapier's GJK refuses corners that it would go on from") {
  const auto is_it = [](const PairCase& pair) {
    return explains("rapier2d-contact-equal-corners", pair, {}, Kind::missed_contact);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0,0],[-1.8968295,0]],"rounding":"round"},
          "b":{"vertices":[[0,0],[0.7374981,0],[1.7924254,0.66115576],[1.8700929,1.1608782],[1.496641,1.4781543],
                           [1.2052621,1.58696],[0.3562563,1.3763142],[0.04475291,0.7874512]],
               "radius":0.0006218889,"rounding":"round","position":[0,0.0005371647]}})");
  CHECK(is_it(pair));
  pair.b.pose.position.y() = -0.1F;
  CHECK_FALSE(is_it(pair));
}

TEST_CASE("Rapier takes a corner within 10 epsilon for one at the origin") {
  const auto is_it = [](const PairCase& pair, const Vector2<double>& normal, double depth) {
    const Manifold<double> got = one_point(normal, {-0.007732951222, -0.000688970077}, depth);
    return explains("rapier2d-contact-origin-within-tolerance", pair, got, Kind::phantom_contact);
  };
  PairCase pair = pair_of(
      R"({"a":{"vertices":[[0.0067269322,-0.0057003554],[0.0010060197,0.0063893246],[-0.007732952,-0.00068896904]],
               "position":[-0.026710689,0.02869454],"rotation":[-0.07933768,-0.9968478]},
          "b":{"vertices":[[-0.0028743844,-0.0021079916],[0.0003804199,-0.00059742125],[0.0013002576,0.00012268414],
                           [0.00090673903,0.00030613178],[0.0006772096,0.00039500112],[0.00048536682,0.00045467532],
                           [-5.1246192e-05,0.00060726376],[-0.00082436245,0.00081965665]],
               "position":[-0.02665393,0.040020004],"rotation":[0.6204418,0.7842525]}})");
  const Vector2<double> normal(-0.629407158, 0.777075691);
  CHECK(is_it(pair, normal, 6.87145203e-08));
  CHECK_FALSE(is_it(pair, -normal, 6.87145203e-08));
  CHECK_FALSE(is_it(pair, normal, 1e-06));
  pair.b.pose.position.y() += 0.001F;
  CHECK_FALSE(is_it(pair, normal, 6.87145203e-08));
}

TEST_CASE("Godot may die of supports that it does not find") {
  const PairCase pair = pair_of(
      R"({"a":{"vertices":[[360324640000000,-398217860000000],[0,0],[-153915000000000,-243399120000000]],"rotation":[0,1]},
          "b":{"vertices":[[0,-125000000000000],[788426900000000,-1077411600000000],[1000000000000000,-1000000000000000],
                           [1179480700000000,-459005370000000]],
               "position":[-471383260000000,-783970000000000],"rotation":[0,1]}})");
  const auto is_it = entry_of("godot3-start-values").explains_lost;
  const Answer answer = Lost{};
  CHECK(is_it({pair, answer, Lost::How::crashed}));
  CHECK_FALSE(is_it({pair, answer, Lost::How::timed_out}));
  CHECK_FALSE(is_it({test::squares_side_by_side(), answer, Lost::How::crashed}));
}
