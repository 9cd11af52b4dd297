#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "report/picture/labels.hpp"
#include "report/picture/view.hpp"

namespace manifuzz {

/// Whose marks a picture holds.
struct MarkNames {
  std::string subject;
  std::string oracle;
};

inline constexpr Font kSmallFont{10.5};
inline constexpr std::array<Side, 2> kSides{Side::a, Side::b};

/// Classes of the style sheet: the kind of thing, and whose it is.
inline std::string css(std::string_view kind, Side side) {
  return fmt::format("{} {}", kind, side == Side::a ? "a" : "b");
}

/// One view of a scene while it is drawn: lines and areas at once, words when all else is known.
struct Drawing {
  Svg& svg;
  const Scene& scene;
  const View& view;
  bool is_whole = true;  ///< shows all of the scene
  const MarkNames& names;
  std::array<Region, 2> shapes;  ///< A's and B's with their skins, in the scene
  LabelLayer labels;
  std::vector<Label> words;  ///< to be placed, the most important first

  const Region& shape(Side side) const { return shapes[static_cast<std::size_t>(side)]; }
  bool sees(const Point& on_canvas) const { return view.frame.contains(on_canvas); }

  /// Draws the part of a canvas segment that is seen; labels avoid it.
  std::optional<Segment> stroke(const Segment& on_canvas, std::string_view style) {
    const auto seen = inside(on_canvas, view.frame);
    if (!seen) return std::nullopt;
    svg.line(*seen, style);
    labels.avoid(*seen);
    return seen;
  }
};

/// Polygons, their overlap, reference and incident with the side planes.
void draw_shapes(Drawing& drawing);

/// Depth bars, normals and contact points, with their labels.
void draw_contacts(Drawing& drawing);

/// The letters A and B, and the numbers of the vertices where there is room.
void draw_names(Drawing& drawing);

/// A contact point's mark: the subject's a disc, the oracle's a square around it.
void draw_mark(Svg& svg, const Point& at, bool by_subject);

/// Everything of the scene that view `index` shows; the first is the whole, and closer ones are
/// marked where they lie.
void draw_view(Svg& svg, const Scene& scene, const std::vector<View>& views, std::size_t index,
               const MarkNames& names);

}  // namespace manifuzz
