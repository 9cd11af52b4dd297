#include "report/picture/drawing.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

void fill(Drawing& drawing, const Region& region, std::string_view style) {
  drawing.svg.polygon(intersection(drawing.view.place(region), drawing.view.frame), style);
}

void draw_edges(Drawing& drawing, Side side) {
  const auto& polygon = drawing.scene.polygon(side);
  for (int i = 0; i < polygon.count; ++i) {
    const Segment edge{polygon.vertices[i], polygon.vertices[polygon.next(i)]};
    drawing.stroke(drawing.view.place(edge), css("edge", side));
  }
  if (drawing.scene.radius(side) <= 0) return;
  const Region skin = drawing.view.place(drawing.shape(side));
  for (std::size_t i = 0; i < skin.size(); ++i) {
    drawing.stroke({skin[i], skin[(i + 1) % skin.size()]}, css("skin", side));
  }
}

void highlight(Drawing& drawing, const PlacedFace& face, std::string_view role) {
  constexpr double shortest_named = 4;
  const auto seen = drawing.stroke(drawing.view.place(face.segment), role);
  if (!seen) return;
  if (!drawing.is_whole && length(seen->second - seen->first) < shortest_named) return;
  const Point outward = View::direction(drawing.scene.polygon(face.side).normals[face.index]);
  drawing.words.push_back({.text = fmt::format("{} ({})", role, face_name(face.side, face.index)),
                           .anchor = (seen->first + seen->second) / 2,
                           .towards = outward,
                           .css = fmt::format("{}-word", role)});
}

/// A side plane is a line; as much of it as the frame shows.
void draw_side_planes(Drawing& drawing) {
  const Box& frame = drawing.view.frame;
  const double far = 2 * (frame.width + frame.height);
  const Point along = View::direction(drawing.scene.outward) * far;
  for (const Point& corner : drawing.scene.slab) {
    const Point at = drawing.view.place(corner);
    if (length(at - frame.center()) < far / 2) drawing.stroke({at - along, at + along}, "plane");
  }
}

}  // namespace

void draw_shapes(Drawing& drawing) {
  for (const Side side : kSides) fill(drawing, drawing.shape(side), css("fill", side));
  fill(drawing, intersection(drawing.shapes[0], drawing.shapes[1]), "overlap");
  if (drawing.scene.incident) draw_side_planes(drawing);
  for (const Side side : kSides) draw_edges(drawing, side);
  highlight(drawing, drawing.scene.reference, "reference");
  if (drawing.scene.incident) highlight(drawing, *drawing.scene.incident, "incident");
}

}  // namespace manifuzz
