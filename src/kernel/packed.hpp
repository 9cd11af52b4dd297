#pragma once

#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "geometry/convex_polygon.hpp"
#include "geometry/manifold.hpp"
#include "kernel/shapes.hpp"

// Pairs and manifolds in blocks of sixteen, one row a quantity and one column a pair, so that every
// instruction set reads and writes whole vectors.

namespace manifuzz::kernel {

/// How many pairs a block holds.
inline constexpr int kBlockPairs = 16;

/// One quantity of every pair of a block.
template <class Scalar>
struct alignas(64) Row {
  Scalar column[kBlockPairs];  ///< one a pair
};

/// An integer as wide as the scalar: it fills the same lanes.
template <class Scalar>
using LaneInt = std::conditional_t<sizeof(Scalar) == 4, std::int32_t, std::int64_t>;

/// The rows of a block of pairs before the polygons': each body's pose, the total radius, counts.
enum PairRow : int {
  kPoseA = 0,        ///< four rows: x and y of the position in the world, cos, sin
  kPoseB = 4,        ///< the same of B
  kTotalRadius = 8,  ///< a length
  kCountA = 9,       ///< of A's corners, 1 to 8, as a scalar
  kCountB = 10,      ///< of B's
  kCorners           ///< the first row of A's corners; B's follow
};

/// The rows of a block of circles, from `kPoseA` and `kPoseB` on.
enum CircleRow : int {
  kCentreA = 8,   ///< two rows: x and y, in A's frame
  kCentreB = 10,  ///< two rows: x and y, in B's frame
  kRadiusA = 12,  ///< a length
  kRadiusB = 13,  ///< a length
  kCircleRows     ///< how many rows there are
};

/// The rows of one corner, a scalar each.
inline constexpr int kCornerRows = kCornerScalars;

/// The rows of a polygon: its corners, and its first vertex again. In the columns of polygons with
/// fewer corners than the block's most, the first corner fills up.
constexpr int polygon_rows(int count_max) {
  return kCornerRows * count_max + 2;
}

/// The rows of both shapes' radii, behind their corners.
inline constexpr int kRadiusRows = 2;

/// A body: which shape, and where it stands. (cos, sin) is taken to be unit.
template <class Scalar>
struct Placement {
  std::uint32_t shape = 0;  ///< its index among the `Shapes`
  Pose<Scalar> pose;        ///< in the world
};

/// Two bodies, by their indices.
struct BodyPair {
  std::uint32_t a = 0;  ///< its manifold is in the frame of this one
  std::uint32_t b = 0;  ///< its normal points to this one
};

/// A pair of a block of which one shape is round, or both are.
template <class Scalar>
struct RoundPair {
  int column = 0;           ///< of its block
  ConvexPolygon<Scalar> a;  ///< in its own frame
  ConvexPolygon<Scalar> b;  ///< in its own frame
  Pose<Scalar> b_in_a;      ///< where B stands in A's frame
};

/// Puts two bodies that are circles into a column of a block of circles.
template <class Scalar>
void put_circles(const Shapes<Scalar>& shapes, const Placement<Scalar>& a,
                 const Placement<Scalar>& b, Row<Scalar>* rows, int column);

/// Sixteen pairs: `PairRow`s, then A's rows, then B's, then A's radii and B's; or, where all shapes
/// are circles, `CircleRow`s.
template <class Scalar>
struct PairBlock {
  const Row<Scalar>* rows = nullptr;         ///< all of them
  int count_a = 0;                           ///< the most corners of any A
  int count_b = 0;                           ///< the most corners of any B
  PairKind kind = PairKind::sharp;           ///< of all of them, or sharp
  std::span<const RoundPair<Scalar>> round;  ///< those of another kind
};

/// Many pairs, laid out for the kernel. Pairs of a group (`Shapes::group`) are best kept together:
/// a block takes as long as its largest polygons, and where its pairs are of several kinds, those
/// with a round shape are collided one by one.
template <class Scalar>
class PackedPairs {
 public:
  /// Lays out the pairs in this order, sixteen a block. Indices are not checked.
  PackedPairs(const Shapes<Scalar>& shapes, std::span<const Placement<Scalar>> bodies,
              std::span<const BodyPair> pairs);

  /// How many blocks the pairs fill; the last may be filled up with its last pair.
  std::size_t block_count() const { return blocks_.size(); }
  /// A block, for as long as this object lives.
  PairBlock<Scalar> block(std::size_t index) const {
    const Block& block = blocks_[index];
    return {rows_.data() + block.first_row, block.count_a, block.count_b, block.kind,
            std::span(round_).subspan(block.first_round, block.round_count)};
  }

 private:
  struct Block {
    std::size_t first_row = 0;
    int count_a = 0;
    int count_b = 0;
    PairKind kind = PairKind::sharp;
    std::size_t first_round = 0;
    std::size_t round_count = 0;
  };
  struct Columns {
    const Placement<Scalar>* body[kBlockPairs][2];  // A, B
  };

  void pack_circles(const Shapes<Scalar>& shapes, const Columns& columns, Block& block);
  void pack_polygons(const Shapes<Scalar>& shapes, const Columns& columns, Block& block);
  void keep_round(const Shapes<Scalar>& shapes, const Columns& columns, Block& block);

  std::vector<Block> blocks_;
  std::vector<Row<Scalar>> rows_;
  std::vector<RoundPair<Scalar>> round_;
};

/// The manifolds of a block of pairs, each in the frame of its A; units and signs are `Manifold`'s.
template <class Scalar>
struct ManifoldBlock {
  Row<LaneInt<Scalar>> count;        ///< of points: 0, 1 or 2
  Row<LaneInt<Scalar>> reference;    ///< 0: A's face, 1: B's
  Row<Scalar> normal[2];             ///< x, y
  Row<Scalar> position[2][2];        ///< of each point: x, y
  Row<Scalar> depth[2];              ///< of each point
  Row<LaneInt<Scalar>> features[2];  ///< of each point: a `FeaturePair`'s bytes
};

/// The manifold in one column of a block, 0 <= column < kBlockPairs. Without points, the first
/// one's depth is minus the gap between the polygons, or 0, and the rest of the column is
/// unspecified, but for its features where a batch wrote it (batch.hpp).
template <class Scalar>
Manifold<Scalar> manifold(const ManifoldBlock<Scalar>& block, int column);

/// Puts a manifold into one column of a block.
template <class Scalar>
void put(const Manifold<Scalar>& manifold, ManifoldBlock<Scalar>& block, int column);

}  // namespace manifuzz::kernel
