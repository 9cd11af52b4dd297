#include <sstream>

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/picture/drawing.hpp"

namespace manifuzz {
namespace {

/// A pixel's hundredth is enough. Zero has no sign.
std::string number(double pixels) {
  std::string text = fmt::format("{:.2f}", pixels);
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text == "-0" ? "0" : text;
}

/// A place as paths have it.
std::string at(const Point& p) {
  return number(p.x()) + ' ' + number(p.y());
}

}  // namespace

Svg::Svg(std::string_view title, std::string_view style) : root_(document_.append_child("svg")) {
  constexpr std::size_t longest = 4096;
  root_.append_attribute("xmlns") = "http://www.w3.org/2000/svg";
  root_.append_attribute("version") = "1.1";
  root_.append_attribute("font-family") = "DejaVu Sans, Verdana, Bitstream Vera Sans, sans-serif";
  root_.append_child("title").text() = printable(title, longest).c_str();
  root_.append_child("style").text() = std::string(style).c_str();
  paper_ = add("rect", "paper", {{"x", 0.5}, {"y", 0.5}, {"rx", 8}});
}

pugi::xml_node Svg::add(const char* element, std::string_view css, Numbers numbers) {
  pugi::xml_node node = root_.append_child(element);
  for (const auto& [name, value] : numbers) node.append_attribute(name) = number(value).c_str();
  node.append_attribute("class") = std::string(css).c_str();
  return node;
}

void Svg::polygon(const Region& region, std::string_view css) {
  if (region.size() < 3) return;
  std::string points;
  for (const Point& point : region) {
    points += (points.empty() ? "" : " ") + number(point.x()) + ',' + number(point.y());
  }
  add("polygon", css, {}).append_attribute("points") = points.c_str();
}

void Svg::add_path(const std::string& steps, std::string_view css) {
  if (!steps.empty()) add("path", css, {}).append_attribute("d") = steps.c_str();
}

void Svg::rim(const Rim& rim, std::string_view css) {
  std::string steps;
  for (const RimCorner& corner : rim) {
    steps += (steps.empty() ? 'M' : 'L') + at(corner.begin());
    if (corner.radius <= 0) continue;
    const std::string radius = number(corner.radius);
    steps += 'A' + radius + ' ' + radius + " 0 0 0 " + at(corner.end());
  }
  add_path(steps + 'Z', css);
}

void Svg::path(const std::vector<Segment>& segments, std::string_view css) {
  std::string steps;
  std::string end;
  for (const Segment& segment : segments) {
    if (const std::string begin = at(segment.first); begin != end) steps += 'M' + begin;
    end = at(segment.second);
    steps += 'L' + end;
  }
  add_path(steps, css);
}

void Svg::line(const Segment& segment, std::string_view css) {
  const auto& [from, to] = segment;
  add("line", css, {{"x1", from.x()}, {"y1", from.y()}, {"x2", to.x()}, {"y2", to.y()}});
}

void Svg::circle(const Point& center, double radius, std::string_view css) {
  add("circle", css, {{"cx", center.x()}, {"cy", center.y()}, {"r", radius}});
}

void Svg::box(const Box& box, std::string_view css, double corner_radius) {
  add("rect", css,
      {{"x", box.x},
       {"y", box.y},
       {"width", box.width},
       {"height", box.height},
       {"rx", corner_radius}});
}

void Svg::text(const Point& at, std::string_view text, const Font& font, std::string_view css) {
  constexpr std::size_t longest = 4096;
  pugi::xml_node node = add("text", css, {{"x", at.x()}, {"y", at.y()}, {"font-size", font.size}});
  if (font.bold) node.append_attribute("font-weight") = "bold";
  node.text() = printable(text, longest).c_str();
}

std::string Svg::finish(double width, double height) {
  const auto set_size = [](pugi::xml_node node, double across, double down) {
    node.append_attribute("width") = number(across).c_str();
    node.append_attribute("height") = number(down).c_str();
  };
  set_size(root_, width, height);
  set_size(paper_, width - 1, height - 1);
  root_.append_attribute("viewBox") =
      fmt::format("0 0 {} {}", number(width), number(height)).c_str();
  std::ostringstream text;
  document_.save(text, "");
  return text.str();
}

double write_down(Svg& svg, std::string_view text, const Point& at, double right, const Font& font,
                  std::string_view css) {
  double y = at.y();
  for (const std::string& line : wrapped(text, font, right - at.x())) {
    svg.text({at.x(), y}, line, font, css);
    y += font.size * 1.68;
  }
  return y;
}

void fill_rim(Svg& svg, const View& view, const Rim& rim, const Region& seen,
              std::string_view css) {
  const Rim placed = view.place(rim);
  const bool has_arcs = rim.front().radius > 0;
  if (has_arcs && view.frame.contains(box_around_rim(placed))) return svg.rim(placed, css);
  svg.polygon(intersection(view.place(seen), view.frame), css);
}

void draw_rim(Svg& svg, const View& view, const Rim& rim, const Region& seen,
              std::string_view css) {
  const Rim placed = view.place(rim);
  if (view.frame.contains(box_around_rim(placed))) return svg.rim(placed, css);
  const Region corners = view.place(seen);
  std::vector<Segment> parts;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto part = inside({corners[i], corners[(i + 1) % corners.size()]}, view.frame);
    if (part) parts.push_back(*part);
  }
  svg.path(parts, css);
}

}  // namespace manifuzz
