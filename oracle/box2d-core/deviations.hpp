#pragma once

#include "judging/ledger.hpp"

namespace manifuzz {

// What the ledger's entries on @box2d/core look for beside Box2D's own faults.

/// @box2d/core: B's face clips, and each point's feature of B is that of A; all else is right.
bool features_lost_by_two_assignments(const Deviation& deviation);
/// @box2d/core: a face shorter than 1e-5, whose direction is not normalised: the normal is as short
/// as the face, and depths are next to none.
bool normal_of_short_face(const Deviation& deviation);
/// @box2d/core: a circle whose centre is within 1e-5 of another's or of an edge's end: the normal
/// is the world's x axis.
bool axis_within_box2d_core_epsilon(const Deviation& deviation);
/// @box2d/core: a circle whose centre is within 1e-5 of a polygon: the normal is a face's, beyond
/// its corner too.
bool face_within_box2d_core_epsilon(const Deviation& deviation);

}  // namespace manifuzz
