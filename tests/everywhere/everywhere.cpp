// Hashes of all that must be the same on every machine: cases, manifolds, scenes, verdicts. A line
// each: what, of which regime, the hash. Takes what it needs on any machine, so no library but
// those of headers.

#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "collider/answer_hash.hpp"
#include "exact/truth.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "kernel/batch.hpp"
#include "kernel/target.hpp"
#include "own_colliders/own_colliders.hpp"
#include "scene/scene.hpp"

namespace manifuzz {

/// No engine is asked here.
std::vector<LedgerEntry> built_ledger() {
  return {};
}

namespace {

constexpr std::uint64_t kSeed = 1;

void print(std::string_view what, std::string_view regime, std::uint64_t hash) {
  std::printf("%.*s %.*s %016llx\n", static_cast<int>(what.size()), what.data(),
              static_cast<int>(regime.size()), regime.data(),
              static_cast<unsigned long long>(hash));
}

std::uint64_t bits_of(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

void add(Hash& hash, const Vector2<float>& v) {
  hash.add(bits_of(v.x()) << 32 | bits_of(v.y()));
}

void add(Hash& hash, const Pose<float>& pose) {
  add(hash, pose.position);
  add(hash, pose.rotation);
}

void add(Hash& hash, const PairCase& pair) {
  for (const Body* const body : {&pair.a, &pair.b}) {
    const ConvexPolygon<float>& polygon = body->polygon;
    hash.add(static_cast<std::uint64_t>(polygon.count));
    hash.add(bits_of(polygon.radius) << 8 | static_cast<std::uint64_t>(polygon.rounding));
    for (int i = 0; i < polygon.count; ++i) {
      add(hash, polygon.vertices[i]);
      add(hash, polygon.normals[i]);
    }
    add(hash, body->pose);
  }
}

std::vector<PairCase> cases_of(const Regime& regime, std::uint64_t count) {
  std::vector<PairCase> cases;
  for (std::uint64_t i = 0; i < count; ++i) cases.push_back(generate(kSeed, regime, i));
  return cases;
}

void hash_answers(const Collider& collider, const Regime& regime, std::span<const PairCase> cases) {
  Hash hash;
  for (const PairCase& pair : cases) add(hash, collider.collide(pair));
  print(collider.declaration.name, regime.name, hash.value());
}

/// All cases of a regime at once, from indices and packed, so that every lane is asked.
template <class Scalar>
void hash_batches(std::string_view what, const Regime& regime, std::span<const PairCase> cases) {
  kernel::Shapes<Scalar> shapes;
  std::vector<kernel::Placement<Scalar>> bodies;
  std::vector<kernel::BodyPair> pairs;
  for (const PairCase& pair : cases) {
    const auto placed = clipping::placed_pair<Scalar>(pair);
    const auto a = static_cast<std::uint32_t>(bodies.size());
    bodies.push_back({shapes.add(placed.a), placed.pose_a});
    bodies.push_back({shapes.add(placed.b), placed.pose_b});
    pairs.push_back({a, a + 1});
  }
  std::vector<Manifold<Scalar>> manifolds(pairs.size());
  kernel::collide_pairs(shapes, bodies, pairs, Scalar{0}, manifolds);
  Hash hash;
  for (const Manifold<Scalar>& one : manifolds) add(hash, manifold_cast<double>(one));
  const kernel::PackedPairs<Scalar> packed(shapes, bodies, pairs);
  std::vector<kernel::ManifoldBlock<Scalar>> blocks(packed.block_count());
  kernel::collide_packed(packed, Scalar{0}, blocks);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto column = static_cast<int>(i % kernel::kBlockPairs);
    add(hash, manifold_cast<double>(kernel::manifold(blocks[i / kernel::kBlockPairs], column)));
  }
  print(what, regime.name, hash.value());
}

/// For each case what the judge makes of two colliders, one of which is often wrong.
void hash_verdicts(const Regime& regime, std::span<const PairCase> cases) {
  const Collider subject = make_clip();
  const Collider oracle = make_gjk_shrunk();
  Hash hash;
  for (const PairCase& pair : cases) {
    const Judgement judgement = judge(pair, subject, oracle);
    const Bucket& bucket = judgement.bucket;
    for (const int part :
         {static_cast<int>(bucket.fault), static_cast<int>(bucket.verdict),
          static_cast<int>(bucket.kind), static_cast<int>(bucket.tie_class),
          static_cast<int>(bucket.reference), static_cast<int>(bucket.error_class)}) {
      hash.add(static_cast<std::uint64_t>(part));
    }
    hash.add(judgement.magnitude);
    hash.add(judgement.bound);
  }
  print("verdicts", regime.name, hash.value());
}

/// Shapes of every kind, about one across.
std::vector<ConvexPolygon<float>> shapes_of_every_kind() {
  std::vector<ConvexPolygon<float>> shapes;
  for (const char* const regime : {"boxes", "generic", "mixed_shapes"}) {
    for (const PairCase& pair : cases_of(*find_regime(regime), 16)) {
      shapes.push_back(pair.a.polygon);
    }
  }
  return shapes;
}

/// Bodies in a crowd, each on its way and turning; every contact of every step.
void hash_scene() {
  constexpr std::uint32_t kWidth = 12;
  constexpr int kSteps = 40;
  scene::Scene scene;
  std::vector<std::uint32_t> shapes;
  for (const ConvexPolygon<float>& polygon : shapes_of_every_kind()) {
    const auto added = scene.add_shape(polygon);
    if (const auto* const shape = std::get_if<std::uint32_t>(&added)) shapes.push_back(*shape);
  }
  Random random(kSeed, "scene of every kind", 0);
  std::vector<scene::Move> moves;
  std::vector<Vector2<float>> turns;
  for (std::uint32_t i = 0; i < kWidth * kWidth; ++i) {
    const Vector2<float> place(static_cast<float>(i % kWidth), static_cast<float>(i / kWidth));
    const Pose<float> pose{place, {1, 0}};
    const auto body = std::get<scene::BodyHandle>(scene.add(shapes[i % shapes.size()], pose));
    moves.push_back({body, pose});
    turns.push_back(unit_direction({1, random.uniform(-0.1, 0.1)}).cast<float>());
  }
  Hash hash;
  for (int step = 0; step < kSteps; ++step) {
    for (std::size_t i = 0; i < moves.size(); ++i) {
      Pose<float>& pose = moves[i].pose;
      const auto x = static_cast<float>(random.uniform(-0.05, 0.05));
      const auto y = static_cast<float>(random.uniform(-0.05, 0.05));
      pose.position += Vector2<float>(x, y);
      const Vector2<float> turned = rotate(pose.rotation, turns[i]);
      pose.rotation = unit_direction(turned.cast<double>()).cast<float>();
    }
    const auto stepped = scene.step(moves);
    const auto& result = std::get<scene::StepResult>(stepped);
    const scene::PairCounts& pairs = result.counts.pairs;
    hash.add(std::uint64_t{pairs.collided} << 32 | std::uint64_t{pairs.separated});
    for (const scene::Contact& contact : result.contacts) {
      hash.add(std::uint64_t{contact.a.index} << 32 | contact.b.index);
      add(hash, manifold_cast<double>(contact.manifold));
    }
  }
  print("scene", "every_kind", hash.value());
}

void hash_all(std::uint64_t count) {
  const std::array<Collider, 7> colliders{make_clip(),    make_clip64(), make_pair(), make_batch(),
                                          make_batch64(), make_gjk(),    make_gjk64()};
  for (const Regime& regime : regimes()) {
    const std::vector<PairCase> cases = cases_of(regime, count);
    Hash hash;
    for (const PairCase& pair : cases) add(hash, pair);
    print("cases", regime.name, hash.value());
    for (const Collider& collider : colliders) hash_answers(collider, regime, cases);
    hash_batches<float>("batches", regime, cases);
    hash_batches<double>("batches64", regime, cases);
    hash_verdicts(regime, cases);
  }
  hash_scene();
}

}  // namespace
}  // namespace manifuzz

int main(int count, char** words) {
  const std::vector<std::string> targets = manifuzz::kernel::targets();
  if (count == 2 && std::string_view(words[1]) == "--targets") {
    for (const std::string& target : targets) std::puts(target.c_str());
    return 0;
  }
  if (count > 2) {
    std::fputs("usage: everywhere [TARGET]|--targets\n", stderr);
    return 2;
  }
  manifuzz::kernel::use_target(count == 2 ? words[1] : targets.front());
  manifuzz::hash_all(200);
}
