#pragma once

#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "judging/ledger.hpp"

namespace manifuzz {

/// A number that reads back bit for bit.
template <class Number>
std::string digits(Number value) {
  std::string out;
  append_number(out, value);
  return out;
}

/// Given numbers, which are floats, to the last bit; of computed ones the sign of a zero says
/// nothing.
template <class Number>
std::string digits(const Vector2<Number>& v) {
  constexpr Number zero = std::is_same_v<Number, float> ? -0.0F : 0;  // x + -0 is x
  return fmt::format("({}, {})", digits(v.x() + zero), digits(v.y() + zero));
}

/// What `line_of` says of each of a list, one after the other.
std::string lines_of(const auto& list, const auto& line_of) {
  std::string lines;
  for (const auto& one : list) lines += line_of(one);
  return lines;
}

/// Named values below each other.
struct Rows {
  int name_width = 0;
  std::string text{};

  void add(std::string_view name, std::string_view value) {
    text += fmt::format("  {:<{}} {}\n", name, name_width, value);
  }
  /// Verdict, bucket, magnitude, and the ledger's entry if there is one.
  void add_finding(const Bucket& bucket, double magnitude, const LedgerEntry* explanation);
  /// Where the case was drawn, by which `regime`, what was found beside it, and its note.
  void add_origin(const CorpusCase& given, std::string_view regime);
};

}  // namespace manifuzz
