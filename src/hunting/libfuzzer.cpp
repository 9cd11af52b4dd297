// What libFuzzer calls, over a collider after manifuzz_collider.h that is linked with it: its
// inputs are cases (hunting/case_bytes.hpp), its mutations are the moves of a hunt, and each answer
// is judged. scripts/libfuzzer compiles the collider and links it, which alone is to be
// instrumented.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "external/external_collider.hpp"
#include "generating/drafts.hpp"
#include "generating/regime.hpp"
#include "hunting/breeding.hpp"
#include "hunting/bytes_corpus.hpp"
#include "hunting/case_bytes.hpp"
#include "hunting/libfuzzer_options.hpp"
#include "hunting/wrong_answers.hpp"
#include "sequence/sequence_ledger.hpp"

extern "C" {
int LLVMFuzzerInitialize(int* argc, char*** argv);
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t size_max,
                                    unsigned seed);
std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                      const std::uint8_t* second, std::size_t second_size,
                                      std::uint8_t* out, std::size_t out_max, unsigned seed);
// What the collider's floats are compared with, where scripts/libfuzzer says so.
extern const double manifuzz_constants[] __attribute__((weak));
extern const std::int32_t manifuzz_constant_count __attribute__((weak));
// libFuzzer's own mutations.
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t size_max);
}

namespace manifuzz {

// Nobody's mistakes are known here.
std::vector<LedgerEntry> built_ledger() {
  return {};
}
std::vector<SequenceEntry> built_sequence_ledger() {
  return {};
}

namespace {

// To leave an input out of the corpus is known to libFuzzer from clang 15 on; an earlier one, which
// ends at anything but 0, sees no coverage in it.
#if defined(__clang_major__) && __clang_major__ >= 15
constexpr int kRejected = -1;
#else
constexpr int kRejected = 0;
#endif

/// A process of libFuzzer's that starts others names the folder of findings to them by it.
constexpr const char* kFindings = "MANIFUZZ_LIBFUZZER_FINDINGS";

struct Fuzzed {
  Collider collider;
  std::span<const Regime> regimes;
  GenerationContext context;
  std::optional<WrongAnswers> kept{};  ///< none: a wrong answer ends the run
  bool stops = false;
};

Fuzzed make_fuzzed() {
  Fuzzed fuzzed{collider_of_function(manifuzz_collider, manifuzz_collide), regimes(), {}};
  const Declaration& declaration = fuzzed.collider.declaration;
  const bool is_of_polygons = declaration.min_vertices == kMinVertices && !declaration.takes_round;
  if (is_of_polygons) fuzzed.regimes = polygon_regimes();
  fuzzed.context.takes = [declaration](const PairCase& pair) {
    return !beyond_limits(declaration, pair);
  };
  fuzzed.context.takes_mitred = fuzzed.context.takes;
  if (!declaration.takes_radius) fuzzed.context.mitred_radius = 0;
  return fuzzed;
}

/// Ends the program as bad usage does.
[[noreturn]] void refuse(const std::exception& error) {
  write_error(fmt::format("manifuzz: {}\n", error.what()));
  std::_Exit(2);
}

Fuzzed& fuzzed() {
  static Fuzzed all = [] {
    try {
      return make_fuzzed();
    } catch (const UserError& error) {
      refuse(error);
    }
  }();
  return all;
}

bool is_asked_for(const PairCase& pair) {
  return is_in_use(pair) && is_taken(fuzzed().context, pair);
}

/// The case, where it is one that is asked for.
std::optional<PairCase> case_of(const std::uint8_t* data, std::size_t size) {
  const auto pair = decode_case({data, size});
  return pair && is_asked_for(*pair) ? pair : std::nullopt;
}

std::size_t written(const PairCase& pair, std::uint8_t* to) {
  encode_case(pair, std::span<std::uint8_t, kCaseBytes>(to, kCaseBytes));
  return kCaseBytes;
}

PairCase drawn(Random& random) {
  const auto last = static_cast<int>(fuzzed().regimes.size()) - 1;
  const Regime& regime = fuzzed().regimes[static_cast<std::size_t>(random.integer(0, last))];
  return generate(random.bits(), regime, 0, fuzzed().context);
}

/// One number to a constant of the collider's, or to what it is away from.
void move_to_a_constant(Random& random, PairCase& pair) {
  const int count = &manifuzz_constant_count == nullptr ? 0 : manifuzz_constant_count;
  if (count == 0) return;
  const double constant = manifuzz_constants[random.integer(0, count - 1)];
  const std::vector<float*> numbers = free_numbers(pair);
  const auto any = [&]() -> float& {
    return *numbers[static_cast<std::size_t>(
        random.integer(0, static_cast<int>(numbers.size()) - 1))];
  };
  const double from = random.chance(0.75) ? 0 : static_cast<double>(any());
  any() = static_cast<float>(from + random.either_sign(constant));
}

/// What becomes of a case by moves, some of which are to a constant of the collider's.
std::optional<PairCase> bred_with_constants(Random& random, const PairCase& parent,
                                            const PairCase& mate) {
  constexpr BreedShares shares{.of_numbers = 0.5};
  if (!random.chance(0.2)) return bred(random, parent, mate, shares);
  PairCase child = parent;
  move_to_a_constant(random, child);
  const auto valid = revalidated(child);
  return valid && random.chance(0.5) ? bred(random, *valid, mate, shares) : valid;
}

PairCase bred_or_drawn(Random& random, const PairCase& parent, const PairCase& mate) {
  constexpr int attempts = 8;
  for (int i = 0; i < attempts; ++i) {
    std::optional<PairCase> child = bred_with_constants(random, parent, mate);
    if (!child) continue;
    put_radius(fuzzed().context, *child);
    if (is_asked_for(*child)) return *child;
  }
  return drawn(random);
}

/// By libFuzzer's own mutations, which know the constants that the collider compared with.
std::optional<PairCase> mutated_as_bytes(const std::uint8_t* data) {
  std::array<std::uint8_t, kCaseBytes> bytes;
  std::memcpy(bytes.data(), data, kCaseBytes);
  const std::size_t size = LLVMFuzzerMutate(bytes.data(), kCaseBytes, kCaseBytes);
  return case_of(bytes.data(), size);
}

/// Says what is new, and ends the run as libFuzzer's own findings do where it is to end.
void report(const WrongAnswer& wrong) {
  std::optional<std::filesystem::path> file;
  if (fuzzed().kept) {
    file = fuzzed().kept->keep(wrong);
    if (!file && !fuzzed().stops) return;
  }
  write_error(fmt::format("manifuzz: wrong answer: {}, by {:.2g} of the size{}{}\n",
                          to_string(wrong.judgement.bucket), wrong.judgement.magnitude,
                          file ? ": " : "", file ? file->string() : ""));
  if (!fuzzed().kept || fuzzed().stops) std::abort();
}

/// Writes what goes to and from JSON. Whether that was all.
bool convert(const LibFuzzerOptions& options) {
  if (!options.from.empty()) {
    const Rewritten cases = write_as_bytes(options.from, options.inputs.front(), is_asked_for);
    write_error(
        fmt::format("manifuzz: {} to begin with, {} left out, which the collider is not "
                    "asked\n",
                    counted(cases.written, "case"), cases.left_out));
  }
  if (!options.to_json) return false;
  const Rewritten inputs = write_as_json(options.inputs, *options.to_json);
  write_error(fmt::format("manifuzz: {} as JSON in {}, {} left out, which are no case\n",
                          counted(inputs.written, "input"), options.to_json->string(),
                          inputs.left_out));
  return true;
}

void take_findings(const LibFuzzerOptions& options) {
  fuzzed().stops = options.stops;
  if (options.findings) setenv(kFindings, options.findings->c_str(), 1);
  const char* const folder = std::getenv(kFindings);
  if (folder != nullptr) fuzzed().kept.emplace(fuzzed().collider.declaration, folder);
}

/// Takes our options out of the command line.
void take_options(int* argc, char*** argv) {
  const LibFuzzerOptions options = libfuzzer_options({*argv, *argv + *argc});
  if (convert(options)) std::exit(0);
  take_findings(options);
  static std::vector<std::string> rest;
  static std::vector<char*> pointers;
  rest = options.rest;
  pointers.clear();
  for (std::string& word : rest) pointers.push_back(word.data());
  *argc = static_cast<int>(pointers.size());
  pointers.push_back(nullptr);
  *argv = pointers.data();
}

}  // namespace
}  // namespace manifuzz

using namespace manifuzz;

int LLVMFuzzerInitialize(int* argc, char*** argv) {
  try {
    take_options(argc, argv);
  } catch (const std::exception& error) {
    refuse(error);
  }
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  // Without a corpus libFuzzer begins with nothing and with one byte, and gives up if they show
  // nothing.
  const auto pair = size <= 1 ? overlapping_boxes() : case_of(data, size);
  if (!pair) return kRejected;
  const auto wrong = wrong_answer(fuzzed().collider, *pair);
  if (!wrong) return 0;
  try {
    report(*wrong);
  } catch (const UserError& error) {
    refuse(error);
  }
  return 0;
}

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t size_max,
                                    unsigned seed) {
  if (size_max < kCaseBytes) return std::min(size, size_max);
  Random random(seed, "libfuzzer", 0);
  const auto parent = case_of(data, size);
  if (!parent || random.chance(0.05)) return written(drawn(random), data);
  if (random.chance(0.25)) {
    if (const auto child = mutated_as_bytes(data)) return written(*child, data);
  }
  return written(bred_or_drawn(random, *parent, *parent), data);
}

std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                      const std::uint8_t* second, std::size_t second_size,
                                      std::uint8_t* out, std::size_t out_max, unsigned seed) {
  if (out_max < kCaseBytes) return 0;
  Random random(seed, "libfuzzer's crossover", 0);
  const auto parent = case_of(first, first_size);
  const auto mate = case_of(second, second_size);
  if (!parent || !mate) return written(parent ? *parent : mate ? *mate : drawn(random), out);
  return written(bred_or_drawn(random, *parent, *mate), out);
}
