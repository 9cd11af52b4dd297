#pragma once

#include <string>

namespace manifuzz {

/// Runs commands of gnuplot that draw one picture, which becomes the file. Throws UserError where
/// its name does not end in .svg or .png, or where gnuplot is missing.
void draw_by_gnuplot(const std::string& path, const std::string& commands);

}  // namespace manifuzz
