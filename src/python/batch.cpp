#include "kernel/batch.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "python/shapes.hpp"

namespace manifuzz::python {
namespace {

/// The shapes of a batch, laid out once.
template <class Scalar>
class LaidOut {
 public:
  explicit LaidOut(const In<ShapeRecord<Scalar>>& shapes) {
    const auto all = records<ShapeRecord<Scalar>>(shapes);
    for (std::size_t i = 0; i < all.size(); ++i) shapes_.add(checked_shape(all, i, "shapes"));
    size_ = all.size();
  }

  const kernel::Shapes<Scalar>& shapes() const { return shapes_; }
  std::size_t size() const { return size_; }

 private:
  kernel::Shapes<Scalar> shapes_;
  std::size_t size_ = 0;
};

/// So many pairs at a time that their manifolds are still near when they are looked at again, and
/// that few are left over in batches that are not full.
constexpr std::size_t kPairsAtATime = 16384;

/// Looks at all before it looks for one that is wrong, without a branch each.
template <class Scalar>
void expect_bodies(std::span<const kernel::Placement<Scalar>> bodies, std::size_t shapes) {
  bool are_valid = true;
  for (const auto& [shape, pose] : bodies) {
    const Scalar sum = pose.position.x() + pose.position.y();
    are_valid &= shape < shapes;
    are_valid &= sum - sum == 0;
    are_valid &= is_unit_rotation(pose.rotation);
  }
  for (std::size_t i = 0; !are_valid && i < bodies.size(); ++i) {
    if (bodies[i].shape >= shapes) {
      throw nanobind::value_error(
          fmt::format("bodies[{}]: shape {}, of {} shapes; they are counted from 0", i,
                      bodies[i].shape, shapes)
              .c_str());
    }
    expect_pose(bodies[i].pose, "bodies", i);
  }
}

void expect_pairs(std::span<const kernel::BodyPair> pairs, std::size_t bodies) {
  std::uint32_t most = 0;
  for (const auto& pair : pairs) most = std::max(most, std::max(pair.a, pair.b));
  if (pairs.empty() || most < bodies) return;
  const auto found = std::ranges::find_if(
      pairs, [bodies](const kernel::BodyPair& pair) { return std::max(pair.a, pair.b) >= bodies; });
  throw nanobind::value_error(
      fmt::format("pairs[{}]: ({}, {}), of {} bodies; they are counted from 0",
                  found - pairs.begin(), found->a, found->b, bodies)
          .c_str());
}

template <class Scalar>
void batch(const LaidOut<Scalar>& shapes, const In<kernel::Placement<Scalar>>& bodies,
           const In<kernel::BodyPair>& pairs, Scalar tie_bias, const Out<Manifold<Scalar>>& out) {
  const auto placed = records<kernel::Placement<Scalar>>(bodies);
  const auto wanted = records<kernel::BodyPair>(pairs);
  const auto manifolds = records<Manifold<Scalar>>(out);
  expect_bodies(placed, shapes.size());
  expect_pairs(wanted, placed.size());
  for (std::size_t begin = 0; begin < wanted.size(); begin += kPairsAtATime) {
    const std::size_t count = std::min(kPairsAtATime, wanted.size() - begin);
    const auto some = manifolds.subspan(begin, count);
    kernel::collide_pairs(shapes.shapes(), placed, wanted.subspan(begin, count), tie_bias, some);
    for (auto& manifold : some) clear_unspecified(manifold);
  }
}

template <class Scalar>
void define(nanobind::module_& module, const char* laid_out) {
  nanobind::class_<LaidOut<Scalar>>(module, laid_out)
      .def(nanobind::init<const In<ShapeRecord<Scalar>>&>())
      .def("__len__", &LaidOut<Scalar>::size);
  module.def("batch", batch<Scalar>, Unlocked());
}

}  // namespace

void define_batch(nanobind::module_& module) {
  define<float>(module, "LaidOut32");
  define<double>(module, "LaidOut64");
}

}  // namespace manifuzz::python
