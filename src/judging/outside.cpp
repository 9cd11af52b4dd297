#include "judging/outside.hpp"

namespace manifuzz {
namespace {

/// The features of the clip's point nearest to a reported one.
FeaturePair nearest_features(const exact::Clip& clip, const Vector2<double>& position) {
  const auto squared = [&](int i) {
    const Vector2<double> apart = clip.points[i].position() - position;
    return apart.dot(apart);
  };
  return clip.points[clip.count > 1 && squared(1) < squared(0) ? 1 : 0].features;
}

Manifold<double> as_the_clip_has_it(const OutsideManifold& given, const exact::Clip& clip) {
  Manifold<double> manifold = given.manifold;
  if (!given.names_reference) manifold.reference = clip.reference.side;
  for (int i = 0; i < manifold.count && !given.names_features; ++i) {
    manifold.points[i].features = nearest_features(clip, manifold.points[i].position);
  }
  order_points(manifold);
  return manifold;
}

}  // namespace

Manifold<double> completed(const OutsideManifold& given, const Admissible& right) {
  if (right.candidates.empty()) return given.manifold;
  for (const exact::Clip* clip : right.candidates) {
    const Manifold<double> manifold = as_the_clip_has_it(given, *clip);
    if (mismatch(manifold, *clip, right).kind == Kind::none) return manifold;
  }
  return as_the_clip_has_it(given, *right.candidates.front());
}

}  // namespace manifuzz
