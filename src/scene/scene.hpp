#pragma once

#include <variant>

#include "scene/broad_phase.hpp"
#include "scene/contacts.hpp"
#include "scene/pair_cache.hpp"

// The manifolds of a whole scene, step after step. Of the bodies that moved, in this order:
//
//   broad phase    those that left their fattened boxes find their candidate pairs afresh
//   pair cache     what is known of each candidate pair of a moved body
//   certificates   pairs proven to be separated still are skipped
//   batch kernel   the rest is collided
//
// A step's contacts are those of colliding every pair of bodies afresh, bit for bit; what did not
// move is not even looked at.

namespace manifuzz::scene {

/// The first move of a step that is refused, and why.
struct RefusedMove {
  std::size_t index = 0;
  Defect defect{};
};

class Scene {
 public:
  /// A face of B is taken only where it leads by more than `tie_bias` (a length, >= 0).
  explicit Scene(float tie_bias = 0) : tie_bias_(tie_bias), shapes_(tie_bias) {}

  // What is given a defect's value has changed nothing.

  /// The new shape's index. The polygon must be free of `PolygonDefect`s.
  std::variant<std::uint32_t, Defect> add_shape(const ConvexPolygon<float>& polygon);

  std::variant<BodyHandle, Defect> add(std::uint32_t shape, const Pose<float>& pose);
  std::optional<Defect> remove(BodyHandle body);
  std::optional<Defect> set_shape(BodyHandle body, std::uint32_t shape);

  /// Puts bodies where they are now and brings the contacts up to date. Of two moves of one body
  /// the last counts.
  std::variant<StepResult, RefusedMove> step(std::span<const Move> moves);

  /// Of a body that is in the scene.
  const Pose<float>& pose(BodyHandle body) const { return placements_[body.index].pose; }

  std::size_t body_count() const { return body_count_; }
  std::size_t pair_count() const { return pairs_.size(); }

  /// What bodies and pairs take, the shapes left out.
  std::size_t bytes() const;

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
  void drop_candidates(std::uint32_t body);
  void look_at_pairs();
  void look_at(std::uint32_t pair);
  void collide_waiting();
  void conclude(std::uint32_t pair, const Manifold<float>& manifold);
  void begin_contact(std::uint32_t pair);
  void end_contact(std::uint32_t pair);
  StepResult result();

  float tie_bias_;
  ShapeTable shapes_;
  std::size_t body_count_ = 0;
  std::vector<kernel::Placement<float>> placements_;  // by body
  std::vector<std::uint32_t> generations_;            // by body
  std::vector<std::uint32_t> free_;                   // bodies' places to be used again
  std::vector<Change> changes_;                       // by body
  std::vector<std::uint32_t> changed_;                // bodies, each once
  BroadPhase broad_phase_;
  PairCache pairs_;
  std::vector<Contact> contacts_;

  // Of the step under way.
  std::vector<std::uint32_t> waiting_;  // pairs for the kernel, and their bodies
  std::vector<kernel::BodyPair> waiting_bodies_;
  std::vector<Manifold<float>> manifolds_;
  StepCounts counts_;

  // What a step reports.
  std::vector<std::uint32_t> began_;
  std::vector<EndedContact> ended_;
  std::ptrdiff_t ended_reported_ = 0;  // by the last step; those behind wait for the next
};

}  // namespace manifuzz::scene
