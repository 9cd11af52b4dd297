#include "scene/broad_phase.hpp"

#include <algorithm>
#include <cmath>

namespace manifuzz::scene {
namespace {

constexpr std::size_t kBucketsMin = 16;

/// Cells beyond are taken for the last one: what is placed there is found all the same.
constexpr double kCellMax = 1 << 30;

/// The cell of a coordinate. Every rounding on the way keeps the order of coordinates.
int cell_at(double coordinate, double width) {
  return static_cast<int>(std::clamp(std::floor(coordinate / width), -kCellMax, kCellMax));
}

double middle(float low, float high) {
  return (static_cast<double>(low) + static_cast<double>(high)) / 2;
}

}  // namespace

Grid::Cell Grid::cell_of(const Box& box) {
  const double extent = std::max(static_cast<double>(box.x_max) - static_cast<double>(box.x_min),
                                 static_cast<double>(box.y_max) - static_cast<double>(box.y_min));
  int level = 0;
  std::frexp(extent, &level);
  level += level & 1;  // every other power of two
  const double width = std::ldexp(1.0, level);
  return {level, cell_at(middle(box.x_min, box.x_max), width),
          cell_at(middle(box.y_min, box.y_max), width)};
}

Grid::Range Grid::range_of(const Box& box, int level) {
  const double width = std::ldexp(1.0, level);
  const auto low = [&](float x) { return cell_at(static_cast<double>(x) - width / 2, width); };
  const auto high = [&](float x) { return cell_at(static_cast<double>(x) + width / 2, width); };
  return {low(box.x_min), low(box.y_min), high(box.x_max), high(box.y_max)};
}

std::size_t Grid::bucket_of(const Cell& cell) const {
  std::uint64_t hash = static_cast<std::uint32_t>(cell.x) * 0x9e3779b97f4a7c15ULL;
  hash ^= (static_cast<std::uint32_t>(cell.y) + 0x632be5ab00000000ULL) * 0xbf58476d1ce4e5b9ULL;
  hash += static_cast<std::uint32_t>(cell.level) * 0x94d049bb133111ebULL;
  return ((hash ^ (hash >> 32)) * 0x9e3779b97f4a7c15ULL >> 32) & (buckets_.size() - 1);
}

Grid::Level& Grid::level_of(int level) {
  const auto at = std::ranges::lower_bound(levels_, level, {}, &Level::level);
  if (at != levels_.end() && at->level == level) return *at;
  return *levels_.insert(at, {level, 0});
}

void Grid::place(std::uint32_t body, const Box& box) {
  if (body >= entries_.size()) entries_.resize(body + 1);
  const Cell cell = cell_of(box);
  entries_[body].box = box;
  if (entries_[body].placed) {
    if (entries_[body].cell == cell) return;
    remove(body);
  }
  ++placed_;
  if (placed_ > buckets_.size()) widen();
  ++level_of(cell.level).bodies;
  entries_[body].cell = cell;
  entries_[body].placed = true;
  link(body);
}

void Grid::remove(std::uint32_t body) {
  unlink(body);
  entries_[body].placed = false;
  --level_of(entries_[body].cell.level).bodies;
  --placed_;
}

void Grid::link(std::uint32_t body) {
  std::uint32_t& first = buckets_[bucket_of(entries_[body].cell)];
  entries_[body].next = first;
  entries_[body].previous = kNone;
  if (first != kNone) entries_[first].previous = body;
  first = body;
}

void Grid::unlink(std::uint32_t body) {
  const Entry& entry = entries_[body];
  if (entry.next != kNone) entries_[entry.next].previous = entry.previous;
  if (entry.previous != kNone) {
    entries_[entry.previous].next = entry.next;
  } else {
    buckets_[bucket_of(entry.cell)] = entry.next;
  }
}

void Grid::widen() {
  buckets_.assign(std::max(kBucketsMin, 2 * buckets_.size()), kNone);
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    if (entries_[i].placed) link(i);
  }
}

std::size_t Grid::bytes() const {
  return entries_.capacity() * sizeof(Entry) + buckets_.capacity() * sizeof(std::uint32_t) +
         levels_.capacity() * sizeof(Level);
}

namespace {

/// The box fattened all round, and ahead of where the body comes from.
Box fattened(const Box& box, const Vector2<float>& motion, float reach, const Fatness& fatness) {
  const float ahead_max = fatness.ahead_max * reach;
  const auto ahead = [&](float way) { return std::clamp(fatness.ahead * way, 0.0F, ahead_max); };
  Box fat = grown(box, fatness.all_round * reach);
  fat.x_min -= ahead(-motion.x());
  fat.y_min -= ahead(-motion.y());
  fat.x_max += ahead(motion.x());
  fat.y_max += ahead(motion.y());
  return fat;
}

}  // namespace

bool BroadPhase::update(std::uint32_t body, const Box& box, const Pose<float>& pose, float reach,
                        const Fatness& fatness) {
  if (body >= anchors_.size()) anchors_.resize(body + 1);
  Anchor& anchor = anchors_[body];
  const bool is_new = !grid_.holds(body);
  const bool left = is_new || !contains(grid_.box(body), box);
  if (left) {
    const Vector2<float> motion =
        is_new ? Vector2<float>(0, 0) : Vector2<float>(pose.position - anchor.pose.position);
    grid_.place(body, fattened(box, motion, reach, fatness));
  }
  anchor = {pose, slack(grid_.box(body), box)};
  return left;
}

void BroadPhase::remove(std::uint32_t body) {
  if (!grid_.holds(body)) return;
  grid_.remove(body);
  anchors_[body].slack = 0;
}

}  // namespace manifuzz::scene
