#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/faces.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <hwy/highway.h>

#include "kernel/lanes-inl.hpp"
#include "scene/faces.hpp"
#include "scene/lengths-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {

/// A lane a pair.
using Pairs = hn::CappedTag<float, kPairLanes>;
using Numbers = hn::Vec<Pairs>;

/// A lane a vertex.
using Vertices = hn::CappedTag<float, kMaxVertices>;

/// How far a separation may be from what the kernel makes of the same face, as a share of the
/// extent: what the kernel rounds, and what is rounded here (certificates.md, "A face that lay
/// between them").
constexpr float kError = kSeparationError + 11 * kRoundoff;

/// What is read of some pairs, an array each. N is the body that has the face, F the other.
struct Views {
  const float* pose[2][kPairLanes];          ///< of N and F: x, y, cos, sin
  const float* face[kPairLanes];             ///< the vertex that it begins with, and its normal
  const kernel::ShapeRows* far[kPairLanes];  ///< the shape of F
  HWY_ALIGN std::uint32_t face_bits[kPairLanes];
  HWY_ALIGN float paths[kPairLanes];  ///< the sum of both, as of what follows
  HWY_ALIGN float clearance[kPairLanes];
  HWY_ALIGN float clearance_now[kPairLanes];
};

HWY_INLINE void view(const FacedBodies& bodies, std::uint32_t a, std::uint32_t b, FaceBetween face,
                     std::size_t lane, Views& views) {
  const std::uint32_t swap = (a ^ b) & (0 - static_cast<std::uint32_t>(face.is_of_b()));
  const auto& [near, near_pose] = bodies.placements[a ^ swap];
  const auto& [far, far_pose] = bodies.placements[b ^ swap];
  views.pose[0][lane] = near_pose.position.data();
  views.pose[1][lane] = far_pose.position.data();
  views.face[lane] = bodies.corners[near].scalars.data() + kernel::kCornerScalars * face.index();
  views.far[lane] = &bodies.rows[far];
  __builtin_prefetch(views.face[lane]);
  __builtin_prefetch(views.far[lane]);
  views.face_bits[lane] = face.bits();
  views.paths[lane] = bodies.paths[a] + bodies.paths[b];
  views.clearance[lane] = bodies.facts[near].clearance + bodies.facts[far].clearance;
  views.clearance_now[lane] = bodies.facts[near].clearance_now + bodies.facts[far].clearance_now;
}

/// How far a shape reaches least along a direction in its own frame.
HWY_INLINE float least_along(const kernel::ShapeRows& shape, float x, float y) {
  const Vertices d;
  const auto along = [&](std::size_t first) {
    return hn::Add(hn::Mul(hn::Set(d, x), hn::Load(d, shape.x + first)),
                   hn::Mul(hn::Set(d, y), hn::Load(d, shape.y + first)));
  };
  auto least = along(0);
  for (std::size_t first = hn::Lanes(d); first < kMaxVertices; first += hn::Lanes(d)) {
    least = hn::Min(along(first), least);
  }
  return hn::GetLane(hn::MinOfLanes(d, least));
}

/// How far F's cores lie in front of the faces of the views from `first` on, and at least how far
/// the origins are from each other; lengths.
struct Separations {
  Numbers separation;
  Numbers distance;
};

/// min_j (R_F^T R_N n) . v_j - n . f - (R_N n) . (p_N - p_F), f being the face's first vertex.
HWY_INLINE Separations separations(const Views& views, std::size_t first) {
  using Vectors = kernel::HWY_NAMESPACE::Lanes2<Pairs>;
  using kernel::HWY_NAMESPACE::dot;
  using kernel::HWY_NAMESPACE::turned;
  const Pairs d;
  const auto load = [&](const float* const* from, Vectors(&two)[2]) {
    Numbers rows[4];
    kernel::HWY_NAMESPACE::load_rows(
        d, [&](std::size_t lane) { return from[first + lane]; }, rows);
    two[0] = {rows[0], rows[1]};
    two[1] = {rows[2], rows[3]};
  };
  Vectors near[2];  // position and rotation
  Vectors far[2];
  Vectors face[2];  // first vertex and normal
  load(views.pose[0], near);
  load(views.pose[1], far);
  load(views.face, face);
  const Vectors& normal = face[1];
  const Vectors turn = {dot(far[1], near[1]),
                        hn::Sub(hn::Mul(far[1].x, near[1].y), hn::Mul(far[1].y, near[1].x))};
  const Vectors in_far = turned<Pairs>(turn, normal);
  HWY_ALIGN float x[kPairLanes];
  HWY_ALIGN float y[kPairLanes];
  HWY_ALIGN float least[kPairLanes];
  hn::Store(in_far.x, d, x);
  hn::Store(in_far.y, d, y);
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    least[lane] = least_along(*views.far[first + lane], x[lane], y[lane]);
  }
  const Vectors apart = kernel::HWY_NAMESPACE::subtract<Pairs>(near[0], far[0]);
  const auto of_poses = dot<Pairs>(turned<Pairs>(near[1], normal), apart);
  const auto of_face = dot<Pairs>(normal, face[0]);
  return {hn::Sub(hn::Load(d, least), hn::Add(of_face, of_poses)), length_at_most(d, apart)};
}

/// What the views from `first` on prove, as `prove_by_faces` says it.
HWY_INLINE void prove(const Views& views, std::size_t first, std::uint32_t* known) {
  const Pairs d;
  const hn::RebindToUnsigned<Pairs> di;
  const Separations found = separations(views, first);
  const auto certain = hn::Sub(hn::Mul(hn::Set(d, kRoundDown), found.separation),
                               hn::Mul(hn::Set(d, kError), found.distance));
  const auto margin = hn::Sub(certain, hn::Load(d, views.clearance + first));
  const auto paths = hn::Add(hn::Load(d, views.paths + first), margin);
  // As `apart_until` has it; paths are normal floats, and so is a longer one.
  const auto until = hn::BitCast(di, hn::Mul(hn::Set(d, kPathShare), paths));
  const auto lower = hn::AndNot(hn::Set(di, FaceBetween::kBits),
                                hn::Sub(until, hn::Set(di, FaceBetween::kBits + 1)));
  const auto lasts = hn::RebindMask(di, hn::Gt(margin, hn::Zero(d)));
  const auto face = hn::Load(di, views.face_bits + first);
  const auto is_clear = hn::Gt(certain, hn::Load(d, views.clearance_now + first));
  const auto is_apart =
      hn::And(hn::RebindMask(di, is_clear), hn::TestBit(face, hn::Set(di, FaceBetween::kKnown)));
  const auto apart = hn::Or(hn::IfThenElseZero(lasts, lower), face);
  hn::StoreU(hn::IfThenElseZero(is_apart, apart), di, known + first);
}

void prove_by_faces(const FacedBodies& by_caller, const Queue& queue, std::size_t first,
                    std::size_t count, std::uint32_t* known) {
  const FacedBodies bodies = by_caller;  // nothing that is written changes it
  const std::uint32_t* const a = queue.a.data() + first;
  const std::uint32_t* const b = queue.b.data() + first;
  const std::uint32_t* const at = queue.at.data() + first;
  Views views;
  for (std::size_t i = 0; i < count; i += kPairLanes) {
    for (std::size_t lane = 0; lane < kPairLanes; ++lane) {
      const std::size_t k = std::min(i + lane, count - 1);
      view(bodies, a[k], b[k], FaceBetween(bodies.candidates[at[k]].known()), lane, views);
    }
    for (std::size_t lane = 0; lane < kPairLanes; lane += hn::Lanes(Pairs())) {
      prove(views, lane, known + i);
    }
  }
}

}  // namespace manifuzz::scene::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace manifuzz::scene {

HWY_EXPORT(prove_by_faces);

void prove_by_faces(const FacedBodies& bodies, const Queue& queue, std::size_t first,
                    std::size_t count, std::uint32_t* known) {
  HWY_DYNAMIC_DISPATCH(prove_by_faces)(bodies, queue, first, count, known);
}

}  // namespace manifuzz::scene
#endif
