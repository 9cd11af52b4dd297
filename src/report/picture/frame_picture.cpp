#include "report/picture/frame_picture.hpp"

#include <algorithm>
#include <limits>

#include "report/picture/svg.hpp"

namespace manifuzz {
namespace {

constexpr double kLongerSide = 1200;
constexpr double kMargin = 20;

constexpr std::string_view kStyle =
    ".body { fill: #cfe0f0; stroke: #1f4e79; stroke-width: 1 }\n"
    ".ground { fill: #ffffff }\n"
    ".contact { fill: #c0392b }\n"
    ".normal { stroke: #c0392b; stroke-width: 1.5 }\n";

/// In pixels.
constexpr double kNormalLength = 9;

/// The corners of a body in the world.
Region region_of(const Body& body) {
  const Pose<double> pose{body.pose.position.cast<double>(), body.pose.rotation.cast<double>()};
  Region region;
  for (const auto& corner : body.polygon.corners()) {
    region.push_back(transform(pose, Vector2<double>(corner.cast<double>())));
  }
  return region;
}

/// From the world to pixels, y down.
struct Mapping {
  Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Point high = -low;

  void include(const Point& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  double scale() const { return kLongerSide / (high - low).maxCoeff(); }
  Point size() const { return (high - low) * scale() + Point(2 * kMargin, 2 * kMargin); }
  Point operator()(const Point& p) const {
    return {kMargin + (p.x() - low.x()) * scale(), kMargin + (high.y() - p.y()) * scale()};
  }
};

}  // namespace

std::string frame_svg(std::span<const Body> bodies, std::span<const FramePoint> points,
                      std::string_view title) {
  std::vector<Region> regions;
  Mapping mapping;
  for (const Body& body : bodies) {
    for (const Point& corner : regions.emplace_back(region_of(body))) mapping.include(corner);
  }
  const Point size = mapping.size();
  Svg svg;
  svg.polygon({{0, 0}, {size.x(), 0}, size, {0, size.y()}}, "ground");
  for (Region& region : regions) {
    std::ranges::transform(region, region.begin(), mapping);
    svg.polygon(region, "body");
  }
  for (const FramePoint& point : points) {
    const Point at = mapping(point.position);
    const Point along(point.normal.x(), -point.normal.y());
    svg.line({at, at + kNormalLength * along}, "normal");
    svg.circle(at, 2.5, "contact");
  }
  return svg.finish(size.x(), size.y(), title, kStyle);
}

}  // namespace manifuzz
