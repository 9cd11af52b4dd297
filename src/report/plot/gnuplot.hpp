#pragma once

#include <string>

namespace manifuzz {

/// Throws UserError where `path` ends neither in .svg nor in .png.
void expect_plot_name(const std::string& path);

/// Runs commands of gnuplot that draw one picture, which becomes the file. Throws UserError where
/// its name does not end in .svg or .png, or where gnuplot is missing.
void draw_by_gnuplot(const std::string& path, const std::string& commands);

}  // namespace manifuzz
