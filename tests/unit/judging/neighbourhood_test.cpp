#include <array>
#include <limits>

#include <catch2/catch.hpp>

#include "generating/regime.hpp"
#include "judging/judge.hpp"

using namespace manifuzz;

namespace {

ConvexPolygon<float> triangle(std::array<Vector2<float>, 3> corners) {
  return make_polygon<float>(corners);
}

PairCase triangle_on_triangle() {
  PairCase pair;
  pair.a.polygon = triangle({Vector2<float>(-2, 0), {2, 0}, {0, 3}});
  pair.b.polygon = triangle({Vector2<float>(-1, -2), {1, -2}, {0.25F, 0}});
  pair.b.pose.position = {0, 0.125F};
  return pair;
}

Bucket bucket(Fault fault, Verdict verdict) {
  return {.fault = fault, .verdict = verdict};
}

}  // namespace

TEST_CASE("the deciding vertex is the deepest behind the face of the greatest separation") {
  CHECK(deciding_vertex(exact::Truth(triangle_on_triangle())) == VertexOf{Side::b, 2});
  for (std::uint64_t i = 0; i < 200; ++i) {
    const PairCase pair = generate(1, *find_regime("generic"), i, {});
    const exact::Truth truth(pair);
    const exact::FaceOf face = truth.greatest();
    const VertexOf found = deciding_vertex(truth);
    CHECK(found.side == other(face.side));
    PairCase shallower = pair;  // drawn out of the face's way, it decides no longer
    ConvexPolygon<float>& polygon = shallower[found.side].polygon;
    polygon.vertices[found.index] = (polygon.vertices[polygon.next(found.index)] +
                                     polygon.vertices[polygon.previous(found.index)]) /
                                    2;
    const exact::FaceOf same{face.side, face.index};
    CHECK(exact::Truth(shallower).separation(same) > truth.separation(same));
  }
}

TEST_CASE("a grid is symmetric about the case itself") {
  const PairCase pair = triangle_on_triangle();
  const Grid grid = grid_around(exact::Truth(pair), 3);
  CHECK(grid.side() >= 128);
  CHECK(grid.cell_count() == grid.side() * grid.side());
  const int middle = grid.cell_count() / 2;
  CHECK(neighbour(pair, grid, middle) == pair);
  const Vector2<float> at = pair.b.polygon.vertices[2];
  const auto moved_by = [&](int cell) -> Vector2<double> {
    const Vector2<float> to = neighbour(pair, grid, cell)->b.polygon.vertices[2];
    return to.cast<double>() - at.cast<double>();
  };
  for (const int cell : {0, 1, grid.side() - 1, grid.side(), 5000, middle - 1}) {
    const int opposite = grid.cell_count() - 1 - cell;
    CHECK(grid.x_of(opposite) == -grid.x_of(cell));
    CHECK(grid.y_of(opposite) == -grid.y_of(cell));
    CHECK(moved_by(opposite) == -moved_by(cell));
    // The floats at B's reach, sqrt(5), are 2^-22 apart.
    CHECK(moved_by(cell) == 3 * 0x1p-22 * Vector2<double>(grid.x_of(cell), grid.y_of(cell)));
  }
  CHECK(moved_by(0) == Vector2<double>(-192, -192) * 0x1p-22);
}

TEST_CASE("a circle at its own origin is moved by ulps of its radius") {
  const std::array<Vector2<float>, 1> center{Vector2<float>(0, 0)};
  PairCase pair{{make_polygon<float>(center, 1.0F), {}}, {make_polygon<float>(center, 1.0F), {}}};
  pair.b.pose.position = {1.5F, 0};
  CHECK(grid_around(exact::Truth(pair)).ulp == 0x1p-23);
}

TEST_CASE("a neighbour that is no convex polygon of floats is none") {
  PairCase pair = triangle_on_triangle();
  pair.b.polygon = triangle({Vector2<float>(-1, 0), {1, 0}, {0, 1e-6F}});
  const Grid flat{.vertex = {Side::b, 2}, .ulp = 0x1p-24};
  CHECK(neighbour(pair, flat, flat.cell_count() / 2));
  CHECK(neighbour(pair, flat, flat.cell_count() - 1));
  CHECK_FALSE(neighbour(pair, flat, 0));
  const float most = std::numeric_limits<float>::max();
  pair.b.polygon = triangle({Vector2<float>(0, 0), {most, 0}, {0, most}});
  const Grid wide{.vertex = {Side::b, 1}, .ulp = 0x1p104};
  CHECK(neighbour(pair, wide, wide.cell_count() / 2 - 1));
  CHECK_FALSE(neighbour(pair, wide, wide.cell_count() / 2 + 1));
}

TEST_CASE("what is said is the points' features, whatever their figures") {
  Manifold<double> manifold;
  CHECK(summary_of(Answer(manifold)).kind == ContactSummary::Kind::apart);
  manifold.count = 1;
  const ContactSummary said = summary_of(Answer(manifold));
  CHECK(said.kind == ContactSummary::Kind::contact);
  manifold.points[0].depth = 7;
  CHECK(summary_of(Answer(manifold)) == said);
  manifold.points[0].features.b.index = 1;
  CHECK_FALSE(summary_of(Answer(manifold)) == said);
  manifold.count = 3;
  CHECK(summary_of(Answer(manifold)).kind == ContactSummary::Kind::nothing);
  CHECK(summary_of(Answer(Unsupported{"no"})).kind == ContactSummary::Kind::nothing);
}

TEST_CASE("the truth says what the exact clip keeps") {
  PairCase pair = triangle_on_triangle();
  const ContactSummary said = summary_of(exact::Truth(pair));
  CHECK(said.kind == ContactSummary::Kind::contact);
  CHECK(said.reference == Side::a);
  CHECK(said.count == 1);
  CHECK(said.features[0] == FeaturePair{{Feature::Kind::face, 0}, {Feature::Kind::vertex, 2}});
  pair.b.pose.position.y() = -1;
  CHECK(summary_of(exact::Truth(pair)).kind == ContactSummary::Kind::apart);
}

TEST_CASE("a neighbour fails alike where the collider at fault is wrong") {
  const Bucket agree;
  const Bucket tie = bucket(Fault::none, Verdict::tie);
  const Bucket known = bucket(Fault::oracle, Verdict::known);
  const Bucket of_subject = bucket(Fault::subject, Verdict::subject_wrong);
  const Bucket of_oracle = bucket(Fault::oracle, Verdict::oracle_wrong);
  const Bucket of_both = bucket(Fault::both, Verdict::both_wrong);
  const Bucket died = bucket(Fault::subject, Verdict::crashed);
  const std::array all{agree, tie, known, of_subject, of_oracle, of_both, died};
  const auto alike = [&all](const Bucket& finding) {
    std::string flags;
    for (const Bucket& other : all) flags += fails_alike(other, finding) ? '1' : '0';
    return flags;
  };
  CHECK(alike(agree) == "0011111");
  CHECK(alike(tie) == "0100000");
  CHECK(alike(known) == "0010110");
  CHECK(alike(of_oracle) == "0010110");
  CHECK(alike(of_subject) == "0001011");
  CHECK(alike(died) == "0001011");
  CHECK(alike(of_both) == "0000010");
}

TEST_CASE("the severity counts what was judged") {
  Neighbourhood neighbourhood;
  const Bucket wrong = bucket(Fault::subject, Verdict::subject_wrong);
  CHECK(severity(neighbourhood, wrong).share() == 0);
  neighbourhood.cells.resize(8);
  for (std::size_t i = 0; i < 5; ++i) neighbourhood.cells[i].bucket = wrong;
  for (std::size_t i = 0; i < 4; ++i) neighbourhood.cells[i].state = Cell::State::judged;
  neighbourhood.cells[4].state = Cell::State::invalid;
  neighbourhood.cells[7].state = Cell::State::judged;
  CHECK(severity(neighbourhood, wrong).failing == 4);
  CHECK(severity(neighbourhood, wrong).valid == 5);
  CHECK(severity(neighbourhood, wrong).share() == 0.8);
}
