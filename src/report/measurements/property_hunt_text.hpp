#pragma once

#include <string>

#include "hunting/property_hunt.hpp"

namespace manifuzz {

// What hunts of properties print, for people.

/// One line of a running hunt: cases, rate, cells filled, how many properties fail, the nearest to
/// its bound of those that hold.
std::string property_hunt_line(const PropertyHuntProgress& progress);

/// A line of a hunt that ended: cases, generations, cells, and that nearest one.
std::string property_hunt_row(const PropertyHunt& hunt);

}  // namespace manifuzz
