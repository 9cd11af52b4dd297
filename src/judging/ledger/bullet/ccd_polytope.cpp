#include "judging/ledger/bullet/ccd_polytope.hpp"

#include <algorithm>
#include <utility>

// libccd 2.1, ccd.c and polytope.c.

namespace manifuzz::ledger_of {
namespace {

constexpr double kEpaTolerance = 1e-4;

/// Of an edge of a face that is not `without`, those that are left, in the order of expandPolytope:
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

}  // namespace

CcdPrisms::Prism CcdPrisms::placed(const Body& body, double half_height) {
  Prism prism{{}, half_height};
  const Vector2<double> turn = body.pose.rotation.cast<double>();
  const Vector2<double> place = body.pose.position.cast<double>();
  for (int i = 0; i < body.polygon.count; ++i) {
    const Vector2<double> vertex = body.polygon.vertices[i].cast<double>();
    prism.corners.emplace_back(turn.x() * vertex.x() - turn.y() * vertex.y() + place.x(),
                               turn.y() * vertex.x() + turn.x() * vertex.y() + place.y());
  }
  return prism;
}

CcdPrisms::CcdPrisms(const PairCase& pair) {
  const auto reach = [](const Body& body) {
    double farthest = 0;
    for (int i = 0; i < body.polygon.count; ++i) {
      const Vector2<double> vertex = body.polygon.vertices[i].cast<double>();
      farthest = std::max(farthest, std::hypot(vertex.x(), vertex.y()));
    }
    return farthest;
  };
  const double both = reach(pair.a) + reach(pair.b);
  a_ = placed(pair.a, 2 * both);
  b_ = placed(pair.b, 1 * both);
}

CcdVector CcdPrisms::Prism::farthest(const CcdVector& along) const {
  std::size_t best = 0;
  const auto far = [&](std::size_t i) {
    return corners[i].x() * along.x() + corners[i].y() * along.y();
  };
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (far(i) > far(best)) best = i;
  }
  return {corners[best].x(), corners[best].y(), along.z() < 0 ? -half_height : half_height};
}

CcdVector CcdPrisms::support(const CcdVector& along) const {
  return a_.farthest(along) - b_.farthest(along * -1.0);
}

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

bool CcdPolytope::make_of_three(const CcdSimplex& simplex) {
  const auto& [a, b, c, unused] = simplex.corners;
  const CcdVector dir = ccd_cross<double>(b - a, c - a);
  const std::array tips{prisms_->support(dir), prisms_->support(dir * -1.0)};
  const auto is_flat = [&](const CcdVector& tip) {
    return ccd_is_zero(nearest_of_triangle<double>(tip, a, b, c, false).square);
  };
  const std::array base{add_vertex(a), add_vertex(b), add_vertex(c)};
  const bool is_touching = std::ranges::any_of(tips, is_flat);
  std::vector<CcdElement*> corners;
  if (!is_touching) corners = {add_vertex(tips[0]), add_vertex(tips[1])};
  const std::array around{add_edge(base[0], base[1]), add_edge(base[1], base[2]),
                          add_edge(base[2], base[0])};
  if (is_touching) {
    add_face(around[0], around[1], around[2]);
    nearest_ = store_.back().type == 3 ? &store_.back() : nullptr;
    return false;
  }
  std::vector<std::array<CcdElement*, 3>> sides;
  for (CcdElement* const tip : corners) {
    sides.push_back({add_edge(tip, base[0]), add_edge(tip, base[1]), add_edge(tip, base[2])});
  }
  for (const auto& side : sides) {
    for (std::size_t i = 0; i < 3; ++i) add_face(side[i], side[(i + 1) % 3], around[i]);
  }
  return true;
}

bool CcdPolytope::make_of_four(CcdSimplex simplex) {
  auto& ps = simplex.corners;
  const auto is_on = [&](std::size_t i, std::size_t j, std::size_t k) {
    return ccd_is_zero(
        nearest_of_triangle<double>(CcdVector::Zero(), ps[i], ps[j], ps[k], false).square);
  };
  // As there, what is set is what is looked at next.
  bool is_on_face = is_on(0, 1, 2);
  if (is_on(0, 2, 3)) is_on_face = true, ps[1] = ps[2], ps[2] = ps[3];
  if (is_on(0, 1, 3)) is_on_face = true, ps[2] = ps[3];
  if (is_on(1, 2, 3)) is_on_face = true, ps[0] = ps[1], ps[1] = ps[2], ps[2] = ps[3];
  if (is_on_face) return make_of_three(simplex);
  std::array<CcdElement*, 4> v{};
  for (std::size_t i = 0; i < 4; ++i) v[i] = add_vertex(ps[i]);
  const std::array e{add_edge(v[0], v[1]), add_edge(v[1], v[2]), add_edge(v[2], v[0]),
                     add_edge(v[3], v[0]), add_edge(v[3], v[1]), add_edge(v[3], v[2])};
  add_face(e[0], e[1], e[2]);
  add_face(e[3], e[4], e[0]);
  add_face(e[4], e[5], e[1]);
  add_face(e[5], e[3], e[2]);
  return true;
}

void CcdPolytope::expand_edge(CcdElement* edge, const CcdVector& corner) {
  const auto [from, to] = edge->vertex;
  const auto [face, opposite] = edge->faces;
  if (face == nullptr) return;
  const OtherEdges one = edges_beside(*face, edge, from, to);
  const OtherEdges two =
      opposite == nullptr ? OtherEdges{} : edges_beside(*opposite, edge, to, from);
  CcdElement* const tip = add_vertex(corner);
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

CcdAnswer CcdPolytope::expand_from(CcdSimplex simplex) {
  constexpr int expansions_max = 1000;
  if (simplex.size < 3) return {};
  if (!(simplex.size == 4 ? make_of_four(simplex) : make_of_three(simplex))) {
    return {CcdEnd::touching, store_.back().nearest};
  }
  for (int i = 0; i < expansions_max; ++i) {
    const CcdElement element = *nearest();
    if (element.type == 1 || ccd_is_zero(element.nearest.square)) {
      return {CcdEnd::zero, element.nearest};
    }
    const CcdVector corner = prisms_->support(element.nearest.place);
    double beyond = 0;
    const CcdEnd end = end_at(element, corner, beyond);
    if (end != CcdEnd::none) return {end, element.nearest, beyond};
    if (element.type == 2) {
      expand_edge(nearest_, corner);
    } else {
      expand_face(nearest_, corner);
    }
  }
  return {};
}

CcdAnswer ccd_penetration(const PairCase& pair) {
  const CcdPrisms prisms(pair);
  CcdSimplex simplex;
  const auto support = [&](const CcdVector& along) { return prisms.support(along); };
  if (!is_intersection(support, simplex)) return {};
  return CcdPolytope(prisms).expand_from(simplex);
}

}  // namespace manifuzz::ledger_of
