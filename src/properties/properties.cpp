#include "properties/properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "generating/drafts.hpp"
#include "judging/by_curve.hpp"
#include "judging/compare.hpp"
#include "judging/ledger.hpp"
#include "properties/round_answer.hpp"

namespace manifuzz {
namespace {

#define MANIFUZZ_ENTRY(function, name, sentence) Property{name, sentence, function},
constexpr std::array kProperties{MANIFUZZ_PROPERTIES(MANIFUZZ_ENTRY)};
#undef MANIFUZZ_ENTRY

bool is_explained(const Collider& collider, const PairCase& pair) {
  const Answer answer = ask(collider, pair);
  const auto* got = std::get_if<Manifold<double>>(&answer);
  if (got == nullptr) return false;
  const Admissible right = admissible(pair, collider.declaration);
  const Kind kind = is_round(pair) ? judge_by_curve(*right.truth, collider.declaration, answer).kind
                                   : mismatch(*got, right).kind;
  return kind != Kind::none &&
         find_explanation(collider.declaration.name, {right, *got, kind}) != nullptr;
}

}  // namespace

std::span<const Property> properties() {
  return kProperties;
}

PropertyOutcome check(const Property& property, const Collider& collider, const PairCase& pair) {
  if (is_ill_posed(size(pair), bounds(pair, collider.declaration))) return not_applicable();
  AskedCollider ask(collider);
  PropertyOutcome outcome = property.holds(ask, pair);
  if (ask.lost()) return fails("no answer: " + ask.lost()->why, 1);
  // A figure that is no number is beyond all that are.
  if (!std::isfinite(outcome.magnitude)) outcome.magnitude = std::numeric_limits<double>::max();
  if (outcome.kind == PropertyOutcome::Kind::fails &&
      std::any_of(ask.asked().begin(), ask.asked().end(),
                  [&](const PairCase& asked) { return is_explained(collider, asked); })) {
    outcome.kind = PropertyOutcome::Kind::known;
  }
  return outcome;
}

std::optional<Admissible> decided(const PairCase& pair, const Declaration& declaration) {
  if (declaration.claims != Claims::manifold) return std::nullopt;  // any of its points will do
  Admissible right = admissible(pair, declaration);
  if (is_ill_posed(right.truth->size(), right.bounds)) return std::nullopt;
  if (right.candidates.size() != 1) return std::nullopt;
  const exact::Clip& only = *right.candidates.front();
  // Either side leads by more than a bias towards any of them.
  const TieBias& bias = declaration.tie_bias;
  const double undecided = bias.absolute + right.bounds.separation;
  const bool leads = std::ranges::any_of(std::array{Side::a, Side::b}, [&](Side side) {
    return right.truth->compare_lead(side, 1, undecided) > 0 &&
           right.truth->compare_lead(side, 1 - bias.relative, undecided) > 0;
  });
  if (!leads || right.may_be_apart || only.count < 2 || may_miss(right, only)) return std::nullopt;
  for (const exact::ClipPoint& point : only.points) {
    if (!features_decided(right, only, point) || is_at_zero_depth(right, only, point)) {
      return std::nullopt;
    }
  }
  return right;
}

ManifoldError tolerance(const Admissible& right) {
  ManifoldError within{.normal = 2 * right.bounds.normal};
  const exact::Clip& clip = *right.candidates.front();
  for (const exact::ClipPoint& point : points_of(clip)) {
    widen(within, {.position = 2 * position_bound(right, clip, point),
                   .depth = 2 * depth_bound(right, clip, point)});
  }
  return within;
}

PropertyOutcome same_manifold(const PairCase& pair, const Manifold<double>& expected,
                              const Manifold<double>& got, const ManifoldError& within,
                              Features features) {
  const double unit = size(pair);
  if (expected.count != got.count) return fails("another number of points", 1);
  if (expected.count == 0) return holds();
  if (expected.reference != got.reference) return fails("another reference polygon", 1);
  const double turn = (expected.normal - got.normal).norm();
  if (!(turn <= within.normal)) return fails("another normal", turn);
  double of_bound = taken_of(within.normal, turn);
  for (int i = 0; i < expected.count; ++i) {
    const auto& p = expected.points[i];
    const auto& q = got.points[i];
    const double off = (p.position - q.position).norm();
    if (!(off <= within.position)) return fails("another position", off / unit);
    const double deeper = std::abs(p.depth - q.depth);
    if (!(deeper <= within.depth)) return fails("another depth", deeper / unit);
    if (features == Features::compared && p.features != q.features) {
      return fails("other features", 0);
    }
    of_bound = std::max({of_bound, taken_of(within.position, off), taken_of(within.depth, deeper)});
  }
  return holds(of_bound);
}

namespace {

/// A point of B's frame in A's, the positions subtracted first.
Vector2<double> from_b_to_a(const PairCase& pair, const Vector2<double>& local_of_b) {
  using exact::DoubleDouble;
  const auto apart = exact::widen<DoubleDouble>(pair.b.pose.position) -
                     exact::widen<DoubleDouble>(pair.a.pose.position);
  const auto from_a = exact::turned_back(
      pair.a, exact::turned(pair.b, exact::widen<DoubleDouble>(local_of_b)) + apart);
  const DoubleDouble scale = exact::scale<DoubleDouble>(pair.a);
  return {exact::leading(from_a.x / scale), exact::leading(from_a.y / scale)};
}

/// A unit direction of B's frame in A's.
Vector2<double> turned_from_b_to_a(const PairCase& pair, const Vector2<double>& direction) {
  const Vector2<double> world = rotate<double>(pair.b.pose.rotation.cast<double>(), direction);
  const Vector2<double> local = rotate_back<double>(pair.a.pose.rotation.cast<double>(), world);
  return local / local.norm();
}

/// A manifold of the swapped pair as one of the pair itself.
Manifold<double> swapped_back(const PairCase& pair, Manifold<double> manifold) {
  manifold.reference = other(manifold.reference);
  manifold.normal = -turned_from_b_to_a(pair, manifold.normal);
  for (int i = 0; i < manifold.count; ++i) {
    auto& point = manifold.points[i];
    point.position = from_b_to_a(pair, point.position);
    std::swap(point.features.a, point.features.b);
  }
  return manifold;
}

/// Asks for both, and compares what `back` makes of the second with the first.
template <class Back>
PropertyOutcome compare_moved(AskedCollider& ask, const PairCase& pair, const PairCase& moved,
                              Features features, Back back) {
  if (is_round(pair)) return same_round_contact(ask, pair, moved, back);
  const auto right = decided(pair, ask.declaration());
  const auto right_moved = decided(moved, ask.declaration());
  if (!right || !right_moved) return not_applicable();
  const auto here = ask.manifold(pair);
  const auto there = ask.manifold(moved);
  if (!here || !there) return not_applicable();
  const ManifoldError p = tolerance(*right);
  const ManifoldError q = tolerance(*right_moved);
  const ManifoldError within{(p.normal + q.normal) / 2, (p.position + q.position) / 2,
                             (p.depth + q.depth) / 2};
  return same_manifold(pair, *here, back(*there), within, features);
}

/// `by` added to both coordinates, if every bit of the sum fits a float.
std::optional<Vector2<float>> translated(const Vector2<float>& v, float by) {
  const Vector2<float> sum = v + Vector2<float>(by, by);
  for (int i = 0; i < 2; ++i) {
    const double back = static_cast<double>(sum[i]) - static_cast<double>(by);
    if (back != static_cast<double>(v[i]) || !std::isfinite(sum[i])) return std::nullopt;
  }
  return sum;
}

/// Far enough from the ends of the range that no product of two numbers leaves it when scaled.
bool is_in_mid_range(const Body& body) {
  const auto in_range = [](float x) {
    const float magnitude = std::abs(x);
    return magnitude == 0 || (magnitude > 0x1p-24F && magnitude < 0x1p24F);
  };
  const auto both = [&](const Vector2<float>& v) { return in_range(v.x()) && in_range(v.y()); };
  const auto corners = body.polygon.corners();
  return std::all_of(corners.begin(), corners.end(), both) && both(body.pose.position) &&
         both(body.pose.rotation) && in_range(body.polygon.radius);
}

/// Whether it declares a length, besides its tie bias, that does not grow with the shapes.
bool has_fixed_length(const Declaration& declaration) {
  return declaration.speculative != 0 || declaration.least_depth != 0 ||
         declaration.tolerance.absolute != 0;
}

}  // namespace

PropertyOutcome swapping_mirrors(AskedCollider& ask, const PairCase& pair) {
  return compare_moved(ask, pair, {pair.b, pair.a}, Features::compared,
                       [&](const Manifold<double>& m) { return swapped_back(pair, m); });
}

PropertyOutcome renumbering_changes_features_only(AskedCollider& ask, const PairCase& pair) {
  PairCase other_numbers = pair;
  renumber(other_numbers.a.polygon);
  renumber(other_numbers.b.polygon);
  return compare_moved(ask, pair, other_numbers, Features::ignored, std::identity());
}

PropertyOutcome quarter_turns_move(AskedCollider& ask, const PairCase& pair) {
  PairCase turned = pair;
  turn_by_quarter(turned);
  return compare_moved(ask, pair, turned, Features::compared, std::identity());
}

PropertyOutcome translations_move(AskedCollider& ask, const PairCase& pair) {
  PairCase moved = pair;
  for (const float by : {4096.0F, 64.0F, 1.0F, 0.015625F}) {
    const auto a = translated(pair.a.pose.position, by);
    const auto b = translated(pair.b.pose.position, by);
    if (!a || !b) continue;
    moved.a.pose.position = *a;
    moved.b.pose.position = *b;
    return compare_moved(ask, pair, moved, Features::compared, std::identity());
  }
  return not_applicable();
}

PropertyOutcome powers_of_two_scale(AskedCollider& ask, const PairCase& pair) {
  const TieBias& bias = ask.declaration().tie_bias;
  if (!is_in_mid_range(pair.a) || !is_in_mid_range(pair.b)) return not_applicable();
  if (bias.absolute != 0 && !ask.collider().with_tie_bias) return not_applicable();
  if (has_fixed_length(ask.declaration())) return not_applicable();
  const auto here = ask.manifold(pair);
  if (!here) return not_applicable();
  for (const float factor : {0x1p-12F, 0x1p9F}) {
    const double scale = static_cast<double>(factor);
    const Collider collider =
        bias.absolute == 0 ? ask.collider() : ask.collider().with_tie_bias(bias.absolute * scale);
    PairCase scaled = pair;
    scale_lengths(scaled, factor);
    const Answer there = manifuzz::ask(collider, scaled);
    Manifold<double> expected = *here;
    for (int i = 0; i < expected.count; ++i) {
      expected.points[i].position *= scale;
      expected.points[i].depth *= scale;
    }
    const auto* const got = std::get_if<Manifold<double>>(&there);
    if (got == nullptr) return not_applicable();
    if (*got != expected) return fails("another manifold when scaled", 1);
  }
  return holds();
}

}  // namespace manifuzz
