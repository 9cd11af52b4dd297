#include "scene/certificates.hpp"

#include "kernel/pair.hpp"
#include "scene/roundings.hpp"

namespace manifuzz::scene {
namespace {

/// What both separations may be off by, and both relative poses, as a share of the extent.
constexpr float kErrors = 2 * kSeparationError + 16 * kRoundoff;

}  // namespace

Certificate prove_separated(const ShapeTable& shapes, const kernel::Placement<float>& a,
                            const kernel::Placement<float>& b) {
  const kernel::PairSeparation found =
      kernel::separation(shapes.rows(a.shape), shapes.rows(b.shape), relative_pose(a.pose, b.pose));
  const bool is_a = found.face.side == Side::a;
  Certificate proof;
  proof.near = found.face.side;
  proof.far_in_near = is_a ? relative_pose(a.pose, b.pose) : relative_pose(b.pose, a.pose);
  const ShapeFacts& facts_a = shapes.facts(a.shape);
  const ShapeFacts& facts_b = shapes.facts(b.shape);
  const float extent = facts_a.reach + facts_b.reach + length_at_most(proof.far_in_near.position);
  const float total_radius = facts_a.radius + facts_b.radius;
  proof.margin = found.separation - total_radius - kErrors * (extent + total_radius) - kUnderflow;
  return proof;
}

}  // namespace manifuzz::scene
