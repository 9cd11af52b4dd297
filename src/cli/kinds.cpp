#include "cli/kinds.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/pairs/pair_trial.hpp"
#include "generating/regime.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

constexpr std::array kOthers{&kSequences};

template <class IsIt>
const OtherKind* find_kind(const IsIt& is_it) {
  const auto* const found =
      std::ranges::find_if(kOthers, [&](const OtherKind* kind) { return is_it(*kind); });
  return found == kOthers.end() ? nullptr : *found;
}

}  // namespace

const OtherKind* kind_for(const ColliderChoice& choice) {
  return find_kind([&](const OtherKind& kind) { return kind.is_asked(choice); });
}

const OtherKind* kind_for(const std::vector<std::string>& regimes) {
  return find_kind(
      [&](const OtherKind& kind) { return std::ranges::any_of(regimes, kind.has_regime); });
}

const OtherKind* kind_for(const AnyCase& any) {
  return find_kind([&](const OtherKind& kind) { return kind.kind == kind_of(any); });
}

CaseKind kind_to_read(const ColliderChoice& subject) {
  const OtherKind* const kind = kind_for(subject);
  return kind != nullptr ? kind->kind : CaseKind::either;
}

void expect_none_of(const OtherKind& kind, const std::vector<PairOption>& options) {
  for (const PairOption& option : options) {
    if (!option.is_given) continue;
    throw UserError(
        fmt::format("{}: applies only to pair cases; omit it for {}", option.name, kind.noun));
  }
}

void expect_regimes_of_pairs(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const OtherKind* const kind = kind_for(std::vector{name});
    if (kind == nullptr) continue;
    throw UserError(fmt::format("--regime: {} is {}", name, kind->regime_is));
  }
}

void expect_regimes_of(const OtherKind& kind, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (kind.has_regime(name) || find_regime(name) == nullptr) continue;
    throw UserError(fmt::format("--regime: {} is a regime of pair cases, which do not mix with {}",
                                name, kind.noun));
  }
}

TrialOf trials_of_others(const ColliderChoice& subject, const ExternalOptions& external) {
  std::map<CaseKind, TrialOf> of_kind;
  for (const OtherKind* const kind : kOthers) of_kind[kind->kind] = kind->trials(subject, external);
  return [of_kind](const CorpusCase& known) { return of_kind.at(kind_of(known.any))(known); };
}

TrialOf trials_of(const SubjectAndOracle& asked) {
  const bool is_of_pairs = kind_for(asked.subject) == nullptr;
  const TrialOf of_pairs = trials_of_pairs(std::make_shared<NamedColliders>(
      find_installed_or_named(asked.external.named),
      is_of_pairs ? given_collider(asked.subject, asked.external) : std::nullopt,
      given_collider(asked.oracle, asked.external)));
  const TrialOf of_others = trials_of_others(asked.subject, asked.external);
  return [of_pairs, of_others](const CorpusCase& known) {
    return kind_of(known.any) == CaseKind::pair ? of_pairs(known) : of_others(known);
  };
}

Corpus taken_by(const ColliderChoice& subject, Corpus corpus) {
  if (!subject.is_given()) return corpus;
  std::vector<CorpusCase>& left_out = kind_for(subject) != nullptr ? corpus.cases : corpus.others;
  if (!left_out.empty()) {
    const OtherKind* const kind = kind_for(left_out.front().any);
    write_remark(fmt::format("left out: {} {}, which --{}{} does not take", left_out.size(),
                             kind != nullptr ? kind->noun : "pair cases", subject.role,
                             subject.command.empty() ? " " + subject.name : "-command"));
  }
  left_out.clear();
  return corpus;
}

}  // namespace manifuzz
