#pragma once

#include <bit>
#include <unordered_map>
#include <variant>

#include "afresh/cells.hpp"
#include "scene/body.hpp"
#include "scene/candidates.hpp"
#include "scene/division.hpp"
#include "scene/large_pages.hpp"
#include "scene/parts.hpp"
#include "scene/settings.hpp"
#include "scene/state.hpp"
#include "scene/work.hpp"

// The manifolds of a whole scene, step after step. Of the bodies that moved, in this order:
//
//   cells          those that left their fattened boxes find their candidate pairs
//   candidates     pairs proven to be apart for so long are skipped, and those whose boxes are
//   kernel         the rest is collided
//
// A step's contacts are those of colliding every pair of bodies afresh, bit for bit, unless they
// are asked to be recycled; what did not move is not even looked at.

/// Whole scenes, step after step.
namespace manifuzz::scene {

/// Bodies that come, go and move, and the contacts between them, step after step. What it refuses,
/// giving a `Defect`, has changed nothing. Where memory runs out, calls throw std::bad_alloc, and
/// have changed nothing either, but for two: `step` may have placed some moves, `set_filter` may
/// have set the filter, and they have forgotten all contacts. The next step tells of those that
/// there are as begun, and of none before as ended.
class Scene {
 public:
  /// The settings must be free of defects.
  explicit Scene(const Settings& settings = {});

  /// The new shape's index, or why it is refused.
  std::variant<std::uint32_t, Defect> add_shape(const ConvexPolygon<float>& polygon);

  /// A new body, of a shape that was added, at a pose in the world; the next step looks at it.
  std::variant<BodyHandle, Defect> add(std::uint32_t shape, const Pose<float>& pose,
                                       const Rules& rules = {});
  /// A new body of one or more parts, which do not touch each other. Each part stands where
  /// `composed` puts it, which must be free of defects, too, and has contacts of its own: `part`
  /// says of a contact's handle whose it is.
  std::variant<BodyHandle, Defect> add(std::span<const BodyPart> parts, const Pose<float>& pose,
                                       const Rules& rules = {});
  /// Takes a body out; its contacts are reported as ended by the next step.
  std::optional<Defect> remove(BodyHandle body);
  /// Gives a body, or one of its parts, another shape, which the next step looks at.
  std::optional<Defect> set_shape(BodyHandle body, std::uint32_t shape, std::uint32_t part = 0);
  /// Gives a body another filter: contacts that it does not allow are reported as ended by the next
  /// step, others begin there. What one filter ends and the next allows, before a step, ends and
  /// begins.
  std::optional<Defect> set_filter(BodyHandle body, const Filter& filter);

  /// Puts bodies where they are now and brings the contacts up to date. Of two moves of one body
  /// the last counts. An executor, where one is given, runs parts of it: the result is the same.
  /// One that throws leaves the scene fit for nothing but its end.
  std::variant<StepResult, RefusedMove> step(std::span<const Move> moves,
                                             const Executor& executor = {});

  /// Where a body stands in the world, as of the last step; it must be in the scene.
  const Pose<float>& pose(BodyHandle body) const;
  /// What a body is to others; it must be in the scene.
  Rules rules(BodyHandle body) const {
    return traits_.empty() ? Rules{} : traits_[body.index].rules;
  }
  /// The body and the part that a handle of the last step's contacts names, ended ones too.
  PartName part(BodyHandle handle) const {
    return traits_.empty() ? PartName{handle} : traits_[handle.index].name;
  }
  /// The handle by which contacts name a part; its body must be in the scene and have the part.
  BodyHandle handle(const PartName& name) const;

  /// The shape, and where it stands in the world as of the last step, of what a contact's handle
  /// names: a body, or one of its parts.
  kernel::Placement<float> placement(BodyHandle handle) const { return placements_[handle.index]; }
  /// A shape that was added.
  const ConvexPolygon<float>& shape(std::uint32_t index) const {
    return shapes_.for_pairs().polygon(index);
  }

  /// Puts the handles of all bodies and parts whose padded boxes overlap this one into `found`, by
  /// their indices: so of all that reach into it (certificates.md, "Boxes"), their radii being
  /// round. As of the last step; a body that was given another shape since may be missed. It
  /// writes to the scene's memory: one thread at a time.
  void near(const Box& box, std::vector<BodyHandle>& found);

  /// How many bodies are in the scene; each part counts.
  std::size_t body_count() const { return body_count_; }
  /// How many pairs of bodies are candidates.
  std::size_t pair_count() const { return candidates_.size(); }

  /// What it takes, the shapes left out.
  Memory memory() const;

 private:
  /// A contact as the kernel gave it, to be recycled.
  struct Kept {
    Pose<float> b_in_a;
    Manifold<float> manifold;
  };

  bool is_known(BodyHandle body) const {
    return body.index < generations_.size() && generations_[body.index] == body.generation &&
           body.generation % 2 == 1 && part(body).body == body;
  }
  BodyHandle handle(std::uint32_t index) const { return {index, generations_[index]}; }
  const ShapeFacts& facts(std::uint32_t body) const {
    return shapes_.facts(placements_[body].shape);
  }
  bool is(std::uint32_t body, State state) const { return (states_[body] & state) != 0; }
  bool overlap(std::uint32_t a, std::uint32_t b) const {
    return scene::overlap(boxes_[a], boxes_[b]);
  }

  void make_room_for(std::size_t bodies, bool with_traits);
  std::uint32_t take_place(std::uint32_t shape, const Pose<float>& pose);
  std::size_t contacts_of(std::uint32_t body);
  void leave_place(std::uint32_t body);
  void set_traits(std::uint32_t body, const Traits& traits);
  void refilter(std::uint32_t body);
  template <class Act>
  void for_each_part(BodyHandle body, const Act& act) const;
  void advance(std::span<const Move> moves, bool may_divide);
  void forget_pairs();
  void recall_bodies();
  CheckedMoves check(std::span<const Move> moves) const;
  std::optional<RefusedMove> find_refused(std::span<const Move> moves, const Share& share) const;
  std::span<const Move> moves_of_parts(std::span<const Move> moves);
  bool may_touch(std::uint32_t a, std::uint32_t b) const {
    return traits_.empty() || (!(traits_[a].name.body == traits_[b].name.body) &&
                               scene::may_touch(traits_[a].rules, traits_[b].rules));
  }
  /// Whether contacts of two bodies have no points.
  bool is_sensed(const kernel::BodyPair& bodies) const {
    return !traits_.empty() &&
           (traits_[bodies.a].rules.is_sensor || traits_[bodies.b].rules.is_sensor);
  }

  /// `act(k)` of each work on pairs, in which there are so many things in all.
  template <class Act>
  void for_each_pair_work(std::size_t things, const Act& act) const {
    const std::size_t works = pair_works_.size();
    if (division_.tasks_for(things) > 1) return division_.run(works, act);
    for (std::size_t k = 0; k < works; ++k) act(k);
  }

  void start_path(std::uint32_t body);
  void forget_removed();
  void place(std::span<const Move> moves, bool may_divide);
  void place(std::span<const Move> moves, std::vector<std::uint32_t>& moved,
             std::vector<Mover>& unsure);
  void count_movers(std::size_t movers);
  /// One of those that may have left their fattened boxes.
  Mover unsure(std::size_t i) const {
    if (i >= started_) return unsure_[i - started_];
    return {movers_[i], placements_[movers_[i]].pose.position};
  }

  void renew_boxes();
  void find_leavers();
  void find_leavers(const Share& share, std::vector<Leaver>& left);
  void leave(const Mover& mover, std::vector<Leaver>& left);
  void draw_all_boxes();
  void draw_tight_boxes(std::span<const std::uint32_t> bodies);
  void part_from_partners();
  void refile();
  void find_all_partners();
  void find_partners(std::span<const Leaver> some, Scratch& scratch, PartnerWork& work) const;
  void add_partners(const Leaver& leaver, std::span<const std::uint32_t> found,
                    std::vector<std::uint32_t>& partners, PartnerWork& work) const;
  void look_at_new(std::span<const std::uint32_t> lower, PairWork& work);
  void add_candidates();
  void drop(std::uint32_t a, Candidate& candidate);
  void drop_all(std::uint32_t body);

  void look_at_candidates();
  void look_at_movers();
  void look_at_all_rows();
  PairWork& begun_work(std::size_t work, Scratch& scratch, Candidate* candidates,
                       std::size_t count);
  void mark_bodies();
  /// Both paths, added as `sort_rows` does where bodies are marked.
  float paths_of(std::uint32_t a, std::uint32_t b) const {
    if (few_moved_ || settings_.recycled_motion > 0) return paths_[a] + paths_[b];
    return std::bit_cast<float>(marks_[a]) + std::bit_cast<float>(marks_[b]);
  }
  void look_at_rows(std::uint32_t first, std::uint32_t last, PairWork& work);
  void look_at_row(std::uint32_t a, PairWork& work);
  void look_at_partners(std::uint32_t body, PairWork& work);
  void look_at(std::uint32_t a, Candidate& candidate, PairWork& work);
  void leave_out_apart(PairWork& work);
  void leave_out_behind_faces(PairWork& work);
  void draw_undrawn(PairWork& work);
  template <class Out>
  void collide(const Queue& queue, Out out, PairWork& work);
  void collide_waiting(PairWork& work);
  void collide_touching(PairWork& work);
  void keep_touching(const Queue& touching);
  void collide_apart(PairWork& work);
  void prove_apart(const kernel::BodyPair& bodies, const Manifold<float>& none, std::uint32_t place,
                   PairWork& work);
  void note_parted(PairWork& work) const;
  void take_results();
  /// The sum of both paths up to which two bodies are apart that have this much room, a length.
  float paths_to(const kernel::BodyPair& bodies, float margin) const {
    return kPathShare * (paths_[bodies.a] + paths_[bodies.b] + margin);
  }
  void begin_contacts();
  void begin_contacts(std::span<const Beginning> beginning, std::size_t begun,
                      std::size_t behind_last);
  void drop_parted();
  void end_contact(Candidate& candidate);
  void erase_contact(std::uint32_t contact);

  bool recycle(std::uint32_t a, const Candidate& candidate);
  Pose<float> b_in_a(const kernel::BodyPair& bodies) const {
    return relative_pose(placements_[bodies.a].pose, placements_[bodies.b].pose);
  }
  void settle();
  StepResult result();

  /// The path of a body of which nothing is known: longer than any.
  static constexpr float kNoPath = 1e30F;

  Settings settings_;
  ShapeTable shapes_;
  std::size_t body_count_ = 0;
  std::vector<std::uint32_t> free_;     // bodies' places to be used again
  std::vector<std::uint32_t> removed_;  // to be used again once a step has told of what ended
  bool has_forgotten_ = false;          // its pairs, and which bodies moved
  std::unordered_map<std::uint32_t, Assembly> assemblies_;  // bodies of parts, by the first's place

  // By body.
  LargeVector<kernel::Placement<float>> placements_;
  std::vector<std::uint32_t> generations_;
  std::vector<std::uint8_t> states_;    // of State
  std::vector<float> paths_;            // how far its vertices went since its path began, at most
  std::vector<float> leave_at_;         // it is in its fattened box until its path is longer
  std::vector<Box> boxes_;              // fattened
  std::vector<Box> tight_;              // where kBoxed
  std::vector<std::uint32_t> left_at_;  // its place among those that left, if it did
  std::vector<Traits> traits_;          // empty while no body had any

  Cells cells_;  // of the fattened boxes
  Candidates candidates_;
  LargeVector<Contact> contacts_;
  LargeVector<Kept> kept_;  // by contact, unless strict

  // What only the step under way needs.
  std::vector<Move> part_moves_;
  std::vector<std::uint32_t> movers_;  // bodies that moved, all of them where few did
  std::size_t started_ = 0;            // the first so many: they began new paths before the moves
  std::vector<Mover> unsure_;          // others that may have left their fattened boxes
  bool few_moved_ = false;
  bool all_are_boxed_ = false;
  std::vector<Leaver> left_;
  std::vector<std::uint32_t> bodies_;
  std::vector<std::uint32_t> marks_;  // by body
  Division division_;
  std::vector<MoverWork> mover_works_;
  std::vector<std::vector<Leaver>> left_works_;
  std::vector<PartnerWork> partner_works_;
  std::vector<PairWork> pair_works_;   // on rows, and as many on pairs that are new
  std::size_t compared_ = 0;           // pairs of tight boxes, in the last step
  std::vector<std::uint32_t> vacant_;  // contacts that ended in this step
  StepCounts counts_;

  // What a step reports.
  std::vector<std::uint32_t> began_;
  std::vector<EndedContact> ended_;
  std::vector<RenumberedContact> renumbered_;
  std::ptrdiff_t ended_reported_ = 0;  // by the last step; those behind wait for the next
  std::ptrdiff_t renumbered_reported_ = 0;
};

}  // namespace manifuzz::scene
