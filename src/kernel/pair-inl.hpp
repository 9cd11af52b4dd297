// One pair, a face a lane: places B, finds the greatest separation (clipping/separation.hpp) and
// the incident edge (clipping/features.hpp).

#if defined(MANIFUZZ_KERNEL_PAIR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_PAIR_INL
#undef MANIFUZZ_KERNEL_PAIR_INL
#else
#define MANIFUZZ_KERNEL_PAIR_INL
#endif

#include <limits>

#include "kernel/lanes-inl.hpp"
#include "kernel/shapes.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

using Faces = hn::CappedTag<float, kMaxVertices>;
using FaceLanes = hn::Vec<Faces>;
using FaceLanes2 = Lanes2<Faces>;
inline constexpr int kPart = static_cast<int>(hn::MaxLanes(Faces()));
inline constexpr int kParts = kMaxVertices / kPart;  // the vectors of a polygon's row

/// Corners k, k + 1, ..., of a shape.
HWY_INLINE FaceLanes2 vertices(const ShapeRows& shape, int k) {
  return {hn::Load(Faces(), shape.x + k), hn::Load(Faces(), shape.y + k)};
}

HWY_INLINE FaceLanes2 normals(const ShapeRows& shape, int k) {
  return {hn::Load(Faces(), shape.normal_x + k), hn::Load(Faces(), shape.normal_y + k)};
}

HWY_INLINE FaceLanes2 in_every_lane(float x, float y) {
  return {hn::Set(Faces(), x), hn::Set(Faces(), y)};
}

/// A pose in every lane. `memory`: position x, y; cos, sin.
HWY_INLINE LanePose<Faces> lane_pose(const float* memory) {
  return {in_every_lane(memory[0], memory[1]), in_every_lane(memory[2], memory[3])};
}

/// `placed` becomes the shape as seen from the frame in which `pose` places it.
HWY_INLINE void place(const ShapeRows& shape, const LanePose<Faces>& pose, ShapeRows& placed) {
  for (int k = 0; k < kMaxVertices; k += kPart) {
    const FaceLanes2 vertex = transformed(pose, vertices(shape, k));
    const FaceLanes2 normal = turned<Faces>(pose.rotation, normals(shape, k));
    hn::Store(vertex.x, Faces(), placed.x + k);
    hn::Store(vertex.y, Faces(), placed.y + k);
    hn::Store(normal.x, Faces(), placed.normal_x + k);
    hn::Store(normal.y, Faces(), placed.normal_y + k);
  }
  placed.count = shape.count;
  placed.radius = shape.radius;
  placed.rounding = shape.rounding;
}

/// A value of each face of a polygon.
struct FaceValues {
  FaceLanes part[kParts];
};

/// How far `other` lies in front of each face. Two chains of minima, even corners and odd ones,
/// take half as long as one.
HWY_INLINE FaceValues face_separations(const ShapeRows& shape, const ShapeRows& other) {
  const FaceLanes infinity = hn::Set(Faces(), std::numeric_limits<float>::infinity());
  FaceValues least;
  FaceLanes even[kParts];
  FaceLanes odd[kParts];
  for (int p = 0; p < kParts; ++p) even[p] = odd[p] = infinity;
  const auto consider = [&](int j, FaceLanes(&of)[kParts]) {
    const FaceLanes2 corner = in_every_lane(other.x[j], other.y[j]);
    for (int p = 0; p < kParts; ++p) {
      const FaceLanes2 from_face = subtract<Faces>(corner, vertices(shape, p * kPart));
      of[p] = hn::Min(dot<Faces>(normals(shape, p * kPart), from_face), of[p]);
    }
  };
  for (int j = 0; j < other.count; j += 2) {
    consider(j, even);
    consider(j + 1, odd);
  }
  for (int p = 0; p < kParts; ++p) least.part[p] = hn::Min(even[p], odd[p]);
  return least;
}

/// The dot product of each face's normal with `normal`.
HWY_INLINE FaceValues dots(const ShapeRows& shape, float normal_x, float normal_y) {
  const FaceLanes2 normal = in_every_lane(normal_x, normal_y);
  FaceValues products;
  for (int p = 0; p < kParts; ++p) {
    products.part[p] = dot<Faces>(normal, normals(shape, p * kPart));
  }
  return products;
}

struct Extreme {
  float value = 0;
  int face = 0;  ///< the first of equals
};

/// `extreme` is a value of some face, in every lane.
HWY_INLINE Extreme first_of(const FaceValues& values, FaceLanes extreme) {
  Extreme found{hn::GetLane(extreme), 0};
  for (int p = kParts - 1; p >= 0; --p) {
    const auto lane = hn::FindFirstTrue(Faces(), hn::Eq(values.part[p], extreme));
    if (lane >= 0) found.face = p * kPart + static_cast<int>(lane);
  }
  return found;
}

HWY_INLINE Extreme greatest(const FaceValues& values) {
  FaceLanes most = values.part[0];
  for (int p = 1; p < kParts; ++p) most = hn::Max(values.part[p], most);
  return first_of(values, hn::MaxOfLanes(Faces(), most));
}

HWY_INLINE Extreme least(const FaceValues& values) {
  FaceLanes fewest = values.part[0];
  for (int p = 1; p < kParts; ++p) fewest = hn::Min(values.part[p], fewest);
  return first_of(values, hn::MinOfLanes(Faces(), fewest));
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
