#include "unit/committed_tree.hpp"

#include <filesystem>

#include "support/run_program.hpp"
#include "support/source_tree.hpp"
#include "support/temporary_folder.hpp"

namespace manifuzz::test {

namespace fs = std::filesystem;

namespace {

/// The paths git keeps; in a tree without git, every file of the folders that hold sources.
std::vector<std::string> committed_paths() {
  std::vector<std::string> paths;
  std::string listed;
  if (fs::exists(source_dir() / ".git")) {
    const std::string top = source_dir().string();
    listed = run_program({"env", "git", "-c", "safe.directory=*", "-C", top, "ls-files", "-z"}).out;
  }
  for (std::size_t begin = 0; begin < listed.size();) {
    const std::size_t end = listed.find('\0', begin);
    paths.push_back(listed.substr(begin, end - begin));
    begin = end + 1;
  }
  if (!paths.empty()) return paths;
  for (const char* folder : {"src", "oracle", "tests", "corpus", "scripts"}) {
    if (!fs::exists(source_dir() / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(source_dir() / folder)) {
      paths.push_back(fs::relative(entry.path(), source_dir()).generic_string());
    }
  }
  return paths;
}

}  // namespace

const std::vector<SourceFile>& tree() {
  static const std::vector<SourceFile> files = [] {
    std::vector<SourceFile> found;
    for (const std::string& path : committed_paths()) {
      if (fs::is_regular_file(source_dir() / path))
        found.push_back({path, text_of(source_dir() / path)});
    }
    return found;
  }();
  return files;
}

}  // namespace manifuzz::test
