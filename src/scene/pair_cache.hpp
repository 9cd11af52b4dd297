#pragma once

#include <cstdint>
#include <vector>

#include "kernel/packed.hpp"
#include "scene/certificates.hpp"

namespace manifuzz::scene {

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

}  // namespace manifuzz::scene
