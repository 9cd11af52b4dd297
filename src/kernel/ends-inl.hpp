// One pair's clips, both ends of the incident edge against both side planes at once
// (clipping/clip.hpp).

#if defined(MANIFUZZ_KERNEL_ENDS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_ENDS_INL
#undef MANIFUZZ_KERNEL_ENDS_INL
#else
#define MANIFUZZ_KERNEL_ENDS_INL
#endif

#include "geometry/manifold.hpp"
#include "kernel/faces-inl.hpp"

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

#if HWY_TARGET != HWY_SCALAR

/// Lanes 0, 1: the edge's first and second end at the side plane of the face's first corner; lanes
/// 2, 3: the same at its second corner's.
using Ends = hn::CappedTag<float, 4>;
using EndLanes = hn::Vec<Ends>;
using EndLanes2 = Lanes2<Ends>;
using EndInts = hn::Vec<DInt<Ends>>;

HWY_INLINE EndLanes of_ends(float first, float second) {
  return hn::InterleaveLower(Ends(), hn::Set(Ends(), first), hn::Set(Ends(), second));
}

HWY_INLINE EndInts of_ends(std::int32_t first, std::int32_t second) {
  const DInt<Ends> d;
  return hn::InterleaveLower(d, hn::Set(d, first), hn::Set(d, second));
}

HWY_INLINE EndLanes of_planes(float first, float second) {
  return hn::ConcatLowerLower(Ends(), hn::Set(Ends(), second), hn::Set(Ends(), first));
}

HWY_INLINE EndInts of_planes(std::int32_t first, std::int32_t second) {
  const DInt<Ends> d;
  return hn::ConcatLowerLower(d, hn::Set(d, second), hn::Set(d, first));
}

/// The features that make a contact point, as a `FeaturePair`'s bytes: kinds are 0 for a vertex, 1
/// for a face.
struct FeatureBytes {
  int reference_shift;
  int incident_shift;

  HWY_INLINE std::int32_t operator()(int reference_kind, int reference, int incident_kind,
                                     int incident) const {
    return (reference_kind | reference << 8) << reference_shift | (incident_kind | incident << 8)
                                                                      << incident_shift;
  }
};

/// The incident edge as far as it has been clipped: lanes 0 and 1.
struct ClippedEdge {
  EndLanes2 position;
  EndInts features;
  hn::Mask<Ends> is_gone;  ///< it misses the slab
};

HWY_INLINE ClippedEdge clip_to_slab(const EndLanes2& whole, const EndLanes2& inward,
                                    const EndLanes2& corner, EndLanes margin, EndInts end_features,
                                    EndInts crossing_features) {
  const Ends d;
  const DInt<Ends> di;
  const EndLanes zero = hn::Zero(d);
  const EndLanes offset = hn::Add(dot<Ends>(inward, subtract<Ends>(whole, corner)), margin);
  const EndLanes offset0 = hn::DupEven(offset);
  const EndLanes offset1 = hn::DupOdd(offset);
  const auto is_whole = hn::And(hn::Ge(offset0, zero), hn::Ge(offset1, zero));
  const auto is_behind = hn::And(hn::Le(offset0, zero), hn::Le(offset1, zero));
  const EndLanes gone = hn::VecFromMask(d, hn::AndNot(is_whole, is_behind));

  const EndLanes share = hn::Div(offset0, hn::Sub(offset0, offset1));
  const EndLanes2 from{hn::DupEven(whole.x), hn::DupEven(whole.y)};
  const EndLanes2 to{hn::DupOdd(whole.x), hn::DupOdd(whole.y)};
  const EndLanes2 along = subtract<Ends>(to, from);
  const EndLanes2 crossing{hn::Add(from.x, hn::Mul(share, along.x)),
                           hn::Add(from.y, hn::Mul(share, along.y))};
  const auto is_second_end = hn::RebindMask(d, hn::Eq(of_ends(0, 1), hn::Set(di, 1)));
  const auto is_cut = hn::AndNot(is_whole, hn::Xor(hn::Lt(offset0, zero), is_second_end));

  // The second plane's lanes are brought beside the first's: it cuts last.
  const auto second = [](auto lanes) { return hn::Shuffle1032(lanes); };
  const auto cut_second = hn::MaskFromVec(second(hn::VecFromMask(d, is_cut)));
  const EndLanes2 by_first = select<Ends>(is_cut, crossing, whole);
  const EndInts first_features =
      hn::IfThenElse(hn::RebindMask(di, is_cut), crossing_features, end_features);
  return {select<Ends>(cut_second, {second(crossing.x), second(crossing.y)}, by_first),
          hn::IfThenElse(hn::RebindMask(di, cut_second), second(crossing_features), first_features),
          hn::MaskFromVec(hn::Or(gone, second(gone)))};
}

HWY_INLINE ClippedEdge clip_to_slab(const PairFeatures& f, float total_radius) {
  const auto& [reference, incident, reference_is_b, face, edge] = f;
  const FeatureBytes bytes{reference_is_b ? 16 : 0, reference_is_b ? 0 : 16};
  const auto next = [](int k, int count) { return k + 1 < count ? k + 1 : 0; };
  const auto next_place = [](int k) { return (k + 1) % kMaxVertices; };  // past the last, the first
  const int second = next_place(edge);
  const int side = next_place(face);
  const float normal_x = reference.normal_x[face];
  const float normal_y = reference.normal_y[face];
  return clip_to_slab(
      {of_ends(incident.x[edge], incident.x[second]),
       of_ends(incident.y[edge], incident.y[second])},
      {of_planes(-normal_y, normal_y), of_planes(normal_x, -normal_x)},
      {of_planes(reference.x[face], reference.x[side]),
       of_planes(reference.y[face], reference.y[side])},
      hn::Set(Ends(), total_radius),
      of_ends(bytes(1, face, 0, edge), bytes(1, face, 0, next(edge, incident.count))),
      of_planes(bytes(0, face, 1, edge), bytes(0, next(face, reference.count), 1, edge)));
}

/// Writes the manifold of the ends behind the face; returns its greatest depth, the total radius
/// where there is none.
HWY_INLINE float keep_behind_face(const PairFeatures& f, const ClippedEdge& edge,
                                  float total_radius, Manifold<float>& manifold) {
  static_assert(sizeof(Manifold<float>) == 48 && offsetof(Manifold<float>, normal) == 8 &&
                offsetof(Manifold<float>, points) == 16);
  const Ends d;
  const DInt<Ends> di;
  const EndLanes2 normal{hn::Set(d, f.reference.normal_x[f.face]),
                         hn::Set(d, f.reference.normal_y[f.face])};
  const EndLanes2 origin{hn::Set(d, f.reference.x[f.face]), hn::Set(d, f.reference.y[f.face])};
  const EndLanes margin = hn::Set(d, total_radius);
  const EndLanes separation = dot<Ends>(normal, subtract<Ends>(edge.position, origin));
  const EndLanes depth = hn::Sub(margin, separation);
  const auto is_kept = hn::Not(hn::Or(edge.is_gone, hn::Gt(separation, margin)));
  const EndInts kept = hn::VecFromMask(di, hn::RebindMask(di, is_kept));  // -1 or 0
  const int keeps_first = -hn::GetLane(kept);
  const int keeps_second = -hn::GetLane(hn::DupOdd(kept));

  float* const memory = reinterpret_cast<float*>(&manifold);
  const EndInts head = of_ends(keeps_first + keeps_second, std::int32_t{f.reference_is_b});
  const EndInts turn = hn::Set(di, f.reference_is_b ? std::numeric_limits<std::int32_t>::min() : 0);
  const EndLanes facing_b =
      hn::Xor(hn::InterleaveLower(d, normal.x, normal.y), hn::BitCast(d, turn));
  hn::StoreU(hn::ConcatLowerLower(d, facing_b, hn::BitCast(d, head)), d, memory);
  const EndLanes position = hn::InterleaveLower(d, edge.position.x, edge.position.y);
  const EndLanes rest = hn::InterleaveLower(d, depth, hn::BitCast(d, edge.features));
  const EndLanes first = hn::ConcatLowerLower(d, rest, position);
  hn::StoreU(hn::ConcatUpperUpper(d, rest, position), d, memory + 4);  // the second end leads
  hn::StoreU(first, d, memory + 8);
  hn::StoreU(first, d, memory + 4 + 4 * keeps_second);  // unless it is not kept

  const EndLanes none = hn::Set(d, -std::numeric_limits<float>::infinity());
  const EndLanes kept_depth = hn::IfThenElse(is_kept, depth, none);
  const float deepest = hn::GetLane(hn::Max(kept_depth, hn::DupOdd(kept_depth)));
  return keeps_first + keeps_second > 0 ? deepest : total_radius;
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
