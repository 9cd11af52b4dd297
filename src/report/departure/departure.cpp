#include "report/departure/departure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "geometry/pose.hpp"
#include "judging/by_curve.hpp"
#include "judging/manifold_error.hpp"
#include "judging/unjudged.hpp"
#include "report/departure/steps.hpp"

namespace manifuzz {
namespace {

using exact::FaceOf;

constexpr std::size_t kNamedMax = 3;  ///< changes that are named, the earliest steps first

/// A manifold as it is replayed: world directions and lengths, seen from A's position.
struct GivenContact {
  Vector2<double> normal{0, 0};
  std::vector<ReplayedPoint> points;
  bool names_features = true;
};

GivenContact seen_in_world(const PairCase& pair, const Manifold<double>& manifold,
                           bool names_features) {
  GivenContact contact{world_normal(pair, manifold.normal), {}, names_features};
  for (int i = 0; i < manifold.count; ++i) {
    const ContactPoint<double>& point = manifold.points[i];
    contact.points.push_back(
        {exact::seen_from_a(pair, point.position), point.depth, point.features});
  }
  return contact;
}

bool is_finite(const GivenContact& contact) {
  return std::ranges::all_of(contact.points, [&](const ReplayedPoint& point) {
    return contact.normal.allFinite() && point.place.allFinite() && std::isfinite(point.depth);
  });
}

/// How far a right collider's figures may be off where these choices clip.
struct Reach {
  double normal = 0;
  double position = 0;  ///< of an end that is not clipped
  double depth = 0;     ///< of such an end
  double along = 0;     ///< how much farther a crossing may lie off, along the face
  double across = 0;    ///< and how much its depth
};

Reach reach_of(const ClipChoices& choices, const Bounds& bounds) {
  const Vector2<double> edge = choices.edge[1] - choices.edge[0];
  const double length = edge.norm();
  const double rise = std::abs(choices.outward.dot(edge));
  const double run = std::abs(cross(choices.outward, edge));
  const double of_angle = run > 0 ? bounds.separation / run : length;
  return {bounds.normal, bounds.position, bounds.separation, std::min(of_angle * length, length),
          std::min(of_angle * rise, length)};
}

bool is_in_place(const Vector2<double>& given, const ReplayedPoint& replayed, const Reach& reach) {
  const double within = reach.position + (replayed.is_crossing ? reach.along : 0);
  return (given - replayed.place).norm() <= within;
}

bool is_near(const ReplayedPoint& given, const ReplayedPoint& replayed, const Reach& reach) {
  // An end before the face has no depth that can be reported; its distance or 0 is.
  const double depth = replayed.depth;
  const double within = reach.depth + (replayed.is_crossing ? reach.across : 0);
  const bool is_deep = std::abs(given.depth - depth) <= within;
  const bool is_instead =
      depth < 0 && (std::abs(given.depth) <= within || std::abs(given.depth + depth) <= within);
  return is_in_place(given.place, replayed, reach) && (is_deep || is_instead);
}

/// How much of an answer a replayed clip gives.
enum class Given : unsigned char { nothing, figures, figures_and_features };

/// What the clip with these choices gives of the contact, within the bounds.
Given given_by(const ClipChoices& choices, const GivenContact& contact, const Bounds& bounds) {
  const std::vector<ReplayedPoint> replayed = replay_clip(choices);
  if (contact.points.empty() || replayed.empty()) {
    return contact.points.empty() && replayed.empty() ? Given::figures : Given::nothing;
  }
  const Reach reach = reach_of(choices, bounds);
  if ((contact.normal - choices.normal).norm() > reach.normal) return Given::nothing;
  const auto is_given = [&](const ReplayedPoint& point) {
    return std::abs(point.depth) <= reach.depth ||
           std::ranges::any_of(contact.points,
                               [&](const auto& given) { return is_near(given, point, reach); });
  };
  if (!std::ranges::all_of(replayed, is_given)) return Given::nothing;
  bool has_features = contact.names_features;
  for (const ReplayedPoint& given : contact.points) {
    const auto is_it = [&](const ReplayedPoint& point) { return is_near(given, point, reach); };
    if (std::ranges::none_of(replayed, is_it)) return Given::nothing;
    has_features = has_features && std::ranges::any_of(replayed, [&](const auto& point) {
                     return is_it(point) && point.features == given.features;
                   });
  }
  return has_features ? Given::figures_and_features : Given::figures;
}

/// Every right way, or where the shapes are apart, the clips of the face that separates them.
std::vector<RightWay> right_ways(const Admissible& right, const exact::RoughPair& polygons) {
  const exact::Truth& truth = *right.truth;
  std::vector<RightWay> ways;
  for (const exact::Clip* const clip : right_clips(right)) {
    ways.push_back({truth, polygons, right.bounds, clip->reference, clip->incident, false});
  }
  if (!ways.empty()) return ways;
  const FaceOf greatest = truth.greatest();
  for (const int incident : truth.incident_edges(greatest, right.bounds.incident_dot)) {
    ways.push_back({truth, polygons, right.bounds, greatest, incident, true});
  }
  return ways;
}

/// Keeps the first of each step, one with the answer's features before others.
void keep(std::vector<Departure>& found, const Departure& departure) {
  const auto known = std::ranges::find(found, departure.step, &Departure::step);
  if (known == found.end()) {
    found.push_back(departure);
  } else if (departure.has_features && !known->has_features) {
    *known = departure;
  }
}

void find_departures(const RightWay& way, const GivenContact& contact, Departures& departures) {
  for (const ClipStep& step : clip_steps()) {
    step.try_others(way, [&](const std::string& words, const ClipChoices& choices) {
      const Given given = given_by(choices, contact, way.bounds);
      if (given == Given::nothing) return;
      keep(departures.found, {step.name, words, given == Given::figures_and_features});
    });
  }
}

/// In the order of the steps; where features tell some from others, those alone.
void put_in_order(std::vector<Departure>& found) {
  if (std::ranges::any_of(found, &Departure::has_features)) {
    std::erase_if(found, [](const Departure& departure) { return !departure.has_features; });
  }
  std::ranges::stable_sort(found, {}, [](const Departure& departure) {
    return std::ranges::find(clip_steps(), departure.step, &ClipStep::name) - clip_steps().begin();
  });
}

std::string face_in_words(FaceOf face) {
  return fmt::format("{}'s face {}", face.side == Side::a ? 'A' : 'B', face.index);
}

bool has_normal_of(const RightWay& way, FaceOf face, const Vector2<double>& normal) {
  const Vector2<double>& outward = way.polygons[face.side].normals[face.index];
  const Vector2<double> a_to_b = face.side == Side::a ? outward : Vector2<double>(-outward);
  return (normal - a_to_b).norm() <= way.bounds.normal;
}

/// Where a clip of any two edges would leave a point at that place, in words; empty: nowhere.
std::string place_in_words(const RightWay& way, const ReplayedPoint& point) {
  const auto faces = exact::all_faces(way.truth.stored());
  for (const FaceOf edge : faces) {
    const auto& at = way.polygons[edge.side].vertices[edge.index];
    if ((point.place - at).norm() > way.bounds.position) continue;
    return fmt::format("{}'s vertex {}", edge.side == Side::a ? 'A' : 'B', edge.index);
  }
  for (const FaceOf reference : faces) {
    for (const FaceOf edge : faces) {
      if (edge.side == reference.side) continue;
      ClipChoices choices = choices_of(way, reference, edge);
      choices.kept = {true, true};
      const Reach reach = reach_of(choices, way.bounds);
      for (const ReplayedPoint& end : replay_clip(choices)) {
        if (!is_in_place(point.place, end, reach)) continue;
        return fmt::format("where {} cuts off {}", face_in_words(reference), edge_in_words(edge));
      }
    }
  }
  return {};
}

std::string normal_in_words(const RightWay& way, const Vector2<double>& normal) {
  if (has_normal_of(way, way.reference, normal)) {
    return fmt::format("The normal is right, that of {}.", face_in_words(way.reference));
  }
  for (const FaceOf face : exact::all_faces(way.truth.stored())) {
    if (has_normal_of(way, face, normal)) {
      return fmt::format("The normal is that of {}, where {} is the reference.",
                         face_in_words(face), face_in_words(way.reference));
    }
  }
  return "The normal is that of no face.";
}

/// A point of the answer, which is its n-th, beside those of the right clip.
std::string point_in_words(const RightWay& way, const ReplayedPoint& point, std::size_t number) {
  const ClipChoices right = choices_of(way);
  const Reach reach = reach_of(right, way.bounds);
  const std::string name = fmt::format("Point {}", number);
  bool has_place = false;
  for (const ReplayedPoint& expected : replay_clip(right)) {
    if (is_near(point, expected, reach)) return name + " is right.";
    has_place = has_place || is_in_place(point.place, expected, reach);
  }
  if (has_place) return name + " is in its right place, and its depth is that of no step.";
  const std::string place = place_in_words(way, point);
  if (place.empty()) return name + " is at no clip of any edge.";
  return fmt::format("{} is at {}, where the right clip has none.", name, place);
}

/// How far the answer agrees with the way whose normal it has, or else with the first.
std::string agreement_in_words(const std::vector<RightWay>& ways, const GivenContact& contact) {
  if (contact.points.empty()) return "No single step done otherwise gives no contact.";
  const auto own = std::ranges::find_if(
      ways, [&](const RightWay& way) { return has_normal_of(way, way.reference, contact.normal); });
  const RightWay& way = own == ways.end() ? ways.front() : *own;
  std::string words = "No single step done otherwise gives this answer. ";
  words += normal_in_words(way, contact.normal);
  for (std::size_t i = 0; i < contact.points.size(); ++i) {
    words += ' ' + point_in_words(way, contact.points[i], i + 1);
  }
  return words;
}

/// The manifold of an answer that is wrong and that the steps of the article could have given.
std::optional<Manifold<double>> wrong_manifold(const PairCase& pair, const ColliderAnswer& given,
                                               const Admissible& right) {
  if (is_round(pair) || is_judged_by_curve(given.declaration, pair) ||
      !std::isfinite(right.bounds.separation) || used_by(given.answer) != nullptr) {
    return std::nullopt;
  }
  const Answer answer = whole(given.answer, right, given.declaration);
  const auto* const manifold = std::get_if<Manifold<double>>(&answer);
  if (manifold == nullptr || manifold->count < 0 || manifold->count > 2) return std::nullopt;
  if (!is_finite(seen_in_world(pair, *manifold, false))) return std::nullopt;
  const Kind kind = mismatch(*manifold, right).kind;
  const bool is_enough =
      kind == Kind::count && given.declaration.one_point_enough && manifold->count == 1;
  const bool is_right = kind == Kind::none && !why_malformed(pair, *manifold);
  if (is_right || is_enough) return std::nullopt;
  return *manifold;
}

}  // namespace

std::vector<const exact::Clip*> right_clips(const Admissible& right) {
  std::vector<const exact::Clip*> clips;
  std::ranges::copy_if(right.candidates, std::back_inserter(clips), [&](const exact::Clip* clip) {
    return true_manifold(*clip, right.bounds.separation).count > 0;
  });
  return clips;
}

std::optional<Departures> departures_of(const PairCase& pair, const ColliderAnswer& given) {
  const Admissible right = admissible(pair, given.declaration);
  const auto manifold = wrong_manifold(pair, given, right);
  if (!manifold) return std::nullopt;
  const auto* const partial = std::get_if<PartialManifold>(&given.answer);
  const GivenContact contact =
      seen_in_world(pair, *manifold, partial == nullptr || partial->names_features);
  const exact::RoughPair polygons = exact::place_roughly(right.truth->stored());
  const std::vector<RightWay> ways = right_ways(right, polygons);
  Departures departures;
  const bool has_right_figures = std::ranges::any_of(ways, [&](const RightWay& way) {
    return !way.is_apart && given_by(choices_of(way), contact, way.bounds) != Given::nothing;
  });
  if (has_right_figures) {
    departures.agreement =
        "Every step agrees: all figures are right, and only the reference side or the features "
        "that it names are not.";
    return departures;
  }
  for (const RightWay& way : ways) find_departures(way, contact, departures);
  put_in_order(departures.found);
  if (departures.found.empty()) departures.agreement = agreement_in_words(ways, contact);
  return departures;
}

std::string departures_in_words(const Departures& departures) {
  if (departures.found.empty()) return departures.agreement;
  const Departure& first = departures.found.front();
  if (departures.found.size() == 1) {
    return fmt::format("It departs at {}: {} the clip gives this answer.", first.step, first.words);
  }
  std::string words = "One of these changes alone gives this answer:";
  const std::size_t named = std::min(departures.found.size(), kNamedMax);
  for (const Departure& departure : std::span(departures.found).first(named)) {
    words += fmt::format("{} at {}, {}", &departure == &first ? "" : ";", departure.step,
                         departure.words);
  }
  return words + '.';
}

}  // namespace manifuzz
