#include "hunting/journal.hpp"

#include <fstream>

#include <fmt/format.h>

#include "corpus/corpus.hpp"
#include "hunting/hunted_pairs.hpp"

namespace manifuzz {

Journal::Journal(const std::string& folder, const Plan& plan) : plan_(plan) {
  if (!folder.empty())
    file_ = std::filesystem::path(folder) / fmt::format("hunt-{}.jsonl", plan.seed);
}

void Journal::add(const Tally& tally) {
  if (file_.empty()) return;
  std::string lines;
  for (const auto& [bucket, met] : tally.buckets.all()) {
    if (bucket.fault == Fault::none || !known_.insert(index_of(bucket)).second) continue;
    append_found_case_line(lines, plan_.work->draw(plan_, met->first),
                           {plan_.seed, std::string(kHunted.name), plan_.index_of(met->first), {}});
    lines += '\n';
  }
  if (lines.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  std::ofstream(file_, std::ios::app) << lines << std::flush;
}

void Journal::end() const {
  std::error_code ignored;
  if (!known_.empty()) std::filesystem::remove(file_, ignored);
}

}  // namespace manifuzz
