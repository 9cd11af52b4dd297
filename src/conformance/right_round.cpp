#include "conformance/right_round.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "conformance/widened.hpp"
#include "exact/fine_point.hpp"
#include "exchange/json.hpp"
#include "judging/curve_answer.hpp"
#include "judging/round_contact.hpp"
#include "judging/second_point.hpp"

namespace manifuzz {
namespace {

/// The second point of answers with right normals.
struct SecondOf {
  bool is_allowed = false;
  bool is_required = false;
  double span = 0;  ///< that both points must have along the tangent, a world length

  /// Whether both allow and require the same, and their spans are equal but for rounding.
  bool is_alike(const SecondOf& other) const {
    constexpr double kRounding = 1e-3;
    return is_allowed == other.is_allowed && is_required == other.is_required &&
           std::abs(span - other.span) <= kRounding * std::max(span, other.span);
  }
};

/// What is right in one scalar.
class RoundInScalar {
 public:
  RoundInScalar(const exact::Truth& truth, ScalarType scalar)
      : truth_(truth),
        declaration_(port_declaration(scalar)),
        bounds_(bounds(truth.pair(), declaration_, truth.extent())),
        of_curve_(curve_bounds(truth.pair(), declaration_, truth.extent())),
        answer_(truth, declaration_, said_, of_curve_) {}

  const CurveAnswer& answer() const { return answer_; }
  const CurveBounds& within() const { return of_curve_; }
  bool may_be_empty() const { return answer_.curve().compare_least(of_curve_.touching) <= 0; }
  bool may_touch() const { return answer_.curve().compare_least(-of_curve_.touching) >= 0; }
  bool may_be_apart() const {
    return !truth_.has_faces() || truth_.compare_separation(-of_curve_.touching) >= 0;
  }

  /// None where it depends on the normal.
  std::optional<SecondOf> second() const {
    std::optional<SecondOf> all;
    for (const Vector2<double>& normal : right_normals()) {
      const SecondOf one = second_at(normal);
      if (all && !all->is_alike(one)) return std::nullopt;
      const double span = all ? std::min(all->span, one.span) : one.span;
      all = one;
      all->span = span;
    }
    return all;
  }

 private:
  bool is_right(const Vector2<double>& normal) const {
    return answer_.is_minimal(exact::Along(truth_, normal));
  }

  /// From each least value of the curve, and each nearest direction, as far both ways as normals
  /// are right; in A's frame.
  std::vector<Vector2<double>> right_normals() const {
    std::vector<Vector2<double>> middles = answer_.curve().minima(of_curve_.minimality);
    if (answer_.nearest().may_be_near()) {
      for (const auto& [x, y] : answer_.nearest().directions()) {
        middles.push_back(local_normal(truth_.pair(), {x.high, y.high}));
      }
    }
    std::vector<Vector2<double>> normals;
    for (const Vector2<double>& middle : middles) {
      if (!is_right(middle)) continue;
      normals.push_back(middle);
      for (const double way : {1.0, -1.0}) add_turned(middle, way, normals);
    }
    return normals;
  }

  void add_turned(const Vector2<double>& middle, double way,
                  std::vector<Vector2<double>>& normals) const {
    constexpr double kMost = 64;   // all but a quarter turn
    constexpr int kHalvings = 20;  // to where right ones end
    const auto add = [&](double turn) {
      const Vector2<double> turned =
          unit_direction(middle + way * turn * counter_clockwise_quarter(middle));
      if (!is_right(turned)) return false;
      normals.push_back(turned);
      return true;
    };
    double right = 0;
    double wrong = of_curve_.normal / 8;
    for (; wrong < kMost && add(wrong); wrong *= 1.25) right = wrong;
    for (int i = 0; i < kHalvings; ++i) {
      const double half = right + (wrong - right) / 2;
      (add(half) ? right : wrong) = half;
    }
  }

  SecondOf second_at(const Vector2<double>& normal) const {
    Manifold<double> manifold;
    manifold.normal = normal;
    const auto found_of = [&](int count) {
      manifold.count = count;
      return second_point_mismatch(truth_, declaration_, bounds_, manifold);
    };
    SecondOf second;
    second.is_required = found_of(1).has_value();
    const auto of_two = found_of(2);  // both at one place
    second.is_allowed = !of_two || of_two->kind != Kind::count;
    if (of_two && second.is_allowed) {
      second.span = std::max(of_two->magnitude - of_two->bound, 0.0);
    }
    return second;
  }

  const exact::Truth& truth_;
  Declaration declaration_;
  Bounds bounds_;
  CurveBounds of_curve_;
  Said said_{.touches = true, .normal = {}, .depth = 0, .manifold = nullptr};
  CurveAnswer answer_;
};

void append_key_of(std::string& out, std::string_view key) {
  if (out.back() != '{') out += ", ";
  out.append("\"").append(key) += "\": ";
}

/// Each once, as two figures and what they lost where they were written.
void append_directions(std::string& out, const std::vector<exact::FinePoint>& directions) {
  std::vector<std::string> texts;
  for (const auto& [x, y] : directions) {
    std::string text = "[";
    append_number(text, x.high);
    append_number(text += ',', y.high);
    append_low(text += ',', x);
    append_low(text += ',', y);
    text += ']';
    if (std::ranges::count(texts, text) == 0) texts.push_back(text);
  }
  out += fmt::format("[{}]", fmt::join(texts, ","));
}

void append_round(std::string& out, const exact::Truth& truth, const RoundInScalar& in,
                  const SecondOf& second) {
  // What a checker in doubles loses on a length.
  const double of_lengths = 0x1p-51 * (truth.extent() + total_radius(truth.pair()));
  const CurveBounds& within = in.within();
  const NearestNormal& nearest = in.answer().nearest();
  const auto append = [&](std::string_view key, double bound) {
    append_key_of(out, key);
    append_widened(out, bound);
  };
  out += '{';
  append("unit", within.normal);
  if (nearest.may_be_near()) {
    append_key_of(out, "nearest");
    append_directions(out, nearest.directions());
    append("turn", nearest.bound());
  }
  if (!nearest.must_be_near()) append("excess", within.minimality + of_lengths);
  if (in.may_be_apart()) append("depth", within.touching + of_lengths);
  if (!nearest.decides()) append("shortfall", within.minimality + of_lengths);
  append("consistency", within.consistency + of_lengths);
  append("along", within.along + of_lengths);
  append("across", within.across + of_lengths);
  append_key_of(out, "points");
  out += second.is_required ? "[2,2]" : second.is_allowed ? "[1,2]" : "[1,1]";
  if (second.span > 0) {
    append_key_of(out, "span");
    append_number(out, second.span - of_lengths);
  }
  out += '}';
}

}  // namespace

bool append_right_round(std::string& out, const exact::Truth& truth) {
  std::string empty;
  std::string contacts;
  double least = 0;
  for (const ScalarType scalar : kScalars) {
    const RoundInScalar in(truth, scalar);
    least = in.answer().curve().least();
    if (in.may_be_empty()) {
      empty.append(empty.empty() ? "\"" : ",\"").append(scalar_key(scalar)) += '"';
    }
    if (!in.may_touch()) continue;
    const auto second = in.second();
    if (!second) return false;
    contacts.append(", \"").append(scalar_key(scalar)) += "\": ";
    append_round(contacts, truth, in, *second);
  }
  append_number(out.append("\"empty\": [").append(empty) += "], \"round\": {\"least\": ", least);
  out.append(contacts) += '}';
  return true;
}

}  // namespace manifuzz
