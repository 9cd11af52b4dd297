#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/plan.hpp"
#include "exact/placed.hpp"
#include "generating/drafts.hpp"
#include "report/picture/region.hpp"

struct _cairo;          // NOLINT(bugprone-reserved-identifier)
struct _cairo_surface;  // NOLINT(bugprone-reserved-identifier)
struct _RsvgHandle;     // NOLINT(bugprone-reserved-identifier)

namespace manifuzz {

struct Font {
  double size = 12;  ///< in pixels
  bool bold = false;
};

/// At most this wide, in pixels.
double text_width(std::string_view text, const Font& font);

/// The text in lines of at most this width, broken at blanks; a word that is longer is cut.
std::vector<std::string> wrapped(std::string_view text, const Font& font, double width);

/// A plain SVG 1.1 document in the making, in pixels, y down, on a sheet of the class `paper`.
/// `css` names classes of the style sheet.
class Svg {
 public:
  /// `title` is for readers who cannot see it.
  Svg(std::string_view title, std::string_view style);

  void polygon(const Region& region, std::string_view css);
  /// Its arcs are arcs.
  void rim(const Rim& rim, std::string_view css);
  /// Lines that go on from each other are one, so that dashes go on too.
  void path(const std::vector<Segment>& segments, std::string_view css);
  void line(const Segment& segment, std::string_view css);
  void circle(const Point& center, double radius, std::string_view css);
  void box(const Box& box, std::string_view css, double corner_radius = 0);
  /// `at`: the left end of the base line.
  void text(const Point& at, std::string_view text, const Font& font, std::string_view css);

  /// The document, at this size.
  std::string finish(double width, double height);

 private:
  using Numbers = std::initializer_list<std::pair<const char*, double>>;
  pugi::xml_node add(const char* element, std::string_view css, Numbers numbers);
  void add_path(const std::string& steps, std::string_view css);

  pugi::xml_document document_;
  pugi::xml_node root_;
  pugi::xml_node paper_;
};

/// What all pictures of a case have in common: width, free sides, fonts.
inline constexpr double kPictureWidth = 960;
inline constexpr double kPictureEdge = 24;
inline constexpr Font kTitleFont{17, true};
inline constexpr Font kTextFont{12.5};

/// The text from `at` to `right`, in as many lines as it takes; where the next line would begin.
double write_down(Svg& svg, std::string_view text, const Point& at, double right, const Font& font,
                  std::string_view css);

/// 0xRRGGBB.
using Colour = std::uint32_t;

/// A picture in pixels, y down, white at first. Texts are as wide as `text_width` says, at most.
class Canvas {
 public:
  Canvas(int width, int height);

  /// All pixels of the box, whose figures are whole.
  void fill(const Box& box, Colour colour);
  /// A line of one pixel around the box, whose figures are whole.
  void frame(const Box& box, Colour colour);
  void ring(const Point& center, double radius, double line_width, Colour colour);
  /// `at`: the left end of the base line. What is not printable ASCII is drawn escaped.
  void text(const Point& at, std::string_view text, const Font& font, Colour colour);

  /// An SVG document over all of it.
  void draw(_RsvgHandle* document);

  /// The topmost rows as a PNG file.
  std::string png(int height) const;

 private:
  _cairo* coloured(Colour colour);
  void stroke(double line_width);

  std::shared_ptr<_cairo_surface> surface_;
  std::shared_ptr<_cairo> context_;
};

/// An SVG document as a PNG file, twice as large for sharp texts. Throws std::runtime_error.
std::string png_of(const std::string& svg);

/// A picture of characters, each of them two by four dots as Braille has them; marks stand over the
/// dots. Coordinates are dots, y down; what lies outside is not drawn.
class DotCanvas {
 public:
  DotCanvas(int columns, int rows);

  int width() const { return 2 * columns_; }
  int height() const { return 4 * rows_; }

  void dot(int x, int y);
  /// Both ends are inside. `every`: 1 for a solid line, 2 for each second dot of it.
  void line(const Point& from, const Point& to, int every);
  /// One character over the dot's cell.
  void mark(const Point& at, char mark);
  /// The mark over the dot's cell, or 0; nothing stands outside.
  char mark_at(const Point& at);

  /// The rows as lines of UTF-8. Empty cells are empty Braille, which is as wide as the others
  /// wherever they are not as wide as a blank; none at the end of a line, and no empty rows at the
  /// top and the bottom.
  std::string text() const;

 private:
  struct Cell {
    unsigned dots = 0;
    char mark = 0;
  };
  /// The cell of a dot, or nullptr.
  Cell* cell(int x, int y);

  int columns_;
  int rows_;
  std::vector<Cell> cells_;
};

inline constexpr std::array<Side, 2> kSides{Side::a, Side::b};

/// Classes of the style sheet: the kind of thing, and whose it is.
inline std::string css_of(std::string_view kind, Side side) {
  return std::string(kind) + (side == Side::a ? " a" : " b");
}

/// A face of a shape where it stands, or where round shapes are nearest at a vertex, that.
struct PlacedFace {
  Side side = Side::a;
  Feature feature{Feature::Kind::face, 0};
  Segment segment;  ///< of a vertex from it to itself
};

/// A depth as a stretch along the normal: from the incident shape's skin to the reference face's.
struct DepthBar {
  Point from{0, 0};
  Point to{0, 0};
  double depth = 0;  ///< world length; negative: a gap
};

/// A contact point that a collider reported.
struct DrawnPoint {
  bool by_subject = true;
  Point position{0, 0};  ///< finite; all else need not be
  Point normal{0, 0};    ///< of its manifold, from A to B, as long as it was reported
  DepthBar bar;
};

/// What a picture of a case shows: world directions and lengths, seen from A's position.
struct Scene {
  exact::RoughPair polygons;
  bool is_round = false;  ///< contact points are on surfaces, and side planes where cores end
  std::array<double, 2> radii{};
  std::array<Rim, 2> rims;  ///< the shapes with their radii, as they are judged
  /// The reference face of the candidate to show; where the polygons are apart, the face of the
  /// greatest separation alone.
  PlacedFace reference;
  std::optional<PlacedFace> incident;
  Point outward{0, 0};             ///< the reference face's normal, unit
  DepthBar deepest;                ///< the truth at the deepest point
  double depth = 0;                ///< of the overlap, or the gap; a world length
  double rounding = 0;             ///< how far the subject's figures may be off, by its bounds
  std::vector<Point> right;        ///< the candidate's contact points
  std::vector<DrawnPoint> points;  ///< the subject's first

  double radius(Side side) const { return radii[static_cast<std::size_t>(side)]; }
  Point a_to_b() const { return reference.side == Side::a ? outward : Point(-outward); }
  const Rim& rim(Side side) const { return rims[static_cast<std::size_t>(side)]; }
  /// A shape with its radius, which inside the box comes within `tolerance` of the arcs.
  Region shape(Side side, const Box& where, double tolerance) const {
    return region_of(rim(side), where, tolerance);
  }
  /// Around both shapes and the points that are not farther off than `reach` times their size.
  Box whole(double reach) const;
};

/// `answers`: the subject's, then the oracle's if there is one.
Scene make_scene(const PairCase& pair, std::span<const DeclaredAnswer> answers);

/// A frame on the canvas (pixels, y down) and what of the scene it shows (y up), at one scale.
struct View {
  Box frame;
  Point center{0, 0};  ///< in the scene, in the middle of the frame
  double scale = 1;    ///< pixels a length

  Point place(const Point& p) const {
    const Point moved = (p - center) * scale;
    return frame.center() + Point(moved.x(), -moved.y());
  }
  Segment place(const Segment& s) const { return {place(s.first), place(s.second)}; }
  Region place(const Region& region) const;
  Rim place(const Rim& rim) const;
  /// The part of the scene inside the frame.
  Box shown() const {
    return {center.x() - frame.width / 2 / scale, center.y() - frame.height / 2 / scale,
            frame.width / scale, frame.height / scale};
  }
  /// Where the scale stands; no label does.
  Box footer() const { return {frame.x + 8, frame.bottom() - 24, 290, 20}; }
  /// A direction of the scene, on the canvas.
  static Point direction(const Point& d) { return {d.x(), -d.y()}; }
};

/// The views of a picture: the whole scene first, then up to two closer ones. The first of these
/// shows the largest thing of interest that is too small to be seen so far, the second the depth or
/// else the smallest. They fill a box of this width from (x, y) down; how high it is they decide.
std::vector<View> choose_views(const Scene& scene, double x, double y, double width);

/// A shape with its radius, filled or as a line: with true arcs where the view shows all of it,
/// else what it shows of `seen`, the shape with short edges for arcs.
void fill_rim(Svg& svg, const View& view, const Rim& rim, const Region& seen, std::string_view css);
void draw_rim(Svg& svg, const View& view, const Rim& rim, const Region& seen, std::string_view css);

/// Everything of the scene that the view shows. `names` are the subject's and the oracle's.
void draw_view(Svg& svg, const Scene& scene, const View& view,
               const std::array<std::string, 2>& names);

/// A contact point's mark: the subject's a disc, the oracle's a square around it.
void draw_mark(Svg& svg, const Point& at, bool by_subject);

}  // namespace manifuzz
