#include <algorithm>
#include <iterator>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "report/campaign_text.hpp"
#include "report/finding_groups.hpp"
#include "report/outputs.hpp"
#include "report/sequence/sequence_report.hpp"

namespace manifuzz {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t kScreenLines = 24;
constexpr std::size_t kCausesShown = 5;
constexpr std::size_t kGroupsShown = 5;
constexpr std::size_t kRemarksShown = 6;
constexpr std::size_t kLineLength = 150;

std::string share_in_words(std::uint64_t part, std::uint64_t whole) {
  const double percent = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (part == whole) return "100%";
  if (percent >= 99.9) return "more than 99.9%";
  if (percent >= 10) return fmt::format("{:.1f}%", percent);
  return percent < 0.01 ? "less than 0.01%" : fmt::format("{:.2g}%", percent);
}

/// What wrong answers of one of both come to.
struct WrongAnswers {
  std::uint64_t count = 0;
  std::uint64_t explained = 0;
  std::uint64_t accepted = 0;
  double magnitude = 0;
};

WrongAnswers wrong_answers(const CampaignResult& result, Fault of) {
  WrongAnswers wrong;
  const Errors& worst = of == Fault::oracle ? result.of_oracle : result.of_subject;
  wrong.magnitude = std::ranges::max(worst.all());
  for (const BucketResult& found : result.buckets) {
    const auto bucket = find_bucket(found.bucket);
    if (!bucket || (bucket->fault != of && bucket->fault != Fault::both)) continue;
    wrong.count += found.count;
    if (bucket->verdict == Verdict::known) wrong.explained += found.count;
    if (found.is_accepted) wrong.accepted += found.count;
  }
  return wrong;
}

std::string wrong_in_words(std::string_view collider, const WrongAnswers& wrong,
                           std::uint64_t cases) {
  if (wrong.count == 0) return fmt::format("{}: no wrong answer", collider);
  std::string line = fmt::format("{}: wrong in {} ({})", collider, wrong.count,
                                 share_in_words(wrong.count, cases));
  if (wrong.magnitude > 0) {  // else all of them are lost
    line += fmt::format(", by {:.2g} of the size at worst", wrong.magnitude);
  }
  if (wrong.explained > 0) line += fmt::format("; {} explained by the ledger", wrong.explained);
  if (wrong.accepted > 0) line += fmt::format("; {} accepted", wrong.accepted);
  return line;
}

/// The most frequent causes of the oracle's wrong answers, in the ledger's words.
Lines causes_in_words(const CampaignResult& result) {
  std::vector<const LedgerResult*> causes;
  for (const LedgerResult& entry : result.ledger) {
    if (entry.hits > 0) causes.push_back(&entry);
  }
  std::ranges::stable_sort(causes, std::ranges::greater{}, &LedgerResult::hits);
  Lines lines;
  for (const LedgerResult* const cause : causes | std::views::take(kCausesShown)) {
    const auto entry = std::ranges::find(ledger(), cause->id, &LedgerEntry::id);
    const std::string_view words = entry == ledger().end() ? cause->id : entry->description;
    lines.push_back(printable(fmt::format("{:>10}  {}", cause->hits, words), kLineLength));
  }
  if (causes.size() > kCausesShown) {
    std::uint64_t hits = 0;
    for (const LedgerResult* const cause : causes | std::views::drop(kCausesShown)) {
      hits += cause->hits;
    }
    lines.push_back(
        fmt::format("{:>10}  by other causes ({})", hits, causes.size() - kCausesShown));
  }
  return lines;
}

std::string verdicts_in_words(const CampaignResult& result) {
  std::string line;
  for (const auto& [verdict, words] :
       {std::pair{Verdict::agree, "both right and the same"},
        std::pair{Verdict::tie, "both right and not the same"},
        std::pair{Verdict::ill_posed, "too near for float to tell"},
        std::pair{Verdict::unsupported, "not taken by one of both"}}) {
    const std::uint64_t count = result.verdicts[static_cast<std::size_t>(verdict)];
    if (count == 0) continue;
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", words,
                        share_in_words(count, result.cases()));
  }
  return line;
}

/// A group in two lines: what is wrong, and the command that shows its clearest case.
Lines group_in_words(const FindingGroup& group, const std::string& collider,
                     const ShowAgain& show) {
  const BucketResult& clearest = *group.buckets.front();
  std::string line =
      fmt::format("{}{}", group.new_buckets > 0 ? fresh("new ") : "known to the corpus, ",
                  bad(fmt::format("{}: {}", collider, group.what)));
  line += group.count == 1 ? ", once" : fmt::format(", {} times", group.count);
  if (group.buckets.size() > 1) line += fmt::format(" in {} buckets", group.buckets.size());
  if (group.new_buckets > 0 && group.new_buckets < group.buckets.size()) {
    line += fmt::format(" ({} new)", group.new_buckets);
  }
  if (group.magnitude > 0) {
    line += fmt::format(", by {:.2g} of the size at worst", group.magnitude);
  }
  const auto objection = std::ranges::find_if(
      group.buckets, [](const BucketResult* found) { return !found->objection.empty(); });
  if (objection != group.buckets.end()) line += "; " + (*objection)->objection;
  const std::string command = clearest.file.empty()
                                  ? clearest.command
                                  : fmt::format("{} show {}{}", show.program,
                                                quoted_for_shell(clearest.file), show.options);
  return {line, "  " + command};
}

Lines groups_in_words(const CampaignResult& result, const ShowAgain& show, std::size_t room) {
  const std::vector<FindingGroup> groups = finding_groups(result);
  Lines lines;
  std::size_t shown = 0;
  for (const FindingGroup& group : groups | std::views::take(kGroupsShown)) {
    if (lines.size() + 3 > room) break;
    const std::string collider = collider_at_fault(group.fault, result.settings);
    std::ranges::move(group_in_words(group, collider, show), std::back_inserter(lines));
    ++shown;
  }
  if (shown < groups.size()) {
    const std::size_t more = groups.size() - shown;
    lines.push_back(more == 1 ? "and one other kind: --verbose lists all"
                              : fmt::format("and {} other kinds: --verbose lists all", more));
  }
  return lines;
}

Lines split_lines(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// Accepted findings that come no more.
Lines stale_lines(std::span<const std::string> files) {
  if (files.size() <= 1) return split_lines(stale_in_words(files));
  return {
      fmt::format("{} accepted findings come no more: --verbose names their files", files.size())};
}

/// What was run, and how it came out by verdict and by collider.
Lines overview(const Campaign& campaign) {
  const CampaignResult& result = campaign.result;
  const Settings& settings = result.settings;
  Lines lines = split_lines(campaign_heading(campaign));
  lines.push_back(verdicts_in_words(result));
  lines.emplace_back();
  lines.push_back(wrong_in_words(collider_at_fault(Fault::subject, settings),
                                 wrong_answers(result, Fault::subject), result.cases()));
  if (result.is_of_sequences()) return lines;
  lines.push_back(wrong_in_words(collider_at_fault(Fault::oracle, settings),
                                 wrong_answers(result, Fault::oracle), result.cases()));
  std::ranges::move(causes_in_words(result), std::back_inserter(lines));
  return lines;
}

}  // namespace

std::string campaign_screen(const Campaign& campaign, const ShowAgain& show,
                            const std::optional<CampaignResult>& baseline) {
  Lines lines = overview(campaign);
  Lines rest = split_lines(remarks_on_campaign(campaign));
  std::ranges::move(stale_lines(campaign.result.stale), std::back_inserter(rest));
  if (rest.size() > kRemarksShown) {
    rest.resize(kRemarksShown);
    rest.emplace_back("and more: --verbose has all");
  }
  if (baseline) rest.push_back(comparison_line(*baseline, campaign.result));
  const std::size_t taken = lines.size() + rest.size() + 2;
  Lines groups =
      groups_in_words(campaign.result, show, kScreenLines > taken ? kScreenLines - taken : 0);
  if (groups.empty()) groups.emplace_back("nothing that is new or unexplained");
  lines.emplace_back();
  std::ranges::move(groups, std::back_inserter(lines));
  if (!rest.empty()) lines.emplace_back();
  std::ranges::move(rest, std::back_inserter(lines));
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace manifuzz
