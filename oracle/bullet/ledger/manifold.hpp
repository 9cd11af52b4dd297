#pragma once

#include <vector>

#include "oracle/bullet/ledger/prisms.hpp"

namespace manifuzz::ledger_of {

/// btManifoldPoint, and which query found it: 0 is the first, whose shapes are not turned.
struct BulletPoint {
  Space local_a{0, 0, 0};
  Space local_b{0, 0, 0};
  Space on_a{0, 0, 0};
  Space on_b{0, 0, 0};
  Space normal{0, 0, 0};
  float distance = 0;
  int query = 0;
};

/// btPersistentManifold of a pair, filled by btManifoldResult.
class BulletManifold {
 public:
  /// `breaking`: the distance up to which points are kept, and one takes another's place.
  BulletManifold(const BulletPair& pair, float breaking, bool does_replace = true)
      : pair_(&pair), breaking_(breaking), does_replace_(does_replace) {}

  void add(const Space& normal, const Space& on_b, float distance, int query);
  void refresh();

  std::vector<BulletPoint> points;

 private:
  std::vector<BulletPoint>::iterator near_to(const BulletPoint& point);
  bool is_broken(const BulletPoint& point) const;

  const BulletPair* pair_;
  float breaking_;
  bool does_replace_;
};

/// The deepest of the points that touch; null where none touches.
const BulletPoint* deepest_of(const std::vector<BulletPoint>& points);

}  // namespace manifuzz::ledger_of
