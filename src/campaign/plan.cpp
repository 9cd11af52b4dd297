#include "campaign/plan.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "sequence/sequence_judge.hpp"

namespace manifuzz {

DeclaredAnswer declared_answer(const Collider& collider, const PairCase& pair,
                               Interruption& interruption) {
  return {collider.declaration, ask_in_child(collider, pair, interruption)};
}

namespace {

Standing standing_of(const PairCase& pair) {
  return standing(exact::Truth(pair));
}

/// Whether it touches in any frame, or else comes near.
Standing standing_of(const Sequence& sequence) {
  Standing all;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    const Standing of_frame = standing_of(sequence.at(k));
    all.near = all.near || of_frame.near;
    if (of_frame.touching) return of_frame;
  }
  return all;
}

}  // namespace

JudgedCase judged_case(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                       Interruption& interruption) {
  return {given, declared_answer(subject, given.pair(), interruption),
          declared_answer(oracle, given.pair(), interruption),
          judge_in_child(given.pair(), subject, oracle, interruption)};
}

std::string KindOfWork::options_again(const Plan& plan, CaseNumber number) const {
  return fmt::format(" --regime {} --seed {} --first {} --cases 1",
                     plan.regimes[plan.regime_of(number)]->name, plan.seed, plan.index_of(number));
}

std::vector<Declaration> asked_by(const Plan& plan) {
  std::vector<Declaration> asked{plan.subject.declaration};
  if (plan.oracle.declaration.name != kJudgeName) asked.push_back(plan.oracle.declaration);
  return asked;
}

Standing standing(const AnyCase& any) {
  return std::visit([](const auto& one) { return standing_of(one); }, any);
}

std::vector<const Regime*> regimes_for(const std::vector<Collider>& colliders,
                                       std::span<const std::string> names) {
  std::vector<const Regime*> chosen = chosen_by_name(regimes(), names, "regime", "--regime");
  if (!names.empty()) return chosen;
  GenerationContext context{};
  narrow_to(colliders, context);
  // Many cases are drawn before one is given that nobody takes.
  std::erase_if(chosen, [&](const Regime* regime) {
    return regime->is_round && !context.takes(generate(1, *regime, 0, context));
  });
  return chosen;
}

void narrow_to(const std::vector<Collider>& colliders, GenerationContext& context) {
  const auto is_any = [&](bool (*is)(const Declaration&)) {
    return std::ranges::any_of(colliders, is, &Collider::declaration);
  };
  context.takes = [colliders](const PairCase& pair) {
    return std::ranges::all_of(colliders,
                               [&](const Collider& collider) { return takes(collider, pair); });
  };
  // Most take all of them, and asking costs.
  const auto is_choosy = [](const Declaration& of) {
    return of.max_vertices < kMaxVertices || !of.least_polygon.is_none();
  };
  if (is_any(is_choosy)) context.takes_mitred = context.takes;
  if (!context.radius && is_any([](const Declaration& of) { return !of.takes_radius; })) {
    context.mitred_radius = 0.0F;
  }
}

Share share_of(const std::string& text) {
  Share share;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, share.number);
  if (number.ec == std::errc() && number.ptr != end && *number.ptr == '/') {
    const auto of = std::from_chars(number.ptr + 1, end, share.of);
    if (of.ec == std::errc() && of.ptr == end && share.number < share.of) return share;
  }
  throw UserError(fmt::format(
      "--share: '{}' is no share; K/N is expected, as 0/40: share K of N, K from 0 to N - 1",
      printable(text)));
}

void narrow_to_share(const Share& share, Plan& plan) {
  const std::uint64_t cases = plan.cases.value_or(0);
  const std::uint64_t in_turn = plan.regimes.size();
  const std::uint64_t turns = cases / in_turn + (cases % in_turn == 0 ? 0 : 1);
  if (share.of > turns) {
    throw UserError(
        fmt::format("--share: {} are too many shares of {}, dealt to {} in turn; use at most {}",
                    share.of, counted(cases, "case"), counted(in_turn, "regime"), turns));
  }
  const std::uint64_t begin = begin_of_part(share.number, share.of, turns);
  const std::uint64_t end = begin_of_part(share.number + 1, share.of, turns);
  plan.first += begin;
  plan.cases = std::min((end - begin) * in_turn, cases - begin * in_turn);
}

namespace {

void take_worse(double& mine, CaseNumber& at, double other, CaseNumber there) {
  if (other < mine || (other == mine && there >= at)) return;
  mine = other;
  at = there;
}

}  // namespace

void BucketTally::meet(std::size_t regime, CaseNumber number, const Judgement& judgement) {
  const WorstError met = worst_error(judgement);
  if (count == 0) {
    first = worst = number;
    error = met;
    worst_of.fill(number);
  }
  ++count;
  ++regimes[regime];
  if (judgement.is_agreed_contact) ++agreed[regime];
  first = std::min(first, number);
  take_worse(error.magnitude, worst, met.magnitude, number);
  for (std::size_t i = 0; i < worst_of.size(); ++i) {
    take_worse(error.errors.all()[i], worst_of[i], met.errors.all()[i], number);
  }
}

void BucketTally::add(const BucketTally& tally) {
  if (tally.count == 0) return;
  if (count == 0) {
    *this = tally;
    return;
  }
  count += tally.count;
  for (std::size_t i = 0; i < regimes.size(); ++i) regimes[i] += tally.regimes[i];
  for (std::size_t i = 0; i < agreed.size(); ++i) agreed[i] += tally.agreed[i];
  first = std::min(first, tally.first);
  take_worse(error.magnitude, worst, tally.error.magnitude, tally.worst);
  for (std::size_t i = 0; i < worst_of.size(); ++i) {
    take_worse(error.errors.all()[i], worst_of[i], tally.error.errors.all()[i], tally.worst_of[i]);
  }
}

std::size_t BucketTallies::slot_of(std::size_t bucket) const {
  std::size_t slot = bucket % kRoom;
  while (places_[slot] != 0 && places_[slot] != bucket + 1) slot = (slot + 1) % kRoom;
  return slot;
}

BucketTally& BucketTallies::of(const Bucket& bucket) {
  const std::size_t slot = slot_of(index_of(bucket));
  places_[slot] = index_of(bucket) + 1;
  return tallies_[slot];
}

const BucketTally* BucketTallies::find(const Bucket& bucket) const {
  const std::size_t slot = slot_of(index_of(bucket));
  return places_[slot] == 0 ? nullptr : &tallies_[slot];
}

void BucketTallies::add(const BucketTallies& tallies) {
  for (std::size_t slot = 0; slot < kRoom; ++slot) {
    if (tallies.places_[slot] == 0) continue;
    of(bucket_at(tallies.places_[slot] - 1)).add(tallies.tallies_[slot]);
  }
}

std::vector<BucketTallies::Met> BucketTallies::all() const {
  std::vector<Met> met;
  for (std::size_t slot = 0; slot < kRoom; ++slot) {
    if (places_[slot] != 0) met.push_back({bucket_at(places_[slot] - 1), &tallies_[slot]});
  }
  std::ranges::sort(met, {}, [](const Met& one) { return index_of(one.bucket); });
  return met;
}

void RegimeTally::add(const RegimeTally& tally) {
  cases += tally.cases;
  touching += tally.touching;
  near += tally.near;
  unexplained += tally.unexplained;
  frames += tally.frames;
  agreed += tally.agreed;
  agreed_judged += tally.agreed_judged;
}

namespace {

/// Whether the subject has answered, and wrong.
bool is_wrong_answer(const Bucket& bucket) {
  const bool is_of_subject = bucket.fault == Fault::subject || bucket.fault == Fault::both;
  const bool is_none = bucket.verdict == Verdict::crashed || bucket.verdict == Verdict::timed_out;
  return is_of_subject && !is_none;
}

}  // namespace

void Tally::add(std::size_t regime, CaseNumber number, const Standing& standing,
                const Judgement& judgement, std::size_t frames) {
  widen(of_subject, judgement.of_subject.errors);
  widen(of_oracle, judgement.of_oracle.errors);
  const Bucket& bucket = judgement.bucket;
  RegimeTally& of_regime = regimes[regime];
  ++of_regime.cases;
  of_regime.frames += frames;
  if (standing.touching) {
    ++of_regime.touching;
  } else if (standing.near) {
    ++of_regime.near;
  }
  if (is_unexplained(bucket.verdict)) ++of_regime.unexplained;
  ++verdicts[static_cast<std::size_t>(bucket.verdict)];
  if (judgement.is_by_tolerance) ++by_tolerance;
  if (bucket.verdict == Verdict::agree && judgement.is_judged) ++agreeing_judged;
  if (judgement.is_agreed_contact) {
    ++of_regime.agreed;
    if (judgement.is_judged) ++of_regime.agreed_judged;
  }
  if (bucket.verdict != Verdict::agree) buckets.of(bucket).meet(regime, number, judgement);
  if (is_wrong_answer(bucket)) first_wrong[static_cast<std::size_t>(bucket.kind)].add(number);
  if (judgement.explanation != nullptr) ++explained[index_of(*judgement.explanation)][regime];
}

void Tally::add(const Tally& tally) {
  widen(of_subject, tally.of_subject);
  widen(of_oracle, tally.of_oracle);
  for (std::size_t i = 0; i < verdicts.size(); ++i) verdicts[i] += tally.verdicts[i];
  by_tolerance += tally.by_tolerance;
  agreeing_judged += tally.agreeing_judged;
  for (std::size_t i = 0; i < regimes.size(); ++i) regimes[i].add(tally.regimes[i]);
  buckets.add(tally.buckets);
  for (std::size_t i = 0; i < first_wrong.size(); ++i) first_wrong[i].add(tally.first_wrong[i]);
  for (std::size_t i = 0; i < explained.size(); ++i) {
    for (std::size_t r = 0; r < kRegimesMax; ++r) explained[i][r] += tally.explained[i][r];
  }
}

}  // namespace manifuzz
