#include "report/picture/svg.hpp"

#include <array>
#include <iterator>

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/xml.hpp"

namespace manifuzz {
namespace {

constexpr std::string_view kFonts = "DejaVu Sans, Verdana, Bitstream Vera Sans, sans-serif";

/// The widths of DejaVu Sans from blank to tilde, in hundredths of an em: the widest of its kind.
constexpr std::array<unsigned char, 95> kWidths{
    32, 41, 46, 84, 64, 96, 78, 28, 40,  40, 50, 84, 32, 37, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 54, 100, 69, 69, 70, 78, 64, 58, 78, 76, 30, 30, 66, 56, 87, 75, 79,
    61, 79, 70, 64, 62, 74, 69, 99, 69,  62, 69, 40, 34, 40, 84, 50, 50, 62, 64, 55, 64, 62, 36, 64,
    64, 28, 28, 58, 28, 98, 64, 62, 64,  64, 42, 53, 40, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84,
};
constexpr double kBoldIsWider = 1.15;

double width_of(char c) {
  const bool is_printable = c >= ' ' && c <= '~';
  return is_printable ? kWidths[static_cast<std::size_t>(c - ' ')] / 100.0 : 1.0;
}

/// A pixel's hundredth is enough. Zero has no sign.
std::string number(double pixels) {
  std::string text = fmt::format("{:.2f}", pixels);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

double text_width(std::string_view text, const Font& font) {
  double width = 0;
  for (const char c : text) width += width_of(c);
  return width * font.size * (font.bold ? kBoldIsWider : 1.0);
}

std::vector<std::string> wrapped(std::string_view text, const Font& font, double width) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t fits = 1;
    while (fits < text.size() && text_width(text.substr(0, fits + 1), font) <= width) ++fits;
    std::size_t end = fits;
    if (fits < text.size()) {
      const std::size_t blank = text.rfind(' ', fits);
      if (blank != text.npos && blank > 0) end = blank;
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
    while (text.starts_with(' ')) text.remove_prefix(1);
  }
  return lines;
}

void Svg::polygon(const Region& region, std::string_view css) {
  if (region.size() < 3) return;
  body_ += "<polygon points=\"";
  std::string_view separator;
  for (const Point& point : region) {
    body_.append(separator) += number(point.x()) + ',' + number(point.y());
    separator = " ";
  }
  fmt::format_to(std::back_inserter(body_), "\" class=\"{}\"/>\n", css);
}

void Svg::line(const Segment& segment, std::string_view css) {
  fmt::format_to(std::back_inserter(body_),
                 "<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\" class=\"{}\"/>\n",
                 number(segment.first.x()), number(segment.first.y()), number(segment.second.x()),
                 number(segment.second.y()), css);
}

void Svg::circle(const Point& center, double radius, std::string_view css) {
  fmt::format_to(std::back_inserter(body_), "<circle cx=\"{}\" cy=\"{}\" r=\"{}\" class=\"{}\"/>\n",
                 number(center.x()), number(center.y()), number(radius), css);
}

void Svg::box(const Box& box, std::string_view css, double corner_radius) {
  fmt::format_to(std::back_inserter(body_),
                 "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"{} class=\"{}\"/>\n",
                 number(box.x), number(box.y), number(box.width), number(box.height),
                 corner_radius > 0 ? fmt::format(" rx=\"{}\"", number(corner_radius)) : "", css);
}

void Svg::text(const Point& at, std::string_view text, const Font& font, std::string_view css) {
  constexpr std::size_t longest = 4096;
  fmt::format_to(std::back_inserter(body_),
                 "<text x=\"{}\" y=\"{}\" font-size=\"{}\"{} class=\"{}\">{}</text>\n",
                 number(at.x()), number(at.y()), number(font.size),
                 font.bold ? " font-weight=\"bold\"" : "", css,
                 escape_xml(printable(text, longest)));
}

std::string Svg::finish(double width, double height, std::string_view title,
                        std::string_view style) const {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"{2}\">\n<title>{3}</title>\n<style>{4}</style>\n{5}"
      "</svg>\n",
      number(width), number(height), kFonts, escape_xml(printable(title, 4096)), style, body_);
}

}  // namespace manifuzz
