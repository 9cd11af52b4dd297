#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "external/manifuzz_timed_world.h"
#include "geometry/pair_case.hpp"

namespace manifuzz {

/// A world of a shared library after manifuzz_timed_world.h, loaded into this process.
class TimedWorld {
 public:
  /// Throws UserError where the library has no such world, or the world cannot take a body.
  TimedWorld(const std::string& path, const std::string& name, std::span<const Body> bodies);
  ~TimedWorld();
  TimedWorld& operator=(TimedWorld&&) = delete;  // neither moved nor copied

  /// What its contacts took, in ns. Throws UserError where that cannot be.
  double step(std::span<const manifuzz_move> moves);
  /// How many pairs touch. Throws likewise.
  std::size_t contacts();

 private:
  std::string name_;
  manifuzz_timed_world* world_ = nullptr;
  decltype(&manifuzz_timed_world_step) step_ = nullptr;
  decltype(&manifuzz_timed_world_contacts) contacts_ = nullptr;
  decltype(&manifuzz_timed_world_destroy) destroy_ = nullptr;
};

/// Whether there is a library that can be loaded and has worlds: not one that was built before they
/// were asked for.
bool has_timed_worlds(const std::string& path);

}  // namespace manifuzz
