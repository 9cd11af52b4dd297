#include "judging/unjudged.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "judging/by_curve.hpp"

namespace manifuzz {
namespace {

/// A NaN without its sign, which differs between machines.
std::string in_words(double value) {
  return std::isnan(value) ? "nan" : fmt::format("{}", value);
}

std::string in_words(const Vector2<double>& v) {
  return fmt::format("({}, {})", in_words(v.x()), in_words(v.y()));
}

/// Says of a figure, by its name, that it is not finite.
std::string not_finite(std::string_view name, const std::string& value) {
  return fmt::format("{} {} is not finite; smaller coordinates are expected", name, value);
}

std::optional<std::string> why_malformed(const PairCase& pair, const ContactPoint<double>& point,
                                         bool may_be_apart) {
  if (!point.position.allFinite()) return not_finite("position", in_words(point.position));
  if (!std::isfinite(point.depth)) return not_finite("depth", in_words(point.depth));
  if (point.depth < 0 && !may_be_apart) {
    return fmt::format("depth {} is below 0; 0 or more is expected", point.depth);
  }
  for (const Side side : {Side::a, Side::b}) {
    const Feature& feature = side == Side::a ? point.features.a : point.features.b;
    const int count = pair[side].polygon.count;
    if (feature.index < count) continue;
    return fmt::format("names {} {} of {}, which has {}",
                       feature.kind == Feature::Kind::face ? "face" : "vertex", feature.index,
                       side == Side::a ? 'A' : 'B', count);
  }
  return std::nullopt;
}

std::optional<std::string> why_malformed(const PairCase& pair, const Manifold<double>& m,
                                         bool may_be_apart) {
  if (m.count < 0 || m.count > 2) return fmt::format("{} points; 0 to 2 are expected", m.count);
  if (m.count > 0 && !m.normal.allFinite()) return not_finite("normal", in_words(m.normal));
  for (int i = 0; i < m.count; ++i) {
    const auto why = why_malformed(pair, m.points[i], may_be_apart);
    if (why) return fmt::format("point {}: {}", i, *why);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_malformed(const PairCase& pair, const Manifold<double>& manifold) {
  return why_malformed(pair, manifold, false);
}

std::optional<std::string> why_malformed(const PairCase& pair, const ColliderAnswer& given) {
  const Answer& answer = given.answer;
  if (const UsedShapes* const used = used_by(answer)) {
    for (const UsedVertices& vertices : {used->a, used->b}) {
      for (const Vector2<double>& v : vertices.corners()) {
        if (!v.allFinite()) return not_finite("vertex of the shapes", in_words(v));
      }
      const double radius = static_cast<double>(vertices.round_radius.value_or(0));
      if (!(radius >= 0 && std::isfinite(radius))) {
        return not_finite("radius of the shapes", in_words(radius));
      }
    }
  }
  if (const auto* const less = std::get_if<Penetration>(&answer)) {
    if (!std::isfinite(less->depth)) return not_finite("depth", in_words(less->depth));
    if (!less->normal || less->normal->allFinite()) return std::nullopt;
    return not_finite("normal", in_words(*less->normal));
  }
  const Manifold<double>* const manifold = manifold_in(answer);
  if (manifold == nullptr) return std::nullopt;
  return why_malformed(pair, *manifold, given.declaration.speculative > 0);
}

std::optional<std::string> why_lost(const PairCase& pair, const ColliderAnswer& given) {
  if (const auto* const lost = std::get_if<Lost>(&given.answer)) return lost->why;
  return why_malformed(pair, given);
}

namespace {

Verdict verdict_of(Lost::How how) {
  constexpr std::array verdicts{Verdict::crashed, Verdict::timed_out, Verdict::malformed};
  return verdicts[static_cast<std::size_t>(how)];
}

/// An answer that is no manifold to judge, as the finding that it is by itself: lost, or nonsense.
std::optional<Bucket> without_manifold(const PairCase& pair, const ColliderAnswer& given,
                                       Fault fault) {
  const Answer& answer = given.answer;
  if (const auto* const lost = std::get_if<Lost>(&answer)) {
    return bucket_of_lost(verdict_of(lost->how), fault);
  }
  if (!why_malformed(pair, given)) return std::nullopt;
  return bucket_of_lost(Verdict::malformed, fault);
}

/// The wider of both colliders' bounds.
Bounds wider_bounds(const exact::Truth& truth, const ColliderAnswer& subject,
                    const ColliderAnswer& oracle) {
  const auto of = [&](const ColliderAnswer& given) {
    return bounds(truth.pair(), given.declaration, truth.extent());
  };
  return std::max(of(subject), of(oracle),
                  [](const Bounds& a, const Bounds& b) { return a.separation < b.separation; });
}

}  // namespace

bool hides_all(const exact::Truth& truth, const ColliderAnswer& subject,
               const ColliderAnswer& oracle) {
  return is_ill_posed(truth.size(), wider_bounds(truth, subject, oracle)) ||
         std::max(tolerance_of(truth, subject.declaration),
                  tolerance_of(truth, oracle.declaration)) > kIllPosedShare * truth.size();
}

std::optional<Bucket> without_judging(const exact::Truth& truth, const ColliderAnswer& subject,
                                      const ColliderAnswer& oracle) {
  const PairCase& pair = truth.pair();
  // What overflows in the collider's scalar is no nonsense of the collider's.
  if (!std::isfinite(wider_bounds(truth, subject, oracle).separation)) {
    return Bucket{.verdict = Verdict::ill_posed};
  }
  if (const auto bucket = without_manifold(pair, subject, Fault::subject)) return bucket;
  if (const auto bucket = without_manifold(pair, oracle, Fault::oracle)) return bucket;
  if (std::holds_alternative<Unsupported>(subject.answer) ||
      std::holds_alternative<Unsupported>(oracle.answer)) {
    return Bucket{.verdict = Verdict::unsupported};
  }
  return std::nullopt;
}

}  // namespace manifuzz
