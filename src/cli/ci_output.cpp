#include "cli/ci_output.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "base/user_error.hpp"
#include "report/github.hpp"
#include "report/junit.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_on_github() {
  return environment("GITHUB_ACTIONS") == "true";
}

/// The file, or its line, from the root of the checked out repository; "" where it lies outside.
std::string in_repository(const std::string& file) {
  const std::string root = environment("GITHUB_WORKSPACE");
  if (root.empty() || file.empty()) return "";
  std::error_code unknown;
  const fs::path path = fs::relative(file, root, unknown);
  return unknown || path.empty() || *path.begin() == ".." ? "" : path.generic_string();
}

/// A path as a part of an address.
std::string escape_path(std::string_view path) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/";
  std::string out;
  for (const char c : path) {
    out += plain.find(c) != plain.npos ? std::string(1, c)
                                       : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
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
  return fmt::format("{}/{}/raw/{}/{}", server, repository, commit, escape_path(path));
}

/// What other programs of this step wrote stays.
void append_summary(const std::string& file, std::span<const TestSuite> suites) {
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(file, missing);
  const std::size_t used = missing ? 0 : static_cast<std::size_t>(size);
  const std::size_t room = kSummaryBytesMax - std::min(used, kSummaryBytesMax);
  errno = 0;
  std::ofstream stream(file, std::ios::binary | std::ios::app);
  stream << step_summary(suites, room, image_of) << std::flush;
  if (stream) return;
  write_complaint(fmt::format("{}: cannot write the step summary: {}", printable(file, 200),
                              std::strerror(errno)));
}

}  // namespace

void add_junit(CLI::App& app, CiOutput& ci) {
  app.add_option("--junit", ci.junit, "a JUnit XML report, - for stdout")->type_name("FILE");
}

bool is_wanted(const CiOutput& ci) {
  return !ci.junit.empty() || is_on_github();
}

void write_ci(const CiOutput& ci, std::vector<TestSuite> suites, Outputs& outputs) {
  auto& errors = suites.front().errors;
  errors.insert(errors.end(), outputs.errors().begin(), outputs.errors().end());
  outputs.write(!ci.junit.empty(), [&] { write_data(ci.junit, junit_xml(suites)); });
  if (!is_on_github()) return;
  const std::string text = annotations(suites, in_repository);
  ci.stdout_is_data ? write_error(text) : write_to_reader(text);
  const std::string summary = environment("GITHUB_STEP_SUMMARY");
  std::error_code unknown;
  const bool is_junit = std::filesystem::equivalent(summary, ci.junit, unknown) && !unknown;
  if (is_junit)
    write_complaint("GITHUB_STEP_SUMMARY: is what --junit writes; the summary is left out");
  if (!summary.empty() && !is_junit) append_summary(summary, suites);
}

int run_for_ci(std::string_view command, const CiOutput& ci, const std::function<int()>& run) {
  try {
    return run();
  } catch (const BadOutput&) {
    throw;
  } catch (const std::exception& error) {
    TestSuite suite{fmt::format("manifuzz {}", command), "", {}};
    suite.errors.emplace_back(error.what());
    Outputs outputs;
    write_ci(ci, {suite}, outputs);
    throw;
  }
}

}  // namespace manifuzz
