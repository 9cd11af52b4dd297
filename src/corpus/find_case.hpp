#pragma once

#include <filesystem>
#include <string>

namespace manifuzz {

/// A case's file, and what there is to say of the choice.
struct FoundCase {
  std::string file;
  std::string remark{};  ///< "taken: ..." where the name was not the file's
};

/// The file that is meant: the name itself where it is "-" or exists. Else it is looked up in the
/// corpus, as a bucket (with slashes or dashes), whose smallest case it is then, or as the
/// beginning of a file's name. Throws UserError where that gives no case, or several.
FoundCase find_case(const std::string& name, const std::filesystem::path& corpus);

}  // namespace manifuzz
