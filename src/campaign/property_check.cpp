#include "campaign/property_check.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "base/user_error.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

/// Writes the failing case to the corpus and returns its path.
std::string save(const std::string& corpus, const Property& property, const Collider& subject,
                 const PropertyResult& result) {
  CorpusCase failing;
  failing.pair = *result.failing;
  failing.property = std::string(property.name);
  failing.note = fmt::format("{} {}: {}: {}.", subject.declaration.name,
                             subject.declaration.version, property.sentence, result.why);
  return write_corpus_case(std::filesystem::path(corpus) / "regressions", failing).string();
}

/// When the first of so many, who share what time is left, must be done.
Deadline share_of(const Deadline& deadline, std::size_t count) {
  if (!deadline) return deadline;
  const auto now = Clock::now();
  return now + (*deadline - now) / static_cast<int>(count);
}

}  // namespace

std::vector<CheckedProperty> check_properties(
    const std::vector<const Property*>& chosen, const Collider& subject, const PropertyPlan& plan,
    const Deadline& deadline, const std::string& save_to,
    const std::function<void(const CheckedProperty&)>& on_checked) {
  std::vector<CheckedProperty> all;
  Interruption signals(kUntilSignal);
  for (const Property* const property : chosen) {
    const auto start = Clock::now();
    Interruption interruption({.hurried_at = share_of(deadline, chosen.size() - all.size())});
    PropertyPlan in_turn = plan;
    in_turn.interruption = &interruption;
    CheckedProperty checked{property, run_property(*property, subject, in_turn)};
    checked.seconds = seconds_since(start);
    try {
      if (checked.result.failing && !save_to.empty()) {
        checked.saved = save(save_to, *property, subject, checked.result);
      }
    } catch (const UserError& error) {
      checked.why_unsaved = error.what();
    }
    on_checked(checked);
    all.push_back(checked);
    if (signals.is_stopped()) break;
  }
  return all;
}

}  // namespace manifuzz
