#include <algorithm>
#include <cmath>

#include "report/picture/drawing.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

/// How much room a letter has at a place of the canvas: inside its own shape, outside the other's.
double room(const Drawing& drawing, Side side, const Point& at) {
  const View& view = drawing.view;
  const Point moved = at - view.frame.center();
  const Point p = view.center + Point(moved.x(), -moved.y()) / view.scale;
  const double in_own = depth_in(drawing.shape(side), p);
  const double out_of_other = -depth_in(drawing.shape(other(side)), p);
  const double in_frame = std::min({at.x() - view.frame.x, view.frame.right() - at.x(),
                                    at.y() - view.frame.y, view.frame.bottom() - at.y()});
  return std::min({in_own * view.scale, out_of_other * view.scale, in_frame});
}

/// Where the polygon is widest; beside it where it is too narrow for its letter.
void draw_letter(Drawing& drawing, Side side) {
  const View& view = drawing.view;
  const Region seen = intersection(view.place(drawing.shape(side)), view.frame);
  if (seen.size() < 3) return;
  const std::string name = side == Side::a ? "A" : "B";
  const Box about = box_around(seen);
  constexpr int steps = 20;
  constexpr double enough = 14;
  double best = 0;
  Point at = about.center();
  for (int i = 1; i < steps; ++i) {
    for (int j = 1; j < steps; ++j) {
      const Point p(about.x + about.width * i / steps, about.y + about.height * j / steps);
      const double here = room(drawing, side, p);
      const Box letter = Box{p.x(), p.y(), 0, 0}.grown(12);
      if (here <= best || !drawing.labels.is_free(letter)) continue;
      best = here;
      at = p;
    }
  }
  if (best < enough) {
    drawing.words.push_back(
        {.text = name, .anchor = about.center(), .font = {16, true}, .css = css("letter", side)});
    return;
  }
  drawing.svg.text(at + Point(-7.5, 8), name, {22, true}, css("letter", side));
  drawing.labels.block(Box{at.x(), at.y(), 0, 0}.grown(12));
}

void number_vertices(Drawing& drawing, Side side) {
  const auto& polygon = drawing.scene.polygon(side);
  for (int i = 0; i < polygon.count; ++i) {
    const Point at = drawing.view.place(polygon.vertices[i]);
    if (!drawing.sees(at)) continue;
    const Point sum = polygon.normals[i] + polygon.normals[i > 0 ? i - 1 : polygon.count - 1];
    const Point outward = unit(View::direction(sum));
    drawing.words.push_back({.text = fmt::format("{}", i),
                             .anchor = at,
                             .towards = outward,
                             .font = kSmallFont,
                             .css = css("vertex", side),
                             .reach = 12});
  }
}

/// The longest of 1, 2 and 5 times a power of ten that is not too wide.
double round_length(double scale) {
  constexpr double widest = 120;
  double unit = 1;
  while (unit * scale > widest) unit /= 10;
  while (unit * 10 * scale <= widest) unit *= 10;
  for (const double factor : {5.0, 2.0}) {
    if (unit * factor * scale <= widest) return unit * factor;
  }
  return unit;
}

void draw_scale_bar(Drawing& drawing) {
  const double unit = round_length(drawing.view.scale);
  const std::string text = brief(unit);
  const Box& frame = drawing.view.frame;
  const Point left(frame.x + 14, frame.bottom() - 14);
  const Point right = left + Point(unit * drawing.view.scale, 0);
  const double words = text_width(text, kSmallFont);
  const Box box{left.x() - 6, left.y() - 10, right.x() - left.x() + words + 20, 20};
  drawing.svg.box(box, "label", 3);
  drawing.svg.line({left, right}, "scale");
  for (const Point& end : {left, right}) {
    drawing.svg.line({end - Point(0, 4), end + Point(0, 4)}, "scale");
  }
  drawing.svg.text(right + Point(8, 4), text, kSmallFont, "quiet");
  drawing.labels.block(box);
}

/// "660x closer", to two digits.
std::string caption_of(const View& whole, const View& closer) {
  const double times = closer.scale / whole.scale;
  double digits = 1;
  while (times / digits >= 100) digits *= 10;
  return fmt::format("{:g}x closer", std::round(times / digits) * digits);
}

void draw_caption(Drawing& drawing, std::string_view caption) {
  const Box& frame = drawing.view.frame;
  const Box box{frame.x + 6, frame.y + 6, text_width(caption, kSmallFont) + 12, 19};
  drawing.svg.box(box, "caption", 3);
  drawing.svg.text({box.x + 6, box.bottom() - 5.5}, caption, kSmallFont, "quiet");
  drawing.labels.block(box);
}

/// Which of the views before view `i` it is marked in: the last that shows its center.
std::size_t host_of(const std::vector<View>& views, std::size_t i) {
  std::size_t host = i - 1;
  while (host > 0 && !views[host].frame.contains(views[host].place(views[i].center))) --host;
  return host;
}

/// Where the closer view lies, and lines to it.
void mark_view(Drawing& drawing, const View& closer) {
  constexpr double least = 9;
  const double shrunk = drawing.view.scale / closer.scale;
  const Point center = drawing.view.place(closer.center);
  const double width = std::max(least, closer.frame.width * shrunk);
  const double height = std::max(least, closer.frame.height * shrunk);
  const Box box{center.x() - width / 2, center.y() - height / 2, width, height};
  const Box& frame = closer.frame;
  const bool is_beside = frame.x > drawing.view.frame.right();
  const Point first(frame.x, frame.y);
  const Point second = is_beside ? Point(frame.x, frame.bottom()) : Point(frame.right(), frame.y);
  for (const Point& corner : {first, second}) {
    const Segment line{nearest(box, corner), corner};
    drawing.svg.line(line, "zoom-line");
    drawing.labels.avoid(line);
  }
  drawing.svg.box(box, "zoomed", 2);
  if (width <= 2 * least) drawing.labels.block(box);
}

}  // namespace

void draw_names(Drawing& drawing) {
  for (const Side side : kSides) draw_letter(drawing, side);
  for (const Side side : kSides) number_vertices(drawing, side);
}

void draw_view(Svg& svg, const Scene& scene, const std::vector<View>& views, std::size_t index,
               const MarkNames& names) {
  const View& view = views[index];
  svg.box(view.frame, "frame", 4);
  Drawing drawing{svg, scene, view, index == 0, names, {}, LabelLayer(view.frame.grown(-4)), {}};
  for (const Side side : kSides) {
    drawing.shapes[static_cast<std::size_t>(side)] =
        rounded(scene.polygon(side), scene.radius(side), view.shown(), 0.2 / view.scale);
  }
  draw_shapes(drawing);
  for (std::size_t i = index + 1; i < views.size(); ++i) {
    if (host_of(views, i) == index) mark_view(drawing, views[i]);
  }
  draw_contacts(drawing);
  draw_scale_bar(drawing);
  if (index > 0) draw_caption(drawing, caption_of(views.front(), view));
  draw_names(drawing);
  for (const Label& word : drawing.words) drawing.labels.place(word);
  drawing.labels.draw(svg);
}

}  // namespace manifuzz
