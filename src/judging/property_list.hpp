#pragma once

#include "judging/properties.hpp"

/// The one list of properties: a function, defined in a file of its theme (properties_*.cpp), a
/// name, and a sentence that is true of every right collider.
#define MANIFUZZ_PROPERTIES(PROPERTY)                                                           \
  PROPERTY(swapping_mirrors, "swapping-mirrors",                                                \
           "swapping A and B mirrors the manifold, outside ties")                               \
  PROPERTY(renumbering_changes_features_only, "renumbering",                                    \
           "renumbering the vertices changes features only, outside ties")                      \
  PROPERTY(quarter_turns_move, "quarter-turns",                                                 \
           "a quarter turn of the world moves the manifold along, outside ties")                \
  PROPERTY(translations_move, "translations",                                                   \
           "a translation that floats can represent moves the manifold along, outside ties")    \
  PROPERTY(powers_of_two_scale, "powers-of-two",                                                \
           "scaling by a power of two scales the manifold, bit for bit")                        \
  PROPERTY(given_normal_agrees, "given-normal",                                                 \
           "the given-normal entry agrees with collide, outside ties")                          \
  PROPERTY(points_lie_where_they_say, "points-in-place",                                        \
           "points lie on the incident edge, in the slab, behind the reference face, in order") \
  PROPERTY(depth_is_the_overlap, "depth-is-overlap",                                            \
           "at bias 0 and S <= 0 the largest depth is the total radius minus S")                \
  PROPERTY(depth_moves_apart, "depth-moves-apart",                                              \
           "moving B by the depth along the normal leaves them touching at zero, and on by t "  \
           "separates them by t")                                                               \
  PROPERTY(float_and_double_agree, "float-and-double", "float and double agree within bound")   \
  PROPERTY(overlap_is_never_empty, "never-empty", "overlapping is never empty")                 \
  PROPERTY(manifold_is_admissible, "admissible",                                                \
           "every manifold is one of the right ones, within bound")

namespace manifuzz {

#define MANIFUZZ_DECLARE(function, name, sentence) \
  Outcome function(AskedCollider& ask, const PairCase& pair);
MANIFUZZ_PROPERTIES(MANIFUZZ_DECLARE)
#undef MANIFUZZ_DECLARE

}  // namespace manifuzz
