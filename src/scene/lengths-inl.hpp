// Lengths of vectors, one a lane.

#if defined(MANIFUZZ_SCENE_LENGTHS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_SCENE_LENGTHS_INL
#undef MANIFUZZ_SCENE_LENGTHS_INL
#else
#define MANIFUZZ_SCENE_LENGTHS_INL
#endif

#include "afresh/shape_table.hpp"
#include "kernel/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// `length_at_most` of afresh/shape_table.hpp.
template <class D>
HWY_INLINE hn::Vec<D> length_at_most(D d, const kernel::HWY_NAMESPACE::Lanes2<D>& v) {
  const auto x = hn::Abs(v.x);
  const auto y = hn::Abs(v.y);
  return hn::Add(hn::Max(x, y), hn::Mul(hn::Set(d, kLesserSide), hn::Min(x, y)));
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
