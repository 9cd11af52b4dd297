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

/// From where CI, which has none of this machine's keys, can clone what this machine clones from
/// there; empty where that is not known. A token before the host is a secret, so it is not written.
std::string url_for_all(const std::string& url) {
  const auto scheme_end = url.find("://");
  const std::string scheme = url.substr(0, scheme_end);
  if (scheme_end == std::string::npos) {  // USER@HOST:PATH, or a folder
    const auto host_end = url.find(':');
    if (!url.starts_with("git@") || host_end == std::string::npos) return "";
    const auto path = url.find_first_not_of('/', host_end + 1);
    if (path == std::string::npos) return "";
    return "https://" + url.substr(4, host_end - 4) + '/' + url.substr(path);
  }
  if (scheme == "file") return "";
  const auto host_begin = scheme_end + 3;
  const std::string host = url.substr(host_begin, url.find('/', host_begin) - host_begin);
  const auto user_end = host.find('@');
  if (scheme == "ssh") {
    if (host.find(':') != std::string::npos) return "";  // the port of a server of its own
    return "https://" + url.substr(host_begin + (user_end == std::string::npos ? 0 : user_end + 1));
  }
  return user_end == std::string::npos ? url : "";
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
  return {url_for_all(line_of_git(tree, "remote get-url origin")),
          line_of_git(tree, "rev-parse HEAD")};
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
