#include <algorithm>
#include <limits>

#include "engines/engine.hpp"
#include "judging/faults/circle_faults.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/box2d/deviations.hpp"

// @box2d/core, Box2D 2.4 in TypeScript, whose other faults are Box2D's own.

namespace manifuzz {
namespace {

constexpr double kEpsilonOfBox2dCore = 1e-5;  // b2_common.js: b2_epsilon

bool are_features_lost(const Manifold<double>& got) {
  return got.count > 0 && got.reference == Side::b &&
         std::all_of(got.points.begin(), got.points.begin() + got.count,
                     [](const ContactPoint<double>& point) {
                       return point.features.b == point.features.a;
                     });
}

/// The answer, its lost features of B as the clip has them, by whose features of A its points are
/// known.
Manifold<double> with_features_of_b(Manifold<double> manifold, const exact::Clip& clip) {
  if (!are_features_lost(manifold)) return manifold;
  for (int i = 0; i < manifold.count; ++i) {
    FeaturePair& features = manifold.points[i].features;
    for (const exact::ClipPoint& point : points_of(clip)) {
      if (point.features.a == features.a) features.b = point.features.b;
    }
  }
  return manifold;
}

/// Whether a point of sharp polygons is a corner of the other polygon, or where the face's clip has
/// one, its side planes turned by so much.
bool is_place_of_clip(const Deviation& d, const exact::RoughPolygon& of, exact::FaceOf face,
                      double turned, const ContactPoint<double>& point) {
  const Vector2<double> turn = d.right.pair().a.pose.rotation.cast<double>();
  const Vector2<double> at = rotate<double>(turn, point.position);
  const auto is_near = [&](const Vector2<double>& place, double bound) {
    return (place - at).norm() <=
           bound + 2 * d.right.bounds.separation + turned * d.right.truth->extent();
  };
  if (std::any_of(of.vertices.begin(), of.vertices.begin() + of.count,
                  [&](const Vector2<double>& corner) { return is_near(corner, 0); })) {
    return true;
  }
  const auto clips = clips_within(*d.right.truth, face.side, d.right.bounds);
  return std::ranges::any_of(clips, [&](const exact::Clip* clip) {
    return clip->reference == face &&
           std::ranges::any_of(points_of(*clip), [&](const exact::ClipPoint& right) {
             return is_near(rotate<double>(turn, right.position()),
                            position_bound(d.right, *clip, right));
           });
  });
}

/// Whether the answer is what such a face makes: its normal as long as it is, by which b2Dot makes
/// separations shorter, and b2WorldManifold once more, twice.
bool is_of_short_face(const Deviation& d, const exact::RoughPair& placed, exact::FaceOf face) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  const exact::Truth& truth = *d.right.truth;
  const PairCase& pair = d.right.pair();
  const exact::RoughPolygon& on = placed[face.side];
  // In its polygon's own frame, as the engine has it: far from the origin no length is left.
  const auto& [own, pose] = truth.stored()[face.side];
  const Vector2<double> along = own.vertices[own.next(face.index)] - own.vertices[face.index];
  const double length = along.norm() * pose.rotation.cast<double>().norm();
  if (length >= kEpsilonOfBox2dCore) return false;
  const double side = face.side == Side::a ? 1.0 : -1.0;
  // The length of a normal is the same in both frames.
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  const Vector2<double> normal = rotate<double>(turn, d.got.normal);
  // The face is a difference of two vertices, each rounded as normal_of_rounded_vertices has it.
  const double rounded = 7 * u * truth.extent();
  const double bound = d.right.bounds.normal * length + rounded;
  if ((normal - side * length * on.normals[face.index]).norm() > bound) return false;
  // (radii - length * height) * length^2, of a height down to the extent below the face.
  const double most =
      length * length * (total_radius(pair) + length * truth.extent()) + d.right.bounds.separation;
  // With radii the side planes are off by them over the face's length, and cut elsewhere.
  const bool is_sharp = total_radius(pair) == 0;
  const exact::RoughPolygon& of = placed[other(face.side)];
  return std::all_of(d.got.points.begin(), d.got.points.begin() + d.got.count,
                     [&](const ContactPoint<double>& point) {
                       return point.depth <= most &&
                              (!is_sharp || is_place_of_clip(d, of, face, rounded / length, point));
                     });
}

/// B's face clips, and each point's feature of B is that of A; all else is right.
bool features_lost_by_two_assignments(const Deviation& d) {
  return d.kind == Kind::features && are_features_lost(d.got) &&
         std::ranges::any_of(d.right.candidates, [&](const exact::Clip* clip) {
           return mismatch(with_features_of_b(d.got, *clip), *clip, d.right).kind == Kind::none;
         });
}

/// A face shorter than 1e-5, whose direction is not normalised: the normal is as short
/// as the face, and depths are next to none.
bool normal_of_short_face(const Deviation& d) {
  if (d.got.count == 0) return false;
  const exact::StoredPair& stored = d.right.truth->stored();
  const exact::RoughPair placed = exact::place_roughly(stored);
  return std::ranges::any_of(exact::all_faces(stored), [&](const exact::FaceOf& face) {
    return is_of_short_face(d, placed, face);
  });
}

/// A circle whose centre is within 1e-5 of another's or of an edge's end: the normal
/// is the world's x axis.
bool axis_within_box2d_core_epsilon(const Deviation& d) {
  return ledger_of::is_axis_within(d, kEpsilonOfBox2dCore);
}

/// A circle whose centre is within 1e-5 of a polygon: the normal is a face's, beyond
/// its corner too.
bool face_within_box2d_core_epsilon(const Deviation& d) {
  return ledger_of::is_face_within(d, kEpsilonOfBox2dCore);
}

constexpr LedgerRow kBox2dCoreRows[] = {
    {"lost-features", features_lost_by_two_assignments},
    {"normal-of-short-face", normal_of_short_face},
    {"no-contact-under-bias", no_contact_under_bias},
    {"no-contact-on-tied-features", no_contact_on_tied_features},
    {"edge-slab-not-widened", edge_slab_not_widened},
    {"edge-hysteresis", edge_face_kept_by_hysteresis},
    {"axis-within-epsilon", axis_within_box2d_core_epsilon},
    {"face-within-epsilon", face_within_box2d_core_epsilon},
    {"circle-tied-faces", ledger_of::is_end_of_tied_face},
};

}  // namespace

Engine engine_box2d_core() {
  return {.name = "box2d-core", .ledger = {{"box2d-core", kBox2dCoreRows}}};
}

}  // namespace manifuzz
