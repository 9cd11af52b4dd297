#include "report/page/page.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <iterator>
#include <set>
#include <span>
#include <tuple>

#include <fmt/format.h>

#include "base/text.hpp"
#include "campaign/in_child.hpp"
#include "campaign/risk/curve.hpp"
#include "report/glossary.hpp"
#include "report/outputs.hpp"
#include "report/overview.hpp"
#include "report/round_truth.hpp"
#include "report/texts.hpp"

namespace manifuzz {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array kResultKinds{"fuzz", "replay", "bench", "stress", "scene"};

/// What the campaign's own screen says, with the case that shows each cause.
Json overview_json(const CampaignResult& result) {
  const CampaignOverview overview = overview_of(result);
  Json json{{"verdicts", overview.verdicts},
            {"subject", overview.subject},
            {"oracle", overview.oracle},
            {"causes", Json::array()},
            {"findings", Json::array()}};
  for (const CauseMet& cause : overview.causes) {
    json["causes"].push_back(
        {{"hits", cause.hits}, {"words", cause.words}, {"witness", cause.witness}});
  }
  for (const FindingInWords& finding : overview.findings) {
    json["findings"].push_back({{"new", finding.is_new},
                                {"what", finding.what},
                                {"how", finding.how},
                                {"file", finding.file},
                                {"command", finding.command}});
  }
  return json;
}

/// Cases, and the buckets and wrong buckets met in so many.
Json curve_json(const CampaignResult& result) {
  Json points = Json::array();
  for (const CurvePoint& point : bucket_curve(result)) {
    points.push_back({point.cases, point.buckets, point.wrong});
  }
  return points;
}

Json data_of(const RunFiles& files, const std::vector<PageCase>& cases,
             const std::string& command) {
  Json data{{"format", "manifuzz/report/1"},
            {"version", MANIFUZZ_VERSION},
            {"command", command},
            {"sources", Json::array()},
            {"errors", files.corpus.errors}};
  for (const char* const kind : kResultKinds) data[kind] = Json::array();
  for (const ResultFile& result : files.results) {
    data["sources"].push_back({{"path", result.path}, {"kind", result.kind}, {"cases", nullptr}});
    Json run{{"path", result.path}, {"result", result.json}};
    if (result.campaign) {
      run["overview"] = overview_json(*result.campaign);
      run["curve"] = curve_json(*result.campaign);
    }
    data[std::string(result.kind)].push_back(std::move(run));
  }
  if (!cases.empty()) {
    data["sources"].push_back({{"path", "cases"}, {"kind", "cases"}, {"cases", cases.size()}});
  }
  data["words"] = Json::object();
  for (const auto& [word, meaning] : glossary()) data["words"][std::string(word)] = meaning;
  data["cases"] = Json::array();
  for (const PageCase& page_case : cases) data["cases"].push_back(page_case_json(page_case));
  return data;
}

/// Whole numbers that a JavaScript number would round, as texts of their digits.
void write_out_large(Json& json) {
  constexpr std::uint64_t kExactMax = std::uint64_t{1} << 53;
  if (json.is_structured()) {
    for (Json& one : json) write_out_large(one);
  } else if (json.is_number_unsigned() && json.get<std::uint64_t>() > kExactMax) {
    json = std::to_string(json.get<std::uint64_t>());
  }
}

/// JSON as the text of a script element, which no `<` may end.
std::string script_text(const Json& json) {
  // Paths and words from outside need not be UTF-8.
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return boost::replace_all_copy(text, "<", "\\u003c");
}

/// The template with each place filled; what is filled in is not searched for places.
std::string filled(std::string_view rest,
                   std::span<const std::pair<std::string_view, std::string_view>> fillings) {
  std::string out;
  for (const auto& [place, text] : fillings) {
    const std::size_t at = rest.find(place);
    out.append(rest.substr(0, at)).append(text);
    rest.remove_prefix(at + place.size());
  }
  return out.append(rest);
}

/// Whether the file records a mistake that may be mended by now.
bool was_unexplained(const CorpusCase& given) {
  const auto bucket = find_bucket(given.expect.value_or(Expectation{}).bucket);
  return bucket && is_unexplained(bucket->verdict);
}

CorpusCase without_answers(CorpusCase given) {
  given.expect->manifolds.clear();
  return given;
}

/// What the file records of that collider's answer, else what it answers now.
DeclaredAnswer answer_of(const CorpusCase& given, const std::string& name, const Collider* collider,
                         Interruption& interruption) {
  DeclaredAnswer asked;
  if (collider != nullptr) asked.declaration = collider->declaration;
  asked.declaration.name = name;
  if (given.found && given.found->versions.contains(name)) {
    asked.declaration.version = given.found->versions.at(name);
  }
  const auto recorded = given.expect.value_or(Expectation{}).manifolds;
  const auto own = std::ranges::find(recorded, name, &NamedAnswer::collider);
  if (own != recorded.end()) {
    asked.answer = own->answer;
  } else if (collider != nullptr) {
    asked.answer = ask_in_child(*collider, given.pair(), interruption);
  } else {
    asked.answer = Lost{Lost::How::crashed, "no answer is recorded"};
  }
  return asked;
}

/// What is right, the subject's own manifold first where it is one of them.
std::vector<Manifold<double>> right_of(const PageCase& page_case) {
  std::vector<Manifold<double>> right;
  const CorpusCase& given = page_case.judged.given;
  if (page_case.is_judged) {
    const Declaration& subject = page_case.judged.subject.declaration;
    right = manifolds_to_show(admissible(given.pair(), subject), subject);
  } else if (given.expect) {
    for (const NamedAnswer& named : given.expect->manifolds) {
      const Manifold<double>* const manifold = manifold_in(named.answer);
      if (named.collider == kJudgeName && manifold != nullptr) right.push_back(*manifold);
    }
  }
  const ContactSummary own = summary_of(page_case.judged.subject.answer);
  std::stable_partition(right.begin(), right.end(),
                        [&](const Manifold<double>& other) { return summary_of(other) == own; });
  return right;
}

/// The colliders of a page's case: those that it names; of the worst case of a hunt the collider
/// that it is of, where that is here, against the clean code in double.
std::pair<std::string, std::string> colliders_of(const CorpusCase& given,
                                                 NamedColliders& colliders) {
  const Expectation expect = given.expect.value_or(Expectation{});
  const std::string hunted = given.expect ? "" : collider_of_hunted(given.path);
  if (!hunted.empty() && colliders.find(hunted) != nullptr) {
    return {hunted, hunted == "clip64" ? "clip" : "clip64"};
  }
  return {expect.subject.empty() ? colliders.subject() : expect.subject,
          expect.oracle.empty() ? colliders.oracle() : expect.oracle};
}

PageCase page_case_of(const CorpusCase& given, const BucketRuns& runs, NamedColliders& colliders,
                      Interruption& interruption) {
  const auto [subject_name, oracle_name] = colliders_of(given, colliders);
  const Collider* const subject = colliders.find(subject_name);
  const Collider* const oracle = colliders.find(oracle_name);
  PageCase page_case;
  page_case.is_judged = subject != nullptr && oracle != nullptr;
  JudgedCase& judged = page_case.judged;
  judged.given = given;
  // What no run here met may be mended: it is asked again.
  const bool may_be_mended = page_case.is_judged && !runs.count && was_unexplained(given);
  const CorpusCase asked = may_be_mended ? without_answers(given) : given;
  judged.subject = answer_of(asked, subject_name, subject, interruption);
  judged.oracle = answer_of(asked, oracle_name, oracle, interruption);
  if (page_case.is_judged) {
    judged.judgement = judge(given.pair(), {judged.subject.declaration, judged.subject.answer},
                             {judged.oracle.declaration, judged.oracle.answer});
  }
  page_case.right = right_of(page_case);
  return page_case;
}

void add_maps(std::vector<PageCase>& cases, NamedColliders& colliders, std::size_t maps_max,
              Interruption& interruption, const ProgressLine& line) {
  std::set<std::tuple<std::string, std::string, std::string>> seen;
  std::vector<PageCase*> wanted;
  for (PageCase& page_case : cases) {
    const JudgedCase& judged = page_case.judged;
    const bool is_first =
        page_case.is_judged && page_case.smallest.empty() &&
        judged.judgement.bucket.verdict != Verdict::agree &&
        seen.emplace(to_string(judged.judgement.bucket), judged.subject.declaration.name,
                     judged.oracle.declaration.name)
            .second;
    if (is_first) wanted.push_back(&page_case);
  }
  // Somebody is wrong and nothing explains it; somebody is wrong; the others.
  std::ranges::stable_sort(wanted, {}, [](const PageCase* page_case) {
    const Verdict verdict = page_case->judged.judgement.bucket.verdict;
    return is_unexplained(verdict) ? 0 : verdict == Verdict::known ? 1 : 2;
  });
  wanted.resize(std::min(wanted.size(), maps_max));
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    line.show(fmt::format("the page: map {} of {}", i + 1, wanted.size()));
    PageCase* const page_case = wanted[i];
    const JudgedCase& judged = page_case->judged;
    page_case->map = case_map(judged, *colliders.find(judged.subject.declaration.name),
                              *colliders.find(judged.oracle.declaration.name), 1, interruption);
  }
}

std::vector<PageCase> page_cases(const RunFiles& files, NamedColliders& colliders,
                                 const std::string& program, Interruption& interruption,
                                 const ProgressLine& line) {
  std::set<std::string> paths;
  for (const CorpusCase& given : files.corpus.cases) paths.insert(given.path);
  std::vector<PageCase> cases;
  for (const CorpusCase& given : files.corpus.cases) {
    if (interruption.is_stopped()) throw Interrupted();
    line.show(fmt::format("the page: case {} of {}", cases.size() + 1, files.corpus.cases.size()));
    BucketRuns runs = runs_of(given, files.results);
    PageCase page_case = page_case_of(given, runs, colliders, interruption);
    const std::string shrunk = shrunk_beside(given.path);
    if (is_worst(given.path) && paths.contains(shrunk)) page_case.smallest = shrunk;
    page_case.commands.push_back(fmt::format("{} show {}", program, quoted_for_shell(given.path)));
    page_case.count = runs.count;
    std::ranges::move(runs.commands, std::back_inserter(page_case.commands));
    cases.push_back(std::move(page_case));
  }
  return cases;
}

}  // namespace

BucketRuns runs_of(const CorpusCase& given, const std::vector<ResultFile>& results) {
  BucketRuns runs;
  const auto& expect = given.expect;
  if (!expect) return runs;
  const std::string_view oracle = expect->oracle.empty() ? kJudgeName : expect->oracle;
  for (const ResultFile& result : results) {
    const bool is_of_these = result.campaign && result.campaign->settings.oracle == oracle &&
                             result.campaign->settings.subject == expect->subject;
    if (!is_of_these) continue;
    for (const BucketResult& found : result.campaign->buckets) {
      if (found.bucket != expect->bucket) continue;
      runs.count = runs.count.value_or(0) + found.count;
      runs.commands.push_back(found.command);
    }
  }
  return runs;
}

std::string page_of(const RunFiles& files, PageColliders colliders, std::size_t maps_max,
                    const PageCommands& commands) {
  Interruption interruption(kUntilSignal);
  std::vector<PageCase> cases;
  Json sequences;
  try {
    const ProgressLine line;
    cases = page_cases(files, colliders.of_pairs, commands.program, interruption, line);
    add_maps(cases, colliders.of_pairs, maps_max, interruption, line);
    sequences = page_sequences_json(files, colliders.of_sequences, commands.program, interruption);
  } catch (const Interrupted&) {
    throw UserError("the page: interrupted before it was done");
  }
  Json page_data = data_of(files, cases, commands.again);
  page_data["sequences"] = std::move(sequences);
  write_out_large(page_data);
  const std::string data = script_text(page_data);
  const std::array<std::pair<std::string_view, std::string_view>, 3> fillings{
      {{"@style@", kPageStyle}, {"@data@", data}, {"@script@", kPageScript}}};
  return filled(kPageTemplate, fillings);
}

}  // namespace manifuzz
