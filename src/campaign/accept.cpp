#include "campaign/accept.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/known.hpp"
#include "campaign/save.hpp"
#include "judging/bucket.hpp"

namespace manifuzz {
namespace {

/// ", up to 0.5 in normal, 0.1 of the size in depth": each component that is accepted.
std::string limits_in_words(const Errors& up_to) {
  std::string text;
  for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
    if (up_to.all()[i] == 0) continue;
    text += fmt::format(", {}{:.3g}{} in {}", text.empty() ? "up to " : "", up_to.all()[i],
                        unit_of(static_cast<Component>(i)), kComponentNames[i]);
  }
  return text.empty() ? ", no error beyond bounds" : text;
}

}  // namespace

bool is_of_same_kind(const CorpusCase& known, const CorpusCase& wanted) {
  if (!known.expect || !wanted.expect || known.property != wanted.property) return false;
  const Expectation& one = *known.expect;
  const Expectation& other = *wanted.expect;
  if (!known.property.empty()) return one.subject == other.subject;
  const auto bucket = find_bucket(one.bucket);
  const auto other_bucket = find_bucket(other.bucket);
  return bucket && other_bucket && is_unexplained(bucket->verdict) &&
         kind_key(*bucket, one.subject, one.oracle) ==
             kind_key(*other_bucket, other.subject, other.oracle);
}

Acceptance acceptance_of(const CorpusCase& known, Acceptance asked) {
  const Expectation expect = known.expect.value_or(Expectation{});
  const auto bucket = find_bucket(expect.bucket);
  const bool is_mistake = !known.property.empty() || (bucket && is_unexplained(bucket->verdict));
  if (!is_mistake || expect.subject.empty()) {
    throw UserError(
        fmt::format("{}: shows nobody's mistake; a finding that a campaign or a property "
                    "saved is expected",
                    printable(known.path, 200)));
  }
  const std::optional<Seen> seen = known.found ? known.found->seen : std::nullopt;
  const bool has_errors = expect.errors || (seen && seen->errors);
  if (!asked.up_to && !seen && !expect.magnitude && !has_errors) {
    throw UserError(
        fmt::format("{}: does not record how bad it is; say with --up-to how bad it may be",
                    printable(known.path, 200)));
  }
  // Shrinking again and again may have made it worse than any case that the campaign met.
  const auto limit = [](double seen_error, double as_saved) {
    return std::max(kAcceptedTimesWorst * seen_error, as_saved);
  };
  const Errors as_saved = expect.errors.value_or(Errors{});
  const Errors worst = seen && seen->errors ? *seen->errors : as_saved;
  if (worst != Errors{} || as_saved != Errors{}) {
    Errors& up_to = asked.errors_up_to.emplace();
    for (std::size_t i = 0; i < kComponentNames.size(); ++i) {
      const double of_component = limit(worst.all()[i], as_saved.all()[i]);
      up_to.all()[i] = of_component > 0 ? asked.up_to.value_or(of_component) : 0;
    }
    asked.up_to.reset();
  } else if (!asked.up_to) {
    const double magnitude = expect.magnitude.value_or(0);
    asked.up_to = limit(seen ? seen->magnitude : magnitude, magnitude);
  }
  if (!seen) return asked;
  for (const auto& [regime, count] : seen->regimes) {
    asked.per_million[regime] = accepted_per_million(count, seen->cases);
  }
  return asked;
}

CorpusCase accepted_case(const std::string& file, const Acceptance& asked) {
  CorpusCase known = read_case_file(file, CaseKind::either);
  known.accepted = acceptance_of(known, asked);
  return known;
}

void accept_in(const std::filesystem::path& corpus, CorpusCase& accepted) {
  if (!accepted.path.ends_with(".json")) {
    accepted.path = write_corpus_case(corpus / corpus_folder(accepted), accepted).string();
  }
  write_acceptance(accepted.path, accepted.accepted);
}

void drop_acceptance(const std::string& file) {
  if (!read_case_file(file, CaseKind::either).accepted) {
    throw UserError(fmt::format("--drop: {} is not accepted", printable(file, 200)));
  }
  write_acceptance(file, {});
}

std::string acceptance_in_words(const CorpusCase& accepted, const std::string& today) {
  const Acceptance& acceptance = *accepted.accepted;
  const Expectation expect = accepted.expect.value_or(Expectation{});
  const std::string what =
      accepted.property.empty() ? expect.bucket : fmt::format("property {}", accepted.property);
  std::string text = fmt::format("accepted {}: {} of {}", printable(accepted.path, 200), what,
                                 printable(expect.subject));
  if (acceptance.up_to) text += fmt::format(", up to {:.3g} of the size", *acceptance.up_to);
  if (acceptance.errors_up_to) text += limits_in_words(*acceptance.errors_up_to);
  if (acceptance.is_of_kind) text += ", and other buckets of its kind";
  if (!acceptance.until.empty()) {
    const bool is_past = acceptance.until < today;
    text += fmt::format(", until {}{}", acceptance.until, is_past ? ", which is past" : "");
  }
  text += ": " + printable(acceptance.because, 400);
  if (!acceptance.link.empty()) text += fmt::format(" ({})", printable(acceptance.link, 400));
  return text;
}

std::string list_accepted(const Corpus& known_cases, const std::string& today) {
  std::string text;
  for (const CorpusCase& known : known_cases.all()) {
    if (known.accepted) text += acceptance_in_words(known, today) + '\n';
  }
  return text;
}

}  // namespace manifuzz
