#pragma once

#include <filesystem>

namespace manifuzz {

/// Makes an empty file where nothing was. False where it cannot; errno is then EEXIST where
/// something is there.
bool make_new_file(const std::filesystem::path& path);

}  // namespace manifuzz
