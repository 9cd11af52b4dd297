#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/picture/region.hpp"

namespace manifuzz {

struct Font {
  double size = 12;  ///< in pixels
  bool bold = false;
};

/// At most this wide, in pixels.
double text_width(std::string_view text, const Font& font);

/// The text in lines of at most this width, broken at blanks; a word that is longer is cut.
std::vector<std::string> wrapped(std::string_view text, const Font& font, double width);

/// A plain SVG 1.1 document in the making, in pixels, y down. `css` names classes of the style
/// sheet that `finish` is given.
class Svg {
 public:
  void polygon(const Region& region, std::string_view css);
  void line(const Segment& segment, std::string_view css);
  void circle(const Point& center, double radius, std::string_view css);
  void box(const Box& box, std::string_view css, double corner_radius = 0);
  /// `at`: the left end of the base line.
  void text(const Point& at, std::string_view text, const Font& font, std::string_view css);

  /// Draws all of `other` on top.
  void append(const Svg& other) { body_ += other.body_; }

  /// The document; `title` is for readers who cannot see it.
  std::string finish(double width, double height, std::string_view title,
                     std::string_view style) const;

 private:
  std::string body_;
};

}  // namespace manifuzz
