#include "engines/provenance.hpp"

#include <fstream>
#include <string>
#include <thread>

#include "kernel/target.hpp"

namespace manifuzz {
namespace {

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t value = line.find_first_not_of(" \t", line.find(':') + 1);
    return value == std::string::npos ? "unknown" : line.substr(value);
  }
  return "unknown";
}

std::string_view compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

}  // namespace

nlohmann::ordered_json provenance(std::uint64_t seed, const std::vector<Declaration>& colliders) {
  nlohmann::ordered_json json;
  json["machine"] = {{"processor", processor()},
                     {"cores", std::thread::hardware_concurrency()},
                     {"instruction_set", kernel::targets().front()}};
  json["compiler"] = compiler();
  json["seed"] = seed;
  json["versions"]["manifuzz"] = MANIFUZZ_VERSION;
  for (const Declaration& collider : colliders) json["versions"][collider.name] = collider.version;
  return json;
}

}  // namespace manifuzz
