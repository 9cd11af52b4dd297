#pragma once

#include "judging/neighbourhood.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// Asks both colliders for the cells of the grid, in child processes: a cell on which one of them
/// dies is judged as crashed. Begins with the case itself and goes on evenly spread, so that the
/// cells asked are a fair sample where it ends early: after `cells_max` cells, after as many
/// crashes as take no longer than that, after the first hang, or when interrupted.
Neighbourhood ask_neighbourhood(const PairCase& pair, const Collider& subject,
                                const Collider& oracle, const Grid& grid, int cells_max,
                                Interruption& interruption);

}  // namespace manifuzz
