#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/text.hpp"
#include "oracle/external/external_collider.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFileName = "subjects.json";

/// The nearest such file: in the folder itself, or in one of those above it.
std::optional<fs::path> subjects_file(const fs::path& corpus) {
  constexpr int kFoldersUp = 4;  // corpus/defects/box2d/case.json, and beside the corpus
  fs::path folder = resolved(corpus);
  for (int up = 0; up <= kFoldersUp; ++up, folder = folder.parent_path()) {
    std::error_code unknown;
    if (fs::is_regular_file(folder / kFileName, unknown)) return folder / kFileName;
  }
  return std::nullopt;
}

NamedSubject read_subject(const JsonView& object) {
  object.expect_keys({"command", "library"});
  NamedSubject subject{object.string_or("command", ""), object.string_or("library", "")};
  if (subject.command.empty() == subject.library.empty()) {
    object.fail("names a command or a library, one of both");
  }
  return subject;
}

}  // namespace

NamedSubjects read_subjects(std::span<const fs::path> corpora) {
  NamedSubjects subjects;
  for (const fs::path& corpus : corpora) {
    const auto path = subjects_file(corpus);
    if (!path) continue;
    InputFile file(path->string());
    try {
      const JsonTree tree = parse_json(file.read_all());
      const JsonView root(tree);
      for (const std::string_view name : root.keys()) {
        subjects.emplace(name, read_subject(root.at(name)));
      }
    } catch (const UserError& error) {
      throw UserError(fmt::format("{}: {}", file.name(), error.what()));
    }
  }
  return subjects;
}

}  // namespace manifuzz
