#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "scene/faces.cpp"
#include <hwy/foreach_target.h>  // includes this file once more for every other target
// after foreach_target
#include <algorithm>
#include <hwy/highway.h>

#include "kernel/lanes-inl.hpp"
#include "scene/faces.hpp"

HWY_BEFORE_NAMESPACE();
namespace manifuzz::scene::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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

HWY_INLINE Numbers sum_of_products(Numbers a, Numbers b, Numbers c, Numbers e) {
  return hn::Add(hn::Mul(a, b), hn::Mul(c, e));
}

HWY_INLINE Numbers difference_of_products(Numbers a, Numbers b, Numbers c, Numbers e) {
  return hn::Sub(hn::Mul(a, b), hn::Mul(c, e));
}

/// How far F's cores lie in front of the faces of the views from `first` on, and at least how far
/// the origins are from each other; lengths.
struct Separations {
  Numbers separation;
  Numbers distance;
};

/// min_j (R_F^T R_N n) . v_j - n . f - (R_N n) . (p_N - p_F), f being the face's first vertex.
HWY_INLINE Separations separations(const Views& views, std::size_t first) {
  const Pairs d;
  const auto load = [&](const float* const* from, Numbers(&rows)[4]) {
    kernel::HWY_NAMESPACE::load_rows(
        d, [&](std::size_t lane) { return from[first + lane]; }, rows);
  };
  Numbers near[4];
  Numbers far[4];
  Numbers face[4];
  load(views.pose[0], near);
  load(views.pose[1], far);
  load(views.face, face);
  const auto& normal_x = face[2];
  const auto& normal_y = face[3];
  const auto cosine = sum_of_products(near[2], far[2], near[3], far[3]);
  const auto sine = difference_of_products(near[3], far[2], near[2], far[3]);
  HWY_ALIGN float x[kPairLanes];  // of the normal in F's frame
  HWY_ALIGN float y[kPairLanes];
  hn::Store(difference_of_products(cosine, normal_x, sine, normal_y), d, x);
  hn::Store(sum_of_products(sine, normal_x, cosine, normal_y), d, y);
  HWY_ALIGN float least[kPairLanes];
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
    least[lane] = least_along(*views.far[first + lane], x[lane], y[lane]);
  }
  const auto apart_x = hn::Sub(near[0], far[0]);
  const auto apart_y = hn::Sub(near[1], far[1]);
  const auto of_face = sum_of_products(normal_x, face[0], normal_y, face[1]);
  const auto in_world_x = difference_of_products(near[2], normal_x, near[3], normal_y);
  const auto in_world_y = sum_of_products(near[3], normal_x, near[2], normal_y);
  const auto of_poses = sum_of_products(in_world_x, apart_x, in_world_y, apart_y);
  const auto greater = hn::Max(hn::Abs(apart_x), hn::Abs(apart_y));
  const auto lesser = hn::Min(hn::Abs(apart_x), hn::Abs(apart_y));
  return {hn::Sub(hn::Load(d, least), hn::Add(of_face, of_poses)),
          hn::Add(greater, hn::Mul(hn::Set(d, kLesserSide), lesser))};
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
