// The lanes of a mask, one after another.

#if defined(MANIFUZZ_AFRESH_COMPRESSED_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_AFRESH_COMPRESSED_INL
#undef MANIFUZZ_AFRESH_COMPRESSED_INL
#else
#define MANIFUZZ_AFRESH_COMPRESSED_INL
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The values in a mask's lanes first, in their order; behind them anything.
template <class D>
HWY_INLINE hn::Vec<D> compressed(D d, hn::Vec<D> values, hn::Mask<D> mask) {
#if HWY_TARGET <= HWY_AVX3
  return hn::Compress(values, mask);
#else
  // Not Compress: g++ 12 copies its table of a thousand bytes at each call.
  HWY_ALIGN hn::TFromD<D> lanes[hn::MaxLanes(D())];
  HWY_ALIGN hn::TFromD<D> chosen[hn::MaxLanes(D())];
  hn::Store(values, d, lanes);
  hn::Store(hn::IfThenElseZero(mask, hn::Set(d, 1)), d, chosen);
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    lanes[count] = lanes[lane];
    count += chosen[lane];
  }
  return hn::Load(d, lanes);
#endif
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
