// The vocabulary of the kernels: vectors of pairs, and a strip of pairs in memory. Included once a
// target.

#if defined(MANIFUZZ_KERNEL_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_LANES_INL
#undef MANIFUZZ_KERNEL_LANES_INL
#else
#define MANIFUZZ_KERNEL_LANES_INL
#endif

#include <hwy/highway.h>

#include "geometry/convex_polygon.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

template <class D>
using DInt = hn::RebindToSigned<D>;

/// A vector of the plane in every lane.
template <class D>
struct Lanes2 {
  hn::Vec<D> x;
  hn::Vec<D> y;
};

template <class D>
HWY_INLINE Lanes2<D> load2(D d, const hn::TFromD<D>* x, const hn::TFromD<D>* y) {
  return {hn::Load(d, x), hn::Load(d, y)};
}

template <class V>
HWY_INLINE V dot(V ax, V ay, V bx, V by) {
  return hn::Add(hn::Mul(ax, bx), hn::Mul(ay, by));
}

/// One pair a lane: both polygons corner by corner, B's still in its own frame until `place`.
template <class D>
struct Strip {
  using T = hn::TFromD<D>;
  static constexpr std::size_t kLanes = hn::MaxLanes(D());
  /// Of polygon, corner: vertex x, vertex y, normal x, normal y. Corners beyond a polygon's last,
  /// up to `corners()`, repeat one of its own.
  alignas(64) T corner[2][kMaxVertices][4][kLanes];
  alignas(64) T pose[2][4][kLanes];  ///< of A, of B: position x, y, cos, sin
  alignas(64) T total_radius[kLanes];
  alignas(64) hwy::MakeSigned<T> count[2][kLanes];
  int count_max[2];

  int corners() const { return HWY_MAX(count_max[0], count_max[1]); }
};

/// Puts B into A's frame: `relative_pose`, then `transform`.
template <class D>
HWY_INLINE void place(D d, Strip<D>& s) {
  const auto cos_a = hn::Load(d, s.pose[0][2]);
  const auto sin_a = hn::Load(d, s.pose[0][3]);
  const auto rotate_back = [&](auto x, auto y) -> Lanes2<D> {
    return {dot(cos_a, sin_a, x, y), hn::Sub(hn::Mul(cos_a, y), hn::Mul(sin_a, x))};
  };
  const Lanes2<D> position =
      rotate_back(hn::Sub(hn::Load(d, s.pose[1][0]), hn::Load(d, s.pose[0][0])),
                  hn::Sub(hn::Load(d, s.pose[1][1]), hn::Load(d, s.pose[0][1])));
  const Lanes2<D> rotation = rotate_back(hn::Load(d, s.pose[1][2]), hn::Load(d, s.pose[1][3]));
  const auto rotate = [&](auto x, auto y) -> Lanes2<D> {
    return {hn::Sub(hn::Mul(rotation.x, x), hn::Mul(rotation.y, y)),
            dot(rotation.y, rotation.x, x, y)};
  };
  for (int j = 0; j < s.count_max[1]; ++j) {
    auto& corner = s.corner[1][j];
    const Lanes2<D> vertex = rotate(hn::Load(d, corner[0]), hn::Load(d, corner[1]));
    const Lanes2<D> normal = rotate(hn::Load(d, corner[2]), hn::Load(d, corner[3]));
    hn::Store(hn::Add(vertex.x, position.x), d, corner[0]);
    hn::Store(hn::Add(vertex.y, position.y), d, corner[1]);
    hn::Store(normal.x, d, corner[2]);
    hn::Store(normal.y, d, corner[3]);
  }
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
