#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "report/picture/drawing.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kMarkRadius = 5;
constexpr double kMarkSquare = 15;
constexpr double kArrow = 54;
constexpr double kBarOffset = 3.5;  // of either collider's bars, so that both are seen
constexpr double kSameSpot = 9;     // contact points nearer than this share a label

void draw_bar(Drawing& drawing, const DepthBar& bar, double offset, std::string_view style) {
  const Point from = drawing.view.place(bar.from);
  const Point along = drawing.view.place(bar.to) - from;
  const double pixels = length(along);
  if (!(pixels >= 1)) return;
  const Point aside = clockwise_quarter<double>(along) / pixels;
  const Point shifted = from + aside * offset;
  drawing.stroke({shifted, shifted + along}, style);
  const Point foot = shifted + along;
  if (drawing.sees(foot)) drawing.svg.line({foot - 4 * aside, foot + 4 * aside}, style);
}

/// Where the true bar ends beside the reference face, the line from there to the face's skin.
void extend_reference(Drawing& drawing) {
  const Scene& scene = drawing.scene;
  const Point lift = scene.radius(scene.reference.side) * scene.outward;
  const Point from = scene.reference.segment.first + lift;
  const Point along = scene.reference.segment.second + lift - from;
  const double share = along.dot(scene.deepest.to - from) / along.dot(along);
  if (share >= 0 && share <= 1) return;
  const Point end = share < 0 ? from : Point(from + along);
  drawing.stroke(drawing.view.place(Segment(scene.deepest.to, end)), "extension");
}

/// Of every reported point; where there is none, of the truth.
void draw_bars(Drawing& drawing) {
  const Scene& scene = drawing.scene;
  if (scene.points.empty()) draw_bar(drawing, scene.deepest, 0, "bar truth");
  for (const DrawnPoint& point : scene.points) {
    draw_bar(drawing, point.bar, point.by_subject ? -kBarOffset : kBarOffset,
             point.by_subject ? "bar subject" : "bar oracle");
  }
}

/// How far a place is from every contact point and the foot of every bar.
double clearance(const Drawing& drawing, const Point& place) {
  double least = std::numeric_limits<double>::infinity();
  const auto see = [&](const Point& p) {
    least = std::min(least, length(drawing.view.place(p) - place));
  };
  const Scene& scene = drawing.scene;
  if (scene.points.empty()) {
    see(scene.deepest.from);
    see(scene.deepest.to);
  }
  for (const DrawnPoint& point : scene.points) {
    see(point.position);
    see(point.bar.to);
  }
  return least;
}

void draw_arrow(Drawing& drawing, const Point& from, const Point& direction, std::string text) {
  const Point to = from + kArrow * direction;
  if (!drawing.view.frame.grown(-8).contains(to)) return;
  const Point aside = clockwise_quarter<double>(direction);
  const Point neck = to - 10 * direction;
  drawing.stroke({from, neck}, "normal");
  drawing.svg.polygon({to, neck + 4.5 * aside, neck - 4.5 * aside}, "arrow");
  drawing.labels.block(Box{to.x(), to.y(), 0, 0}.grown(5));
  drawing.words.push_back(
      {.text = std::move(text), .anchor = to, .towards = direction, .css = "normal-word"});
}

/// On the reference face, where there is room.
void draw_normal(Drawing& drawing) {
  const auto face =
      inside(drawing.view.place(drawing.scene.reference.segment), drawing.view.frame.grown(-10));
  if (!face) return;
  constexpr double enough = 40;
  const auto on_face = [&](double share) -> Point {
    return face->first + share * (face->second - face->first);
  };
  Point base = on_face(0.5);
  for (const double share : {0.4, 0.6, 0.3, 0.7, 0.2, 0.8, 0.1, 0.9}) {
    if (clearance(drawing, base) > enough) break;
    if (clearance(drawing, on_face(share)) > clearance(drawing, base) + 4) base = on_face(share);
  }
  draw_arrow(drawing, base, View::direction(drawing.scene.normal), "normal, A to B");
}

/// Of a collider whose normal is clearly another one.
void draw_differing_normal(Drawing& drawing, bool of_subject) {
  constexpr double clearly = 0.998;
  for (const DrawnPoint& point : drawing.scene.points) {
    const Point at = drawing.view.place(point.position);
    if (point.by_subject != of_subject || !drawing.sees(at)) continue;
    const double reported = length(point.normal);
    const bool is_unit = std::abs(reported - 1) <= 1 - clearly;
    if (is_unit && point.normal.dot(drawing.scene.normal) >= clearly) continue;
    std::string text = "normal of " + (of_subject ? drawing.names.subject : drawing.names.oracle);
    if (!is_unit) text += fmt::format(", length {}", brief(reported));
    draw_arrow(drawing, at, View::direction(unit(point.normal)), text);
    return;
  }
}

/// "depth 0.31 (clip, box2d)": what is reported at one spot, equal figures once.
std::string depth_text(const std::vector<const DrawnPoint*>& spot, const MarkNames& names) {
  std::vector<std::pair<std::string, std::vector<std::string>>> said;  // figure, by whom
  for (const DrawnPoint* point : spot) {
    const std::string figure = brief(point->bar.depth);
    const std::string& who = point->by_subject ? names.subject : names.oracle;
    auto same = std::find_if(said.begin(), said.end(),
                             [&](const auto& entry) { return entry.first == figure; });
    if (same == said.end()) same = said.insert(said.end(), {figure, {}});
    if (same->second.empty() || same->second.back() != who) same->second.push_back(who);
  }
  std::vector<std::string> parts;
  for (const auto& [figure, by] : said) {
    parts.push_back(fmt::format("{} ({})", figure, fmt::join(by, ", ")));
  }
  return fmt::format("depth {}", fmt::join(parts, ", "));
}

/// The class of those who report at one spot; of nobody where both do.
std::string whose(const std::vector<const DrawnPoint*>& spot) {
  const bool same = std::all_of(spot.begin(), spot.end(), [&](const DrawnPoint* point) {
    return point->by_subject == spot.front()->by_subject;
  });
  if (!same) return {};
  return spot.front()->by_subject ? " subject" : " oracle";
}

/// A reported depth is named at its point, or where its bar is seen if the point is not.
struct Named {
  const DrawnPoint* point;
  Point at;
};

std::vector<Named> named_points(const Drawing& drawing) {
  constexpr double shortest_bar = 14;
  std::vector<Named> named;
  for (const DrawnPoint& point : drawing.scene.points) {
    const Point at = drawing.view.place(point.position);
    const auto bar =
        inside(drawing.view.place(Segment(point.bar.from, point.bar.to)), drawing.view.frame);
    if (drawing.sees(at)) {
      named.push_back({&point, at});
    } else if (bar && length(bar->second - bar->first) >= shortest_bar) {
      named.push_back({&point, (bar->first + bar->second) / 2});
    }
  }
  return named;
}

void label_depths(Drawing& drawing) {
  std::vector<Named> left = named_points(drawing);
  while (!left.empty()) {
    const Named first = left.front();
    const auto others = std::stable_partition(left.begin(), left.end(), [&](const Named& named) {
      return length(named.at - first.at) < kSameSpot;
    });
    std::vector<const DrawnPoint*> spot;
    for (auto named = left.begin(); named != others; ++named) spot.push_back(named->point);
    left.erase(left.begin(), others);
    const Point inwards = View::direction(first.point->bar.from - first.point->bar.to);
    drawing.words.insert(drawing.words.begin(), {.text = depth_text(spot, drawing.names),
                                                 .anchor = first.at,
                                                 .towards = unit(inwards),
                                                 .font = {12, true},
                                                 .css = "depth-word" + whose(spot)});
  }
}

/// Where nobody reports a point, the bar of the truth has the word.
void label_truth(Drawing& drawing) {
  const DepthBar& bar = drawing.scene.deepest;
  const Point middle = drawing.view.place(Point((bar.from + bar.to) / 2));
  if (!drawing.scene.points.empty() || !drawing.sees(middle)) return;
  drawing.words.push_back(
      {.text = bar.depth >= 0 ? "true depth " + brief(bar.depth) : "gap " + brief(-bar.depth),
       .anchor = middle,
       .font = {12, true},
       .css = "depth-word subject"});
}

}  // namespace

void draw_mark(Svg& svg, const Point& at, bool by_subject) {
  if (by_subject) return svg.circle(at, kMarkRadius, "mark-subject");
  svg.box({at.x() - kMarkSquare / 2, at.y() - kMarkSquare / 2, kMarkSquare, kMarkSquare},
          "mark-oracle");
}

void draw_contacts(Drawing& drawing) {
  extend_reference(drawing);
  draw_bars(drawing);
  for (const DrawnPoint& point : drawing.scene.points) {
    const Point at = drawing.view.place(point.position);
    if (drawing.sees(at))
      drawing.labels.block(Box{at.x(), at.y(), 0, 0}.grown(kMarkSquare / 2 + 1));
  }
  draw_normal(drawing);
  for (const bool of_subject : {true, false}) draw_differing_normal(drawing, of_subject);
  label_depths(drawing);
  label_truth(drawing);
  for (const DrawnPoint& point : drawing.scene.points) {
    const Point at = drawing.view.place(point.position);
    if (drawing.sees(at)) draw_mark(drawing.svg, at, point.by_subject);
  }
}

}  // namespace manifuzz
