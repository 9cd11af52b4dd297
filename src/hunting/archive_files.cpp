#include "hunting/archive_files.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "base/file.hpp"
#include "base/json.hpp"
#include "base/text.hpp"
#include "hunting/case_bytes.hpp"

namespace manifuzz {
namespace {

constexpr std::string_view kArchiveFormat = "manifuzz/archive/1";
/// The largest archive that is read.
constexpr std::size_t kLongestArchive = std::size_t{1} << 32;

// An archive is a line that says whose it is, how long the rest is and what it sums up to; then the
// cases, each of so many bytes: number, bins (a half byte each), gauges and nearness, and the bytes
// of hunting/case_bytes.hpp. Numbers are little-endian, figures IEEE 754 binary64.
constexpr std::size_t kBinsBytes = kConditions / 2;
static_assert(kConditions % 2 == 0 && kBins == 16);
constexpr std::size_t kArchivedBytes = 8 + kBinsBytes + 8 * kGauges + 8 + kCaseBytes;

std::string first_line(const ArchiveFolder& folder, const RoundShare& of, std::string_view rest) {
  std::string line = fmt::format("{{\"format\": \"{}\", \"hunt\": ", kArchiveFormat);
  append_string(line, folder.hunt);
  return line +
         fmt::format(", \"round\": {}, \"share\": {}, \"bytes\": {}, \"sum\": \"{:016x}\"}}\n",
                     of.round, of.share, rest.size(), hash_of(rest));
}

void append_whole(std::string& out, std::uint64_t number) {
  for (int i = 0; i < 8; ++i) out += static_cast<char>(number >> 8 * i);
}

void append_archived(std::string& out, const ArchivedCase& one) {
  append_whole(out, one.number);
  const auto& bins = one.observed.conditions.all();
  for (std::size_t i = 0; i < kConditions; i += 2) {
    out += static_cast<char>(bins[i] | bins[i + 1] << 4);
  }
  for (const double gauge : std::span(one.observed.gauges).first<kGauges>()) {
    append_whole(out, std::bit_cast<std::uint64_t>(gauge));
  }
  append_whole(out, std::bit_cast<std::uint64_t>(one.observed.nearness));
  std::array<std::uint8_t, kCaseBytes> bytes{};
  encode_case(one.pair, bytes);
  out.append(bytes.begin(), bytes.end());
}

/// Takes bytes from the front of a text that is long enough.
class BytesReader {
 public:
  explicit BytesReader(std::string_view text) : left_(text) {}

  std::string_view take(std::size_t length) {
    const std::string_view taken = left_.substr(0, length);
    left_.remove_prefix(length);
    return taken;
  }
  std::uint64_t whole() {
    std::uint64_t number = 0;
    int place = 0;
    for (const char byte : take(8)) {
      number |= std::uint64_t{static_cast<unsigned char>(byte)} << 8 * place++;
    }
    return number;
  }
  double figure() { return std::bit_cast<double>(whole()); }

 private:
  std::string_view left_;
};

ArchivedCase read_archived(std::string_view text) {
  BytesReader reader(text);
  ArchivedCase one{.number = reader.whole(), .observed = {.is_there = true, .is_well_posed = true}};
  std::size_t condition = 0;
  for (const char byte : reader.take(kBinsBytes)) {
    const auto both = static_cast<std::uint8_t>(byte);
    one.observed.conditions[static_cast<Condition>(condition++)] = both & 15;
    one.observed.conditions[static_cast<Condition>(condition++)] = both >> 4;
  }
  for (double& gauge : std::span(one.observed.gauges).first<kGauges>()) gauge = reader.figure();
  one.observed.nearness = reader.figure();
  const std::string_view bytes = reader.take(kCaseBytes);
  const auto pair = decode_case(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  if (!pair) throw UserError("has a case that is none; delete it, and run its share again");
  one.pair = *pair;
  return one;
}

/// Throws UserError where the first line of an archive names another hunt than the folder's.
void expect_this_hunt(const ArchiveFolder& folder, std::string_view first) {
  std::optional<std::string> hunt;
  try {
    const JsonTree tree = parse_json(first);
    if (JsonView(tree).string_or("format", "") == kArchiveFormat) {
      hunt = JsonView(tree).string_or("hunt", "");
    }
  } catch (const UserError&) {
    // It is torn in its first line.
  }
  if (hunt && *hunt != folder.hunt) {
    throw UserError(fmt::format("is of another hunt ({}); one of this hunt is expected ({})",
                                printable(*hunt, 300), printable(folder.hunt, 300)));
  }
}

/// Throws UserError where the first line is another than that of this share with these lines.
void expect_whole(const ArchiveFolder& folder, const RoundShare& of, std::string_view first,
                  std::string_view rest) {
  if (first == first_line(folder, of, rest)) return;
  expect_this_hunt(folder, first);
  throw UserError("is no whole archive of this share; delete it, and run its share again");
}

/// So many cases are kept in memory before any is left out.
constexpr std::size_t kFewToThin = 1 << 18;

/// Uses the archives of all rounds before this one.
template <class Use>
void for_each_archive(const ArchiveFolder& folder, std::uint64_t round, const Use& use) {
  for (std::uint64_t before = 0; before < round; ++before) {
    for (std::uint64_t share = 0; share < folder.rounds.shares; ++share) {
      use(read_archive(folder, {before, share}));
    }
  }
}

}  // namespace

std::filesystem::path archive_file(const ArchiveFolder& folder, const RoundShare& of) {
  return folder.path / fmt::format("round-{}-share-{}.archive", of.round, of.share);
}

void expect_no_other_hunt(const ArchiveFolder& folder, const RoundShare& of) {
  const std::filesystem::path path = archive_file(folder, of);
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return;
  InputFile file(path.string());
  const std::string text = file.read_all(kLongestArchive);
  try {
    expect_this_hunt(folder, std::string_view(text).substr(0, text.find('\n')));
  } catch (const UserError& error) {
    throw UserError(fmt::format("--archives: {}: {}", file.name(), error.what()));
  }
}

void write_archive(const ArchiveFolder& folder, const RoundShare& of,
                   const std::vector<ArchivedCase>& cases) {
  std::string rest;
  rest.reserve(cases.size() * kArchivedBytes);
  for (const ArchivedCase& one : cases) append_archived(rest, one);
  write_file(archive_file(folder, of), first_line(folder, of, rest) + rest);
}

std::vector<ArchivedCase> read_archive(const ArchiveFolder& folder, const RoundShare& of) {
  const std::filesystem::path path = archive_file(folder, of);
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) {
    throw UserError(fmt::format("--archives: {} is not there; share {} of round {} writes it",
                                printable_path(path), of.share, of.round));
  }
  if (!std::filesystem::is_regular_file(path, unknown)) {  // a pipe may never answer
    throw UserError(fmt::format("--archives: {} is no file", printable_path(path)));
  }
  InputFile file(path.string());
  const std::string text = file.read_all(kLongestArchive);
  const std::size_t end_of_first = std::min(text.find('\n'), text.size() - 1) + 1;
  std::string_view rest = std::string_view(text).substr(end_of_first);
  std::vector<ArchivedCase> cases;
  try {
    expect_whole(folder, of, text.substr(0, end_of_first), rest);
    while (rest.size() >= kArchivedBytes) {
      cases.push_back(read_archived(rest));
      rest.remove_prefix(kArchivedBytes);
    }
  } catch (const UserError& error) {
    throw UserError(fmt::format("--archives: {}: {}", file.name(), error.what()));
  }
  return cases;
}

std::vector<ArchivedCase> read_rounds_before(const ArchiveFolder& folder, std::uint64_t round) {
  std::vector<ArchivedCase> best;
  std::size_t thinned = kFewToThin;
  const auto thin = [&] { best = best_of(std::move(best), folder.rounds, folder.measure); };
  for_each_archive(folder, round, [&](const std::vector<ArchivedCase>& more) {
    best.insert(best.end(), more.begin(), more.end());
    if (best.size() < 2 * thinned) return;
    thin();
    thinned = std::max(kFewToThin, best.size());
  });
  thin();
  return best;
}

FilledCells cells_of_all(const ArchiveFolder& folder) {
  Archive archive;
  for_each_archive(folder, folder.rounds.rounds, [&](const std::vector<ArchivedCase>& more) {
    for (const ArchivedCase& one : more) {
      archive.add(one.observed, 0, [&] { return one.pair; });
    }
  });
  return archive.filled();
}

}  // namespace manifuzz
