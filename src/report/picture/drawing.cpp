#include "report/picture/drawing.hpp"

#include <algorithm>
#include <cairo.h>
#include <cmath>
#include <librsvg/rsvg.h>
#include <new>
#include <stdexcept>

#include "base/text.hpp"

namespace manifuzz {
namespace {

/// The widths of DejaVu Sans from blank to tilde, in hundredths of an em: the widest of its kind.
constexpr std::array<unsigned char, 95> kWidths{
    32, 41, 46, 84, 64, 96, 78, 28, 40,  40, 50, 84, 32, 37, 32, 34, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 54, 100, 69, 69, 70, 78, 64, 58, 78, 76, 30, 30, 66, 56, 87, 75, 79,
    61, 79, 70, 64, 62, 74, 69, 99, 69,  62, 69, 40, 34, 40, 84, 50, 50, 62, 64, 55, 64, 62, 36, 64,
    64, 28, 28, 58, 28, 98, 64, 62, 64,  64, 42, 53, 40, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84,
};
constexpr double kBoldIsWider = 1.15;

/// The bits of a cell's dots, by row and column.
constexpr unsigned kBits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};

int nearest_dot(double x) {
  return static_cast<int>(std::floor(x + 0.5));
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

}  // namespace

double text_width(std::string_view text, const Font& font) {
  double width = 0;
  for (const char c : text) {
    const bool is_printable = c >= ' ' && c <= '~';
    width += is_printable ? kWidths[static_cast<std::size_t>(c - ' ')] / 100.0 : 1.0;
  }
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

Canvas::Canvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height),
               cairo_surface_destroy),
      context_(cairo_create(surface_.get()), cairo_destroy) {
  fill({0, 0, static_cast<double>(width), static_cast<double>(height)}, 0xffffff);
}

cairo_t* Canvas::coloured(Colour colour) {
  const auto part = [colour](int shift) { return ((colour >> shift) & 0xffU) / 255.0; };
  cairo_set_source_rgb(context_.get(), part(16), part(8), part(0));
  return context_.get();
}

void Canvas::stroke(double line_width) {
  cairo_set_line_width(context_.get(), line_width);
  cairo_stroke(context_.get());
}

void Canvas::fill(const Box& box, Colour colour) {
  cairo_rectangle(coloured(colour), box.x, box.y, box.width, box.height);
  cairo_fill(context_.get());
}

void Canvas::frame(const Box& box, Colour colour) {
  cairo_rectangle(coloured(colour), box.x - 0.5, box.y - 0.5, box.width + 1, box.height + 1);
  stroke(1);
}

void Canvas::ring(const Point& center, double radius, double line_width, Colour colour) {
  constexpr double full_turn = 6.283185307179586;
  cairo_new_sub_path(coloured(colour));
  cairo_arc(context_.get(), center.x(), center.y(), radius, 0, full_turn);
  stroke(line_width);
}

void Canvas::text(const Point& at, std::string_view text, const Font& font, Colour colour) {
  cairo_t* const context = coloured(colour);
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, font.size);
  cairo_move_to(context, at.x(), at.y());
  cairo_show_text(context, printable(text, text.size()).c_str());
}

std::string Canvas::png(int height) const {
  check(cairo_status(context_.get()));
  cairo_surface_t* const all = surface_.get();
  const std::shared_ptr<cairo_surface_t> top(
      cairo_surface_create_for_rectangle(all, 0, 0, cairo_image_surface_get_width(all), height),
      cairo_surface_destroy);
  const auto append = [](void* to, const unsigned char* data, unsigned int length) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  };
  std::string file;
  check(cairo_surface_write_to_png_stream(top.get(), append, &file));
  return file;
}

void Canvas::draw(_RsvgHandle* document) {
  const RsvgRectangle all{0, 0, static_cast<double>(cairo_image_surface_get_width(surface_.get())),
                          static_cast<double>(cairo_image_surface_get_height(surface_.get()))};
  if (!rsvg_handle_render_document(document, context_.get(), &all, nullptr)) {
    throw std::runtime_error("an SVG document cannot be drawn");
  }
}

std::string png_of(const std::string& svg) {
  constexpr double kScale = 2;
  const auto* const bytes = reinterpret_cast<const guint8*>(svg.data());
  const std::unique_ptr<RsvgHandle, decltype(&g_object_unref)> document(
      rsvg_handle_new_from_data(bytes, svg.size(), nullptr), g_object_unref);
  double width = 0;
  double height = 0;
  if (document == nullptr ||
      !rsvg_handle_get_intrinsic_size_in_pixels(document.get(), &width, &height)) {
    throw std::runtime_error("an SVG document has no size");
  }
  const int rows = static_cast<int>(std::ceil(kScale * height));
  Canvas canvas(static_cast<int>(std::ceil(kScale * width)), rows);
  canvas.draw(document.get());
  return canvas.png(rows);
}

DotCanvas::DotCanvas(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

DotCanvas::Cell* DotCanvas::cell(int x, int y) {
  if (x < 0 || x >= width() || y < 0 || y >= height()) return nullptr;
  const int index = y / 4 * columns_ + x / 2;
  return &cells_[static_cast<std::size_t>(index)];
}

void DotCanvas::dot(int x, int y) {
  if (Cell* const at = cell(x, y)) at->dots |= kBits[y % 4][x % 2];
}

void DotCanvas::line(const Point& from, const Point& to, int every) {
  const int x = nearest_dot(from.x());
  const int y = nearest_dot(from.y());
  const int dx = nearest_dot(to.x()) - x;
  const int dy = nearest_dot(to.y()) - y;
  const int steps = std::max({std::abs(dx), std::abs(dy), 1});
  for (int i = 0; i <= steps; i += every) {
    const double share = static_cast<double>(i) / steps;
    dot(x + nearest_dot(share * dx), y + nearest_dot(share * dy));
  }
}

void DotCanvas::mark(const Point& at, char mark) {
  if (Cell* const marked = cell(nearest_dot(at.x()), nearest_dot(at.y()))) marked->mark = mark;
}

char DotCanvas::mark_at(const Point& at) {
  const Cell* const marked = cell(nearest_dot(at.x()), nearest_dot(at.y()));
  return marked == nullptr ? '\0' : marked->mark;
}

std::string DotCanvas::text() const {
  std::string text;
  for (std::size_t i = 0; i < cells_.size();) {
    std::size_t used = text.size();
    for (int column = 0; column < columns_; ++column, ++i) {
      const Cell& cell = cells_[i];
      // U+2800 and the dots, in UTF-8.
      const char low = static_cast<char>(0x80 | (cell.dots & 0x3f));
      const char high = static_cast<char>(0xa0 | (cell.dots >> 6));
      text += cell.mark != 0 ? std::string(1, cell.mark) : std::string{'\xe2', high, low};
      if (cell.mark != 0 || cell.dots != 0) used = text.size();
    }
    text.resize(used);
    text += '\n';
  }
  const std::size_t begin = std::min(text.find_first_not_of('\n'), text.size());
  while (text.size() > begin + 1 && text.ends_with("\n\n")) text.pop_back();
  return text.substr(begin);
}

}  // namespace manifuzz
