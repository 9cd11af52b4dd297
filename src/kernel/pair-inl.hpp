// One pair, a face a lane: places B, finds the greatest separation (clipping/separation.hpp) and
// the incident edge (clipping/features.hpp), and clips both its ends against both side planes at
// once (clipping/clip.hpp).

#if defined(MANIFUZZ_KERNEL_PAIR_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef MANIFUZZ_KERNEL_PAIR_INL
#undef MANIFUZZ_KERNEL_PAIR_INL
#else
#define MANIFUZZ_KERNEL_PAIR_INL
#endif

#include <limits>

#include "geometry/manifold.hpp"
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
  alignas(16) static constexpr std::int32_t kSecondEnds[4] = {0, -1, 0, -1};
  const auto is_second_end = hn::RebindMask(d, hn::MaskFromVec(hn::Load(di, kSecondEnds)));
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
  const EndInts kept_second = hn::DupOdd(kept);

  float* const memory = reinterpret_cast<float*>(&manifold);
  const EndInts count = hn::Neg(hn::Add(kept, kept_second));
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
  const auto leads = hn::RebindMask(d, hn::MaskFromVec(hn::Broadcast<1>(kept)));
  hn::StoreU(hn::IfThenElse(leads, second, first), d, memory + 4);  // the second end leads
  hn::StoreU(first, d, memory + 8);

  const EndLanes none = hn::Set(d, -std::numeric_limits<float>::infinity());
  const EndLanes kept_depth = hn::IfThenElse(is_kept, depth, none);
  const EndLanes deepest = hn::Max(kept_depth, hn::DupOdd(kept_depth));
  return hn::GetLane(
      hn::IfThenElse(hn::RebindMask(d, hn::Eq(count, hn::Zero(di))), margin, deepest));
}

#endif  // HWY_TARGET != HWY_SCALAR

}  // namespace manifuzz::kernel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
