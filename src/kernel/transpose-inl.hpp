// Between rows of pairs and what lies together in memory: shapes and poses in, manifolds out.
// Sixteen bytes of each pair at a time, transposed in registers.

#if defined(MANIFUZZ_KERNEL_TRANSPOSE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_TRANSPOSE_INL
#undef MANIFUZZ_KERNEL_TRANSPOSE_INL
#else
#define MANIFUZZ_KERNEL_TRANSPOSE_INL
#endif

#include <cstring>

#include "kernel/lanes-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// How many scalars sixteen bytes hold.
template <class D>
inline constexpr std::size_t kQuad = 16 / sizeof(hn::TFromD<D>);

#if HWY_TARGET == HWY_SCALAR

/// Reads kQuad scalars of the one pair, from `address(0)` on, as that many rows.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void load_rows(D d, const Address& address, V (&rows)[kQuad<D>]) {
  for (std::size_t r = 0; r < kQuad<D>; ++r) rows[r] = hn::LoadU(d, address(0) + r);
}

/// Writes that many rows as kQuad scalars of the one pair, to `address(0)` on, bytes.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void store_rows(D, V (&rows)[kQuad<D>], const Address& address) {
  std::memcpy(address(0), rows, sizeof(rows));
}

#else

/// Sixteen bytes from each of `address(0)`, `address(kQuad)`, ...: a block of 128 bits each.
template <class D, class Address>
HWY_INLINE hn::Vec<D> load_blocks(D d, const Address& address) {
  if constexpr (hn::MaxLanes(D()) == kQuad<D>) {
    return hn::LoadU(d, address(0));
  } else {
    const hn::Half<D> half;
    return hn::Combine(
        d, load_blocks(half, [&](std::size_t i) { return address(i + hn::MaxLanes(half)); }),
        load_blocks(half, address));
  }
}

template <class D, class Address>
HWY_INLINE void store_blocks([[maybe_unused]] D d, hn::Vec<D> v, const Address& address) {
  if constexpr (hn::MaxLanes(D()) == kQuad<D>) {
    const hn::Repartition<std::uint8_t, D> bytes;
    hn::StoreU(hn::BitCast(bytes, v), bytes, address(0));
  } else {
    const hn::Half<D> half;
    store_blocks(half, hn::LowerHalf(half, v), address);
    store_blocks(half, hn::UpperHalf(half, v),
                 [&](std::size_t i) { return address(i + hn::MaxLanes(half)); });
  }
}

/// Transposes the square of scalars in every 128-bit block. It is its own inverse.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void transpose_blocks([[maybe_unused]] D d, V (&rows)[kQuad<D>]) {
  if constexpr (kQuad<D> == 2) {
    const V first = hn::InterleaveLower(d, rows[0], rows[1]);
    rows[1] = hn::InterleaveUpper(d, rows[0], rows[1]);
    rows[0] = first;
  } else {
    const hn::Repartition<double, D> dd;
    const auto lower01 = hn::BitCast(dd, hn::InterleaveLower(d, rows[0], rows[1]));
    const auto upper01 = hn::BitCast(dd, hn::InterleaveUpper(d, rows[0], rows[1]));
    const auto lower23 = hn::BitCast(dd, hn::InterleaveLower(d, rows[2], rows[3]));
    const auto upper23 = hn::BitCast(dd, hn::InterleaveUpper(d, rows[2], rows[3]));
    rows[0] = hn::BitCast(d, hn::InterleaveLower(dd, lower01, lower23));
    rows[1] = hn::BitCast(d, hn::InterleaveUpper(dd, lower01, lower23));
    rows[2] = hn::BitCast(d, hn::InterleaveLower(dd, upper01, upper23));
    rows[3] = hn::BitCast(d, hn::InterleaveUpper(dd, upper01, upper23));
  }
}

/// Reads kQuad scalars of every lane's pair, from `address(lane)` on, as that many rows.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void load_rows(D d, const Address& address, V (&rows)[kQuad<D>]) {
  for (std::size_t r = 0; r < kQuad<D>; ++r) {
    rows[r] = load_blocks(d, [&](std::size_t lane) { return address(lane + r); });
  }
  transpose_blocks(d, rows);
}

/// Writes that many rows as kQuad scalars of every lane's pair, to `address(lane)` on, bytes.
template <class D, class Address, class V = hn::Vec<D>>
HWY_INLINE void store_rows(D d, V (&rows)[kQuad<D>], const Address& address) {
  transpose_blocks(d, rows);
  for (std::size_t r = 0; r < kQuad<D>; ++r) {
    store_blocks(d, rows[r], [&](std::size_t lane) { return address(lane + r); });
  }
}

#endif  // HWY_TARGET == HWY_SCALAR

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
