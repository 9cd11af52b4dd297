#include "oracle/libccd/ledger/polytope.hpp"

#include <algorithm>
#include <utility>

// libccd, ccd.c and polytope.c.

namespace manifuzz::ledger_of {
namespace {

constexpr double kEpaTolerance = 1e-4;

/// What is left of a face's edges but `without`, in the order of expandPolytope:
/// the first is at `from`. And the corner between them.
struct OtherEdges {
  CcdElement* first;
  CcdElement* second;
  CcdElement* corner;
};

OtherEdges edges_beside(const CcdElement& face, const CcdElement* without, const CcdElement* from,
                        const CcdElement* to) {
  auto [first, second, third] = face.edge;
  if (first == without) {
    first = third;
  } else if (second == without) {
    second = third;
  }
  auto [corner, other] = first->vertex;
  if (corner != from && other != from) {
    std::swap(first, second);
    if (corner == to) corner = other;
  } else if (corner == from) {
    corner = other;
  }
  return {first, second, corner};
}

/// The third corner of a face of which the first two are its first edge's.
CcdElement* third_corner(const CcdElement& first, const CcdElement& second) {
  CcdElement* const one = second.vertex[0];
  return one != first.vertex[0] && one != first.vertex[1] ? one : second.vertex[1];
}

std::vector<CcdVector> corners_of(const CcdElement& element) {
  if (element.type == 2) {
    return {element.vertex[0]->nearest.place, element.vertex[1]->nearest.place};
  }
  const auto& [first, second, third] = element.edge;
  return {first->vertex[0]->nearest.place, first->vertex[1]->nearest.place,
          third_corner(*first, *second)->nearest.place};
}

/// nextSupport has no end of its own: so many are taken for all, where they repeat themselves.
constexpr std::size_t kExpansionsMax = 1000;

/// Whether the second half of what was expanded, each by its corner, is one cycle again and again,
/// in which one may come twice.
bool is_going_round(const std::vector<std::vector<CcdVector>>& asked) {
  const auto half = asked.begin() + static_cast<std::ptrdiff_t>(asked.size() / 2);
  const auto left = std::distance(half, asked.end());
  for (std::ptrdiff_t period = 1; 4 * period <= left; ++period) {
    if (std::equal(half + period, asked.end(), half)) return true;
  }
  return false;
}

}  // namespace

void CcdPolytope::note(CcdElement* element) {
  const double square = element->nearest.square;
  const bool is_nearer =
      ccd_equal(nearest_square_, square) ? element->type < nearest_type_ : square < nearest_square_;
  if (!is_nearer) return;
  nearest_ = element;
  nearest_square_ = square;
  nearest_type_ = element->type;
}

const CcdElement* CcdPolytope::nearest() {
  if (nearest_ != nullptr) return nearest_;
  nearest_square_ = std::numeric_limits<double>::max();
  nearest_type_ = 3;
  for (const auto& elements : of_type_) std::ranges::for_each(elements, [&](auto* e) { note(e); });
  return nearest_;
}

CcdElement* CcdPolytope::add_vertex(const CcdVector& place) {
  CcdElement* const made = &store_.emplace_back();
  made->type = 1;
  made->nearest = {ccd_dot(place, place), place};
  of_type_[1].push_back(made);
  note(made);
  return made;
}

CcdElement* CcdPolytope::add_edge(CcdElement* from, CcdElement* to) {
  CcdElement* const made = &store_.emplace_back();
  made->type = 2;
  made->vertex = {from, to};
  made->nearest =
      nearest_of_segment<double>(CcdVector::Zero(), from->nearest.place, to->nearest.place);
  of_type_[2].push_back(made);
  note(made);
  return made;
}

void CcdPolytope::add_face(CcdElement* first, CcdElement* second, CcdElement* third) {
  CcdElement* const made = &store_.emplace_back();
  made->type = 3;
  made->edge = {first, second, third};
  made->nearest = nearest_of_triangle<double>(CcdVector::Zero(), first->vertex[0]->nearest.place,
                                              first->vertex[1]->nearest.place,
                                              third_corner(*first, *second)->nearest.place);
  for (CcdElement* edge : made->edge) edge->faces[edge->faces[0] == nullptr ? 0 : 1] = made;
  of_type_[3].push_back(made);
  note(made);
}

void CcdPolytope::drop_face(CcdElement* face) {
  for (CcdElement* edge : face->edge) {
    if (edge->faces[0] == face) edge->faces[0] = edge->faces[1];
    edge->faces[1] = nullptr;
  }
  std::erase(of_type_[3], face);
  if (nearest_ == face) nearest_ = nullptr;
}

void CcdPolytope::drop_edge(CcdElement* edge) {
  if (edge->faces[0] != nullptr) return;
  std::erase(of_type_[2], edge);
  if (nearest_ == edge) nearest_ = nullptr;
}

void CcdPolytope::note_expansion(const std::array<CcdElement*, 3>& triangle,
                                 const CcdElement& tip) {
  const auto& [a, b, c] = triangle;
  expanded_.push_back({a->nearest.place, b->nearest.place, c->nearest.place, tip.nearest.place});
}

void CcdPolytope::expand_edge(CcdElement* edge, const CcdVector& corner) {
  const auto [from, to] = edge->vertex;
  const auto [face, opposite] = edge->faces;
  if (face == nullptr) return;
  const OtherEdges one = edges_beside(*face, edge, from, to);
  const OtherEdges two =
      opposite == nullptr ? OtherEdges{} : edges_beside(*opposite, edge, to, from);
  CcdElement* const tip = add_vertex(corner);
  note_expansion({from, to, one.corner}, *tip);
  if (opposite != nullptr) note_expansion({from, to, two.corner}, *tip);
  drop_face(face);
  if (opposite != nullptr) {
    drop_face(opposite);
    drop_edge(edge);
  }
  CcdElement* const tip_to = add_edge(tip, to);
  CcdElement* const tip_from = add_edge(tip, from);
  CcdElement* const tip_one = add_edge(tip, one.corner);
  CcdElement* const tip_two = opposite == nullptr ? nullptr : add_edge(tip, two.corner);
  add_face(one.second, tip_to, tip_one);
  add_face(one.first, tip_one, tip_from);
  if (opposite == nullptr) return add_face(tip_to, tip_from, edge);
  add_face(two.second, tip_from, tip_two);
  add_face(tip_to, tip_two, two.first);
}

void CcdPolytope::expand_face(CcdElement* face, const CcdVector& corner) {
  auto [first, second, third] = face->edge;
  const auto [v0, v1] = first->vertex;
  auto [v2, v3] = second->vertex;
  if (v2 != v1 && v3 != v1) std::swap(second, third);
  if (v3 != v0 && v3 != v1) v2 = v3;
  drop_face(face);
  CcdElement* const tip = add_vertex(corner);
  note_expansion({v0, v1, v2}, *tip);
  const std::array sides{add_edge(tip, v0), add_edge(tip, v1), add_edge(tip, v2)};
  add_face(sides[0], sides[1], first);
  add_face(sides[1], sides[2], second);
  add_face(sides[2], sides[0], third);
}

CcdEnd CcdPolytope::end_at(const CcdElement& element, const CcdVector& corner,
                           double& beyond) const {
  const CcdNearest& at = element.nearest;
  beyond = ccd_dot(corner, at.place) - at.square;
  if (beyond < kEpaTolerance) return CcdEnd::along;
  if (element.type == 2) {
    beyond = nearest_of_segment<double>(corner, element.vertex[0]->nearest.place,
                                        element.vertex[1]->nearest.place, false)
                 .square;
  } else {
    const auto& [first, second, third] = element.edge;
    beyond = nearest_of_triangle<double>(corner, first->vertex[0]->nearest.place,
                                         first->vertex[1]->nearest.place,
                                         third_corner(*first, *second)->nearest.place, false)
                 .square;
  }
  return beyond < kEpaTolerance ? CcdEnd::near : CcdEnd::none;
}

CcdAnswer CcdPolytope::expanded() {
  std::vector<std::vector<CcdVector>> asked;
  for (std::size_t i = 0; i < kExpansionsMax; ++i) {
    const CcdElement element = *nearest();
    if (element.type == 1 || ccd_is_zero(element.nearest.square)) {
      return {CcdEnd::zero, element.nearest};
    }
    const CcdVector corner = prisms_->support(element.nearest.place);
    double beyond = 0;
    const CcdEnd end = end_at(element, corner, beyond);
    if (end != CcdEnd::none) return {end, element.nearest, beyond};
    asked.push_back(corners_of(element));
    asked.back().push_back(corner);
    if (element.type == 2) {
      expand_edge(nearest_, corner);
    } else {
      expand_face(nearest_, corner);
    }
  }
  return {is_going_round(asked) ? CcdEnd::endless : CcdEnd::none};
}

CcdAnswer CcdPolytope::expand_from(const CcdSimplex& simplex) {
  const bool is_expanded = simplex.size == 4   ? make_of_four(simplex)
                           : simplex.size == 3 ? make_of_three(simplex)
                                               : make_of_two(simplex);
  CcdAnswer answer = is_expanded ? expanded() : CcdAnswer{CcdEnd::touching, store_.back().nearest};
  answer.first = first_;
  answer.expanded = expanded_;
  return answer;
}

CcdAnswer ccd_penetration(const PairCase& pair) {
  const CcdPrisms prisms(pair, manifuzz_libccd::kHeightsOfGjk);
  CcdSimplex simplex;
  CcdVector dir(0, 0, 0);
  const auto support = [&](const CcdVector& along) { return prisms.support(along); };
  if (!is_intersection(support, simplex, dir)) return {};
  return CcdPolytope(prisms).expand_from(simplex);
}

bool is_ccd_apart_by_zero(const PairCase& pair) {
  const CcdPrisms prisms(pair, manifuzz_libccd::kHeightsOfGjk);
  CcdSimplex simplex;
  CcdVector dir(0, 0, 0);
  const auto support = [&](const CcdVector& along) { return prisms.support(along); };
  // Every other step than that of a flat tetrahedron leaves three corners at most.
  return !is_intersection(support, simplex, dir) &&
         (simplex.size == 4 || ccd_is_zero(ccd_dot(dir, dir)));
}

}  // namespace manifuzz::ledger_of
