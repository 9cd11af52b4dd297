#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "collider/collider.hpp"
#include "judging/admissible.hpp"
#include "judging/manifold_error.hpp"

namespace manifuzz {

/// What became of a property on one case.
struct PropertyOutcome {
  enum class Kind {
    holds,
    not_applicable,  ///< a tie, no contact, or the collider does not offer what it takes
    known,           ///< it fails, and the ledger explains an answer that it asked for
    fails,
  };
  Kind kind = Kind::holds;
  std::string why;       ///< of a failure, for people
  double magnitude = 0;  ///< of a failure, as a share of the size
  bool is_lost = false;  ///< of a failure: the collider died or hung
  /// Where the property holds: the greatest share of its bound that anything compared takes, at
  /// most 1; 0 where nothing is measured.
  double of_bound = 0;
};

class AskedCollider;

/// A sentence that must be true of every collider, whatever an oracle says.
struct Property {
  std::string_view name;
  std::string_view sentence;
  PropertyOutcome (*holds)(AskedCollider& ask, const PairCase& pair);
};

/// Every property, as listed below.
std::span<const Property> properties();

/// The property on one case of one collider, through the ledger.
PropertyOutcome check(const Property& property, const Collider& collider, const PairCase& pair);

// What properties are written with: asking a collider, outcomes, and holding two manifolds against
// each other.

/// What a property asks of a collider, remembered so that the ledger can be asked in turn.
class AskedCollider {
 public:
  explicit AskedCollider(const Collider& collider) : collider_(collider) {}

  const Collider& collider() const { return collider_; }
  const Declaration& declaration() const { return collider_.declaration; }
  const std::vector<PairCase>& asked() const { return asked_; }

  /// Its manifold, or none where it does not take the case.
  std::optional<Manifold<double>> manifold(const PairCase& pair) {
    asked_.push_back(pair);
    const Answer answer = ask(collider_, pair);
    const auto* const found = std::get_if<Manifold<double>>(&answer);
    const auto* const lost = std::get_if<Lost>(&answer);
    if (lost && !lost_) lost_ = *lost;
    return found ? std::optional(*found) : std::nullopt;
  }

  /// The first time that it died, hung, or answered nonsense.
  const std::optional<Lost>& lost() const { return lost_; }

 private:
  const Collider& collider_;
  std::optional<Lost> lost_;
  std::vector<PairCase> asked_;
};

inline PropertyOutcome holds(double of_bound = 0) {
  return {.why = {}, .of_bound = of_bound};
}
/// How much of its bound a difference takes, between 0 and 1.
inline double taken_of(double bound, double off) {
  return bound > 0 && off > 0 ? std::min(off / bound, 1.0) : 0;
}
inline PropertyOutcome not_applicable() {
  return {.kind = PropertyOutcome::Kind::not_applicable, .why = {}};
}
inline PropertyOutcome fails(std::string why, double magnitude) {
  return {.kind = PropertyOutcome::Kind::fails, .why = std::move(why), .magnitude = magnitude};
}

/// What is right for this collider, if nothing that decides it is within bound: one reference face
/// by a clear lead, one incident edge, both ends clearly kept, clipped or dropped. Nothing of those
/// that claim less than a manifold.
std::optional<Admissible> decided(const PairCase& pair, const Declaration& declaration);

/// By how much two right manifolds of one case may differ: the sum of both bounds.
ManifoldError tolerance(const Admissible& right);

enum class Features { compared, ignored };

/// Holds where both manifolds, given in one frame, are the same within the tolerance.
PropertyOutcome same_manifold(const PairCase& pair, const Manifold<double>& expected,
                              const Manifold<double>& got, const ManifoldError& within,
                              Features features);

/// The one list of properties: a function, defined in properties.cpp, properties_manifold.cpp or
/// properties_round.cpp, a name, and a sentence that is true of every right collider.
#define MANIFUZZ_PROPERTIES(PROPERTY)                                                             \
  PROPERTY(swapping_mirrors, "swapping-mirrors",                                                  \
           "swapping A and B mirrors the manifold, outside ties")                                 \
  PROPERTY(renumbering_changes_features_only, "renumbering",                                      \
           "renumbering the vertices changes features only, outside ties")                        \
  PROPERTY(quarter_turns_move, "quarter-turns",                                                   \
           "a quarter turn of the world moves the manifold along, outside ties")                  \
  PROPERTY(translations_move, "translations",                                                     \
           "a translation that floats can represent moves the manifold along, outside ties")      \
  PROPERTY(powers_of_two_scale, "powers-of-two",                                                  \
           "scaling by a power of two scales the manifold, bit for bit")                          \
  PROPERTY(given_normal_agrees, "given-normal",                                                   \
           "the given-normal entry agrees with collide, outside ties")                            \
  PROPERTY(points_lie_where_they_say, "points-in-place",                                          \
           "points lie on the incident edge, in the slab, behind the reference face, in order")   \
  PROPERTY(depth_is_the_overlap, "depth-is-overlap",                                              \
           "at bias 0 and S <= 0 the largest depth is the total radius minus S")                  \
  PROPERTY(depth_moves_apart, "depth-moves-apart",                                                \
           "moving B by the depth along the normal leaves them touching at zero, and on by t "    \
           "separates them by t")                                                                 \
  PROPERTY(float_and_double_agree, "float-and-double", "float and double agree within bound")     \
  PROPERTY(overlap_is_never_empty, "never-empty", "overlapping is never empty")                   \
  PROPERTY(manifold_is_admissible, "admissible",                                                  \
           "every manifold is one of the right ones, within bound")                               \
  PROPERTY(circles_may_turn, "circles-turn", "turning a circle about its centre changes nothing") \
  PROPERTY(capsules_are_hulls_of_circles, "capsules-are-hulls",                                   \
           "a capsule is as deep as the deepest circle along it")                                 \
  PROPERTY(circles_are_limits_of_polygons, "circles-are-limits",                                  \
           "a circle is as deep as the regular polygons in it and around it, within their "       \
           "distance")

#define MANIFUZZ_COUNT(function, name, sentence) +1
inline constexpr std::size_t kPropertyCount = 0 MANIFUZZ_PROPERTIES(MANIFUZZ_COUNT);
#undef MANIFUZZ_COUNT

#define MANIFUZZ_DECLARE(function, name, sentence) \
  PropertyOutcome function(AskedCollider& ask, const PairCase& pair);
MANIFUZZ_PROPERTIES(MANIFUZZ_DECLARE)
#undef MANIFUZZ_DECLARE

}  // namespace manifuzz
