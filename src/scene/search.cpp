#include <algorithm>
#include <array>

#include "afresh/boxes.hpp"
#include "scene/scene.hpp"

namespace manifuzz::scene {
namespace {

/// How far a box is fattened.
struct Fatness {
  float all_round;  ///< on each side, a share of its body's extent, and how far it went last
  float ahead_max;  ///< in the direction of its motion, no farther than this share,
  float ahead;      ///< and a multiple of how far it went last
};
constexpr Fatness kAmongOthers{0.125F, 2, 4};
/// A box with few partners may be fatter, and one without may be fat: it costs little there.
constexpr Fatness kAmongFew{0.25F, 3, 8};
constexpr Fatness kByItself{0.8F, 4, 12};

const Fatness& fatness_of(std::uint8_t state) {
  if ((state & kAlone) != 0) return kByItself;
  return (state & kFewPartners) != 0 ? kAmongFew : kAmongOthers;
}

/// Paths get little longer than this multiple of an extent: sums of two are rounded little then.
constexpr float kPathMax = 64;

/// Where a path begins. What is known of a pair of which nothing is proven is less as a length,
/// whatever face it names, and a longer path has bits enough for one.
constexpr float kPathMin = std::numeric_limits<float>::min();

/// Once one body in so many has left its box, all are filed anew.
constexpr std::size_t kFileShare = 6;

/// Once one body in so many has left its box, most of the cells and boxes will be read.
constexpr std::size_t kAskShare = 24;

/// So many more find room in a cell.
constexpr std::uint32_t kRoom = 1;

Box fattened(const Box& box, const Vector2<float>& motion, float extent, const Fatness& fatness) {
  const float most = fatness.ahead_max * extent;
  const auto ahead = [&](float along) { return std::clamp(fatness.ahead * along, -most, most); };
  const float x = ahead(motion.x());
  const float y = ahead(motion.y());
  // What goes fast would soon have used up its room to the sides, where it does not go.
  const float went = std::max(std::abs(motion.x()), std::abs(motion.y()));
  Box fat = grown(box, fatness.all_round * extent + std::min(went, most));
  (x < 0 ? fat.x_min : fat.x_max) += x;
  (y < 0 ? fat.y_min : fat.y_max) += y;
  return fat;
}

}  // namespace

/// Bodies that left their fattened boxes get new ones.
void Scene::renew_boxes() {
  all_are_boxed_ = !few_moved_ && (division_.has_executor() || 2 * compared_ > body_count_);
  if (all_are_boxed_) draw_all_boxes();
  find_leavers();
  counts_.left_boxes = left_.size();
  part_from_partners();
}

/// Notes how many moved, and whether they are few: only their pairs are looked at then. Each is
/// found by going along a row, and rows are long where one body lies under all.
void Scene::count_movers(std::size_t movers) {
  constexpr std::size_t kShare = 16;
  counts_.moved = movers;
  few_moved_ = kShare * movers < body_count_ &&
               movers * candidates_.longest_row() < body_count_ + candidates_.size();
}

/// Each task looks at its share of the unsure ones; those that left are listed in their order.
void Scene::find_leavers() {
  clear_for(left_, body_count_);
  clear_for(bodies_, body_count_);
  const std::size_t unsure = started_ + unsure_.size();
  const std::size_t tasks = division_.tasks_for(unsure);
  if (tasks == 1) {
    find_leavers({0, unsure}, left_);
  } else {
    left_works_.resize(tasks);
    division_.divide(unsure, tasks, [&](const Share& share, std::size_t task) {
      find_leavers(share, left_works_[task]);
    });
    for (std::vector<Leaver>& left : left_works_) {
      append(left_, left);
      clear_for(left, body_count_);
    }
  }
  for (std::size_t i = 0; i < left_.size(); ++i) {
    left_at_[left_[i].body] = static_cast<std::uint32_t>(i);
  }
}

/// Some at a time: what is needed of them is asked for, their boxes are drawn, and each is looked
/// at.
void Scene::find_leavers(const Share& share, std::vector<Leaver>& left) {
  std::array<std::uint32_t, 256> bodies;
  for (std::size_t first = share.first; first < share.last; first += bodies.size()) {
    const std::size_t count = std::min(bodies.size(), share.last - first);
    for (std::size_t i = 0; i < count; ++i) {
      bodies[i] = unsure(first + i).body;
      ask_for(boxes_, bodies[i]);
      __builtin_prefetch(&shapes_.rows(placements_[bodies[i]].shape));
    }
    if (!all_are_boxed_) draw_tight_boxes(std::span(bodies).first(count));
    for (std::size_t i = 0; i < count; ++i) leave(unsure(first + i), left);
  }
}

/// Draws the tight boxes of all bodies, moved or not: in tasks, none draws what another reads; and
/// where most are asked for, it is faster than to find out which.
void Scene::draw_all_boxes() {
  const std::size_t places = states_.size();
  division_.divide(places, [&](const Share& share, std::size_t) {
    std::array<std::uint32_t, 256> undrawn;
    for (std::size_t first = share.first; first < share.last; first += undrawn.size()) {
      const std::size_t last = std::min(first + undrawn.size(), share.last);
      std::size_t count = 0;
      for (std::size_t body = first; body < last; ++body) {
        undrawn[count] = static_cast<std::uint32_t>(body);
        const std::uint8_t state = states_[body];
        const bool is_there = (state & (kMoved | kFiled)) != 0;
        count += static_cast<std::size_t>(is_there & ((state & kBoxed) == 0));
      }
      draw_tight_boxes(std::span(undrawn).first(count));
    }
  });
}

void Scene::draw_tight_boxes(std::span<const std::uint32_t> bodies) {
  std::array<Box, 256> drawn;
  for (std::size_t first = 0; first < bodies.size(); first += drawn.size()) {
    const auto some = bodies.subspan(first, std::min(drawn.size(), bodies.size() - first));
    padded_boxes(shapes_, placements_, some, drawn);
    for (std::size_t i = 0; i < some.size(); ++i) {
      tight_[some[i]] = drawn[i];
      states_[some[i]] |= kBoxed;
    }
  }
}

/// It is not sure to be in its fattened box any more: where it is, it may go on from here; where it
/// is not, it gets another. After a long path it gets another in any case, and the path begins
/// anew.
void Scene::leave(const Mover& mover, std::vector<Leaver>& left) {
  const std::uint32_t body = mover.body;
  const Box& box = tight_[body];
  float& path = paths_[body];
  Box& fat = boxes_[body];
  const float extent = facts(body).extent();
  const bool is_long = path > kPathMax * extent;
  const bool goes_on = !is_long && contains(fat, box);
  if (!goes_on) {
    left.push_back({body, fat});
    const Vector2<float> motion = placements_[body].pose.position - mover.from;
    fat = fattened(box, motion, extent, fatness_of(states_[body]));
    states_[body] |= kLeft;
    if (is_long) {
      path = kPathMin;
      states_[body] |= kUnproven;
    }
  }
  leave_at_[body] = (path + slack(fat, box)) * (1 - 4 * kRoundoff);
}

/// Where a body that left began a new path, proofs are forgotten; and where only few rows are
/// looked at, its pairs whose boxes overlap no longer are dropped.
void Scene::part_from_partners() {
  for (const Leaver& leaver : left_) {
    const bool is_unproven = is(leaver.body, kUnproven);
    if (!is(leaver.body, kFiled) || !(few_moved_ || is_unproven)) continue;
    for (const std::uint32_t other : cells_.near(leaver.before)) {
      const auto [a, b] = std::minmax(leaver.body, other);
      Candidate* const candidate = candidates_.find(a, b);
      if (candidate == nullptr) continue;
      if (few_moved_ && !overlap(a, b)) {
        drop(a, *candidate);
      } else if (is_unproven && !candidate->touches()) {
        candidate->know(0);
      }
    }
  }
}

/// Files those that left. It writes no states: other tasks read them meanwhile.
void Scene::refile() {
  if (left_.empty()) return;
  if (kAskShare * left_.size() > body_count_) {
    cells_.ask_for_all();
    ask_for_all(boxes_);
  }
  const auto refiled = [&](std::size_t i) -> Cells::Refiled {
    const auto& [body, before] = left_[i];
    return {body, is(body, kFiled) ? &before : nullptr, &boxes_[body]};
  };
  const bool is_filed =
      kFileShare * left_.size() < body_count_ && cells_.refile(left_.size(), refiled);
  if (is_filed) return;
  bodies_.clear();
  for (std::uint32_t body = 0; body < states_.size(); ++body) {
    if ((states_[body] & (kFiled | kLeft)) != 0) bodies_.push_back(body);
  }
  cells_.file(bodies_, boxes_, kRoom);
}

}  // namespace manifuzz::scene
