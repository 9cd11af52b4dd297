#include "corpus/corpus_folders.hpp"

#include "base/text.hpp"

namespace manifuzz {

namespace fs = std::filesystem;

fs::path findings_folder() {
  std::error_code unknown;
  const fs::path here = fs::current_path(unknown);
  for (fs::path at = fs::read_symlink("/proc/self/exe", unknown); at.has_relative_path();
       at = at.parent_path()) {
    if (at.filename() == "build" && is_within(here, at.parent_path())) {
      return kept_path(at / "found");
    }
  }
  return "found";
}

std::string CorpusFolders::corpus() const {
  return named.value_or("corpus");
}

std::string CorpusFolders::found() const {
  if (findings) return *findings;
  return named ? corpus() : findings_folder().string();
}

std::string CorpusFolders::save_to() const {
  return is_unsaved ? "" : found();
}

OutputPath CorpusFolders::saved() const {
  const char* const option = findings ? "--found" : named ? "--corpus" : "findings";
  return {option, save_to(), OutputPath::Kind::corpus};
}

std::vector<fs::path> CorpusFolders::all() const {
  if (found() == corpus()) return {corpus()};
  return {corpus(), found()};
}

std::string CorpusFolders::again() const {
  return named ? " --corpus " + quoted_for_shell(kept_path(*named).string()) : "";
}

void CorpusFolders::make_relative() {
  for (auto* const folder : {&named, &findings}) {
    if (*folder && !(*folder)->empty()) *folder = kept_path(**folder).string();
  }
}

Corpus read_known(const CorpusFolders& folders) {
  Corpus known;
  for (const fs::path& folder : folders.all()) known.add(read_known(folder));
  return known;
}

Corpus read_whole(const CorpusFolders& folders) {
  Corpus known = read_known(folders);
  if (!known.errors.empty()) throw UserError(known.errors.front());
  return known;
}

}  // namespace manifuzz
