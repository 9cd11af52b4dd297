#include "oracle/box2d/pairs.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <box2d/b2_broad_phase.h>
#include <box2d/b2_collision.h>

#include "oracle/box2d/shape.hpp"

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

void* as_data(std::uintptr_t body) {
  return reinterpret_cast<void*>(body);
}

}  // namespace

struct Box2dPairs::State {
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

Box2dPairs::Box2dPairs(std::span<const Body> bodies) : state_(std::make_unique<State>()) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    Placed& placed = state_->bodies.emplace_back();
    placed.shape = box2d::to_box2d(bodies[i].polygon);
    placed.transform = box2d::to_box2d(bodies[i].pose);
    placed.box = box_of(placed);
    placed.proxy = state_->broad_phase.CreateProxy(placed.box, as_data(i));
    placed.moved = true;
    state_->moved.push_back(static_cast<std::uint32_t>(i));
  }
}

Box2dPairs::~Box2dPairs() = default;

void Box2dPairs::step(std::span<const BodyMove> moves, bool skip_unmoved) {
  State& state = *state_;
  for (const BodyMove& move : moves) state.move(move);
  state.broad_phase.UpdatePairs(&state);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < state.pairs.size(); ++i) {
    Pair& pair = state.pairs[i];
    Placed& a = state.bodies[pair.a];
    Placed& b = state.bodies[pair.b];
    const bool is_active = a.moved || b.moved;
    if ((is_active || !skip_unmoved) && state.is_apart(pair)) continue;
    if (is_active || !skip_unmoved) {
      b2CollidePolygons(&pair.manifold, &a.shape, a.transform, &b.shape, b.transform);
    }
    if (kept != i) state.pairs[kept] = pair;
    ++kept;
  }
  state.pairs.resize(kept);
  for (const std::uint32_t body : state.moved) state.bodies[body].moved = false;
  state.moved.clear();
}

}  // namespace manifuzz
