#include "judging/errors/place_error.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "exact/placed.hpp"

namespace manifuzz {
namespace {

using exact::RoughPolygon;

/// With mitred corners that lie so far out.
RoughPolygon grown(const RoughPolygon& core, double radius) {
  RoughPolygon result = core;
  for (int i = 0; i < core.count; ++i) {
    const Vector2<double>& before = core.normals[core.previous(i)];
    const Vector2<double>& after = core.normals[i];
    result.vertices[i] += radius * (before + after) / (1 + before.dot(after));
  }
  return result;
}

double distance_from(const Vector2<double>& place, const RoughPolygon& shape) {
  const auto is_before = [&](int i) { return shape.normals[i].dot(place - shape.vertices[i]) > 0; };
  bool is_outside = shape.count < kMinVertices;
  double least = INFINITY;
  for (int i = 0; i < shape.count; ++i) {
    is_outside = is_outside || is_before(i);
    least = std::min(
        least, exact::distance_to_segment(place, shape.vertices[i], shape.vertices[shape.next(i)]));
  }
  return is_outside ? least : 0;
}

/// The heights of a core's boundary that faces the other core, as a polyline along the tangent.
struct Profile {
  std::vector<Vector2<double>> corners;  ///< place along the tangent, and height; places ascend

  double first() const { return corners.front().x(); }
  double last() const { return corners.back().x(); }
  double height_at(double place) const {
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const auto& from = corners[i];
      const auto& to = corners[i + 1];
      if (place > to.x()) continue;
      const double run = to.x() - from.x();
      const double share = run > 0 ? std::clamp((place - from.x()) / run, 0.0, 1.0) : 1;
      return from.y() + share * (to.y() - from.y());
    }
    return corners.back().y();
  }
};

/// `up` is 1 for the side that faces along the normal, -1 for the other: what lies farthest that
/// way.
Profile profile_of(const RoughPolygon& core, const Vector2<double>& normal, double up) {
  const auto seen = [&](int i) {
    const Vector2<double>& at = core.vertices[i];
    return Vector2<double>(cross<double>(normal, at), normal.dot(at));
  };
  std::vector<Vector2<double>> all;
  for (int i = 0; i < core.count; ++i) all.push_back(seen(i));
  std::ranges::sort(all, [&](const auto& p, const auto& q) {
    return p.x() != q.x() ? p.x() < q.x() : up * p.y() < up * q.y();
  });
  Profile profile;
  for (const Vector2<double>& corner : all) {
    const auto is_below = [&] {
      const auto& from = profile.corners[profile.corners.size() - 2];
      const auto& at = profile.corners.back();
      return up * cross<double>(at - from, corner - from) >= 0;
    };
    if (!profile.corners.empty() && profile.corners.back().x() == corner.x()) {
      profile.corners.pop_back();
    }
    while (profile.corners.size() > 1 && is_below()) profile.corners.pop_back();
    profile.corners.push_back(corner);
  }
  return profile;
}

/// A function that falls and then rises, at its least between two places.
template <class Function>
double least_between(double low, double high, const Function& function) {
  constexpr int kSteps = 60;  // each leaves two thirds: to the last digits of a double
  for (int i = 0; i < kSteps; ++i) {
    const double third = (high - low) / 3;
    if (function(low + third) <= function(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return std::min(function(low), function(high));
}

/// A point and both cores, seen along a normal.
class Seen {
 public:
  Seen(const exact::Truth& truth, const Vector2<double>& normal, const WitnessClaim& claim)
      : claim_(claim),
        radius_(total_radius(truth.pair())),
        reach_(is_round(truth.pair()) ? 0 : radius_) {
    const exact::RoughPair placed = exact::place_roughly(truth.stored());
    const Vector2<double> along = exact::seen_from_a(truth.pair(), normal).normalized();
    top_ = profile_of(placed.a, along, 1);
    bottom_ = profile_of(placed.b, along, -1);
    const Vector2<double> at = exact::seen_from_a(truth.pair(), claim.point.position);
    place_ = cross<double>(along, at);
    height_ = along.dot(at);
  }

  double error() const {
    const double low = std::max(top_.first(), bottom_.first());
    const double high = std::min(top_.last(), bottom_.last());
    double least = INFINITY;
    for (const exact::Height& height : claim_.heights) {
      const auto at = [&](double place) { return error_at(place, height); };
      if (!(low <= high)) return std::max(at(low), at(high));  // no line meets both
      least = std::min(least, std::min(at(low), at(high)));
      const std::vector<double> corners = corners_between(low, high);
      for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        least = std::min(least, least_between(corners[i], corners[i + 1], at));
      }
    }
    return least;
  }

 private:
  std::vector<double> corners_between(double low, double high) const {
    std::vector<double> corners{low, high};
    for (const Profile* const profile : {&top_, &bottom_}) {
      for (const auto& corner : profile->corners) {
        if (corner.x() > low && corner.x() < high) corners.push_back(corner.x());
      }
    }
    std::ranges::sort(corners);
    return corners;
  }

  double error_at(double place, const exact::Height& claimed) const {
    const double top = top_.height_at(place);
    const double bottom = bottom_.height_at(place);
    const double height = claimed.of_top * top + claimed.of_bottom * bottom + claimed.offset;
    // Side planes of mitred skins are widened by the radius, and so is where a point may be.
    const double along = std::max(std::abs(place - place_) - reach_, 0.0);
    const double gap = top - bottom + radius_;
    return std::max(
        {std::hypot(along, height - height_), claim_.gap_least - gap, gap - claim_.gap_most, 0.0});
  }

  const WitnessClaim& claim_;
  double radius_;
  double reach_;
  Profile top_;     ///< of A
  Profile bottom_;  ///< of B
  double place_ = 0;
  double height_ = 0;
};

}  // namespace

double distance_from_both(const exact::Truth& truth, const Vector2<double>& place) {
  const exact::RoughPair placed = exact::place_roughly(truth.stored());
  const double radius = total_radius(truth.pair());
  const Vector2<double> at = exact::seen_from_a(truth.pair(), place);
  const auto from = [&](const RoughPolygon& core) {
    if (is_round(truth.pair())) return std::max(distance_from(at, core) - radius, 0.0);
    return distance_from(at, radius > 0 ? grown(core, radius) : core);
  };
  return std::max(from(placed.a), from(placed.b));
}

double distance_from_vertices(const exact::Truth& truth, const Vector2<double>& place) {
  const exact::RoughPair placed = exact::place_roughly(truth.stored());
  const Vector2<double> at = exact::seen_from_a(truth.pair(), place);
  double least = INFINITY;
  for (const Side side : {Side::a, Side::b}) {
    for (int i = 0; i < placed[side].count; ++i) {
      least = std::min(least, (at - placed[side].vertices[i]).norm());
    }
  }
  return std::max(least - total_radius(truth.pair()), 0.0);
}

double witness_error(const exact::Truth& truth, const Vector2<double>& normal,
                     const WitnessClaim& claim) {
  return Seen(truth, normal, claim).error();
}

}  // namespace manifuzz
