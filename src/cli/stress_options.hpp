#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/collider_choice.hpp"

namespace manifuzz {

/// What `stress` is asked for; empty is not.
struct StressOptions {
  std::vector<std::string> sweeps;
  std::vector<std::string> colliders;
  ColliderChoice program{"collider", "", ""};
  ExternalOptions outside;
  std::optional<std::uint64_t> cases;
  std::optional<std::uint64_t> frames;
  std::optional<std::uint64_t> seed;
  std::optional<std::uint64_t> jobs;
  bool quick = false;
  bool flush_to_zero = false;
  std::string json;
  std::string csv;
  std::string pictures;
  std::string save;
  std::string baseline;
  std::string store;
};

void add_stress_options(CLI::App& app, StressOptions& options);

}  // namespace manifuzz
