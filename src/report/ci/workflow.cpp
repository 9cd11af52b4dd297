#include "report/ci/workflow.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "report/ci/github.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
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

}  // namespace

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
