#include "hunting/rare_bugs.hpp"

#include <algorithm>
#include <cmath>

#include "judging/bounds.hpp"

namespace manifuzz::test {
namespace {

double radius(const BugView& view, Side side) {
  return static_cast<double>(view.shape(side).radius);
}

/// The share of the incident edge, from its nearer end, at which a side plane cuts it; 1 where none
/// does.
double crossing(const BugView& view) {
  const exact::Clip& clip = *view.clip;
  const double first = clip.along[0].value;
  const double whole = clip.along[1].value - first;
  double nearest = 1;
  for (int end = 0; end < 2; ++end) {
    if (!view.is_cut(end) || clip.misses()) continue;
    const double plane = clip.cuts[end] == exact::Cut::before ? 0 : clip.width.value;
    const double share = std::abs((plane - first) / whole);
    nearest = std::min({nearest, share, std::abs(1 - share)});
  }
  return nearest;
}

/// From the nearest end that is not cut to the nearest side plane, over the face's length.
double margin(const BugView& view) {
  const exact::Clip& clip = *view.clip;
  double nearest = 1;
  for (int end = 0; end < 2; ++end) {
    if (view.is_cut(end)) continue;
    const double along = clip.along[end].value;
    nearest = std::min({nearest, std::abs(along) / view.face_length,
                        std::abs(clip.width.value - along) / view.face_length});
  }
  return nearest;
}

double incident_over_reference(const BugView& view) {
  return view.clip->edge_length / view.face_length;
}

double lead_of_side(const BugView& view) {
  return view.truth.separation(view.reference) - view.truth.separation(other(view.reference.side));
}

/// Whether a climb over the reference side's faces can stop at another than the best.
bool has_local_maximum(const BugView& view) {
  const ConvexPolygon<float>& shape = view.shape(view.reference.side);
  const auto at = [&](int i) {
    return view.truth.separation(exact::FaceOf{view.reference.side, i});
  };
  for (int i = 0; i < shape.count; ++i) {
    if (i != view.reference.index && at(i) > at(shape.next(i)) && at(i) > at(shape.previous(i))) {
      return true;
    }
  }
  return false;
}

bool is_whole(float x) {
  return x == std::round(x);
}

bool is_turned_by_an_eighth(const Body& body) {
  return std::abs(body.pose.rotation.x()) == std::abs(body.pose.rotation.y());
}

bool is_turned_by_quarters(const Body& body) {
  return body.pose.rotation.x() == 0 || body.pose.rotation.y() == 0;
}

constexpr RareBug kRareBugs[] = {
    {"large_reference_radius", "an octagon's radius is over 1,000 times a triangle's, one end cut",
     true,
     [](const BugView& v) {
       const double of_b = radius(v, Side::b);
       return v.has_counts(8, 3) && of_b > 0 && radius(v, Side::a) > 1000 * of_b &&
              v.reference.side == Side::a && v.is_one_cut();
     }},
    {"counts_and_both_cut", "a heptagon's face, a pentagon's edge, both ends cut", true,
     [](const BugView& v) {
       return v.has_counts(7, 5) && v.reference.side == Side::a && v.are_both_cut();
     }},
    {"barely_in_and_deep", "one end within 1e-8 of a side plane, the other cut at over a third",
     true,
     [](const BugView& v) {
       return v.has_counts(5, 6) && v.is_one_cut() && margin(v) < 1e-8 && crossing(v) > 1.0 / 3;
     }},
    {"plane_beside_long_edge",
     "an octagon's edge, an end within 1e-6 of a plane, 100 times as long", true,
     [](const BugView& v) {
       return margin(v) < 1e-6 && incident_over_reference(v) > 100 &&
              v.shape(other(v.reference.side)).count == 8;
     }},
    {"octagons_last_face",
     "octagons, B's last face, A's first edge, one end cut, tilted below 1e-3", true,
     [](const BugView& v) {
       return v.has_counts(8, 8) && v.reference == exact::FaceOf{Side::b, 7} &&
              v.clip->incident == 0 && v.is_one_cut() && v.clip->tangent < 1e-3;
     }},
    {"triangle_and_octagon", "a triangle's last face, an octagon's last edge, both ends cut", true,
     [](const BugView& v) {
       return v.has_counts(3, 8) && v.reference == exact::FaceOf{Side::a, 2} &&
              v.clip->incident == 7 && v.are_both_cut();
     }},
    {"eighth_turn", "B, a heptagon, turned by exactly 45 degrees, A not, one end cut, B's face",
     true,
     [](const BugView& v) {
       return is_turned_by_an_eighth(v.pair.b) && v.shape(Side::b).count == 7 &&
              !is_turned_by_an_eighth(v.pair.a) && !is_turned_by_quarters(v.pair.a) &&
              v.is_one_cut() && v.reference.side == Side::b;
     }},
    {"lengths_alike", "face and edge as long but for 1e-7 to 1e-6, of unlike counts, tilted", true,
     [](const BugView& v) {
       const double off = std::abs(1 - incident_over_reference(v));
       return off > 1e-7 && off < 1e-6 && v.clip->tangent > 0.1 &&
              v.shape(Side::a).count != v.shape(Side::b).count;
     }},
    {"absolute_length",
     "deeper than a tenth of the size, and shallower than 2e-7, of 6 and 5 faces", true,
     [](const BugView& v) {
       return v.has_counts(6, 5) && v.depth > 0.1 * v.size && v.depth < 2e-7;
     }},
    {"equal_positions", "A's x is B's y, no whole number, both turned", true,
     [](const BugView& v) {
       return v.pair.a.pose.position.x() == v.pair.b.pose.position.y() &&
              !is_whole(v.pair.a.pose.position.x()) && !is_turned_by_quarters(v.pair.a) &&
              !is_turned_by_quarters(v.pair.b);
     }},
    {"vertex_equals_position", "A's first x is B's position's, no whole number, B of 6 or more",
     true,
     [](const BugView& v) {
       const float x = v.shape(Side::a).vertices[0].x();
       return x == v.pair.b.pose.position.x() && !is_whole(2 * x) && v.shape(Side::b).count >= 6;
     }},
    {"crossing_at_an_end", "an edge cut within 1e-6 of its end, 10 times as long, of 8 and 6 faces",
     true,
     [](const BugView& v) {
       return v.has_counts(8, 6) && crossing(v) < 1e-6 && v.clip->tangent > 0.01 &&
              incident_over_reference(v) > 10;
     }},
    {"climb_stops_short", "octagons, another local maximum, within 1e-9 of the best, but not equal",
     true,
     [](const BugView& v) {
       if (!v.has_counts(8, 8) || !has_local_maximum(v)) return false;
       double second = -std::numeric_limits<double>::infinity();
       for (int i = 0; i < v.shape(v.reference.side).count; ++i) {
         if (i == v.reference.index) continue;
         second = std::max(second, v.truth.separation(exact::FaceOf{v.reference.side, i}));
       }
       const double lead = v.truth.separation(v.reference) - second;
       return lead > 0 && lead < 1e-9 * v.size;
     }},
    {"indices_wrap", "the last face of a hexagon of A, the last edge of a heptagon, both ends cut",
     true,
     [](const BugView& v) {
       return v.has_counts(6, 7) && v.reference == exact::FaceOf{Side::a, 5} &&
              v.clip->incident == 6 && v.are_both_cut();
     }},
    {"nearly_parallel_sliver", "tilted by 1e-7 to 1e-6, one end cut, B thinner than 1%", true,
     [](const BugView& v) {
       return v.clip->tangent > 1e-7 && v.clip->tangent < 1e-6 && v.is_one_cut() &&
              v.shape(Side::b).count >= 3 && aspect_of(v.shape(Side::b)) < 0.01;
     }},
    {"sides_nearly_tie", "4 and 5 faces, unlike radii, a side leads by 0 to 1e-6, both ends cut",
     true,
     [](const BugView& v) {
       const double lead = lead_of_side(v);
       return v.has_counts(4, 5) && lead > 0 && lead < 1e-6 * v.size && v.are_both_cut() &&
              v.shape(Side::a).radius > 4 * v.shape(Side::b).radius;
     }},
    {"deep_on_a_short_face", "heptagons, deeper than 0.45 sizes on a face below 1% of the size",
     true,
     [](const BugView& v) {
       return v.has_counts(7, 7) && v.depth > 0.45 * v.size && v.face_length < 0.01 * v.size;
     }},
    {"far_and_both_cut", "an octagon over 2^20 sizes away, both ends of its edge cut", true,
     [](const BugView& v) {
       return v.shape(other(v.reference.side)).count == 8 && v.are_both_cut() &&
              v.pair.a.pose.position.cast<double>().norm() > 0x1p20 * v.size;
     }},
    {"parallel_with_large_radii",
     "an octagon, parallel, equal radii above a tenth of the size, cut", true,
     [](const BugView& v) {
       return v.clip->tangent == 0 && v.are_both_cut() && v.shape(Side::a).count == 8 &&
              v.shape(Side::a).radius == v.shape(Side::b).radius &&
              radius(v, Side::a) > 0.1 * v.size;
     }},
    {"just_touching_unlike_sizes", "within 1e-6 of touching, one shape 1,000 times as large", true,
     [](const BugView& v) {
       const double ratio = size(v.shape(Side::a)) / size(v.shape(Side::b));
       return v.depth < 1e-6 * v.size && (ratio > 1000 || ratio < 1e-3);
     }},
    {"exact_tie_of_sides", "a pentagon and a heptagon of unlike radii tie exactly, both ends cut",
     true,
     [](const BugView& v) {
       return v.has_counts(5, 7) && v.are_both_cut() && v.truth.compare_lead_of_b(0) == 0 &&
              v.shape(Side::a).radius != v.shape(Side::b).radius;
     }},
    {"plunging_slivers", "both thinner than 0.1%, at over 45 degrees, one end cut", true,
     [](const BugView& v) {
       return v.shape(Side::a).count >= 3 && v.shape(Side::b).count >= 3 && v.clip->tangent > 1 &&
              v.is_one_cut() && aspect_of(v.shape(Side::a)) < 1e-3 &&
              aspect_of(v.shape(Side::b)) < 1e-3;
     }},
    {"fat_capsule_on_octagon", "a capsule of a radius over 5,000 cores on an octagon's last face",
     true,
     [](const BugView& v) {
       return v.has_counts(2, 8) && v.reference == exact::FaceOf{Side::b, 7} &&
              radius(v, Side::a) > 5000 * core_size(v.shape(Side::a));
     }},
    {"circle_in_heptagon", "a circle's centre under the last face of a heptagon, half a size deep",
     false,
     [](const BugView& v) {
       return v.has_counts(7, 1) && v.reference == exact::FaceOf{Side::a, 6} &&
              v.depth - radius(v, Side::b) > 0.5 * v.size;
     }},
    {"tiny_and_large_skin", "A's round corners below 1e-6 of its core, B's radius above its core",
     true,
     [](const BugView& v) {
       const ConvexPolygon<float>& a = v.shape(Side::a);
       return a.count >= 3 && a.is_round() && a.radius > 0 &&
              radius(v, Side::a) < 1e-6 * core_size(a) &&
              radius(v, Side::b) > core_size(v.shape(Side::b)) && v.shape(Side::b).count >= 2;
     }},
    {"eighth_and_quarter", "A turned by exactly 45 degrees, B by quarters, both ends cut", true,
     [](const BugView& v) {
       return is_turned_by_an_eighth(v.pair.a) && is_turned_by_quarters(v.pair.b) &&
              v.are_both_cut();
     }},
};

}  // namespace

std::span<const RareBug> rare_bugs() {
  return kRareBugs;
}

std::uint64_t rare_bugs_met_by(const exact::Truth& truth) {
  if (!truth.has_faces() || truth.compare_contact(0) > 0) return 0;
  const PairCase& pair = truth.pair();
  const Bounds bounds = manifuzz::bounds(pair, {}, truth.extent());
  if (is_ill_posed(truth.size(), bounds)) return 0;
  BugView view{.pair = pair,
               .size = truth.size(),
               .depth = total_radius(pair) - truth.separation(),
               .reference = truth.greatest(),
               .truth = truth};
  const ConvexPolygon<float>& shape = pair[view.reference.side].polygon;
  view.face_length = (shape.vertices[shape.next(view.reference.index)].cast<double>() -
                      shape.vertices[view.reference.index].cast<double>())
                         .norm();
  if (truth.has_faces(other(view.reference.side))) {
    view.clip = &truth.clip(view.reference, truth.incident_edges(view.reference, 0).front());
  }
  std::uint64_t met = 0;
  for (std::size_t i = 0; i < std::size(kRareBugs); ++i) {
    const RareBug& bug = kRareBugs[i];
    if (bug.needs_clip && view.clip == nullptr) continue;
    if (bug.is_met(view)) met |= std::uint64_t{1} << i;
  }
  return met;
}

}  // namespace manifuzz::test
