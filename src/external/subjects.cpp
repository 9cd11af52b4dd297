#include <algorithm>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/text.hpp"
#include "external/external_collider.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kFileName = "subjects.json";

/// Such a file in the folder of a corpus, or in the one that holds it.
std::optional<fs::path> subjects_file(const fs::path& corpus) {
  const fs::path folder = resolved(corpus);
  std::error_code unknown;
  if (!fs::is_directory(folder, unknown)) return std::nullopt;
  for (const fs::path& at : {folder, folder.parent_path()}) {
    if (fs::is_regular_file(at / kFileName, unknown)) return at / kFileName;
  }
  return std::nullopt;
}

/// What it names is started: whoever else could have written it would run it as this user.
void expect_own(const fs::path& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0 || status.st_uid == 0 || status.st_uid == geteuid()) return;
  throw UserError(
      fmt::format("{}: belongs to another user and names programs to start; if you trust "
                  "it, give it as --subjects FILE",
                  printable(file.string(), 200)));
}

NamedSubject read_subject(const JsonView& object) {
  object.expect_keys({"command", "library"});
  NamedSubject subject{object.string_or("command", ""), object.string_or("library", "")};
  if (subject.command.empty() == subject.library.empty()) {
    object.fail("either \"command\" or \"library\" is expected");
  }
  return subject;
}

void add_subjects(NamedSubjects& subjects, const fs::path& path) {
  InputFile file(path.string());
  const std::string text = file.read_all();  // its errors name the file themselves
  try {
    const JsonTree tree = parse_json(text);
    const JsonView root(tree);
    for (const std::string_view name : root.keys()) {
      subjects.emplace(name, read_subject(root.at(name)));
      subjects.find(name)->second.file = file.name();
    }
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}: {}", file.name(), error.what()));
  }
}

}  // namespace

NamedSubjects read_subjects(const SubjectsFrom& from) {
  NamedSubjects subjects;
  if (!from.file.empty()) add_subjects(subjects, from.file);
  for (const fs::path& corpus : from.corpora) {
    const auto path = subjects_file(corpus);
    if (!path || !from.file.empty()) continue;
    expect_own(*path);
    add_subjects(subjects, *path);
  }
  return subjects;
}

}  // namespace manifuzz
