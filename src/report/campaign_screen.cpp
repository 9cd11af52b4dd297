#include <algorithm>
#include <iterator>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "campaign/result.hpp"
#include "report/campaign_text.hpp"
#include "report/outputs.hpp"
#include "report/overview.hpp"
#include "report/risk_text.hpp"

namespace manifuzz {
namespace {

using Lines = std::vector<std::string>;

constexpr std::size_t kScreenLines = 24;
constexpr std::size_t kCausesShown = 5;
constexpr std::size_t kFindingsShown = 5;
constexpr std::size_t kRemarksShown = 5;
constexpr std::size_t kCauseLength = 138;

/// As much of a sentence as a line holds, whole words.
std::string shortened(const std::string& words) {
  if (words.size() <= kCauseLength) return words;
  return words.substr(0, words.find_last_of(" ,;", kCauseLength)) + " ...";
}

/// The most frequent causes of the oracle's wrong answers.
Lines causes_in_words(std::span<const CauseMet> causes) {
  Lines lines;
  for (const CauseMet& cause : causes | std::views::take(kCausesShown)) {
    lines.push_back(fmt::format("{:>10}  {}", cause.hits, shortened(cause.words)));
  }
  if (causes.size() > kCausesShown) {
    std::uint64_t hits = 0;
    for (const CauseMet& cause : causes | std::views::drop(kCausesShown)) hits += cause.hits;
    lines.push_back(
        fmt::format("{:>10}  by other causes ({})", hits, causes.size() - kCausesShown));
  }
  return lines;
}

/// A finding in two lines: what is wrong, and the command that shows its clearest case.
Lines finding_in_words(const FindingInWords& finding, const ShowAgain& show) {
  const std::string command =
      finding.file.empty()
          ? finding.command
          : fmt::format("{} show {}{}", show.program, quoted_for_shell(finding.file), show.options);
  return {fmt::format("{}{}, {}", finding.is_new ? fresh("new ") : "known to the corpus, ",
                      bad(finding.what), finding.how),
          "  " + command};
}

Lines findings_in_words(std::span<const FindingInWords> findings, const ShowAgain& show,
                        std::size_t room) {
  Lines lines;
  std::size_t shown = 0;
  for (const FindingInWords& finding : findings | std::views::take(kFindingsShown)) {
    if (lines.size() + 3 > room) break;
    std::ranges::move(finding_in_words(finding, show), std::back_inserter(lines));
    ++shown;
  }
  if (shown < findings.size()) {
    const std::size_t more = findings.size() - shown;
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
Lines head_of(const Campaign& campaign, const CampaignOverview& overview) {
  Lines lines = split_lines(campaign_heading(campaign));
  lines.push_back(overview.verdicts);
  std::ranges::move(split_lines(risk_in_words(campaign.result)), std::back_inserter(lines));
  lines.emplace_back();
  lines.push_back(overview.subject);
  if (!overview.oracle.empty()) lines.push_back(overview.oracle);
  std::ranges::move(causes_in_words(overview.causes), std::back_inserter(lines));
  return lines;
}

}  // namespace

std::string campaign_screen(const Campaign& campaign, const ShowAgain& show,
                            const std::optional<CampaignResult>& baseline) {
  const CampaignOverview overview = overview_of(campaign.result);
  Lines lines = head_of(campaign, overview);
  Lines rest = split_lines(remarks_on_campaign(campaign));
  std::ranges::move(stale_lines(campaign.result.stale), std::back_inserter(rest));
  if (rest.size() > kRemarksShown) {
    rest.resize(kRemarksShown);
    rest.emplace_back("and more: --verbose has all");
  }
  if (baseline) rest.push_back(comparison_line(*baseline, campaign.result));
  const std::size_t taken = lines.size() + rest.size() + 2;
  Lines findings =
      findings_in_words(overview.findings, show, kScreenLines > taken ? kScreenLines - taken : 0);
  if (findings.empty()) findings.emplace_back("nothing that is new or unexplained");
  lines.emplace_back();
  std::ranges::move(findings, std::back_inserter(lines));
  if (!rest.empty()) lines.emplace_back();
  std::ranges::move(rest, std::back_inserter(lines));
  return fmt::format("{}\n", fmt::join(lines, "\n"));
}

}  // namespace manifuzz
