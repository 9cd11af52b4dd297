#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "afresh/cells.hpp"
#include "afresh/shape_table.hpp"
#include "scene/body.hpp"
#include "scene/division.hpp"
#include "scene/placing.hpp"

namespace manifuzz::scene {

/// So many pairs ahead, contacts and candidates are asked for: they lie anywhere in memory.
inline constexpr std::size_t kContactsAhead = 16;

/// The place so far ahead of one among so many, or the last one.
inline std::size_t ahead_of(std::size_t place, std::size_t by, std::size_t count) {
  return std::min(place + by, count - 1);
}

/// A pair that begins to touch.
struct Beginning {
  kernel::BodyPair bodies;   ///< A and B
  Candidate* candidate;      ///< theirs
  Manifold<float> manifold;  ///< as the kernel gave it
};

/// What is proven of a candidate, to be written once no thread reads rows any more: their vectors
/// reach past a row's end.
struct Proof {
  std::uint32_t place;  ///< among the candidates
  std::uint32_t known;  ///< `Candidate::known`
};

/// A candidate whose boxes overlap no longer.
struct Parted {
  std::uint32_t a;      ///< its row
  std::uint32_t place;  ///< among the candidates
};

/// What comes of a look at some candidates: a run of rows, or those that are new.
struct PairWork {
  Scratch* scratch = nullptr;         ///< in which its pairs wait while they are looked at
  Candidate* candidates = nullptr;    ///< among which those that wait have their places
  bool are_read = false;              ///< by others at the same time: proofs are written later
  std::vector<Proof> proofs;          ///< to be written
  std::vector<Beginning> beginning;   ///< pairs that begin to touch
  std::vector<Parted> parted;         ///< pairs to be dropped
  std::vector<std::uint32_t> vacant;  ///< contacts that ended
  std::vector<EndedContact> ended;    ///< as they are reported
  PairCounts pairs;                   ///< what was done with the candidates
  std::size_t proof_count = 0;        ///< of pairs that are apart
  std::size_t compared = 0;           ///< pairs whose tight boxes were compared

  /// What is known of a candidate, as `Candidate::know` has it; written now or later.
  void know(std::uint32_t place, std::uint32_t known) {
    if (are_read) {
      proofs.push_back({place, known});
    } else {
      candidates[place].know(known);
    }
  }

  /// The memory it takes.
  std::size_t bytes() const {
    return bytes_of(proofs) + bytes_of(beginning) + bytes_of(parted) + bytes_of(vacant) +
           bytes_of(ended);
  }
};

/// What moves are found to be before any is made.
struct CheckedMoves {
  std::optional<RefusedMove> refused;  ///< the first that is
  /// Whether they are made in tasks: there are enough, and they ascend, so that no two are of one
  /// body. Where some bodies have several parts, that is found out of the parts' moves.
  bool may_divide = false;
};

/// What comes of the moves of some bodies.
struct MoverWork {
  std::vector<std::uint32_t> moved;  ///< bodies that moved
  std::vector<Mover> unsure;         ///< those that may have left their fattened boxes

  /// The memory it takes.
  std::size_t bytes() const { return bytes_of(moved) + bytes_of(unsure); }
};

/// A body that left its fattened box, and that box.
struct Leaver {
  std::uint32_t body;  ///< its place
  Box before;          ///< the box that it left
};

/// What comes of the search for partners of some bodies that left their boxes.
struct PartnerWork {
  std::vector<std::uint32_t> lower;     ///< of the pairs that are to be candidates, A,
  std::vector<Candidate> adding;        ///< and what else is known of them
  std::vector<std::uint32_t> alone;     ///< bodies that have no partners
  std::vector<std::uint32_t> with_few;  ///< bodies that have few

  /// The memory it takes.
  std::size_t bytes() const {
    return bytes_of(lower) + bytes_of(adding) + bytes_of(alone) + bytes_of(with_few);
  }
};

}  // namespace manifuzz::scene
