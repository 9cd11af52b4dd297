#pragma once

#include <vector>

#include "geometry/pair_case.hpp"
#include "oracle/libccd/ledger/simplex.hpp"

namespace manifuzz::ledger_of {

/// The prisms of oracle/libccd, in its own doubles.
class CcdPrisms {
 public:
  /// How far they go up and down, as shares of both reaches.
  struct Heights {
    double a = 0;
    double b = 0;
  };
  static constexpr Heights kOfGjk{2, 1};
  static constexpr Heights kOfMpr{16, 16};

  CcdPrisms(const PairCase& pair, const Heights& heights);

  /// __ccdSupport.
  CcdVector support(const CcdVector& along) const;
  /// The difference of both centres, as center gives them.
  CcdVector middle() const;

 private:
  struct Prism {
    std::vector<Vector2<double>> corners;
    double half_height = 0;
    CcdVector farthest(const CcdVector& along) const;
    CcdVector middle() const;
  };
  static Prism placed(const Body& body, double half_height);
  Prism a_, b_;
};

}  // namespace manifuzz::ledger_of
