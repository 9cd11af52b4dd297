#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "oracle/exact/placed.hpp"
#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/sequence/strip_frames.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kGutter = 14;        // between frames, in pixels
constexpr double kStripLine = 18;     // of text below a frame
constexpr double kHeadRoom = 26;      // of a frame's heading, above its picture
constexpr double kNormalLength = 62;  // of arrows, in pixels
constexpr double kShownDegrees = 2;   // true normals nearer than this are not drawn
constexpr std::size_t kColumnsMax = 4;
constexpr Font kHeadFont{13, true};
constexpr Font kNoteFont{11.5};
constexpr Font kMarkFont{11, true};

constexpr std::string_view kStripStyle = R"(
.wrong-frame{fill:none;stroke:#d1002c;stroke-width:3}
.wrong-word{fill:#b00025}
.right-word{fill:#006048}
.anchor.a{fill:#0072b2;stroke:#ffffff;stroke-width:1.2}
.anchor.b{fill:none;stroke:#b87900;stroke-width:2.2}
.joined{stroke:#14181f;stroke-width:1.4;stroke-dasharray:3 2}
.kept{stroke:#14181f;stroke-width:2.2}
.kept-head{fill:#14181f}
.kept.wrong{stroke:#d1002c;stroke-width:2.8}
.kept-head.wrong{fill:#d1002c}
.truth{stroke:#00795c;stroke-width:2.2;stroke-dasharray:6 3}
.truth-head{fill:#00795c}
.spoke{stroke-width:1.2;stroke-dasharray:2 3}
.spoke.a{stroke:#0072b2}
.spoke.b{stroke:#b87900}
)";

std::string of_side(std::string_view kind, Side side) {
  return fmt::format("{} {}", kind, side == Side::a ? "a" : "b");
}

/// One frame, in world directions and lengths, seen from A's position.
struct StripFrame {
  std::size_t number = 0;
  PairCase pair;
  exact::RoughPair polygons{};
  std::array<Rim, 2> rims{};
  std::vector<KeptPoint> points{};
  TrueContact truth{};
  const FrameJudgement* verdict = nullptr;  ///< none where nothing was judged

  bool is_wrong() const { return verdict != nullptr && verdict->kind != Kind::none; }
  const Rim& rim(Side side) const { return rims[static_cast<std::size_t>(side)]; }
  Point anchor(const KeptPoint& point, Side side) const {
    const Pose<float>& pose = pair[side].pose;
    const Point& local = side == Side::a ? point.anchor_a : point.anchor_b;
    const Point turned = rotate<double>(pose.rotation.cast<double>(), local);
    return side == Side::a ? turned : Point(turned + origin(side));
  }
  Point origin(Side side) const {
    return (pair[side].pose.position - pair.a.pose.position).cast<double>();
  }
  Box whole() const {
    const Box a = box_around_rim(rims[0]);
    const Box b = box_around_rim(rims[1]);
    return box_around({{a.x, a.y}, {a.right(), a.bottom()}, {b.x, b.y}, {b.right(), b.bottom()}});
  }
  /// What is looked at: the kept points, or where the bodies are.
  Point middle() const {
    if (points.empty()) return whole().center();
    Point sum(0, 0);
    for (const KeptPoint& point : points) sum += anchor(point, Side::a) + anchor(point, Side::b);
    return sum / (2 * static_cast<double>(points.size()));
  }
};

StripFrame strip_frame(const JudgedSequence& judged, std::size_t number) {
  StripFrame frame{.number = number, .pair = judged.given.sequence().at(number)};
  frame.polygons = exact::place_roughly(frame.pair);
  const Rounding corners = is_round(frame.pair) ? Rounding::round : Rounding::mitre;
  for (const Side side : kSides) {
    const auto radius = static_cast<double>(frame.pair[side].polygon.radius);
    frame.rims[static_cast<std::size_t>(side)] = rim_of(frame.polygons[side], radius, corners);
  }
  frame.points = points_in(judged, number);
  frame.truth = true_contact(frame.pair, judged.subject.declaration);
  const auto& verdicts = judged.judgement.frames;
  if (number < verdicts.size()) frame.verdict = &verdicts[number];
  return frame;
}

/// The angle between two directions, in degrees.
double degrees_between(const Point& p, const Point& q) {
  return std::abs(std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q))) * 180 / std::numbers::pi;
}

/// The true normal that is nearest to this one.
Point nearest_truth(const StripFrame& frame, const Point& normal) {
  return *std::ranges::min_element(
      frame.truth.normals, {}, [&](const Point& truth) { return degrees_between(truth, normal); });
}

void arrow(Svg& svg, const Point& from, const Point& direction, const std::string& line,
           const std::string& head) {
  const Point to = from + kNormalLength * direction;
  const Point across(-direction.y(), direction.x());
  svg.line({from, to - 8 * direction}, line);
  svg.polygon({to, to - 11 * direction + 5 * across, to - 11 * direction - 5 * across}, head);
}

/// A word on a light ground, in the frame.
void label(Svg& svg, const Box& room, Point center, std::string_view text, const Font& font,
           std::string_view css) {
  const double width = text_width(text, font) + 6;
  center.x() = std::clamp(center.x(), room.x + width / 2, room.right() - width / 2);
  center.y() = std::clamp(center.y(), room.y + 9, room.bottom() - 9);
  svg.box({center.x() - width / 2, center.y() - 9, width, 17}, "label", 3);
  svg.text({center.x() - width / 2 + 3, center.y() + 4}, text, font, css);
}

class Filmstrip {
 public:
  explicit Filmstrip(const JudgedSequence& judged)
      : judged_(judged),
        svg_(verdict_sentence(judged), std::string(kPictureStyle) + std::string(kStripStyle)) {
    for (const std::size_t number : frames_that_matter(judged)) {
      frames_.push_back(strip_frame(judged, number));
    }
    const std::size_t columns = std::min(frames_.size(), kColumnsMax);
    width_ = (kPictureWidth - 2 * kPictureEdge - kGutter * static_cast<double>(columns - 1)) /
             static_cast<double>(columns);
    width_ = std::min(width_, 560.0);
    height_ = std::min(0.86 * width_, 380.0);
    columns_ = columns;
    choose_scale();
  }

  std::string draw() {
    write_title();
    for (std::size_t i = 0; i < frames_.size(); i += columns_) draw_row(i);
    write_legend();
    return svg_.finish(kPictureWidth, y_);
  }

 private:
  /// All frames at one scale: both bodies of each, but for what is far larger than the smaller one.
  void choose_scale() {
    double wanted = 0;
    double high = 0;
    for (const StripFrame& frame : frames_) {
      wanted = std::max(wanted, frame.whole().width);
      high = std::max(high, frame.whole().height);
    }
    const double most = 5 * size(judged_.given.pair);
    is_cut_ = wanted > most || high > most;
    const double fit =
        0.86 * std::min(width_ / std::min(wanted, most), height_ / std::min(high, most));
    scale_ = fit > 0 && std::isfinite(fit) ? fit : 1;
  }

  void write_title();
  void draw_row(std::size_t first);
  void draw_frame(const StripFrame& frame, const Box& box);
  void draw_bodies(const StripFrame& frame, const View& view);
  void draw_point(const StripFrame& frame, const View& view, std::size_t i);
  double write_notes(const StripFrame& frame, const Box& box);
  void write_legend();

  const JudgedSequence& judged_;
  Svg svg_;
  std::vector<StripFrame> frames_;
  std::size_t columns_ = 1;
  double width_ = 0;
  double height_ = 0;
  double scale_ = 1;
  bool is_cut_ = false;
  double y_ = 38;
};

void Filmstrip::write_title() {
  const double right = kPictureWidth - kPictureEdge;
  y_ = write_down(svg_, verdict_sentence(judged_), {kPictureEdge, y_}, right, kTitleFont, "title");
  y_ -= 5;
  const Declaration& subject = judged_.subject.declaration;
  std::string text = fmt::format("{} {}: {}.", subject.name, subject.version, subject.description);
  if (frames_.size() < judged_.given.frames.size()) {
    text += fmt::format(
        " Shown are {} of {} frames: the first, births, what is wrong and its "
        "neighbours.",
        frames_.size(), judged_.given.frames.size());
  }
  y_ = write_down(svg_, text, {kPictureEdge, y_}, right, kTextFont, "subtitle");
}

void Filmstrip::draw_row(std::size_t first) {
  const std::size_t end = std::min(first + columns_, frames_.size());
  const double top = y_;
  double bottom = top;
  for (std::size_t i = first; i < end; ++i) {
    const double x = kPictureEdge + static_cast<double>(i - first) * (width_ + kGutter);
    const Box box{x, top + kHeadRoom, width_, height_};
    draw_frame(frames_[i], box);
    bottom = std::max(bottom, write_notes(frames_[i], box));
  }
  y_ = bottom + 12;
}

void Filmstrip::draw_frame(const StripFrame& frame, const Box& box) {
  const std::string heading = fmt::format("frame {}", frame.number);
  svg_.text({box.x + 2, box.y - 8}, heading, kHeadFont, "title");
  const bool was_judged = frame.verdict != nullptr && !frame.verdict->is_ill_posed;
  const std::string_view word = frame.is_wrong() ? "wrong" : was_judged ? "right" : "not judged";
  svg_.text({box.right() - text_width(word, kHeadFont) - 2, box.y - 8}, word, kHeadFont,
            frame.is_wrong() ? "wrong-word"
            : was_judged     ? "right-word"
                             : "quiet");
  svg_.box(box, "frame", 4);
  const View view{box, is_cut_ ? frame.middle() : frame.whole().center(), scale_};
  draw_bodies(frame, view);
  for (std::size_t i = 0; i < frame.points.size(); ++i) draw_point(frame, view, i);
  if (frame.is_wrong()) svg_.box(box, "wrong-frame", 4);
}

void Filmstrip::draw_bodies(const StripFrame& frame, const View& view) {
  const double tolerance = 0.25 / scale_;
  std::array<Region, 2> seen;
  for (const Side side : kSides) {
    const auto i = static_cast<std::size_t>(side);
    seen[i] = region_of(frame.rim(side), view.shown(), tolerance);
    fill_rim(svg_, view, frame.rim(side), seen[i], of_side("fill", side));
  }
  const Region both = intersection(seen[0], seen[1]);
  svg_.polygon(intersection(view.place(both), view.frame), "overlap");
  for (const Side side : kSides) {
    const auto i = static_cast<std::size_t>(side);
    draw_rim(svg_, view, frame.rim(side), seen[i], of_side("outline", side));
    // From the middle to a corner, so that a turn is seen.
    const exact::RoughPolygon& polygon = frame.polygons[side];
    const Region core(polygon.vertices.begin(), polygon.vertices.begin() + polygon.count);
    const Point middle = middle_of(core);
    Point corner = core.front();
    if (core.size() == 1) {
      const double radius = frame.pair[side].polygon.radius;
      corner += radius * frame.pair[side].pose.rotation.cast<double>();
    }
    const auto spoke = inside(view.place(Segment{middle, corner}), view.frame);
    if (spoke) svg_.line(*spoke, of_side("spoke", side));
    const Region visible = intersection(view.place(seen[i]), view.frame);
    if (!visible.empty()) {
      label(svg_, view.frame.grown(-4), middle_of(visible), side == Side::a ? "A" : "B", kHeadFont,
            of_side("letter", side));
    }
  }
}

void Filmstrip::draw_point(const StripFrame& frame, const View& view, std::size_t i) {
  const KeptPoint& point = frame.points[i];
  const Point on_a = view.place(frame.anchor(point, Side::a));
  const Point on_b = view.place(frame.anchor(point, Side::b));
  if (!view.frame.contains(on_a) || !view.frame.contains(on_b)) return;
  const bool is_to_blame =
      frame.is_wrong() && frame.verdict->kind != Kind::extent && frame.verdict->point == i;
  const Point from = (on_a + on_b) / 2;
  const Point normal = unit_or_zero(point.normal);
  const Point truth = nearest_truth(frame, normal);
  const double off = degrees_between(truth, normal);
  const Box room = view.frame.grown(-4);
  if (off > kShownDegrees) {
    const Point along = View::direction(truth);
    arrow(svg_, from, along, "truth", "truth-head");
    label(svg_, room, from + (kNormalLength + 16) * along, "true", kMarkFont, "right-word");
  }
  const Point along = View::direction(normal);
  const std::string wrong = is_to_blame ? " wrong" : "";
  arrow(svg_, from, along, "kept" + wrong, "kept-head" + wrong);
  svg_.line({on_a, on_b}, "joined");
  svg_.circle(on_b, 6, "anchor b");
  svg_.circle(on_a, 3.6, "anchor a");
  const std::string words = is_to_blame && off > kShownDegrees
                                ? fmt::format("{}: {:.0f} degrees off", point.id, off)
                                : fmt::format("{}", point.id);
  const double out = kNormalLength + 16;
  label(svg_, room, from + out * along, words, kMarkFont, is_to_blame ? "wrong-word" : "title");
}

double Filmstrip::write_notes(const StripFrame& frame, const Box& box) {
  double y = box.bottom() + kStripLine;
  const auto write = [&](std::string_view text, std::string_view css) {
    y = write_down(svg_, text, {box.x + 2, y}, box.right(), kNoteFont, css) + 1;
  };
  write(fmt::format("true {} {}", frame.truth.depth < 0 ? "gap" : "overlap",
                    brief(std::abs(frame.truth.depth))),
        "subtitle");
  for (const KeptPoint& point : frame.points) {
    const bool is_new = point.born == static_cast<int>(frame.number);
    write(fmt::format("point {}: {} {}, {}", point.id, point.depth < 0 ? "gap" : "depth",
                      brief(std::abs(point.depth)),
                      is_new ? "new" : fmt::format("kept since frame {}", point.born)),
          "legend");
  }
  if (frame.points.empty()) write("no point", "legend");
  const std::string words = frame_in_words(judged_, frame.number);
  if (words != "right") write(words, frame.is_wrong() ? "wrong-word" : "subtitle");
  return y;
}

void Filmstrip::write_legend() {
  double x = kPictureEdge;
  y_ += 6;
  const auto entry = [&](double wide, std::string_view text, const auto& draw) {
    const double width = wide + 8 + text_width(text, kTextFont);
    if (x > kPictureEdge && x + width > kPictureWidth - kPictureEdge) {
      x = kPictureEdge;
      y_ += 22;
    }
    draw(Point(x, y_ - 4));
    svg_.text({x + wide + 8, y_}, text, kTextFont, "legend");
    x += width + 22;
  };
  entry(26, "a kept point: its anchor on A, on B", [&](const Point& at) {
    svg_.line({at + Point(4, 0), at + Point(20, 0)}, "joined");
    svg_.circle(at + Point(4, 0), 3.6, "anchor a");
    svg_.circle(at + Point(20, 0), 6, "anchor b");
  });
  const auto pointing = [&](const Point& at, const std::string& line, const std::string& head) {
    svg_.line({at, at + Point(22, 0)}, line);
    svg_.polygon({at + Point(30, 0), at + Point(19, 5), at + Point(19, -5)}, head);
  };
  entry(30, "its normal, from A to B", [&](const Point& at) { pointing(at, "kept", "kept-head"); });
  entry(30, "the same, wrong",
        [&](const Point& at) { pointing(at, "kept wrong", "kept-head wrong"); });
  entry(30, "the true normal, along which they overlap least",
        [&](const Point& at) { pointing(at, "truth", "truth-head"); });
  entry(18, "overlap", [&](const Point& at) {
    svg_.box({at.x(), at.y() - 7, 18, 13}, "overlap", 2);
  });
  y_ += 22;
}

}  // namespace

std::string filmstrip_svg(const JudgedSequence& judged) {
  return Filmstrip(judged).draw();
}

}  // namespace manifuzz
