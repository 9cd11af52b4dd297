#pragma once

#include <bit>
#include <cassert>
#include <cstdint>
#include <span>
#include <vector>

#include "afresh/lists.hpp"
#include "afresh/shape_table.hpp"
#include "geometry/manifold.hpp"
#include "scene/large_pages.hpp"

namespace manifuzz::scene {

/// A face of A's or of B's before which the other body lay when both were last collided, as five
/// bits of a number.
class FaceBetween {
 public:
  static constexpr std::uint32_t kIndex = 7;   ///< these bits are the face's index,
  static constexpr std::uint32_t kOfB = 8;     ///< this one is set if it is B's,
  static constexpr std::uint32_t kKnown = 16;  ///< and this one if there is one
  static constexpr std::uint32_t kBits = 31;   ///< all of them

  FaceBetween() = default;  ///< none
  /// As the kernel names it of a pair without points.
  explicit FaceBetween(const FeaturePair& features)
      : bits_(bits_if_face(features.a, kKnown) | bits_if_face(features.b, kKnown | kOfB)) {}
  /// The one that a number names, whatever its other bits are.
  explicit FaceBetween(std::uint32_t number) : bits_(number & kBits) {}

  bool is_of_b() const { return (bits_ & kOfB) != 0; }
  std::uint32_t index() const { return bits_ & kIndex; }
  std::uint32_t bits() const { return bits_; }

 private:
  static std::uint32_t bits_if_face(const Feature& feature, std::uint32_t bits) {
    return feature.kind == Feature::Kind::face ? bits | feature.index : 0;
  }

  std::uint32_t bits_ = 0;
};

/// What is known of two bodies that are apart until their paths sum up to this length, rounded down
/// to where the face finds room. 0 proves nothing: no path is as short as the face's bits.
inline std::uint32_t apart_until(float paths, FaceBetween face) {
  constexpr std::uint32_t kStep = FaceBetween::kBits + 1;
  const std::uint32_t bits = std::bit_cast<std::uint32_t>(paths);
  const std::uint32_t lower = bits < 2 * kStep ? 0 : bits - kStep;
  return (lower & ~FaceBetween::kBits) | face.bits();
}

/// Two bodies that may touch and whose fattened boxes overlap, in the row of the one of lower
/// index, A. They touch, or are apart for as long as their paths are together no longer than
/// proven; one number holds either, since as a length a contact's index is below 0 or none. Such a
/// length's last bits name a face that lay between them.
class Candidate {
 public:
  Candidate() = default;
  explicit Candidate(std::uint32_t body) : b(body) {}

  /// Whether the bodies touched when they were last collided.
  bool touches() const { return (known_ & kTouches) != 0; }
  /// The contact's index, of bodies that touch.
  std::uint32_t contact() const { return known_ & ~kTouches; }
  /// Whether bodies whose paths sum up to this length are apart for certain.
  bool is_apart(float paths) const { return paths < std::bit_cast<float>(known_); }

  void touch(std::uint32_t contact) {
    assert((contact & kTouches) == 0);
    known_ = kTouches | contact;
  }
  /// Where bodies do not touch, as `apart_until` has it.
  std::uint32_t known() const { return known_; }
  void know(std::uint32_t known) { known_ = known; }

  /// Set in what is known of bodies that touch.
  static constexpr std::uint32_t kTouches = std::uint32_t{1} << 31;

  std::uint32_t b = kNone;  ///< the other body

 private:
  std::uint32_t known_ = 0;
};

/// Less than 1 by more than a sum of two paths and a margin is rounded.
inline constexpr float kPathShare = 1 - 8 * kRoundoff;

/// So many pairs of a row are read together: most rows are no longer. As many may be read past the
/// end of a row.
inline constexpr std::size_t kRowLanes = 8;

/// So many rows share a number, in which each has a bit.
inline constexpr std::uint32_t kRowBits = 64;

/// Where a body's row is among all candidates.
struct CandidateRow {
  std::uint32_t first = 0;  ///< its first place
  std::uint32_t count = 0;  ///< of its candidates
  std::uint32_t room = 0;   ///< for so many
};

/// All rows, to be gone through while none changes: held by value, they are known not to.
struct CandidateRows {
  const CandidateRow* rows;               ///< by body
  std::span<const std::uint64_t> filled;  ///< a bit a body: whether there are candidates in its row
  const Candidate* all;                   ///< by place

  /// A body's row.
  std::span<const Candidate> row(std::uint32_t a) const {
    return {all + rows[a].first, rows[a].count};
  }
  /// Asks for a row in which there are candidates; most are no longer than two cache lines.
  void prefetch(std::uint32_t a) const {
    const std::span<const Candidate> soon = row(a);
    __builtin_prefetch(&soon.front());
    __builtin_prefetch(&soon.back());
  }
};

/// The candidate pairs: those of a body with bodies of higher index lie together, rows in one
/// array.
class Candidates {
 public:
  /// How many pairs there are.
  std::size_t size() const { return count_; }
  /// How many pairs the rows from the first to before the last have.
  std::size_t size_of(std::uint32_t first, std::uint32_t last) const;
  /// No row has had more of them since they were last packed.
  std::size_t longest_row() const { return longest_row_; }

  /// Bodies from this one on have no row.
  std::uint32_t rows() const { return static_cast<std::uint32_t>(rows_.size()); }

  /// A body's row; valid until a pair is added.
  std::span<Candidate> row(std::uint32_t a) {
    if (a >= rows_.size()) return {};
    return {all_.data() + rows_[a].first, rows_[a].count};
  }

  /// All rows; valid until a pair is added or dropped.
  CandidateRows all_rows() const { return {rows_.data(), filled_, all_.data()}; }

  /// Asks for a body's row ahead of its use.
  void prefetch(std::uint32_t a) const {
    if (a < rows_.size() && rows_[a].count > 0) all_rows().prefetch(a);
  }

  /// A candidate by its place, which it keeps until a pair is added or dropped.
  Candidate& at(std::uint32_t place) { return all_[place]; }
  /// All of them, by place.
  Candidate* all() { return all_.data(); }
  std::uint32_t place_of(const Candidate& candidate) const {
    return static_cast<std::uint32_t>(&candidate - all_.data());
  }

  /// The candidate of two bodies, a < b; null if they are no candidates.
  Candidate* find(std::uint32_t a, std::uint32_t b) {
    for (Candidate& candidate : row(a)) {
      if (candidate.b == b) return &candidate;
    }
    return nullptr;
  }

  /// Adds a pair of this body with one of higher index that are none.
  void add(std::uint32_t a, const Candidate& candidate);

  /// Takes one out of A's row; the last of that row takes its place.
  void drop(std::uint32_t a, Candidate& candidate) {
    candidate = row(a).back();
    if (--rows_[a].count == 0) filled_[a / kRowBits] &= ~row_bit(a);
    --count_;
  }

  /// The memory that grows with the number of bodies, and with that of pairs.
  std::size_t bytes_by_body() const { return bytes_of(rows_) + bytes_of(filled_); }
  std::size_t bytes_by_pair() const { return all_.capacity() * sizeof(Candidate); }

 private:
  static std::uint64_t row_bit(std::uint32_t a) { return std::uint64_t{1} << (a % kRowBits); }

  void pack();

  std::vector<CandidateRow> rows_;     // by body
  std::vector<std::uint64_t> filled_;  // a bit a body: whether its row has candidates
  LargeVector<Candidate> all_;         // and kRowLanes past the last row's room
  std::size_t end_ = 0;                // of the last row's room
  std::size_t count_ = 0;
  std::uint32_t longest_row_ = 0;
};

}  // namespace manifuzz::scene
