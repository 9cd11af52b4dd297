#include "hunting/hunt.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "campaign/result.hpp"
#include "cli/campaign_options.hpp"
#include "cli/campaign_page.hpp"
#include "cli/collider_choice.hpp"
#include "cli/commands.hpp"
#include "cli/kinds.hpp"
#include "cli/options.hpp"
#include "engines/provenance.hpp"
#include "hunting/archive_files.hpp"
#include "hunting/worst_cases.hpp"
#include "report/campaign_text.hpp"
#include "report/measurements/hunt_report.hpp"
#include "report/outputs.hpp"

namespace manifuzz {
namespace {

struct HuntArguments : CampaignOptions {
  /// The oracle is one that is seldom wrong itself: whatever it does wrong is found, too.
  HuntArguments() { colliders.oracle.name = "clip64"; }

  std::vector<std::string> from;
  std::string measure;
  bool is_alone = false;
  std::string share;
  std::optional<std::uint64_t> rounds;
  std::optional<std::uint64_t> round;
  std::string archives;
};

/// A hunt of one machine has none.
std::optional<Rounds> rounds_of(const HuntArguments& options) {
  if (options.share.empty()) return std::nullopt;
  return Rounds{*options.cases, *options.rounds, share_of(options.share).of};
}

RoundShare round_share_of(const HuntArguments& options) {
  return {*options.round, share_of(options.share).number};
}

std::optional<Measure> measure_named(const std::string& name) {
  const auto found = std::ranges::find(kMeasureNames, name);
  if (found == kMeasureNames.end()) return std::nullopt;
  return static_cast<Measure>(found - kMeasureNames.begin());
}

/// The pair cases that the plan's colliders take in the files and folders that --from names, one
/// broken file being an error; says how many others are there, and how many come too late.
std::vector<PairCase> founders_in(const std::vector<std::string>& named, const Plan& plan) {
  const std::vector<std::filesystem::path> paths(named.begin(), named.end());
  const Corpus corpus = read_corpus(paths);
  if (!corpus.errors.empty()) throw UserError(corpus.errors.front());
  std::vector<PairCase> founders;
  for (const CorpusCase& one : corpus.cases) {
    if (is_taken(plan.context, one.pair())) founders.push_back(one.pair());
  }
  const std::size_t given = corpus.cases.size() + corpus.others.size();
  if (founders.empty() && !named.empty()) {
    throw UserError(fmt::format("--from: no case was found that both colliders take in {}",
                                printable_path(named.front())));
  }
  if (founders.size() < given) {
    write_error(fmt::format("--from: {} of {} left out, no pairs that both colliders take\n",
                            given - founders.size(), counted(given, "case")));
  }
  if (plan.cases && *plan.cases < founders.size()) {
    write_error(fmt::format("--from: --cases {} leaves {} untried\n", *plan.cases,
                            counted(founders.size() - *plan.cases, "case")));
  }
  return founders;
}

HuntPlan hunt_plan_of(const HuntArguments& options) {
  HuntPlan hunt;
  Plan& plan = hunt.plan;
  const ColliderChoice& subject = options.colliders.subject;
  if (const OtherKind* const kind = kind_for(subject)) {
    throw UserError(fmt::format("hunt: {} takes {}; a collider of pairs is expected",
                                printable(subject.name), kind->noun));
  }
  plan_pairs(plan, options);
  plan.cases = options.cases;
  plan.seconds = options.seconds;
  if (!options.cases && !options.seconds) plan.seconds = kSecondsUnsaid;
  plan.jobs = jobs_of(options.jobs);
  hunt.measure = measure_named(options.measure);
  hunt.compares = !options.is_alone;
  hunt.founders = founders_in(options.from, plan);
  hunt.what = hunt.measure ? fmt::format("a hunt for {}", options.measure) : "a hunt";
  hunt.rounds = rounds_of(options);
  return hunt;
}

/// All that the cases of a hunt depend on, as far as the command's words do not say it.
std::string hunt_in_words(const HuntPlan& hunt, const HuntArguments& options) {
  const Plan& plan = hunt.plan;
  std::string bred_from;  // of known cases the sums, for files may change
  for (const std::span<const PairCase> known : {std::span(hunt.founders), plan.context.corpus}) {
    std::string lines;
    for (const PairCase& pair : known) append_case_line(lines, pair);
    bred_from += fmt::format(" {:016x}", hash_of(lines));
  }
  std::string words = fmt::format(
      "{} of {}, seed {}, in {} of {}", hunt.what, counted(*plan.cases, "case"), plan.seed,
      counted(hunt.rounds->rounds, "round"), counted(hunt.rounds->shares, "share"));
  for (const Declaration& asked : asked_by(plan))
    words += fmt::format(", {} {}", asked.name, asked.version);
  for (const std::string& regime : options.regimes) words += fmt::format(", {}", regime);
  return words + bias_and_radius_again(options) + ", cases" + bred_from;
}

/// Every `of`-th case from that of the share's number on.
std::vector<PairCase> dealt(const std::vector<PairCase>& cases, const Share& share) {
  std::vector<PairCase> mine;
  for (std::size_t i = share.number; i < cases.size(); i += share.of) mine.push_back(cases[i]);
  return mine;
}

/// Leaves the plan its share of a round, and gives it what the round before left.
ArchiveFolder deal(HuntPlan& hunt, const HuntArguments& options) {
  const RoundShare share = round_share_of(options);
  if (share.round >= hunt.rounds->rounds) {
    throw UserError(
        fmt::format("--round: {} is no round of {}; a whole number from 0 to {} is expected",
                    share.round, hunt.rounds->rounds, hunt.rounds->rounds - 1));
  }
  expect_cases_for_all(*hunt.rounds);
  hunt.what = hunt_in_words(hunt, options);
  hunt.compares = false;
  hunt.again = fmt::format(" --seed {} --cases {} --share {} --rounds {} --round {} --archives {}",
                           hunt.plan.seed, hunt.rounds->cases, options.share, hunt.rounds->rounds,
                           share.round, quoted_for_shell(options.archives));
  narrow_to(*hunt.rounds, share, hunt.plan);
  ArchiveFolder folder{options.archives, hunt.what, *hunt.rounds, hunt.measure};
  expect_no_other_hunt(folder, share);
  if (share.round > 0) {
    hunt.founders.clear();
    hunt.earlier = read_rounds_before(folder, share.round);
  } else {
    hunt.founders = dealt(hunt.founders, share_of(options.share));
  }
  return folder;
}

/// The beginning of a command that repeats a hunt up to a case.
std::string repeating_hunt(const HuntArguments& options) {
  std::string command = fmt::format("{} hunt {}", this_program(), options_again(options.colliders));
  for (const std::string& regime : options.regimes) command += fmt::format(" --regime {}", regime);
  for (const std::string& path : options.from) {
    command += fmt::format(" --from {}", quoted_for_shell(path));
  }
  if (!options.measure.empty()) command += fmt::format(" --measure {}", options.measure);
  return command + bias_and_radius_again(options) + " --no-compare" + options.folders.again();
}

CommandFiles files_of_hunt(const HuntArguments& options) {
  CommandFiles files{
      {options.folders.saved(), {"--json", options.json}, {"--report", options.report}},
      options.folders.all()};
  for (const std::string& path : options.from) files.inputs.emplace_back(path);
  if (!options.share.empty()) {
    const ArchiveFolder folder{options.archives, {}, {}, {}};
    files.outputs.push_back({"--archives", archive_file(folder, round_share_of(options)).string(),
                             OutputPath::Kind::file});
  }
  return files;
}

int hunt(HuntArguments& options) {
  options.folders.make_relative();
  if (!options.archives.empty()) options.archives = kept_path(options.archives).string();
  check_outputs(files_of_hunt(options));
  const Corpus corpus = read_corpus_folder(options.folders.corpus());
  const Corpus all = read_whole(options.folders);
  HuntPlan plan = hunt_plan_of(options);
  plan.plan.seed = seed_or_draw(options.seed);
  const std::vector<PairCase> pairs = pairs_of(corpus, plan.plan.seed);
  plan.plan.context.corpus = pairs;
  std::optional<ArchiveFolder> archives;
  if (plan.rounds) archives = deal(plan, options);
  const Known known = known_of(all.of(CaseKind::pair), options.today);
  const SaveTo saved = save_to_of(options);
  const Origin origin{repeating_hunt(options), provenance(plan.plan.seed, asked_by(plan.plan))};
  Hunt hunted = [&] {
    const ProgressLine line;
    return run_hunt(plan, known, saved, origin,
                    [&](const HuntProgress& progress) { line.show(hunt_line(progress)); });
  }();
  if (!saved.folder.empty()) keep_worst(hunted, options.folders.all(), saved.folder);
  const ShowAgain show{this_program(), options_to_show(options.colliders)};
  Outputs outputs;
  const std::string table = leaves_out_tables(options.json) ? objections(hunted.campaign)
                            : options.is_verbose            ? hunt_table(hunted)
                                                            : hunt_screen(hunted, show);
  write_table(outputs, table, options.json, json_text(json_of(hunted)));
  outputs.write(!options.report.empty(), [&] {
    // Its summary as a campaign's: the page compares no cells.
    write_data(options.report, page_of_campaign(hunted.campaign, json_of(hunted.campaign.result),
                                                {options.colliders, options.folders, ""}));
  });
  outputs.add_error(unwritten_in_words(hunted.campaign.saving));
  if (!outputs.are_written()) return 2;
  if (archives && !hunted.campaign.result.interrupted) {
    write_archive(*archives, round_share_of(options), hunted.archived);
  }
  // Whoever deals shares takes 1 for done.
  if (archives && hunted.campaign.result.interrupted) return 0;
  return has_failed(hunted.campaign.result) ? 1 : 0;
}

void add_rounds(CLI::App& app, HuntArguments& options) {
  constexpr std::uint64_t most = 1'000'000;
  CLI::Option* const share =
      add_text(app, "--share", options.share, "K/N",
               "run the share K of N, K from 0 to N - 1, of a round of the hunt that --seed and "
               "--cases give; nothing is drawn to compare with")
          ->needs("--seed")
          ->needs("--cases");
  const std::vector<CLI::Option*> others{
      add_whole_number(app, "--rounds", options.rounds,
                       "number of rounds of a hunt that is dealt to machines", 1, most),
      add_whole_number(app, "--round", options.round,
                       "which round, from 0 on; it begins with what all shares of the rounds "
                       "before have found"),
      add_text(app, "--archives", options.archives, "DIR",
               "folder of the archives that the shares of each round write, and those of the next "
               "one read")};
  for (CLI::Option* const other : others) {
    share->needs(other);
    other->needs(share);
  }
}

void add_hunt_arguments(CLI::App& app, HuntArguments& options) {
  add_subject_and_oracle(app, options.colliders);
  add_seed(app, options.seed);
  CLI::Option* const cases =
      add_whole_number(app, "--cases", options.cases, "number of cases to breed and judge", 1);
  add_length(app, "--seconds", options.seconds,
             "duration of the hunt in seconds, drawn cases included; default: 10")
      ->excludes(cases);
  add_text(app, "--from", options.from, "PATH",
           "file or folder of cases to begin with, besides drawn ones; repeatable");
  app.add_option("--measure", options.measure,
                 "look for the worst of one measure alone: error (of wrong answers), bound_share "
                 "(how much of its bound a right answer takes), missed (depth of missed contacts)")
      ->check(CLI::IsMember(std::vector<std::string>(kMeasureNames.begin(), kMeasureNames.end())));
  app.add_flag("--no-compare", options.is_alone,
               "do not run as many drawn cases beside it, to compare with");
  add_rounds(app, options);
  add_shrinking(app, options);
  add_jobs(app, options.jobs);
  add_pairs_and_folders(app, options);
  add_summaries(app, options, "what the hunt found");
}

}  // namespace

Run define_hunt(CLI::App& app) {
  return define<HuntArguments, add_hunt_arguments, hunt>(app);
}

}  // namespace manifuzz
