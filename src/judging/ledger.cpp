#include "judging/ledger.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

bool no_contact_under_bias(const Deviation& d) {
  return misses_overlap(d) && d.right.truth->compare_lead_of_b(0) > 0 &&
         may_be_empty_from(d, Side::a);
}

bool no_contact_on_tied_features(const Deviation& d) {
  return misses_overlap(d) && (may_be_empty_from(d, Side::a) || may_be_empty_from(d, Side::b));
}

/// The reference face is too short for b2Vec2::Normalize, or shorter than world coordinates
/// resolve.
bool tiny_reference_face(const Deviation& d) {
  if (d.kind != Kind::normal && d.kind != Kind::missed_contact) return false;
  const double unresolved =
      std::max(d.right.bounds.separation, 2.0 * std::numeric_limits<float>::epsilon());
  return any_candidate(d, [&](const exact::Clip& clip) {
    const ConvexPolygon<float>& polygon = d.right.pair()[clip.reference.side].polygon;
    const Vector2<float> face = polygon.vertices[polygon.next(clip.reference.index)] -
                                polygon.vertices[clip.reference.index];
    return static_cast<double>(face.norm()) <= unresolved;
  });
}

/// The square of the reference face's length is beyond float, so that b2Vec2::Normalize divides by
/// infinity.
bool huge_reference_face(const Deviation& d) {
  if (d.kind != Kind::normal && d.kind != Kind::missed_contact) return false;
  return any_candidate(d, [&](const exact::Clip& clip) {
    const ConvexPolygon<float>& polygon = d.right.pair()[clip.reference.side].polygon;
    const Vector2<float> face = polygon.vertices[polygon.next(clip.reference.index)] -
                                polygon.vertices[clip.reference.index];
    return !std::isfinite(face.dot(face));
  });
}

/// An end of the incident edge lies so near a side plane that the product of both ends' distances
/// underflows: the crossing is not seen, and one point is left.
bool crossing_underflows(const Deviation& d) {
  return misses_overlap(d) && any_candidate(d, [&](const exact::Clip& clip) {
           return std::any_of(clip.points.begin(), clip.points.begin() + clip.count,
                              [&](const exact::ClipPoint& point) {
                                return compare_margin(d.right.pair(), clip, point.end,
                                                      std::numeric_limits<float>::min()) <= 0;
                              });
         });
}

// Twice what 20,000,000 cases showed, rounded up. An entry without budgets is met in the regime
// `corpus` alone, which has none.
constexpr Budget kOfTinyFaces[] = {{"micro_edge", 7200}, {"scaled", 1300}, {"ulp", 500}};
constexpr Budget kOfBias[] = {{"generic", 30},
                              {"regular", 20},
                              {"sliver", 1600},
                              {"near_parallel", 10},
                              {"tied_faces", 60},
                              {"micro_edge", 5000},
                              {"near_collinear", 300},
                              {"corner_corner", 4000},
                              {"corner_face", 30},
                              {"deep", 30},
                              {"tie_bias", 47'000},
                              {"far_from_origin", 40},
                              {"scaled", 16'000},
                              {"off_unit", 50},
                              {"ulp", 4400}};
constexpr Budget kOfTies[] = {{"sliver", 4800},        {"tied_faces", 26'000},
                              {"micro_edge", 10},      {"near_collinear", 48'000},
                              {"corner_corner", 40},   {"tie_bias", 10},
                              {"far_from_origin", 30}, {"scaled", 10},
                              {"off_unit", 20},        {"ulp", 4700}};
constexpr std::array kLedger{
    LedgerEntry{.id = "box2d-tiny-reference-face",
                .collider = "box2d",
                .description =
                    "a wrong normal or no contact: the reference face is shorter than b2_epsilon, "
                    "so its direction is not normalised, or than world coordinates resolve",
                .source =
                    "Box2D 2.4.1, include/box2d/b2_math.h, b2Vec2::Normalize: "
                    "`if (length < b2_epsilon) return 0.0f`; src/collision/b2_collide_polygon.cpp, "
                    "b2CollidePolygons: side offsets of world vertices",
                .witness = "defects/box2d/witness-box2d-tiny-reference-face.json",
                .budgets = kOfTinyFaces,
                .explains = tiny_reference_face},
    LedgerEntry{.id = "box2d-huge-reference-face",
                .collider = "box2d",
                .description =
                    "a normal of length zero: the square of the reference face's length is beyond "
                    "float, so its direction is divided by infinity",
                .source = "Box2D 2.4.1, include/box2d/b2_math.h, b2Vec2::Length and Normalize: "
                          "`b2Sqrt(x * x + y * y)`",
                .witness = "defects/box2d/witness-box2d-huge-reference-face.json",
                .budgets = {},
                .explains = huge_reference_face},
    LedgerEntry{.id = "box2d-no-contact-under-bias",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: the bias keeps A's shallower face, whose "
                    "side planes the incident edge misses",
                .source = "Box2D 2.4.1, src/collision/b2_collide_polygon.cpp, b2CollidePolygons: "
                          "k_tol = 0.1f * b2_linearSlop, then `if (np < 2) return`",
                .witness = "defects/box2d/witness-box2d-no-contact-under-bias.json",
                .budgets = kOfBias,
                .explains = no_contact_under_bias},
    LedgerEntry{.id = "box2d-no-contact-on-tied-features",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: faces or edges tie in float, the wrong "
                    "one is kept, and its slab misses the deepest vertex",
                .source =
                    "Box2D 2.4.1, src/collision/b2_collide_polygon.cpp, b2FindMaxSeparation and "
                    "b2FindIncidentEdge: first of equals",
                .witness = "defects/box2d/witness-box2d-no-contact-on-tied-features.json",
                .budgets = kOfTies,
                .explains = no_contact_on_tied_features},
    LedgerEntry{.id = "box2d-crossing-underflows",
                .collider = "box2d",
                .description =
                    "no contact for overlapping polygons: an end of the incident edge all "
                    "but touches a side plane, the product of distances underflows",
                .source = "Box2D 2.4.1, src/collision/b2_collision.cpp, b2ClipSegmentToLine: "
                          "`if (distance0 * distance1 < 0.0f)`",
                .witness = "defects/box2d/witness-box2d-crossing-underflows.json",
                .budgets = {},
                .explains = crossing_underflows},
};

static_assert(kLedger.size() <= kLedgerMax);

}  // namespace

std::span<const LedgerEntry> ledger() {
  return kLedger;
}

std::size_t index_of(const LedgerEntry& entry) {
  return static_cast<std::size_t>(&entry - kLedger.data());
}

double budget_per_million(const LedgerEntry& entry, std::string_view regime) {
  const auto found = std::ranges::find(entry.budgets, regime, &Budget::regime);
  return found == entry.budgets.end() ? 0 : found->per_million;
}

const LedgerEntry* find_explanation(std::string_view collider, const Deviation& deviation) {
  for (const LedgerEntry& entry : kLedger) {
    if (entry.collider == collider && entry.explains(deviation)) return &entry;
  }
  return nullptr;
}

}  // namespace manifuzz
