#include "scene/pair_cache.hpp"

#include "kernel/pair.hpp"

namespace manifuzz::scene {
namespace {

/// What both separations may be off by, and both relative poses, as a share of the extent.
constexpr float kErrors = 2 * kSeparationError + 16 * kRoundoff;

}  // namespace

Certificate prove_separated(const ShapeTable& shapes, const kernel::Placement<float>& a,
                            const kernel::Placement<float>& b) {
  const kernel::PairSeparation found =
      kernel::separation(shapes.rows(a.shape), shapes.rows(b.shape), relative_pose(a.pose, b.pose));
  const bool is_a = found.face.side == Side::a;
  Certificate proof;
  proof.near = found.face.side;
  proof.far_in_near = is_a ? relative_pose(a.pose, b.pose) : relative_pose(b.pose, a.pose);
  const ShapeFacts& facts_a = shapes.facts(a.shape);
  const ShapeFacts& facts_b = shapes.facts(b.shape);
  const float extent = facts_a.reach + facts_b.reach + length_at_most(proof.far_in_near.position);
  const float total_radius = facts_a.radius + facts_b.radius;
  proof.margin = found.separation - total_radius - kErrors * (extent + total_radius) - kUnderflow;
  return proof;
}

namespace {

constexpr std::size_t kSlotsMin = 16;

/// Of all slots, no more than 3 in 4 are taken.
bool is_crowded(std::size_t pairs, std::size_t slots) {
  return 4 * pairs > 3 * slots;
}

/// Room for one more, in steps that leave little memory unused.
template <class T>
void make_room(std::vector<T>& vector, std::size_t size) {
  if (size > vector.capacity()) vector.reserve(size + size / 8 + 16);
}

}  // namespace

std::size_t PairCache::home_of(const kernel::BodyPair& pair) const {
  const std::uint64_t key = (std::uint64_t{pair.a} << 32) | pair.b;
  const std::uint64_t hash = (key ^ (key >> 29)) * 0x9e3779b97f4a7c15ULL;
  return (hash >> 32) & (slots_.size() - 1);
}

std::uint32_t PairCache::find(std::uint32_t body, std::uint32_t other) const {
  if (slots_.empty()) return kNone;
  const kernel::BodyPair bodies{std::min(body, other), std::max(body, other)};
  const std::size_t last = slots_.size() - 1;
  for (std::size_t slot = home_of(bodies); slots_[slot] != kNone; slot = (slot + 1) & last) {
    const kernel::BodyPair& found = pairs_[slots_[slot]].bodies;
    if (found.a == bodies.a && found.b == bodies.b) return slots_[slot];
  }
  return kNone;
}

std::size_t PairCache::slot_of(std::uint32_t pair) const {
  std::size_t slot = home_of(pairs_[pair].bodies);
  while (slots_[slot] != pair) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

void PairCache::add(std::uint32_t body, std::uint32_t other) {
  const auto pair = static_cast<std::uint32_t>(pairs_.size());
  make_room(pairs_, pairs_.size() + 2);  // and for one aside
  make_room(links_, links_.size() + 4);
  pairs_.push_back({{std::min(body, other), std::max(body, other)}, {}});
  links_.resize(links_.size() + 2);
  link(2 * pair);
  link(2 * pair + 1);
  if (is_crowded(pairs_.size(), slots_.size())) {
    widen();
  } else {
    insert(pair);
  }
}

void PairCache::insert(std::uint32_t pair) {
  std::size_t slot = home_of(pairs_[pair].bodies);
  while (slots_[slot] != kNone) slot = (slot + 1) & (slots_.size() - 1);
  slots_[slot] = pair;
}

void PairCache::widen() {
  slots_.assign(std::max(kSlotsMin, 2 * slots_.size()), kNone);
  for (std::uint32_t i = 0; i < pairs_.size(); ++i) insert(i);
}

/// Closes the gap with those behind that a search would now miss.
void PairCache::erase(std::size_t slot) {
  const std::size_t last = slots_.size() - 1;
  std::size_t gap = slot;
  for (std::size_t i = (gap + 1) & last; slots_[i] != kNone; i = (i + 1) & last) {
    const std::size_t home = home_of(pairs_[slots_[i]].bodies);
    if (((i - home) & last) < ((i - gap) & last)) continue;
    slots_[gap] = slots_[i];
    gap = i;
  }
  slots_[gap] = kNone;
}

void PairCache::link(End end) {
  const std::uint32_t body = body_of(end);
  if (body >= first_.size()) first_.resize(body + 1, kNone);
  links_[end] = {first_[body], kNone};
  if (first_[body] != kNone) links_[first_[body]].previous = end;
  first_[body] = end;
}

void PairCache::unlink(End end) {
  const Links links = links_[end];
  if (links.next != kNone) links_[links.next].previous = links.previous;
  (links.previous != kNone ? links_[links.previous].next : first_[body_of(end)]) = links.next;
}

/// What is at `to` is forgotten; nothing is left at `from`.
void PairCache::renumber(std::uint32_t from, std::uint32_t to) {
  slots_[slot_of(from)] = to;
  pairs_[to] = pairs_[from];
  for (const End side : {0U, 1U}) {
    const End end = 2 * to + side;
    const Links& links = links_[end] = links_[2 * from + side];
    if (links.next != kNone) links_[links.next].previous = end;
    (links.previous != kNone ? links_[links.previous].next : first_[body_of(end)]) = end;
  }
}

void PairCache::swap(std::uint32_t pair, std::uint32_t other) {
  if (pair == other) return;
  const auto aside = static_cast<std::uint32_t>(pairs_.size());
  pairs_.emplace_back();
  links_.resize(links_.size() + 2);
  renumber(pair, aside);
  renumber(other, pair);
  renumber(aside, other);
  pairs_.pop_back();
  links_.resize(links_.size() - 2);
}

void PairCache::remove(std::uint32_t pair) {
  const auto last = static_cast<std::uint32_t>(pairs_.size()) - 1;
  erase(slot_of(pair));
  unlink(2 * pair);
  unlink(2 * pair + 1);
  if (pair != last) renumber(last, pair);
  pairs_.pop_back();
  links_.resize(links_.size() - 2);
}

std::size_t PairCache::bytes_by_body() const {
  return first_.capacity() * sizeof(End);
}

std::size_t PairCache::bytes_by_pair() const {
  return pairs_.capacity() * sizeof(Pair) + links_.capacity() * sizeof(Links) +
         slots_.capacity() * sizeof(std::uint32_t);
}

namespace {

/// A point of A's frame in the frame of B.
Vector2<float> in_b(const Pose<float>& b_in_a, const Vector2<float>& point) {
  return rotate_back<float>(b_in_a.rotation, point - b_in_a.position);
}

}  // namespace

Manifold<float> recycled(const Manifold<float>& manifold, const Pose<float>& from,
                         const Pose<float>& to) {
  Manifold<float> carried = manifold;
  const Vector2<float> normal_in_b = rotate_back(from.rotation, manifold.normal);
  if (manifold.reference == Side::b) carried.normal = rotate(to.rotation, normal_in_b);
  for (int i = 0; i < manifold.count; ++i) {
    ContactPoint<float>& point = carried.points[i];
    const Vector2<float> at = point.position;
    if (manifold.reference == Side::a) {
      point.position = transform(to, in_b(from, at));
      point.depth -= manifold.normal.dot(point.position - at);
    } else {
      point.depth += normal_in_b.dot(in_b(to, at) - in_b(from, at));
    }
  }
  return carried;
}

}  // namespace manifuzz::scene
