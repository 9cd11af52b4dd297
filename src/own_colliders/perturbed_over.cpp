#include "methods/perturbed.hpp"
#include "own_colliders/detected.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz {
namespace {

/// The pair with B turned, A at the origin: rotations in the scale that they are stored in.
PairCase turned_pair(const PairCase& pair, const Pose<double>& b_in_a) {
  const Vector2<double> of_a = unit_direction(pair.a.pose.rotation.cast<double>());
  const double scale_of_b = pair.b.pose.rotation.cast<double>().norm();
  PairCase turned = pair;
  turned.a.pose.position = {0, 0};
  turned.b.pose = {rotate<double>(of_a, b_in_a.position).cast<float>(),
                   (scale_of_b * rotate<double>(of_a, b_in_a.rotation)).cast<float>()};
  return turned;
}

/// What a collider answers with as the contract has it: a point on B's core, of shapes without
/// radius.
Manifold<double> point_on_b(const PairCase& pair, const Declaration& declaration,
                            const Answer& answer) {
  Manifold<double> one;
  const auto found = own::detected(pair, declaration, answer);
  if (!found) return one;
  one.count = 1;
  one.normal = found->normal;
  one.points[0] = manifold_in(answer)->points[0];
  one.points[0].position = found->on_b;
  return one;
}

Answer perturbed_answers(const Collider& base, const PairCase& pair) {
  const auto placed = clipping::placed_pair<double>(pair);
  const Pose<double> b_in_a = relative_pose(placed.pose_a, placed.pose_b);
  bool is_first = true;
  std::optional<Answer> no_manifold;
  const auto detect = [&](const auto&, const auto&, const Pose<double>& q_in_p) {
    const PairCase asked = is_first ? pair : turned_pair(pair, q_in_p);
    is_first = false;
    const Answer answer = base.collide(asked);
    if (manifold_in(answer) == nullptr) no_manifold = answer;
    Manifold<double> one = point_on_b(asked, base.declaration, answer);
    one.points[0].position /= placed.local_per_world;
    return one;
  };
  // Turned poses are rounded to floats, whatever the collider computes in.
  constexpr double kFloatRoundings = 0x1p29;
  const double roundoff =
      kFloatRoundings * clipping::separation_roundoff(placed.a, transform(b_in_a, placed.b));
  Manifold<double> manifold =
      methods::contact_by_perturbing(placed.a, placed.b, b_in_a, detect, roundoff);
  if (no_manifold) return *no_manifold;
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].position *= placed.local_per_world;
  return manifold;
}

}  // namespace

Collider make_perturbed_over(const Collider& base) {
  Collider collider;
  collider.declaration = base.declaration;
  Declaration& declaration = collider.declaration;
  declaration.name = "perturbed+" + base.declaration.name;
  declaration.description =
      base.declaration.name + ", asked again with one shape turned a little each way";
  // Whatever the collider computes in, turned poses reach it as floats.
  declaration.scalar = ScalarType::float32;
  declaration.takes_radius = false;
  declaration.takes_round = false;
  declaration.min_vertices = kMinVertices;
  declaration.claims = Claims::manifold;
  declaration.clips = false;
  declaration.points = PointsAt::clip;
  declaration.shares_depth = false;
  declaration.one_point_enough = true;
  declaration.snippet.clear();
  collider.collide = [base](const PairCase& pair) -> Answer {
    if (is_round(pair)) return Unsupported{"takes no round shapes"};
    return perturbed_answers(base, pair);
  };
  collider.seconds_max = 3 * base.seconds_max;
  return collider;
}

}  // namespace manifuzz
