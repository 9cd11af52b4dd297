#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace manifuzz {

/// What a person can put right: bad usage, bad input, a file that cannot be read or written. The
/// text is one printable line: where, what, and what would be right. A command that meets it ends
/// with status 2.
class UserError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Appends the shortest decimal that reads back bit for bit, read to the nearest double and then to
/// the nearest float; "null" where the number is not finite, which JSON cannot say.
void append_number(std::string& out, float value);
void append_number(std::string& out, double value);

/// Appends a JSON string, quotes included. Bytes that are not UTF-8 become U+FFFD.
void append_string(std::string& out, std::string_view text);

/// `text` fit for an error line: printable ASCII as it is, every other byte as \xNN, shortened to
/// `longest` characters.
std::string printable(std::string_view text, std::size_t longest = 40);

/// As one word of a shell's command line: in single quotes where it needs them.
std::string quoted_for_shell(std::string_view text);

/// "2 points", "1 point"; `plural` where it is not the noun with an s.
std::string counted(std::uint64_t count, std::string_view noun, std::string_view plural = {});

/// "once", "2 times".
std::string times_in_words(std::uint64_t count);

/// The candidate that was most likely meant by `word`: the only one that begins with it, else the
/// first of those with the fewest slips (a character too many, missing, another, or two swapped),
/// at most one in three characters. Nothing where none is that near.
std::optional<std::string_view> nearest(std::string_view word,
                                        std::span<const std::string_view> candidates);

/// "; did you mean 'sliver'?", or nothing where no candidate is near.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates);

/// "there is no regime 'slivr'; did you mean 'sliver'?", then what there is, unless that is long
/// and the nearest was named.
std::string no_such(std::string_view kind, std::string_view word,
                    std::span<const std::string_view> candidates);

/// The `name`s of a list's elements, each once.
template <class List>
std::vector<std::string_view> names_of(const List& list) {
  std::vector<std::string_view> names;
  for (const auto& element : list) {
    if (std::ranges::find(names, element.name) == names.end()) names.emplace_back(element.name);
  }
  return names;
}

/// The first element of `list` with that name, or nullptr.
template <class List>
auto find_by_name(const List& list, std::string_view name) {
  const auto found =
      std::ranges::find_if(list, [&](const auto& element) { return element.name == name; });
  return found == std::end(list) ? nullptr : &*found;
}

/// The first elements of `list` with these names, each once, in the order in which they are named;
/// all of the list for no name. Throws UserError where there is none: `option`, `no_such(kind)`.
template <class List>
auto chosen_by_name(const List& list, std::span<const std::string> names, std::string_view kind,
                    std::string_view option) {
  std::vector<decltype(&*std::begin(list))> chosen;
  const auto choose = [&chosen](const auto& element) {
    if (std::ranges::find(chosen, &element) == chosen.end()) chosen.push_back(&element);
  };
  for (const std::string& name : names) {
    const auto* const found = find_by_name(list, name);
    if (!found) throw UserError(std::string(option) + ": " + no_such(kind, name, names_of(list)));
    choose(*found);
  }
  if (names.empty()) std::ranges::for_each(list, choose);
  return chosen;
}

}  // namespace manifuzz
