#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "corpus/corpus.hpp"

namespace manifuzz {

/// Where findings are saved if no corpus is named: build/found of the tree whose build holds this
/// program, where the working folder lies in that tree; else found. From the working folder.
std::filesystem::path findings_folder();

/// Where a command reads known cases, and where it saves new ones.
struct CorpusFolders {
  std::optional<std::string> named{};     ///< one folder for both
  std::optional<std::string> findings{};  ///< another for new ones
  bool is_unsaved = false;                ///< new cases are saved nowhere

  /// The regime `corpus` mutates its cases, and subjects.json lies beside it.
  std::string corpus() const;
  /// New cases are saved there, and known ones are read from there too.
  std::string found() const;
  /// Each of both, once.
  std::vector<std::filesystem::path> all() const;
  /// `found`; empty where nothing is saved.
  std::string save_to() const;
  /// That folder as an output; an error calls it by its option, if it was named.
  OutputPath saved() const;
  /// The option that names the folder again, for a shell, with the space before it; else empty.
  std::string again() const;
  /// Names the folder from the working folder, since no absolute path goes into what is kept.
  void make_relative();
};

/// What is known: both folders, each sorted by path, and a line for each broken file. A folder that
/// is not there is empty. Throws UserError where the name of one is.
Corpus read_known(const CorpusFolders& folders);

/// What is known, where all of it must be read: throws UserError on the first broken file.
Corpus read_whole(const CorpusFolders& folders);

}  // namespace manifuzz
