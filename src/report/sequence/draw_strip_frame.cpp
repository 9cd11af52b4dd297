#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include "report/sequence/strip_frames.hpp"

namespace manifuzz {
namespace {

constexpr double kNormalLength = 62;  // of arrows, in pixels
constexpr double kShownDegrees = 2;   // true normals nearer than this are not drawn
constexpr Font kMarkFont{11, true};
constexpr Font kLetterFont{13, true};

/// In a region, half way from its middle to the corner that is farthest from there.
Point away_from(const Point& contact, const Region& region) {
  const Point far = *std::ranges::max_element(
      region, {}, [&](const Point& corner) { return (corner - contact).norm(); });
  return (middle_of(region) + far) / 2;
}

/// One frame while it is drawn.
struct FrameDrawing {
  Svg& svg;
  const StripFrame& frame;
  const View& view;
  std::vector<Box> taken{};                       ///< where no more labels may lie
  std::array<std::optional<Point>, 2> letters{};  ///< where the bodies' letters stand

  void draw_bodies();
  void draw_points();
  void write_labels();

 private:
  void arrow(const Point& from, const Point& direction, const std::string& line,
             const std::string& head);
  void write_label(Point center, std::string_view text, const Font& font, std::string_view css);
};

void FrameDrawing::arrow(const Point& from, const Point& direction, const std::string& line,
                         const std::string& head) {
  const Point to = from + kNormalLength * direction;
  const Point across(-direction.y(), direction.x());
  svg.line({from, to - 8 * direction}, line);
  svg.polygon({to, to - 11 * direction + 5 * across, to - 11 * direction - 5 * across}, head);
  taken.push_back(Box{to.x(), to.y()}.grown(5));
}

/// A word on a light ground, near its place in the frame.
void FrameDrawing::write_label(Point center, std::string_view text, const Font& font,
                               std::string_view css) {
  const Box room = view.frame.grown(-4);
  const double width = text_width(text, font) + 6;
  center.x() = std::clamp(center.x(), room.x + width / 2, room.right() - width / 2);
  center.y() = std::clamp(center.y(), room.y + 9, room.bottom() - 9);
  const Box wanted{center.x() - width / 2, center.y() - 9, width, 17};
  const Box box = nearest_free(wanted, taken, room).value_or(wanted);
  taken.push_back(box);
  svg.box(box, "label", 3);
  svg.text({box.x + 3, box.y + 13}, text, font, css);
}

void FrameDrawing::draw_bodies() {
  const double tolerance = 0.25 / view.scale;
  std::array<Region, 2> seen;
  for (const Side side : kSides) {
    const auto i = static_cast<std::size_t>(side);
    seen[i] = region_of(frame.rim(side), view.shown(), tolerance);
    fill_rim(svg, view, frame.rim(side), seen[i], css_of("fill", side));
  }
  const Region both = intersection(seen[0], seen[1]);
  svg.polygon(intersection(view.place(both), view.frame), "overlap");
  for (const Side side : kSides) {
    const auto i = static_cast<std::size_t>(side);
    draw_rim(svg, view, frame.rim(side), seen[i], css_of("outline", side));
    const auto spoke = inside(view.place(frame.spoke(side)), view.frame);
    if (spoke) svg.line(*spoke, css_of("spoke", side));
    const Region visible = intersection(view.place(seen[i]), view.frame);
    if (!visible.empty()) letters[i] = away_from(view.place(frame.middle()), visible);
  }
}

void FrameDrawing::draw_points() {
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    if (frame.degrees_off(i) <= kShownDegrees) continue;
    const Point along = View::direction(nearest_truth(frame, frame.points[i].normal));
    arrow(view.place(frame.place(i)), along, "truth", "truth-head");
  }
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const std::string wrong = frame.has_wrong_normal(i) ? " wrong" : "";
    const Point along = View::direction(unit_or_zero(frame.points[i].normal));
    arrow(view.place(frame.place(i)), along, "kept" + wrong, "kept-head" + wrong);
  }
  for (const KeptPoint& point : frame.points) {
    const Point on_a = view.place(frame.anchor(point, Side::a));
    const Point on_b = view.place(frame.anchor(point, Side::b));
    if (const auto seen = inside(Segment{on_a, on_b}, view.frame)) svg.line(*seen, "joined");
    if (view.frame.contains(on_b)) svg.circle(on_b, 6, "anchor b");
    if (view.frame.contains(on_a)) svg.circle(on_a, 3.6, "anchor a");
    for (const Point& at : {on_a, on_b}) taken.push_back(Box{at.x(), at.y()}.grown(7));
  }
}

void FrameDrawing::write_labels() {
  const auto beyond = [&](std::size_t i, const Point& normal) {
    return Point(view.place(frame.place(i)) + (kNormalLength + 14) * View::direction(normal));
  };
  for (std::size_t i = 0; i < frame.points.size(); ++i) {
    const KeptPoint& point = frame.points[i];
    const bool is_blamed = frame.is_to_blame(i);
    const std::string words =
        frame.has_wrong_normal(i)
            ? fmt::format("{}: {:.0f} degrees off", point.id, frame.degrees_off(i))
            : std::to_string(point.id);
    if (frame.has_wrong_normal(i)) {
      write_label(beyond(i, nearest_truth(frame, point.normal)), "true", kMarkFont, "right-word");
    }
    write_label(beyond(i, unit_or_zero(point.normal)), words, kMarkFont,
                is_blamed ? "wrong-word" : "title");
  }
  for (const Side side : kSides) {
    const auto& at = letters[static_cast<std::size_t>(side)];
    if (!at) continue;
    write_label(*at, side == Side::a ? "A" : "B", kLetterFont, css_of("letter", side));
  }
}

}  // namespace

void draw_strip_frame(Svg& svg, const StripFrame& frame, const View& view) {
  FrameDrawing drawing{svg, frame, view};
  drawing.draw_bodies();
  drawing.draw_points();
  drawing.write_labels();
}

}  // namespace manifuzz
