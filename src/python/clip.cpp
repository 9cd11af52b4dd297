#include <string_view>

#include "clipping/collide.hpp"
#include "own_colliders/own_colliders.hpp"
#include "python/shapes.hpp"

namespace manifuzz::python {
namespace {

/// One shape for all pairs, or one a pair.
template <class Scalar>
class ShapesOf {
 public:
  ShapesOf(std::span<const ShapeRecord<Scalar>> shapes, std::string_view array)
      : shapes_(shapes), array_(array) {
    if (shapes_.size() == 1) only_ = checked_shape(shapes_, 0, array_);
  }

  ConvexPolygon<Scalar> operator[](std::size_t index) const {
    return shapes_.size() == 1 ? only_ : checked_shape(shapes_, index, array_);
  }

 private:
  std::span<const ShapeRecord<Scalar>> shapes_;
  std::string_view array_;
  ConvexPolygon<Scalar> only_;
};

Manifold<float> collide(const ConvexPolygon<float>& a, const ConvexPolygon<float>& b,
                        const Pose<float>& pose_a, const Pose<float>& pose_b, float tie_bias) {
  return clipping::collide(a, b, relative_pose(pose_a, pose_b), tie_bias);
}

Manifold<double> collide(const ConvexPolygon<double>& a, const ConvexPolygon<double>& b,
                         const Pose<double>& pose_a, const Pose<double>& pose_b, double tie_bias) {
  const auto placed = clipping::placed_pair_scaled(a, b, pose_a, pose_b);
  Manifold<double> manifold =
      clipping::collide(placed.a, placed.b, relative_pose(placed.pose_a, placed.pose_b), tie_bias);
  for (auto& point : manifold.points) point.position *= placed.local_per_world;
  return manifold;
}

/// Pairs from `begin` to before `end`. `a` and `b` are one shape or as many as `poses`; `out` is as
/// long.
template <class Scalar>
void clip(const In<ShapeRecord<Scalar>>& a, const In<ShapeRecord<Scalar>>& b,
          const In<PosesRecord<Scalar>>& poses, Scalar tie_bias, const Out<Manifold<Scalar>>& out,
          std::size_t begin, std::size_t end) {
  const ShapesOf<Scalar> shapes_a(records<ShapeRecord<Scalar>>(a), "a");
  const ShapesOf<Scalar> shapes_b(records<ShapeRecord<Scalar>>(b), "b");
  const auto placed = records<PosesRecord<Scalar>>(poses);
  const auto manifolds = records<Manifold<Scalar>>(out);
  for (std::size_t i = begin; i < end; ++i) {
    manifolds[i] = collide(shapes_a[i], shapes_b[i], checked_pose(placed, i, Side::a),
                           checked_pose(placed, i, Side::b), tie_bias);
    clear_unspecified(manifolds[i]);
  }
}

/// Throws ValueError at the first shape that has a defect.
template <class Scalar>
void check_shapes(const In<ShapeRecord<Scalar>>& shapes, const std::string& array) {
  const auto all = records<ShapeRecord<Scalar>>(shapes);
  for (std::size_t i = 0; i < all.size(); ++i) checked_shape(all, i, array);
}

}  // namespace

void define_clip(nanobind::module_& module) {
  module.def("clip", clip<float>, Unlocked());
  module.def("clip64", clip<double>, Unlocked());
  module.def("check_shapes", check_shapes<float>, Unlocked());
  module.def("check_shapes64", check_shapes<double>, Unlocked());
}

}  // namespace manifuzz::python
