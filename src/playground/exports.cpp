#include <array>
#include <string>
#include <vector>

#include "judging/ledger.hpp"
#include "playground/numbers.hpp"

// What the page calls. It writes a case where `playground_case` says, calls, and reads numbers and
// text from where these say; each stays until the next call.

#ifdef __wasm__
#define MANIFUZZ_EXPORT(name) extern "C" __attribute__((export_name(#name)))
#else
#define MANIFUZZ_EXPORT(name) extern "C"
#endif

namespace manifuzz {

/// No engine is asked here, whose deviations a ledger would name.
std::vector<LedgerEntry> built_ledger() {
  return {};
}

}  // namespace manifuzz

namespace manifuzz::playground {
namespace {

std::array<double, kCaseNumbers> given{};
Told told;
std::string text;

}  // namespace

MANIFUZZ_EXPORT(playground_case) double* playground_case() {
  return given.data();
}

/// 1 where the case has no defect; else the text says which.
MANIFUZZ_EXPORT(playground_check) int playground_check() {
  const auto defect = defect_of(given);
  text = defect.value_or("");
  return defect ? 0 : 1;
}

/// Answers a case without defects: count of numbers. The text has the buckets.
MANIFUZZ_EXPORT(playground_tell) int playground_tell() {
  told = tell(pair_of(given));
  text = told.buckets;
  return static_cast<int>(told.numbers.size());
}

MANIFUZZ_EXPORT(playground_numbers) const double* playground_numbers() {
  return told.numbers.data();
}

MANIFUZZ_EXPORT(playground_text) const char* playground_text() {
  return text.data();
}

MANIFUZZ_EXPORT(playground_text_size) int playground_text_size() {
  return static_cast<int>(text.size());
}

}  // namespace manifuzz::playground
