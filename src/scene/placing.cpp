#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/placing.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <cstddef>
#include <hwy/highway.h>

#include "afresh/compressed-inl.hpp"
#include "afresh/defect.hpp"
#include "kernel/lanes-inl.hpp"
#include "scene/lengths-inl.hpp"
#include "scene/placing.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {

static_assert(sizeof(Pose<float>) == 16 && sizeof(Move) == 24 && offsetof(Move, pose) == 8);
static_assert(offsetof(kernel::Placement<float>, pose) == 4 && sizeof(ShapeFacts) % 4 == 0);

/// A lane a move.
using MoveLanes = hn::CappedTag<float, 16>;
using Lengths = hn::Vec<MoveLanes>;
using BodyLanes = hn::RebindToUnsigned<MoveLanes>;

/// So many bodies ahead, all that is known of one is asked for: most move in the order in which
/// they lie in memory.
constexpr std::size_t kBodiesAhead = 160;

/// Asks for so many things, so far behind the first; the array may have ended before.
template <class T>
HWY_INLINE void ask_for_lines(const T* first, std::size_t ahead, std::size_t count) {
  constexpr std::size_t kLine = 64;
  const auto from = reinterpret_cast<std::uintptr_t>(first) + ahead * sizeof(T);
  for (std::size_t at = 0; at < count * sizeof(T); at += kLine) {
    __builtin_prefetch(reinterpret_cast<const void*>(from + at), 1);
  }
}

/// What a body is after it moved.
HWY_INLINE int state_after(int state, bool is_unsure) {
  return (state & ~kBoxed) | kMoved | static_cast<int>(is_unsure) * kUnsure;
}

/// Puts one body where it is now; no branch depends on what becomes of it.
HWY_INLINE void place_one(const Move& move, const Placing& placing, PlacedCounts& counts) {
  const std::uint32_t body = move.body.index;
  auto& [shape, pose] = placing.placements[body];
  if (same_bits(pose, move.pose)) return;
  const float went = displacement(pose, move.pose, placing.facts[shape].reach);
  const float path = next_float(placing.paths[body] + went);
  const bool is_unsure = path > placing.leave_at[body];
  const int state = placing.states[body];
  placing.moved[counts.moved] = body;
  counts.moved += static_cast<std::size_t>((state & kMoved) == 0);
  placing.unsure[counts.unsure] = {body, pose.position};
  counts.unsure += static_cast<std::size_t>(is_unsure & ((state & kUnsure) == 0));
  placing.paths[body] = path;
  placing.states[body] = static_cast<std::uint8_t>(state_after(state, is_unsure));
  pose = move.pose;
}

/// Sixteen bytes of things that lie so many bytes apart, as four rows: of a pose x, y, cos and sin.
template <class T>
HWY_INLINE void load_four(const T* first, std::size_t stride, Lengths (&rows)[4]) {
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(first);
  const auto at = [&](std::size_t lane) {
    return reinterpret_cast<const float*>(bytes + stride * lane);
  };
  kernel::HWY_NAMESPACE::load_rows(MoveLanes(), at, rows);
}

/// `displacement` of afresh/shape_table.hpp.
HWY_INLINE Lengths displacements(const Lengths (&from)[4], const Lengths (&to)[4], Lengths reach) {
  const MoveLanes d;
  const auto length_from = [&](int row) {
    return length_at_most<MoveLanes>(
        d, {hn::Sub(to[row], from[row]), hn::Sub(to[row + 1], from[row + 1])});
  };
  const auto sum = hn::Add(length_from(0), hn::Mul(reach, length_from(2)));
  return hn::Mul(hn::Set(d, kRoundUp), sum);
}

/// The reaches of the shapes of bodies that follow each other.
HWY_INLINE Lengths reaches(const kernel::Placement<float>* placements, const ShapeFacts* facts) {
  const MoveLanes d;
  const hn::RebindToSigned<MoveLanes> di;
  const auto times = [&](auto indices, std::size_t size) {
    return hn::Mul(indices, hn::Set(di, static_cast<std::int32_t>(size)));
  };
  const auto* const shapes = reinterpret_cast<const std::int32_t*>(&placements->shape);
  const auto shape = hn::GatherOffset(di, shapes, times(hn::Iota(di, 0), sizeof(*placements)));
  return hn::GatherOffset(d, &facts->reach, times(shape, sizeof(*facts)));
}

/// Adds the bodies in a mask's lanes.
HWY_INLINE void add_unsure(hn::Mask<BodyLanes> mask, std::uint32_t first, const Placing& placing,
                           PlacedCounts& counts) {
  const BodyLanes d;
  if (hn::AllFalse(d, mask)) return;
  kernel::HWY_NAMESPACE::for_each_lane(d, mask, [&](std::size_t lane) {
    const std::uint32_t body = first + static_cast<std::uint32_t>(lane);
    placing.unsure[counts.unsure++] = {body, placing.placements[body].pose.position};
  });
}

/// Puts the bodies of as many moves as there are lanes where they are now; they follow each other.
HWY_INLINE void place_strip(const Move* moves, const Placing& placing, PlacedCounts& counts) {
  const MoveLanes d;
  const BodyLanes di;
  const hn::RebindToSigned<MoveLanes> ds;
  const hn::Rebind<std::uint8_t, MoveLanes> db;
  const std::size_t lanes = hn::Lanes(d);
  const std::uint32_t first = moves->body.index;
  kernel::Placement<float>* const placements = placing.placements + first;
  float* const paths = placing.paths + first;
  std::uint8_t* const states = placing.states + first;
  ask_for_lines(placements, kBodiesAhead, lanes);
  ask_for_lines(paths, kBodiesAhead, lanes);
  ask_for_lines(placing.leave_at + first, kBodiesAhead, lanes);
  Lengths from[4];
  Lengths to[4];
  load_four(&placements->pose, sizeof(*placements), from);
  load_four(&moves->pose, sizeof(*moves), to);
  const auto is_same = [&](int row) {
    return hn::Eq(hn::BitCast(di, from[row]), hn::BitCast(di, to[row]));
  };
  const auto moved =
      hn::Not(hn::And(hn::And(is_same(0), is_same(1)), hn::And(is_same(2), is_same(3))));
  if (hn::AllFalse(di, moved)) return;
  const auto path = hn::LoadU(d, paths);
  const auto sum = hn::Add(path, displacements(from, to, reaches(placements, placing.facts)));
  const auto next = hn::BitCast(d, hn::Add(hn::BitCast(di, sum), hn::Set(di, 1)));
  hn::StoreU(hn::IfThenElse(hn::RebindMask(d, moved), next, path), d, paths);
  const auto leave_at = hn::LoadU(d, placing.leave_at + first);
  const auto is_unsure = hn::And(moved, hn::RebindMask(di, hn::Gt(next, leave_at)));
  const auto state = hn::PromoteTo(di, hn::LoadU(db, states));
  const auto lacks = [&](State flag) { return hn::Not(hn::TestBit(state, hn::Set(di, flag))); };
  const auto unboxed = hn::AndNot(hn::Set(di, kBoxed), state);
  const auto added = hn::IfThenElse(is_unsure, hn::Set(di, kMoved | kUnsure), hn::Set(di, kMoved));
  const auto after = hn::IfThenElse(moved, hn::Or(unboxed, added), state);
  hn::StoreU(hn::DemoteTo(db, hn::BitCast(ds, after)), db, states);
  const auto bodies = hn::Add(hn::Set(di, first), hn::Iota(di, 0));
  const auto begins = hn::And(moved, lacks(kMoved));
  hn::StoreU(compressed(di, bodies, begins), di, placing.moved + counts.moved);
  counts.moved += hn::CountTrue(di, begins);
  add_unsure(hn::And(is_unsure, lacks(kUnsure)), first, placing, counts);
  for (std::size_t lane = 0; lane < lanes; ++lane) placements[lane].pose = moves[lane].pose;
}

/// Whether the bodies of as many moves as there are lanes lie one after another.
HWY_INLINE bool follow_each_other(const Move* moves) {
  std::uint32_t differences = 0;
  for (std::uint32_t i = 1; i < hn::Lanes(MoveLanes()); ++i) {
    differences |= moves[i].body.index - moves[0].body.index - i;
  }
  return differences == 0;
}

/// `strip(moves)` of as many moves as there are lanes, where their bodies follow each other, and
/// `one(move)` of each other move.
template <class Strip, class One>
HWY_INLINE void for_each_strip(std::span<const Move> moves, const Strip& strip, const One& one) {
  const std::size_t lanes = hn::Lanes(MoveLanes());
  std::size_t i = 0;
  for (; i + lanes <= moves.size(); i += lanes) {
    const auto some = moves.subspan(i, lanes);
    if (follow_each_other(some.data())) {
      strip(some);
    } else {
      for (const Move& move : some) one(move);
    }
  }
  for (const Move& move : moves.subspan(i)) one(move);
}

HWY_INLINE bool is_sound(const Move& move, std::span<const std::uint32_t> generations) {
  const auto& [index, generation] = move.body;
  return index < generations.size() && generations[index] == generation && generation % 2 == 1 &&
         !find_defect(move.pose);
}

/// Whether the moves of a strip are sound for certain. Squares of rotations are rounded by less
/// than four roundoffs, which the tolerance leaves out here.
HWY_INLINE bool are_plainly_sound(const Move* moves, std::span<const std::uint32_t> generations) {
  const MoveLanes d;
  const BodyLanes di;
  const std::size_t first = moves->body.index;
  if (first + hn::Lanes(d) > generations.size()) return false;
  Lengths head[4];  // index, generation and position
  Lengths pose[4];
  load_four(&moves->body, sizeof(*moves), head);
  load_four(&moves->pose, sizeof(*moves), pose);
  const auto generation = hn::LoadU(di, generations.data() + first);
  const auto is_named = hn::Eq(generation, hn::BitCast(di, head[1]));
  const auto is_there = hn::And(is_named, hn::TestBit(generation, hn::Set(di, 1)));
  const auto is_near = [&](int row) { return hn::Le(hn::Abs(pose[row]), hn::Set(d, kLengthMax)); };
  const auto squares = hn::Add(hn::Mul(pose[2], pose[2]), hn::Mul(pose[3], pose[3]));
  const auto off = hn::Abs(hn::Sub(squares, hn::Set(d, 1)));
  constexpr float kOffMax = static_cast<float>(kRotationTolerance) - 4 * kRoundoff;
  const auto is_unit = hn::Le(off, hn::Set(d, kOffMax));
  const auto is_pose = hn::And(is_unit, hn::And(is_near(0), is_near(1)));
  return hn::AllTrue(d, hn::And(is_pose, hn::RebindMask(d, is_there)));
}

bool are_sound(std::span<const Move> moves, std::span<const std::uint32_t> generations) {
  bool all = true;
  const auto one = [&](const Move& move) { all = all && is_sound(move, generations); };
  const auto strip = [&](std::span<const Move> some) {
    if (!are_plainly_sound(some.data(), generations)) std::ranges::for_each(some, one);
  };
  for_each_strip(moves, strip, one);
  return all;
}

PlacedCounts place_moves(std::span<const Move> moves, const Placing& placing_by_caller) {
  const Placing placing = placing_by_caller;  // nothing that is written changes it
  PlacedCounts counts;
  for_each_strip(
      moves, [&](std::span<const Move> some) { place_strip(some.data(), placing, counts); },
      [&](const Move& move) { place_one(move, placing, counts); });
  return counts;
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::scene {

HWY_EXPORT(are_sound);
HWY_EXPORT(place_moves);

bool are_sound(std::span<const Move> moves, std::span<const std::uint32_t> generations) {
  return HWY_DYNAMIC_DISPATCH(are_sound)(moves, generations);
}

bool do_ascend(std::span<const Move> moves) {
  const auto place_of = [](const Move& move) { return move.body.index; };
  return std::ranges::adjacent_find(moves, std::ranges::greater_equal{}, place_of) == moves.end();
}

PlacedCounts place_moves(std::span<const Move> moves, const Placing& placing) {
  return HWY_DYNAMIC_DISPATCH(place_moves)(moves, placing);
}

}  // namespace manifuzz::scene
#endif
