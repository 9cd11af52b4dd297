#include "exchange/reported_manifold.hpp"

namespace manifuzz {

PartialManifold in_frame_of_a(const ReportedManifold& reported, const Conventions& conventions,
                              const PairCase& pair) {
  PartialManifold result{.names_reference = reported.reference.has_value(),
                         .names_features = reported.count > 0,
                         .has_midpoints = conventions.has_midpoints};
  Manifold<double>& manifold = result.manifold;
  manifold.count = reported.count;
  if (manifold.count == 0) return result;
  manifold.reference = reported.reference.value_or(Side::a);
  manifold.normal = conventions.normal_in_a ? reported.normal : local_normal(pair, reported.normal);
  if (conventions.normal_from_b) manifold.normal = -manifold.normal;
  for (int i = 0; i < manifold.count; ++i) {
    const ReportedPoint& point = reported.points[i];
    manifold.points[i] = {point.local ? *point.local : to_local(pair.a.pose, point.world.value()),
                          point.depth, point.features.value_or(FeaturePair{})};
    result.names_features = result.names_features && point.features.has_value();
  }
  if (!conventions.is_ordered) order_points(manifold);
  return result;
}

}  // namespace manifuzz
