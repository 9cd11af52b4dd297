#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "hunting/rounds.hpp"

namespace manifuzz {

/// Whose archives a folder holds. Files of another hunt are refused.
struct ArchiveFolder {
  std::filesystem::path path;
  std::string hunt;  ///< in words: all that its cases depend on
  Rounds rounds;
  std::optional<Measure> measure;
};

/// round-ROUND-share-SHARE.archive of the folder.
std::filesystem::path archive_file(const ArchiveFolder& folder, const RoundShare& of);

/// Throws UserError where what that share writes would replace an archive of another hunt.
void expect_no_other_hunt(const ArchiveFolder& folder, const RoundShare& of);

/// Writes what that share has found, whole or not at all. Throws UserError.
void write_archive(const ArchiveFolder& folder, const RoundShare& of,
                   const std::vector<ArchivedCase>& cases);

/// What `write_archive` wrote. Throws UserError that names the file where it is not there, not
/// whole, or another's.
std::vector<ArchivedCase> read_archive(const ArchiveFolder& folder, const RoundShare& of);

/// The best of all shares of the rounds before this one, in the order of `best_of`. Throws
/// UserError as `read_archive` does.
std::vector<ArchivedCase> read_rounds_before(const ArchiveFolder& folder, std::uint64_t round);

/// How many cells all rounds fill together. Throws UserError as `read_archive` does.
FilledCells cells_of_all(const ArchiveFolder& folder);

}  // namespace manifuzz
