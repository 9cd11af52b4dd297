#include "base/text.hpp"

#include <charconv>
#include <cmath>

#include <fmt/compile.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

namespace manifuzz {
namespace {

/// Whether JSON has other words for it than fmt; those are appended.
bool append_special(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return true;
  }
  if (value == 0 && std::signbit(value)) {
    out += "-0.0";  // "-0" is an integer to many readers, and integers have no sign of zero
    return true;
  }
  return false;
}

}  // namespace

std::string quoted_for_shell(std::string_view text) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";
  if (!text.empty() && text.find_first_not_of(plain) == std::string_view::npos) {
    return std::string(text);
  }
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

void append_number(std::string& out, double value) {
  if (append_special(out, value)) return;
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value);
}

void append_number(std::string& out, float value) {
  if (append_special(out, value)) return;
  const std::size_t start = out.size();
  fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), value);
  double read = 0;
  std::from_chars(out.data() + start, out.data() + out.size(), read);
  if (static_cast<float>(read) == value) return;
  out.resize(start);  // rounded twice, a few floats' shortest decimals end up beside them
  append_number(out, static_cast<double>(value));
}

void append_string(std::string& out, std::string_view text) {
  constexpr auto replace = nlohmann::json::error_handler_t::replace;
  out += nlohmann::json(text).dump(-1, ' ', false, replace);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string out;
  for (const char c : text) {
    if (out.size() >= longest) return out + "...";
    if (c >= ' ' && c <= '~') {
      out += c;
    } else {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return out;
}

namespace {

/// So many names can be taken in at a glance.
constexpr std::size_t kShortList = 10;

/// The Damerau-Levenshtein distance, no character being changed twice: insertions, deletions,
/// replacements and swaps of neighbours that turn `a` into `b`.
std::size_t slips(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::vector<std::size_t> row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = std::move(last);
    last = std::move(row);
  }
  return last.back();
}

std::optional<std::string_view> only_one_that_begins_with(
    std::string_view word, std::span<const std::string_view> candidates) {
  const auto begins = [word](std::string_view candidate) { return candidate.starts_with(word); };
  if (word.empty() || std::ranges::count_if(candidates, begins) != 1) return std::nullopt;
  return *std::ranges::find_if(candidates, begins);
}

}  // namespace

std::string counted(std::uint64_t count, std::string_view noun, std::string_view plural) {
  if (count != 1 && !plural.empty()) return fmt::format("{} {}", count, plural);
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string times_in_words(std::uint64_t count) {
  return count == 1 ? "once" : fmt::format("{} times", count);
}

std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates) {
  if (const auto begun = only_one_that_begins_with(word, candidates)) return begun;
  std::optional<std::string_view> best;
  std::size_t fewest = 0;
  for (const std::string_view candidate : candidates) {
    const auto [shorter, longer] = std::minmax({word.size(), candidate.size()});
    if (longer - shorter > longer / 3) continue;  // a word of a megabyte is not compared at all
    const std::size_t count = slips(word, candidate);
    if (count > longer / 3 || (best && count >= fewest)) continue;
    best = candidate;
    fewest = count;
  }
  return best;
}

std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates) {
  const auto meant = nearest(word, candidates);
  return meant ? fmt::format("; did you mean '{}'?", *meant) : "";
}

std::string no_such(std::string_view kind, std::string_view word,
                    std::span<const std::string_view> candidates) {
  std::string text = fmt::format("there is no {} '{}'", kind, printable(word));
  const std::string suggestion = did_you_mean(word, candidates);
  if (suggestion.empty()) return text + fmt::format("; there are {}", fmt::join(candidates, ", "));
  text += suggestion;
  if (candidates.size() > kShortList) return text;
  return text + fmt::format(" There are {}", fmt::join(candidates, ", "));
}

}  // namespace manifuzz
