#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace manifuzz {

/// A collider to begin with, in a language: it runs as it is, and is there to be edited.
struct Starter {
  std::string_view language;
  std::vector<std::string_view> signs;  ///< names, or endings, of files of projects in it
  std::string_view file;                ///< its name where it is written
  const std::string_view* text;
  std::string_view program{};   ///< what runs the file, or
  std::string_view library{};   ///< the shared library that is made of it
  std::string_view packages{};  ///< of Debian, that it needs, with a space before each
};

/// The one of the first language of which the folder shows a sign; the one in Python where it shows
/// none. Throws UserError where there is none in its language.
const Starter& starter_for(const std::filesystem::path& folder);

/// The command that makes the library of a source, for a shell; its header is in `headers`.
std::string making(const std::string& source, const std::string& library,
                   const std::string& headers);

/// The packages of Debian that a command's first word needs, each with a space before it.
std::string packages_for(const std::string& command);

}  // namespace manifuzz
