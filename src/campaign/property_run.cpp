#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <ostream>
#include <sstream>

#include <fmt/format.h>
#include <rapidcheck.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/property_failure.hpp"
#include "campaign/replay.hpp"
#include "corpus/corpus.hpp"
#include "corpus/shrink.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"
#include "process/pool.hpp"

namespace manifuzz {
namespace {

/// A case and the regime it was drawn from.
struct Drawn {
  std::string regime;
  PairCase pair;
};

/// RapidCheck prints counterexamples with this; the line reads back bit for bit.
void showValue(const Drawn& drawn, std::ostream& out) {
  std::string line;
  append_case_line(line, drawn.pair);
  out << line;
}

using CheckCase = std::function<PropertyOutcome(const PairCase&)>;

/// Simpler cases that fail in the root's way and no less: left alone, RapidCheck takes any failure,
/// and slides a gross one to just above the tolerance.
rc::Seq<Drawn> simpler(const Drawn& drawn, const CheckCase& check_case,
                       const PropertyOutcome& root) {
  const auto alike = [check_case, root](const PairCase& pair) {
    return fails_alike(check_case(pair), root);
  };
  return rc::seq::map(rc::seq::filter(simpler_cases(drawn.pair), alike),
                      [regime = drawn.regime](PairCase&& pair) {
                        return Drawn{regime, pair};
                      });
}

/// Draws one seed and a regime, and lets the project's generator make the case of them.
rc::Gen<Drawn> any_case(const CheckCase& check_case, const std::vector<const Regime*>& from,
                        const GenerationContext& context) {
  return [check_case, from, context](const rc::Random& random, int) {
    rc::Random stream = random;
    const std::uint64_t seed = stream.next();
    const Regime& regime = *from[stream.next() % from.size()];
    const Drawn root{std::string(regime.name), generate(seed, regime, 0, context)};
    const auto outcome = std::make_shared<std::optional<PropertyOutcome>>();
    const auto shrinks = [check_case, outcome](const Drawn& drawn) {
      if (!*outcome) *outcome = check_case(drawn.pair);
      return simpler(drawn, check_case, **outcome);
    };
    return rc::shrinkable::shrinkRecur(root, shrinks);
  };
}

constexpr std::array<std::string_view, 4> kOutcomeNames{"holds", "not applicable",
                                                        "known deviation", "fails"};

class Silence : public rc::detail::TestListener {
 public:
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

/// The failures that a value of RC_PARAMS asks to repeat.
using FailuresToRepeat = std::unordered_map<std::string, rc::detail::Reproduce>;
FailuresToRepeat failures_to_repeat(const std::string& rc_params) {
  if (rc_params.empty()) return {};
  try {
    return rc::detail::configFromString(rc_params, rc::detail::Configuration()).reproduce;
  } catch (const std::exception& error) {
    throw UserError(fmt::format("RC_PARAMS: {}; what a failing property printed is expected",
                                printable(error.what(), 200)));
  }
}

/// What a run leaves behind as it goes, where its parent can see it even if it dies.
struct RunSlot {
  double magnitude = 0;
  std::atomic<bool> is_over{false};  ///< it is to leave the rest out
  std::atomic<std::uint64_t> checks{0};
  PairCase at_work;
  int cases = 0;             ///< before anything failed
  int applied = 0;           ///< of these
  bool has_failing = false;  ///< `failing` is the smallest so far, for the reason `why`
  PairCase failing;
  SharedText<512> why;
  bool passed = false;
  SharedText<1 << 16> report;
  SharedText<1 << 16> reproduce;
};

void describe_failure(RunSlot& slot, const rc::detail::FailureResult& failure,
                      const std::string& id) {
  rc::detail::Configuration repeat;
  repeat.reproduce[id] = failure.reproduce;
  slot.reproduce.set(rc::detail::configToMinimalString(repeat));
  slot.has_failing = !failure.counterExample.empty();
  if (!slot.has_failing) return;
  const std::string& line = failure.counterExample.front().second;
  slot.failing = parse_case(line, FormatKey::optional).pair();
}

std::string message_of(const rc::detail::TestResult& result) {
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  return message.str();
}

void run_rapidcheck(const Property& property, const Collider& subject, const PropertyPlan& plan,
                    const FailuresToRepeat& to_repeat, const std::function<bool()>& is_over,
                    RunSlot& slot) {
  const Collider collider = until(is_over, subject);
  const CheckCase check_case = [&](const PairCase& pair) {
    slot.at_work = pair;
    ++slot.checks;
    return check(property, collider, pair);
  };
  GenerationContext context{plan.corpus, {}};
  narrow_to({collider}, context);
  const std::vector<const Regime*> from = regimes_for({collider}, {});
  const auto testable = [&] {
    // Thrown as they stand: RapidCheck's macros put this file's name into what people read.
    using CaseEnd = rc::detail::CaseResult;
    if (is_over()) throw CaseEnd(CaseEnd::Type::Discard, "time is up");
    const Drawn drawn = *any_case(check_case, from, context).as("case");
    const PropertyOutcome outcome = check_case(drawn.pair);
    RC_TAG(drawn.regime, std::string(name_of(outcome.kind, kOutcomeNames)));
    const Standing where = standing(exact::Truth(drawn.pair));
    RC_CLASSIFY(where.touching, std::string("touching"));
    if (!slot.has_failing && !is_over()) {
      ++slot.cases;
      slot.applied += static_cast<int>(outcome.kind != PropertyOutcome::Kind::not_applicable);
    }
    if (outcome.kind != PropertyOutcome::Kind::fails) return;
    slot.why.set(outcome.why);  // whatever it is shrunk to fails alike
    slot.magnitude = outcome.magnitude;
    slot.failing = drawn.pair;
    slot.has_failing = true;
    throw CaseEnd(CaseEnd::Type::Failure, outcome.why);
  };
  rc::detail::TestParams params;
  params.seed = plan.seed;
  params.maxSuccess = plan.cases;
  params.maxDiscardRatio = 0;  // the first case that there is no time for ends it
  rc::detail::TestMetadata metadata;
  metadata.id = collider.declaration.name + "/" + std::string(property.name);
  metadata.description = std::string(property.sentence);
  Silence silence;
  const rc::detail::TestResult outcome = rc::detail::checkProperty(
      rc::detail::toProperty(testable), metadata, params, silence, to_repeat);
  slot.passed = outcome.is<rc::detail::SuccessResult>() || outcome.is<rc::detail::GaveUpResult>();
  slot.report.set(message_of(outcome));
  if (outcome.is<rc::detail::FailureResult>()) {
    describe_failure(slot, outcome.get<rc::detail::FailureResult>(), metadata.id);
  }
}

/// What is left of a run that did not end by itself: a collider that died or hung did so on the
/// case at work, as small as it is.
void end_halfway(RunSlot& slot, Ending ending) {
  if (ending != Ending::stopped) {
    slot.why.set(lost_by(ending).why);
    slot.failing = slot.at_work;
    slot.has_failing = slot.checks > 0;
  }
  slot.passed = ending == Ending::stopped && !slot.has_failing;
  if (slot.passed) return;
  rc::detail::FailureResult failure;
  failure.numSuccess = slot.cases;
  failure.description = slot.why.str();
  std::string line;
  append_case_line(line, slot.failing);
  if (slot.has_failing) failure.counterExample = {{"case", line}};
  slot.report.set(message_of(failure));
}

PropertyResult result_of(const RunSlot& slot, const PropertyPlan& plan) {
  PropertyResult result{.passed = slot.passed,
                        .cases = slot.cases,
                        .applied = slot.applied,
                        .magnitude = slot.magnitude,
                        .report = slot.report.str(),
                        .failing = {},
                        .why = slot.why.str(),
                        .reproduce = slot.reproduce.str()};
  if (!result.passed && slot.has_failing) result.failing = slot.failing;
  if (result.passed && result.cases < plan.cases && plan.rc_params.empty()) {
    result.report =
        fmt::format("OK, passed {} of {} tests; then it was stopped", result.cases, plan.cases);
  }
  return result;
}

}  // namespace

PropertyResult run_property(const Property& property, const Collider& subject,
                            const PropertyPlan& plan) {
  const FailuresToRepeat to_repeat = failures_to_repeat(plan.rc_params);
  Interruption own;
  Interruption& interruption = plan.interruption != nullptr ? *plan.interruption : own;
  const Shared<RunSlot> slot;
  if (subject.is_isolated()) {
    // It is asked from here, where it runs already.
    const auto is_over = [&] { return interruption.state() != Interruption::State::running; };
    run_rapidcheck(property, subject, plan, to_repeat, is_over, *slot);
    return result_of(*slot, plan);
  }
  const auto is_over = [&slot] { return slot->is_over.load(std::memory_order_relaxed); };
  const Ending ending =
      run_in_child([&] { run_rapidcheck(property, subject, plan, to_repeat, is_over, *slot); },
                   case_seconds_max(subject, subject), interruption,
                   [&] { return slot->checks.load(); }, &slot->is_over);
  if (ending != Ending::done) end_halfway(*slot, ending);
  return result_of(*slot, plan);
}

}  // namespace manifuzz
