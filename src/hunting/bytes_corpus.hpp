#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "geometry/pair_case.hpp"

namespace manifuzz {

// A corpus of cases as JSON, and one of files that hold the bytes of one case each
// (hunting/case_bytes.hpp).

/// How many were written, and how many were left out.
struct Rewritten {
  std::size_t written = 0;
  std::size_t left_out = 0;
};

/// Writes the pair cases in these files and folders, as far as they are asked for, as bytes: a file
/// each in the folder, which is made, named by a hash of it. Throws UserError where one is broken
/// or cannot be written.
Rewritten write_as_bytes(std::span<const std::filesystem::path> cases,
                         const std::filesystem::path& folder,
                         const std::function<bool(const PairCase&)>& is_asked_for);

/// Writes each of these files, and of the files in these folders, as a corpus case; what is no case
/// is left out. Throws UserError where there is no such file or one cannot be read or written.
Rewritten write_as_json(std::span<const std::filesystem::path> inputs,
                        const std::filesystem::path& folder);

}  // namespace manifuzz
