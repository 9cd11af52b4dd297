#include "judging/properties.hpp"

#include <algorithm>
#include <array>

#include "judging/inquiry.hpp"
#include "judging/ledger.hpp"

namespace manifuzz {
namespace {

constexpr std::array kProperties{
    Property{"swapping-mirrors", "swapping A and B mirrors the manifold, outside ties",
             swapping_mirrors},
    Property{"renumbering", "renumbering the vertices changes features only, outside ties",
             renumbering_changes_features_only},
    Property{"quarter-turns", "a quarter turn of the world moves the manifold along, outside ties",
             quarter_turns_move},
    Property{"translations",
             "a translation that floats can represent moves the manifold along, outside ties",
             translations_move},
    Property{"powers-of-two", "scaling by a power of two scales the manifold, bit for bit",
             powers_of_two_scale},
    Property{"given-normal", "the given-normal entry agrees with collide, outside ties",
             given_normal_agrees},
    Property{"points-in-place",
             "points lie on the incident edge, in the slab, behind the reference face, in order",
             points_lie_where_they_say},
    Property{"depth-is-overlap",
             "at bias 0 and S <= 0 the largest depth is the total radius minus S",
             depth_is_the_overlap},
    Property{"depth-moves-apart",
             "moving B by the depth along the normal leaves them touching at zero, and on by t "
             "separates them by t",
             depth_moves_apart},
    Property{"float-and-double", "float and double agree within bound", float_and_double_agree},
    Property{"never-empty", "overlapping is never empty", overlap_is_never_empty},
    Property{"admissible", "every manifold is one of the right ones, within bound",
             manifold_is_admissible},
};

bool is_explained(const Collider& collider, const PairCase& pair) {
  const Answer answer = ask(collider, pair);
  const auto* got = std::get_if<Manifold<double>>(&answer);
  if (got == nullptr) return false;
  const Admissible right = admissible(pair, collider.declaration);
  const Kind kind = mismatch(*got, right).kind;
  return kind != Kind::none &&
         find_explanation(collider.declaration.name, {right, *got, kind}) != nullptr;
}

}  // namespace

std::span<const Property> properties() {
  return kProperties;
}

const Property* find_property(std::string_view name) {
  const auto found = std::find_if(kProperties.begin(), kProperties.end(),
                                  [name](const Property& p) { return p.name == name; });
  return found == kProperties.end() ? nullptr : &*found;
}

Outcome check(const Property& property, const Collider& collider, const PairCase& pair) {
  if (is_ill_posed(pair, bounds(pair, collider.declaration))) return not_applicable();
  Inquiry ask(collider);
  Outcome outcome = property.holds(ask, pair);
  if (ask.lost()) return fails("no answer: " + ask.lost()->why, 1);
  if (outcome.kind == Outcome::Kind::fails &&
      std::any_of(ask.asked().begin(), ask.asked().end(),
                  [&](const PairCase& asked) { return is_explained(collider, asked); })) {
    outcome.kind = Outcome::Kind::known;
  }
  return outcome;
}

std::optional<Admissible> decided(const PairCase& pair, const Declaration& declaration) {
  Admissible right = admissible(pair, declaration);
  if (is_ill_posed(pair, right.bounds) || right.candidates.size() != 1) return std::nullopt;
  const exact::Clip& only = *right.candidates.front();
  const double undecided = declaration.tie_bias + right.bounds.separation;
  const bool leads = right.truth->compare_lead_of_b(undecided) > 0 ||
                     right.truth->compare_lead_of_b(-undecided) < 0;
  if (!leads || right.may_be_apart || only.count < 2 || may_miss(right, only)) return std::nullopt;
  for (const exact::ClipPoint& point : only.points) {
    const double depth = depth_bound(right, only, point);
    if (!features_decided(right, only, point) || (compare_depth(pair, only, point, depth) <= 0 &&
                                                  compare_depth(pair, only, point, -depth) >= 0)) {
      return std::nullopt;
    }
  }
  return right;
}

Tolerance tolerance(const Admissible& right) {
  Tolerance within{.normal = 2 * right.bounds.normal, .position = 0, .depth = 0};
  const exact::Clip& clip = *right.candidates.front();
  for (int i = 0; i < clip.count; ++i) {
    within.position = std::max(within.position, 2 * position_bound(right, clip, clip.points[i]));
    within.depth = std::max(within.depth, 2 * depth_bound(right, clip, clip.points[i]));
  }
  return within;
}

Outcome same_manifold(const PairCase& pair, const Manifold<double>& expected,
                      const Manifold<double>& got, const Tolerance& within, Features features) {
  const double unit = size(pair);
  if (expected.count != got.count) return fails("another number of points", 1);
  if (expected.count == 0) return holds();
  if (expected.reference != got.reference) return fails("another reference polygon", 1);
  const double turn = (expected.normal - got.normal).norm();
  if (!(turn <= within.normal)) return fails("another normal", turn);
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
  }
  return holds();
}

}  // namespace manifuzz
