#include "properties/round_answer.hpp"

#include <algorithm>
#include <cmath>

#include "judging/bound_shares.hpp"
#include "judging/curve_answer.hpp"
#include "judging/judge.hpp"

namespace manifuzz {
namespace {

/// The declared lengths by which a right depth may lie off besides rounding.
double declared_slack(const exact::Truth& truth, const Declaration& declaration) {
  const TieBias& bias = declaration.tie_bias;
  return tolerance_of(truth, declaration) + bias.absolute +
         bias.relative * std::abs(exact::separation_of(truth));
}

/// How far two places lie apart across a normal.
double across(const Vector2<double>& normal, const Vector2<double>& from,
              const Vector2<double>& to) {
  return std::abs(cross<double>(normal, to - from));
}

bool has_circle(const PairCase& pair) {
  return pair.a.polygon.count == 1 || pair.b.polygon.count == 1;
}

PropertyOutcome same_normal_and_place(const PairCase& pair, const RoundAnswer& here,
                                      const RoundAnswer& there,
                                      const Manifold<double>& moved_back) {
  const double turn = (here.manifold().normal - moved_back.normal).norm();
  const double within = here.normal_bound() + there.normal_bound();
  if (!(turn <= within)) {
    const bool is_tie = here.has_right_normal() && there.has_right_normal();
    return is_tie ? not_applicable() : fails("another normal", turn);
  }
  const double of_bound = taken_of(within, turn);
  if (!has_circle(pair)) return holds(of_bound);
  // On the line through the circle's center, a radius and a depth from it at most.
  const ContactPoint<double>& other_deepest = moved_back.points[deepest_of(moved_back)];
  const double off =
      across(here.manifold().normal, here.deepest().position, other_deepest.position);
  const auto along = [](const RoundAnswer& answer) {
    return answer.within().position + answer.within().separation;
  };
  const double arm = total_radius(pair) + std::abs(here.deepest().depth);
  const double bound = along(here) + along(there) + within * arm;
  if (off <= bound) return holds(std::max(of_bound, taken_of(bound, off)));
  return fails("another position", off / size(pair));
}

}  // namespace

double taken_within(double width, double beyond) {
  return std::isfinite(width) ? taken_of(width, width + beyond) : 0;
}

RoundAnswer::RoundAnswer(AskedCollider& ask, const PairCase& pair)
    : truth_(pair),
      curve_(truth_, exact::skin_of(truth_)),
      bounds_(bounds(pair, ask.declaration())),
      nearest_(truth_, curve_, bounds_.separation, bounds_.normal),
      minimality_(curve_bounds(pair, ask.declaration(), truth_.extent()).minimality),
      manifold_(ask.manifold(pair)),
      least_(-INFINITY),
      most_(INFINITY) {
  if (manifold_) read_depth(ask.declaration());
}

const ContactPoint<double>& RoundAnswer::deepest() const {
  return manifold_->points[deepest_of(*manifold_)];
}

double RoundAnswer::distance() const {
  return exact::separation_of(truth_) - bounds_.separation;
}

void RoundAnswer::read_depth(const Declaration& declaration) {
  const double slack = declared_slack(truth_, declaration);
  if (!touches()) {
    most_ = bounds_.separation + slack + declaration.least_depth;
    return;
  }
  const double depth = deepest().depth;
  const double off = nearest_.decides() ? bounds_.separation : minimality_;
  least_ = depth - off - slack - (depth > 0 ? 0 : declaration.speculative);
  most_ = depth + off + slack;
}

PropertyOutcome same_round_contact(
    AskedCollider& ask, const PairCase& pair, const PairCase& moved,
    const std::function<Manifold<double>(const Manifold<double>&)>& back) {
  const RoundAnswer here(ask, pair);
  const RoundAnswer there(ask, moved);
  if (!here.is_given() || !there.is_given()) return not_applicable();
  const double apart = std::max(here.least() - there.most(), there.least() - here.most());
  if (!(apart <= 0)) return fails("another depth", apart / size(pair));
  const double of_depth = taken_within(here.half_width() + there.half_width(), apart);
  if (!here.tells_normal() || !there.tells_normal()) return holds(of_depth);
  PropertyOutcome outcome = same_normal_and_place(pair, here, there, back(there.manifold()));
  if (outcome.kind == PropertyOutcome::Kind::not_applicable) return holds(of_depth);
  outcome.of_bound = std::max(outcome.of_bound, of_depth);
  return outcome;
}

PropertyOutcome round_depth_is_least(AskedCollider& ask, const PairCase& pair) {
  const RoundAnswer answer(ask, pair);
  if (!answer.touches()) return not_applicable();
  const double least = answer.curve().least();
  const double off = std::max(answer.least() - least, least - answer.most());
  if (off <= 0) return holds(taken_within(answer.half_width(), off));
  return fails("a largest depth that is not the least overlap", off / size(pair));
}

PropertyOutcome round_depth_moves_apart(AskedCollider& ask, const PairCase& pair) {
  const RoundAnswer answer(ask, pair);
  if (!answer.touches()) return not_applicable();
  // By how much D at the normal may exceed D*.
  double excess = answer.minimality();
  if (answer.tells_normal()) excess = std::max(excess, answer.normal_bound() * extent(pair));
  const Vector2<double> normal = world_normal(pair, answer.manifold().normal);
  double of_bound = 0;
  for (const double further : {0.0, size(pair) / 4}) {
    const double by = answer.deepest().depth + further;
    PairCase moved = pair;
    const Vector2<double> start = pair.b.pose.position.cast<double>();
    moved.b.pose.position = Vector2<double>(start + by * normal).cast<float>();
    const Vector2<double> shift = moved.b.pose.position.cast<double>() - start;
    const double rounding = (shift - by * normal).norm();
    const exact::Truth truth(moved);
    const double left = exact::PenetrationCurve(truth, exact::Skin::round).least() + further;
    const double depth_off =
        answer.most() - answer.deepest().depth + rounding + answer.within().normal * by;
    if (left > excess + depth_off) {
      return fails(further == 0 ? "still overlapping when moved by the depth"
                                : "not as far apart as it was moved",
                   left / size(pair));
    }
    if (left < -depth_off) return fails("farther apart than it was moved", -left / size(pair));
    // What the move was rounded by is known, and nobody's error.
    of_bound = std::max({of_bound, taken_of(excess + depth_off - rounding, left - rounding),
                         taken_of(depth_off - rounding, -left - rounding)});
  }
  return holds(of_bound);
}

PropertyOutcome round_overlap_is_never_empty(AskedCollider& ask, const PairCase& pair) {
  const RoundAnswer answer(ask, pair);
  if (!answer.is_given()) return not_applicable();
  const double least = answer.curve().least();
  if (answer.touches() || answer.most() >= least) return holds();
  return fails("no contact for an overlap", least / size(pair));
}

PropertyOutcome manifold_is_right_by_curve(AskedCollider& ask, const PairCase& pair) {
  const auto manifold = ask.manifold(pair);
  if (!manifold) return not_applicable();
  const ColliderAnswer answer{ask.declaration(), *manifold};
  const Judgement judgement = judge(pair, answer, answer);
  if (judgement.bucket.fault == Fault::none) {
    const ManifoldError shares = curve_shares(exact::Truth(pair), answer);
    return holds(std::max(shares.normal, shares.depth));
  }
  return fails("wrong: " + std::string(name_of(judgement.bucket.kind, kKindNames)),
               judgement.magnitude);
}

}  // namespace manifuzz
