#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/rows.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <bit>
#include <hwy/highway.h>

#include "afresh/compressed-inl.hpp"
#include "scene/rows.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {

using Lanes = hn::CappedTag<std::uint32_t, kPairLanes>;

/// A queue while it grows: what lies behind its end may be overwritten.
class Tail {
 public:
  explicit Tail(Queue& queue)
      : queue_(queue), a_(queue.a.data()), b_(queue.b.data()), at_(queue.at.data()) {}
  ~Tail() { queue_.count = count_; }

  bool has_room(std::size_t more) const { return count_ + more <= room_; }

  /// The pairs in a mask's lanes.
  HWY_INLINE void append(hn::Vec<Lanes> a, hn::Vec<Lanes> b, hn::Vec<Lanes> at,
                         hn::Mask<Lanes> mask) {
    const Lanes d;
    hn::StoreU(compressed(d, a, mask), d, a_ + count_);
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
  std::size_t room_ = queue_.room();
};

static_assert(sizeof(Candidate) == 8);

/// Pairs of rows, one after another: most rows are shorter than a vector.
class Run {
 public:
  static constexpr std::size_t kMax = 512;

  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

  /// Copies pairs of a body's row; there is room for them.
  HWY_INLINE void append(std::span<const Candidate> pairs, std::uint32_t place, std::uint32_t a,
                         std::uint32_t mark_a) {
    const hn::CappedTag<std::uint32_t, kRowLanes> d;
    const std::size_t lanes = hn::Lanes(d);
    const auto* const from = reinterpret_cast<const std::uint32_t*>(pairs.data());
    for (std::size_t i = 0; i < pairs.size(); i += lanes) {
      const std::size_t at = size_ + i;
      hn::StoreU(hn::LoadU(d, from + 2 * i), d, pairs_ + 2 * at);
      hn::StoreU(hn::LoadU(d, from + 2 * i + lanes), d, pairs_ + 2 * at + lanes);
      hn::StoreU(hn::Set(d, a), d, a_ + at);
      hn::StoreU(hn::Set(d, mark_a), d, mark_a_ + at);
      const auto first = hn::Set(d, place + static_cast<std::uint32_t>(i));
      hn::StoreU(hn::Add(first, hn::Iota(d, 0)), d, place_ + at);
    }
    size_ += pairs.size();
  }

  /// A lane a pair. Hardly a branch depends on what one is: pairs of bodies that left are rare.
  HWY_INLINE void sort(const std::uint32_t* marks, bool any_left, Tail& touching, Tail& apart,
                       Tail& leaving, std::size_t& separated) const {
    const Lanes d;
    const hn::RebindToFloat<Lanes> df;
    const hn::RebindToSigned<Lanes> di;
    for (std::size_t i = 0; i < size_; i += hn::Lanes(d)) {
      hn::Vec<Lanes> b;
      hn::Vec<Lanes> known;
      hn::LoadInterleaved2(d, pairs_ + 2 * i, b, known);
      const auto in_run = hn::FirstN(d, size_ - i);
      b = hn::IfThenElseZero(in_run, b);
      known = hn::IfThenElseZero(in_run, known);
      const auto mark_a = hn::Load(d, mark_a_ + i);
      const auto mark_b = hn::GatherIndex(d, marks, hn::BitCast(di, b));
      const auto of_both = hn::Or(mark_a, mark_b);
      const auto moved = hn::And(in_run, hn::TestBit(of_both, hn::Set(d, kMoved)));
      if (hn::AllFalse(d, moved)) continue;
      const auto paths = hn::Add(hn::BitCast(df, mark_a), hn::BitCast(df, mark_b));
      const auto touches = hn::TestBit(known, hn::Set(d, Candidate::kTouches));
      const auto is_apart = hn::RebindMask(d, hn::Lt(paths, hn::BitCast(df, known)));
      const auto a = hn::Load(d, a_ + i);
      const auto places = hn::Load(d, place_ + i);
      const auto contacts = hn::AndNot(hn::Set(d, Candidate::kTouches), known);
      touching.append(a, b, contacts, hn::And(moved, touches));
      apart.append(a, b, places, hn::AndNot(hn::Or(touches, is_apart), moved));
      separated += hn::CountTrue(d, hn::And(moved, is_apart));
      if (!any_left) continue;
      const auto left = hn::And(in_run, hn::TestBit(of_both, hn::Set(d, kLeft)));
      if (!hn::AllFalse(d, left)) leaving.append(a, b, places, left);
    }
  }

 private:
  static constexpr std::size_t kRoom = kMax + kPairLanes;  // vectors reach past the last pair
  HWY_ALIGN std::uint32_t pairs_[2 * kRoom];               // as `Candidate` holds them
  HWY_ALIGN std::uint32_t a_[kRoom];
  HWY_ALIGN std::uint32_t mark_a_[kRoom];
  HWY_ALIGN std::uint32_t place_[kRoom];
  std::size_t size_ = 0;
};

/// `look(a)` of each row from the first to before the last in which there are candidates, until it
/// refuses one, which is returned, or else the last; rows ahead are asked for.
template <class Look>
HWY_INLINE std::uint32_t for_each_filled_row(const CandidateRows& rows, std::uint32_t first,
                                             std::uint32_t last, const Look& look) {
  const auto pop = [](std::uint32_t from, std::uint64_t& bits) {
    const auto place = static_cast<std::uint32_t>(std::countr_zero(bits));
    bits &= bits - 1;
    return from + place;
  };
  const auto filled = [&](std::uint32_t from) {
    const std::size_t number = from / kRowBits;
    return number < rows.filled.size() ? rows.filled[number] : 0;
  };
  std::uint32_t from = first / kRowBits * kRowBits;
  std::uint64_t bits = filled(from) >> (first - from) << (first - from);
  for (; from < last; from += kRowBits) {
    const std::uint64_t next = filled(from + kRowBits);
    std::uint64_t ahead = next;
    while (bits != 0) {
      const std::uint32_t a = pop(from, bits);
      if (a >= last) return last;
      if (ahead != 0) rows.prefetch(pop(from + kRowBits, ahead));
      if (!look(a)) return a;
    }
    while (ahead != 0) rows.prefetch(pop(from + kRowBits, ahead));
    bits = next;
  }
  return last;
}

std::uint32_t sort_rows(const CandidateRows& all, const std::uint32_t* marks, std::uint32_t first,
                        std::uint32_t last, SortedPairs& sorted) {
  const CandidateRows rows = all;
  Tail touching(sorted.touching);
  Tail apart(sorted.apart);
  Tail leaving(sorted.leaving);
  Run run;
  const auto sort = [&] {
    run.sort(marks, sorted.any_left, touching, apart, leaving, sorted.separated);
    run.clear();
  };
  const auto look = [&](std::uint32_t a) {
    const std::span<const Candidate> row = rows.row(a);
    const std::size_t more = run.size() + row.size();
    if (!touching.has_room(more) || !apart.has_room(more)) return false;
    if (sorted.any_left && !leaving.has_room(more)) return false;
    for (std::size_t i = 0; i < row.size(); i += Run::kMax) {
      const auto some = row.subspan(i, std::min(row.size() - i, Run::kMax));
      if (run.size() + some.size() > Run::kMax) sort();
      run.append(some, rows.rows[a].first + static_cast<std::uint32_t>(i), a, marks[a]);
    }
    return true;
  };
  const std::uint32_t next = for_each_filled_row(rows, first, last, look);
  sort();
  return next;
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::scene {

HWY_EXPORT(sort_rows);

std::uint32_t sort_rows(const CandidateRows& rows, const std::uint32_t* marks, std::uint32_t first,
                        std::uint32_t last, SortedPairs& sorted) {
  return HWY_DYNAMIC_DISPATCH(sort_rows)(rows, marks, first, last, sorted);
}

}  // namespace manifuzz::scene
#endif
