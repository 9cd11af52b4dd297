#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "clipping/collide.hpp"
#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;
using Catch::Matchers::WithinAbs;

namespace {

using Core = std::vector<Vector2<double>>;

const Core kBox{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};

Manifold<double> contact(const Core& a, double radius_a, const Core& b, double radius_b,
                         SecondPoint second_point = {}) {
  const auto make = [](const Core& core, double radius) {
    return make_polygon<double>(core, radius, Rounding::round);
  };
  return clipping::collide_in_frame(make(a, radius_a), make(b, radius_b), 0.0, second_point);
}

bool is_at(const ContactPoint<double>& point, double x, double y, double depth) {
  return std::abs(point.position.x() - x) < 1e-12 && std::abs(point.position.y() - y) < 1e-12 &&
         std::abs(point.depth - depth) < 1e-12;
}

}  // namespace

TEST_CASE("a circle's only point is its farthest along the normal") {
  const auto m = contact({{0, 0}}, 1, {{1.5, 2}}, 2);
  REQUIRE(m.count == 1);
  CHECK_THAT(m.normal.x(), WithinAbs(0.6, 1e-15));
  CHECK(m.reference == Side::b);
  CHECK(is_at(m.points[0], 0.6, 0.8, 0.5));
  CHECK(contact({{0, 0}}, 1, {{3, 4}}, 3.9).count == 0);
}

TEST_CASE("circles at one place are as deep as both radii, along some normal") {
  const auto m = contact({{2, 3}}, 1, {{2, 3}}, 0.5);
  REQUIRE(m.count == 1);
  CHECK(m.normal.norm() == 1);
  CHECK(m.points[0].depth == 1.5);
}

TEST_CASE("a circle meets a polygon at a face, at a corner, and from inside") {
  const auto at_face = contact(kBox, 0, {{0.5, 1.25}}, 0.5);
  REQUIRE(at_face.count == 1);
  CHECK(at_face.normal == Vector2<double>(0, 1));
  CHECK(is_at(at_face.points[0], 0.5, 0.75, 0.25));
  const auto at_corner = contact(kBox, 0, {{1.3, 1.4}}, 1);
  REQUIRE(at_corner.count == 1);
  CHECK_THAT(at_corner.normal.x(), WithinAbs(0.6, 1e-15));
  CHECK(is_at(at_corner.points[0], 0.7, 0.6, 0.5));
  const auto inside = contact(kBox, 0, {{0.5, 0.25}}, 0.25);
  REQUIRE(inside.count == 1);
  CHECK(inside.normal == Vector2<double>(1, 0));
  CHECK(is_at(inside.points[0], 0.25, 0.25, 0.75));
}

TEST_CASE("a circle past the end of a face and before the next one has the next one's normal") {
  // Rounded, face 6 is the farther one from the centre; it lies before face 7, by the corner.
  const std::vector<Vector2<float>> core{
      {0.5423506F, 0.5285393F},     {-0.3780128F, -0.11523522F},  {-0.35057297F, -0.37195945F},
      {-0.22614224F, -0.28214663F}, {-0.12390314F, -0.18066764F}, {0.031537622F, -0.016319584F},
      {0.18542019F, 0.14745925F},   {0.31932276F, 0.29032996F}};
  const std::vector<Vector2<float>> centre{{0, 0}};
  const Body circle{make_polygon<float>(centre, 1.3313574F, Rounding::round),
                    {{0, 0}, {-0.08732953F, -0.99617946F}}};
  const Body polygon{make_polygon<float>(core, 0.01F),
                     {{0.18671046F, 1.3648125F}, {0.2945051F, -0.9556499F}}};
  const auto m = std::get<Manifold<double>>(make_clip().collide({circle, polygon}));
  REQUIRE(m.count == 1);
  CHECK(m.points[0].features.b == Feature{Feature::Kind::face, 7});
  CHECK_THAT(m.normal.x(), WithinAbs(-0.9337245601, 4e-7));
  CHECK_THAT(m.normal.y(), WithinAbs(0.3579922688, 4e-7));
  CHECK_THAT(m.points[0].depth, WithinAbs(0.0673968959, 3e-6));
}

TEST_CASE("parallel capsules touch along the overlap of their edges") {
  const auto m = contact({{-1, 0}, {1, 0}}, 0.5, {{-0.25, 0.75}, {3, 0.75}}, 0.5);
  REQUIRE(m.count == 2);
  CHECK(m.normal == Vector2<double>(0, 1));
  CHECK(is_at(m.points[0], 1, 0.25, 0.25));
  CHECK(is_at(m.points[1], -0.25, 0.25, 0.25));
}

TEST_CASE("the second point of capsules is measured along the contact's normal") {
  // B's near end is in front of the inside of A: 0.75 above it. Its far end is as far again.
  const auto m = contact({{-4, 0}, {4, 0}}, 1, {{0, 0.75}, {2, 1.5}}, 0.5);
  REQUIRE(m.count == 2);
  CHECK(m.normal == Vector2<double>(0, 1));
  CHECK(is_at(m.points[0], 2, 1, 0));
  CHECK(is_at(m.points[1], 0, 0.25, 0.75));
}

TEST_CASE("capsules end to end on one line touch in one point, along the line") {
  const auto m = contact({{-1, 0}, {1, 0}}, 0.5, {{1.75, 0}, {4, 0}}, 0.5);
  REQUIRE(m.count == 1);
  CHECK(m.normal == Vector2<double>(1, 0));
  CHECK(m.points[0].depth == 0.25);
  CHECK(contact({{-1, 0}, {1, 0}}, 0.5, {{2.25, 0}, {4, 0}}, 0.5).count == 0);
}

TEST_CASE("crossing capsules leave along the nearest way out of their cores") {
  const auto m = contact({{-1, 0}, {1, 0}}, 0.25, {{0.5, -3}, {0.5, 1}}, 0.25);
  REQUIRE(m.count >= 1);
  double deepest = 0;
  for (int i = 0; i < m.count; ++i) deepest = std::max(deepest, m.points[i].depth);
  CHECK(deepest == 1);  // B moves right past A's end, 0.5 away, and by both radii
  CHECK(m.normal == Vector2<double>(1, 0));
}

TEST_CASE("an edge gives an end where its normal is off by more than a second point may have it") {
  const Core flat{{-4, 0}, {4, 0}};
  const Core tilted{{0, 0.75}, {2, 1}};
  CHECK(contact(flat, 1, tilted, 0.5).count == 2);
  CHECK(contact(flat, 1, tilted, 0.5, SecondPoint::never()).count == 1);
  const double angle = std::atan2(0.25, 2);
  CHECK(contact(flat, 1, tilted, 0.5, SecondPoint::within(1.01 * angle)).count == 2);
  CHECK(contact(flat, 1, tilted, 0.5, SecondPoint::within(0.99 * angle)).count == 1);
  CHECK(contact({{-1, 0}, {1, 0}}, 0.25, {{0.5, -3}, {0.5, 1}}, 0.25, SecondPoint::never()).count ==
        1);
}

TEST_CASE("round corners touch where they are nearest, and not where mitred ones would") {
  const auto box_at = [](double x, double y) {
    Core box = kBox;
    for (auto& corner : box) corner += Vector2<double>(x, y);
    return box;
  };
  CHECK(contact(kBox, 0.5, box_at(2.9, 2.9), 0.5).count == 0);  // corners 1.27 apart
  const auto m = contact(kBox, 0.5, box_at(2.6, 2.6), 0.5);
  REQUIRE(m.count >= 1);
  CHECK_THAT(m.normal.x(), WithinAbs(std::sqrt(0.5), 1e-15));
  CHECK_THAT(m.points[0].depth, WithinAbs(1 - 0.6 * std::sqrt(2), 1e-12));
}

TEST_CASE("a corner before a face is nearest where no two vertices are") {
  const auto box = make_polygon<double>(kBox);
  const auto above = make_polygon<double>(Core{{0.75, 1.5}, {3, 4}, {-3, 5}});
  const auto at_face = clipping::nearest_of_all(box, above, 0.0);
  CHECK(at_face.features.a == clipping::face(2));
  CHECK(at_face.features.b == clipping::vertex(0));
  CHECK(at_face.apart == Vector2<double>(0, 0.5));
  CHECK(clipping::nearest_of_all(above, box, 0.0).apart == Vector2<double>(0, -0.5));
  const auto beside = make_polygon<double>(Core{{1.75, 1.5}, {3, 4}, {2, 5}});
  const auto at_corner = clipping::nearest_of_all(box, beside, 0.0);
  CHECK(at_corner.features.a == clipping::vertex(2));
  CHECK(at_corner.apart == Vector2<double>(0.75, 0.5));
}

TEST_CASE("two vertices are off by how far the line between them leads along an edge") {
  const auto box = make_polygon<double>(kBox);
  const auto slip_to = [&](double x, double y) {
    const auto point = make_polygon<double>(Core{{x, y}});
    return clipping::slip_along_edges(box, point, clipping::between_vertices(box, 2, point, 0));
  };
  CHECK(slip_to(2, 3) == 0);
  CHECK(slip_to(0.75, 3) == 0.25);
  CHECK(slip_to(3, -0.5) == 1.5);
  CHECK(slip_to(3, -9) == 2);
}

TEST_CASE("a vertex off the line of a face is a misfit, along it is none") {
  auto box = make_polygon<double>(kBox);
  CHECK(clipping::misfit_of_faces(box) == 0);
  box.vertices[1].x() += 0.5;
  box.vertices[2].x() += 0.5;
  CHECK(clipping::misfit_of_faces(box) == 0);
  box.vertices[1].y() -= 0.25;
  CHECK(clipping::misfit_of_faces(box) == 0.25);
  CHECK(clipping::misfit_of_faces(make_polygon<double>(Core{{3, 4}})) == 0);
}

TEST_CASE("a face that placing has turned off its vertices is nearest, not a vertex far away") {
  // B's vertices were rounded to 64 after its normals were turned, so no face is on its line.
  auto a =
      make_polygon<float>(std::vector<Vector2<float>>{{0, 0}, {0, 2e-8F}}, 2e-6F, Rounding::round);
  auto b = make_polygon<float>(std::vector<Vector2<float>>{{64, 4492630}, {0, -3507370.25F}},
                               2.3e6F, Rounding::round);
  b.normals[0] = {-1, 1.4844725e-5F};
  b.normals[1] = -b.normals[0];
  const auto manifold = clipping::collide_in_frame(a, b);
  REQUIRE(manifold.count >= 1);
  CHECK(manifold.normal == b.normals[1]);
}
