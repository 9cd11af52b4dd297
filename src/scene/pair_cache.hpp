#pragma once

#include <cstdint>
#include <vector>

#include "geometry/manifold.hpp"
#include "kernel/packed.hpp"
#include "scene/shape_table.hpp"

namespace manifuzz::scene {

// What a pair was last proven to be, and how far its bodies may move for that to stay proven
// (derived in certificates.md).

/// A face of one body, the near one, separates the other, far one; or, of a pair that touches, how
/// long its manifold is recycled.
struct Certificate {
  Pose<float> far_in_near;  ///< the far body's pose in the near one's frame, at that moment
  /// The far polygon's vertices may move by less than this, seen from the near one, and the kernel
  /// still finds it separated, or the manifold is still recycled; <= 0: nothing is proven. Length.
  float margin = -1;
  Side near = Side::a;  ///< whose face it is
};

/// The proof that A and B are separated at these poses in the world, by the face that the kernel
/// finds; proves nothing where they are nearer than rounding can tell.
Certificate prove_separated(const ShapeTable& shapes, const kernel::Placement<float>& a,
                            const kernel::Placement<float>& b);

/// Whether the bodies have moved by less than the margin. The shapes are those of the proof.
inline bool still_holds(const Certificate& certificate, const ShapeTable& shapes,
                        const kernel::Placement<float>& a, const kernel::Placement<float>& b) {
  const bool is_a = certificate.near == Side::a;
  const kernel::Placement<float>& near = is_a ? a : b;
  const kernel::Placement<float>& far = is_a ? b : a;
  const float moved = displacement(certificate.far_in_near, relative_pose(near.pose, far.pose),
                                   shapes.facts(far.shape).reach);
  return moved < certificate.margin;
}

/// A candidate pair and what is known of it.
struct Pair {
  kernel::BodyPair bodies;  ///< a < b
  Certificate certificate;
};

/// The candidate pairs: an array without gaps, those that touch before those that do not; found by
/// both bodies' indices, and through each body those it takes part in. Indices hold until a pair is
/// removed, begins or ends to touch.
class PairCache {
 public:
  /// How many pairs there are.
  std::size_t size() const { return pairs_.size(); }
  /// The pair of that index, 0 <= pair < size().
  Pair& operator[](std::uint32_t pair) { return pairs_[pair]; }
  /// The pair of that index, 0 <= pair < size().
  const Pair& operator[](std::uint32_t pair) const { return pairs_[pair]; }

  /// The pair's index, or kNone.
  std::uint32_t find(std::uint32_t body, std::uint32_t other) const;

  /// Whether a body has any pairs.
  bool has_any(std::uint32_t body) const { return body < first_.size() && first_[body] != kNone; }

  /// Adds a pair that is not there.
  void add(std::uint32_t body, std::uint32_t other);

  /// Calls `visit(pair, other)` for each pair of a body.
  template <class Visit>
  void each_of(std::uint32_t body, const Visit& visit) const;

  /// Pairs of lower index touch, the others do not.
  std::uint32_t touching() const { return touching_; }

  /// A pair begins to touch, as the last of those that do.
  void begin_touching(std::uint32_t pair) { swap(pair, touching_++); }

  /// A pair touches no longer; the last of those that do takes its index. Its new index.
  std::uint32_t end_touching(std::uint32_t pair) {
    swap(pair, --touching_);
    return touching_;
  }

  /// Of a pair that does not touch.
  void remove(std::uint32_t pair);

  /// The memory that grows with the number of bodies, and with that of pairs.
  std::size_t bytes_by_body() const;
  std::size_t bytes_by_pair() const;

 private:
  /// A pair seen from one of its bodies: twice the pair's index, plus 1 for body b.
  using End = std::uint32_t;

  /// The neighbours of an end in its body's list.
  struct Links {
    End next = kNone;
    End previous = kNone;
  };

  std::uint32_t body_of(End end) const {
    const kernel::BodyPair& bodies = pairs_[end / 2].bodies;
    return end % 2 == 0 ? bodies.a : bodies.b;
  }
  std::uint32_t partner_of(End end) const { return body_of(end ^ 1); }
  std::size_t home_of(const kernel::BodyPair& pair) const;
  std::size_t slot_of(std::uint32_t pair) const;
  void insert(std::uint32_t pair);
  void erase(std::size_t slot);
  void widen();
  void link(End end);
  void unlink(End end);
  void renumber(std::uint32_t from, std::uint32_t to);
  void swap(std::uint32_t pair, std::uint32_t other);

  std::uint32_t touching_ = 0;
  std::vector<Pair> pairs_;
  std::vector<Links> links_;          // by end
  std::vector<End> first_;            // by body
  std::vector<std::uint32_t> slots_;  // pairs by the hash of their bodies, linear probing
};

template <class Visit>
void PairCache::each_of(std::uint32_t body, const Visit& visit) const {
  if (body >= first_.size()) return;
  for (End end = first_[body]; end != kNone; end = links_[end].next)
    visit(end / 2, partner_of(end));
}

/// A manifold of B at the pose `from` in A's frame, for B at `to`, with nothing computed anew: its
/// points stay where they are on the incident edge, its normal stays the reference face's, and the
/// depths are those of the points as they moved. What the motion clips, uncovers or separates is
/// not seen, so depths may fall below 0.
Manifold<float> recycled(const Manifold<float>& manifold, const Pose<float>& from,
                         const Pose<float>& to);

}  // namespace manifuzz::scene
