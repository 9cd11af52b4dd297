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
  return judge_alone(truth, {undone.declaration, undone.answer});
}

/// What becomes of an answer without a mistake; open is what nobody can judge then.
enum class Fate { right, wrong, open };

Fate fate_without(const Mistake& mistake, const AskedAgain& asked, const Plan& plan) {
  const auto undone = mistake.undo({*asked.truth, plan.subject.declaration, asked.answer});
  if (!undone) return Fate::wrong;
  const Judgement judgement = judged_undone(asked, *undone);
  if (!is_wrong(judgement)) return is_right(judgement) ? Fate::right : Fate::open;
  const bool is_near = judgement.is_judged && judgement.bucket.kind != Kind::features &&
                       judgement.of_subject.magnitude < undone->within;
  return is_near ? Fate::right : Fate::wrong;
}

bool becomes_wrong_without(const Mistake& mistake, const AskedAgain& right, const Plan& plan) {
  const bool is_shown =
      mistake.undo({*right.truth, plan.subject.declaration, right.answer}).has_value();
  return is_shown && fate_without(mistake, right, plan) == Fate::wrong;
}

/// How many answers of one kind or several are right without the mistake, of those that are judged.
struct RightOf {
  std::size_t right = 0;
  std::size_t of = 0;
  std::size_t open = 0;  ///< those that cannot
};

/// None right where too few are. The first few decide against nearly every mistake.
RightOf right_of_kind(const Mistake& mistake, std::span<const AskedAgain> wrong, const Plan& plan) {
  const auto share_of = [](std::size_t count) {
    return static_cast<std::size_t>((1 - kHintedShare) * static_cast<double>(count));
  };
  RightOf result;
  for (const AskedAgain& asked : wrong) {
    const Fate fate = fate_without(mistake, asked, plan);
    if (fate == Fate::right) ++result.right;
    ++(fate == Fate::open ? result.open : result.of);
    if (result.of - result.right > share_of(wrong.size())) return {};
  }
  return result.of - result.right > share_of(result.of) ? RightOf{} : result;
}

/// What a mistake explains of a sample.
struct Explained {
  const Mistake* mistake = nullptr;
  RightOf answers{};
  std::vector<Kind> kinds{};
};

Explained explained_by(const Mistake& mistake, const Sample& sample, const Plan& plan) {
  Explained explained{&mistake};
  for (const auto& [kind, wrong] : sample.wrong) {
    const RightOf of_kind = right_of_kind(mistake, wrong, plan);
    explained.answers.open += of_kind.open;
    if (of_kind.right == 0) continue;
    explained.answers.right += of_kind.right;
    explained.answers.of += of_kind.of;
    explained.kinds.push_back(kind);
  }
  return explained;
}

bool is_enough(const Explained& explained, const Sample& sample) {
  const auto& [right, of, open] = explained.answers;
  const std::size_t needed = explained.mistake->is_allowance ? sample.wrong_count() - open : of;
  return right >= kHintedMin &&
         static_cast<double>(right) >= kHintedShare * static_cast<double>(needed);
}

bool harms(const Mistake& mistake, const Sample& sample, const Plan& plan) {
  return std::ranges::any_of(sample.right, [&](const AskedAgain& right) {
    return becomes_wrong_without(mistake, right, plan);
  });
}

/// The mistake that explains most, the first of those that explain nearly as much; none where none
/// explains enough.
Explained best_explanation(const Sample& sample, const Plan& plan) {
  std::vector<Explained> all;
  std::size_t most = 0;
  for (const Mistake& mistake : mistakes()) {
    Explained explained = explained_by(mistake, sample, plan);
    if (!is_enough(explained, sample) || harms(mistake, sample, plan)) continue;
    most = std::max(most, explained.answers.right);
    all.push_back(std::move(explained));
    // No later one can explain much more.
    const double of_all = kHintedShare * static_cast<double>(sample.wrong_count());
    if (static_cast<double>(most) >= of_all) break;
  }
  const auto first = std::ranges::find_if(all, [most](const Explained& explained) {
    return static_cast<double>(explained.answers.right) >= kHintedShare * static_cast<double>(most);
  });
  return first == all.end() ? Explained{} : *first;
}

Hint hint_of(const Explained& explained) {
  const Mistake& mistake = *explained.mistake;
  const auto& [right, of, open] = explained.answers;
  return {std::string(mistake.name), of, right,
          fmt::format("of {} wrong answers, asked again, {} are right if {}: {}", of, right,
                      mistake.condition, mistake.advice)};
}

/// Asks the subject about these cases of the plan, up to one to which it gives nothing any more.
class AskingAgain {
 public:
  AskingAgain(const Plan& plan, Interruption& interruption)
      : plan_(plan), subject_(hosted(plan.subject)), interruption_(interruption) {}

  std::vector<AskedAgain> ask(std::span<const CaseNumber> numbers) const {
    std::vector<PairCase> pairs;
    for (const CaseNumber number : numbers) {
      pairs.push_back(std::get<PairCase>(plan_.work->draw(plan_, number)));
    }
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
    return judge_alone(asked.truth, {plan_.subject.declaration, asked.answer});
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
  if (wrong < kHintedMin) return {};
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
