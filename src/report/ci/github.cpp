#include "report/ci/github.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/markdown.hpp"

namespace manifuzz {
namespace {

/// As the runner reads it back: in data % and line ends, in properties : and , too.
std::string escape_command(std::string_view text, bool is_property) {
  std::string out;
  for (const char c : text) {
    const bool is_special =
        c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ','));
    out += is_special ? fmt::format("%{:02X}", c) : std::string(1, c);
  }
  return out;
}

std::size_t failures_of(std::span<const TestSuite> suites) {
  std::size_t count = 0;
  for (const TestSuite& suite : suites) count += suite.failures();
  return count;
}

std::size_t errors_of(std::span<const TestSuite> suites) {
  std::size_t count = 0;
  for (const TestSuite& suite : suites) count += suite.errors.size();
  return count;
}

/// Calls `use` for the first so many failing tests.
void for_failures(std::span<const TestSuite> suites, std::size_t most,
                  const std::function<void(const TestSuite&, const TestResult&)>& use) {
  std::size_t seen = 0;
  for (const TestSuite& suite : suites) {
    for (const TestResult& test : suite.tests) {
      if (test.failure && ++seen <= most) use(suite, test);
    }
  }
}

std::string table_of(const TestSuite& suite) {
  std::string text;
  for (std::size_t row = 0; row < suite.table.size(); ++row) {
    for (const std::string& cell : suite.table[row]) text += "| " + escape_markdown(cell) + ' ';
    text += "|\n";
    if (row > 0) continue;
    for (std::size_t i = 0; i < suite.table[0].size(); ++i) text += i == 0 ? "|---" : "|---:";
    text += "|\n";
  }
  return text;
}

std::string result_in_words(const TestSuite& suite) {
  std::vector<std::string> parts;
  const std::size_t errors = suite.errors.size();
  if (errors > 0) parts.push_back(fmt::format("{} {}", errors, errors == 1 ? "error" : "errors"));
  if (suite.failures() > 0) {
    parts.push_back(fmt::format("{} of {} failed", suite.failures(), suite.tests.size()));
  }
  return parts.empty() ? "passed" : fmt::format("{}", fmt::join(parts, ", "));
}

/// What did not take place, as many as are described.
std::string errors_in_words(const TestSuite& suite) {
  std::string text;
  for (const std::string& error : suite.errors) {
    if (&error == suite.errors.data() + kDescribedMax) {
      return text + fmt::format("- and {} more\n\n", suite.errors.size() - kDescribedMax);
    }
    text += fmt::format("- **{}**\n", escape_markdown(error));
  }
  return text.empty() ? text : text + '\n';
}

std::string head_of(const TestSuite& suite) {
  return fmt::format("## {}: {}\n\n{}\n\n{}{}\n", escape_markdown(suite.name),
                     result_in_words(suite), escape_markdown(suite.headline),
                     errors_in_words(suite), table_of(suite));
}

std::string description_of(const TestSuite& suite, const TestResult& test,
                           const std::string& image) {
  const TestFailure& failure = *test.failure;
  std::string text =
      fmt::format("### {}: {}\n\n", escape_markdown(suite.name), escape_markdown(test.name));
  text += fmt::format("Expected {}, got **{}**\n\n", escape_markdown(failure.expected),
                      escape_markdown(failure.got));
  if (!failure.file.empty() && failure.file != test.name) {
    text += fmt::format("File: {}\n\n", escape_markdown(failure.file));
  }
  if (!image.empty()) text += fmt::format("![the case]({})\n\n", image);
  if (!failure.picture.empty()) text += code_block(failure.picture, "text") + '\n';
  if (!failure.command.empty())
    text += "Repeat it with\n\n" + code_block(failure.command, "sh") + '\n';
  return text;
}

std::string rest_in_words(std::size_t count) {
  return count == 0 ? "" : fmt::format("And {} more, in the log and in the JUnit report.\n", count);
}

}  // namespace

std::pair<std::string_view, std::string_view> file_and_line(std::string_view file) {
  const std::size_t colon = file.rfind(':');
  const std::string_view line = colon == file.npos ? "" : file.substr(colon + 1);
  const bool is_number = !line.empty() && line.find_first_not_of("0123456789") == line.npos;
  if (!is_number) return {file, ""};
  return {file.substr(0, colon), line};
}

std::string error_annotation(std::string_view title, std::string_view file,
                             std::string_view message) {
  std::string text = "::error title=" + escape_command(title, true);
  const auto [name, line] = file_and_line(file);
  if (!name.empty()) text += ",file=" + escape_command(name, true);
  if (!line.empty()) text += fmt::format(",line={}", line);
  return text + "::" + escape_command(message, false) + '\n';
}

std::string annotations(std::span<const TestSuite> suites, const FileInRepository& in_repository) {
  const std::size_t all = errors_of(suites) + failures_of(suites);
  const std::size_t shown = all <= kAnnotationsMax ? all : kAnnotationsMax - 1;
  std::vector<std::string> lines;
  for (const TestSuite& suite : suites) {
    for (const std::string& error : suite.errors) {
      lines.push_back(error_annotation(suite.name, "", error));
    }
  }
  for_failures(suites, shown, [&](const TestSuite& suite, const TestResult& test) {
    std::string message = in_words(*test.failure);
    if (!test.failure->command.empty()) message += '\n' + test.failure->command;
    lines.push_back(error_annotation(suite.name + ": " + test.name,
                                     in_repository(test.failure->file), message));
  });
  lines.resize(std::min(lines.size(), shown));
  if (shown < all) {
    lines.push_back(error_annotation("manifuzz", "", fmt::format("and {} more", all - shown)));
  }
  return fmt::format("{}", fmt::join(lines, ""));
}

std::string step_summary(std::span<const TestSuite> suites, std::size_t room,
                         const std::function<std::string(const std::string& file)>& image_of) {
  std::string text;
  for (const TestSuite& suite : suites) text += head_of(suite);
  const std::size_t failed = failures_of(suites);
  const std::size_t for_the_rest = rest_in_words(failed).size();
  std::size_t described = 0;
  bool is_full = false;
  for_failures(suites, kDescribedMax, [&](const TestSuite& suite, const TestResult& test) {
    const std::string next = description_of(suite, test, image_of(test.failure->file));
    is_full = is_full || text.size() + next.size() + for_the_rest > room;
    if (is_full) return;
    text += next;
    ++described;
  });
  text += rest_in_words(failed - described);
  return text.size() <= room ? text : "";
}

}  // namespace manifuzz
