#pragma once

#include <array>
#include <deque>

#include "oracle/bullet/ledger/prisms.hpp"

namespace manifuzz::ledger_of {

/// MinkowskiDiff of btGjkEpa2.cpp: the difference in A's frame.
class EpaDifference {
 public:
  /// With the margins, or without.
  EpaDifference(const BulletPair& pair, bool is_round);

  Space support_a(const Space& along) const { return support(*a_, along); }
  Space support_b(const Space& along) const;
  Space support(const Space& along) const { return support_a(along) - support_b(Space(-along)); }

 private:
  Space support(const BulletHull& hull, const Space& along) const {
    return is_round_ ? hull.farthest_of_round(along) : hull.farthest(along);
  }

  const BulletHull* a_;
  const BulletHull* b_;
  bool is_round_;
  BulletPlace to_b_{};  ///< m_toshape1
  BulletPlace to_a_{};  ///< m_toshape0
};

/// A corner of the difference, and the unit direction it is farthest along.
struct EpaCorner {
  Space d{0, 0, 0};
  Space w{0, 0, 0};
};

/// GJK of btGjkEpa2.cpp.
class EpaGjk {
 public:
  enum class Status { valid, inside, failed };
  struct Simplex {
    std::array<EpaCorner, 4> c{};
    std::array<float, 4> p{};
    int rank = 0;
  };

  explicit EpaGjk(const EpaDifference& difference) : difference_(&difference) {}

  Status evaluate(const Space& guess);
  /// Adds corners until the simplex has a volume.
  bool enclose_origin();
  EpaCorner corner_along(const Space& along) const;

  Simplex simplex;
  /// It ended as inside since the origin is nearer to the simplex than GJK_MIN_DISTANCE.
  bool is_near = false;
  static float determinant(const Space& a, const Space& b, const Space& c);

 private:
  void append(const Space& along);
  bool is_enclosed_with(const Space& along);
  /// One step: none where it ends there.
  bool reduce(Space& ray, Status& status);

  const EpaDifference* difference_;
};

}  // namespace manifuzz::ledger_of
