#include "campaign/property_run.hpp"

#include <memory>
#include <ostream>
#include <sstream>

#include <fmt/format.h>
#include <rapidcheck.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "campaign/findings.hpp"
#include "corpus/corpus.hpp"
#include "corpus/simpler_cases.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"

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

bool fails_alike(const Outcome& outcome, const Outcome& root) {
  return outcome.kind == Outcome::Kind::fails && outcome.why == root.why &&
         outcome.magnitude >= kMagnitudeShareKept * root.magnitude;
}

/// Simpler cases that fail in the root's way and no less: left alone, RapidCheck takes any failure,
/// and slides a gross one to just above the tolerance.
rc::Seq<Drawn> simpler(const Drawn& drawn, const Property& property, const Collider& collider,
                       const Outcome& root) {
  const auto alike = [&property, &collider, root](const PairCase& pair) {
    return fails_alike(check(property, collider, pair), root);
  };
  return rc::seq::map(rc::seq::filter(simpler_cases(drawn.pair), alike),
                      [regime = drawn.regime](PairCase&& pair) {
                        return Drawn{regime, pair};
                      });
}

/// What the cases are narrowed to: nothing, or no radius for one that takes none.
std::optional<float> radius_for(const Collider& collider) {
  return collider.declaration.takes_radius ? std::nullopt : std::optional(0.0F);
}

/// Draws one seed and a regime, and lets the project's generator make the case of them.
rc::Gen<Drawn> any_case(const Property& property, const Collider& collider,
                        std::span<const PairCase> corpus) {
  return [&property, &collider, corpus](const rc::Random& random, int) {
    rc::Random stream = random;
    const std::uint64_t seed = stream.next();
    const Regime& regime = regimes()[stream.next() % regimes().size()];
    Drawn root{std::string(regime.name), generate(seed, regime, 0, {corpus, radius_for(collider)})};
    const auto outcome = std::make_shared<std::optional<Outcome>>();
    const auto shrinks = [&property, &collider, outcome](const Drawn& drawn) {
      if (!*outcome) *outcome = check(property, collider, drawn.pair);
      return simpler(drawn, property, collider, **outcome);
    };
    return rc::shrinkable::shrinkRecur(root, shrinks);
  };
}

std::string_view name_of(Outcome::Kind kind) {
  switch (kind) {
    case Outcome::Kind::holds:
      return "holds";
    case Outcome::Kind::not_applicable:
      return "not applicable";
    case Outcome::Kind::known:
      return "known deviation";
    default:
      return "fails";
  }
}

class Silence : public rc::detail::TestListener {
 public:
  void onTestCaseFinished(const rc::detail::CaseDescription&) override {}
  void onShrinkTried(const rc::detail::CaseDescription&, bool) override {}
  void onTestFinished(const rc::detail::TestMetadata&, const rc::detail::TestResult&) override {}
};

/// The failures that a value of RC_PARAMS asks to repeat.
std::unordered_map<std::string, rc::detail::Reproduce> failures_to_repeat(
    const std::string& rc_params) {
  if (rc_params.empty()) return {};
  try {
    return rc::detail::configFromString(rc_params, rc::detail::Configuration()).reproduce;
  } catch (const std::exception& error) {
    throw UserError(fmt::format("RC_PARAMS: {}; what a failing property printed is expected",
                                printable(error.what(), 200)));
  }
}

/// The collider, which declines whatever there is no time for: from then on a property holds of all
/// that is left, shrinking included.
Collider while_asked(const Collider& collider, const PropertyPlan& plan) {
  if (plan.interruption == nullptr) return collider;
  Collider hurried = collider;
  hurried.collide = [collider, &plan](const PairCase& pair) -> Answer {
    const auto go_on = [&plan] { return !plan.is_over(); };
    Answer answer = Unsupported{"time is up"};
    if (!collider.is_isolated()) return go_on() ? collider.collide(pair) : answer;
    return collider.collide_many({&pair, 1}, {&answer, 1}, go_on) == 1 ? answer
                                                                       : Unsupported{"time is up"};
  };
  return hurried;
}

void describe_failure(PropertyResult& result, const rc::detail::FailureResult& failure,
                      const std::string& id) {
  rc::detail::Configuration repeat;
  repeat.reproduce[id] = failure.reproduce;
  result.reproduce = rc::detail::configToMinimalString(repeat);
  if (failure.counterExample.empty()) return;
  const std::string& line = failure.counterExample.front().second;
  result.failing = parse_case(line, FormatKey::optional).pair;
}

}  // namespace

PropertyResult run_property(const Property& property, const Collider& subject,
                            const PropertyPlan& plan) {
  const Collider collider = while_asked(subject, plan);
  PropertyResult result;
  const auto testable = [&] {
    if (plan.is_over()) return;
    const Drawn drawn = *any_case(property, collider, plan.corpus).as("case");
    const Outcome outcome = check(property, collider, drawn.pair);
    RC_TAG(drawn.regime, std::string(name_of(outcome.kind)));
    const Standing where = standing(exact::Truth(drawn.pair));
    RC_CLASSIFY(where.touching, std::string("touching"));
    if (result.why.empty() && !plan.is_over()) ++result.cases;
    if (outcome.kind != Outcome::Kind::fails) return;
    result.why = outcome.why;  // whatever it is shrunk to fails alike
    RC_FAIL(outcome.why);
  };
  rc::detail::TestParams params;
  params.seed = plan.seed;
  params.maxSuccess = plan.cases;
  rc::detail::TestMetadata metadata;
  metadata.id = collider.declaration.name + "/" + std::string(property.name);
  metadata.description = std::string(property.sentence);
  Silence silence;
  const rc::detail::TestResult outcome =
      rc::detail::checkProperty(rc::detail::toProperty(testable), metadata, params, silence,
                                failures_to_repeat(plan.rc_params));

  result.passed = outcome.is<rc::detail::SuccessResult>();
  std::ostringstream report;
  rc::detail::printResultMessage(outcome, report);
  result.report = report.str();
  if (outcome.is<rc::detail::FailureResult>()) {
    describe_failure(result, outcome.get<rc::detail::FailureResult>(), metadata.id);
  }
  if (result.passed && result.cases < plan.cases && plan.rc_params.empty()) {
    result.report =
        fmt::format("OK, passed {} of {} tests; then it was stopped", result.cases, plan.cases);
  }
  return result;
}

}  // namespace manifuzz
