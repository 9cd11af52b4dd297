#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/user_error.hpp"

namespace manifuzz {

/// An option, and the file or folder that it names to be written; an empty path: none.
struct OutputPath {
  enum class Kind {
    data,    ///< a file, or "-" for the standard output
    file,    ///< a file
    folder,  ///< a folder for files that are no cases
    corpus,  ///< a folder for cases
  };
  std::string_view option;  ///< "--json"
  std::string path;
  Kind kind = Kind::data;
  std::vector<std::string_view> endings{};  ///< one of which a file's name must have, if any
  std::string replaces{};                   ///< an input whose place it may take
};

/// What the names of pictures end in.
inline const std::vector<std::string_view> kPictureEndings{".svg", ".png"};

/// Everything that a command reads and writes.
struct CommandFiles {
  std::vector<OutputPath> outputs;
  std::vector<std::filesystem::path> inputs{};  ///< files, and folders whose cases are read
};

/// What must not or cannot be written.
struct BadOutput : UserError {
  BadOutput(const std::string& what, std::vector<std::string_view> which)
      : UserError(what), options(std::move(which)) {}

  bool concerns(std::string_view option) const;

  std::vector<std::string_view> options;  ///< those that it is about
};

/// The check that every command makes before it runs; whether an output takes the standard output,
/// which then has nothing else. Paths are compared by the file that they mean, not by their
/// spelling. Throws BadOutput where two outputs go to one place; where one is a file that is read,
/// or would be taken for a case of a folder that is read or written; and where one cannot be made:
/// what is missing of it is made and taken away again.
bool check_outputs(const CommandFiles& files);

/// Whether this output would pass beside these, but for whether it can be made.
bool is_apart(const OutputPath& output, const CommandFiles& files);

}  // namespace manifuzz
