#include "cli/property_check.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "cli/collider_options.hpp"
#include "cli/shown.hpp"
#include "corpus/corpus.hpp"
#include "report/github.hpp"
#include "report/style.hpp"

namespace manifuzz {
namespace {

using Clock = std::chrono::steady_clock;

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

TestFailure failure_of(const CheckedProperty& checked, const std::string& options) {
  const PropertyResult& result = checked.result;
  TestFailure failure{std::string(checked.property->sentence),
                      result.why.empty() ? "a failure" : result.why, checked.saved};
  if (!result.failing) return failure;
  failure.got += " of ";
  append_case_line(failure.got, *result.failing);
  failure.command =
      fmt::format("RC_PARAMS={} {} property {} {}", quoted_for_shell(result.reproduce),
                  this_program(), checked.property->name, options);
  return failure;
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
    checked.seconds = std::chrono::duration<double>(Clock::now() - start).count();
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

std::string property_text(const CheckedProperty& checked) {
  const PropertyResult& result = checked.result;
  std::string text = fmt::format("{} {}: {}\n{}\n", result.passed ? good("ok  ") : bad("FAIL"),
                                 checked.property->name, checked.property->sentence, result.report);
  if (!result.reproduce.empty())
    text += fmt::format("repeat with RC_PARAMS=\"{}\"\n", result.reproduce);
  if (!checked.saved.empty()) text += fmt::format("saved {}\n", checked.saved);
  return text;
}

TestSuite property_suite(const std::vector<CheckedProperty>& checked, const Collider& subject,
                         const std::string& options, Interruption& interruption) {
  TestSuite suite{"manifuzz property", "", {}, {{"property", "result", "cases", "seconds"}}};
  std::size_t pictures = 0;
  std::size_t left_out = 0;
  for (const CheckedProperty& one : checked) {
    if (one.is_left_out()) {
      ++left_out;
      continue;
    }
    TestResult test{std::string(one.property->name), one.seconds};
    if (!one.result.passed) {
      test.failure = failure_of(one, options);
      const bool is_drawn = one.result.failing && ++pictures <= kDescribedMax;
      if (is_drawn) add_picture(*test.failure, *one.result.failing, subject, interruption);
    }
    suite.table.push_back({test.name, one.result.passed ? "ok" : "FAIL",
                           std::to_string(one.result.cases), fmt::format("{:.2f}", one.seconds)});
    suite.tests.push_back(test);
  }
  suite.headline = fmt::format("{}: {} properties, {} failed", subject.declaration.name,
                               suite.tests.size(), suite.failures());
  if (left_out > 0) suite.headline += fmt::format("; {} left out, for time was up", left_out);
  return suite;
}

}  // namespace manifuzz
