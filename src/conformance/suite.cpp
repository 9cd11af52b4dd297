#include "conformance/suite.hpp"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "conformance/conformance_case.hpp"
#include "corpus/corpus.hpp"
#include "generating/regime.hpp"
#include "judging/judge.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kWitness = "witness-";

/// How many cases of a regime are looked at for each that is taken.
constexpr std::uint64_t kLookedAtForEach = 20;

/// What tells a case from another at a glance: how many vertices there are, and of sharp corners
/// the features of the contact.
struct Look {
  int vertices_of_a = 0;
  int vertices_of_b = 0;
  ContactSummary contact;

  friend bool operator==(const Look&, const Look&) = default;
};

Look look_at(const PairCase& pair) {
  return {pair.a.polygon.count, pair.b.polygon.count, summary_of(exact::Truth(pair))};
}

std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [read_to, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && read_to == end ? std::optional(value) : std::nullopt;
}

/// What stands before the first slash, which is taken off with it.
std::string_view part_of(std::string_view& name) {
  const std::string_view part = name.substr(0, name.find('/'));
  name.remove_prefix(std::min(part.size() + 1, name.size()));
  return part;
}

std::optional<PairCase> drawn_pair(std::string_view name) {
  const Regime* const regime = find_regime(part_of(name));
  const auto seed = whole_number(part_of(name));
  const auto index = whole_number(name);
  if (regime == nullptr || !seed || !index) return std::nullopt;
  return generate(*seed, *regime, *index);
}

/// The files of cases in a folder of the corpus and below; none where it has no such folder.
std::vector<fs::path> files_in(const fs::path& folder) {
  if (!fs::exists(folder)) return {};
  std::vector<std::string> errors;
  const fs::path folders[] = {folder};
  auto files = find_case_files(folders, errors);
  if (!errors.empty()) throw UserError(errors.front());
  return files;
}

/// The file of the corpus that shows a cause, in the folder of whichever engine.
fs::path witness_of(std::string_view cause, const fs::path& corpus) {
  const fs::path file = fmt::format("{}{}.json", kWitness, cause);
  for (const fs::path& path : files_in(corpus / "defects")) {
    if (path.filename() == file) return path;
  }
  throw UserError(
      fmt::format("{}: no {} is there", printable_path(corpus / "defects"), file.string()));
}

class Builder {
 public:
  Builder(const SuitePlan& plan, const std::function<void(std::size_t)>& progress)
      : plan_(plan), progress_(progress) {}

  Suite build() {
    picks_ = read_picks();
    add_worst();
    add_witnesses();
    add_regimes(plan_.cases - std::min(plan_.cases, picks_.size()));
    begin("picks");
    for (const std::string& name : picks_) add(name);
    return std::move(suite_);
  }

 private:
  void add_worst() {
    begin("worst");
    for (const fs::path& path : files_in(plan_.corpus / "worst")) {
      add(fmt::format("worst/{}/{}", path.parent_path().filename().string(), path.stem().string()));
    }
  }

  void add_witnesses() {
    begin("ledger");
    for (const fs::path& path : files_in(plan_.corpus / "defects")) {
      const std::string stem = path.stem().string();
      if (!stem.starts_with(kWitness)) continue;
      const CorpusCase witness = read_case_file(path.string(), CaseKind::either);
      if (kind_of(witness.any) == CaseKind::pair) add("ledger/" + stem.substr(kWitness.size()));
    }
  }

  /// A name a line; what follows a # is a remark.
  std::vector<std::string> read_picks() const {
    std::vector<std::string> names;
    const fs::path file = plan_.corpus / "conformance" / "picks.txt";
    if (!fs::exists(file)) return names;
    InputFile picks(file.string());
    LineReader lines(picks);
    while (const auto line = lines.next()) {
      std::string_view name = line->text.substr(0, line->text.find('#'));
      name = name.substr(0, name.find_last_not_of(" \t\r") + 1);
      if (name.empty()) continue;
      if (!drawn_pair(name)) {
        throw UserError(fmt::format("{}:{}: \"{}\" names no case; REGIME/SEED/INDEX is expected",
                                    printable_path(file), line->number, printable(name)));
      }
      names.emplace_back(name);
    }
    return names;
  }

  /// Until there are so many lines.
  void add_regimes(std::size_t count) {
    std::vector<const Regime*> all;
    for (const Regime& regime : regimes()) {
      if (regime.name != "corpus") all.push_back(&regime);  // it needs a corpus to draw from
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t missing = count - std::min(count, suite_.lines.size());
      add_regime(*all[i], missing / (all.size() - i));
    }
  }

  /// First what looks like no case before, then whatever comes first.
  void add_regime(const Regime& regime, std::size_t count) {
    begin(regime.name);
    const std::size_t until = suite_.lines.size() + count;
    std::vector<std::uint64_t> passed_over;
    for (std::uint64_t i = 0; i < kLookedAtForEach * count && suite_.lines.size() < until; ++i) {
      if (std::ranges::count(picks_, drawn_name(regime, i)) > 0) continue;
      const Look look = look_at(generate(plan_.seed, regime, i));
      if (std::ranges::count(looks_, look) > 0) {
        passed_over.push_back(i);
      } else {
        add(drawn_name(regime, i));
      }
    }
    for (const std::uint64_t i : passed_over) {
      if (suite_.lines.size() < until) add(drawn_name(regime, i));
    }
  }

  std::string drawn_name(const Regime& regime, std::uint64_t index) const {
    return fmt::format("{}/{}/{}", regime.name, plan_.seed, index);
  }

  void begin(std::string_view source) { suite_.sources.push_back({std::string(source)}); }

  void add(const std::string& name) {
    const PairCase pair = named_pair(name, plan_.corpus).value();
    if (std::ranges::count(pairs_, pair) > 0) return;
    pairs_.push_back(pair);
    auto line = conformance_line(name, pair);
    if (!line) {
      ++suite_.sources.back().left_out;
      return;
    }
    looks_.push_back(look_at(pair));
    suite_.lines.push_back(std::move(*line));
    ++suite_.sources.back().taken;
    progress_(suite_.lines.size());
  }

  const SuitePlan& plan_;
  const std::function<void(std::size_t)>& progress_;
  Suite suite_;
  std::vector<std::string> picks_;
  std::vector<PairCase> pairs_;
  std::vector<Look> looks_;
};

}  // namespace

Suite suite(const SuitePlan& plan, const std::function<void(std::size_t)>& progress) {
  if (!fs::is_directory(plan.corpus)) {
    throw UserError(printable_path(plan.corpus) + ": is no folder; that of a corpus is expected");
  }
  return Builder(plan, progress).build();
}

std::optional<PairCase> named_pair(std::string_view name, const fs::path& corpus) {
  std::string_view rest = name;
  const std::string_view source = part_of(rest);
  if (source == "worst") return read_case_file((corpus / (std::string(name) + ".json"))).pair();
  if (source == "ledger") return read_case_file(witness_of(rest, corpus)).pair();
  return drawn_pair(name);
}

}  // namespace manifuzz
