#include <algorithm>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>

#include <fmt/format.h>

#include "base/text.hpp"
#include "exact/curve.hpp"
#include "judging/by_curve.hpp"
#include "judging/curve_answer.hpp"
#include "report/round_truth.hpp"
#include "report/upstream/parts.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

/// A contact in the world, in one engine's terms.
class EngineTerms {
 public:
  EngineTerms(const PairCase& pair, const Declaration& declaration, const Program& program,
              Detail detail)
      : pair_(pair), declaration_(declaration), program_(program), detail_(detail) {}

  std::string normal(const Vector2<double>& local) const {
    const bool from_b = declaration_.normal_from_b != program_.is_b_first;
    const Vector2<double> world = world_normal(pair_, local);
    const Vector2<double> own = from_b ? Vector2<double>(-world) : world;
    std::string text = "normal " + place_text(own);
    const double length = world.norm();
    const double lacking = 1 - length;
    // Beyond what a unit normal rounds to.
    const double rounding = declaration_.scalar == ScalarType::float32 ? 0x1p-20 : 0x1p-49;
    if (std::abs(lacking) > 1e-3) {
      text += " of length " + short_figure(length);
    } else if (std::abs(lacking) > rounding) {
      text += fmt::format(" of length 1 {} {}", lacking > 0 ? '-' : '+',
                          short_figure(std::abs(lacking)));
    }
    return fmt::format("{} from {}", text, from_b ? "B to A" : "A to B");
  }

  /// `on`: on whose surface, or the middle where there is none.
  std::string point(const Vector2<double>& world_place, double depth, std::optional<Side> on,
                    const Vector2<double>& world_unit, bool is_clamped,
                    const std::string& form) const {
    const double back = on ? 0.0 : depth / 2;
    const Vector2<double> on_a =
        on == Side::b ? world_place + depth * world_unit : world_place + back * world_unit;
    const Vector2<double> on_b = on_a - depth * world_unit;
    std::string text = form;
    boost::replace_all(text, "$p", place_text(world_place));
    boost::replace_all(text, "$m", place_text(0.5 * (on_a + on_b)));
    boost::replace_all(text, "$a", place_text(on_a));
    boost::replace_all(text, "$b", place_text(on_b));
    boost::replace_all(text, "$d", figure(depth));
    boost::replace_all(text, "$s", is_clamped && depth == 0 ? "of 0 or above" : figure(-depth));
    return text;
  }

  /// What the engine itself answered; its points lie where it declares.
  std::string got(const Manifold<double>& manifold) const {
    const bool is_by_curve = is_judged_by_curve(declaration_, pair_);
    // Across a gap no right contact has an incident edge that a midpoint is moved to.
    const bool is_moved = !is_by_curve && !admissible(pair_, declaration_).candidates.empty();
    if (is_moved || (!is_by_curve && declaration_.points != PointsAt::midpoint)) {
      return contact(manifold, manifold.reference, true);
    }
    switch (declaration_.points) {
      case PointsAt::midpoint:
        return contact(manifold, std::nullopt, true);
      case PointsAt::surface_a:
        return contact(manifold, Side::b, true);  // the incident side's
      case PointsAt::surface_b:
        return contact(manifold, Side::a, true);
      default:  // of round shapes on the second's surface
        return contact(manifold, program_.is_b_first ? Side::b : Side::a, true);
    }
  }

  /// `reference`: points are on the other side's surface, or core where corners are mitred.
  /// `is_clamped`: a depth of 0 may stand for less.
  std::string contact(const Manifold<double>& manifold, std::optional<Side> reference,
                      bool is_clamped) const {
    if (manifold.count <= 0) return program_.none;
    const Vector2<double> normal_there = world_normal(pair_, manifold.normal);
    const double length = normal_there.norm();
    // A midpoint was moved along the normal as it was given.
    const bool is_as_given =
        length == 0 || (is_clamped && reference && declaration_.points == PointsAt::midpoint);
    const Vector2<double> unit =
        is_as_given ? normal_there : Vector2<double>(normal_there / length);
    std::vector<std::string> parts;
    if (program_.has_normal) parts.push_back(normal(manifold.normal));
    for (int i = 0; i < std::min(manifold.count, 2); ++i) {
      const auto& [local, depth, features] = manifold.points[i];
      Vector2<double> at = to_world(pair_, local);
      std::optional<Side> on;
      if (reference) {
        on = other(*reference);
        if (!is_round(pair_)) {
          const auto radius = static_cast<double>(pair_[*on].polygon.radius);
          at += (*on == Side::a ? radius : -radius) * unit;
        }
      }
      parts.push_back(point(without_roundings(at), depth, on, unit, is_clamped,
                            i > 0 && declaration_.shares_depth ? form_of_place() : program_.point));
      if (detail_.has_features) {
        parts.back() += fmt::format(", between {} and {}", place_name(Side::a, features.a),
                                    place_name(Side::b, features.b));
      }
    }
    return fmt::format("{}", fmt::join(parts, "; "));
  }

  std::string penetration(const Penetration& said) const {
    if (!said.touches) return none();
    if (!said.normal) return "contact";
    return fmt::format("{}; overlap {}", normal(*said.normal), figure(said.depth));
  }

  const std::string& none() const { return program_.none; }

 private:
  std::string figure(double value) const {
    const int digits = declaration_.scalar == ScalarType::float32 ? 7 : 9;
    if (std::isnan(value)) return "nan";  // its sign differs between machines
    return fmt::format("{:.{}g}", value + 0.0, digits + detail_.more_digits);
  }

  /// A second point's, where one depth is given for both.
  std::string form_of_place() const { return program_.point.substr(0, program_.point.find(',')); }

  /// A place comes by A's frame, where that is not the world's: what is left there of a coordinate
  /// of 0 is roundings.
  Vector2<double> without_roundings(Vector2<double> place) const {
    const Pose<float>& frame = pair_.a.pose;
    if (frame.rotation == Vector2<float>(1, 0) && frame.position == Vector2<float>(0, 0))
      return place;
    const double largest =
        place.cwiseAbs().maxCoeff() + frame.position.cast<double>().cwiseAbs().maxCoeff();
    for (int i = 0; i < 2; ++i) {
      if (std::abs(place[i]) <= 0x1p-50 * largest) place[i] = 0;
    }
    return place;
  }

  std::string place_text(const Vector2<double>& place) const {
    const Vector2<double> plain = without_negative_zeros(place);
    return fmt::format("({}, {})", figure(plain.x()), figure(plain.y()));
  }

  const PairCase& pair_;
  const Declaration& declaration_;
  const Program& program_;
  Detail detail_;
};

Manifold<double> deepest_alone(Manifold<double> manifold) {
  if (manifold.count < 2) return manifold;
  auto& [first, second] = manifold.points;
  if (second.depth > first.depth) first = second;
  manifold.count = 1;
  return manifold;
}

std::string in_terms(const EngineTerms& terms, const Declaration& declaration,
                     const Manifold<double>& right) {
  if (declaration.claims == Claims::manifold) {
    return terms.contact(right, right.reference, false);
  }
  if (declaration.claims == Claims::point) {
    return terms.contact(deepest_alone(right), right.reference, false);
  }
  if (right.count == 0) return terms.none();
  if (declaration.claims == Claims::touching) return "contact";
  Penetration penetration{.touches = true, .normal = right.normal, .depth = right.points[0].depth};
  if (right.count > 1) penetration.depth = std::max(penetration.depth, right.points[1].depth);
  return terms.penetration(penetration);
}

/// The right manifold whose normal is nearest to that of the answer.
const Manifold<double>& nearest_to(const std::vector<Manifold<double>>& right, const Said& got) {
  const auto distance = [&](const Manifold<double>& one) {
    if (!got.touches || !got.normal || one.count == 0) return one.count == 0 ? INFINITY : 0.0;
    return (one.normal - *got.normal).norm();
  };
  return *std::ranges::min_element(right, {}, distance);
}

/// The contact along the answer's own normal, where no other has clearly less depth; none of
/// mitred corners, which have faces' normals alone, nor where another direction is the nearest.
std::optional<Manifold<double>> right_along_own(const PairCase& pair, const DeclaredAnswer& asked) {
  const Said got = said_by(asked.answer);
  if (!is_judged_by_curve(asked.declaration, pair) || !got.normal || got.normal->isZero(0) ||
      !got.normal->allFinite()) {
    return std::nullopt;
  }
  const exact::Truth truth(pair);
  const CurveAnswer answer(truth, asked.declaration, got,
                           curve_bounds(pair, asked.declaration, truth.extent()));
  const exact::Along along(truth, *got.normal);
  const bool is_mitred = total_radius(pair) > 0 && !is_round(pair);
  if (is_mitred || answer.curve().compare_least(0) < 0 || !answer.is_minimal(along)) {
    return std::nullopt;
  }
  return contact_along(pair, got.normal->normalized(), along.depth(), asked.declaration);
}

}  // namespace

std::string short_figure(double value) {
  return fmt::format("{:.4g}", value + 0.0);
}

double true_depth(const PairCase& pair) {
  return total_radius(pair) - exact::separation_of(exact::Truth(pair));
}

RightContact right_contact(const PairCase& pair, const DeclaredAnswer& asked) {
  if (const auto along_own = right_along_own(pair, asked)) {
    return {.manifold = along_own, .count = 1, .is_along_own = true};
  }
  const std::vector<Manifold<double>> right =
      manifolds_to_show(admissible(pair, asked.declaration), asked.declaration);
  if (right.empty()) return {};
  return {.manifold = nearest_to(right, said_by(asked.answer)),
          .count = static_cast<int>(right.size())};
}

std::string got_in_words(const PairCase& pair, const DeclaredAnswer& asked, const Program& program,
                         Detail detail) {
  const EngineTerms terms(pair, asked.declaration, program, detail);
  if (const auto* const said = std::get_if<Penetration>(&asked.answer)) {
    return terms.penetration(*said);
  }
  const auto* const lost = std::get_if<Lost>(&asked.answer);
  if (lost != nullptr && lost->why.ends_with("is null; a number is expected")) {
    return "a contact with figures that are no numbers";  // JSON has neither nan nor infinity
  }
  const Manifold<double>* const manifold = asked.manifold();
  return manifold == nullptr ? answer_in_words(asked) : terms.got(*manifold);
}

std::string expected_in_words(const PairCase& pair, const DeclaredAnswer& asked,
                              const Program& program, Detail detail) {
  const EngineTerms terms(pair, asked.declaration, program, detail);
  const RightContact right = right_contact(pair, asked);
  const std::string text =
      right.manifold ? in_terms(terms, asked.declaration, *right.manifold) : program.none;
  if (right.count <= 1) return text;
  return fmt::format("{}; or another of {} that are right", text, right.count);
}

}  // namespace manifuzz
