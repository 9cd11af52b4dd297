#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "judging/by_curve.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "report/texts.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kFrame = 620;  // the plot's height, as wide as the picture
constexpr double kLevel = 150;  // the radius of depth 0
constexpr double kReach = 270;  // the farthest that the curve gets from the middle
constexpr double kCrater = 60;  // the nearest
constexpr double kShapes = 52;  // the radius that both shapes fit into, in the middle
constexpr Font kLevelFont{10.5};
constexpr double kPlot = 580;  // the side of a plot alone, which is drawn half as large
constexpr Font kPlotFont{19};

/// An answer as the curve sees it.
struct SeenAnswer {
  Point normal{0, 0};  ///< in the world, unit or nearly
  double depth = 0;    ///< of its deepest point
  double along = 0;    ///< D at its normal
};

class CurvePicture {
 public:
  explicit CurvePicture(const JudgedCase& judged)
      : judged_(judged),
        pair_(judged.given.pair()),
        truth_(pair_),
        curve_(truth_, exact::skin_of(truth_)),
        placed_(exact::place_roughly(pair_)),
        bounds_(bounds(pair_, judged.subject.declaration)),
        svg_(title(), kPictureStyle) {
    double deepest = 0;
    for (const double angle : exact::angles_to_draw(placed_))
      deepest = std::max(deepest, depth_along(at_angle(angle)));
    const double least = curve_.least();
    scale_ = (kReach - kLevel) / deepest;
    if (least < 0) scale_ = std::min(scale_, (kLevel - kCrater) / -least);
  }

  std::string draw() {
    double y = write_down(svg_, title(), {kPictureEdge, 38}, kRight, kTitleFont, "title") - 5;
    y = write_down(svg_, subtitle(), {kPictureEdge, y}, kRight, kTextFont, "subtitle") - 6;
    const Box frame{kPictureEdge, y, kPictureWidth - 2 * kPictureEdge, kFrame};
    draw_plot(frame, kLevelFont);
    y = frame.bottom() + 25;
    y = write_ring(y);
    y = write_answer(judged_.subject, true, y);
    y = write_answer(judged_.oracle, false, y);
    return svg_.finish(kPictureWidth, y);
  }

  /// Without words, which stand beside it.
  CurvePlot draw_small() {
    draw_plot({0, 0, kPlot, kPlot}, kPlotFont);
    return {svg_.finish(kPlot, kPlot),
            {title(), ring_in_words(), in_words(judged_.subject), in_words(judged_.oracle)}};
  }

 private:
  static constexpr double kRight = kPictureWidth - kPictureEdge;

  static Point at_angle(double angle) { return {std::cos(angle), std::sin(angle)}; }

  /// A depth along a unit normal, on the canvas.
  Point place(const Point& normal, double depth) const {
    return middle_ + (kLevel + scale_ * depth) * View::direction(normal);
  }

  double depth_along(const Point& normal) const {
    return exact::Along(truth_, local_normal(pair_, normal)).depth();
  }

  void draw_plot(const Box& frame, const Font& level_font) {
    middle_ = frame.center();
    svg_.box(frame, "frame", 4);
    draw_shapes();
    draw_levels(level_font);
    draw_curve();
    draw_answer(judged_.oracle, false);
    draw_answer(judged_.subject, true);
  }

  /// Both shapes, small, in the middle. Mitred skins are left out: their corners may be far away.
  void draw_shapes() {
    std::array<Rim, 2> rims;
    std::vector<Point> ends;
    for (const Side side : kSides) {
      Rim& rim = rims[static_cast<std::size_t>(side)];
      const double radius = static_cast<double>(pair_[side].polygon.radius);
      rim = rim_of(placed_[side], is_round(pair_) ? radius : 0, Rounding::round);
      const Box box = box_around_rim(rim);
      ends.insert(ends.end(), {Point(box.x, box.y), Point(box.right(), box.bottom())});
    }
    const Box all = box_around(ends);
    const double shrunk = kShapes / length(Point(all.width, all.height) / 2);
    const View view{Box{middle_.x(), middle_.y()}, all.center(), shrunk};
    for (const Side side : kSides) {
      const Rim rim = view.place(rims[static_cast<std::size_t>(side)]);
      svg_.rim(rim, side == Side::a ? "fill a" : "fill b");
      svg_.rim(rim, side == Side::a ? "outline a" : "outline b");
    }
  }

  void draw_level(double depth, std::string_view words, const Font& font) {
    const double radius = kLevel + scale_ * depth;
    svg_.circle(middle_, radius, "level");
    const double width = text_width(words, font);
    // On the far side of what the picture is about.
    const double down = View::direction(minima().front()).y() > 0 ? -radius : radius;
    const Point at = middle_ + Point(-width / 2, down + 0.38 * font.size);
    svg_.box({at.x() - 3, at.y() - font.size, width + 6, 1.3 * font.size}, "label");
    svg_.text(at, words, font, "quiet");
  }

  /// Depth 0, and a round depth outside it.
  void draw_levels(const Font& font) {
    draw_level(0, "depth 0: they touch", font);
    const double widest = 0.8 * (kReach - kLevel) / scale_;
    const double power = std::pow(10, std::floor(std::log10(widest)));
    const double round = widest >= 5 * power ? 5 * power : widest >= 2 * power ? 2 * power : power;
    draw_level(round, "depth " + brief(round), font);
  }

  void draw_curve() {
    Region outline;
    for (const double angle : exact::angles_to_draw(placed_)) {
      outline.push_back(place(at_angle(angle), depth_along(at_angle(angle))));
    }
    svg_.polygon(outline, "curve");
    for (const Point& normal : minima()) svg_.circle(place(normal, curve_.least()), 10, "ring");
  }

  std::vector<Point> minima() const {
    const double bound = bounds_.separation;
    std::vector<Point> normals;
    for (const Point& normal : curve_.minima(std::isfinite(bound) ? bound : 0)) {
      normals.push_back(world_normal(pair_, normal));
    }
    return normals;
  }

  std::optional<SeenAnswer> seen(const DeclaredAnswer& asked) const {
    const auto said = said_along(asked.answer);
    if (!said || !said->normal.allFinite() || said->normal.isZero(0)) return std::nullopt;
    if (!std::isfinite(said->depth)) return std::nullopt;
    return SeenAnswer{world_normal(pair_, said->normal), said->depth,
                      exact::Along(truth_, said->normal).depth()};
  }

  void draw_answer(const DeclaredAnswer& asked, bool is_subject) {
    const auto answer = seen(asked);
    if (!answer) return;
    const Point direction = unit_or_zero(answer->normal);
    const Point at = place(direction, answer->depth);
    svg_.line({middle_ + kShapes * View::direction(direction), at},
              is_subject ? "ray subject" : "ray oracle");
    draw_mark(svg_, at, is_subject);
  }

  std::string title() const {
    return fmt::format("How deep they overlap, direction by direction: least {}",
                       brief(curve_.least()));
  }

  static std::string subtitle() {
    return "The farther the line is from the middle in a direction, the farther B must be moved "
           "that way to leave A. A right answer stands in a ring, where that is least; one on the "
           "line elsewhere names a deeper way out; one off the line has a depth that its own "
           "normal does not have.";
  }

  std::string ring_in_words() const {
    std::string text = minima().size() > 1 ? "the least depths, which tie:" : "the least depth:";
    std::string_view separator = " ";
    for (const Point& normal : minima()) {
      text += fmt::format("{}along ({}, {})", separator, brief(normal.x()), brief(normal.y()));
      separator = " and ";
    }
    return text;
  }

  double write_ring(double y) {
    svg_.circle({kPictureEdge + 9, y - 4}, 8, "ring");
    return write_down(svg_, ring_in_words(), {kPictureEdge + 26, y}, kRight, kTextFont, "legend");
  }

  double write_answer(const DeclaredAnswer& asked, bool is_subject, double y) {
    draw_mark(svg_, {kPictureEdge + 9, y - 4}, is_subject);
    return write_down(svg_, in_words(asked), {kPictureEdge + 26, y}, kRight, kTextFont, "legend");
  }

  std::string in_words(const DeclaredAnswer& asked) const {
    const auto answer = seen(asked);
    if (!answer) {
      return fmt::format("{}: {}", asked.declaration.name, answer_in_words(asked));
    }
    return fmt::format("{}: depth {} along ({}, {}), where they overlap by {}, {} more than least",
                       asked.declaration.name, brief(answer->depth), brief(answer->normal.x()),
                       brief(answer->normal.y()), brief(answer->along),
                       brief(answer->along - curve_.least())) +
           (used_by(asked.answer) == nullptr ? "" : "; it used shapes of its own");
  }

  const JudgedCase& judged_;
  const PairCase& pair_;
  exact::Truth truth_;
  exact::PenetrationCurve curve_;
  exact::RoughPair placed_;
  Bounds bounds_;
  Svg svg_;
  double scale_ = 1;
  Point middle_{0, 0};
};

}  // namespace

std::string curve_svg(const JudgedCase& judged) {
  return CurvePicture(judged).draw();
}

CurvePlot curve_plot(const JudgedCase& judged) {
  return CurvePicture(judged).draw_small();
}

std::string curve_png(const JudgedCase& judged) {
  return png_of(curve_svg(judged));
}

}  // namespace manifuzz
