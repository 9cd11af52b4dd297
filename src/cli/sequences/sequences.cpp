#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/sequences/keeper_trial.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "campaign/sequences/sequence_work.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "engines/sequence_colliders.hpp"
#include "exchange/kept_json.hpp"
#include "report/outputs.hpp"
#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"
#include "sequence/motions.hpp"

// Sequences and the colliders that keep points over their frames, as commands have them.

namespace manifuzz {
namespace {

bool keeps_points(const ColliderChoice& choice) {
  if (!choice.command.empty()) return choice.keeps_points;
  const std::string& name = choice.name;
  return find_sequence_entry(name) != nullptr || name.starts_with("cached+") ||
         name.starts_with("cached-bullet+");
}

bool is_motion(std::string_view name) {
  return find_motion(name) != nullptr;
}

SequenceCollider keeper_by_command(const std::string& command, const ExternalOptions& external) {
  return keeper_of_command(command, time_limit_of(external), external.start_seconds);
}

/// What subjects.json calls by that name, if it does.
std::optional<SequenceCollider> find_named_keeper(const std::string& name,
                                                  const ExternalOptions& external) {
  const auto choice = named_choice({"subject", name, ""}, external.named);
  if (!choice) return std::nullopt;
  return find_by_its_name(name, [&] {
    if (!choice->command.empty()) return keeper_by_command(choice->command, external);
    throw UserError(
        "a library keeps no points over frames, and this is a sequence; a \"command\" is expected");
  });
}

SequenceCollider find_keeper(const ColliderChoice& choice, const ExternalOptions& external) {
  if (external.in_process) {
    throw UserError(
        "--in-process: applies only to shared libraries, which take pair cases; omit it for "
        "sequences");
  }
  if (!choice.command.empty()) {
    if (!choice.keeps_points) {
      throw UserError(fmt::format(
          "--{}-command: takes pair cases, and this is a sequence; if the program keeps "
          "points, add --sequences",
          choice.role));
    }
    return keeper_by_command(choice.command, external);
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

void plan_campaign(Plan& plan, const SubjectAndOracle& asked,
                   std::span<const std::string> regimes) {
  plan_sequences(plan, find_keeper(asked.subject, asked.external), regimes);
}

std::shared_ptr<const KeeperTrial> keeper_for(const CorpusCase& given, ColliderChoice choice,
                                              const ExternalOptions& external) {
  if (!choice.is_given()) {
    const bool names_one = given.expect && !given.expect->subject.empty();
    choice.name = names_one ? given.expect->subject : kUsualKeeper;
    if (const auto named = find_named_keeper(choice.name, external)) {
      return std::make_shared<const KeeperTrial>(*named);
    }
    if (!keeps_points(choice)) {
      throw UserError(fmt::format(
          "{}: was found with '{}', which is not built in; say how to start it: --subject-command "
          "PROGRAM --sequences, --subjects FILE, or a file subjects.json beside the --corpus",
          given.path, printable(choice.name)));
    }
  }
  return std::make_shared<const KeeperTrial>(find_keeper(choice, external));
}

std::shared_ptr<const Trial> trial_for(const CorpusCase& given, ColliderChoice choice,
                                       const ExternalOptions& external) {
  return keeper_for(given, std::move(choice), external);
}

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

TrialOf trials_by_name(const ColliderChoice& choice, const ExternalOptions& external) {
  const bool is_given = keeps_points(choice);
  const auto find = [external](const std::string& name) {
    try {
      if (auto named = find_named_keeper(name, external)) return named;
    } catch (const UserError& error) {
      write_complaint(error.what());
      return std::optional<SequenceCollider>();
    }
    return find_known_keeper(name);
  };
  return trials_of_keepers(find,
                           is_given ? std::optional(find_keeper(choice, external)) : std::nullopt);
}

int collide_sequences(const ColliderChoice& choice, const ExternalOptions& external,
                      const std::string& file) {
  const SequenceCollider keeper = find_keeper(choice, external);
  const auto answer = [&](const AnyCase& any, std::size_t index, std::string& lines) {
    const auto& sequence = std::get<Sequence>(any);
    const std::vector<KeptAnswer> answers = ask_sequence(keeper, sequence);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      if (k > 0) lines += '\n';
      append_kept_answer(lines, sequence.at(k), keeper.declaration.name, {index, k}, answers[k]);
    }
  };
  answer_each(file, CaseKind::sequence, answer);
  return 0;
}

/// Status 1 where something is wrong that nobody explains.
int judge_sequences(const ColliderChoice& choice, const ExternalOptions& external,
                    const std::string& file) {
  const SequenceCollider keeper = find_keeper(choice, external);
  bool is_any_unexplained = false;
  const auto answer = [&](const AnyCase& any, std::size_t index, std::string& lines) {
    const auto& sequence = std::get<Sequence>(any);
    JudgedSequence judged{{any}, keeper, ask_sequence(keeper, sequence), {}};
    judged.judgement = judge_sequence(sequence, keeper, judged.answers);
    append_sequence_judgement(lines, index, judged);
    is_any_unexplained = is_any_unexplained || is_unexplained(judged.judgement.bucket.verdict);
  };
  answer_each(file, CaseKind::sequence, answer);
  return is_any_unexplained ? 1 : 0;
}

int generate_sequences(const DrawOptions& draw) {
  const auto chosen = chosen_by_name(motions(), draw.regimes, "motion", "--regime");
  expect_indices(draw.first, draw.count, chosen.size());
  const std::uint64_t seed = seed_or_draw(draw.seed);
  print_drawn(chosen, draw, seed, [&](const Motion& motion, std::uint64_t index) {
    return draw_sequence(seed, motion, index);
  });
  return 0;
}

int show_sequence(const CorpusCase& given, const ColliderChoice& choice,
                  const ExternalOptions& external, const std::string& picture) {
  Interruption interruption(kUntilSignal);
  const JudgedSequence judged =
      judged_sequence(given, keeper_for(given, choice, external)->keeper(), interruption);
  const std::string svg = picture.empty() ? "" : filmstrip_svg(judged);
  if (picture == "-") {
    write_output(svg);
    return 0;
  }
  if (!picture.empty()) write_file(picture, picture.ends_with(".png") ? png_of(svg) : svg);
  write_output(sequence_text(judged));
  return 0;
}

}  // namespace

const OtherKind kSequences{
    .kind = CaseKind::sequence,
    .noun = "sequences",
    .regime_is =
        "a motion, for sequences, which need a subject that keeps points, such as "
        "--subject cached",
    .is_asked = keeps_points,
    .has_regime = is_motion,
    .plan = plan_campaign,
    .trial = trial_for,
    .trials = trials_by_name,
    .collide = collide_sequences,
    .judge = judge_sequences,
    .generate = generate_sequences,
    .show = show_sequence};

}  // namespace manifuzz
