#include <string>

#include <fmt/format.h>

#include "engines/provenance.hpp"
#include "report/measurements/measurements.hpp"

namespace manifuzz {
namespace {

std::string digits_of(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

}  // namespace

std::string digest_table(const DigestPlan& plan, const Digest& digest) {
  const Declaration& declaration = plan.collider.declaration;
  constexpr const char* kRow = "{:<18}{:>12}{:>12}{:>20}\n";
  std::string text = fmt::format("{} {}: every bit of its answers, seed {}\n\n", declaration.name,
                                 declaration.version, plan.seed) +
                     fmt::format(fmt::runtime(kRow), "regime", "cases", "contacts", "digest");
  for (const RegimeDigest& regime : digest.regimes) {
    text += fmt::format(fmt::runtime(kRow), regime.regime, plan.cases, regime.contacts,
                        digits_of(regime.hash));
  }
  return text + fmt::format(fmt::runtime(kRow), "all", digest.regimes.size() * plan.cases, "",
                            digits_of(digest.hash));
}

nlohmann::ordered_json digest_json(const DigestPlan& plan, const Digest& digest) {
  nlohmann::ordered_json json = provenance(plan.seed, {plan.collider.declaration});
  json["collider"] = plan.collider.declaration.name;
  json["cases"] = digest.regimes.size() * plan.cases;
  json["digest"] = digits_of(digest.hash);
  json["regimes"] = nlohmann::ordered_json::array();
  for (const RegimeDigest& regime : digest.regimes) {
    json["regimes"].push_back({{"name", regime.regime},
                               {"cases", plan.cases},
                               {"contacts", regime.contacts},
                               {"digest", digits_of(regime.hash)}});
  }
  return json;
}

}  // namespace manifuzz
