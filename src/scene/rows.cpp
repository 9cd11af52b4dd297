#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/rows.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <hwy/highway.h>

#include "afresh/compressed-inl.hpp"
#include "scene/rows.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {

using Lanes = hn::CappedTag<std::uint32_t, kRowLanes>;

/// A queue while it grows: what lies behind its end may be overwritten.
class Tail {
 public:
  explicit Tail(Queue& queue)
      : queue_(queue), a_(queue.a.data()), b_(queue.b.data()), at_(queue.at.data()) {}
  ~Tail() { queue_.count = count_; }

  bool has_room(std::size_t more) const { return count_ + more < size_; }

  /// The pairs in a mask's lanes.
  HWY_INLINE void append(hn::Vec<Lanes> a, hn::Vec<Lanes> b, hn::Vec<Lanes> at,
                         hn::Mask<Lanes> mask) {
    const Lanes d;
    hn::StoreU(a, d, a_ + count_);
    hn::StoreU(compressed(d, b, mask), d, b_ + count_);
    hn::StoreU(compressed(d, at, mask), d, at_ + count_);
    count_ += hn::CountTrue(d, mask);
  }

 private:
  Queue& queue_;
  std::uint32_t* a_;
  std::uint32_t* b_;
  std::uint32_t* at_;
  std::size_t count_ = queue_.count;
  std::size_t size_ = queue_.a.size();
};

/// A lane a pair, and hardly a branch that depends on one: those of bodies that left are rare.
std::uint32_t sort_rows(Candidates& candidates, const std::uint32_t* marks, std::uint32_t first,
                        std::uint32_t last, SortedPairs& sorted) {
  const Lanes d;
  const hn::RebindToFloat<Lanes> df;
  const hn::RebindToSigned<Lanes> di;
  const std::size_t lanes = hn::Lanes(d);
  Tail touching(sorted.touching);
  Tail apart(sorted.apart);
  Tail leaving(sorted.leaving);
  std::size_t separated = 0;
  std::uint32_t a = first;
  for (; a < last; ++a) {
    candidates.prefetch(a + kRowsAhead);
    const std::span<Candidate> row = candidates.row(a);
    if (row.empty()) continue;
    const std::size_t room = row.size() + lanes;
    if (!touching.has_room(room) || !apart.has_room(room)) break;
    if (sorted.any_left && !leaving.has_room(room)) break;
    const auto mark_a = hn::Set(d, marks[a]);
    for (std::size_t i = 0; i < row.size(); i += lanes) {
      hn::Vec<Lanes> b;
      hn::Vec<Lanes> known;
      hn::LoadInterleaved2(d, reinterpret_cast<const std::uint32_t*>(&row[i]), b, known);
      const auto in_row = hn::FirstN(d, row.size() - i);
      b = hn::IfThenElseZero(in_row, b);
      const auto mark_b = hn::GatherIndex(d, marks, hn::BitCast(di, b));
      const auto of_both = hn::Or(mark_a, mark_b);
      const auto moved = hn::And(in_row, hn::TestBit(of_both, hn::Set(d, kHasMoved)));
      if (hn::AllFalse(d, moved)) continue;
      const auto paths = hn::Add(hn::BitCast(df, mark_a), hn::BitCast(df, mark_b));
      const auto touches = hn::TestBit(known, hn::Set(d, Candidate::kTouches));
      const auto is_apart = hn::RebindMask(d, hn::Lt(paths, hn::BitCast(df, known)));
      const auto row_a = hn::Set(d, a);
      const auto places = hn::Add(hn::Set(d, candidates.place_of(row[i])), hn::Iota(d, 0));
      const auto contacts = hn::AndNot(hn::Set(d, Candidate::kTouches), known);
      touching.append(row_a, b, contacts, hn::And(moved, touches));
      apart.append(row_a, b, places, hn::AndNot(hn::Or(touches, is_apart), moved));
      separated += hn::CountTrue(d, hn::And(moved, is_apart));
      if (!sorted.any_left) continue;
      const auto left = hn::And(in_row, hn::TestBit(of_both, hn::Set(d, kHasLeft)));
      if (!hn::AllFalse(d, left)) leaving.append(row_a, b, places, left);
    }
  }
  sorted.separated += separated;
  return a;
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::scene {

HWY_EXPORT(sort_rows);

std::uint32_t sort_rows(Candidates& candidates, const std::uint32_t* marks, std::uint32_t first,
                        std::uint32_t last, SortedPairs& sorted) {
  return HWY_DYNAMIC_DISPATCH(sort_rows)(candidates, marks, first, last, sorted);
}

}  // namespace manifuzz::scene
#endif
