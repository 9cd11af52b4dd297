#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "geometry/diameter.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <cmath>
#include <hwy/highway.h>

#include "geometry/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::HWY_NAMESPACE {

/// All vertices at once meet those that lie so many behind them, counted round: up to half of all.
HWY_INLINE double squared_diameter_of(const ConvexPolygon<float>& polygon) {
  const int count = polygon.count;
  const LanePoints<> vertices = load_points(polygon.vertices[0].data(), count);
  double x[2 * kMaxVertices];
  double y[2 * kMaxVertices];
  store(vertices.x, x);
  store(vertices.y, y);
  for (int i = 0; i < count / 2; ++i) {
    x[count + i] = x[i];
    y[count + i] = y[i];
  }
  Lanes<> minus_greatest = in_every_lane(0);
  for (int apart = 1; apart <= count / 2; ++apart) {
    const LanePoints<> d = LanePoints<>{load(lane_memory<kMaxVertices>(x + apart, count)),
                                        load(lane_memory<kMaxVertices>(y + apart, count))} -
                           vertices;
    minus_greatest = lesser(-dot(d, d), minus_greatest);
  }
  return -least_of(select(first_lanes(count), minus_greatest, in_every_lane(0)));
}

double squared_diameter(const ConvexPolygon<float>& polygon) {
  return squared_diameter_of(polygon);
}

double smaller_squared_diameter(const ConvexPolygon<float>& p, const ConvexPolygon<float>& q) {
  return std::min(squared_diameter_of(p), squared_diameter_of(q));
}

}  // namespace manifuzz::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz {

HWY_EXPORT(squared_diameter);
HWY_EXPORT(smaller_squared_diameter);

double diameter(const ConvexPolygon<float>& polygon) {
  return std::sqrt(HWY_DYNAMIC_DISPATCH(squared_diameter)(polygon));
}

double smaller_diameter(const ConvexPolygon<float>& p, const ConvexPolygon<float>& q) {
  return std::sqrt(HWY_DYNAMIC_DISPATCH(smaller_squared_diameter)(p, q));
}

}  // namespace manifuzz
#endif
