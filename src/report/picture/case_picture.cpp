#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "report/picture/drawing.hpp"
#include "report/picture/pictures.hpp"
#include "report/texts.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kWidth = kPictureWidth;
constexpr double kEdge = kPictureEdge;
constexpr double kInner = kWidth - 2 * kEdge;
constexpr Font kScaleFont{10.5};
constexpr double kLine = 21;

/// A place in the world, without a blank to break the line at.
std::string place(const Point& at) {
  return fmt::format("({:.6g},{:.6g})", at.x(), at.y());
}

/// Where a closer view lies in its host, and lines to it.
void mark_view(Svg& svg, const View& host, const View& closer) {
  const double shrunk = host.scale / closer.scale;
  const Point center = host.place(closer.center);
  const double width = std::max(9.0, closer.frame.width * shrunk);
  const double height = std::max(9.0, closer.frame.height * shrunk);
  const Box box{center.x() - width / 2, center.y() - height / 2, width, height};
  const Box& frame = closer.frame;
  const bool is_beside = frame.x > host.frame.right();
  const Point second = is_beside ? Point(frame.x, frame.bottom()) : Point(frame.right(), frame.y);
  for (const Point& corner : {Point(frame.x, frame.y), second}) {
    svg.line({nearest(box, corner), corner}, "zoom-line");
  }
  svg.box(box, "zoomed", 2);
}

/// A view's footer: how long a round length is drawn, and how much closer than the whole that is.
void draw_scale(Svg& svg, const View& view, double times_closer) {
  // The longest of 1, 2 and 5 times a power of ten that is not too wide.
  constexpr double widest = 120;
  const double power = std::pow(10, std::floor(std::log10(widest / view.scale)));
  const auto fits = [&](double factor) { return power * factor * view.scale <= widest; };
  const double unit = power * (fits(5) ? 5 : fits(2) ? 2 : 1);
  std::string text = brief(unit);
  if (times_closer > 1) {  // "660x closer", to two digits
    const double digits = std::pow(10, std::max(0.0, std::floor(std::log10(times_closer)) - 1));
    text += fmt::format(", {:g}x closer", std::round(times_closer / digits) * digits);
  }
  const Point left = Point(view.footer().x, view.footer().center().y()) + Point(6, 0);
  const Point right = left + Point(unit * view.scale, 0);
  svg.line({left, right}, "scale");
  for (const Point& end : {left, right}) svg.line({end - Point(0, 4), end + Point(0, 4)}, "scale");
  const Point at = right + Point(8, 4);
  svg.box({at.x() - 3, at.y() - 11, text_width(text, kScaleFont) + 6, 15}, "label", 3);
  svg.text(at, text, kScaleFont, "quiet");
}

class Picture {
 public:
  explicit Picture(const JudgedCase& judged)
      : judged_(judged),
        scene_(make_scene(judged.given.pair(), std::array{judged.subject, judged.oracle})),
        svg_(verdict_sentence(judged), kPictureStyle) {
    std::erase_if(scene_.points, [](const DrawnPoint& p) { return !p.bar.to.allFinite(); });
  }

  std::string draw() {
    write_title();
    draw_views();
    write_swatches();
    write_answer(judged_.subject, true);
    write_answer(judged_.oracle, false);
    if (const LedgerEntry* const entry = judged_.judgement.explanation) {
      write(fmt::format("Known as {}: {}. {}", entry->id, entry->description, entry->source), kEdge,
            kTextFont, "subtitle");
    }
    return svg_.finish(kWidth, y_);
  }

 private:
  void write(std::string_view text, double x, const Font& font, std::string_view css) {
    y_ = write_down(svg_, text, {x, y_}, kWidth - kEdge, font, css);
  }

  void write_title() {
    y_ = 38;
    write(verdict_sentence(judged_), kEdge, kTitleFont, "title");
    y_ -= 5;
    write(truth_line(), kEdge, kTextFont, "subtitle");
    y_ -= 6;
  }

  std::string truth_line() const {
    const PairCase& pair = judged_.given.pair();
    const exact::Truth truth(pair);
    if (scene_.is_round) {
      const double apart = exact::separation_of(truth);
      return fmt::format("Cores {} at {}; total radius {}; {}.",
                         apart >= 0 ? brief(apart) + " apart" : "overlap by " + brief(-apart),
                         place_name(scene_.reference.side, scene_.reference.feature),
                         brief(total_radius(pair)), truth_in_words(pair));
    }
    const auto greatest = [&](Side side) {
      const exact::FaceOf face = truth.greatest(side);
      return fmt::format("{} ({})", brief(leading(truth.fine_separation(face))),
                         face_name(side, face.index));
    };
    return fmt::format("Greatest separation {}, {}; total radius {}; {}.", greatest(Side::a),
                       greatest(Side::b), brief(total_radius(pair)), truth_in_words(pair));
  }

  void draw_views() {
    const std::vector<View> views = choose_views(scene_, kEdge, y_, kInner);
    for (const View& view : views) {
      draw_view(svg_, scene_, view,
                {judged_.subject.declaration.name, judged_.oracle.declaration.name});
      draw_scale(svg_, view, view.scale / views.front().scale);
      y_ = std::max(y_, view.frame.bottom());
    }
    for (std::size_t i = 1; i < views.size(); ++i) {
      // Marked in the closest view that shows its center.
      std::size_t host = i - 1;
      while (host > 0 && !views[host].frame.contains(views[host].place(views[i].center))) --host;
      mark_view(svg_, views[host], views[i]);
    }
    y_ += kLine + 4;
  }

  void write_swatches();
  void write_answer(const DeclaredAnswer& asked, bool is_subject);

  const JudgedCase& judged_;
  Scene scene_;
  Svg svg_;
  double y_ = 0;
};

/// What areas and lines mean, as many to a line as fit.
void Picture::write_swatches() {
  double x = kEdge;
  const auto make_room = [&](std::string_view text) {
    const double width = 26 + text_width(text, kTextFont);
    if (x > kEdge && x + width > kWidth - kEdge) {
      x = kEdge;
      y_ += kLine;
    }
    const Point at(x, y_);
    x += width + 20;
    svg_.text(at + Point(26, 0), text, kTextFont, "legend");
    return at;
  };
  const auto area = [&](std::string_view css, std::string_view text) {
    const Point at = make_room(text);
    svg_.box({at.x(), at.y() - 11, 18, 13}, css, 2);
  };
  const auto line = [&](std::string_view css, std::string_view text) {
    const Point at = make_room(text) + Point(0, -4);
    svg_.line({at, at + Point(20, 0)}, css);
  };
  for (const Side side : kSides) {
    const Body& body = judged_.given.pair()[side];
    area(side == Side::a ? "fill a" : "fill b",
         fmt::format("{}: {}, at {}", side == Side::a ? 'A' : 'B', shape_in_words(body.polygon),
                     place(body.pose.position.cast<double>())));
  }
  const auto face = [&](std::string_view role, const PlacedFace& placed) {
    line(role, fmt::format("{} ({})", role, place_name(placed.side, placed.feature)));
  };
  if (scene_.incident || (scene_.is_round && scene_.deepest.depth >= 0)) area("overlap", "overlap");
  face("reference", scene_.reference);
  if (scene_.incident) {
    face("incident", *scene_.incident);
    line("plane", "side planes");
  }
  line("normal", "normal, A to B");
  y_ += kLine;
}

void Picture::write_answer(const DeclaredAnswer& asked, bool is_subject) {
  draw_mark(svg_, {kEdge + 9, y_ - 4}, is_subject);
  std::string text =
      fmt::format("{} {} ({}): {}", asked.declaration.name, asked.declaration.version,
                  is_subject ? "subject" : "oracle", answer_in_words(asked));
  if (asked.count() > 0) {
    const Manifold<double>& manifold = *asked.manifold();
    const Point normal = world_normal(judged_.given.pair(), manifold.normal);
    text +=
        fmt::format("; reference {}, normal ({}, {})", manifold.reference == Side::a ? 'A' : 'B',
                    brief(normal.x()), brief(normal.y()));
    for (int i = 0; i < asked.count(); ++i) {
      const Point at = to_world(judged_.given.pair(), manifold.points[i].position);
      text += (i == 0 ? "; at " : " and ") + place(at);
    }
  }
  write(text, kEdge + 26, kTextFont, "legend");
}

}  // namespace

std::string case_svg(const JudgedCase& judged) {
  return Picture(judged).draw();
}

}  // namespace manifuzz
