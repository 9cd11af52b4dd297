#include "report/picture/canvas.hpp"

#include <cairo.h>
#include <new>
#include <stdexcept>

#include "base/text.hpp"

namespace manifuzz {
namespace {

constexpr double kFullTurn = 6.283185307179586;

cairo_status_t append(void* to, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

}  // namespace

Canvas::Canvas(int width, int height)
    : surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height)),
      context_(cairo_create(surface_)) {
  fill({0, 0, static_cast<double>(width), static_cast<double>(height)}, 0xffffff);
}

Canvas::~Canvas() {
  cairo_destroy(context_);
  cairo_surface_destroy(surface_);
}

void Canvas::set(Colour colour) {
  const auto part = [colour](int shift) { return ((colour >> shift) & 0xffU) / 255.0; };
  cairo_set_source_rgb(context_, part(16), part(8), part(0));
}

void Canvas::fill(const Box& box, Colour colour) {
  set(colour);
  cairo_rectangle(context_, box.x, box.y, box.width, box.height);
  cairo_fill(context_);
}

void Canvas::frame(const Box& box, Colour colour) {
  set(colour);
  cairo_set_line_width(context_, 1);
  cairo_rectangle(context_, box.x - 0.5, box.y - 0.5, box.width + 1, box.height + 1);
  cairo_stroke(context_);
}

void Canvas::ring(const Point& center, double radius, double line_width, Colour colour) {
  set(colour);
  cairo_set_line_width(context_, line_width);
  cairo_new_sub_path(context_);
  cairo_arc(context_, center.x(), center.y(), radius, 0, kFullTurn);
  cairo_stroke(context_);
}

void Canvas::text(const Point& at, std::string_view text, const Font& font, Colour colour) {
  set(colour);
  cairo_select_font_face(context_, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_, font.size);
  cairo_move_to(context_, at.x(), at.y());
  cairo_show_text(context_, printable(text, text.size()).c_str());
}

std::string Canvas::png(int height) const {
  check(cairo_status(context_));
  cairo_surface_flush(surface_);
  cairo_surface_t* const top = cairo_image_surface_create_for_data(
      cairo_image_surface_get_data(surface_), CAIRO_FORMAT_RGB24,
      cairo_image_surface_get_width(surface_), height, cairo_image_surface_get_stride(surface_));
  std::string file;
  const cairo_status_t status = cairo_surface_write_to_png_stream(top, append, &file);
  cairo_surface_destroy(top);
  check(status);
  return file;
}

}  // namespace manifuzz
