#include <algorithm>

#include <fmt/format.h>

#include "report/measurements/measurements.hpp"
#include "report/picture/drawing.hpp"

namespace manifuzz {
namespace {

constexpr std::string_view kFrameStyle =
    ".body { fill: #cfe0f0; stroke: #1f4e79; stroke-width: 1 }\n"
    ".paper { fill: #ffffff }\n"
    ".contact { fill: #c0392b }\n"
    ".normal { stroke: #c0392b; stroke-width: 1.5 }\n";

/// All of these, at a scale at which the longer side is so many pixels.
View view_around(const std::vector<Point>& corners) {
  constexpr double longer_side = 1200;
  constexpr double margin = 20;
  const Box shown = box_around(corners);
  const double scale = longer_side / std::max(shown.width, shown.height);
  return {{0, 0, shown.width * scale + 2 * margin, shown.height * scale + 2 * margin},
          shown.center(),
          scale};
}

/// The corners of a body in the world.
Region region_of(const Body& body) {
  const Pose<double> pose{body.pose.position.cast<double>(), body.pose.rotation.cast<double>()};
  Region region;
  for (const auto& corner : body.polygon.corners()) {
    region.push_back(transform(pose, Point(corner.cast<double>())));
  }
  return region;
}

void draw_contact(Svg& svg, const View& view, const Pose<float>& a,
                  const Manifold<float>& manifold) {
  constexpr double normal_length = 9;
  const Point normal = rotate(a.rotation, manifold.normal).cast<double>();
  for (int i = 0; i < manifold.count; ++i) {
    const Point at = view.place(Point(transform(a, manifold.points[i].position).cast<double>()));
    svg.line({at, at + normal_length * View::direction(normal)}, "normal");
    svg.circle(at, 2.5, "contact");
  }
}

}  // namespace

std::string scene_frame(const ScenePlan& plan) {
  const SceneSpec& spec = *plan.scenes.front();
  const std::size_t bodies = plan.sizes.front();
  const Frame frame = last_frame(spec.make(bodies, plan.steps), plan.settings);
  std::vector<Region> regions;
  std::vector<Point> corners;
  for (const Body& body : frame.bodies) {
    const Region& region = regions.emplace_back(region_of(body));
    corners.insert(corners.end(), region.begin(), region.end());
  }
  const View view = view_around(corners);
  Svg svg(fmt::format("{} of {} bodies", spec.name, bodies), kFrameStyle);
  for (const Region& region : regions) svg.polygon(view.place(region), "body");
  for (const scene::Contact& contact : frame.contacts) {
    draw_contact(svg, view, frame.bodies[contact.a.index].pose, contact.manifold);
  }
  return svg.finish(view.frame.width, view.frame.height);
}

}  // namespace manifuzz
