#include "report/picture/view.hpp"

#include <algorithm>
#include <limits>

namespace manifuzz {
namespace {

constexpr double kHeightMin = 280;
constexpr double kHeightMax = 440;
constexpr double kHeightOfTwo = 470;  // beside two closer views
constexpr double kGap = 14;           // between frames
constexpr double kWholeShare = 0.6;   // of the width, where there are closer views
constexpr double kMargin = 56;        // around the scene, for labels

/// Something that a picture must show, and how large it must come out.
struct Interest {
  Point focus{0, 0};
  double length = 0;
  double pixels_min = 0;    // to be seen
  double share_wanted = 0;  // of a closer view's smaller side
  bool is_depth = false;
};

Point middle(const Segment& segment) {
  return (segment.first + segment.second) / 2;
}

double length_of(const Segment& segment) {
  return length(segment.second - segment.first);
}

/// Around a polygon and its skin.
Box box_of(const Scene& scene, Side side) {
  const auto& polygon = scene.polygon(side);
  const auto* const vertices = polygon.vertices.data();
  return box_around({vertices, vertices + polygon.count}).grown(scene.radius(side));
}

/// The width of a polygon where it is thinnest, and the corner there.
Interest thickness(const exact::RoughPolygon& polygon) {
  Interest thinnest{{0, 0}, std::numeric_limits<double>::infinity(), 4, 0.25};
  for (int face = 0; face < polygon.count; ++face) {
    const Point& normal = polygon.normals[face];
    Point farthest = polygon.vertices[face];
    for (int i = 0; i < polygon.count; ++i) {
      if (normal.dot(polygon.vertices[i] - farthest) < 0) farthest = polygon.vertices[i];
    }
    const double width = normal.dot(polygon.vertices[face] - farthest);
    if (width < thinnest.length) {
      thinnest.length = width;
      thinnest.focus = farthest + width / 2 * normal;
    }
  }
  return thinnest;
}

/// The largest first.
std::vector<Interest> interests(const Scene& scene) {
  std::vector<Interest> all;
  for (const Side side : {Side::a, Side::b}) {
    const Box box = box_of(scene, side);
    all.push_back({box.center(), length({box.width, box.height}), 30, 0.6});
    if (scene.radius(side) <= 0) all.push_back(thickness(scene.polygon(side)));
  }
  all.push_back({middle(scene.reference.segment), length_of(scene.reference.segment), 20, 0.4});
  if (scene.incident) {
    all.push_back({middle(scene.incident->segment), length_of(scene.incident->segment), 20, 0.4});
  }
  if (scene.deepest.depth != 0) {
    // A closer look than a quarter of the bound would show rounding alone.
    const double depth = std::max(std::abs(scene.deepest.depth), scene.rounding / 4);
    all.push_back({middle({scene.deepest.from, scene.deepest.to}), depth, 14, 0.25, true});
  }
  // What rounding makes no longer than nothing cannot be looked at more closely.
  std::erase_if(all, [](const Interest& interest) { return !(interest.length > 0); });
  std::stable_sort(all.begin(), all.end(),
                   [](const Interest& p, const Interest& q) { return p.length > q.length; });
  return all;
}

bool shows(const View& view, const Interest& interest) {
  return interest.length * view.scale >= interest.pixels_min &&
         view.frame.contains(view.place(interest.focus));
}

/// What is in none of the views.
std::vector<Interest> unseen(const std::vector<Interest>& all, const std::vector<View>& views) {
  std::vector<Interest> left;
  for (const Interest& interest : all) {
    const bool seen = std::any_of(views.begin(), views.end(),
                                  [&](const View& view) { return shows(view, interest); });
    if (!seen) left.push_back(interest);
  }
  return left;
}

/// Both shapes, and reported points that are not absurdly far from them.
Box whole(const Scene& scene) {
  std::vector<Point> points;
  for (const Side side : {Side::a, Side::b}) {
    const Box box = box_of(scene, side);
    points.insert(points.end(), {Point(box.x, box.y), Point(box.right(), box.bottom())});
  }
  const Box shapes = box_around(points);
  const Box about = shapes.grown(std::max(shapes.width, shapes.height));
  for (const DrawnPoint& reported : scene.points) {
    if (about.contains(reported.position)) points.push_back(reported.position);
  }
  return box_around(points);
}

View view_of(const Box& scene, const Box& frame) {
  const double across = std::min((frame.width - 2 * kMargin) / scene.width,
                                 (frame.height - 2 * kMargin) / scene.height);
  return {frame, scene.center(), across};
}

View close_view(const Interest& interest, const Box& frame) {
  const double side = std::min(frame.width, frame.height);
  return {frame, interest.focus, interest.share_wanted * side / interest.length};
}

}  // namespace

Region View::place(const Region& region) const {
  Region placed;
  placed.reserve(region.size());
  for (const Point& point : region) placed.push_back(place(point));
  return placed;
}

std::vector<View> choose_views(const Scene& scene, double x, double y, double width) {
  const Box shown = whole(scene);
  const std::vector<Interest> all = interests(scene);
  const double wanted = (width - 2 * kMargin) * shown.height / shown.width + 2 * kMargin;
  const double height = std::clamp(wanted, kHeightMin, kHeightMax);
  std::vector<View> views{view_of(shown, {x, y, width, height})};
  if (unseen(all, views).empty()) return views;

  const double left = kWholeShare * (width - kGap);
  const Box beside{x + left + kGap, y, width - left - kGap, kHeightMax};
  views = {view_of(shown, {x, y, left, kHeightMax})};
  views.push_back(close_view(unseen(all, views).front(), beside));
  if (unseen(all, views).empty()) return views;

  const double half = (kHeightOfTwo - kGap) / 2;
  const Box upper{beside.x, y, beside.width, half};
  const Box lower{beside.x, y + half + kGap, beside.width, half};
  views = {view_of(shown, {x, y, left, kHeightOfTwo})};
  views.push_back(close_view(unseen(all, views).front(), upper));
  const std::vector<Interest> left_over = unseen(all, views);
  if (left_over.empty()) return views;
  const auto depth = std::find_if(left_over.begin(), left_over.end(),
                                  [](const Interest& interest) { return interest.is_depth; });
  views.push_back(close_view(depth != left_over.end() ? *depth : left_over.back(), lower));
  return views;
}

}  // namespace manifuzz
