#include <algorithm>
#include <ranges>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/replay.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

using Checked = std::span<const CheckedProperty>;

constexpr std::size_t kFailuresShown = 5;

/// "applies to none of these cases: one, two", of the properties that it is true of; else empty.
std::string line_of_names(std::string_view what, Checked checked, const auto& is_so) {
  std::vector<std::string_view> names;
  for (const CheckedProperty& one : checked) {
    if (is_so(one)) names.push_back(one.property->name);
  }
  return names.empty() ? "" : fmt::format("{}: {}\n", what, fmt::join(names, ", "));
}

/// The property, and the command that shows its failure.
std::string failure_in_words(const CheckedProperty& failed, const CalledAgain& again) {
  const std::string objection = failed.objection.empty() ? "" : "; " + failed.objection;
  const std::string drawn =
      failed.hunted_by.empty() ? fmt::format("RC_PARAMS=\"{}\" ", failed.result.reproduce) : "";
  const std::string command = !failed.saved.empty()
                                  ? fmt::format("{} show {}{}", again.program,
                                                quoted_for_shell(failed.saved), again.to_show)
                                  : fmt::format("{}{} property {} {}", drawn, again.program,
                                                failed.names_again(), again.options);
  return fmt::format("{} {}: {}{}\n  {}\n", bad("FAIL"), failed.property->name,
                     failed.property->sentence, objection, command);
}

}  // namespace

std::string property_text(const CheckedProperty& checked) {
  const PropertyResult& result = checked.result;
  const std::string how = result.passed         ? good("ok  ")
                          : checked.is_accepted ? "accepted"
                                                : bad("FAIL");
  if (checked.is_vacuous() || checked.is_left_out()) return property_line(checked);
  std::string text = fmt::format("{} {}: {}\n{}\n", how, checked.property->name,
                                 checked.property->sentence, result.report);
  if (!checked.objection.empty()) text += fmt::format("{}\n", bad(checked.objection));
  if (!result.reproduce.empty()) {
    text += fmt::format("repeat with RC_PARAMS=\"{}\"\n", result.reproduce);
  }
  if (!checked.saved.empty()) text += fmt::format("saved {}\n", checked.saved);
  return text;
}

std::string property_screen(Checked checked, const std::string& subject, const CalledAgain& again) {
  const auto has_failed = [](const CheckedProperty& one) { return !one.holds(); };
  const auto is_tested = [](const CheckedProperty& one) {
    return !one.is_vacuous() && !one.is_left_out();
  };
  const auto tested = std::ranges::count_if(checked, is_tested);
  const auto passed = std::ranges::count_if(
      checked, [&](const CheckedProperty& one) { return is_tested(one) && one.result.passed; });
  std::string text =
      fmt::format("{}: {} of {} {}\n", subject, passed, counted(tested, "property", "properties"),
                  tested == 1 ? "holds" : "hold");
  std::size_t shown = 0;
  for (const CheckedProperty& one : checked | std::views::filter(has_failed)) {
    if (++shown <= kFailuresShown) text += failure_in_words(one, again);
  }
  if (shown > kFailuresShown) {
    const std::size_t others = shown - kFailuresShown;
    text += fmt::format("and {} {}: --verbose has all\n", others,
                        others == 1 ? "other fails" : "others fail");
  }
  text += line_of_names("accepted", checked, [](const CheckedProperty& one) {
    return !one.result.passed && one.is_accepted;
  });
  text += line_of_names("applies to none of these cases", checked,
                        [](const CheckedProperty& one) { return one.is_vacuous(); });
  return text + line_of_names("left out, for time was up", checked,
                              [](const CheckedProperty& one) { return one.is_left_out(); });
}

std::string property_line(const CheckedProperty& checked) {
  const Property& property = *checked.property;
  if (checked.is_left_out()) {
    return fmt::format("--   {}: left out, for time was up\n", property.name);
  }
  if (checked.is_vacuous()) {
    return fmt::format("--   {}: applies to none of {}\n", property.name,
                       counted(checked.result.cases, "case"));
  }
  return fmt::format("{} {}: {}, {}\n", checked.is_accepted ? "accepted" : good("ok  "),
                     property.name, property.sentence, counted(checked.result.cases, "case"));
}

}  // namespace manifuzz
