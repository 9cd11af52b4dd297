#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "oracle/exact/placed.hpp"
#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr std::size_t kFramesARow = 3;
constexpr std::size_t kFramesMax = 9;  // of a long sequence those that matter
constexpr double kBetweenFrames = 16;
constexpr double kFrameWidth =
    (kPictureWidth - 2 * kPictureEdge - (kFramesARow - 1) * kBetweenFrames) / kFramesARow;
constexpr double kFrameHeight = 230;
constexpr double kAroundBodies = 26;  // around the bodies, in a panel
constexpr double kNormalLength = 46;  // how long a normal is drawn
constexpr Font kFrameNumberFont{13, true};
constexpr Font kFrameWordsFont{11.5};

constexpr std::string_view kFilmstripStyle = R"(
.wrong{fill:none;stroke:#c0143c;stroke-width:3}
.kept,.arrow.kept{stroke:#14181f;stroke-width:1.8;fill:#14181f}
.stale,.arrow.stale{stroke:#c0143c;stroke-width:1.8;fill:#c0143c}
.true,.arrow.true{stroke:#00795c;stroke-width:1.8;fill:#00795c}
.gap{stroke:#14181f;stroke-width:1.2;stroke-dasharray:2 2}
.anchor.a{fill:#0072b2;stroke:#ffffff;stroke-width:1}
.anchor.b{fill:#e69f00;stroke:#ffffff;stroke-width:1}
.born{fill:none;stroke:#14181f;stroke-width:1.4}
.wrong-words{fill:#a01030}
)";

/// A pair as it stands in a frame, seen from A's position.
struct StandingPair {
  std::array<Rim, 2> rims;
  Box around;

  explicit StandingPair(const PairCase& pair) {
    const exact::RoughPair placed = exact::place_roughly(exact::stored(pair));
    std::vector<Point> ends;
    for (const Side side : kSides) {
      const ConvexPolygon<float>& shape = pair[side].polygon;
      const Rounding corners = is_round(pair) ? Rounding::round : Rounding::mitre;
      Rim& rim = rims[static_cast<std::size_t>(side)];
      rim = rim_of(placed[side], static_cast<double>(shape.radius), corners);
      const Box box = box_around_rim(rim);
      ends.insert(ends.end(), {Point(box.x, box.y), Point(box.right(), box.bottom())});
    }
    around = box_around(ends);
  }
};

/// The frames that are drawn: all of a short sequence; of a longer one the first, the deciding one
/// and its neighbours, those in which a point is born, and the last.
std::vector<std::size_t> chosen_frames(const JudgedSequence& judged) {
  const std::size_t count = judged.answers.size();
  std::set<std::size_t> chosen;
  const auto choose = [&](std::size_t frame) {
    if (frame < count && chosen.size() < kFramesMax) chosen.insert(frame);
  };
  const std::size_t deciding = judged.judgement.frame;
  choose(deciding);
  choose(0);
  if (deciding > 0) choose(deciding - 1);
  choose(deciding + 1);
  for (std::size_t frame = 0; frame < count; ++frame) {
    for (const KeptPoint& point : points_in(judged, frame)) {
      if (point.born == static_cast<int>(frame) && point.id > 0) choose(frame);
    }
  }
  for (std::size_t frame = 0; frame < count; ++frame) choose(frame);
  return {chosen.begin(), chosen.end()};
}

class Filmstrip {
 public:
  explicit Filmstrip(const JudgedSequence& judged)
      : judged_(judged), frames_(chosen_frames(judged)), svg_(verdict_sentence(judged), style()) {
    double width = 0;
    double height = 0;
    for (const std::size_t frame : frames_) {
      standing_.emplace_back(pair_at(frame));
      width = std::max(width, standing_.back().around.width);
      height = std::max(height, standing_.back().around.height);
    }
    const double across = (kFrameWidth - 2 * kAroundBodies) / width;
    const double up = (kFrameHeight - 2 * kAroundBodies) / height;
    scale_ = std::min(across, up);
  }

  std::string draw() {
    double y = write_down(svg_, verdict_sentence(judged_), {kPictureEdge, 38}, kRight, kTitleFont,
                          "title");
    for (std::size_t i = 0; i < frames_.size(); i += kFramesARow) {
      double bottom = y;
      for (std::size_t k = i; k < std::min(i + kFramesARow, frames_.size()); ++k) {
        const double x = kPictureEdge + static_cast<double>(k - i) * (kFrameWidth + kBetweenFrames);
        bottom = std::max(bottom, draw_frame(k, {x, y, kFrameWidth, kFrameHeight}));
      }
      y = bottom + kBetweenFrames;
    }
    y = write_down(svg_, legend(), {kPictureEdge, y + 10}, kRight, kTextFont, "legend");
    return svg_.finish(kPictureWidth, y);
  }

 private:
  static constexpr double kRight = kPictureWidth - kPictureEdge;

  static const std::string& style() {
    static const std::string both = std::string(kPictureStyle) + std::string(kFilmstripStyle);
    return both;
  }

  PairCase pair_at(std::size_t frame) const { return judged_.given.sequence().at(frame); }

  bool is_wrong(std::size_t frame) const {
    const auto& frames = judged_.judgement.frames;
    return frame >= frames.size() || frames[frame].kind != Kind::none;
  }

  /// Whether this point is the one that a frame is wrong by.
  bool is_to_blame(std::size_t frame, std::size_t point) const {
    const auto& frames = judged_.judgement.frames;
    return frame < frames.size() && frames[frame].kind != Kind::none &&
           frames[frame].point == point;
  }

  /// Draws one, and says below it what is in it; where that ends.
  double draw_frame(std::size_t k, const Box& panel) {
    const std::size_t frame = frames_[k];
    svg_.box(panel, "frame", 4);
    const View view{panel, standing_[k].around.center(), scale_};
    for (const Side side : kSides) {
      const Rim rim = view.place(standing_[k].rims[static_cast<std::size_t>(side)]);
      svg_.rim(rim, side == Side::a ? "fill a" : "fill b");
      svg_.rim(rim, side == Side::a ? "outline a" : "outline b");
    }
    const std::vector<KeptPoint> points = points_in(judged_, frame);
    for (std::size_t i = 0; i < points.size(); ++i) {
      draw_point(view, frame, points[i], is_to_blame(frame, i));
    }
    if (is_wrong(frame)) svg_.box(panel, "wrong", 4);
    return write_frame(frame, points, panel);
  }

  void draw_point(const View& view, std::size_t frame, const KeptPoint& point, bool is_to_blame) {
    const PairCase pair = pair_at(frame);
    const Vector2<double> apart =
        pair.b.pose.position.cast<double>() - pair.a.pose.position.cast<double>();
    const Vector2<double> turn_a = pair.a.pose.rotation.cast<double>();
    const Vector2<double> turn_b = pair.b.pose.rotation.cast<double>();
    const Point on_a = view.place(rotate<double>(turn_a, point.anchor_a));
    const Point on_b = view.place(Point(rotate<double>(turn_b, point.anchor_b) + apart));
    if (!on_a.allFinite() || !on_b.allFinite()) return;
    const Point middle = (on_a + on_b) / 2;
    svg_.line({on_a, on_b}, "gap");
    if (is_to_blame) {
      for (const Vector2<double>& normal :
           true_overlap(pair, judged_.subject.declaration).normals) {
        draw_arrow(middle, normal, "true");
      }
    }
    draw_arrow(middle, point.normal, is_to_blame ? "stale" : "kept");
    svg_.circle(on_a, 3.6, "anchor a");
    svg_.circle(on_b, 3.6, "anchor b");
    if (point.born == static_cast<int>(frame)) svg_.circle(middle, 8, "born");
  }

  void draw_arrow(const Point& from, const Vector2<double>& normal, std::string_view css) {
    if (!normal.allFinite() || normal.isZero(0)) return;
    const Point along = View::direction(normal / normal.norm());
    const Point tip = from + kNormalLength * along;
    const Point across(-along.y(), along.x());
    svg_.line({from, tip}, css);
    svg_.polygon({tip, tip - 9 * along + 4 * across, tip - 9 * along - 4 * across},
                 fmt::format("arrow {}", css));
  }

  double write_frame(std::size_t frame, const std::vector<KeptPoint>& points, const Box& panel) {
    svg_.text({panel.x + 8, panel.y + 19}, fmt::format("frame {}", frame), kFrameNumberFont,
              "legend");
    double y = panel.bottom() + 17;
    const auto write = [&](const std::string& words, std::string_view css) {
      const Font font{kFrameWordsFont.size, css == "wrong-words"};
      y = write_down(svg_, words, {panel.x, y}, panel.right(), font, css);
    };
    write(frame_in_words(judged_, frame), is_wrong(frame) ? "wrong-words" : "legend");
    const TrueOverlap truth = true_overlap(pair_at(frame), judged_.subject.declaration);
    write(truth.depth < 0 ? "truth: " + brief(-truth.depth) + " apart"
                          : "truth: overlap " + brief(truth.depth),
          "quiet");
    for (const KeptPoint& point : points) {
      const std::string since = point.born == static_cast<int>(frame)
                                    ? "new"
                                    : fmt::format("kept since frame {}", point.born);
      write(fmt::format("point {}, {}: depth {}", point.id, since, brief(point.depth)), "quiet");
    }
    return y;
  }

  std::string legend() const {
    const std::size_t left_out = judged_.answers.size() - frames_.size();
    return fmt::format(
        "A blue, B orange, each frame seen from between them at one scale{}. A kept point has an "
        "anchor on either body (dots), joined; its arrow is its normal, from A to B, and a ring "
        "says that it is new. A frame that is wrong is red, and so is the normal of the point it "
        "is wrong by; green is the normal along which the shapes truly overlap least.",
        left_out > 0 ? fmt::format(" ({} more frames are not drawn)", left_out) : "");
  }

  const JudgedSequence& judged_;
  std::vector<std::size_t> frames_;
  std::vector<StandingPair> standing_;
  double scale_ = 1;
  Svg svg_;
};

}  // namespace

std::string filmstrip_svg(const JudgedSequence& judged) {
  return Filmstrip(judged).draw();
}

}  // namespace manifuzz
