#include "report/departure/departure.hpp"

#include <functional>

#include <catch2/catch.hpp>

#include "own_colliders/own_colliders.hpp"

using namespace manifuzz;

namespace {

ConvexPolygon<float> shape_of(const std::vector<Vector2<float>>& vertices) {
  return make_polygon<float>(vertices);
}

/// A box of 4 by 2, and in its upper face, near the right end, the lower corner of a square that is
/// turned: A's right side plane
/// cuts B's edge 0, which slopes less than its edge 3.
PairCase tilted_on_box() {
  PairCase pair;
  pair.a.polygon = shape_of({{-2, -1}, {2, -1}, {2, 1}, {-2, 1}});
  pair.b.polygon = shape_of({{1, 0.5F}, {4, 1.25F}, {3.25F, 4.25F}, {0.25F, 3.5F}});
  return pair;
}

using Spoil = std::function<void(Manifold<double>& manifold)>;

std::optional<Departures> departures_after(const PairCase& pair, const Spoil& spoil) {
  const Collider clip = make_clip();
  Answer answer = clip.collide(pair);
  spoil(std::get<Manifold<double>>(answer));
  return departures_of(pair, {clip.declaration, answer});
}

std::string words_after(const Spoil& spoil) {
  const auto departures = departures_after(tilted_on_box(), spoil);
  REQUIRE(departures.has_value());
  return departures_in_words(*departures);
}

/// The manifold of the article's steps along A's upper face, of these points.
Manifold<double> on_upper_face(std::vector<ContactPoint<double>> points) {
  Manifold<double> manifold;
  manifold.reference = Side::a;
  manifold.normal = {0, 1};
  for (const auto& point : points) {
    manifold.points[static_cast<std::size_t>(manifold.count++)] = point;
  }
  return manifold;
}

constexpr Feature face_of(unsigned char index) {
  return {Feature::Kind::face, index};
}
constexpr Feature vertex_of(unsigned char index) {
  return {Feature::Kind::vertex, index};
}

}  // namespace

TEST_CASE("a right answer departs nowhere") {
  CHECK_FALSE(departures_after(tilted_on_box(), [](Manifold<double>&) {}).has_value());
}

TEST_CASE("the clip of another edge departs at the incident edge") {
  PairCase pair = tilted_on_box();
  pair.a.polygon = shape_of({{-2, -3}, {2, -3}, {2, 1}, {-2, 1}});
  pair.b.polygon = shape_of({{0, 0}, {1.5F, 0.5F}, {-1, 0.75F}});
  const auto departures = departures_after(pair, [](Manifold<double>& manifold) {
    manifold = on_upper_face(
        {{{0, 0}, 1, {face_of(2), vertex_of(0)}}, {{-1, 0.75}, 0.25, {face_of(2), vertex_of(2)}}});
  });
  REQUIRE(departures.has_value());
  CHECK(departures_in_words(*departures) ==
        "It departs at the incident edge: with B's edge 2 in place of edge 0 the clip gives this "
        "answer.");
}

TEST_CASE("an end that is not clipped departs at the clip of its side plane") {
  PairCase pair = tilted_on_box();
  pair.a.polygon = shape_of({{-2, -3}, {2, -3}, {2, 1}, {-2, 1}});
  pair.b.polygon = shape_of({{0, -0.5F}, {3, 0}, {0, 3}});
  const auto departures = departures_after(pair, [](Manifold<double>& manifold) {
    manifold = on_upper_face(
        {{{3, 0}, 1, {face_of(2), vertex_of(1)}}, {{0, -0.5}, 1.5, {face_of(2), vertex_of(0)}}});
  });
  REQUIRE(departures.has_value());
  CHECK(departures_in_words(*departures) ==
        "It departs at clip 1: with the side plane at A's vertex 2 left out the clip gives this "
        "answer.");
}

TEST_CASE("a normal from B to A departs at the reference edge") {
  CHECK(words_after([](Manifold<double>& manifold) { manifold.normal = -manifold.normal; }) ==
        "It departs at the reference edge: with the normal not turned to point from A to B the "
        "clip gives this answer.");
}

TEST_CASE("swapped depths depart at the depth") {
  CHECK(words_after([](Manifold<double>& manifold) {
          std::swap(manifold.points[0].depth, manifold.points[1].depth);
        }) ==
        "It departs at the depth: with the depths of the two points swapped the clip gives this "
        "answer.");
}

TEST_CASE("midpoints depart at the points' places") {
  CHECK(words_after([](Manifold<double>& manifold) {
          for (int i = 0; i < manifold.count; ++i) {
            manifold.points[i].position += manifold.normal * (manifold.points[i].depth / 2);
          }
        }) ==
        "It departs at the points' places: with each point halfway between incident and reference "
        "edge the clip gives this answer.");
}

TEST_CASE("a lost point may depart at more than one clip, and features tell them apart") {
  CHECK(words_after([](Manifold<double>& manifold) { manifold.count = 1; }) ==
        "One of these changes alone gives this answer: at clip 1, with the side plane at A's "
        "vertex 2 facing the other way; at clip 2, with the side plane at A's vertex 3 moved to "
        "A's vertex 1; at clip 3 (behind the reference edge), with an end removed that lies behind "
        "the reference edge.");
}

TEST_CASE("an answer that no single step gives is told how far it agrees") {
  CHECK(words_after([](Manifold<double>& manifold) { manifold.points[1].position.x() -= 0.125; }) ==
        "No single step done otherwise gives this answer. The normal is right, that of A's face 2. "
        "Point 1 is right. Point 2 is at no clip of any edge.");
}

TEST_CASE("an answer whose names alone are wrong agrees at every step") {
  CHECK(words_after([](Manifold<double>& manifold) { manifold.reference = Side::b; }) ==
        "Every step agrees: all figures are right, and only the reference side or the features "
        "that it names are not.");
}
