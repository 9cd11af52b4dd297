#include <algorithm>
#include <limits>

#include "judging/ledger/box2d/epsilon_deviations.hpp"
#include "judging/ledger/npm/npm_deviations.hpp"

// @box2d/core, Box2D 2.4 in TypeScript.

namespace manifuzz {
namespace {

constexpr double kEpsilonOfBox2dCore = 1e-5;  // b2_common.js: b2_epsilon

/// The answer with the clip's features of B, by whose features of A its points are known.
Manifold<double> with_features_of_b(Manifold<double> manifold, const exact::Clip& clip) {
  for (int i = 0; i < manifold.count; ++i) {
    FeaturePair& features = manifold.points[i].features;
    for (const exact::ClipPoint& point : points_of(clip)) {
      if (point.features.a == features.a) features.b = point.features.b;
    }
  }
  return manifold;
}

/// Whether the answer is what such a face makes: its normal as long as it is, by which b2Dot makes
/// separations shorter, and b2WorldManifold once more, twice.
bool is_of_short_face(const Deviation& d, const exact::RoughPolygon& on, exact::FaceOf face) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const exact::Truth& truth = *d.right.truth;
  const PairCase& pair = d.right.pair();
  const Vector2<double> along = on.vertices[on.next(face.index)] - on.vertices[face.index];
  const double length = along.norm();
  if (length >= kEpsilonOfBox2dCore) return false;
  const double side = face.side == Side::a ? 1.0 : -1.0;
  // The length of a normal is the same in both frames.
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  const Vector2<double> normal = rotate<double>(turn, d.got.normal);
  // The face is a difference of two vertices, each rounded as normal_of_rounded_vertices has it.
  const double bound = d.right.bounds.normal * length + 7 * u * truth.extent();
  if ((normal - side * length * on.normals[face.index]).norm() > bound) return false;
  // (radii - length * height) * length^2, of a height down to the extent below the face.
  const double most =
      length * length * (total_radius(pair) + length * truth.extent()) + d.right.bounds.separation;
  return std::all_of(d.got.points.begin(), d.got.points.begin() + d.got.count,
                     [&](const ContactPoint<double>& point) { return point.depth <= most; });
}

}  // namespace

bool features_lost_by_two_assignments(const Deviation& d) {
  if (d.kind != Kind::features || d.got.reference != Side::b) return false;
  const auto is_lost = [](const ContactPoint<double>& point) {
    return point.features.b == point.features.a;
  };
  const auto begin = d.got.points.begin();
  return std::all_of(begin, begin + d.got.count, is_lost) &&
         std::ranges::any_of(d.right.candidates, [&](const exact::Clip* clip) {
           return mismatch(with_features_of_b(d.got, *clip), *clip, d.right).kind == Kind::none;
         });
}

bool normal_of_short_face(const Deviation& d) {
  if (d.got.count == 0) return false;
  const exact::StoredPair& stored = d.right.truth->stored();
  const exact::RoughPair placed = exact::place_roughly(stored);
  return std::ranges::any_of(exact::all_faces(stored), [&](const exact::FaceOf& face) {
    return is_of_short_face(d, placed[face.side], face);
  });
}

bool axis_within_box2d_core_epsilon(const Deviation& d) {
  return ledger_of::is_axis_within(d, kEpsilonOfBox2dCore);
}

bool face_within_box2d_core_epsilon(const Deviation& d) {
  return ledger_of::is_face_within(d, kEpsilonOfBox2dCore);
}

}  // namespace manifuzz
