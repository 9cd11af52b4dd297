#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "afresh/cells.hpp"
#include "afresh/shape_table.hpp"
#include "scene/body.hpp"
#include "scene/placing.hpp"
#include "scene/rows.hpp"

namespace manifuzz::scene {

/// A step that is divided has so many tasks, whatever runs them.
inline constexpr std::size_t kTasks = 8;

/// From the first to before the last of some things.
struct Share {
  std::size_t first;  ///< of its things
  std::size_t last;   ///< behind its last one
};

/// What one of so many tasks has of so many things.
inline Share share_of(std::size_t things, std::size_t task, std::size_t tasks) {
  return {task * things / tasks, (task + 1) * things / tasks};
}

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

/// What a run of rows needs, and what comes of it; several are gone through at once, or one alone.
struct RowWork {
  Queue touching;                          ///< pairs that touched
  Queue apart;                             ///< pairs that did not, and are not proven apart
  Queue leaving;                           ///< pairs of which a body left its box
  std::vector<Manifold<float>> manifolds;  ///< of those apart, as the kernel gave them
  std::vector<std::uint32_t> undrawn;      ///< bodies whose tight boxes are to be drawn
  std::vector<Proof> proofs;               ///< to be written
  std::vector<Beginning> beginning;        ///< pairs that begin to touch
  std::vector<std::uint32_t> vacant;       ///< contacts that ended
  std::vector<EndedContact> ended;         ///< as they are reported
  PairCounts pairs;                        ///< what was done with the candidates
  std::size_t proof_count = 0;             ///< of pairs that are apart
  std::size_t compared = 0;                ///< pairs whose tight boxes were compared

  /// The memory it takes.
  std::size_t bytes() const {
    return touching.bytes() + apart.bytes() + leaving.bytes() + bytes_of(manifolds) +
           bytes_of(undrawn) + bytes_of(proofs) + bytes_of(beginning) + bytes_of(vacant) +
           bytes_of(ended);
  }
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

/// What the look at some bodies needs, and what comes of it.
struct LeaverWork {
  std::vector<std::uint32_t> places;  ///< of bodies to be drawn
  std::vector<Leaver> left;           ///< those that left

  /// The memory it takes.
  std::size_t bytes() const { return bytes_of(places) + bytes_of(left); }
};

/// What the search for partners of some bodies that left their boxes needs, and what comes of it.
struct PartnerWork {
  std::vector<Cells::Run> runs;          ///< where some boxes' partners may lie
  std::vector<std::uint32_t> found;      ///< by one of the boxes, and room
  std::vector<kernel::BodyPair> adding;  ///< pairs that are to be candidates
  std::vector<std::uint32_t> alone;      ///< bodies that have no partners
  std::vector<std::uint32_t> with_few;   ///< bodies that have few

  /// The memory it takes.
  std::size_t bytes() const {
    return bytes_of(runs) + bytes_of(found) + bytes_of(adding) + bytes_of(alone) +
           bytes_of(with_few);
  }
};

}  // namespace manifuzz::scene
