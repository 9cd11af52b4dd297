#include "cli/sequences/keepers.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/sequences/sequence_case.hpp"
#include "cli/options.hpp"
#include "engines/sequence_colliders.hpp"
#include "exchange/kept_json.hpp"
#include "report/outputs.hpp"
#include "report/picture/drawing.hpp"
#include "report/sequence/sequence_report.hpp"
#include "sequence/motions.hpp"

namespace manifuzz {

bool keeps_points(std::string_view name) {
  return find_sequence_entry(name) != nullptr || name.starts_with("cached+") ||
         name.starts_with("cached-bullet+");
}

bool keeps_points(const ColliderChoice& choice) {
  return choice.command.empty() ? keeps_points(choice.name) : choice.keeps_points;
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

NamedKeepers named_keepers(const ColliderChoice& choice, const ExternalOptions& external) {
  const auto find = [](const std::string& name) -> std::optional<SequenceCollider> {
    try {
      return find_sequence_collider(name);
    } catch (const UserError&) {
      if (find_sequence_entry(name) == nullptr) return std::nullopt;
      SequenceCollider absent;
      absent.declaration.name = name;
      return absent;
    }
  };
  return {find, keeps_points(choice) ? std::optional(find_keeper(choice, external)) : std::nullopt};
}

SequenceCollider keeper_for(const CorpusCase& given, ColliderChoice choice,
                            const ExternalOptions& external) {
  if (!choice.is_given()) {
    const bool names_one = given.expect && !given.expect->subject.empty();
    choice.name = names_one ? given.expect->subject : kUsualKeeper;
  }
  return find_keeper(choice, external);
}

void expect_none_of(const std::vector<PairOption>& options) {
  for (const PairOption& option : options) {
    if (!option.is_given) continue;
    throw UserError(
        fmt::format("{}: applies only to pair cases; omit it for sequences", option.name));
  }
}

int collide_sequences(const ColliderChoice& choice, const ExternalOptions& external,
                      const std::string& file) {
  const SequenceCollider keeper = find_keeper(choice, external);
  answer_each_sequence(file, [&](const Sequence& sequence, std::size_t index, std::string& lines) {
    const std::vector<KeptAnswer> answers = ask_sequence(keeper, sequence);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      if (k > 0) lines += '\n';
      append_kept_answer(lines, sequence.at(k), keeper.declaration.name, {index, k}, answers[k]);
    }
  });
  return 0;
}

int judge_sequences(const ColliderChoice& choice, const ExternalOptions& external,
                    const std::string& file) {
  const SequenceCollider keeper = find_keeper(choice, external);
  bool is_any_unexplained = false;
  answer_each_sequence(file, [&](const Sequence& sequence, std::size_t index, std::string& lines) {
    JudgedSequence judged{{}, keeper, ask_sequence(keeper, sequence), {}};
    judged.given.set(sequence);
    judged.judgement = judge_sequence(sequence, keeper, judged.answers);
    append_sequence_judgement(lines, index, judged);
    is_any_unexplained = is_any_unexplained || is_unexplained(judged.judgement.bucket.verdict);
  });
  return is_any_unexplained ? 1 : 0;
}

bool names_motion(const std::vector<std::string>& names) {
  return std::ranges::any_of(names,
                             [](const std::string& name) { return find_motion(name) != nullptr; });
}

void expect_no_motions(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (find_motion(name) == nullptr) continue;
    throw UserError(fmt::format(
        "--regime: {} is a motion, for sequences, which need a subject that keeps points, such as "
        "--subject {}",
        name, kUsualKeeper));
  }
}

Corpus taken_by(const ColliderChoice& subject, Corpus corpus) {
  if (!subject.is_given()) return corpus;
  const bool is_keeper = keeps_points(subject);
  std::vector<CorpusCase>& others = is_keeper ? corpus.cases : corpus.sequences;
  if (!others.empty()) {
    write_remark(fmt::format("left out: {} {}, which --{}{} does not take", others.size(),
                             is_keeper ? "pair cases" : "sequences", subject.role,
                             subject.command.empty() ? " " + subject.name : "-command"));
  }
  others.clear();
  return corpus;
}

int generate_sequences(const SequenceDraw& draw) {
  const auto chosen = chosen_by_name(motions(), draw.names, "motion", "--regime");
  expect_indices(draw.first, draw.count, chosen.size());
  const std::uint64_t seed = seed_or_draw(draw.seed);
  Output out;
  std::string line;
  for (std::uint64_t k = 0; k < draw.count; ++k) {
    const Motion& motion = *chosen[k % chosen.size()];
    const std::uint64_t index = draw.first + k / chosen.size();
    line.clear();
    append_found_case_line(line, draw_sequence(seed, motion, index),
                           {seed, std::string(motion.name), index, {}});
    out.write(line += '\n');
  }
  out.flush();
  return 0;
}

int show_sequence(const CorpusCase& given, const ColliderChoice& choice,
                  const ExternalOptions& external, const std::string& picture) {
  Interruption interruption(kUntilSignal);
  const JudgedSequence judged =
      judged_sequence(given, keeper_for(given, choice, external), interruption);
  const std::string svg = picture.empty() ? "" : filmstrip_svg(judged);
  if (picture == "-") {
    write_output(svg);
    return 0;
  }
  if (!picture.empty()) write_file(picture, picture.ends_with(".png") ? png_of(svg) : svg);
  write_output(sequence_text(judged));
  return 0;
}

}  // namespace manifuzz
