#include "external/timed_world.hpp"

#include <cmath>
#include <dlfcn.h>
#include <filesystem>

#include <fmt/format.h>

#include "base/text.hpp"
#include "external/external_collider.hpp"
#include "external/side_effects.hpp"

namespace manifuzz {
namespace {

/// Throws UserError where the library has no function of that name.
template <class Function>
void find_function(void* library, const char* name, const std::string& path, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  if (function != nullptr) return;
  throw UserError(
      fmt::format("{}: has no {}; see manifuzz_timed_world.h", printable(path, 200), name));
}

}  // namespace

TimedWorld::TimedWorld(const std::string& path, const std::string& name,
                       std::span<const Body> bodies)
    : name_(name) {
  void* const library = open_library(path);
  decltype(&manifuzz_timed_world_create) create = nullptr;
  decltype(&manifuzz_timed_world_add) add = nullptr;
  find_function(library, "manifuzz_timed_world_create", path, create);
  find_function(library, "manifuzz_timed_world_add", path, add);
  find_function(library, "manifuzz_timed_world_step", path, step_);
  find_function(library, "manifuzz_timed_world_contacts", path, contacts_);
  find_function(library, "manifuzz_timed_world_destroy", path, destroy_);
  const CallWatch watch;
  world_ = create(name.c_str());
  std::size_t added = 0;
  while (world_ != nullptr && added < bodies.size()) {
    const manifuzz_body body = c_body(bodies[added]);
    if (add(world_, &body) != 0) break;
    ++added;
  }
  watch.end();
  if (world_ == nullptr) {
    throw UserError(fmt::format("{}: has no world {}", printable(path, 200), name));
  }
  if (added == bodies.size()) return;
  destroy_(world_);
  throw UserError(fmt::format("{}: its world cannot take body {}", name, added));
}

TimedWorld::~TimedWorld() {
  destroy_(world_);
}

double TimedWorld::step(std::span<const manifuzz_move> moves) {
  const CallWatch watch;
  const double ns = step_(world_, moves.data(), static_cast<std::int32_t>(moves.size()));
  watch.end();
  if (std::isfinite(ns) && ns >= 0) return ns;
  throw UserError(fmt::format("{}: a step of {} ns", name_, ns));
}

std::size_t TimedWorld::contacts() {
  const CallWatch watch;
  const std::int64_t count = contacts_(world_);
  watch.end();
  if (count >= 0) return static_cast<std::size_t>(count);
  throw UserError(fmt::format("{}: {} contacts", name_, count));
}

bool has_timed_worlds(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) return false;
  try {
    return dlsym(open_library(path), "manifuzz_timed_world_create") != nullptr;
  } catch (const UserError&) {
    return false;
  }
}

}  // namespace manifuzz
