#include "report/picture/text_picture.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text.hpp"
#include "report/candidate.hpp"
#include "report/picture/dot_canvas.hpp"
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

struct Marked {
  Point position{0, 0};
  char mark = kRight;
};

/// What a picture shows, in world directions and lengths, seen from A's position.
struct Sight {
  std::array<exact::RoughPolygon, 2> polygons;
  std::array<double, 2> radii{};
  std::vector<Marked> points;  ///< finite ones
  double depth = 0;            ///< of the overlap, or the gap

  Region region(std::size_t i, const Box& where, double tolerance) const {
    return rounded(polygons[i], radii[i], where, tolerance);
  }
};

/// A part of the world on a canvas; `scale` in dots a length.
struct Frame {
  Box box;
  double scale = 1;
  int columns = 1;
  int rows = 1;

  Point place(const Point& p) const {
    return {(p.x() - box.x) * scale, (box.bottom() - p.y()) * scale};
  }
  Point back(int x, int y) const { return {box.x + x / scale, box.bottom() - y / scale}; }
};

void add_points(Sight& sight, const PairCase& pair, const Manifold<double>& manifold, int count,
                char mark) {
  for (int i = 0; i < count; ++i) {
    const Point& local = manifold.points[i].position;
    if (!local.allFinite()) continue;
    sight.points.push_back({rotate<double>(pair.a.pose.rotation.cast<double>(), local), mark});
  }
}

Sight sight_of(const PairCase& pair, std::span<const DeclaredAnswer> answers) {
  const auto placed = exact::place_roughly(pair);
  Sight sight{{placed.a, placed.b}, {pair.a.polygon.radius, pair.b.polygon.radius}, {}};
  const exact::Truth truth(pair);
  sight.depth = std::abs(leading(truth.fine_separation(truth.greatest())) - total_radius(pair));
  const Admissible right = admissible(pair, answers[0].declaration);
  if (const exact::Clip* const clip = candidate_to_show(right, answers[0])) {
    const Manifold<double> manifold = true_manifold(*clip);
    add_points(sight, pair, manifold, manifold.count, kRight);
  }
  for (std::size_t i = 0; i < answers.size() && i < kAnswerMarks.size(); ++i) {
    const Manifold<double>* const manifold = answers[i].manifold();
    if (manifold) add_points(sight, pair, *manifold, answers[i].count(), kAnswerMarks[i]);
  }
  return sight;
}

Box around_polygons(const Sight& sight) {
  std::vector<Point> corners;
  for (std::size_t i = 0; i < 2; ++i) {
    for (int v = 0; v < sight.polygons[i].count; ++v) {
      const Point& corner = sight.polygons[i].vertices[static_cast<std::size_t>(v)];
      const Point skin(sight.radii[i], sight.radii[i]);
      corners.insert(corners.end(), {corner - skin, corner + skin});
    }
  }
  return box_around(corners);
}

double longer_side(const Box& box) {
  return std::max(box.width, box.height);
}

/// The polygons, and the points that are not absurdly far off.
Box whole(const Sight& sight) {
  const Box box = around_polygons(sight);
  std::vector<Point> places{{box.x, box.y}, {box.right(), box.bottom()}};
  for (const Marked& point : sight.points) {
    if (box.grown(longer_side(box) / 2).contains(point.position)) places.push_back(point.position);
  }
  return box_around(places);
}

/// A finite box, which is not a point, at the largest scale that the canvas has room for.
Frame framed(const Box& box, int rows) {
  const double scale = std::min((2.0 * kColumns - 1) / box.width, (4.0 * rows - 1) / box.height);
  const auto cells = [scale](double length, int dots) {
    return static_cast<int>((length * scale + 1e-9) / dots) + 1;
  };
  return {box, scale, cells(box.width, 2), cells(box.height, 4)};
}

/// The box around what is of interest: the overlap, and the points.
std::optional<Box> interest(const Sight& sight, const Region& overlap, const Box& where) {
  std::vector<Point> places = overlap;
  for (const Marked& point : sight.points) {
    if (where.contains(point.position)) places.push_back(point.position);
  }
  return places.empty() ? std::nullopt : std::optional(box_around(places));
}

/// What a closer view has to show: all that is of interest where it is small, with some air around;
/// else an end of the contact where the overlap, or the gap, is too thin. None where all is seen.
std::optional<Box> closer(const Sight& sight, const Frame& all, const Region& overlap) {
  const auto of_interest = interest(sight, overlap, all.box);
  if (!of_interest) return std::nullopt;
  const double whole_side = longer_side(all.box);
  const double side = longer_side(*of_interest);
  if (side * all.scale < kSmall) {
    return of_interest->grown(side > kPrecision * whole_side ? 0.5 * side
                                                             : 0.5 * kPlaceShare * whole_side);
  }
  const bool is_thin = sight.depth * all.scale < kThin && sight.depth > kPrecision * whole_side;
  if (!is_thin || sight.points.empty()) return std::nullopt;
  const Point& end = sight.points.front().position;
  return Box{end.x(), end.y(), 0, 0}.grown(4 * sight.depth);
}

void draw_outline(DotCanvas& canvas, const Frame& frame, const Region& region, int every) {
  for (std::size_t i = 0; i < region.size(); ++i) {
    const auto edge = inside({region[i], region[(i + 1) % region.size()]}, frame.box);
    if (edge) canvas.line(frame.place(edge->first), frame.place(edge->second), every);
  }
}

void fill(DotCanvas& canvas, const Frame& frame, const Region& region) {
  if (region.size() < 3) return;
  for (int y = 0; y < canvas.height(); y += 2) {
    for (int x = y / 2 % 2; x < canvas.width(); x += 2) {
      if (depth_in(region, frame.back(x, y)) >= 0) canvas.dot(x, y);
    }
  }
}

Point middle_of(const exact::RoughPolygon& polygon) {
  Point sum(0, 0);
  for (int i = 0; i < polygon.count; ++i) sum += polygon.vertices[static_cast<std::size_t>(i)];
  return sum / polygon.count;
}

std::string drawn(const Sight& sight, const Frame& frame) {
  DotCanvas canvas(frame.columns, frame.rows);
  const double tolerance = 0.25 / frame.scale;
  const Region a = sight.region(0, frame.box, tolerance);
  const Region b = sight.region(1, frame.box, tolerance);
  fill(canvas, frame, intersection(intersection(a, frame.box), b));
  draw_outline(canvas, frame, a, 1);
  draw_outline(canvas, frame, b, 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const Point middle = middle_of(sight.polygons[i]);
    if (frame.box.contains(middle)) canvas.mark(frame.place(middle), i == 0 ? 'A' : 'B');
  }
  for (const Marked& point : sight.points) {
    if (!frame.box.contains(point.position)) continue;
    const Point at = frame.place(point.position);
    const char there = canvas.mark_at(at);
    const bool is_first = there == 0 || there == 'A' || there == 'B' || there == point.mark;
    canvas.mark(at, is_first ? point.mark : kSeveral);
  }
  return canvas.text();
}

std::string legend(const PairCase& pair, std::span<const DeclaredAnswer> answers,
                   const Frame& frame) {
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
  const Sight sight = sight_of(pair, answers);
  const Frame all = framed(whole(sight), kRowsOfAll);
  std::string text = drawn(sight, all);
  const double tolerance = 0.25 / all.scale;
  const Region overlap =
      intersection(sight.region(0, all.box, tolerance), sight.region(1, all.box, tolerance));
  if (const auto part = closer(sight, all, overlap)) {
    const Frame near = framed(*part, kRowsOfCloser);
    const double times = near.scale / all.scale;
    if (times >= kCloser) {
      text += fmt::format("\n{} times closer:\n{}", brief(times), drawn(sight, near));
    }
  }
  return text + '\n' + legend(pair, answers, all);
}

std::string text_picture(const JudgedCase& judged) {
  return text_picture(judged.given.pair, std::array{judged.subject, judged.oracle});
}

}  // namespace manifuzz
