#include "cli/starting/workflow.hpp"

#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/text.hpp"
#include "cli/starting/texts.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

/// The source tree in whose folder `build` this program lies, or nothing.
fs::path tree_of_this_program() {
  std::error_code unknown;
  for (fs::path at = fs::read_symlink("/proc/self/exe", unknown); at.has_relative_path();
       at = at.parent_path()) {
    if (at.filename() == "build" && fs::exists(at.parent_path() / "scripts/ci", unknown)) {
      return at.parent_path();
    }
  }
  return {};
}

/// The first line that git prints there; empty where it fails.
std::string line_of_git(const fs::path& tree, const std::string& arguments) {
  const std::string command =
      "git -C " + quoted_for_shell(tree.string()) + ' ' + arguments + " 2>/dev/null";
  std::FILE* const git = popen(command.c_str(), "r");
  if (git == nullptr) return "";
  std::array<char, 1024> buffer{};
  const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), git);
  pclose(git);
  const std::string_view said(buffer.data(), size);
  return std::string(said.substr(0, said.find('\n')));
}

/// Whether others can clone from there, and may read it: a token before the host is a secret.
bool is_remote(const std::string& url) {
  const auto scheme = url.find("://");
  if (scheme == std::string::npos) return url.starts_with("git@");
  if (url.starts_with("file:")) return false;
  const std::string host = url.substr(scheme + 3, url.find('/', scheme + 3) - scheme - 3);
  const auto user_end = host.find('@');
  if (user_end == std::string::npos) return true;
  return url.starts_with("ssh:") && host.find(':') > user_end;
}

/// As a scalar of YAML.
std::string in_yaml(const std::string& text) {
  std::string scalar;
  append_string(scalar, text);
  return scalar;
}

}  // namespace

CloneOf clone_of_this_program() {
  const fs::path tree = tree_of_this_program();
  if (tree.empty()) return {};
  const std::string url = line_of_git(tree, "remote get-url origin");
  return {is_remote(url) ? url : "", line_of_git(tree, "rev-parse HEAD")};
}

std::string workflow_text(const WorkflowOf& workflow) {
  const auto& [subject, oracle, manifuzz, packages, build] = workflow;
  const bool is_program = !subject.command.empty();
  const std::pair<std::string_view, std::string> words[] = {
      {"@url@", manifuzz.url.empty() ? "${{ vars.MANIFUZZ_URL }}" : in_yaml(manifuzz.url)},
      {"@commit@", manifuzz.commit.empty() ? "HEAD" : manifuzz.commit},
      {"@variable@", is_program ? "MANIFUZZ_SUBJECT_COMMAND" : "MANIFUZZ_SUBJECT"},
      {"@subject@", in_yaml(subject.command + subject.name)},
      {"@oracle@", oracle},
      {"@packages@", "ca-certificates git" + packages},
      {"@build@", build.empty() ? "" : "      - name: the collider\n        run: " + build + "\n"}};
  std::string text(kWorkflow);
  for (const auto& [word, meaning] : words) {
    text.replace(text.find(word), word.size(), meaning);
  }
  return text;
}

}  // namespace manifuzz
