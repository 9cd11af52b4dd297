#include "kernel/packed.hpp"

#include <algorithm>
#include <bit>

namespace manifuzz::kernel {

template <class Scalar>
PackedPairs<Scalar>::PackedPairs(const Shapes<Scalar>& shapes,
                                 std::span<const Placement<Scalar>> bodies,
                                 std::span<const BodyPair> pairs) {
  for (std::size_t first = 0; first < pairs.size(); first += kBlockPairs) {
    // The last block is filled up with its last pair.
    const auto body = [&](int side, int column) -> const Placement<Scalar>& {
      const BodyPair& pair = pairs[std::min(first + column, pairs.size() - 1)];
      return bodies[side == 0 ? pair.a : pair.b];
    };
    Block block{rows_.size()};
    for (int column = 0; column < kBlockPairs; ++column) {
      const auto count = [&](int side) {
        return static_cast<int>(shapes.count(body(side, column).shape));
      };
      block.count_a = std::max(block.count_a, count(0));
      block.count_b = std::max(block.count_b, count(1));
    }
    rows_.resize(block.first_row + kCorners + polygon_rows(block.count_a) +
                 polygon_rows(block.count_b));
    Row<Scalar>* const rows = rows_.data() + block.first_row;
    for (int column = 0; column < kBlockPairs; ++column) {
      rows[kTotalRadius].column[column] =
          shapes.radius(body(0, column).shape) + shapes.radius(body(1, column).shape);
      Row<Scalar>* corner = rows + kCorners;
      for (const int side : {0, 1}) {
        const Placement<Scalar>& placed = body(side, column);
        Row<Scalar>* const pose = rows + (side == 0 ? kPoseA : kPoseB);
        for (int axis = 0; axis < 2; ++axis) {
          pose[axis].column[column] = placed.pose.position[axis];
          pose[2 + axis].column[column] = placed.pose.rotation[axis];
        }
        rows[kCountA + side].column[column] = static_cast<Scalar>(shapes.count(placed.shape));
        const ShapeCorners<Scalar>& shape = shapes.corners(placed.shape);
        const int scalars = kCornerRows * (side == 0 ? block.count_a : block.count_b);
        for (int i = 0; i < scalars; ++i, ++corner) corner->column[column] = shape.scalars[i];
        for (int axis = 0; axis < 2; ++axis, ++corner) {
          corner->column[column] = shape.scalars[axis];
        }
      }
    }
    blocks_.push_back(block);
  }
}

template <class Scalar>
Manifold<Scalar> manifold(const ManifoldBlock<Scalar>& block, int column) {
  Manifold<Scalar> result;
  result.count = static_cast<int>(block.count.column[column]);
  if (result.count == 0) {
    result.points[0].depth = block.depth[0].column[column];
    return result;
  }
  result.reference = block.reference.column[column] == 0 ? Side::a : Side::b;
  result.normal = {block.normal[0].column[column], block.normal[1].column[column]};
  for (int i = 0; i < result.count; ++i) {
    ContactPoint<Scalar>& point = result.points[i];
    point.position = {block.position[i][0].column[column], block.position[i][1].column[column]};
    point.depth = block.depth[i].column[column];
    const auto features = static_cast<std::uint32_t>(block.features[i].column[column]);
    point.features = std::bit_cast<FeaturePair>(features);
  }
  return result;
}

template <class Scalar>
void put(const Manifold<Scalar>& manifold, ManifoldBlock<Scalar>& block, int column) {
  block.count.column[column] = manifold.count;
  block.reference.column[column] = manifold.reference == Side::a ? 0 : 1;
  for (int axis = 0; axis < 2; ++axis) {
    block.normal[axis].column[column] = manifold.normal[axis];
    for (int i = 0; i < manifold.count; ++i) {
      block.position[i][axis].column[column] = manifold.points[i].position[axis];
    }
  }
  for (int i = 0; i < manifold.count; ++i) {
    block.depth[i].column[column] = manifold.points[i].depth;
    block.features[i].column[column] = std::bit_cast<std::int32_t>(manifold.points[i].features);
  }
}

template class PackedPairs<float>;
template class PackedPairs<double>;
template Manifold<float> manifold(const ManifoldBlock<float>&, int);
template Manifold<double> manifold(const ManifoldBlock<double>&, int);
template void put(const Manifold<float>&, ManifoldBlock<float>&, int);
template void put(const Manifold<double>&, ManifoldBlock<double>&, int);

}  // namespace manifuzz::kernel
