#pragma once

#include <variant>

#include "scene/body.hpp"
#include "scene/broad_phase.hpp"
#include "scene/pair_cache.hpp"

// The manifolds of a whole scene, step after step. Of the bodies that moved, in this order:
//
//   broad phase    those that left their fattened boxes find their candidate pairs afresh
//   pair cache     what is known of each candidate pair of a moved body
//   certificates   pairs proven to be separated still are skipped
//   batch kernel   the rest is collided
//
// A step's contacts are those of colliding every pair of bodies afresh, bit for bit, unless they
// are asked to be recycled; what did not move is not even looked at.

/// Whole scenes, step after step.
namespace manifuzz::scene {

/// The first move of a step that is refused, and why.
struct RefusedMove {
  std::size_t index = 0;  ///< among the moves of the step
  Defect defect{};        ///< why
};

/// What holds for all pairs of a scene.
struct Settings {
  /// A face of B is taken only where it leads by more than this (a length, >= 0).
  float tie_bias = 0;
  /// Pairs that touch keep their contact, carried along rigidly, until a vertex has moved by this,
  /// seen from the other body (a length). 0 is strict: the same bits as colliding them afresh.
  float recycled_motion = 0;
  /// Pairs are proven separated, and then skipped. Off, all pairs that moved are collided: the same
  /// contacts, sooner where nothing stays proven for long.
  bool certificates = true;
};

/// The first defect of settings, or none.
std::optional<Defect> find_defect(const Settings& settings);

/// What a scene takes.
struct Memory {
  std::size_t bodies = 0;  ///< bytes
  std::size_t pairs = 0;   ///< bytes, of contacts and of those that wait for the kernel too
};

/// Bodies that come, go and move, and the contacts between them, step after step. What it refuses,
/// giving a `Defect`, has changed nothing.
class Scene {
 public:
  /// The settings must be free of defects.
  explicit Scene(const Settings& settings = {});

  /// The new shape's index. The polygon must be free of `PolygonDefect`s.
  std::variant<std::uint32_t, Defect> add_shape(const ConvexPolygon<float>& polygon);

  /// A new body, of a shape that was added, at a pose in the world; the next step looks at it.
  std::variant<BodyHandle, Defect> add(std::uint32_t shape, const Pose<float>& pose);
  /// Takes a body out; its contacts are reported as ended by the next step.
  std::optional<Defect> remove(BodyHandle body);
  /// Gives a body another shape, which the next step looks at.
  std::optional<Defect> set_shape(BodyHandle body, std::uint32_t shape);

  /// Puts bodies where they are now and brings the contacts up to date. Of two moves of one body
  /// the last counts.
  std::variant<StepResult, RefusedMove> step(std::span<const Move> moves);

  /// Where a body stands in the world, as of the last step; it must be in the scene.
  const Pose<float>& pose(BodyHandle body) const { return placements_[body.index].pose; }

  /// How many bodies are in the scene.
  std::size_t body_count() const { return body_count_; }
  /// How many pairs of bodies are candidates.
  std::size_t pair_count() const { return pairs_.size(); }

  /// What it takes, the shapes left out.
  Memory memory() const;

 private:
  enum Change : std::uint8_t { kUnchanged, kChanged, kLeftBox };

  bool is_known(BodyHandle body) const {
    return body.index < generations_.size() && generations_[body.index] == body.generation &&
           body.generation % 2 == 1;
  }
  BodyHandle handle(std::uint32_t index) const { return {index, generations_[index]}; }
  void mark_changed(std::uint32_t body);
  void place(const Move& move);

  void find_candidates();
  void find_partners(std::uint32_t body);
  /// Of a body, those with bodies for which `is_gone(other)`. Returns how many.
  template <class IsGone>
  std::size_t drop_pairs(std::uint32_t body, const IsGone& is_gone);
  void look_at_pairs();
  void look_at_touching(std::uint32_t pair);
  void look_at_apart(std::uint32_t pair);
  bool is_proven(std::uint32_t pair) const;
  void wait(std::uint32_t pair);
  void collide_waiting();
  Pose<float> b_in_a(const kernel::BodyPair& bodies) const {
    return relative_pose(placements_[bodies.a].pose, placements_[bodies.b].pose);
  }
  void keep_for_recycling(std::uint32_t pair);
  void recycle(std::uint32_t pair);
  void conclude(std::uint32_t pair, const Manifold<float>& manifold);
  void begin_and_end();
  void begin_contact(const Contact& contact);
  /// The pair's new index.
  std::uint32_t end_contact(std::uint32_t pair);
  StepResult result();

  Settings settings_;
  ShapeTable shapes_;
  std::size_t body_count_ = 0;
  std::vector<kernel::Placement<float>> placements_;  // by body
  std::vector<std::uint32_t> generations_;            // by body
  std::vector<std::uint32_t> free_;                   // bodies' places to be used again
  std::vector<Change> changes_;                       // by body
  std::vector<std::uint32_t> changed_;                // bodies, each once
  std::vector<std::uint64_t> known_in_;               // by body: the last search that knew it
  std::uint64_t search_ = 0;
  BroadPhase broad_phase_;
  PairCache pairs_;
  std::vector<Contact> contacts_;          // by pair, of those that touch
  std::vector<Manifold<float>> collided_;  // likewise, as the kernel gave them; unless strict

  // Of the step under way.
  std::vector<std::uint32_t> waiting_;  // pairs for the kernel, and their bodies
  std::vector<kernel::BodyPair> waiting_bodies_;
  std::vector<Manifold<float>> manifolds_;
  std::vector<Contact> beginning_;
  std::vector<kernel::BodyPair> ending_;
  std::vector<std::uint32_t> gone_;  // bodies whose pairs with another are dropped
  StepCounts counts_;

  // What a step reports.
  std::vector<std::uint32_t> began_;
  std::vector<EndedContact> ended_;
  std::ptrdiff_t ended_reported_ = 0;  // by the last step; those behind wait for the next
};

template <class IsGone>
std::size_t Scene::drop_pairs(std::uint32_t body, const IsGone& is_gone) {
  gone_.clear();
  pairs_.each_of(body, [&](std::uint32_t, std::uint32_t other) {
    if (is_gone(other)) gone_.push_back(other);
  });
  for (const std::uint32_t other : gone_) {
    const std::uint32_t pair = pairs_.find(body, other);
    pairs_.remove(pair < pairs_.touching() ? end_contact(pair) : pair);
  }
  return gone_.size();
}

}  // namespace manifuzz::scene
