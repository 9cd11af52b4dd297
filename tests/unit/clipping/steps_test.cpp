#include <catch2/catch.hpp>

#include "clipping/collide.hpp"
#include "unit/clipping/squares.hpp"

using namespace manifuzz;
using namespace manifuzz::clipping;
using namespace manifuzz::test;

namespace {

ConvexPolygon<float> moved(const ConvexPolygon<float>& p, float x, float y) {
  return transform<float>({{x, y}, {1, 0}}, p);
}

ClipEdge<float> edge(Vector2<float> from, Vector2<float> to) {
  return {{{from, face(0), vertex(3)}, {to, face(0), vertex(4)}}};
}

}  // namespace

TEST_CASE("a face separation is the distance of the deepest vertex") {
  const auto above = moved(square(), 0.25F, 2.5F);
  const auto top = face_separation(square(), 2, above);
  CHECK(top.separation == 0.5F);
  CHECK(above.vertices[top.deepest].y() == 1.5F);
  CHECK(face_separation(square(), 0, above).separation == -4.5F);
}

TEST_CASE("the greatest separation stops at the first face beyond the limit") {
  const auto far = moved(square(), 10, 20);
  const auto found = greatest_separation<float>(square(), far, 0);
  CHECK(found.face == 1);
  CHECK(found.separation == 8);
  CHECK(greatest_separation<float>(square(), far, 100).face == 2);
}

TEST_CASE("equal separations keep the first face") {
  CHECK(greatest_separation<float>(square(), square(), 0).face == 0);
}

TEST_CASE("the best edge takes the previous one of equals, as the article does") {
  const auto diamond = polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  CHECK(best_edge<float>(diamond, {0, 1}) == 1);
  CHECK(best_edge<float>(diamond, {0.1F, 0.9F}) == 1);
  CHECK(best_edge<float>(diamond, {-0.1F, 0.9F}) == 2);
}

TEST_CASE("the incident edge is the most opposed, the first of equals") {
  CHECK(incident_edge<float>(square(), {0, 1}) == 0);
  CHECK(incident_edge<float>(square(), {0.8F, 0.6F}) == 3);
  const auto diamond = polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  CHECK(incident_edge<float>(diamond, {0, 1}) == 0);
}

TEST_CASE("a clip keeps what lies ahead and replaces the end behind by the crossing") {
  auto e = edge({-1, 0}, {3, 2});
  REQUIRE(clip<float>(e, e, {1, 0}, {0, 0}, 0, 7, 5));
  CHECK(e[0].position == Vector2<float>(0, 0.5F));
  CHECK(e[0].reference == vertex(7));
  CHECK(e[0].incident == face(5));
  CHECK(e[1].position == Vector2<float>(3, 2));
  CHECK(e[1].incident == vertex(4));
}

TEST_CASE("a clip widened by a margin keeps that much more") {
  auto e = edge({-1, 0}, {3, 0});
  REQUIRE(clip<float>(e, e, {1, 0}, {0, 0}, 0.5F, 7, 5));
  CHECK(e[0].position == Vector2<float>(-0.5F, 0));
}

TEST_CASE("fewer than two points after a clip: the features do not overlap") {
  auto behind = edge({-2, 0}, {-1, 0});
  CHECK_FALSE(clip<float>(behind, behind, {1, 0}, {0, 0}, 0, 7, 5));
  auto touching = edge({-2, 0}, {0, 0});
  CHECK_FALSE(clip<float>(touching, touching, {1, 0}, {0, 0}, 0, 7, 5));
  auto on_the_line = edge({0, -2}, {0, 2});
  CHECK(clip<float>(on_the_line, on_the_line, {1, 0}, {0, 0}, 0, 7, 5));
}

TEST_CASE("offsets whose product underflows are still of opposite sign") {
  auto e = edge({-1e-30F, 0}, {1e-30F, 0});
  REQUIRE(clip<float>(e, e, {1, 0}, {0, 0}, 0, 7, 5));
  CHECK(e[0].position.x() == 0);
  CHECK(e[0].incident == face(5));
}

TEST_CASE("points in front of the face go, each of the others has its own depth") {
  const auto kept =
      keep_behind_face<float>(edge({0.5F, 0.75F}, {-0.5F, 1.25F}), square(), 2, Side::a, 0);
  REQUIRE(kept.count == 1);
  CHECK(kept.points[0].position == Vector2<float>(0.5F, 0.75F));
  CHECK(kept.points[0].depth == 0.25F);
}

TEST_CASE("a vertex alone, in a slab by rounding, gives way to a clip of a face that ties") {
  const auto a = polygon({{0, 0}, {17, -70}, {-19, 80}});
  const auto b = polygon({{0, 0}, {49.1F, -205.7F}, {0.0304F, 0.0072F}});
  const float roundoff = separation_roundoff(a, b);
  const auto of_b = face_separation(b, 1, a);
  const auto of_a = face_separation(a, 0, b);
  REQUIRE(of_b.separation > of_a.separation);
  REQUIRE(of_b.separation < of_a.separation + roundoff);
  const auto lone = contact_behind_face(a, b, Side::b, of_b, roundoff);
  CHECK_FALSE(lone.is_deep_clip);
  CHECK(lone.manifold.count == 1);
  const auto clipped = contact_behind_face(a, b, Side::a, of_a, roundoff);
  CHECK(clipped.is_deep_clip);
  CHECK(collide_in_frame(a, b).reference == Side::a);
  CHECK(find_deepest_contact(a, b).excess == 0);
}
