#include "scene/faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>
#include <rapidcheck.h>

#include "kernel/batch.hpp"
#include "unit/kernel/every_target.hpp"
#include "unit/scene/model.hpp"
#include "unit/scene/motion.hpp"

// What a face that lay between two bodies proves of them: that the kernel finds no contact.

using namespace manifuzz;
using scene::FaceBetween;

namespace {

constexpr int kPairsMax = 40;

const scene::ShapeTable& shapes() {
  static const scene::ShapeTable table = [] {
    scene::ShapeTable all(0);
    for (const auto& shape : test::shapes_for_scenes()) all.add(shape);
    all.add(rounded(box(0.02, 0.02), 0.3F).value());  // hardly more than skin, it turns at no cost
    return all;
  }();
  return table;
}

/// FacedPairs that lie about as far from each other as they reach, and all that is asked of them.
struct FacedPairs {
  std::vector<kernel::Placement<float>> placements;
  std::vector<float> paths;
  std::vector<scene::Candidate> candidates;
  scene::Queue queue;

  std::vector<kernel::BodyPair> pairs() const {
    std::vector<kernel::BodyPair> all;
    for (std::size_t i = 0; i < queue.count; ++i) all.push_back(queue.bodies(i));
    return all;
  }
  std::vector<Manifold<float>> collided() const {
    std::vector<Manifold<float>> manifolds(queue.count);
    kernel::collide_pairs(shapes().for_pairs(), placements, pairs(), 0, manifolds);
    return manifolds;
  }
  /// What the faces that the candidates name prove.
  std::vector<std::uint32_t> proven() const {
    std::vector<std::uint32_t> known(queue.count + scene::kPairLanes);
    scene::prove_by_faces({&shapes().for_pairs().corners(0), &shapes().rows(0), &shapes().facts(0),
                           placements.data(), paths.data(), candidates.data()},
                          queue, 0, queue.count, known.data());
    known.resize(queue.count);
    return known;
  }
};

kernel::Placement<float> any_body(Random& random) {
  const int last = static_cast<int>(shapes().size()) - 1;
  const int shape = random.chance(0.3) ? last : random.integer(0, last);
  return {static_cast<std::uint32_t>(shape), test::anywhere(random.bits())};
}

/// The second one beside the first: touching, hardly apart, or apart.
kernel::Placement<float> beside(const kernel::Placement<float>& body, Random& random) {
  kernel::Placement<float> other = any_body(random);
  const float reach = shapes().facts(body.shape).extent() + shapes().facts(other.shape).extent();
  const auto share = static_cast<float>(random.uniform(0.1, 1.6));
  other.pose.position = body.pose.position + share * reach * random_direction(random).cast<float>();
  return other;
}

FacedPairs any_pairs(std::uint64_t seed) {
  Random random = test::motion(seed);
  FacedPairs some;
  const int count = random.integer(1, kPairsMax);
  some.queue.make_room_for(kPairsMax);
  for (int i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint32_t>(some.placements.size());
    some.placements.push_back(any_body(random));
    some.placements.push_back(beside(some.placements.back(), random));
    for (int body = 0; body < 2; ++body) {
      some.paths.push_back(static_cast<float>(random.uniform(1e-3, 4)));
    }
    some.candidates.emplace_back(a + 1);
    some.candidates.back().know(FaceBetween::kKnown |
                                static_cast<std::uint32_t>(random.integer(0, 15)));
    some.queue.push({a, a + 1}, static_cast<std::uint32_t>(i));
  }
  return some;
}

/// Where pairs have no contact, the candidates name the face that the kernel does.
void name_faces(FacedPairs& pairs) {
  const auto manifolds = pairs.collided();
  for (std::size_t i = 0; i < manifolds.size(); ++i) {
    if (manifolds[i].count > 0) continue;
    const FaceBetween face(manifolds[i].points[0].features);
    pairs.candidates[i].know(scene::apart_until(0, face));
  }
}

const ConvexPolygon<float>& shape_of(const FacedPairs& pairs, std::uint32_t body) {
  return shapes().for_pairs().polygon(pairs.placements[body].shape);
}

/// How far the core of one body of a pair lies in front of a face of the other, in double.
double separation(const FacedPairs& pairs, std::size_t i, bool is_of_b, int face) {
  const auto [a, b] = pairs.queue.bodies(i);
  const std::uint32_t near = is_of_b ? b : a;
  const std::uint32_t far = is_of_b ? a : b;
  const auto pose = [&](std::uint32_t body) {
    const Pose<float>& of = pairs.placements[body].pose;
    return Pose<double>{of.position.cast<double>(), of.rotation.cast<double>()};
  };
  const Vector2<double> normal =
      rotate<double>(pose(near).rotation, shape_of(pairs, near).normals[face].cast<double>());
  const Vector2<double> first =
      transform<double>(pose(near), shape_of(pairs, near).vertices[face].cast<double>());
  double least = std::numeric_limits<double>::infinity();
  for (const auto& corner : shape_of(pairs, far).corners()) {
    const Vector2<double> vertex = transform<double>(pose(far), corner.cast<double>());
    least = std::min(least, normal.dot(vertex - first));
  }
  return least;
}

/// That of all faces of both.
double greatest_separation(const FacedPairs& pairs, std::size_t i) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (const bool is_of_b : {false, true}) {
    const auto [a, b] = pairs.queue.bodies(i);
    for (int face = 0; face < shape_of(pairs, is_of_b ? b : a).face_count(); ++face) {
      greatest = std::max(greatest, separation(pairs, i, is_of_b, face));
    }
  }
  return greatest;
}

Pose<float> turned_by(double length, const kernel::Placement<float>& body, Random& random) {
  const auto reach = static_cast<double>(shapes().facts(body.shape).reach);
  const Vector2<double> turn = turn_by(random.either_sign(length / std::max(reach, 1e-3)));
  Pose<float> pose = body.pose;
  pose.rotation = unit(rotate<double>(turn, pose.rotation.cast<double>())).cast<float>();
  return pose;
}

Pose<float> shifted_by(double length, const kernel::Placement<float>& body,
                       const Vector2<float>& towards) {
  Pose<float> pose = body.pose;
  pose.position += (length * unit((towards - pose.position).cast<double>().eval())).cast<float>();
  return pose;
}

/// How much longer the sum of a pair's paths may get.
double path_left(const FacedPairs& pairs, std::size_t i, std::uint32_t proven) {
  const auto [a, b] = pairs.queue.bodies(i);
  return static_cast<double>(std::bit_cast<float>(proven)) -
         static_cast<double>(pairs.paths[a] + pairs.paths[b]);
}

/// Turns both bodies of each pair that is proven apart, and then moves one towards the other,
/// together nearly as far as that allows.
void move_within(FacedPairs& pairs, const std::vector<std::uint32_t>& proven, Random& random) {
  for (std::size_t i = 0; i < proven.size(); ++i) {
    const std::uint32_t a = pairs.queue.a[i];
    const std::uint32_t b = pairs.queue.b[i];
    const auto go = [&](std::uint32_t body, const Pose<float>& to) {
      auto& [shape, pose] = pairs.placements[body];
      const float path = scene::next_float(
          pairs.paths[body] + scene::displacement(pose, to, shapes().facts(shape).reach));
      scene::Candidate candidate(b);
      candidate.know(proven[i]);
      if (!candidate.is_apart(path + pairs.paths[a + b - body])) return;
      pairs.paths[body] = path;
      pose = to;
    };
    for (const std::uint32_t body : {a, b}) {
      const double length = random.uniform(0, 0.5) * path_left(pairs, i, proven[i]);
      if (length > 0) go(body, turned_by(length, pairs.placements[body], random));
    }
    for (const double share : {0.9, 0.9, 0.9}) {  // a path is longer than what was gone
      const double length = share * path_left(pairs, i, proven[i]);
      if (length > 0)
        go(a, shifted_by(length, pairs.placements[a], pairs.placements[b].pose.position));
    }
  }
}

}  // namespace

TEST_CASE("bodies between which a face lies have no contact, now and until their paths say so") {
  CHECK(rc::check("any face of any two shapes", [](std::uint64_t seed) {
    FacedPairs pairs = any_pairs(seed);
    Random random = test::motion(seed + 1);
    if (random.chance(0.5)) name_faces(pairs);
    const std::vector<std::uint32_t> proven = pairs.proven();
    const auto complain = [&](const char* when) {
      const auto manifolds = pairs.collided();
      for (std::size_t i = 0; i < proven.size(); ++i) {
        if (proven[i] != 0 && manifolds[i].count > 0) RC_FAIL(when);
      }
    };
    complain("they touch now");
    move_within(pairs, proven, random);
    complain("they touch too soon");
  }));
}

TEST_CASE("the kernel names the face that separates a pair without contact most") {
  CHECK(rc::check("of any two shapes, but for circles", [](std::uint64_t seed) {
    FacedPairs pairs = any_pairs(seed);
    name_faces(pairs);
    const auto manifolds = pairs.collided();
    for (std::size_t i = 0; i < manifolds.size(); ++i) {
      if (manifolds[i].count > 0) continue;
      const auto [a, b] = pairs.queue.bodies(i);
      const bool has_circle =
          shape_of(pairs, a).face_count() == 0 || shape_of(pairs, b).face_count() == 0;
      const FaceBetween face(pairs.candidates[i].known());
      const bool is_known = face.bits() != 0;
      RC_ASSERT(is_known || has_circle);
      if (!is_known) continue;
      const double named = separation(pairs, i, face.is_of_b(), static_cast<int>(face.index()));
      RC_ASSERT(named > greatest_separation(pairs, i) - 1e-5);
    }
  }));
}

TEST_CASE("a face that separates by more than the clearances proves that, now and from now on") {
  CHECK(rc::check("any face of any two shapes", [](std::uint64_t seed) {
    FacedPairs pairs = any_pairs(seed);
    Random random = test::motion(seed + 1);
    if (random.chance(0.5)) name_faces(pairs);
    const std::vector<std::uint32_t> proven = pairs.proven();
    for (std::size_t i = 0; i < proven.size(); ++i) {
      const FaceBetween face(pairs.candidates[i].known());
      const auto [a, b] = pairs.queue.bodies(i);
      const int faces = shape_of(pairs, face.is_of_b() ? b : a).face_count();
      if (static_cast<int>(face.index()) >= faces) continue;
      const double separates =
          0.99 * separation(pairs, i, face.is_of_b(), static_cast<int>(face.index())) - 1e-3;
      const auto& of_a = shapes().facts(pairs.placements[a].shape);
      const auto& of_b = shapes().facts(pairs.placements[b].shape);
      if (separates > static_cast<double>(of_a.clearance_now + of_b.clearance_now)) {
        RC_ASSERT(proven[i] != 0);
      }
      const double margin = separates - static_cast<double>(of_a.clearance + of_b.clearance);
      if (margin > 0) RC_ASSERT(path_left(pairs, i, proven[i]) > 0.9 * margin);
    }
  }));
}

TEST_CASE("what faces prove is the same on every instruction set") {
  std::vector<std::vector<std::uint32_t>> first;
  test::on_every_target([&] {
    std::vector<std::vector<std::uint32_t>> all;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      FacedPairs pairs = any_pairs(seed);
      name_faces(pairs);
      all.push_back(pairs.proven());
    }
    if (first.empty()) first = all;
    CHECK(all == first);
  });
}

TEST_CASE("a face and a length share a number") {
  CHECK(rc::check("the length is rounded down, the face stays", [](std::uint32_t number) {
    const float length = std::bit_cast<float>(number & 0x7fffffffU);
    const auto face = FaceBetween(number >> 3);
    if (!std::isfinite(length)) return;
    const std::uint32_t known = scene::apart_until(length, face);
    RC_ASSERT(FaceBetween(known).bits() == face.bits());
    const float until = std::bit_cast<float>(known);
    constexpr float kShortest = std::numeric_limits<float>::min();
    RC_ASSERT(until <= std::max(length, kShortest));
    RC_ASSERT(length < kShortest || until >= length * (1 - 8e-6F));
  }));
}
