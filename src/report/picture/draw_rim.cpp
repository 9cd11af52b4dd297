#include "report/picture/drawing.hpp"

namespace manifuzz {

void fill_rim(Svg& svg, const View& view, const Rim& rim, const Region& seen,
              std::string_view css) {
  const Rim placed = view.place(rim);
  const bool has_arcs = rim.front().radius > 0;
  if (has_arcs && view.frame.contains(box_around_rim(placed))) return svg.rim(placed, css);
  svg.polygon(intersection(view.place(seen), view.frame), css);
}

void draw_rim(Svg& svg, const View& view, const Rim& rim, const Region& seen,
              std::string_view css) {
  const Rim placed = view.place(rim);
  if (view.frame.contains(box_around_rim(placed))) return svg.rim(placed, css);
  const Region corners = view.place(seen);
  std::vector<Segment> parts;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto part = inside({corners[i], corners[(i + 1) % corners.size()]}, view.frame);
    if (part) parts.push_back(*part);
  }
  svg.path(parts, css);
}

}  // namespace manifuzz
