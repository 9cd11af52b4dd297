#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "judging/admissible.hpp"

namespace manifuzz {

/// What an entry of the ledger may look at: the oracle's wrong answer, and what would be right.
struct Deviation {
  const Admissible& right;
  const Manifold<double>& got;
  Kind kind = Kind::none;  ///< the first condition of a right answer that it does not meet
  /// The case, which is not `right`'s where the oracle used other shapes; nullptr where unknown.
  const PairCase* asked = nullptr;
};

/// An oracle's answer that is nonsense, or that never came.
struct LostAnswer {
  const PairCase& pair;
  const Answer& answer;
  Lost::How how = Lost::How::malformed;
};

/// How often an entry may fire, at most, in a regime with its own radii.
struct Budget {
  std::string_view regime;
  double per_million = 0;
};

/// A known deviation of an oracle: named, cited, and alive as long as its witness still shows it.
struct LedgerEntry {
  std::string_view id;
  std::string_view collider;          ///< whose deviation it is
  std::string_view description;       ///< one line for `list ledger`
  std::string_view source;            ///< file and function, or issue, where it comes from
  std::span<const Budget> budgets{};  ///< of the regimes in which it fires
  /// Unset where it explains only what is lost.
  bool (*explains)(const Deviation& deviation) = nullptr;
  /// Unset where it explains nothing that is lost.
  bool (*explains_lost)(const LostAnswer& lost) = nullptr;
  /// Its source or its documentation says that it is meant.
  bool is_no_bug = false;
};

/// Every known deviation. An entry is added here, with its witness, and nowhere else.
std::span<const LedgerEntry> ledger();

inline constexpr std::size_t kLedgerMax = 384;

/// The entry's place in the ledger.
std::size_t index_of(const LedgerEntry& entry);

/// The path in the corpus of a case that shows it.
std::string witness_of(const LedgerEntry& entry);

/// The entry's budget in a regime, in hits a million cases: 0 where it names none.
double budget_per_million(const LedgerEntry& entry, std::string_view regime);

/// The first entry that explains what this collider did, or nullptr.
const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation);
/// The first entry that explains an answer that is nonsense, or that never came.
const LedgerEntry* find_explanation(std::string_view collider, const LostAnswer& lost);

// What the ledger's entries look for, in the judge's terms; ledger.cpp says whose deviation each is
// and where it comes from.

/// No contact for overlapping polygons: the bias keeps A's shallower face, whose slab misses.
bool no_contact_under_bias(const Deviation& deviation);
/// No contact for overlapping polygons: of features that tie, one is kept whose slab misses.
bool no_contact_on_tied_features(const Deviation& deviation);
/// The reference face is too short for b2Vec2::Normalize, or shorter than world coordinates
/// resolve.
bool tiny_reference_face(const Deviation& deviation);
/// The square of the reference face's length is beyond float, so that b2Vec2::Normalize divides by
/// infinity.
bool huge_reference_face(const Deviation& deviation);
/// An end of the incident edge lies so near a side plane that the product of both ends' distances
/// underflows: the crossing is not seen, and one point is left.
bool crossing_underflows(const Deviation& deviation);
/// An incident edge that misses the slab, prolonged to it: a point off the polygon, or contact
/// across a gap.
bool edge_extended_to_slab(const Deviation& deviation);
/// The incident edge, along the reference face, is too short to be clipped.
bool incident_edge_unclipped(const Deviation& deviation);
/// The normal is that of vertices that were rounded on the way: off by their roundoff over the
/// face's length.
bool normal_of_rounded_vertices(const Deviation& deviation);
/// The normal is arbitrary, or the contact missed, and a corner of A lies on a corner of B.
bool corner_on_corner(const Deviation& deviation);
/// Contact for polygons that are apart, and the origin lies on the line through two of their
/// difference's corners, beyond them.
bool collinear_and_apart(const Deviation& deviation);
/// The neighbour of the right face is clipped: their directions are nearer than a dot product can
/// tell.
bool neighbours_nearly_parallel(const Deviation& deviation);

/// A collider's answer with its declaration, by reference.
struct ColliderAnswer {
  const Declaration& declaration;
  const Answer& answer;
};

/// In words, what it says that no manifold can say; none of 0 to 2 points, finite figures, no depth
/// below zero, features that exist.
std::optional<std::string> why_malformed(const PairCase& pair, const Manifold<double>& manifold);
/// What is malformed in any answer or in the shapes that it used; one that says nothing is well
/// formed. Depths below zero are allowed to a collider that reports points across gaps.
std::optional<std::string> why_malformed(const PairCase& pair, const ColliderAnswer& given);
/// Why the answer is malformed, or what became of it where it was lost.
std::optional<std::string> why_lost(const PairCase& pair, const ColliderAnswer& given);

/// Whether they match each other within the sum of both bounds, on the cheap: what it says is so,
/// but it leaves to `judge` every case in which anything has to be decided.
bool plainly_agree(const exact::Truth& truth, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle);

/// Whether both match one candidate within their own bounds, hence each other within the sum. Of
/// manifolds that are right.
bool agree_within_bounds(const Manifold<double>& subject, const Admissible& right_for_subject,
                         const Manifold<double>& oracle, const Admissible& right_for_oracle);

/// How the subject's manifold differs from the oracle's, both being right: `from_contact` is the
/// magnitude where only one of them has a contact.
Mismatch difference(const Manifold<double>& subject, const Manifold<double>& oracle,
                    double from_contact);

}  // namespace manifuzz
