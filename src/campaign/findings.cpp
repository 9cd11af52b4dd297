#include "campaign/findings.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "campaign/in_child.hpp"
#include "campaign/neighbourhood_run.hpp"

namespace manifuzz {
namespace {

/// The bucket, with the names of those at fault.
std::string key_of(std::string_view bucket, std::string_view subject, std::string_view oracle) {
  const std::string_view fault = bucket.substr(0, bucket.find('/'));
  return fmt::format("{}|{}|{}", bucket,
                     fault == "subject" || fault == "both" ? subject : std::string_view(),
                     fault == "oracle" || fault == "both" ? oracle : std::string_view());
}

bool is_lost(Verdict verdict) {
  return verdict == Verdict::crashed || verdict == Verdict::timed_out;
}

bool alike(const Judgement& judgement, const Judgement& root) {
  return judgement.bucket == root.bucket && judgement.explanation == root.explanation &&
         judgement.magnitude >= kMagnitudeShareKept * root.magnitude;
}

/// What a shrinking child has found so far, where its parent can see it even if it dies.
struct ShrinkSlot {
  std::atomic<int> pulse{0};
  std::atomic<int> accepted{0};
  std::array<PairCase, 2> best;  ///< the one at `accepted` mod 2 is whole
  std::atomic<bool> complete{false};
};

void shrink_into(ShrinkSlot& slot, const PairCase& pair, const Judgement& root,
                 const std::function<Judgement(const PairCase&)>& judge_it) {
  const auto like_root = [&](const PairCase& candidate) {
    ++slot.pulse;
    if (!alike(judge_it(candidate), root)) return false;
    slot.best[static_cast<std::size_t>(slot.accepted + 1) % 2] = candidate;
    ++slot.accepted;
    return true;
  };
  slot.complete = shrink(pair, like_root).complete;
}

std::string note_of(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                    const Collider& oracle) {
  if (judgement.explanation != nullptr) {
    return fmt::format("{}: {}.", judgement.explanation->id, judgement.explanation->description);
  }
  const Bucket& bucket = judgement.bucket;
  return fmt::format("{} against {}: {} ({}), the greatest separation being {:.3g}.",
                     subject.declaration.name, oracle.declaration.name, to_string(bucket.verdict),
                     name_of(bucket.kind, kKindNames), exact::Truth(pair).separation());
}

std::optional<double> recorded_magnitude(const Judgement& judgement) {
  if (judgement.bucket.verdict == Verdict::agree) return std::nullopt;
  return judgement.magnitude;
}

/// The share of the neighbours that fail alike, to three digits; none where nobody is at fault and
/// nothing differs. A fair sample of the map's cells, right to about 0.01, in about 15 ms.
std::optional<double> recorded_severity(const PairCase& pair, const Bucket& finding,
                                        const Collider& subject, const Collider& oracle,
                                        Interruption& interruption) {
  constexpr int cells_max = 1000;
  if (finding.verdict == Verdict::agree) return std::nullopt;
  const Grid grid = grid_around(exact::Truth(pair));
  // Once somebody has asked to stop there is a second for it, or there is none.
  const bool is_hurried = interruption.requests() > 0;
  Interruption brief(is_hurried
                         ? Deadline(std::chrono::steady_clock::now() + std::chrono::seconds(1))
                         : std::nullopt);
  const Neighbourhood map =
      ask_neighbourhood(pair, subject, oracle, grid, cells_max, is_hurried ? brief : interruption);
  const Severity found = severity(map, finding);
  if (found.valid == 0 || brief.requested()) return std::nullopt;
  return std::round(found.share() * 1000) / 1000;
}

}  // namespace

std::string finding_key(const Expectation& expect) {
  return key_of(expect.bucket, expect.subject, expect.oracle);
}

KnownBuckets::KnownBuckets(std::span<const CorpusCase> corpus) {
  for (const CorpusCase& known : corpus) {
    if (!known.expect) continue;
    files_.emplace(finding_key(*known.expect), known.path);
  }
}

std::string KnownBuckets::file_of(const Bucket& bucket, const Collider& subject,
                                  const Collider& oracle) const {
  const auto found =
      files_.find(key_of(to_string(bucket), subject.declaration.name, oracle.declaration.name));
  return found == files_.end() ? std::string() : found->second;
}

std::vector<Finding> findings(const Tally& tally, const Plan& plan, const KnownBuckets& known) {
  std::vector<Finding> found;
  for (std::size_t i = 0; i < kBucketCount; ++i) {
    if (tally.buckets[i].count == 0) continue;
    Finding finding{bucket_at(i), tally.buckets[i], false, {}};
    finding.file = known.file_of(finding.bucket, plan.subject, plan.oracle);
    finding.is_new = finding.file.empty();
    found.push_back(finding);
  }
  return found;
}

bool has_new(std::span<const Finding> found) {
  return std::ranges::any_of(found, &Finding::is_new);
}

Shrunk shrink_finding(const PairCase& pair, const Collider& subject, const Collider& oracle,
                      Interruption& interruption) {
  const Judgement root = judge_in_child(pair, subject, oracle, interruption);
  const auto judge_it = [&](const PairCase& candidate) {
    return is_lost(root.bucket.verdict) ? judge_in_child(candidate, subject, oracle, interruption)
                                        : judge(candidate, subject, oracle);
  };
  const Shared<ShrinkSlot> slot;
  slot->best[0] = pair;
  run_in_child([&] { shrink_into(*slot, pair, root, judge_it); }, slot->pulse,
               case_seconds_max(subject, oracle), interruption);
  return {slot->best[static_cast<std::size_t>(slot->accepted) % 2], slot->pulse, slot->complete};
}

std::filesystem::path corpus_folder(const Bucket& bucket, const std::string& oracle) {
  switch (bucket.verdict) {
    case Verdict::tie:
      return "ties";
    case Verdict::known:
    case Verdict::oracle_wrong:
      return std::filesystem::path("defects") / oracle;
    case Verdict::agree:
    case Verdict::ill_posed:
    case Verdict::unsupported:
      return "seeds";
    default:
      return "regressions";
  }
}

CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption) {
  CorpusCase recorded;
  recorded.pair = pair;
  recorded.expect = Expectation{
      .subject = subject.declaration.name,
      .oracle = oracle.declaration.name,
      .verdict = std::string(to_string(judgement.bucket.verdict)),
      .bucket = to_string(judgement.bucket),
      .manifolds = {},
      .severity = recorded_severity(pair, judgement.bucket, subject, oracle, interruption),
      .magnitude = recorded_magnitude(judgement)};
  for (const Manifold<double>& right : right_manifolds(admissible(pair, subject.declaration))) {
    recorded.expect->manifolds.push_back({std::string(kJudgeName), right});
  }
  std::string ends;
  for (const Collider* collider : {&subject, &oracle}) {
    const Answer answer = ask_in_child(*collider, pair, interruption);
    if (const auto* const lost = std::get_if<Lost>(&answer)) {
      ends += fmt::format(" {}: {}.", collider->declaration.name, lost->why);
    } else {
      recorded.expect->manifolds.push_back({collider->declaration.name, answer});
    }
  }
  recorded.note = note_of(pair, judgement, subject, oracle) + ends;
  return recorded;
}

void save_finding(Finding& finding, const Plan& plan, const std::filesystem::path& corpus,
                  Interruption& interruption) {
  const CaseNumber number = finding.tally.worst;
  Found found{.seed = plan.seed,
              .regime = std::string(plan.regimes[plan.regime_of(number)]->name),
              .index = plan.index_of(number),
              .versions = {}};
  for (const Collider* collider : {&plan.subject, &plan.oracle}) {
    found.versions[collider->declaration.name] = collider->declaration.version;
  }
  const auto recorded = [&](const PairCase& pair, const Judgement& judgement) {
    CorpusCase saved = recorded_case(pair, judgement, plan.subject, plan.oracle, interruption);
    saved.found = found;
    return saved;
  };
  const auto judged = [&](const PairCase& pair) {
    return judge_in_child(pair, plan.subject, plan.oracle, interruption);
  };
  const PairCase worst = plan.pair(number);
  const Judgement of_worst = judged(worst);
  const auto folder = corpus / corpus_folder(finding.bucket, plan.oracle.declaration.name);
  if (of_worst.bucket != finding.bucket) {
    CorpusCase unrepeated = recorded(worst, {finding.bucket, finding.tally.magnitude});
    unrepeated.note +=
        fmt::format(" Asked again, alone, it came to {}.", to_string(of_worst.bucket));
    finding.file = write_corpus_case(folder, unrepeated).string();
    return;
  }
  PairCase smallest = worst;
  if (interruption.requests() == 0) {
    smallest = shrink_finding(worst, plan.subject, plan.oracle, interruption).pair;
    interruption.forgive();  // one signal ends the shrinking alone
  }
  const auto file = write_corpus_case(folder, recorded(smallest, judged(smallest)));
  finding.file = file.string();
  if (worst != smallest) write_worst_case(file, recorded(worst, of_worst));
}

}  // namespace manifuzz
