// A number for each corner, or face, of a polygon, in a lane of its own, computed with by the
// widest vectors that the machine has: every operation is that of doubles, whatever the machine.
// Included once a target. Lanes behind the last corner hold anything.

#if defined(MANIFUZZ_GEOMETRY_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_GEOMETRY_LANES_INL
#undef MANIFUZZ_GEOMETRY_LANES_INL
#else
#define MANIFUZZ_GEOMETRY_LANES_INL
#endif

#include <hwy/highway.h>

#include "geometry/lane_memory.hpp"
#include "geometry/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// As many lanes as a vector has, up to all.
using Part = hn::CappedTag<double, kMaxVertices>;
using FloatPart = hn::Rebind<float, Part>;
inline constexpr int kPart = static_cast<int>(hn::MaxLanes(Part()));
inline constexpr int kParts = kMaxVertices / kPart;

/// Half of the parts, where there are several: enough for so many corners.
inline constexpr int kHalf = kParts > 1 ? kParts / 2 : 1;
HWY_INLINE bool fits_half(int count) {
  return kHalf < kParts && count <= kHalf * kPart;
}

/// Lanes, or a mask of lanes, part by part.
template <class Result, class Operation>
HWY_INLINE Result each(const Operation& operation) {
  Result result;
  for (int p = 0; p < Result::kCount; ++p) result.parts[p] = operation(p);
  return result;
}

/// In which lanes something is so.
template <int n>
struct LaneMask {
  static constexpr int kCount = n;
  hn::Mask<Part> parts[n];

  friend HWY_INLINE LaneMask operator|(const LaneMask& a, const LaneMask& b) {
    return each<LaneMask>([&](int p) { return hn::Or(a.parts[p], b.parts[p]); });
  }
};

/// In `n` parts, all of them or half of them.
template <int n = kParts>
struct Lanes {
  static constexpr int kCount = n;
  hn::Vec<Part> parts[n];

  friend HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
    return each<Lanes>([&](int p) { return hn::Add(a.parts[p], b.parts[p]); });
  }
  friend HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
    return each<Lanes>([&](int p) { return hn::Sub(a.parts[p], b.parts[p]); });
  }
  friend HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
    return each<Lanes>([&](int p) { return hn::Mul(a.parts[p], b.parts[p]); });
  }
  friend HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
    return each<Lanes>([&](int p) { return hn::Div(a.parts[p], b.parts[p]); });
  }
  friend HWY_INLINE Lanes operator-(const Lanes& a) {
    return each<Lanes>([&](int p) { return hn::Neg(a.parts[p]); });
  }
  friend HWY_INLINE LaneMask<n> operator>(const Lanes& a, const Lanes& b) {
    return each<LaneMask<n>>([&](int p) { return hn::Gt(a.parts[p], b.parts[p]); });
  }
};

template <int n>
HWY_INLINE Lanes<n> root(const Lanes<n>& a) {
  return each<Lanes<n>>([&](int p) { return hn::Sqrt(a.parts[p]); });
}
template <int n>
HWY_INLINE Lanes<n> magnitude(const Lanes<n>& a) {
  return each<Lanes<n>>([&](int p) { return hn::Abs(a.parts[p]); });
}
/// The lesser, b of equals.
template <int n>
HWY_INLINE Lanes<n> lesser(const Lanes<n>& a, const Lanes<n>& b) {
  return each<Lanes<n>>([&](int p) { return hn::Min(a.parts[p], b.parts[p]); });
}

template <int n = kParts>
HWY_INLINE Lanes<n> in_every_lane(double value) {
  return each<Lanes<n>>([&](int) { return hn::Set(Part(), value); });
}

template <int n = kParts>
HWY_INLINE Lanes<n> load(const double* from) {
  return each<Lanes<n>>([&](int p) { return hn::LoadU(Part(), from + p * kPart); });
}

template <int n>
HWY_INLINE void store(const Lanes<n>& lanes, double* to) {
  for (int p = 0; p < n; ++p) hn::StoreU(lanes.parts[p], Part(), to + p * kPart);
}

/// Lane by lane the least of all parts.
template <int n>
HWY_INLINE Lanes<1> least_of_parts(const Lanes<n>& a) {
  Lanes<1> least{a.parts[0]};
  for (int p = 1; p < n; ++p) least.parts[0] = hn::Min(a.parts[p], least.parts[0]);
  return least;
}
template <int n>
HWY_INLINE double least_of(const Lanes<n>& a) {
  return hn::GetLane(hn::MinOfLanes(Part(), least_of_parts(a).parts[0]));
}

template <int n>
HWY_INLINE LaneMask<n> differ(const Lanes<n>& a, const Lanes<n>& b) {
  return each<LaneMask<n>>([&](int p) { return hn::Ne(a.parts[p], b.parts[p]); });
}

/// Lane by lane whether it is so in any part.
template <int n>
HWY_INLINE LaneMask<1> any_of_parts(const LaneMask<n>& a) {
  LaneMask<1> any{a.parts[0]};
  for (int p = 1; p < n; ++p) any.parts[0] = hn::Or(a.parts[p], any.parts[0]);
  return any;
}
/// What is so, and not `excluded`.
template <int n>
HWY_INLINE LaneMask<n> without(const LaneMask<n>& excluded, const LaneMask<n>& mask) {
  return each<LaneMask<n>>([&](int p) { return hn::AndNot(excluded.parts[p], mask.parts[p]); });
}

/// The lanes of so many corners.
template <int n = kParts>
HWY_INLINE LaneMask<n> first_lanes(int count) {
  const auto end = hn::Set(Part(), static_cast<double>(count));
  return each<LaneMask<n>>(
      [&](int p) { return hn::Lt(hn::Iota(Part(), static_cast<double>(p * kPart)), end); });
}

template <int n>
HWY_INLINE Lanes<n> select(const LaneMask<n>& mask, const Lanes<n>& there, const Lanes<n>& here) {
  return each<Lanes<n>>(
      [&](int p) { return hn::IfThenElse(mask.parts[p], there.parts[p], here.parts[p]); });
}

/// A bit a lane.
template <int n>
HWY_INLINE unsigned bits(const LaneMask<n>& mask) {
  unsigned all = 0;
  for (int p = 0; p < n; ++p) {
    unsigned char of_part[8] = {};
    hn::StoreMaskBits(Part(), mask.parts[p], of_part);
    all |= static_cast<unsigned>(of_part[0]) << (p * kPart);
  }
  return all;
}

/// Points, or directions, of the plane.
template <int n = kParts>
struct LanePoints {
  Lanes<n> x;
  Lanes<n> y;

  friend HWY_INLINE LanePoints operator+(const LanePoints& a, const LanePoints& b) {
    return {a.x + b.x, a.y + b.y};
  }
  friend HWY_INLINE LanePoints operator-(const LanePoints& a, const LanePoints& b) {
    return {a.x - b.x, a.y - b.y};
  }
  friend HWY_INLINE LanePoints operator*(const LanePoints& a, const Lanes<n>& b) {
    return {a.x * b, a.y * b};
  }
  friend HWY_INLINE LanePoints operator/(const LanePoints& a, const Lanes<n>& b) {
    return {a.x / b, a.y / b};
  }
};

template <int n>
HWY_INLINE Lanes<n> dot(const LanePoints<n>& a, const LanePoints<n>& b) {
  return a.x * b.x + a.y * b.y;
}
template <int n = kParts>
HWY_INLINE LanePoints<n> in_every_lane(double x, double y) {
  return {in_every_lane<n>(x), in_every_lane<n>(y)};
}
template <int n>
HWY_INLINE LaneMask<n> differ(const LanePoints<n>& a, const LanePoints<n>& b) {
  return differ(a.x, b.x) | differ(a.y, b.y);
}
template <int n>
HWY_INLINE LanePoints<n> clockwise_quarter(const LanePoints<n>& a) {
  // Part by part: g++ 12 copies all parts at once through memory.
  return {each<Lanes<n>>([&](int p) { return a.y.parts[p]; }), -a.x};
}
/// `rotate` of geometry/pose.hpp.
template <int n>
HWY_INLINE LanePoints<n> turned(double cos, double sin, const LanePoints<n>& a) {
  const Lanes<n> c = in_every_lane<n>(cos);
  const Lanes<n> s = in_every_lane<n>(sin);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// Loads points whose x and y alternate, `count` of them somebody's.
template <int n = kParts>
HWY_INLINE LanePoints<n> load_points(const double* points_from, int count) {
  const auto& from = lane_memory<2 * n * kPart>(points_from, 2 * count);
  LanePoints<n> points;
  for (int p = 0; p < n; ++p) {
    hn::LoadInterleaved2(Part(), from + 2 * p * kPart, points.x.parts[p], points.y.parts[p]);
  }
  return points;
}
template <int n = kParts>
HWY_INLINE LanePoints<n> load_points(const float* points_from, int count) {
  const auto& from = lane_memory<2 * n * kPart>(points_from, 2 * count);
  LanePoints<n> points;
  for (int p = 0; p < n; ++p) {
    hn::Vec<FloatPart> x;
    hn::Vec<FloatPart> y;
    hn::LoadInterleaved2(FloatPart(), from + 2 * p * kPart, x, y);
    points.x.parts[p] = hn::PromoteTo(Part(), x);
    points.y.parts[p] = hn::PromoteTo(Part(), y);
  }
  return points;
}
/// Each as the float nearest to it.
template <int n>
HWY_INLINE Lanes<n> rounded_to_floats(const Lanes<n>& a) {
  return each<Lanes<n>>(
      [&](int p) { return hn::PromoteTo(Part(), hn::DemoteTo(FloatPart(), a.parts[p])); });
}
template <int n>
HWY_INLINE LanePoints<n> rounded_to_floats(const LanePoints<n>& points) {
  return {rounded_to_floats(points.x), rounded_to_floats(points.y)};
}
/// Rounds x and y by turns, of `count` points that are somebody's.
template <int n = kParts>
HWY_INLINE void round_to_floats(const double* points_from, int count, float* to) {
  const auto& from = lane_memory<2 * n * kPart>(points_from, 2 * count);
  for (int i = 0; i < 2 * n * kPart; i += kPart) {
    hn::StoreU(hn::DemoteTo(FloatPart(), hn::LoadU(Part(), from + i)), FloatPart(), to + i);
  }
}
/// Stores them rounded to floats, and returns what is stored.
template <int n>
HWY_INLINE LanePoints<n> store_rounded(const LanePoints<n>& points, float* to) {
  LanePoints<n> rounded;
  for (int p = 0; p < n; ++p) {
    const auto x = hn::DemoteTo(FloatPart(), points.x.parts[p]);
    const auto y = hn::DemoteTo(FloatPart(), points.y.parts[p]);
    hn::StoreInterleaved2(x, y, FloatPart(), to + 2 * p * kPart);
    rounded.x.parts[p] = hn::PromoteTo(Part(), x);
    rounded.y.parts[p] = hn::PromoteTo(Part(), y);
  }
  return rounded;
}
template <int n>
HWY_INLINE void store_points(const LanePoints<n>& points, double* to) {
  for (int p = 0; p < n; ++p) {
    hn::StoreInterleaved2(points.x.parts[p], points.y.parts[p], Part(), to + 2 * p * kPart);
  }
}

/// In each of `count` lanes the value of the next lane, in the last that of the first.
template <int n>
HWY_INLINE Lanes<n> next(const Lanes<n>& lanes, int count) {
  double memory[kMaxVertices + 1];
  store(lanes, memory);
  memory[count] = memory[0];
  return load<n>(lane_memory<n * kPart>(memory + 1, count));
}
template <int n>
HWY_INLINE LanePoints<n> next(const LanePoints<n>& points, int count) {
  return {next(points.x, count), next(points.y, count)};
}
/// In each lane the value of the lane before.
template <int n>
HWY_INLINE Lanes<n> previous(const Lanes<n>& lanes, int count) {
  double memory[kMaxVertices + 1];
  store(lanes, memory + 1);
  memory[0] = memory[count];
  return load<n>(memory);
}
template <int n>
HWY_INLINE LanePoints<n> previous(const LanePoints<n>& points, int count) {
  return {previous(points.x, count), previous(points.y, count)};
}

}  // namespace manifuzz::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // MANIFUZZ_GEOMETRY_LANES_INL
