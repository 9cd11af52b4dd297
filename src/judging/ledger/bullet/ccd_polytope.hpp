#pragma once

#include <deque>
#include <vector>

#include "geometry/pair_case.hpp"
#include "judging/ledger/bullet/ccd_simplex.hpp"

namespace manifuzz::ledger_of {

/// Why the polytope of libccd's EPA is not expanded any more: nextSupport.
enum class CcdEnd {
  none,      ///< no intersection, or no end
  touching,  ///< simplexToPolytope takes the first simplex for the difference's boundary
  zero,      ///< the nearest element's square is 0
  along,     ///< the corner is no farther along it: dist - el->dist < epa_tolerance
  near,      ///< the corner is near to it: dist < epa_tolerance
};

/// The nearest element, and how it was the last.
struct CcdAnswer {
  CcdEnd end = CcdEnd::none;
  CcdNearest nearest{};
  double beyond = 0;  ///< what was compared with the tolerance
};

/// The prisms of oracle/libccd, as ccdGJKPenetration is asked of them.
class CcdPrisms {
 public:
  explicit CcdPrisms(const PairCase& pair);

  /// __ccdSupport.
  CcdVector support(const CcdVector& along) const;

 private:
  struct Prism {
    std::vector<Vector2<double>> corners;
    double half_height = 0;
    CcdVector farthest(const CcdVector& along) const;
  };
  static Prism placed(const Body& body, double half_height);
  Prism a_, b_;
};

/// polytope.c: a vertex, an edge or a face.
struct CcdElement {
  int type = 0;
  CcdNearest nearest{};
  std::array<CcdElement*, 2> vertex{};
  std::array<CcdElement*, 2> faces{};
  std::array<CcdElement*, 3> edge{};
};

class CcdPolytope {
 public:
  explicit CcdPolytope(const CcdPrisms& prisms) : prisms_(&prisms) {}

  CcdAnswer expand_from(CcdSimplex simplex);

 private:
  CcdElement* add_vertex(const CcdVector& place);
  CcdElement* add_edge(CcdElement* from, CcdElement* to);
  void add_face(CcdElement* first, CcdElement* second, CcdElement* third);
  void drop_face(CcdElement* face);
  void drop_edge(CcdElement* edge);
  void note(CcdElement* element);
  const CcdElement* nearest();
  /// False where the simplex touches.
  bool make_of_three(const CcdSimplex& simplex);
  bool make_of_four(CcdSimplex simplex);
  void expand_edge(CcdElement* edge, const CcdVector& corner);
  void expand_face(CcdElement* face, const CcdVector& corner);
  CcdEnd end_at(const CcdElement& element, const CcdVector& corner, double& beyond) const;

  const CcdPrisms* prisms_;
  std::deque<CcdElement> store_;
  std::array<std::vector<CcdElement*>, 4> of_type_;  ///< by type: 1 to 3
  CcdElement* nearest_ = nullptr;
  double nearest_square_ = std::numeric_limits<double>::max();
  int nearest_type_ = 3;
};

/// ccdGJKPenetration: none where GJK finds no intersection, or the polytope starts from a segment.
CcdAnswer ccd_penetration(const PairCase& pair);

}  // namespace manifuzz::ledger_of
