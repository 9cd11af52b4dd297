#include "judging/compare.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "judging/manifold_error.hpp"

namespace manifuzz {
namespace {

bool misses_overlap(const Deviation& d) {
  return d.got.count == 0 && d.right.must_touch;
}

template <class Predicate>
bool any_candidate(const Deviation& d, const Predicate& predicate) {
  return std::ranges::any_of(d.right.candidates,
                             [&](const exact::Clip* clip) { return predicate(*clip); });
}

bool may_be_empty_from(const Deviation& d, Side side) {
  return any_candidate(d, [&](const exact::Clip& clip) {
    return clip.reference.side == side && may_be_empty(d.right, clip);
  });
}

/// The vertices in the world, from A's position.
std::vector<Vector2<double>> placed(const PairCase& pair, Side side) {
  std::vector<Vector2<double>> vertices;
  for (int i = 0; i < pair[side].polygon.count; ++i) {
    const exact::Point<double> at = exact::vertex<double>(pair, side, i);
    vertices.emplace_back(at.x, at.y);
  }
  return vertices;
}

/// B's vertices minus A's: the corners, and more, of what GJK walks on.
std::vector<Vector2<double>> differences(const PairCase& pair) {
  std::vector<Vector2<double>> all;
  for (const auto& b : placed(pair, Side::b)) {
    for (const auto& a : placed(pair, Side::a)) all.push_back(b - a);
  }
  return all;
}

/// The reference face as float colliders have it, in its polygon's own frame.
Vector2<float> float_face(const exact::Clip& clip) {
  const auto& [side, face] = clip.reference;
  const exact::StoredPolygon& polygon = (*clip.pair)[side].polygon;
  return polygon.vertices[polygon.next(face)].cast<float>() - polygon.vertices[face].cast<float>();
}

/// Whether one end of an incident edge is beside an end of the face by what float has no normal
/// number for.
bool is_beside_end(const exact::RoughPair& placed, exact::FaceOf face, int incident) {
  const exact::RoughPolygon& on = placed[face.side];
  const exact::RoughPolygon& of = placed[other(face.side)];
  const Vector2<double> along(-on.normals[face.index].y(), on.normals[face.index].x());
  for (const int end : {face.index, on.next(face.index)}) {
    for (const int vertex : {incident, of.next(incident)}) {
      const double margin = std::abs((of.vertices[vertex] - on.vertices[end]).dot(along));
      if (margin > 0 && margin <= double{std::numeric_limits<float>::min()}) return true;
    }
  }
  return false;
}

/// The same of any clip of a segment or capsule and a polygon, of which the bias may take one that
/// is not right.
bool is_edge_beside_end(const Deviation& d) {
  const PairCase& pair = d.right.pair();
  if (pair.a.polygon.count != 2 && pair.b.polygon.count != 2) return false;
  const exact::RoughPair placed = exact::place_roughly(d.right.truth->stored());
  for (const Side side : {Side::a, Side::b}) {
    for (int i = 0; i < pair[side].polygon.face_count(); ++i) {
      const exact::FaceOf face{side, i};
      const auto incident = d.right.truth->incident_edges(face, d.right.bounds.incident_dot);
      const auto is_beside = [&](int edge) { return is_beside_end(placed, face, edge); };
      if (std::ranges::any_of(incident, is_beside)) return true;
    }
  }
  return false;
}

double length_of(const PairCase& pair, exact::FaceOf face) {
  return std::sqrt(exact::square<double>(pair, face));
}

}  // namespace

bool no_contact_under_bias(const Deviation& d) {
  return misses_overlap(d) && d.right.truth->compare_lead_of_b(0) > 0 &&
         may_be_empty_from(d, Side::a);
}

bool no_contact_on_tied_features(const Deviation& d) {
  return misses_overlap(d) && (may_be_empty_from(d, Side::a) || may_be_empty_from(d, Side::b));
}

bool tiny_reference_face(const Deviation& d) {
  if (d.kind != Kind::normal && d.kind != Kind::missed_contact) return false;
  const double unresolved =
      std::max(d.right.bounds.separation, 2.0 * std::numeric_limits<float>::epsilon());
  return any_candidate(d, [&](const exact::Clip& clip) {
    return static_cast<double>(float_face(clip).norm()) <= unresolved;
  });
}

bool huge_reference_face(const Deviation& d) {
  if (d.kind != Kind::normal && d.kind != Kind::missed_contact) return false;
  return any_candidate(d, [](const exact::Clip& clip) {
    const Vector2<float> face = float_face(clip);
    return !std::isfinite(face.dot(face));
  });
}

bool crossing_underflows(const Deviation& d) {
  const auto underflows = [&](const exact::Clip& clip) {
    return std::ranges::any_of(points_of(clip), [&](const exact::ClipPoint& point) {
      return compare_margin(clip, point.end, std::numeric_limits<float>::min()) <= 0;
    });
  };
  return (misses_overlap(d) && any_candidate(d, underflows)) ||
         (d.kind == Kind::missed_contact && is_edge_beside_end(d));
}

bool edge_extended_to_slab(const Deviation& d) {
  const bool fits = d.kind == Kind::position || d.kind == Kind::depth || d.kind == Kind::count ||
                    d.kind == Kind::phantom_contact;
  const Bounds& bounds = d.right.bounds;
  const auto misses = [&](const exact::Clip* clip) {
    return compare_gap(*clip, -bounds.separation) > 0;
  };
  return fits && (std::ranges::any_of(clips_within(*d.right.truth, Side::a, bounds), misses) ||
                  std::ranges::any_of(clips_within(*d.right.truth, Side::b, bounds), misses));
}

bool incident_edge_unclipped(const Deviation& d) {
  constexpr double too_short = 1e-10;  // manifold_c.js: eps
  const bool fits = d.kind == Kind::position || d.kind == Kind::depth || d.kind == Kind::count;
  return fits && any_candidate(d, [](const exact::Clip& clip) {
           return clip.edge_length * clip.cosine <= too_short;
         });
}

bool normal_of_rounded_vertices(const Deviation& d) {
  constexpr double u = std::numeric_limits<double>::epsilon() / 2;
  if (d.kind != Kind::normal) return false;
  const PairCase& pair = d.right.pair();
  double reach = d.right.truth->extent();
  for (const Side side : {Side::a, Side::b}) {
    reach = std::max(reach, pair[side].pose.position.cast<double>().norm());
  }
  return any_candidate(d, [&](const exact::Clip& clip) {
    // Two vertices, each rounded by a rotation (2.42 u) and a sum (u), over the face's length.
    const double bound = d.right.bounds.normal + 7 * u * reach / length_of(pair, clip.reference);
    return is_near_normal(clip, d.got.normal, bound);
  });
}

bool corner_on_corner(const Deviation& d) {
  if (is_round(d.right.pair())) return false;
  const bool fits = d.kind == Kind::normal || d.kind == Kind::missed_contact;
  return fits &&
         std::ranges::any_of(differences(d.right.pair()), [&](const Vector2<double>& apart) {
           return apart.norm() <= d.right.bounds.separation;
         });
}

bool collinear_and_apart(const Deviation& d) {
  if (d.kind != Kind::phantom_contact || is_round(d.right.pair())) return false;
  const auto all = differences(d.right.pair());
  const double bound = 4 * d.right.bounds.separation;  // which the differences are rounded within
  return std::ranges::any_of(all, [&](const Vector2<double>& from) {
    return std::ranges::any_of(all, [&](const Vector2<double>& to) {
      const Vector2<double> along = to - from;
      const double length = along.norm();
      return length > bound && from.dot(along) >= 0 &&
             std::abs(from.x() * along.y() - from.y() * along.x()) <= bound * length;
    });
  });
}

bool neighbours_nearly_parallel(const Deviation& d) {
  if (is_round(d.right.pair())) return false;
  if (d.kind != Kind::count && d.kind != Kind::position && d.kind != Kind::missed_contact) {
    return false;
  }
  const PairCase& pair = d.right.pair();
  for (const Side side : {Side::a, Side::b}) {
    const ConvexPolygon<float>& polygon = pair[side].polygon;
    for (int i = 0; i < polygon.count; ++i) {
      const exact::FaceOf face{side, i};
      const exact::FaceOf next{side, polygon.next(i)};
      const double lengths = length_of(pair, face) * length_of(pair, next);
      const double dot =
          exact::dot(exact::direction<double>(pair, face), exact::direction<double>(pair, next));
      if (dot >= (1 - d.right.bounds.incident_dot) * lengths) return true;
    }
  }
  return false;
}

namespace {

/// Point by point, in order.
bool points_agree(const Manifold<double>& s, const Manifold<double>& o, double apart,
                  double deeper) {
  for (int i = 0; i < s.count; ++i) {
    const ContactPoint<double>& p = s.points[i];
    const ContactPoint<double>& q = o.points[i];
    if (!((p.position - q.position).norm() <= apart) || !(std::abs(p.depth - q.depth) <= deeper) ||
        p.features != q.features) {
      return false;
    }
  }
  return true;
}

bool plainly_agree(const exact::Truth& truth, const Declaration& of_subject,
                   const Manifold<double>& s, const Declaration& of_oracle,
                   const Manifold<double>& o) {
  if (s.count != o.count) return false;
  const Bounds for_subject = bounds(truth.pair(), of_subject, truth.extent());
  const Bounds for_oracle = bounds(truth.pair(), of_oracle, truth.extent());
  const Bounds& wider = for_subject.separation > for_oracle.separation ? for_subject : for_oracle;
  if (is_ill_posed(truth.size_at_least(), wider) && is_ill_posed(truth.size(), wider)) return false;
  if (s.count == 0) {
    return truth.compare_contact(-std::min(for_subject.separation, for_oracle.separation)) >= 0;
  }
  if (s.count < 0 || s.count > 2 || s.reference != o.reference || truth.compare_contact(0) > 0) {
    return false;
  }
  return (s.normal - o.normal).norm() <= for_subject.normal + for_oracle.normal &&
         points_agree(s, o, for_subject.position + for_oracle.position,
                      for_subject.separation + for_oracle.separation);
}

}  // namespace

bool plainly_agree(const exact::Truth& truth, const ColliderAnswer& subject,
                   const ColliderAnswer& oracle) {
  if (is_judged_by_curve(subject.declaration) || is_judged_by_curve(oracle.declaration)) {
    return false;
  }
  // Who gives no second point that the other gives is judged by its own policy.
  if (is_round(truth.pair()) &&
      subject.declaration.second_point != oracle.declaration.second_point) {
    return false;
  }
  if (used_by(subject.answer) != nullptr || used_by(oracle.answer) != nullptr) return false;
  const auto* const s = std::get_if<Manifold<double>>(&subject.answer);
  const auto* const o = std::get_if<Manifold<double>>(&oracle.answer);
  if (s && o) return plainly_agree(truth, subject.declaration, *s, oracle.declaration, *o);
  if (const auto* const p = std::get_if<PartialManifold>(&subject.answer); p && o) {
    return plainly_agree(truth, subject.declaration, completed(*p, truth.pair(), *o),
                         oracle.declaration, *o);
  }
  if (const auto* const p = std::get_if<PartialManifold>(&oracle.answer); p && s) {
    return plainly_agree(truth, subject.declaration, *s, oracle.declaration,
                         completed(*p, truth.pair(), *s));
  }
  return false;
}

bool agree_within_bounds(const Manifold<double>& subject, const Admissible& right_for_subject,
                         const Manifold<double>& oracle, const Admissible& right_for_oracle) {
  if (subject.count != oracle.count) return false;
  if (subject.count == 0) return true;
  return std::ranges::any_of(right_for_subject.candidates, [&](const exact::Clip* clip) {
    return mismatch(subject, *clip, right_for_subject).kind == Kind::none &&
           mismatch(oracle, *clip, right_for_oracle).kind == Kind::none;
  });
}

Mismatch difference(const Manifold<double>& subject, const Manifold<double>& oracle,
                    double from_contact) {
  if (subject.count == 0) return {Kind::missed_contact, from_contact};
  if (oracle.count == 0) return {Kind::phantom_contact, from_contact};
  double magnitude = 0;
  for (int i = 0; i < subject.count; ++i) {
    const auto& point = subject.points[i];
    const auto distance = [&](const auto& other) {
      return (point.position - other.position).norm();
    };
    const bool second = oracle.count > 1 && distance(oracle.points[1]) < distance(oracle.points[0]);
    const auto& nearest = oracle.points[second ? 1 : 0];
    magnitude = std::max({magnitude, distance(nearest), std::abs(point.depth - nearest.depth)});
  }
  if (subject.reference != oracle.reference || subject.normal != oracle.normal) {
    return {Kind::normal, magnitude};
  }
  if (subject.count != oracle.count) return {Kind::count, magnitude};
  return {Kind::position, magnitude};
}

}  // namespace manifuzz
