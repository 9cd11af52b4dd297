#include "oracle/box2d/box2d.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_broad_phase.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_common.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_world.h>

#include "oracle/box2d/round_shapes.hpp"
#include "oracle/box2d/snippet.hpp"

namespace manifuzz {
namespace {

struct Placed {
  b2PolygonShape shape;
  b2Transform transform;
  b2AABB box;
  int proxy = b2BroadPhase::e_nullProxy;
  bool moved = false;
  std::vector<std::uint32_t> partners;  ///< in pairs
};

struct Pair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  b2Manifold manifold;
};

b2AABB box_of(const Placed& body) {
  b2AABB box;
  body.shape.ComputeAABB(&box, body.transform, 0);
  return box;
}

/// What Box2D gives back with a proxy is a pointer, here a number.
void* as_data(std::uintptr_t body) {
  return reinterpret_cast<void*>(body);  // NOLINT(performance-no-int-to-ptr)
}

/// What the broad phase tells of, and what is told it.
struct PairsState {
  std::vector<Placed> bodies;
  std::vector<std::uint32_t> moved;  ///< bodies, since the last step
  std::vector<Pair> pairs;
  b2BroadPhase broad_phase;

  /// Called by the broad phase for pairs whose fattened boxes overlap, those known already too.
  void AddPair(void* data_a, void* data_b) {
    const auto a = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(data_a));
    const auto b = static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(data_b));
    const bool fewer_of_a = bodies[a].partners.size() < bodies[b].partners.size();
    const auto& known = bodies[fewer_of_a ? a : b].partners;
    if (std::ranges::find(known, fewer_of_a ? b : a) != known.end()) return;
    bodies[a].partners.push_back(b);
    bodies[b].partners.push_back(a);
    pairs.push_back({std::min(a, b), std::max(a, b), {}});
  }

  void move(const BodyMove& move) {
    Placed& body = bodies[move.body];
    body.transform = box2d::to_box2d(move.pose);
    if (!std::exchange(body.moved, true)) moved.push_back(move.body);
    const b2AABB before = body.box;
    body.box = box_of(body);
    b2AABB swept;
    swept.Combine(before, body.box);
    broad_phase.MoveProxy(body.proxy, swept, body.box.GetCenter() - before.GetCenter());
  }

  bool is_apart(const Pair& pair) {
    if (broad_phase.TestOverlap(bodies[pair.a].proxy, bodies[pair.b].proxy)) return false;
    std::erase(bodies[pair.a].partners, pair.b);
    std::erase(bodies[pair.b].partners, pair.a);
    return true;
  }
};

class Box2dPairs final : public ScenePairs {
 public:
  explicit Box2dPairs(std::span<const Body> bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      Placed& placed = state_.bodies.emplace_back();
      placed.shape = box2d::to_box2d(bodies[i].polygon);
      placed.transform = box2d::to_box2d(bodies[i].pose);
      placed.box = box_of(placed);
      placed.proxy = state_.broad_phase.CreateProxy(placed.box, as_data(i));
      placed.moved = true;
      state_.moved.push_back(static_cast<std::uint32_t>(i));
    }
  }

  void step(std::span<const BodyMove> moves, bool skip_unmoved) override {
    for (const BodyMove& move : moves) state_.move(move);
    state_.broad_phase.UpdatePairs(&state_);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < state_.pairs.size(); ++i) {
      Pair& pair = state_.pairs[i];
      Placed& a = state_.bodies[pair.a];
      Placed& b = state_.bodies[pair.b];
      const bool is_active = a.moved || b.moved;
      if ((is_active || !skip_unmoved) && state_.is_apart(pair)) continue;
      if (is_active || !skip_unmoved) {
        b2CollidePolygons(&pair.manifold, &a.shape, a.transform, &b.shape, b.transform);
      }
      if (kept != i) state_.pairs[kept] = pair;
      ++kept;
    }
    state_.pairs.resize(kept);
    for (const std::uint32_t body : state_.moved) state_.bodies[body].moved = false;
    state_.moved.clear();
  }

 private:
  PairsState state_;
};

b2Body* add(b2World& world, const WorldBody& from) {
  b2BodyDef definition;
  definition.type = from.is_fixed ? b2_staticBody : b2_dynamicBody;
  definition.position = box2d::to_box2d(from.body.pose.position);
  definition.angle = std::atan2(from.body.pose.rotation.y(), from.body.pose.rotation.x());
  b2Body* const body = world.CreateBody(&definition);
  const b2PolygonShape shape = box2d::to_box2d(from.body.polygon);
  b2FixtureDef fixture;
  fixture.shape = &shape;
  fixture.density = 1;
  fixture.friction = 0.5F;
  body->CreateFixture(&fixture);
  return body;
}

}  // namespace

std::unique_ptr<ScenePairs> box2d_pairs(std::span<const Body> bodies) {
  return std::make_unique<Box2dPairs>(bodies);
}

std::vector<std::vector<Pose<float>>> box2d_trajectory(std::span<const WorldBody> bodies, int steps,
                                                       const GravityTurn& gravity_turn) {
  Vector2<double> gravity(0, -10);
  b2World world(box2d::to_box2d(Vector2<float>(gravity.cast<float>())));
  std::vector<b2Body*> added;
  for (const WorldBody& body : bodies) added.push_back(add(world, body));
  std::vector<std::vector<Pose<float>>> trajectory;
  for (int i = 0; i < steps; ++i) {
    world.Step(1.0F / 60, 8, 3);
    const bool begins_to_turn = i == gravity_turn.first_step && gravity_turn.by.y() != 0;
    if (begins_to_turn) world.SetAllowSleeping(false);  // which wakes all: gravity wakes none
    if (i >= gravity_turn.first_step) gravity = rotate(gravity_turn.by, gravity);
    world.SetGravity(box2d::to_box2d(Vector2<float>(gravity.cast<float>())));
    std::vector<Pose<float>>& poses = trajectory.emplace_back();
    for (const b2Body* const body : added) {
      const b2Transform& at = body->GetTransform();
      poses.push_back({{at.p.x, at.p.y}, {at.q.c, at.q.s}});
    }
  }
  return trajectory;
}

using box2d::to_box2d;

namespace {

Vector2<double> from_box2d(const b2Vec2& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

Feature to_feature(uint8 type, uint8 index) {
  return {type == b2ContactFeature::e_face ? Feature::Kind::face : Feature::Kind::vertex, index};
}

/// A direction of the reference body as the unit normal from A to B in A's frame.
Vector2<double> normal_in_a(const PairCase& pair, Side reference, const b2Vec2& direction) {
  const Vector2<double> normal = from_box2d(direction);
  if (reference == Side::a) return normal;
  const Vector2<double> rotation_b = pair.b.pose.rotation.cast<double>();
  return -local_normal(pair, rotate(rotation_b, normal), rotation_b.norm());
}

/// A local point of the incident body in A's frame.
Vector2<double> point_in_a(const PairCase& pair, Side reference, const b2Vec2& local_point) {
  const Vector2<double> point = from_box2d(local_point);
  if (reference == Side::b) return point;
  const Vector2<double> apart =
      pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
  const Vector2<double> from_a = rotate<double>(pair.b.pose.rotation.cast<double>(), point) + apart;
  return rotate_inverse<double>(pair.a.pose.rotation.cast<double>(), from_a);
}

Answer collide(const PairCase& pair) {
  if (is_round(pair)) return box2d::collide_round(pair);
  const b2PolygonShape shape_a = to_box2d(pair.a.polygon);
  const b2PolygonShape shape_b = to_box2d(pair.b.polygon);
  const b2Transform transform_a = to_box2d(pair.a.pose);
  const b2Transform transform_b = to_box2d(pair.b.pose);
  b2Manifold found;
  b2CollidePolygons(&found, &shape_a, transform_a, &shape_b, transform_b);
  if (found.pointCount == 0) return Manifold<double>{};  // its other fields are then unset

  b2WorldManifold world;
  world.Initialize(&found, transform_a, shape_a.m_radius, transform_b, shape_b.m_radius);
  Manifold<double> manifold;
  manifold.count = found.pointCount;
  manifold.reference = found.type == b2Manifold::e_faceA ? Side::a : Side::b;
  manifold.normal = normal_in_a(pair, manifold.reference, found.localNormal);
  for (int i = 0; i < found.pointCount; ++i) {
    const b2ContactFeature& feature = found.points[i].id.cf;
    manifold.points[i] = {
        point_in_a(pair, manifold.reference, found.points[i].localPoint),
        std::max(0.0, -static_cast<double>(world.separations[i])),
        {to_feature(feature.typeA, feature.indexA), to_feature(feature.typeB, feature.indexB)}};
  }
  order_points(manifold);
  return manifold;
}

}  // namespace

Collider make_box2d() {
  Collider collider;
  collider.declaration = {
      .name = "box2d",
      .version = MANIFUZZ_BOX2D_VERSION,  // b2_version still says 2.4.0
      .description = "Box2D's b2Collide functions on shapes filled from the stored floats",
      .scalar = ScalarType::float32,
      .frame = RoundingFrame::world,
      .tie_bias = {static_cast<double>(0.1f * b2_linearSlop)},
      .max_vertices = b2_maxPolygonVertices,
      .takes_radius = true,
      .min_vertices = 1,
      .takes_round = true,
      .snippet = box2d::kSnippet};
  collider.collide = collide;
  collider.takes = box2d::takes_round;
  return collider;
}

std::function<void()> box2d_pass(std::span<const PairCase> pairs) {
  const auto is_of_round = [](const PairCase& pair) { return is_round(pair); };
  if (std::ranges::any_of(pairs, is_of_round)) return box2d::round_pass(pairs);
  struct Prepared {
    b2PolygonShape shapes[2];
    b2Transform transforms[2];
    b2Manifold found;
  };
  const auto all = std::make_shared<std::vector<Prepared>>();
  for (const PairCase& pair : pairs) {
    all->push_back({{to_box2d(pair.a.polygon), to_box2d(pair.b.polygon)},
                    {to_box2d(pair.a.pose), to_box2d(pair.b.pose)},
                    {}});
  }
  return [all] {
    for (auto& [shapes, transforms, found] : *all) {
      b2CollidePolygons(&found, &shapes[0], transforms[0], &shapes[1], transforms[1]);
    }
  };
}

}  // namespace manifuzz
