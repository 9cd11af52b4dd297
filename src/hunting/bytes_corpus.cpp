#include "hunting/bytes_corpus.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>

#include "base/random.hpp"
#include "corpus/corpus.hpp"
#include "hunting/case_bytes.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& input) {
  std::error_code unknown;
  if (!fs::is_directory(input, unknown)) return {input};
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(input, unknown)) {
    if (entry.is_regular_file(unknown)) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

std::optional<PairCase> case_in(const fs::path& path) {
  InputFile file(path.string());
  std::array<char, kCaseBytes + 1> text;
  std::vector<std::uint8_t> bytes;
  while (bytes.size() <= kCaseBytes) {
    const std::size_t count = file.read(text.data(), text.size());
    if (count == 0) break;
    bytes.insert(bytes.end(), text.begin(), text.begin() + count);
  }
  return decode_case(bytes);
}

}  // namespace

Rewritten write_as_bytes(std::span<const fs::path> cases, const fs::path& folder,
                         const std::function<bool(const PairCase&)>& is_asked_for) {
  const Corpus corpus = read_corpus(cases);
  if (!corpus.errors.empty()) throw UserError(corpus.errors.front());
  Rewritten result{.left_out = corpus.others.size()};
  for (const CorpusCase& one : corpus.cases) {
    if (!is_asked_for(one.pair())) {
      ++result.left_out;
      continue;
    }
    std::array<std::uint8_t, kCaseBytes> bytes;
    encode_case(one.pair(), bytes);
    const std::string text(bytes.begin(), bytes.end());
    write_file(folder / fmt::format("{:016x}", mix(hash_of(text))), text);
    ++result.written;
  }
  return result;
}

Rewritten write_as_json(std::span<const fs::path> inputs, const fs::path& folder) {
  Rewritten result;
  for (const fs::path& input : inputs) {
    for (const fs::path& file : files_in(input)) {
      const auto pair = case_in(file);
      if (pair) {
        const Found found{.regime = std::string(kRegimeOfHunts), .versions = {}};
        write_corpus_case(folder, {.any = *pair, .found = found});
        ++result.written;
      } else {
        ++result.left_out;
      }
    }
  }
  return result;
}

}  // namespace manifuzz
