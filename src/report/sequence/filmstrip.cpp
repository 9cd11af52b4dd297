#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"
#include "report/sequence/strip_frames.hpp"
#include "report/texts.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kGutter = 14;     // between frames, in pixels
constexpr double kStripLine = 18;  // of text below a frame
constexpr double kHeadRoom = 26;   // of a frame's heading, above its picture
constexpr std::size_t kColumnsMax = 3;
constexpr Font kHeadFont{13, true};
constexpr Font kNoteFont{11.5};

class Filmstrip {
 public:
  explicit Filmstrip(const JudgedSequence& judged)
      : judged_(judged),
        svg_(verdict_sentence(judged), std::string(kPictureStyle) + std::string(kFilmstripStyle)) {
    for (const std::size_t number : frames_that_matter(judged)) {
      frames_.push_back(strip_frame(judged, number));
    }
    // Four stand better as two and two.
    const std::size_t columns = frames_.size() == 4 ? 2 : std::min(frames_.size(), kColumnsMax);
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
    const double most = 5 * size(judged_.given.sequence().at(0));
    is_cut_ = wanted > most || high > most;
    const double fit =
        0.86 * std::min(width_ / std::min(wanted, most), height_ / std::min(high, most));
    scale_ = fit > 0 && std::isfinite(fit) ? fit : 1;
  }

  void write_title();
  void draw_row(std::size_t first);
  void draw_frame(const StripFrame& frame, const Box& box);
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
  if (frames_.size() < judged_.given.sequence().frames.size()) {
    text += fmt::format(
        " Shown are {} of {} frames: the first, births, what is wrong and its "
        "neighbours.",
        frames_.size(), judged_.given.sequence().frames.size());
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
  draw_strip_frame(svg_, frame, view);
  if (frame.is_wrong()) svg_.box(box, frame.decides ? "wrong-frame decides" : "wrong-frame", 4);
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
  entry(30, "one that is wrong",
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
