#include "cli/starting/starters.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "base/text.hpp"
#include "cli/starting/texts.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

const Starter kInPython{.language = "Python",
                        .signs = {"pyproject.toml", "requirements.txt", "setup.py", ".py"},
                        .file = "collider.py",
                        .text = &kPythonCollider,
                        .program = "python3",
                        .packages = " python3"};

/// In the order in which signs are looked for: build files of C lie beside bindings of all kinds.
const Starter kStarters[] = {
    {.language = "JavaScript",
     .signs = {"package.json"},
     .file = "collider.cjs",
     .text = &kJavaScriptCollider,
     .program = "node",
     .packages = " nodejs"},
    {.language = "Rust", .signs = {"Cargo.toml"}, .file = "", .text = nullptr},
    {.language = "Java",
     .signs = {"pom.xml", "build.gradle", "build.gradle.kts"},
     .file = "",
     .text = nullptr},
    kInPython,
    {.language = "C",
     .signs = {"CMakeLists.txt", "meson.build", ".c", ".cc", ".cpp", ".h", ".hpp"},
     .file = "collider.c",
     .text = &kCCollider,
     .library = "libcollider.so",
     .packages = " gcc libc6-dev"}};

bool shows(const fs::path& folder, const Starter& starter) {
  std::error_code unreadable;
  const fs::directory_iterator entries(folder, unreadable);
  return std::any_of(begin(entries), end(entries), [&](const fs::directory_entry& entry) {
    const std::string name = entry.path().filename().string();
    const std::string ending = entry.path().extension().string();
    return std::ranges::any_of(
        starter.signs, [&](std::string_view sign) { return sign == name || sign == ending; });
  });
}

}  // namespace

const Starter& starter_for(const fs::path& folder) {
  for (const Starter& starter : kStarters) {
    if (!shows(folder, starter)) continue;
    if (starter.text != nullptr) return starter;
    throw UserError(fmt::format(
        "init: there is no collider in {} to begin with; name yours by --subject-command COMMAND "
        "or --subject ./LIBRARY.so (src/external/README.md says how to write one)",
        starter.language));
  }
  return kInPython;
}

std::string making(const std::string& source, const std::string& library,
                   const std::string& headers) {
  return fmt::format("cc -O2 -shared -fPIC -I {} {} -o {} -lm", headers, source, library);
}

std::string packages_for(const std::string& command) {
  const std::string program = fs::path(command.substr(0, command.find(' '))).filename().string();
  constexpr std::pair<std::string_view, std::string_view> packages[] = {
      {"python", " python3"}, {"node", " nodejs"}, {"java", " default-jre-headless"}};
  for (const auto& [name, package] : packages) {
    if (program.starts_with(name)) return std::string(package);
  }
  return "";
}

}  // namespace manifuzz
