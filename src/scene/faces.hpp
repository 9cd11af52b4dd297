#pragma once

#include <cstdint>
#include <span>

#include "afresh/shape_table.hpp"
#include "kernel/packed.hpp"
#include "scene/candidates.hpp"
#include "scene/rows.hpp"

namespace manifuzz::scene {

/// What is asked of bodies between which faces are looked at again.
struct FacedBodies {
  const kernel::ShapeCorners<float>* corners;  ///< by shape
  const kernel::ShapeRows* rows;               ///< by shape
  const ShapeFacts* facts;                     ///< by shape
  const kernel::Placement<float>* placements;  ///< by body
  const float* paths;           ///< by body; lengths, none less than the least normal float
  const Candidate* candidates;  ///< by place
};

/// Looks at the faces that lay between so many pairs of a queue, from the first on: `known[i]`
/// becomes what is known (`apart_until`) of two bodies between which theirs lies still, or 0 where
/// it does not, or none is known. Where `known` ends, there is room up to a multiple of kPairLanes.
void prove_by_faces(const FacedBodies& bodies, const Queue& queue, std::size_t first,
                    std::size_t count, std::uint32_t* known);

}  // namespace manifuzz::scene
