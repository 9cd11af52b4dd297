#include "campaign/hints/hints.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "campaign/hints/mistakes.hpp"
#include "campaign/in_child.hpp"
#include "judging/by_curve.hpp"

namespace manifuzz {
namespace {

/// Right answers are looked for among so many of the campaign's first cases, and so many are held.
constexpr CaseNumber kSearched = 512;
constexpr std::size_t kRightMax = 64;

/// A case that was asked again.
struct AskedAgain {
  std::shared_ptr<const exact::Truth> truth;
  Answer answer;
};

/// Right and wrong answers, asked again.
struct Sample {
  std::map<Kind, std::vector<AskedAgain>> wrong;
  std::vector<AskedAgain> right;  ///< with a contact

  std::size_t wrong_count() const {
    std::size_t count = 0;
    for (const auto& [kind, answers] : wrong) count += answers.size();
    return count;
  }
};

Judgement judged_alone(const std::shared_ptr<const exact::Truth>& truth,
                       const ColliderAnswer& given) {
  return judge(truth, given, given);
}

bool is_wrong(const Judgement& judgement) {
  return judgement.bucket.fault != Fault::none;
}

bool is_right(const Judgement& judgement) {
  return judgement.bucket.verdict == Verdict::agree;
}

bool has_answered(const Answer& answer) {
  return !std::holds_alternative<Lost>(answer) && !std::holds_alternative<Unsupported>(answer);
}

Judgement judged_undone(const AskedAgain& asked, const Undone& undone) {
  const auto truth = undone.pair ? std::make_shared<const exact::Truth>(*undone.pair) : asked.truth;
  return judged_alone(truth, {undone.declaration, undone.answer});
}

bool is_right_without(const Mistake& mistake, const AskedAgain& asked, const Plan& plan) {
  const auto undone = mistake.undo({*asked.truth, plan.subject.declaration, asked.answer});
  if (!undone) return false;
  const Judgement judgement = judged_undone(asked, *undone);
  const bool is_near = is_wrong(judgement) && judgement.is_judged &&
                       judgement.of_subject.magnitude <= undone->within;
  return is_right(judgement) || is_near;
}

bool becomes_wrong_without(const Mistake& mistake, const AskedAgain& asked, const Plan& plan) {
  const auto undone = mistake.undo({*asked.truth, plan.subject.declaration, asked.answer});
  if (!undone) return false;
  const Judgement judgement = judged_undone(asked, *undone);
  return is_wrong(judgement) && judgement.of_subject.magnitude >= undone->within;
}

/// How many of a kind are right without the mistake; 0 where too few are. The first few decide
/// against nearly every mistake.
std::size_t right_of_kind(const Mistake& mistake, std::span<const AskedAgain> wrong,
                          const Plan& plan) {
  const auto wrong_max =
      static_cast<std::size_t>((1 - kHintedShare) * static_cast<double>(wrong.size()));
  std::size_t still_wrong = 0;
  for (const AskedAgain& asked : wrong) {
    if (!is_right_without(mistake, asked, plan) && ++still_wrong > wrong_max) return 0;
  }
  return wrong.size() - still_wrong;
}

/// What a mistake explains of a sample.
struct Explained {
  const Mistake* mistake = nullptr;
  std::size_t right = 0;
  std::size_t of = 0;
  std::vector<Kind> kinds{};
};

Explained explained_by(const Mistake& mistake, const Sample& sample, const Plan& plan) {
  Explained explained{&mistake};
  for (const auto& [kind, wrong] : sample.wrong) {
    const std::size_t right = right_of_kind(mistake, wrong, plan);
    if (right == 0) continue;
    explained.right += right;
    explained.of += wrong.size();
    explained.kinds.push_back(kind);
  }
  return explained;
}

/// The mistake that explains most, the first of equals; none where none explains enough.
Explained best_explanation(const Sample& sample, const Plan& plan) {
  Explained best;
  for (const Mistake& mistake : mistakes()) {
    Explained explained = explained_by(mistake, sample, plan);
    if (explained.right < kHintedMin || explained.right <= best.right) continue;
    const bool harms = std::ranges::any_of(sample.right, [&](const AskedAgain& right) {
      return becomes_wrong_without(mistake, right, plan);
    });
    if (!harms) best = std::move(explained);
  }
  return best;
}

Hint hint_of(const Explained& explained) {
  const Mistake& mistake = *explained.mistake;
  return {std::string(mistake.name), explained.of, explained.right,
          fmt::format("of {} wrong answers, asked again, {} are right if {}: {}", explained.of,
                      explained.right, mistake.condition, mistake.advice)};
}

/// Asks the subject about these cases of the plan, up to one to which it gives nothing any more.
class AskingAgain {
 public:
  AskingAgain(const Plan& plan, Interruption& interruption)
      : plan_(plan), subject_(hosted(plan.subject)), interruption_(interruption) {}

  std::vector<AskedAgain> ask(std::span<const CaseNumber> numbers) const {
    std::vector<PairCase> pairs;
    for (const CaseNumber number : numbers) pairs.push_back(plan_.pair(number));
    std::vector<Answer> answers(pairs.size());
    const std::size_t count = subject_.collide_many(
        pairs, answers, [this] { return interruption_.state() == Interruption::State::running; });
    std::vector<AskedAgain> asked;
    for (std::size_t i = 0; i < count; ++i) {
      if (!has_answered(answers[i])) continue;
      asked.push_back({std::make_shared<const exact::Truth>(pairs[i]), std::move(answers[i])});
    }
    return asked;
  }

  Judgement judged(const AskedAgain& asked) const {
    return judged_alone(asked.truth, {plan_.subject.declaration, asked.answer});
  }

 private:
  const Plan& plan_;
  Collider subject_;
  Interruption& interruption_;
};

Sample sample_of(const Tally& tally, const Plan& plan, Interruption& interruption) {
  const AskingAgain again(plan, interruption);
  Sample sample;
  for (const LeastCases& of_kind : tally.first_wrong) {
    if (of_kind.all().empty()) continue;
    for (AskedAgain& asked : again.ask(of_kind.all())) {
      const Judgement judgement = again.judged(asked);
      if (is_wrong(judgement)) sample.wrong[judgement.bucket.kind].push_back(std::move(asked));
    }
  }
  if (sample.wrong_count() < kHintedMin) return sample;
  std::vector<CaseNumber> first(std::min(kSearched, plan.cases_max()));
  for (CaseNumber number = 0; number < first.size(); ++number) first[number] = number;
  for (AskedAgain& asked : again.ask(first)) {
    if (sample.right.size() == kRightMax) break;
    if (touches(asked.answer) && is_right(again.judged(asked))) {
      sample.right.push_back(std::move(asked));
    }
  }
  return sample;
}

}  // namespace

std::vector<Hint> hints_of(const Tally& tally, const Plan& plan, Interruption& interruption) {
  std::size_t wrong = 0;
  for (const LeastCases& of_kind : tally.first_wrong) wrong += of_kind.all().size();
  if (plan.sequences || wrong < kHintedMin) return {};
  Sample sample = sample_of(tally, plan, interruption);
  std::vector<Hint> hints;
  while (sample.wrong_count() >= kHintedMin) {
    const Explained best = best_explanation(sample, plan);
    if (best.mistake == nullptr) break;
    hints.push_back(hint_of(best));
    for (const Kind kind : best.kinds) sample.wrong.erase(kind);
  }
  return hints;
}

}  // namespace manifuzz
