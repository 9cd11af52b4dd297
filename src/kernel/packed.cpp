#include "kernel/packed.hpp"

#include <algorithm>
#include <bit>

namespace manifuzz::kernel {

template <class Scalar>
void put_circles(const Shapes<Scalar>& shapes, const Placement<Scalar>& a,
                 const Placement<Scalar>& b, Row<Scalar>* rows, int column) {
  const auto put = [&](int row, const Vector2<Scalar>& v) {
    for (int axis = 0; axis < 2; ++axis) rows[row + axis].column[column] = v[axis];
  };
  put(kPoseA, a.pose.position);
  put(kPoseA + 2, a.pose.rotation);
  put(kPoseB, b.pose.position);
  put(kPoseB + 2, b.pose.rotation);
  put(kCentreA, shapes.polygon(a.shape).vertices[0]);
  put(kCentreB, shapes.polygon(b.shape).vertices[0]);
  rows[kRadiusA].column[column] = shapes.radius(a.shape);
  rows[kRadiusB].column[column] = shapes.radius(b.shape);
}

template <class Scalar>
PackedPairs<Scalar>::PackedPairs(const Shapes<Scalar>& shapes,
                                 std::span<const Placement<Scalar>> bodies,
                                 std::span<const BodyPair> pairs) {
  for (std::size_t first = 0; first < pairs.size(); first += kBlockPairs) {
    Columns columns;
    unsigned kinds = 0;  // a bit each
    for (int column = 0; column < kBlockPairs; ++column) {
      // The last block is filled up with its last pair.
      const BodyPair& pair = pairs[std::min(first + column, pairs.size() - 1)];
      columns.body[column][0] = &bodies[pair.a];
      columns.body[column][1] = &bodies[pair.b];
      kinds |= 1U << static_cast<unsigned>(
                   kind_of_group(shapes.group(bodies[pair.a].shape, bodies[pair.b].shape)));
    }
    Block block{rows_.size()};
    const bool is_of_one_kind = std::has_single_bit(kinds);
    if (is_of_one_kind) block.kind = static_cast<PairKind>(std::countr_zero(kinds));
    if (block.kind == PairKind::circles) {
      pack_circles(shapes, columns, block);
    } else {
      pack_polygons(shapes, columns, block);
      if (!is_of_one_kind) keep_round(shapes, columns, block);
    }
    blocks_.push_back(block);
  }
}

template <class Scalar>
void PackedPairs<Scalar>::pack_circles(const Shapes<Scalar>& shapes, const Columns& columns,
                                       Block& block) {
  rows_.resize(block.first_row + kCircleRows);
  for (int column = 0; column < kBlockPairs; ++column) {
    const auto& [a, b] = columns.body[column];
    put_circles(shapes, *a, *b, rows_.data() + block.first_row, column);
  }
}

/// In blocks of several kinds, round shapes are laid out, too: their columns are collided in vain,
/// and again one by one.
template <class Scalar>
void PackedPairs<Scalar>::pack_polygons(const Shapes<Scalar>& shapes, const Columns& columns,
                                        Block& block) {
  for (const auto& [a, b] : columns.body) {
    block.count_a = std::max(block.count_a, static_cast<int>(shapes.count(a->shape)));
    block.count_b = std::max(block.count_b, static_cast<int>(shapes.count(b->shape)));
  }
  rows_.resize(block.first_row + kCorners + polygon_rows(block.count_a) +
               polygon_rows(block.count_b) + kRadiusRows);
  Row<Scalar>* const rows = rows_.data() + block.first_row;
  for (int column = 0; column < kBlockPairs; ++column) {
    const auto& bodies = columns.body[column];
    rows[kTotalRadius].column[column] =
        shapes.radius(bodies[0]->shape) + shapes.radius(bodies[1]->shape);
    Row<Scalar>* corner = rows + kCorners;
    Row<Scalar>* const radii = rows_.data() + rows_.size() - kRadiusRows;
    for (const int side : {0, 1}) {
      const Placement<Scalar>& placed = *bodies[side];
      radii[side].column[column] = shapes.radius(placed.shape);
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
}

template <class Scalar>
void PackedPairs<Scalar>::keep_round(const Shapes<Scalar>& shapes, const Columns& columns,
                                     Block& block) {
  block.first_round = round_.size();
  for (int column = 0; column < kBlockPairs; ++column) {
    const auto& [a, b] = columns.body[column];
    const ConvexPolygon<Scalar>& shape_a = shapes.polygon(a->shape);
    const ConvexPolygon<Scalar>& shape_b = shapes.polygon(b->shape);
    if (!are_round(shape_a, shape_b)) continue;
    round_.push_back({column, shape_a, shape_b, relative_pose(a->pose, b->pose)});
  }
  block.round_count = round_.size() - block.first_round;
}

template <class Scalar>
Manifold<Scalar> manifold(const ManifoldBlock<Scalar>& block, int column) {
  Manifold<Scalar> result;
  result.count = static_cast<int>(block.count.column[column]);
  const auto features = [&](int i) {
    return std::bit_cast<FeaturePair>(static_cast<std::uint32_t>(block.features[i].column[column]));
  };
  if (result.count == 0) {
    result.points[0].depth = block.depth[0].column[column];
    result.points[0].features = features(0);
    return result;
  }
  result.reference = block.reference.column[column] == 0 ? Side::a : Side::b;
  result.normal = {block.normal[0].column[column], block.normal[1].column[column]};
  for (int i = 0; i < result.count; ++i) {
    ContactPoint<Scalar>& point = result.points[i];
    point.position = {block.position[i][0].column[column], block.position[i][1].column[column]};
    point.depth = block.depth[i].column[column];
    point.features = features(i);
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

template void put_circles(const Shapes<float>&, const Placement<float>&, const Placement<float>&,
                          Row<float>*, int);
template void put_circles(const Shapes<double>&, const Placement<double>&, const Placement<double>&,
                          Row<double>*, int);
template class PackedPairs<float>;
template class PackedPairs<double>;
template Manifold<float> manifold(const ManifoldBlock<float>&, int);
template Manifold<double> manifold(const ManifoldBlock<double>&, int);
template void put(const Manifold<float>&, ManifoldBlock<float>&, int);
template void put(const Manifold<double>&, ManifoldBlock<double>&, int);

}  // namespace manifuzz::kernel
