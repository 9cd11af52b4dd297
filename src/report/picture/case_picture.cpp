#include "report/picture/case_picture.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "report/picture/drawing.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

constexpr double kWidth = 960;
constexpr double kEdge = 24;  // free at the picture's sides
constexpr double kInner = kWidth - 2 * kEdge;
constexpr Font kTitleFont{17, true};
constexpr Font kTextFont{12.5};
constexpr double kLine = 21;

/// Blue and orange, told apart by every eye (Okabe and Ito); what colliders say is dark or green.
constexpr std::string_view kStyle = R"(
.paper{fill:#ffffff;stroke:#c9ced6}
.frame{fill:#fafbfc;stroke:#c9ced6}
.title{fill:#14181f}
.subtitle,.quiet{fill:#5a6472}
.legend{fill:#14181f}
.fill.a{fill:#0072b2;fill-opacity:.16}
.fill.b{fill:#e69f00;fill-opacity:.2}
.overlap{fill:#cc3366;fill-opacity:.38}
.edge{stroke-width:1.5;stroke-linecap:round}
.edge.a,.skin.a{stroke:#0072b2}
.edge.b,.skin.b{stroke:#b87900}
.skin{stroke-width:1.2;stroke-dasharray:4 3}
.plane{stroke:#6b7280;stroke-width:1;stroke-dasharray:7 4}
.reference{stroke:#14181f;stroke-width:4;stroke-linecap:round}
.incident{stroke:#9b30a8;stroke-width:4;stroke-linecap:round}
.normal{stroke:#14181f;stroke-width:1.8}
.arrow{fill:#14181f}
.extension{stroke:#14181f;stroke-width:1;stroke-dasharray:1.5 3}
.bar{stroke-width:2}
.bar.subject,.bar.truth{stroke:#c0143c}
.bar.oracle{stroke:#00795c}
.mark-subject{fill:#c0143c;stroke:#ffffff;stroke-width:1.2}
.mark-oracle{fill:none;stroke:#00795c;stroke-width:2.2}
.leader{stroke:#8a93a0;stroke-width:.9}
.label{fill:#fafbfc;fill-opacity:.85}
.caption{fill:#eceff3}
.zoomed{fill:none;stroke:#5a6472;stroke-width:1.1}
.zoom-line{stroke:#5a6472;stroke-width:.8;stroke-dasharray:2 3}
.scale{stroke:#14181f;stroke-width:1.4}
.reference-word,.normal-word{fill:#14181f}
.incident-word{fill:#7b1f88}
.depth-word{font-weight:bold;fill:#14181f}
.depth-word.subject{fill:#a01030}
.depth-word.oracle{fill:#006048}
.letter.a,.vertex.a{fill:#005a8e}
.letter.b,.vertex.b{fill:#8a5a00}
)";

/// A place in the world, without a blank to break the line at.
std::string place(const Point& at) {
  return fmt::format("({:.6g},{:.6g})", at.x(), at.y());
}

class Picture {
 public:
  explicit Picture(const JudgedCase& judged)
      : judged_(judged),
        scene_(make_scene(judged)),
        names_{judged.subject.declaration.name, judged.oracle.declaration.name} {}

  std::string draw() {
    write_title();
    draw_views();
    write_legend();
    Svg paper;
    const double height = y_;
    paper.box({0.5, 0.5, kWidth - 1, height - 1}, "paper", 8);
    paper.append(svg_);
    return paper.finish(kWidth, height, verdict_sentence(judged_), kStyle);
  }

 private:
  /// Text from `x` to the right edge, in as many lines as it takes; moves down.
  void write(std::string_view text, double x, const Font& font, std::string_view css) {
    for (const std::string& line : wrapped(text, font, kWidth - kEdge - x)) {
      svg_.text({x, y_}, line, font, css);
      y_ += font.size * 1.68;
    }
  }

  void write_title() {
    y_ = 38;
    write(verdict_sentence(judged_), kEdge, kTitleFont, "title");
    y_ -= 5;
    write(truth_line(), kEdge, kTextFont, "subtitle");
    y_ -= 6;
  }

  std::string truth_line() const {
    const PairCase& pair = judged_.given.pair;
    const exact::Truth truth(pair);
    std::string line = "Greatest separation";
    for (const Side side : kSides) {
      const exact::FaceOf face = truth.greatest(side);
      line += fmt::format("{} {} ({})", side == Side::a ? "" : ",",
                          brief(leading(truth.fine_separation(face))), face_name(side, face.index));
    }
    return fmt::format("{}; total radius {}; {}.", line, brief(total_radius(pair)),
                       truth_in_words(pair));
  }

  void draw_views();
  void write_shapes();
  void write_legend();
  void write_answer(const DeclaredAnswer& asked, bool is_subject);

  const JudgedCase& judged_;
  Scene scene_;
  MarkNames names_;
  Svg svg_;
  double y_ = 0;
};

void Picture::draw_views() {
  const std::vector<View> views = choose_views(scene_, kEdge, y_, kInner);
  for (std::size_t i = 0; i < views.size(); ++i) draw_view(svg_, scene_, views, i, names_);
  for (const View& view : views) y_ = std::max(y_, view.frame.bottom());
  y_ += kLine + 4;
}

void Picture::write_answer(const DeclaredAnswer& asked, bool is_subject) {
  draw_mark(svg_, {kEdge + 9, y_ - 4}, is_subject);
  std::string text =
      fmt::format("{} {} ({}): {}", asked.declaration.name, asked.declaration.version,
                  is_subject ? "subject" : "oracle", answer_in_words(asked));
  if (asked.count() > 0) {
    const Manifold<double>& manifold = *asked.manifold();
    const Point normal = world_normal(judged_.given.pair, manifold.normal);
    text +=
        fmt::format("; reference {}, normal ({}, {})", manifold.reference == Side::a ? 'A' : 'B',
                    brief(normal.x()), brief(normal.y()));
    for (int i = 0; i < asked.count(); ++i) {
      const Point at = to_world(judged_.given.pair, manifold.points[i].position);
      text += (i == 0 ? "; at " : " and ") + place(at);
    }
  }
  write(text, kEdge + 26, kTextFont, "legend");
}

void Picture::write_shapes() {
  double x = kEdge;
  const auto make_room = [&](std::string_view text) {
    const double width = 26 + text_width(text, kTextFont);
    if (x > kEdge && x + width > kWidth - kEdge) {
      x = kEdge;
      y_ += kLine;
    }
    const Point at(x, y_);
    x += width + 20;
    return at;
  };
  const auto swatch = [&](std::string_view css, std::string_view text) {
    const Point at = make_room(text);
    svg_.box({at.x(), at.y() - 11, 18, 13}, css, 2);
    svg_.text(at + Point(26, 0), text, kTextFont, "legend");
  };
  for (const Side side : kSides) {
    const Body& body = judged_.given.pair[side];
    std::string text = fmt::format("{}: {} vertices, at {}", side == Side::a ? 'A' : 'B',
                                   body.polygon.count, place(body.pose.position.cast<double>()));
    if (body.polygon.radius > 0) text += ", radius " + brief(body.polygon.radius);
    swatch(css("fill", side), text);
  }
  if (scene_.incident) {
    swatch("overlap", "overlap");
    constexpr std::string_view planes = "side planes";
    const Point at = make_room(planes);
    svg_.line({at + Point(0, -4), at + Point(20, -4)}, "plane");
    svg_.text(at + Point(26, 0), planes, kTextFont, "legend");
  }
  y_ += kLine;
}

void Picture::write_legend() {
  write_shapes();
  write_answer(judged_.subject, true);
  write_answer(judged_.oracle, false);
  if (const LedgerEntry* const entry = judged_.judgement.explanation) {
    write(fmt::format("Known as {}: {}. {}", entry->id, entry->description, entry->source), kEdge,
          kTextFont, "subtitle");
  }
}

}  // namespace

std::string case_svg(const JudgedCase& judged) {
  return Picture(judged).draw();
}

}  // namespace manifuzz
