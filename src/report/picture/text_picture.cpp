#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr int kColumns = 76;
constexpr int kRowsOfAll = 24;
constexpr int kRowsOfCloser = 14;
/// What is smaller than so many dots is shown again, if it can be shown so much closer.
constexpr double kSmall = 16;
constexpr double kCloser = 2;
/// So few dots of depth are not seen either.
constexpr double kThin = 2;
/// Shares of the whole below this are roundoff, or soon will be.
constexpr double kPrecision = 1e-9;
/// A closer view shows this share of the whole at least, where there is but one place to show.
constexpr double kPlaceShare = 1.0 / 16;

/// Right points first, then those of the answers; several in one cell are one mark.
constexpr char kRight = '+';
constexpr std::array<char, 2> kAnswerMarks{'S', 'O'};
constexpr char kSeveral = '*';

/// A part of the world on a canvas; `scale` in dots a length.
struct DotFrame {
  Box box;
  double scale = 1;
  int columns = 1;
  int rows = 1;

  Point place(const Point& p) const {
    return {(p.x() - box.x) * scale, (box.bottom() - p.y()) * scale};
  }
  Point back(int x, int y) const { return {box.x + x / scale, box.bottom() - y / scale}; }
};

/// Contact points with their marks, the right ones first, which lie above those that come later.
std::vector<std::pair<Point, char>> marks_of(const Scene& scene) {
  std::vector<std::pair<Point, char>> marks;
  for (const Point& right : scene.right) marks.emplace_back(right, kRight);
  for (const DrawnPoint& point : scene.points) {
    marks.emplace_back(point.position, kAnswerMarks[point.by_subject ? 0 : 1]);
  }
  return marks;
}

/// A finite box, which is not a point, at the largest scale that the canvas has room for.
DotFrame framed(const Box& box, int rows) {
  const double scale = std::min((2.0 * kColumns - 1) / box.width, (4.0 * rows - 1) / box.height);
  const auto cells = [scale](double length, int dots) {
    return static_cast<int>((length * scale + 1e-9) / dots) + 1;
  };
  return {box, scale, cells(box.width, 2), cells(box.height, 4)};
}

/// What a closer view has to show: the overlap and the points where they are small, with some air
/// around; else an end of the contact where the overlap, or the gap, is too thin. None where all is
/// seen.
std::optional<Box> closer(const Scene& scene, const DotFrame& all) {
  const auto marks = marks_of(scene);
  const double tolerance = 0.25 / all.scale;
  std::vector<Point> places = intersection(scene.shape(Side::a, all.box, tolerance),
                                           scene.shape(Side::b, all.box, tolerance));
  for (const auto& [point, mark] : marks) {
    if (all.box.contains(point)) places.push_back(point);
  }
  if (places.empty()) return std::nullopt;
  const Box of_interest = box_around(places);
  const double whole_side = std::max(all.box.width, all.box.height);
  const double side = std::max(of_interest.width, of_interest.height);
  if (side * all.scale < kSmall) {
    return of_interest.grown(0.5 *
                             (side > kPrecision * whole_side ? side : kPlaceShare * whole_side));
  }
  const bool is_thin = scene.depth * all.scale < kThin && scene.depth > kPrecision * whole_side;
  if (!is_thin || marks.empty()) return std::nullopt;
  const Point& end = marks.front().first;
  return Box{end.x(), end.y()}.grown(4 * scene.depth);
}

void draw_outline(DotCanvas& canvas, const DotFrame& frame, const Region& region, int every) {
  for (std::size_t i = 0; i < region.size(); ++i) {
    const auto edge = inside({region[i], region[(i + 1) % region.size()]}, frame.box);
    if (edge) canvas.line(frame.place(edge->first), frame.place(edge->second), every);
  }
}

void fill(DotCanvas& canvas, const DotFrame& frame, const Region& region) {
  if (region.size() < 3) return;
  for (int y = 0; y < canvas.height(); y += 2) {
    for (int x = y / 2 % 2; x < canvas.width(); x += 2) {
      if (depth_in(region, frame.back(x, y)) >= 0) canvas.dot(x, y);
    }
  }
}

std::string drawn(const Scene& scene, const DotFrame& frame) {
  DotCanvas canvas(frame.columns, frame.rows);
  const double tolerance = 0.25 / frame.scale;
  const Region a = scene.shape(Side::a, frame.box, tolerance);
  const Region b = scene.shape(Side::b, frame.box, tolerance);
  fill(canvas, frame, intersection(intersection(a, frame.box), b));
  draw_outline(canvas, frame, a, 1);
  draw_outline(canvas, frame, b, 2);
  for (const Side side : kSides) {
    const Point middle = middle_of(scene.polygons[side].corners());
    if (frame.box.contains(middle)) canvas.mark(frame.place(middle), side == Side::a ? 'A' : 'B');
  }
  for (const auto& [point, mark] : marks_of(scene)) {
    if (!frame.box.contains(point)) continue;
    const Point at = frame.place(point);
    const char there = canvas.mark_at(at);
    const bool is_first = there == 0 || there == 'A' || there == 'B' || there == mark;
    canvas.mark(at, is_first ? mark : kSeveral);
  }
  return canvas.text();
}

std::string legend(const PairCase& pair, std::span<const DeclaredAnswer> answers,
                   const DotFrame& frame) {
  std::string text =
      fmt::format("A solid, B dotted, overlap filled; a character is {} wide\n{} right: {}\n",
                  brief(2 / frame.scale), kRight, truth_in_words(pair));
  for (std::size_t i = 0; i < answers.size() && i < kAnswerMarks.size(); ++i) {
    text += fmt::format("{} {}: {}\n", kAnswerMarks[i], answers[i].declaration.name,
                        printable(answer_in_words(answers[i]), 200));
  }
  return text + fmt::format("{} several of these\n", kSeveral);
}

}  // namespace

std::string text_picture(const PairCase& pair, std::span<const DeclaredAnswer> answers) {
  const Scene scene = make_scene(pair, answers);
  const DotFrame all = framed(scene.whole(0.5), kRowsOfAll);
  std::string text = drawn(scene, all);
  if (const auto part = closer(scene, all)) {
    const DotFrame near = framed(*part, kRowsOfCloser);
    const double times = near.scale / all.scale;
    if (times >= kCloser) {
      text += fmt::format("\n{} times closer:\n{}", brief(times), drawn(scene, near));
    }
  }
  return text + '\n' + legend(pair, answers, all);
}

std::string text_picture(const JudgedCase& judged) {
  return text_picture(judged.given.pair(), std::array{judged.subject, judged.oracle});
}

}  // namespace manifuzz
