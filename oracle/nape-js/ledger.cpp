#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "engines/engine.hpp"
#include "judging/faults/replayed.hpp"
#include "judging/faults/shared_faults.hpp"
#include "oracle/nape-js/replay.hpp"

// nape in JavaScript.

namespace manifuzz {
namespace {

constexpr double kEpsilonOfNape = 1e-8;  // nape.Config.epsilon

/// The corners that it keeps of a shape, as the case has them; the adapter hands them over as much
/// longer as the rotation is longer than unit.
std::vector<Vector2<double>> kept_of(const Body& body) {
  const std::vector<Vector2<double>> corners = ledger_of::given_to_nape(body);
  const std::vector<Vector2<double>> kept = ledger_of::spliced_by_nape(corners);
  std::vector<Vector2<double>> stored;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (std::ranges::find(kept, corners[i]) == kept.end()) continue;
    stored.emplace_back(body.polygon.vertices[static_cast<int>(i)].cast<double>());
  }
  return stored;
}

bool is_used(const exact::StoredPolygon& used, const std::vector<Vector2<double>>& kept) {
  return std::ranges::equal(kept,
                            std::span(used.vertices).first(static_cast<std::size_t>(used.count)));
}

/// Whether two places are within its epsilon, and the answer is what it gives of such.
bool is_axis_of_nape(const Deviation& d, Side circle, const Vector2<double>& centre,
                     const Vector2<double>& corner) {
  const PairCase& pair = d.right.pair();
  const double bound = 2 * d.right.bounds.separation;
  if ((centre - corner).norm() > kEpsilonOfNape + bound) return false;
  const Vector2<double> at =
      to_world(pair, d.got.points[0].position) - pair.a.pose.position.cast<double>();
  return (at - centre).norm() <= bound + d.right.bounds.position &&
         pair[circle].polygon.count == 1 &&
         std::abs(d.got.points[0].depth - total_radius(pair)) <= bound;
}

/// contactCollide's clip of an incident edge, seen from A's position in the world.
struct ClipOfNape {
  std::array<Vector2<double>, 2> ends;
  std::array<double, 2> depths{};
  bool is_unclipped = false;  ///< an end beyond a side plane stays as it is
};

ClipOfNape clip_by_nape(const exact::Clip& clip) {
  const exact::RoughPair placed = exact::place_roughly(*clip.pair);
  const exact::RoughPolygon& on = placed[clip.reference.side];
  const exact::RoughPolygon& of = placed[other(clip.reference.side)];
  const Vector2<double>& out = on.normals[clip.reference.index];
  const Vector2<double> along(-out.y(), out.x());
  const Vector2<double>& corner = on.vertices[clip.reference.index];
  const double length = (on.vertices[on.next(clip.reference.index)] - corner).dot(along);
  const Vector2<double>& upper = of.vertices[clip.incident];
  const Vector2<double>& lower = of.vertices[of.next(clip.incident)];
  const double high = (upper - corner).dot(along);
  const double low = (lower - corner).dot(along);
  // Its t and t2, as shares of the edge from the end that they move.
  const double of_upper = (high - length) / (high - low);
  const double of_lower = -low / (high - low);
  ClipOfNape found{.ends = {upper, lower}};
  if (of_upper > kEpsilonOfNape) found.ends[0] += of_upper * (lower - upper);
  if (of_lower > kEpsilonOfNape) found.ends[1] += of_lower * (upper - lower);
  for (const std::size_t k : {0U, 1U}) found.depths[k] = -(found.ends[k] - corner).dot(out);
  const auto is_left = [](double share) { return share > 0 && share <= kEpsilonOfNape; };
  found.is_unclipped = is_left(of_upper) || is_left(of_lower);
  return found;
}

/// Whether that is the answer: those of its ends that are no gaps.
bool is_clip_of_nape(const Deviation& d, const exact::Clip& clip, const ClipOfNape& found) {
  if (!is_near_normal(clip, d.got.normal, d.right.bounds.normal)) return false;
  // What is prolonged, or cut, is off by its roundings over the cosine.
  const double bound = 4 * d.right.bounds.separation / std::max(clip.cosine, kEpsilonOfNape);
  const Vector2<double> turn = d.right.pair().a.pose.rotation.cast<double>();
  const Vector2<double> normal = rotate<double>(turn.normalized(), d.got.normal);
  // Its midpoints were taken for points of the other side's where that would be the reference.
  const double across = d.got.reference == clip.reference.side ? 0.0
                        : d.got.reference == Side::a           ? 1.0
                                                               : -1.0;
  int given = 0;
  for (const std::size_t k : {0U, 1U}) {
    if (found.depths[k] < -bound) continue;
    const bool is_there =
        std::any_of(d.got.points.begin(), d.got.points.begin() + d.got.count,
                    [&](const ContactPoint<double>& point) {
                      const Vector2<double> at =
                          rotate<double>(turn, point.position) + across * point.depth * normal;
                      return (at - found.ends[k]).norm() <= bound &&
                             std::abs(point.depth - found.depths[k]) <= bound;
                    });
    if (!is_there && found.depths[k] > bound) return false;
    given += is_there ? 1 : 0;
  }
  return given >= d.got.count;
}

/// Whether the answer is its clip of one of the faces and edges within bound, of which
/// `is_at_fault` tells.
template <class Fault>
bool any_clip_of_nape(const Deviation& d, const Fault& is_at_fault) {
  for (const Side side : {Side::a, Side::b}) {
    for (const exact::Clip* clip : clips_within(*d.right.truth, side, d.right.bounds)) {
      const ClipOfNape found = clip_by_nape(*clip);
      if (is_at_fault(*clip, found) && is_clip_of_nape(d, *clip, found)) return true;
    }
  }
  return false;
}

using ledger_of::ContactOfNape;
using ledger_of::CutOfNape;

/// The ends that are no gaps, as nape-js.mjs has it.
std::vector<std::size_t> given_of(const ContactOfNape& contact) {
  std::vector<std::size_t> given;
  for (const std::size_t k : {0U, 1U}) {
    if (!(contact.depths[k] < 0)) given.push_back(k);
  }
  return given;
}

/// Whether its operations, repeated, give the answer: places off a shape are as large as they are.
bool is_repeated_by(const Deviation& d, const ContactOfNape& contact) {
  constexpr double kRoundings = 16 * std::numeric_limits<double>::epsilon();
  const PairCase& pair = d.right.pair();
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  const Vector2<double> normal = rotate<double>(turn, d.got.normal);
  const std::vector<std::size_t> given = given_of(contact);
  if (static_cast<int>(given.size()) != d.got.count ||
      !((normal - contact.normal).norm() <= d.right.bounds.normal)) {
    return false;
  }
  const double across = d.got.reference == contact.reference ? 0.0
                        : d.got.reference == Side::a         ? 1.0
                                                             : -1.0;
  return std::ranges::all_of(given, [&](std::size_t k) {
    const double bound = d.right.bounds.separation + kRoundings * contact.ends[k].norm();
    return std::any_of(d.got.points.begin(), d.got.points.begin() + d.got.count,
                       [&](const ContactPoint<double>& point) {
                         const Vector2<double> at =
                             to_world(pair, point.position) + across * point.depth * normal;
                         return (at - contact.ends[k]).norm() <= 2 * bound &&
                                std::abs(point.depth - contact.depths[k]) <= bound;
                       });
  });
}

/// Whether the answer would be right if no end were moved by more than the edge's length.
bool is_right_within_edge(const Deviation& d) {
  const Declaration declaration{
      .frame = RoundingFrame::world, .takes_angles = true, .min_vertices = 1};
  const auto contacts = ledger_of::contacts_of_nape(d.right.pair(), CutOfNape::within_edge);
  return std::ranges::any_of(contacts, [&](const ContactOfNape& contact) {
    replayed::Contact mended{contact.normal, {}};
    for (const std::size_t k : given_of(contact)) {
      mended.points.push_back({contact.ends[k], contact.depths[k]});
    }
    return replayed::is_right_answer(d, declaration, mended);
  });
}

bool is_of_clip(Kind kind) {
  return kind == Kind::position || kind == Kind::depth || kind == Kind::count ||
         kind == Kind::phantom_contact;
}

/// The shapes that were used are those which its rule of corners that lie together, or on a
/// line, leaves of the case's.
bool corners_spliced_by_nape(const Deviation& d) {
  if (d.kind != Kind::altered_shape) return false;
  const PairCase& pair = d.right.pair();
  const exact::StoredPair& used = d.right.truth->stored();
  return is_used(used.a.polygon, kept_of(pair.a)) && is_used(used.b.polygon, kept_of(pair.b));
}

/// A circle whose centre is within 1e-8 of another's or of a corner: the normal is against
/// the world's x axis, the depth that of two points at one place, and the point the centre.
bool axis_within_nape_epsilon(const Deviation& d) {
  if (d.got.count != 1) return false;
  const PairCase& pair = d.right.pair();
  const Vector2<double> turn = pair.a.pose.rotation.cast<double>().normalized();
  const Vector2<double> normal = rotate<double>(turn, d.got.normal);
  if ((normal - Vector2<double>(-1, 0)).norm() > 2 * d.right.bounds.normal) return false;
  const exact::RoughPair placed = exact::place_roughly(pair);
  for (const Side side : {Side::a, Side::b}) {
    const exact::RoughPolygon& of = placed[other(side)];
    if (std::any_of(of.vertices.begin(), of.vertices.begin() + of.count,
                    [&](const Vector2<double>& corner) {
                      return is_axis_of_nape(d, side, placed[side].vertices[0], corner);
                    })) {
      return true;
    }
  }
  return false;
}

/// An end of the incident edge is not cut, being beyond a side plane by less than 1e-8 of the
/// edge's length.
bool unclipped_within_nape_epsilon(const Deviation& d) {
  return (is_of_clip(d.kind) || d.kind == Kind::normal) &&
         any_clip_of_nape(
             d, [](const exact::Clip&, const ClipOfNape& found) { return found.is_unclipped; });
}

/// The incident edge misses the slab, or is along the normal but for roundings, and the
/// answer is of it as prolonged to both side planes; if no end left the edge it would be right.
bool edge_extended_by_nape(const Deviation& d) {
  if (is_of_clip(d.kind) && any_clip_of_nape(d, [&](const exact::Clip& clip, const ClipOfNape&) {
        return compare_gap(clip, -d.right.bounds.separation) > 0;
      })) {
    return true;
  }
  const auto contacts = ledger_of::contacts_of_nape(d.right.pair(), CutOfNape::of_any_share);
  return std::ranges::any_of(
             contacts, [&](const ContactOfNape& contact) { return is_repeated_by(d, contact); }) &&
         is_right_within_edge(d);
}

/// An answer that holds no number, for the incident edge has no run along the face, and it
/// divides by that.
bool edge_of_no_run_in_nape(const LostAnswer& lost) {
  if (lost.how != Lost::How::malformed) return false;
  const auto contacts = ledger_of::contacts_of_nape(lost.pair, CutOfNape::of_any_share);
  return std::ranges::any_of(contacts, [](const ContactOfNape& contact) {
    return !std::isfinite(1 / contact.run) &&
           std::ranges::any_of(given_of(contact), [&](std::size_t k) {
             return !contact.ends[k].allFinite() || !std::isfinite(contact.depths[k]);
           });
  });
}

constexpr LedgerRow kNapeJsRows[] = {
    {"corners-spliced", corners_spliced_by_nape},
    {"axis-within-epsilon", axis_within_nape_epsilon},
    {"unclipped-within-epsilon", unclipped_within_nape_epsilon},
    {"edge-extended-to-slab", edge_extended_by_nape},
    {"edge-of-no-run", nullptr, edge_of_no_run_in_nape},
    {"no-contact-on-tied-features", no_contact_on_tied_features},
};

}  // namespace

Engine engine_nape_js() {
  return {.name = "nape-js", .ledger = {{"nape-js", kNapeJsRows}}};
}

}  // namespace manifuzz
