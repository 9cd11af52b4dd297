#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "afresh/cells.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <array>
#include <bit>
#include <cassert>
#include <hwy/highway.h>

#include "afresh/cells.hpp"
#include "afresh/compressed-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {

using Floats = hn::ScalableTag<float>;
using Indices = hn::ScalableTag<std::uint32_t>;

/// Bodies found, with room behind them for whole vectors, which is kept: filling it costs.
class Found {
 public:
  explicit Found(std::vector<std::uint32_t>& bodies) : bodies_(bodies) {}

  std::uint32_t* room_for(std::size_t more) {
    const std::size_t needed = count_ + more + hn::Lanes(Indices());
    if (needed > bodies_.size()) bodies_.resize(std::max(2 * bodies_.size(), needed));
    return bodies_.data() + count_;
  }
  void add(std::size_t count) { count_ += count; }

  std::size_t count() const { return count_; }
  std::uint32_t operator[](std::size_t i) const { return bodies_[i]; }
  void clear() { count_ = 0; }

 private:
  std::vector<std::uint32_t>& bodies_;
  std::size_t count_ = 0;
};

/// The bodies among the entries from first to before last whose boxes overlap this one; of those
/// `also(entry)` says, which gives a mask.
template <class Also>
HWY_INLINE void scan(const BoxColumns& entries, std::uint32_t first, std::uint32_t last,
                     const Box& box, const Also& also, Found& found) {
  const Floats d;
  const Indices di;
  const auto x_min = hn::Set(d, box.x_min);
  const auto y_min = hn::Set(d, box.y_min);
  const auto x_max = hn::Set(d, box.x_max);
  const auto y_max = hn::Set(d, box.y_max);
  std::uint32_t* const begin = found.room_for(last - first);
  std::uint32_t* out = begin;
  for (std::size_t i = first; i < last; i += hn::Lanes(d)) {
    const auto from = [&](const std::vector<float>& column) {
      return hn::LoadU(d, column.data() + i);
    };
    auto hit = hn::And(hn::Le(from(entries.x_min), x_max), hn::Ge(from(entries.x_max), x_min));
    hit = hn::And(hit,
                  hn::And(hn::Le(from(entries.y_min), y_max), hn::Ge(from(entries.y_max), y_min)));
    hit = hn::And(hit, hn::And(also(i), hn::FirstN(d, last - i)));
    const auto found_here = hn::RebindMask(di, hit);
    // Not CompressStore: AMD's processors take a hundred cycles for one.
    hn::StoreU(compressed(di, hn::LoadU(di, entries.body.data() + i), found_here), di, out);
    out += hn::CountTrue(di, found_here);
  }
  found.add(static_cast<std::size_t>(out - begin));
}

HWY_INLINE void scan(const BoxColumns& entries, std::uint32_t first, std::uint32_t last,
                     const Box& box, Found& found) {
  const Floats d;
  const auto all = [d](std::size_t) { return hn::FirstN(d, hn::Lanes(d)); };
  scan(entries, first, last, box, all, found);
}

/// How many of `bodies` are found.
std::size_t among(std::span<const Cells::Run> runs, const BoxColumns& entries, const Box& box,
                  std::vector<std::uint32_t>& bodies) {
  Found found(bodies);
  for (const auto& [first, last] : runs) scan(entries, first, last, box, found);
  return found.count();
}

/// The left one of two boxes of a level finds the other; where both begin at one x, that of the
/// lower entry does.
HWY_INLINE void scan_right(const CellLevel& level, const BoxColumns& entries, std::size_t entry,
                           const Box& box, Found& found) {
  const Floats d;
  const Indices di;
  const auto x_min = hn::Set(d, box.x_min);
  const auto is_later = [&](std::size_t i) {
    const auto other = hn::LoadU(d, entries.x_min.data() + i);
    const auto place = hn::Add(hn::Set(di, static_cast<std::uint32_t>(i)), hn::Iota(di, 0));
    const auto behind = hn::Gt(place, hn::Set(di, static_cast<std::uint32_t>(entry)));
    return hn::Or(hn::Gt(other, x_min), hn::And(hn::Eq(other, x_min), hn::RebindMask(d, behind)));
  };
  level.each_run(level.right_of(box), [&](std::uint32_t first, std::uint32_t last) {
    scan(entries, first, last, box, is_later, found);
  });
}

void pairs(std::span<const CellLevel> levels, const BoxColumns& entries,
           std::vector<std::uint32_t>& bodies, std::vector<kernel::BodyPair>& pairs) {
  pairs.clear();
  Found found(bodies);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const std::vector<std::uint32_t>& begin = levels[i].begin();
    for (std::uint32_t entry = begin.front(); entry < begin.back(); ++entry) {
      const std::uint32_t body = entries.body[entry];
      if (body == kNone) continue;
      const Box box = entries.box(entry);
      found.clear();
      scan_right(levels[i], entries, entry, box, found);
      for (const CellLevel& finer : levels.first(i)) {
        finer.each_run(finer.near(box), [&](std::uint32_t first, std::uint32_t last) {
          scan(entries, first, last, box, found);
        });
      }
      for (std::size_t k = 0; k < found.count(); ++k) {
        pairs.push_back({std::min(body, found[k]), std::max(body, found[k])});
      }
    }
  }
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::scene {

HWY_EXPORT(among);
HWY_EXPORT(pairs);

namespace {

/// The greater of both sides, rounded up.
float extent_of(const Box& box) {
  return std::max(box.x_max - box.x_min, box.y_max - box.y_min) * (1 + 4 * kRoundoff);
}

/// Sizes by exponent and two bits behind it: four steps to an octave.
constexpr int kSizeShift = 21;
constexpr std::size_t kSizes = 1 << (32 - 1 - kSizeShift);

std::size_t size_of(float extent) {
  return std::bit_cast<std::uint32_t>(extent) >> kSizeShift;
}

constexpr std::size_t kSizesALevel = 12;  // down to an eighth of the largest

/// A box whose cell is full may lie so far to the right of it: searches go as far as one does.
constexpr int kAsideMax = 2;

/// How many boxes may lie in no cell: every search goes through them, in eight steps of sixteen.
std::uint32_t overflow_max(std::size_t bodies) {
  return static_cast<std::uint32_t>(std::min<std::size_t>(bodies / 16, 128));
}

struct Size {
  std::uint32_t count = 0;
  float extent_max = 0;
};

}  // namespace

void Cells::make_levels(std::span<const std::uint32_t> bodies, std::span<const Box> boxes) {
  std::array<Size, kSizes> sizes{};
  Box span = kNowhere;
  for (const std::uint32_t body : bodies) {
    const Box& box = boxes[body];
    const float extent = extent_of(box);
    Size& size = sizes[size_of(extent)];
    ++size.count;
    size.extent_max = std::max(size.extent_max, extent);
    span = {std::min(span.x_min, box.x_min), std::min(span.y_min, box.y_min),
            std::max(span.x_max, box.x_min), std::max(span.y_max, box.y_min)};
  }
  std::array<Size, kSizes> large_first;
  used_ = 0;
  for (std::size_t size = kSizes; size-- > 0;) {
    if (sizes[size].count == 0) continue;
    Size& level = large_first[used_++] = sizes[size];
    for (std::size_t k = 1; k < kSizesALevel && size > 0; ++k) level.count += sizes[--size].count;
  }
  if (used_ > levels_.size()) levels_.resize(used_);
  for (std::size_t i = 0; i < used_; ++i) {
    const Size& level = large_first[used_ - 1 - i];
    levels_[i].lay_out(level.extent_max, span, level.count);
  }
}

std::size_t Cells::level_of(const Box& box) const {
  const float extent = extent_of(box);
  std::size_t level = 0;
  while (level < used_ && levels_[level].extent_max() < extent) ++level;
  return level;
}

void Cells::file(std::span<const std::uint32_t> bodies, std::span<const Box> boxes,
                 std::uint32_t room) {
  make_levels(bodies, boxes);
  for (CellLevel& level : levels()) {
    resize(level.begin(), level.places() + 1);
    std::ranges::fill(level.begin(), 0U);
  }
  resize(level_, bodies.size());
  resize(place_, bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Box& box = boxes[bodies[i]];
    level_[i] = static_cast<std::uint8_t>(level_of(box));
    place_[i] = levels_[level_[i]].place_of(box);
    ++levels_[level_[i]].begin()[place_[i]];
  }
  std::uint32_t end = 0;
  for (CellLevel& level : levels()) {
    // Behind its place's last entry at first, each begin goes back as they are filed.
    for (std::uint32_t& begin : level.begin()) {
      const std::uint32_t behind = end + begin;
      end = std::exchange(begin, behind) + room + end;
    }
  }
  overflow_ = overflow_end_ = end;
  entries_.clear_to(end + room * overflow_max(bodies.size()));
  for (std::size_t i = bodies.size(); i-- > 0;) {
    entries_.set(--levels_[level_[i]].begin()[place_[i]], bodies[i], boxes[bodies[i]]);
  }
}

bool Cells::refile(const Refiled& refiled, const Place& from, const Place& to) {
  const auto& [body, before, box] = refiled;
  if (before != nullptr && from == to) {
    entries_.set(entry_of(to, body), body, *box);
    return true;
  }
  if (before != nullptr) entries_.clear(entry_of(from, body));
  std::uint32_t entry = entry_of(to, kNone);
  if (entry == overflow_end_) {
    if (entry == entries_.size) return false;
    ++overflow_end_;
  }
  entries_.set(entry, body, *box);
  return true;
}

Cells::Place Cells::place_of(const Box& box) const {
  const std::size_t level = level_of(box);
  return {level, level == used_ ? 0 : levels_[level].place_of(box)};
}

std::uint32_t Cells::entry_of(const Place& place, std::uint32_t body) {
  const auto find = [&](std::uint32_t first, std::uint32_t last) {
    const auto of = entries_.body.begin();
    return static_cast<std::uint32_t>(std::find(of + first, of + last, body) - of);
  };
  if (place.level < used_) {
    CellLevel& level = levels_[place.level];
    std::uint32_t at = place.place;
    for (int aside = 0; aside <= kAsideMax; ++aside, at = level.next_in_row(at)) {
      const std::uint32_t last = level.begin()[at + 1];
      const std::uint32_t entry = find(level.begin()[at], last);
      if (entry == last) continue;
      level.allow_aside(aside);
      return entry;
    }
  }
  return find(overflow_, overflow_end_);
}

void Cells::find_runs(const Box& box, std::vector<Run>& runs) const {
  for (const CellLevel& level : levels()) {
    level.each_run(level.near(box), [&](std::uint32_t first, std::uint32_t last) {
      if (first == last) return;
      runs.push_back({first, last});
      entries_.ask_for(first);
      entries_.ask_for(last - 1);
    });
  }
  runs.push_back({overflow_, overflow_end_});
}

std::span<const std::uint32_t> Cells::among(std::span<const Run> runs, const Box& box,
                                            Bodies& found) const {
  const std::size_t count = HWY_DYNAMIC_DISPATCH(among)(runs, entries_, box, found);
  return std::span(found).first(count);
}

void Cells::pairs(std::vector<kernel::BodyPair>& found) {
  HWY_DYNAMIC_DISPATCH(pairs)(levels(), entries_, found_, found);
}

std::size_t Cells::bytes() const {
  std::size_t indices = 5 * entries_.body.capacity() + place_.capacity() + found_.capacity();
  for (const CellLevel& level : levels_) indices += level.begin().capacity();
  return level_.capacity() + bytes_of(runs_) + 4 * indices;
}

}  // namespace manifuzz::scene
#endif
