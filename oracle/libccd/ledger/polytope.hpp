#pragma once

#include <deque>
#include <vector>

#include "oracle/libccd/ledger/prisms.hpp"

namespace manifuzz::ledger_of {

/// Why the polytope of libccd's EPA is not expanded any more: nextSupport.
enum class CcdEnd {
  none,      ///< no intersection, or no end
  touching,  ///< simplexToPolytope takes the first simplex for the difference's boundary
  zero,      ///< the nearest element's square is 0
  along,     ///< the corner is no farther along it: dist - el->dist < epa_tolerance
  near,      ///< the corner is near to it: dist < epa_tolerance
  endless,   ///< it goes round in a cycle of elements and corners that it had
};

using CcdTetrahedron = std::array<CcdVector, 4>;

/// The nearest element, and how it was the last.
struct CcdAnswer {
  CcdEnd end = CcdEnd::none;
  CcdNearest nearest{};
  double beyond = 0;                       ///< what was compared with the tolerance
  std::vector<CcdTetrahedron> first{};     ///< what the polytope was at first
  std::vector<CcdTetrahedron> expanded{};  ///< each triangle that was replaced, and by which corner
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

  CcdAnswer expand_from(const CcdSimplex& simplex);

 private:
  CcdElement* add_vertex(const CcdVector& place);
  CcdElement* add_edge(CcdElement* from, CcdElement* to);
  void add_face(CcdElement* first, CcdElement* second, CcdElement* third);
  void drop_face(CcdElement* face);
  void drop_edge(CcdElement* edge);
  void note(CcdElement* element);
  const CcdElement* nearest();
  /// False where the simplex touches.
  bool make_of_two(const CcdSimplex& simplex);
  bool make_of_three(const CcdSimplex& simplex);
  bool make_of_four(CcdSimplex simplex);
  void note_expansion(const std::array<CcdElement*, 3>& triangle, const CcdElement& tip);
  void expand_edge(CcdElement* edge, const CcdVector& corner);
  void expand_face(CcdElement* face, const CcdVector& corner);
  CcdAnswer expanded();
  CcdEnd end_at(const CcdElement& element, const CcdVector& corner, double& beyond) const;

  const CcdPrisms* prisms_;
  std::deque<CcdElement> store_;
  std::array<std::vector<CcdElement*>, 4> of_type_;  ///< by type: 1 to 3
  CcdElement* nearest_ = nullptr;
  std::vector<CcdTetrahedron> first_;
  std::vector<CcdTetrahedron> expanded_;
  double nearest_square_ = std::numeric_limits<double>::max();
  int nearest_type_ = 3;
};

/// ccdGJKPenetration: none where GJK finds no intersection.
CcdAnswer ccd_penetration(const PairCase& pair);

/// Whether __ccdGJK finds no intersection by a square that is below CCD_EPS: a tetrahedron seems
/// flat to doSimplex4, or the next direction to be of no length.
bool is_ccd_apart_by_zero(const PairCase& pair);

}  // namespace manifuzz::ledger_of
