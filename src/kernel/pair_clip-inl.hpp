// One pair whose reference face and incident edge are known: clips both ends of the edge against
// both side planes at once, and keeps what lies behind the face (clipping/clip.hpp).

#if defined(MANIFUZZ_KERNEL_PAIR_CLIP_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_PAIR_CLIP_INL
#undef MANIFUZZ_KERNEL_PAIR_CLIP_INL
#else
#define MANIFUZZ_KERNEL_PAIR_CLIP_INL
#endif

#include <bit>
#include <cmath>
#include <limits>

#include "geometry/manifold.hpp"
#include "kernel/lanes-inl.hpp"
#include "kernel/shapes.hpp"

#if HWY_TARGET != HWY_SCALAR

HWY_BEFORE_NAMESPACE();
namespace manifuzz::kernel::HWY_NAMESPACE {

/// The reference face and the incident edge, each with its polygon in A's frame.
struct PairFeatures {
  const ShapeRows& reference;
  const ShapeRows& incident;
  bool reference_is_b;
  int face;
  int edge;
};

/// Lanes 0, 1: the edge's first and second end at the side plane of the face's first corner; lanes
/// 2, 3: the same at its second corner's.
using Ends = hn::CappedTag<float, 4>;
using EndLanes = hn::Vec<Ends>;
using EndLanes2 = Lanes2<Ends>;
using EndInts = hn::Vec<DInt<Ends>>;

template <class T>
HWY_INLINE hn::Vec<hn::Rebind<T, Ends>> of_ends(T first, T second) {
  const hn::Rebind<T, Ends> d;
  return hn::InterleaveLower(d, hn::Set(d, first), hn::Set(d, second));
}

template <class T>
HWY_INLINE hn::Vec<hn::Rebind<T, Ends>> of_planes(T first, T second) {
  const hn::Rebind<T, Ends> d;
  return hn::ConcatLowerLower(d, hn::Set(d, second), hn::Set(d, first));
}

/// Half of a `FeaturePair`'s bytes: kinds are 0 for a vertex, 1 for a face.
constexpr std::uint64_t vertex_feature(int k) {
  return static_cast<std::uint64_t>(k) << 8;
}

constexpr std::uint64_t face_feature(int k) {
  return 1 | vertex_feature(k);
}

/// Two integers of 32 bits as one of 64: what is done to it, is done to both at once.
constexpr std::uint64_t both(std::uint64_t first, std::uint64_t second) {
  return first | second << 32;
}

/// The index of the corner after this one. Without a branch, which few polygons would take alike.
constexpr int next(int k, int count) {
  return (k + 1) & -static_cast<int>(k + 1 < count);
}

/// Every bit of the lanes whose number is below 0, where `do_signs_tell`. Where comparisons are
/// made into mask registers (AVX-512), they take five times as long, to and fro.
HWY_INLINE EndLanes below_zero(EndLanes v) {
  return hn::BitCast(Ends(), hn::BroadcastSignBit(hn::BitCast(DInt<Ends>(), v)));
}

/// `there` where the bits are set, else `here`.
HWY_INLINE EndLanes2 select_bits(EndLanes bits, const EndLanes2& there, const EndLanes2& here) {
  return {hn::IfVecThenElse(bits, there.x, here.x), hn::IfVecThenElse(bits, there.y, here.y)};
}

/// The incident edge as far as it has been clipped: lanes 0 and 1.
struct ClippedEdge {
  EndLanes2 position;
  EndInts features;
  EndLanes gone;    ///< every bit set: it misses the slab
  EndLanes offset;  ///< of the whole edge's ends from both planes
};

/// Every bit of the lanes where neither offset is above 0 and one is below it, where
/// `do_signs_tell`.
HWY_INLINE EndLanes is_behind(EndLanes offset0, EndLanes offset1) {
  const DInt<Ends> di;
  const EndInts greater = hn::BitCast(di, hn::Max(offset0, offset1));
  const EndInts less = hn::BitCast(di, hn::Min(offset0, offset1));
  // The bits of 0, less one, are those of a number below 0.
  const EndInts none_above = hn::Sub(greater, hn::Set(di, 1));
  return below_zero(hn::BitCast(Ends(), hn::And(none_above, less)));
}

HWY_INLINE ClippedEdge clip_to_slab(const EndLanes2& whole, const EndLanes2& inward,
                                    const EndLanes2& corner, EndLanes margin, EndInts end_features,
                                    EndInts crossing_features) {
  const DInt<Ends> di;
  const EndLanes offset = hn::Add(dot<Ends>(inward, subtract<Ends>(whole, corner)), margin);
  const EndLanes offset0 = hn::DupEven(offset);
  const EndLanes offset1 = hn::DupOdd(offset);
  const EndLanes gone = is_behind(offset0, offset1);

  const EndLanes share = hn::Div(offset0, hn::Sub(offset0, offset1));
  const EndLanes2 from{hn::DupEven(whole.x), hn::DupEven(whole.y)};
  const EndLanes2 to{hn::DupOdd(whole.x), hn::DupOdd(whole.y)};
  const EndLanes2 along = subtract<Ends>(to, from);
  const EndLanes2 crossing{hn::Add(from.x, hn::Mul(share, along.x)),
                           hn::Add(from.y, hn::Mul(share, along.y))};
  const EndLanes cut = below_zero(offset);

  // The second plane's lanes are brought beside the first's: it cuts last.
  const auto second = [](auto lanes) { return hn::Shuffle1032(lanes); };
  const EndLanes cut_second = second(cut);
  const EndLanes2 by_first = select_bits(cut, crossing, whole);
  const EndInts first_features =
      hn::IfVecThenElse(hn::BitCast(di, cut), crossing_features, end_features);
  return {select_bits(cut_second, {second(crossing.x), second(crossing.y)}, by_first),
          hn::IfVecThenElse(hn::BitCast(di, cut_second), second(crossing_features), first_features),
          hn::Or(gone, second(gone)), offset};
}

/// The face's normal turned to the left at its first corner's side plane, to the right at the
/// other.
HWY_INLINE EndLanes2 inward(float normal_x, float normal_y) {
  alignas(16) static constexpr float kTurn[2][4] = {{-0.0F, -0.0F, 0, 0}, {0, 0, -0.0F, -0.0F}};
  const Ends d;
  return {hn::Xor(hn::Load(d, kTurn[0]), hn::Set(d, normal_y)),
          hn::Xor(hn::Load(d, kTurn[1]), hn::Set(d, normal_x))};
}

HWY_INLINE ClippedEdge clip_to_slab(const PairFeatures& f, float total_radius) {
  const auto& [reference, incident, reference_is_b, face, edge] = f;
  const DInt<Ends> di;
  const hn::Repartition<std::uint64_t, DInt<Ends>> d_both;
  const auto next_place = [](int k) { return (k + 1) & (kMaxVertices - 1); };  // from 7 to 0
  const int second = next_place(edge);
  const int side = next_place(face);
  const auto vertices = [&](const ShapeRows& shape, int k) {
    return both(vertex_feature(k), vertex_feature(next(k, shape.count)));
  };
  const auto same = [](std::uint64_t feature) { return both(feature, feature); };
  const int shift = 16 * static_cast<int>(reference_is_b);
  const auto features = [&](std::uint64_t of_reference, std::uint64_t of_incident) {
    const auto pairs = of_reference << shift | of_incident << (16 - shift);
    return hn::BitCast(di, hn::Set(d_both, pairs));
  };
  const EndInts of_crossings = features(vertices(reference, face), same(face_feature(edge)));
  return clip_to_slab({of_ends(incident.x[edge], incident.x[second]),
                       of_ends(incident.y[edge], incident.y[second])},
                      inward(reference.normal_x[face], reference.normal_y[face]),
                      {of_planes(reference.x[face], reference.x[side]),
                       of_planes(reference.y[face], reference.y[side])},
                      hn::Set(Ends(), total_radius),
                      features(same(face_feature(face)), vertices(incident, edge)),
                      hn::InterleaveLower(di, of_crossings, of_crossings));
}

/// The ends that are kept behind the face.
struct KeptEnds {
  EndLanes depth;  ///< lanes 0, 1 and again 2, 3; negative infinity where an end is not kept
  EndLanes sum;    ///< of offsets and depths: not a number where one of them is not
};

/// Whether the signs by which ends were kept tell where they are: each offset and each depth is a
/// number, and none is -0. A total radius of -0 may make one. Where numbers below 2^-126 are taken
/// for zero, so may a small one: a length and a radius of 2^-102 or more differ by nothing, or by
/// 2^-126 at least.
HWY_INLINE bool do_signs_tell(const KeptEnds& kept, float total_radius) {
  return (total_radius >= 0x1p-102F || std::bit_cast<std::int32_t>(total_radius) == 0) &&
         hn::AllTrue(Ends(), hn::Eq(kept.sum, kept.sum));
}

/// Writes the manifold of the ends behind the face.
HWY_INLINE KeptEnds keep_behind_face(const PairFeatures& f, const ClippedEdge& edge,
                                     float total_radius, Manifold<float>& manifold) {
  static_assert(sizeof(Manifold<float>) == 48 && offsetof(Manifold<float>, normal) == 8 &&
                offsetof(Manifold<float>, points) == 16);
  const Ends d;
  const DInt<Ends> di;
  const EndLanes2 normal{hn::Set(d, f.reference.normal_x[f.face]),
                         hn::Set(d, f.reference.normal_y[f.face])};
  const EndLanes2 origin{hn::Set(d, f.reference.x[f.face]), hn::Set(d, f.reference.y[f.face])};
  const EndLanes separation = dot<Ends>(normal, subtract<Ends>(edge.position, origin));
  const EndLanes depth = hn::Sub(hn::Set(d, total_radius), separation);
  const EndLanes lost = hn::Or(edge.gone, below_zero(depth));
  const EndInts lost_first = hn::BitCast(di, lost);  // -1 or 0
  const EndInts lost_second = hn::Broadcast<1>(lost_first);

  float* const memory = reinterpret_cast<float*>(&manifold);
  const EndInts count = hn::Add(hn::Set(di, 2), hn::Add(lost_first, lost_second));
  const EndInts side = hn::Set(di, std::int32_t{f.reference_is_b});
  const EndInts head = hn::InterleaveLower(di, count, side);
  const EndInts turn = hn::ShiftLeft<31>(side);
  const EndLanes facing_b =
      hn::Xor(hn::InterleaveLower(d, normal.x, normal.y), hn::BitCast(d, turn));
  hn::StoreU(hn::ConcatLowerLower(d, facing_b, hn::BitCast(d, head)), d, memory);
  const EndLanes position = hn::InterleaveLower(d, edge.position.x, edge.position.y);
  const EndLanes rest = hn::InterleaveLower(d, depth, hn::BitCast(d, edge.features));
  const EndLanes first = hn::ConcatLowerLower(d, rest, position);
  const EndLanes second = hn::ConcatUpperUpper(d, rest, position);
  const EndLanes second_lost = hn::BitCast(d, lost_second);
  hn::StoreU(hn::IfVecThenElse(second_lost, first, second), d, memory + 4);  // the second leads
  hn::StoreU(first, d, memory + 8);

  const EndLanes none = hn::Set(d, -std::numeric_limits<float>::infinity());
  const EndLanes kept_depth = hn::IfVecThenElse(lost, none, depth);
  return {hn::ConcatLowerLower(d, kept_depth, kept_depth), hn::Add(edge.offset, depth)};
}

/// Whether `clipping::misses_deepest` might say so: it is asked where the roundoff of two corners
/// alone, no more than that of all of them, does not explain what is missing.
HWY_INLINE bool might_miss_deepest(const PairFeatures& f, float missing, float greatest) {
  const auto reach_of = [](const ShapeRows& shape, int corner) {
    return std::abs(shape.x[corner]) + std::abs(shape.y[corner]);
  };
  const float reach = reach_of(f.reference, f.face) + reach_of(f.incident, f.edge);
  constexpr float u = std::numeric_limits<float>::epsilon() / 2;
  const float lacking = std::min(missing, -greatest);
  return lacking > 4 * u * reach;
}

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // HWY_TARGET != HWY_SCALAR

#endif
