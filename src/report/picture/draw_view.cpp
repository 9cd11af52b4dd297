#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "report/picture/drawing.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr Font kDepthFont{12, true};
constexpr double kMarkRadius = 5;
constexpr double kMarkSquare = 15;
constexpr double kArrow = 54;
constexpr double kBarOffset = 3.5;  // of either collider's bars, so that both are seen
constexpr double kSameSpot = 9;     // contact points nearer than this share a label

/// One view of a scene while it is drawn.
struct Drawing {
  Svg& svg;
  const Scene& scene;
  const View& view;
  const std::array<std::string, 2>& names;
  std::array<Region, 2> shapes;  ///< A's and B's with their skins, in the scene
  std::vector<Box> taken;        ///< where no label may lie

  bool sees(const Point& on_canvas) const { return view.frame.contains(on_canvas); }
  const Region& shape(Side side) const { return shapes[static_cast<std::size_t>(side)]; }
  void take(const Point& at, double about) { taken.push_back(Box{at.x(), at.y()}.grown(about)); }
};

/// Draws the part of a canvas segment that is seen.
void stroke(const Drawing& drawing, const Segment& on_canvas, std::string_view style) {
  if (const auto seen = inside(on_canvas, drawing.view.frame)) drawing.svg.line(*seen, style);
}

void fill(const Drawing& drawing, const Region& region, std::string_view style) {
  drawing.svg.polygon(intersection(drawing.view.place(region), drawing.view.frame), style);
}

/// A few words beside what they name.
struct Label {
  std::string text;
  Point anchor{0, 0};   ///< what it names, on the canvas
  Point towards{0, 0};  ///< the direction in which it lies, unit; zero: upon the anchor
  double gap = 0;       ///< in pixels
  Font font = {};
  std::string css;
};

Box box_of(const Label& label) {
  const double width = text_width(label.text, label.font) + 6;
  const double height = label.font.size + 6;
  const Point& d = label.towards;
  const double out = std::min(width / 2 / std::abs(d.x()), height / 2 / std::abs(d.y()));
  const Point center = d.isZero() ? label.anchor : Point(label.anchor + (out + label.gap) * d);
  return {center.x() - width / 2, center.y() - height / 2, width, height};
}

/// Writes a label where it fits into the frame; where its place is taken, above or below if it may
/// move, with a line to what it names if that is far, and else not at all.
bool write(Drawing& drawing, const Label& label, bool may_move) {
  const Box room = drawing.view.frame.grown(-4);
  Box wanted = box_of(label);
  if (wanted.width > room.width) return false;
  wanted.x = std::clamp(wanted.x, room.x, room.right() - wanted.width);
  wanted.y = std::clamp(wanted.y, room.y, room.bottom() - wanted.height);
  const auto box = nearest_free(wanted, drawing.taken, drawing.view.frame);
  if (!box || (box->y != wanted.y && !may_move)) return false;
  drawing.taken.push_back(*box);
  const Segment leader{label.anchor, nearest(*box, label.anchor)};
  if (length(leader.second - leader.first) > 2 * box->height) drawing.svg.line(leader, "leader");
  drawing.svg.box(*box, "label", 3);
  const Point at(box->x + 3, box->bottom() - 3 - 0.2 * label.font.size);
  drawing.svg.text(at, label.text, label.font, label.css);
  return true;
}

void draw_edges(const Drawing& drawing, Side side) {
  const auto& polygon = drawing.scene.polygons[side];
  for (int i = 0; i < polygon.face_count(); ++i) {
    const Segment edge{polygon.vertices[i], polygon.vertices[polygon.next(i)]};
    stroke(drawing, drawing.view.place(edge), css_of("edge", side));
  }
  if (drawing.scene.radius(side) <= 0) return;
  draw_rim(drawing.svg, drawing.view, drawing.scene.rim(side), drawing.shape(side),
           css_of("skin", side));
}

/// A side plane is a line; as much of it as the frame shows.
void draw_side_planes(const Drawing& drawing) {
  const Scene& scene = drawing.scene;
  const Box& frame = drawing.view.frame;
  const double far = 2 * (frame.width + frame.height);
  const Point along = View::direction(scene.outward) * far;
  const Point widening =
      (scene.radii[0] + scene.radii[1]) * counter_clockwise_quarter<double>(scene.outward);
  const auto& [first, second] = scene.reference.segment;
  for (const Point& corner : {Point(first - widening), Point(second + widening)}) {
    const Point at = drawing.view.place(corner);
    if (length(at - frame.center()) < far / 2) stroke(drawing, {at - along, at + along}, "plane");
  }
}

/// Polygons, their overlap, reference and incident with the side planes.
void draw_shapes(const Drawing& drawing) {
  const Scene& scene = drawing.scene;
  for (const Side side : kSides) {
    fill_rim(drawing.svg, drawing.view, drawing.scene.rim(side), drawing.shape(side),
             css_of("fill", side));
  }
  fill(drawing, intersection(drawing.shapes[0], drawing.shapes[1]), "overlap");
  if (scene.incident) draw_side_planes(drawing);
  for (const Side side : kSides) draw_edges(drawing, side);
  stroke(drawing, drawing.view.place(scene.reference.segment), "reference");
  if (scene.incident) stroke(drawing, drawing.view.place(scene.incident->segment), "incident");
}

void draw_bar(const Drawing& drawing, const DepthBar& bar, double offset, std::string_view style) {
  const Point from = drawing.view.place(bar.from);
  const Point along = drawing.view.place(bar.to) - from;
  const double pixels = length(along);
  if (!(pixels >= 1 && std::isfinite(pixels))) return;
  const Point aside = clockwise_quarter<double>(along) / pixels;
  const Point foot = from + along + aside * offset;
  stroke(drawing, {foot - along, foot}, style);
  if (drawing.sees(foot)) drawing.svg.line({foot - 4 * aside, foot + 4 * aside}, style);
}

void draw_arrow(Drawing& drawing, const Point& from, const Point& normal, std::string_view whose) {
  const Point direction = View::direction(unit_or_zero(normal));
  const Point to = from + kArrow * direction;
  if (!drawing.view.frame.grown(-8).contains(to)) return;
  const Point aside = clockwise_quarter<double>(direction);
  const Point neck = to - 10 * direction;
  drawing.svg.line({from, neck}, fmt::format("normal{}", whose));
  drawing.svg.polygon({to, neck + 4.5 * aside, neck - 4.5 * aside}, fmt::format("arrow{}", whose));
  for (const double share : {0.5, 1.0}) drawing.take(from + share * (to - from), 5);
}

/// The true one on the reference face, and of each collider that reports clearly another one.
void draw_normals(Drawing& drawing) {
  constexpr double clearly = 0.998;
  const Point truth = drawing.scene.a_to_b();
  const auto face =
      inside(drawing.view.place(drawing.scene.reference.segment), drawing.view.frame.grown(-10));
  if (face) draw_arrow(drawing, (face->first + face->second) / 2, truth, "");
  std::array<bool, 2> is_drawn{};
  for (const DrawnPoint& point : drawing.scene.points) {
    const Point at = drawing.view.place(point.position);
    const bool is_unit = std::abs(length(point.normal) - 1) <= 1 - clearly;
    if (!drawing.sees(at) || (is_unit && point.normal.dot(truth) >= clearly)) continue;
    if (std::exchange(is_drawn[point.by_subject], true)) continue;
    draw_arrow(drawing, at, point.normal, point.by_subject ? " subject" : " oracle");
  }
}

/// What is reported at one spot: who reports each depth.
struct Spot {
  Label label;
  nlohmann::ordered_map<std::string, std::vector<std::string>> said{};
};

/// "depth 0.31 (clip, box2d)": of the points at one spot, equal figures once.
void label_depths(Drawing& drawing) {
  std::vector<Spot> spots;
  for (const DrawnPoint& point : drawing.scene.points) {
    const Point at = drawing.view.place(point.position);
    if (!drawing.sees(at)) continue;
    const std::string style = point.by_subject ? "depth-word subject" : "depth-word oracle";
    auto spot = std::ranges::find_if(
        spots, [&](const Spot& known) { return length(known.label.anchor - at) < kSameSpot; });
    if (spot == spots.end()) {
      const Point away = unit_or_zero(point.position - (point.bar.from + point.bar.to) / 2);
      spots.push_back({{"", at, View::direction(away), 10, kDepthFont, style}});
      spot = std::prev(spots.end());
    }
    if (spot->label.css != style) spot->label.css = "depth-word";
    std::vector<std::string>& by = spot->said[brief(point.bar.depth)];
    const std::string& who = drawing.names[point.by_subject ? 0 : 1];
    if (by.empty() || by.back() != who) by.push_back(who);
  }
  for (Spot& spot : spots) {
    std::vector<std::string> parts;
    for (const auto& [figure, by] : spot.said) {
      parts.push_back(fmt::format("{} ({})", figure, fmt::join(by, ", ")));
    }
    spot.label.text = fmt::format("depth {}", fmt::join(parts, ", "));
    write(drawing, spot.label, true);
  }
}

/// Where nothing is reported: the true depth, beside its bar.
void draw_truth(Drawing& drawing) {
  const DepthBar& bar = drawing.scene.deepest;
  draw_bar(drawing, bar, 0, "bar truth");
  const Point middle = drawing.view.place(Point((bar.from + bar.to) / 2));
  if (!drawing.sees(middle)) return;
  const Point aside = View::direction(clockwise_quarter<double>(unit_or_zero(bar.to - bar.from)));
  const std::string text = (bar.depth >= 0 ? "true depth " : "gap ") + brief(std::abs(bar.depth));
  write(drawing, {text, middle, aside, 8, kDepthFont, "depth-word subject"}, true);
}

/// Depth bars, normals and contact points, with the depths as text.
void draw_contacts(Drawing& drawing) {
  const std::vector<DrawnPoint>& points = drawing.scene.points;
  draw_normals(drawing);
  for (const DrawnPoint& point : points) {
    draw_bar(drawing, point.bar, point.by_subject ? -kBarOffset : kBarOffset,
             point.by_subject ? "bar subject" : "bar oracle");
  }
  for (const DrawnPoint& point : points) {
    const Point at = drawing.view.place(point.position);
    if (!drawing.sees(at)) continue;
    draw_mark(drawing.svg, at, point.by_subject);
    drawing.take(at, kMarkSquare / 2 + 1);
  }
  if (points.empty()) draw_truth(drawing);
  label_depths(drawing);
}

/// Where its shape has most room for it, outside the other's.
void draw_letter(Drawing& drawing, Side side) {
  const View& view = drawing.view;
  const auto own = static_cast<std::size_t>(side);
  const Region seen = intersection(drawing.shapes[own], view.shown());
  if (seen.size() < 3) return;
  const Point middle = middle_of(seen);
  Point best = middle;
  double most = 0;
  for (const double share : {0.0, 0.3, 0.6}) {
    for (const Point& corner : seen) {
      const Point p = middle + share * (corner - middle);
      const double room =
          std::min(depth_in(drawing.shapes[own], p), -depth_in(drawing.shapes[1 - own], p));
      if (room > 1.2 * most) std::tie(most, best) = std::tuple(room, p);
    }
  }
  // Beside a shape that is too narrow for it.
  const Point towards = most * view.scale < 9 ? Point(0.6, -0.8) : Point(0, 0);
  const std::string name = side == Side::a ? "A" : "B";
  write(drawing, {name, view.place(best), towards, 5, {18, true}, css_of("letter", side)}, true);
}

/// Where there is room, outside the vertex or else beside it.
void number_vertices(Drawing& drawing, Side side) {
  const auto& polygon = drawing.scene.polygons[side];
  for (int i = 0; i < polygon.count; ++i) {
    const Point at = drawing.view.place(polygon.vertices[i]);
    if (!drawing.sees(at)) continue;
    const Point& before = polygon.normals[polygon.previous(i)];
    const Point outward = View::direction(unit_or_zero(polygon.normals[i] + before));
    Label label{fmt::format("{}", i), at, outward, 1, {10.5}, css_of("vertex", side)};
    if (write(drawing, label, false)) continue;
    label.towards = {outward.x() < 0 ? -1 : 1, 0};
    label.gap = 9;
    write(drawing, label, false);
  }
}

}  // namespace

void draw_mark(Svg& svg, const Point& at, bool by_subject) {
  if (by_subject) return svg.circle(at, kMarkRadius, "mark-subject");
  svg.box(Box{at.x(), at.y()}.grown(kMarkSquare / 2), "mark-oracle");
}

void draw_view(Svg& svg, const Scene& scene, const View& view,
               const std::array<std::string, 2>& names) {
  svg.box(view.frame, "frame", 4);
  Drawing drawing{svg, scene, view, names, {}, {view.footer()}};
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    drawing.shapes[i] = scene.shape(kSides[i], view.shown(), 0.2 / view.scale);
  }
  draw_shapes(drawing);
  draw_contacts(drawing);
  for (const Side side : kSides) draw_letter(drawing, side);
  for (const Side side : kSides) number_vertices(drawing, side);
}

}  // namespace manifuzz
