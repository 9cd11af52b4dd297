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

#include "geometry/lanes.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// As many lanes as a vector has, up to all.
using Part = hn::CappedTag<double, kMaxVertices>;
using FloatPart = hn::Rebind<float, Part>;
inline constexpr int kPart = static_cast<int>(hn::MaxLanes(Part()));
inline constexpr int kParts = kMaxVertices / kPart;

struct Lanes {
  hn::Vec<Part> parts[kParts];
};

template <class Operation>
HWY_INLINE Lanes each(const Operation& operation) {
  Lanes result;
  for (int p = 0; p < kParts; ++p) result.parts[p] = operation(p);
  return result;
}

HWY_INLINE Lanes operator+(const Lanes& a, const Lanes& b) {
  return each([&](int p) { return hn::Add(a.parts[p], b.parts[p]); });
}
HWY_INLINE Lanes operator-(const Lanes& a, const Lanes& b) {
  return each([&](int p) { return hn::Sub(a.parts[p], b.parts[p]); });
}
HWY_INLINE Lanes operator*(const Lanes& a, const Lanes& b) {
  return each([&](int p) { return hn::Mul(a.parts[p], b.parts[p]); });
}
HWY_INLINE Lanes operator/(const Lanes& a, const Lanes& b) {
  return each([&](int p) { return hn::Div(a.parts[p], b.parts[p]); });
}
HWY_INLINE Lanes operator-(const Lanes& a) {
  return each([&](int p) { return hn::Neg(a.parts[p]); });
}
HWY_INLINE Lanes root(const Lanes& a) {
  return each([&](int p) { return hn::Sqrt(a.parts[p]); });
}
HWY_INLINE Lanes magnitude(const Lanes& a) {
  return each([&](int p) { return hn::Abs(a.parts[p]); });
}
/// The lesser, b of equals.
HWY_INLINE Lanes lesser(const Lanes& a, const Lanes& b) {
  return each([&](int p) { return hn::Min(a.parts[p], b.parts[p]); });
}

HWY_INLINE Lanes in_every_lane(double value) {
  return each([&](int) { return hn::Set(Part(), value); });
}

HWY_INLINE Lanes load(const double* from) {
  return each([&](int p) { return hn::LoadU(Part(), from + p * kPart); });
}

HWY_INLINE void store(const Lanes& lanes, double* to) {
  for (int p = 0; p < kParts; ++p) hn::StoreU(lanes.parts[p], Part(), to + p * kPart);
}

HWY_INLINE double least_of(const Lanes& a) {
  hn::Vec<Part> least = a.parts[0];
  for (int p = 1; p < kParts; ++p) least = hn::Min(a.parts[p], least);
  return hn::GetLane(hn::MinOfLanes(Part(), least));
}

/// In which lanes something is so.
struct LaneMask {
  hn::Mask<Part> parts[kParts];
};

HWY_INLINE LaneMask operator>(const Lanes& a, const Lanes& b) {
  LaneMask mask;
  for (int p = 0; p < kParts; ++p) mask.parts[p] = hn::Gt(a.parts[p], b.parts[p]);
  return mask;
}

HWY_INLINE LaneMask differ(const Lanes& a, const Lanes& b) {
  LaneMask mask;
  for (int p = 0; p < kParts; ++p) mask.parts[p] = hn::Ne(a.parts[p], b.parts[p]);
  return mask;
}

HWY_INLINE LaneMask operator|(const LaneMask& a, const LaneMask& b) {
  LaneMask mask;
  for (int p = 0; p < kParts; ++p) mask.parts[p] = hn::Or(a.parts[p], b.parts[p]);
  return mask;
}
/// What is so, and not `excluded`.
HWY_INLINE LaneMask without(const LaneMask& excluded, const LaneMask& mask) {
  LaneMask rest;
  for (int p = 0; p < kParts; ++p) rest.parts[p] = hn::AndNot(excluded.parts[p], mask.parts[p]);
  return rest;
}

/// The lanes of so many corners.
HWY_INLINE LaneMask first_lanes(int count) {
  LaneMask mask;
  const auto end = hn::Set(Part(), static_cast<double>(count));
  for (int p = 0; p < kParts; ++p) {
    mask.parts[p] = hn::Lt(hn::Iota(Part(), static_cast<double>(p * kPart)), end);
  }
  return mask;
}

HWY_INLINE Lanes select(const LaneMask& mask, const Lanes& there, const Lanes& here) {
  return each([&](int p) { return hn::IfThenElse(mask.parts[p], there.parts[p], here.parts[p]); });
}

/// A bit a lane.
HWY_INLINE unsigned bits(const LaneMask& mask) {
  unsigned all = 0;
  for (int p = 0; p < kParts; ++p) {
    unsigned char of_part[8] = {};
    hn::StoreMaskBits(Part(), mask.parts[p], of_part);
    all |= static_cast<unsigned>(of_part[0]) << (p * kPart);
  }
  return all;
}

/// Points, or directions, of the plane.
struct LanePoints {
  Lanes x;
  Lanes y;
};

HWY_INLINE LanePoints operator+(const LanePoints& a, const LanePoints& b) {
  return {a.x + b.x, a.y + b.y};
}
HWY_INLINE LanePoints operator-(const LanePoints& a, const LanePoints& b) {
  return {a.x - b.x, a.y - b.y};
}
HWY_INLINE LanePoints operator*(const LanePoints& a, const Lanes& b) {
  return {a.x * b, a.y * b};
}
HWY_INLINE LanePoints operator/(const LanePoints& a, const Lanes& b) {
  return {a.x / b, a.y / b};
}
HWY_INLINE Lanes dot(const LanePoints& a, const LanePoints& b) {
  return a.x * b.x + a.y * b.y;
}
HWY_INLINE LanePoints in_every_lane(double x, double y) {
  return {in_every_lane(x), in_every_lane(y)};
}
HWY_INLINE LaneMask differ(const LanePoints& a, const LanePoints& b) {
  return differ(a.x, b.x) | differ(a.y, b.y);
}
HWY_INLINE LanePoints clockwise_quarter(const LanePoints& a) {
  return {a.y, -a.x};
}
/// `rotate` of geometry/pose.hpp.
HWY_INLINE LanePoints turned(double cos, double sin, const LanePoints& a) {
  const Lanes c = in_every_lane(cos);
  const Lanes s = in_every_lane(sin);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}

/// Of x and y by turns.
HWY_INLINE LanePoints load_points(const double* from) {
  LanePoints points;
  for (int p = 0; p < kParts; ++p) {
    hn::LoadInterleaved2(Part(), from + 2 * p * kPart, points.x.parts[p], points.y.parts[p]);
  }
  return points;
}
HWY_INLINE LanePoints load_points(const float* from) {
  LanePoints points;
  for (int p = 0; p < kParts; ++p) {
    hn::Vec<FloatPart> x;
    hn::Vec<FloatPart> y;
    hn::LoadInterleaved2(FloatPart(), from + 2 * p * kPart, x, y);
    points.x.parts[p] = hn::PromoteTo(Part(), x);
    points.y.parts[p] = hn::PromoteTo(Part(), y);
  }
  return points;
}
/// Each as the float nearest to it.
HWY_INLINE Lanes rounded_to_floats(const Lanes& a) {
  return each([&](int p) { return hn::PromoteTo(Part(), hn::DemoteTo(FloatPart(), a.parts[p])); });
}
HWY_INLINE LanePoints rounded_to_floats(const LanePoints& points) {
  return {rounded_to_floats(points.x), rounded_to_floats(points.y)};
}
/// Rounds x and y by turns, of kMaxVertices points.
HWY_INLINE void round_to_floats(const double* from, float* to) {
  for (int i = 0; i < 2 * kMaxVertices; i += kPart) {
    hn::StoreU(hn::DemoteTo(FloatPart(), hn::LoadU(Part(), from + i)), FloatPart(), to + i);
  }
}
/// Stores them rounded to floats, and returns what is stored.
HWY_INLINE LanePoints store_rounded(const LanePoints& points, float* to) {
  LanePoints rounded;
  for (int p = 0; p < kParts; ++p) {
    const auto x = hn::DemoteTo(FloatPart(), points.x.parts[p]);
    const auto y = hn::DemoteTo(FloatPart(), points.y.parts[p]);
    hn::StoreInterleaved2(x, y, FloatPart(), to + 2 * p * kPart);
    rounded.x.parts[p] = hn::PromoteTo(Part(), x);
    rounded.y.parts[p] = hn::PromoteTo(Part(), y);
  }
  return rounded;
}
HWY_INLINE void store_points(const LanePoints& points, double* to) {
  for (int p = 0; p < kParts; ++p) {
    hn::StoreInterleaved2(points.x.parts[p], points.y.parts[p], Part(), to + 2 * p * kPart);
  }
}

/// Of each of `count` lanes the next, of the last the first.
HWY_INLINE Lanes next(const Lanes& lanes, int count) {
  double memory[kMaxVertices + 1];
  store(lanes, memory);
  memory[count] = memory[0];
  return load(memory + 1);
}
HWY_INLINE LanePoints next(const LanePoints& points, int count) {
  return {next(points.x, count), next(points.y, count)};
}
/// Of each the one before.
HWY_INLINE Lanes previous(const Lanes& lanes, int count) {
  double memory[kMaxVertices + 1];
  store(lanes, memory + 1);
  memory[0] = memory[count];
  return load(memory);
}
HWY_INLINE LanePoints previous(const LanePoints& points, int count) {
  return {previous(points.x, count), previous(points.y, count)};
}

}  // namespace manifuzz::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // MANIFUZZ_GEOMETRY_LANES_INL
