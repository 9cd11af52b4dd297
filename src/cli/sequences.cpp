#include "cli/sequences.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/pairs/pair_trial.hpp"
#include "campaign/sequences/keeper_trial.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "engines/sequence_colliders.hpp"
#include "exchange/kept_json.hpp"
#include "generating/regime.hpp"
#include "report/outputs.hpp"
#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {

bool keeps_points(const ColliderChoice& choice) {
  if (!choice.command.empty()) return choice.keeps_points;
  const std::string& name = choice.name;
  return find_sequence_entry(name) != nullptr || name.starts_with("cached+") ||
         name.starts_with("cached-bullet+");
}

namespace {

bool is_motion(std::string_view name) {
  return find_motion(name) != nullptr;
}

}  // namespace

bool any_motion(const std::vector<std::string>& names) {
  return std::ranges::any_of(names, is_motion);
}

CaseKind kind_to_read(const ColliderChoice& subject) {
  return keeps_points(subject) ? CaseKind::sequence : CaseKind::either;
}

void expect_none_of(const std::vector<PairOption>& options) {
  for (const PairOption& option : options) {
    if (!option.is_given) continue;
    throw UserError(
        fmt::format("{}: applies only to pair cases; omit it for sequences", option.name));
  }
}

void expect_regimes_of_pairs(const std::vector<std::string>& names) {
  const auto motion = std::ranges::find_if(names, is_motion);
  if (motion == names.end()) return;
  throw UserError(
      fmt::format("--regime: {} is a motion, for sequences, which need a subject that keeps "
                  "points, such as --subject cached",
                  *motion));
}

void expect_motions(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (is_motion(name) || find_regime(name) == nullptr) continue;
    throw UserError(fmt::format(
        "--regime: {} is a regime of pair cases, which do not mix with sequences", name));
  }
}

SequenceCollider find_keeper(const ColliderChoice& choice, const ExternalOptions& external) {
  if (!choice.command.empty()) {
    if (!choice.keeps_points) {
      throw UserError(fmt::format(
          "--{}-command: takes pair cases, and this is a sequence; if the program keeps "
          "points, add --sequences",
          choice.role));
    }
    return keeper_of_command(choice.command, time_limit_of(external), external.start_seconds);
  }
  try {
    return find_sequence_collider(choice.name);
  } catch (const UserError& error) {
    const bool is_of_pairs = find_entry(choice.name) != nullptr;
    throw UserError(fmt::format("--{}: {}{}", choice.role,
                                is_of_pairs ? choice.name + " keeps no points over frames, and "
                                                            "this is a sequence: "
                                            : "",
                                error.what()));
  }
}

SequenceCollider keeper_for(const CorpusCase& given, ColliderChoice choice,
                            const ExternalOptions& external) {
  if (!choice.is_given()) {
    const bool names_one = given.expect && !given.expect->subject.empty();
    choice.name = names_one ? given.expect->subject : kUsualKeeper;
  }
  return find_keeper(choice, external);
}

namespace {

std::optional<SequenceCollider> find_known_keeper(const std::string& name) {
  try {
    return find_sequence_collider(name);
  } catch (const UserError&) {
    if (find_sequence_entry(name) == nullptr) return std::nullopt;
    SequenceCollider absent;
    absent.declaration.name = name;
    return absent;
  }
}

}  // namespace

TrialOf trials_of_sequences(const ColliderChoice& subject, const ExternalOptions& external) {
  return trials_of_keepers(find_known_keeper, keeps_points(subject)
                                                  ? std::optional(find_keeper(subject, external))
                                                  : std::nullopt);
}

TrialOf trials_of(const SubjectAndOracle& asked, const NamedColliders::Find& find) {
  const TrialOf of_pairs = trials_of_pairs(std::make_shared<NamedColliders>(
      find,
      keeps_points(asked.subject) ? std::nullopt : given_collider(asked.subject, asked.external),
      given_collider(asked.oracle, asked.external)));
  const TrialOf of_sequences = trials_of_sequences(asked.subject, asked.external);
  return [of_pairs, of_sequences](const CorpusCase& known) {
    return kind_of(known.any) == CaseKind::pair ? of_pairs(known) : of_sequences(known);
  };
}

Corpus taken_by(const ColliderChoice& subject, Corpus corpus) {
  if (!subject.is_given()) return corpus;
  const bool takes_sequences = keeps_points(subject);
  std::vector<CorpusCase>& left_out = takes_sequences ? corpus.cases : corpus.others;
  if (!left_out.empty()) {
    write_remark(fmt::format("left out: {} {}, which --{}{} does not take", left_out.size(),
                             takes_sequences ? "pair cases" : "sequences", subject.role,
                             subject.command.empty() ? " " + subject.name : "-command"));
  }
  left_out.clear();
  return corpus;
}

void collide_sequences(const SequenceCollider& keeper, const std::string& file) {
  const auto answer = [&](const AnyCase& any, std::size_t index, std::string& lines) {
    const auto& sequence = std::get<Sequence>(any);
    const std::vector<KeptAnswer> answers = ask_sequence(keeper, sequence);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      if (k > 0) lines += '\n';
      append_kept_answer(lines, sequence.at(k), keeper.declaration.name, {index, k}, answers[k]);
    }
  };
  answer_each(file, CaseKind::sequence, answer);
}

bool judge_sequences(const SequenceCollider& keeper, const std::string& file) {
  bool is_any_unexplained = false;
  const auto answer = [&](const AnyCase& any, std::size_t index, std::string& lines) {
    const auto& sequence = std::get<Sequence>(any);
    JudgedSequence judged{{any}, keeper, ask_sequence(keeper, sequence), {}};
    judged.judgement = judge_sequence(sequence, keeper, judged.answers);
    append_sequence_judgement(lines, index, judged);
    is_any_unexplained = is_any_unexplained || is_unexplained(judged.judgement.bucket.verdict);
  };
  answer_each(file, CaseKind::sequence, answer);
  return is_any_unexplained;
}

void show_sequence(const CorpusCase& given, const SequenceCollider& keeper,
                   const std::string& picture) {
  Interruption interruption(kUntilSignal);
  const JudgedSequence judged = judged_sequence(given, keeper, interruption);
  const std::string svg = picture.empty() ? "" : filmstrip_svg(judged);
  if (picture == "-") return write_output(svg);
  if (!picture.empty()) write_file(picture, picture.ends_with(".png") ? png_of(svg) : svg);
  write_output(sequence_text(judged));
}

}  // namespace manifuzz
