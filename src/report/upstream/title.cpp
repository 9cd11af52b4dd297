#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "exact/curve.hpp"
#include "judging/bounds.hpp"
#include "report/upstream/effect.hpp"
#include "report/upstream/parts.hpp"

namespace manifuzz {
namespace {

std::string shape_word(const ConvexPolygon<float>& shape) {
  if (shape.count == 1) return "circle";
  if (shape.count == 2) return shape.radius > 0 ? "capsule" : "segment";
  constexpr std::array words{"triangle", "quadrilateral", "pentagon",
                             "hexagon",  "heptagon",      "octagon"};
  const std::string word = words.at(static_cast<std::size_t>(shape.count - kMinVertices));
  return shape.is_round() && shape.radius > 0 ? "rounded " + word : word;
}

std::string with_article(const std::string& word) {
  return (word.starts_with("o") ? "an " : "a ") + word;
}

/// "triangles", "a circle and a capsule".
std::string shapes_in_words(const PairCase& pair) {
  const std::string a = shape_word(pair.a.polygon);
  const std::string b = shape_word(pair.b.polygon);
  return a == b ? a + "s" : with_article(a) + " and " + with_article(b);
}

/// "triangles that overlap by 0.3", "circles 0.01 apart".
std::string pair_in_words(const PairCase& pair) {
  const double depth = true_depth(pair);
  const std::string shapes = shapes_in_words(pair);
  if (depth > 0) return fmt::format("{} that overlap by {}", shapes, plain(depth));
  if (depth < 0) return fmt::format("{} {} apart", shapes, plain(-depth));
  return shapes + " that just touch";
}

/// The kind of an error of a normal, as an end of "the normal of ... ".
std::string normal_in_words(const JudgedCase& judged, const Vector2<double>& normal,
                            const Declaration& declaration) {
  const double length = normal.norm();
  if (length == 0) return "has length 0";
  const double turn = turn_of(judged.given.pair(), normal, declaration);
  const double lacking = std::abs(1 - length);
  if (lacking > turn) {
    if (lacking > 1e-3) return "has length " + plain(length);
    return fmt::format("has length 1 {} {}", length < 1 ? '-' : '+', plain(lacking));
  }
  return "is off by " + angle_in_words(turn);
}

std::string wrong_normal_in_words(const JudgedCase& judged, const Said& claim,
                                  const Declaration& declaration) {
  const Vector2<double> normal = claim.normal.value_or(Vector2<double>(0, 0));
  return fmt::format("the normal of {} {}", pair_in_words(judged.given.pair()),
                     normal_in_words(judged, normal, declaration));
}

std::string depth_in_words(const PairCase& pair, const Said& claim) {
  return fmt::format("{} are reported {} deep", pair_in_words(pair), plain(claim.depth));
}

/// A right normal may point to the same side, or be the answer's own: then its depth is the news.
std::string reversed_in_words(const JudgedCase& judged, const Said& claim,
                              const Declaration& declaration) {
  const PairCase& pair = judged.given.pair();
  const double turn = turn_of(pair, claim.normal.value(), declaration);
  if (turn > std::numbers::pi / 2) return "the normal of " + pair_in_words(pair) + " is reversed";
  if (turn <= bounds(pair, declaration).normal) return depth_in_words(pair, claim);
  return wrong_normal_in_words(judged, claim, declaration);
}

/// Where the direction between the cores decides, a depth is held against the least one: then the
/// normal is the news.
bool is_depth_along_normal(const JudgedCase& judged, const Said& claim) {
  const PairCase& pair = judged.given.pair();
  const double off = judged.judgement.magnitude * size(pair);
  return std::abs(std::abs(claim.depth - depth_along(pair, claim)) - off) <=
         std::abs(std::abs(claim.depth - true_depth(pair)) - off);
}

std::string inconsistent_in_words(const PairCase& pair, const Said& claim) {
  const double depth = depth_along(pair, claim);
  const std::string shapes = shapes_in_words(pair);
  const std::string along =
      depth >= 0 ? fmt::format("{} that overlap by {} along the normal given", shapes, plain(depth))
                 : fmt::format("{} {} apart along the normal given", shapes, plain(-depth));
  if (plain(depth) != plain(claim.depth)) {
    return fmt::format("{} are reported {} deep", along, plain(claim.depth));
  }
  return fmt::format("{} are reported {} too {}", along, plain(std::abs(claim.depth - depth)),
                     claim.depth > depth ? "deep" : "shallow");
}

std::string not_minimal_in_words(const PairCase& pair, const Said& claim) {
  const double needed = depth_along(pair, claim);
  const double least = true_depth(pair);
  const bool is_plain = plain(needed) != plain(least);
  return fmt::format("{} are pushed apart along a direction that needs {}{}", pair_in_words(pair),
                     plain(is_plain ? needed : needed - least), is_plain ? "" : " more");
}

std::string count_in_words(const JudgedCase& judged, const Said& claim,
                           const Declaration& declaration) {
  const std::string pair_words = pair_in_words(judged.given.pair());
  if (points_in(claim) > right_count(judged, declaration)) {
    return pair_words + " have two contact points where one is right";
  }
  return fmt::format(
      "{} have {} where they touch along an edge", pair_words,
      points_in(claim) == 1 ? "one contact point" : "contact points too close together");
}

/// A point where the shapes overlap by less than it says, or that lies out of one of them.
std::string witness_in_words(const PairCase& pair, const DeclaredAnswer& asked) {
  const double outside = outside_by(pair, asked);
  const std::string point = "a contact point of " + pair_in_words(pair);
  if (outside <= bounds(pair, asked.declaration).position) {
    return fmt::format("{} has depth {}, but the shapes do not overlap by that there", point,
                       plain(said_by(asked.answer).depth));
  }
  return fmt::format("{} lies {} outside one of them", point, plain(outside));
}

std::string lost_in_words(const DeclaredAnswer& asked) {
  if (is_nonsense(asked)) return "get an invalid answer";
  const bool is_late = std::get<Lost>(asked.answer).how == Lost::How::timed_out;
  return is_late ? "are not answered in time" : "crash the program";
}

std::string sentence(const JudgedCase& judged, const DeclaredAnswer& asked) {
  const PairCase& pair = judged.given.pair();
  const std::string pair_words = pair_in_words(pair);
  const Said claim = said_by(asked.answer);
  const std::string off = plain(judged.judgement.magnitude * size(pair));  // a length is seen
  const PointErrors points = point_errors(pair, asked);
  const std::string phantom = depth_in_words(pair, claim);
  switch (told_kind(judged, asked)) {
    case Kind::missed_contact:
      return pair_words + " have no contact";
    case Kind::phantom_contact:
      return claim.depth <= 0 ? pair_words + " are in contact" : phantom;
    case Kind::normal:
      if (is_far_too_deep(pair, claim, asked.declaration)) return phantom;
      return wrong_normal_in_words(judged, claim, asked.declaration);
    case Kind::position:
      return fmt::format("a contact point of {} is off by {}", pair_words, plain(points.place));
    case Kind::depth:
      if (plain(claim.depth) != plain(true_depth(pair))) return phantom;
      return fmt::format("the depth of a contact point of {} is off by {}", pair_words,
                         plain(points.depth));
    case Kind::count:
    case Kind::extent:
      return count_in_words(judged, claim, asked.declaration);
    case Kind::features:
      return fmt::format("the contact points of {} name wrong features", pair_words);
    case Kind::reversed:
      return reversed_in_words(judged, claim, asked.declaration);
    case Kind::inconsistent:
      if (is_depth_along_normal(judged, claim)) return inconsistent_in_words(pair, claim);
      return wrong_normal_in_words(judged, claim, asked.declaration);
    case Kind::not_minimal:
      return not_minimal_in_words(pair, claim);
    case Kind::witness:
      return witness_in_words(pair, asked);
    case Kind::altered_shape:
      return fmt::format("the shapes used for {} are off by {}", pair_words, off);
    default:
      return pair_words + " " + lost_in_words(asked);
  }
}

}  // namespace

std::string upstream_title(const JudgedCase& judged, const DeclaredAnswer& asked) {
  std::string text = sentence(judged, asked);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

}  // namespace manifuzz
