#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "report/picture/svg.hpp"

struct _cairo;
struct _cairo_surface;

namespace manifuzz {

/// 0xRRGGBB.
using Colour = std::uint32_t;

/// A picture in pixels, y down, white at first. Texts are as wide as `text_width` says, at most.
class Canvas {
 public:
  Canvas(int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// All pixels of the box, whose figures are whole.
  void fill(const Box& box, Colour colour);
  /// A line of one pixel around the box, whose figures are whole.
  void frame(const Box& box, Colour colour);
  void ring(const Point& center, double radius, double line_width, Colour colour);
  /// `at`: the left end of the base line. What is not printable ASCII is drawn escaped.
  void text(const Point& at, std::string_view text, const Font& font, Colour colour);

  /// The topmost rows as a PNG file.
  std::string png(int height) const;

 private:
  void set(Colour colour);

  _cairo_surface* surface_;
  _cairo* context_;
};

}  // namespace manifuzz
