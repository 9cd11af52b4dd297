#include <array>

#include <fmt/format.h>

#include "exchange/json.hpp"
#include "report/upstream/parts.hpp"
#include "report/upstream/program.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

const DeclaredAnswer& answer_at_fault(const JudgedCase& judged) {
  const Fault fault = judged.judgement.bucket.fault;
  if (fault == Fault::none) {
    throw UserError("--upstream: nobody is at fault in this case; there is nothing to report");
  }
  return fault == Fault::oracle ? judged.oracle : judged.subject;
}

/// Where a template does not say it.
std::string language_of(const Program& program) {
  if (!program.language.empty()) return program.language;
  return program.text.find("#include") != std::string::npos ? "cpp" : "";
}

/// For a collider without a program: its case for `judge`.
Program judged_again(const PairCase& pair, const std::string& options) {
  std::string line;
  append_case_line(line, pair);
  Program program;
  program.text = fmt::format("manifuzz judge {} <<'END'\n{}\nEND\n", options, line);
  program.language = "sh";
  return program;
}

std::string cause_in_words(const LedgerEntry* explanation) {
  if (explanation == nullptr) return {};
  return fmt::format(" Cause: {} ({}).", explanation->description, explanation->source);
}

/// What was got and what is right, in as many digits as it takes to tell one from the other.
std::array<std::string, 2> got_and_expected(const JudgedCase& judged, const DeclaredAnswer& asked,
                                            const Program& program) {
  const PairCase& pair = judged.given.pair();
  const int digits_max = asked.declaration.scalar == ScalarType::float32 ? 9 - 7 : 17 - 9;
  Detail detail{.has_features = judged.judgement.bucket.kind == Kind::features};
  for (;; ++detail.more_digits) {
    const std::string got = got_in_words(pair, asked, program, detail);
    const std::string expected = expected_in_words(pair, asked, program, detail);
    if (!expected.starts_with(got) || detail.more_digits == digits_max) return {got, expected};
  }
}

/// How many neighbours failed, of those that were asked when the case was found.
std::string neighbours_in_words(const JudgedCase& judged) {
  if (!judged.given.expect || !judged.given.expect->severity) return {};
  const double share = *judged.given.expect->severity;
  const std::string failing = share >= 1   ? "all fail too"
                              : share <= 0 ? "almost none fails"
                                           : fmt::format("{:.3g} % fail too", 100 * share);
  return fmt::format("- Neighbours, with one vertex moved by up to 64 ulps each way: {}.\n",
                     failing);
}

}  // namespace

std::string upstream_report(const JudgedCase& judged, const std::string& options) {
  const DeclaredAnswer& asked = answer_at_fault(judged);
  const PairCase& pair = judged.given.pair();
  const std::string& snippet = asked.declaration.snippet;
  const Program program =
      snippet.empty() ? judged_again(pair, options) : program_for(snippet, pair);
  std::string text = fmt::format("# {}\n\n{} {}", upstream_title(judged, asked),
                                 asked.declaration.name, asked.declaration.version);
  if (!program.function.empty()) text += fmt::format(", `{}`", program.function);
  text += "." + cause_in_words(judged.judgement.explanation);
  text += "\n\n" + code_block(program.text, language_of(program)) + '\n';
  const auto [got, expected] = got_and_expected(judged, asked, program);
  const std::string read =
      program.figures.empty() ? "" : fmt::format(" (figures {})", program.figures);
  text += fmt::format("- Got: {}{}.\n- Expected: {}.\n", got, read, expected);
  text += fmt::format("- Users see: {}.\n", seen_by_users(judged, asked));
  text += neighbours_in_words(judged);
  return text + fmt::format("- By hand: {}\n", checked_by_hand(pair));
}

}  // namespace manifuzz
