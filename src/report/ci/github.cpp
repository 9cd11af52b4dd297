#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "report/ci/ci_output.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

/// All but what `is_plain` says as %XX.
std::string percent_encoded(std::string_view text, const std::function<bool(char)>& is_plain) {
  std::string out;
  for (const char c : text) {
    out += is_plain(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

/// As the runner reads it back: in data % and line ends, in properties : and , too.
std::string escape_command(std::string_view text, bool is_property) {
  const std::string_view special = is_property ? "%\r\n:," : "%\r\n";
  return percent_encoded(fit_for_logs(text, "\r\n"),
                         [&](char c) { return special.find(c) == special.npos; });
}

using Failures = std::vector<std::pair<const TestSuite*, const TestResult*>>;

Failures failures_of(std::span<const TestSuite> suites) {
  Failures failures;
  for (const TestSuite& suite : suites) {
    for (const TestResult& test : suite.tests) {
      if (test.failure) failures.emplace_back(&suite, &test);
    }
  }
  return failures;
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
  if (suite.skipped() > 0) {
    parts.push_back(fmt::format("{} of {} skipped", suite.skipped(), suite.tests.size()));
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

namespace fs = std::filesystem;

/// The file, or its line, from the root of the checked out repository; "" where it lies outside.
std::string in_repository(const std::string& file) {
  const std::string root = environment("GITHUB_WORKSPACE");
  if (root.empty() || file.empty()) return "";
  std::error_code unknown;
  const fs::path path = fs::relative(file, root, unknown);
  return unknown || path.empty() || *path.begin() == ".." ? "" : path.generic_string();
}

/// The address of the picture beside a case of the repository, at this commit; "" where there is
/// none.
std::string image_of(const std::string& file) {
  std::error_code unknown;
  const fs::path picture = fs::path(file).replace_extension(".svg");
  const std::string path = in_repository(picture.string());
  const std::string commit = environment("GITHUB_SHA");
  const std::string repository = environment("GITHUB_REPOSITORY");
  const std::string server = environment("GITHUB_SERVER_URL");
  if (path.empty() || commit.empty() || repository.empty() || server.empty()) return "";
  if (!fs::is_regular_file(picture, unknown)) return "";
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  const std::string address =
      percent_encoded(path, [&](char c) { return plain.find(c) != plain.npos; });
  return fmt::format("{}/{}/raw/{}/{}", server, repository, commit, address);
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
  std::vector<std::string> lines;
  for (const TestSuite& suite : suites) {
    for (const std::string& error : suite.errors) {
      lines.push_back(error_annotation(suite.name, "", error));
    }
  }
  for (const auto& [suite, test] : failures_of(suites)) {
    std::string message = in_words(*test->failure);
    if (!test->failure->command.empty()) message += '\n' + test->failure->command;
    lines.push_back(error_annotation(suite->name + ": " + test->name,
                                     in_repository(test->failure->file), message));
  }
  if (lines.size() > kAnnotationsMax) {
    const std::size_t left = lines.size() - (kAnnotationsMax - 1);
    lines.resize(kAnnotationsMax - 1);
    lines.push_back(error_annotation("manifuzz", "", fmt::format("and {} more", left)));
  }
  return fmt::format("{}", fmt::join(lines, ""));
}

std::string step_summary(std::span<const TestSuite> suites, std::size_t room,
                         const std::function<std::string(const std::string& file)>& image_of) {
  std::string text;
  for (const TestSuite& suite : suites) text += head_of(suite);
  const Failures failures = failures_of(suites);
  const std::size_t for_the_rest = rest_in_words(failures.size()).size();
  std::size_t described = 0;
  for (; described < std::min(failures.size(), kDescribedMax); ++described) {
    const auto& [suite, test] = failures[described];
    const std::string next = description_of(*suite, *test, image_of(test->failure->file));
    if (text.size() + next.size() + for_the_rest > room) break;
    text += next;
  }
  text += rest_in_words(failures.size() - described);
  return text.size() <= room ? text : "";
}

bool is_in_workflow() {
  return environment("GITHUB_ACTIONS") == "true";
}

std::string step_summary_file() {
  return is_in_workflow() ? environment("GITHUB_STEP_SUMMARY") : "";
}

std::string workflow_annotations(std::span<const TestSuite> suites) {
  return annotations(suites, in_repository);
}

void append_step_summary(const std::string& file, std::span<const TestSuite> suites) {
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(file, missing);
  const std::size_t used = missing ? 0 : static_cast<std::size_t>(size);
  const std::size_t room = kSummaryBytesMax - std::min(used, kSummaryBytesMax);
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::app);
  stream << step_summary(suites, room, image_of) << std::flush;
  if (stream) return;
  throw UserError(fmt::format("{}: cannot write the step summary: {}", printable(file, 200),
                              std::strerror(errno)));
}

}  // namespace manifuzz
