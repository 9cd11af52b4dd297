#include "report/rows.hpp"

#include "report/outputs.hpp"

namespace manifuzz {

void Rows::add_finding(const Bucket& bucket, double magnitude, const LedgerEntry* explanation) {
  const std::string verdict(to_string(bucket.verdict));
  add("verdict", is_unexplained(bucket.verdict) ? bad(verdict) : verdict);
  add("bucket", to_string(bucket));
  add("magnitude", digits(magnitude) + " of the size");
  if (explanation == nullptr) return;
  add("ledger", fmt::format("{}: {}", explanation->id, explanation->description));
  add("source", explanation->source);
}

void Rows::add_origin(const CorpusCase& given, std::string_view regime) {
  if (given.found) {
    add("found", fmt::format("seed {}, {} {}, index {}", given.found->seed, regime,
                             printable(given.found->regime), given.found->index));
  }
  if (given.expect && given.expect->severity) {
    add("severity", digits(*given.expect->severity) + " of the neighbours, when it was saved");
  }
  if (!given.note.empty()) add("note", printable(given.note, 1000));
}

}  // namespace manifuzz
