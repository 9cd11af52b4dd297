#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "canary/edits.hpp"

// Writes a translation unit that holds a copy of some sources for each planted bug, its edit
// applied, in a namespace of its own:
//
//   plant TABLE SOURCE_DIR OUTPUT ROOT SHARE SHARES {--edits PATH [--as SUFFIX] FILE...}...
//
// ROOT is the file to compile. A bug whose edit is in PATH, a file or a folder, gets copies of the
// FILEs it includes; all else is shared. SUFFIX makes its name another one, where several roots
// have the bug. Of all such bugs, every SHARES-th from SHARE on is taken.

using namespace manifuzz::canary;
namespace fs = std::filesystem;

namespace {

/// The files to be copied for bugs in a file, or in the files of a folder.
struct Part {
  std::string path;
  std::string suffix;
  std::set<std::string> copied;

  bool has(const std::string& file) const { return file == path || file.starts_with(path + "/"); }
};

bool is_word_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Highway includes files that end so once a target; each copy has an include guard of its own.
std::string with_own_guard(std::string line, const std::string& bug) {
  constexpr std::string_view ending = "_INL";
  if (line.starts_with('#') && line.find("MANIFUZZ_") != std::string::npos) {
    const std::size_t at = line.find(ending);
    if (at != std::string::npos) line.insert(at + ending.size(), "_" + bug);
  }
  return line;
}

/// Each time `word` stands in the text as a word of its own, `by` takes its place.
std::string with_word_replaced(std::string text, std::string_view word, std::string_view by) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
    const std::size_t end = at + word.size();
    const bool whole = (at == 0 || !is_word_character(text[at - 1])) &&
                       (end == text.size() || !is_word_character(text[end]));
    if (whole) text.replace(at, word.size(), by);
    at += whole ? by.size() : word.size();
  }
  return text;
}

/// One bug's copies, put into one text in the order in which they include each other.
class Copies {
 public:
  Copies(const fs::path& source, const Edit& edit, const Part& part)
      : source_(source), edit_(edit), part_(part) {}

  void add(const std::string& file) {
    if (!added_.insert(file).second) return;
    std::string text = read_text(source_ / file);
    if (file == edit_.file) text = edited(edit_, text);
    std::istringstream lines(text);
    std::string line;
    while (std::getline(lines, line)) add_line(line);
  }

  const std::string& text() const { return text_; }

 private:
  void add_line(const std::string& line) {
    constexpr std::string_view include = "#include \"";
    if (line == "#pragma once") return;
    if (line.starts_with(include)) {
      const std::size_t start = include.size();
      if (const auto file = copied(line.substr(start, line.find('"', start) - start))) {
        add(*file);
      } else {
        text_ += line + "\n";
      }
      return;
    }
    const std::string guarded = with_own_guard(line, edit_.bug);
    const std::string named = with_word_replaced(guarded, "PLANTED_BUG", edit_.bug);
    text_ += with_word_replaced(named, "manifuzz", "manifuzz::planted::" + edit_.bug) + "\n";
  }

  /// The file that an include means, if it is one to be copied.
  std::optional<std::string> copied(const std::string& included) const {
    for (const std::string& file : {"src/" + included, included}) {
      if (part_.copied.count(file) > 0) return file;
    }
    return std::nullopt;
  }

  const fs::path& source_;
  const Edit& edit_;
  const Part& part_;
  std::set<std::string> added_;
  std::string text_;
};

/// What copies do not redefine is found in the project's own namespace.
std::string opening(const Edit& edit) {
  return "\n// " + edit.bug + ": " + edit.why + "\nnamespace manifuzz {}\n" +
         "namespace manifuzz::planted::" + edit.bug + " {\nusing namespace ::manifuzz;\n}\n";
}

std::vector<Part> read_parts(std::span<char*> arguments) {
  std::vector<Part> parts;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == std::string("--edits") && i + 1 < arguments.size()) {
      parts.push_back({arguments[++i], {}, {}});
    } else if (parts.empty()) {
      throw std::runtime_error("files come after --edits PATH");
    } else if (arguments[i] == std::string("--as") && i + 1 < arguments.size()) {
      parts.back().suffix = arguments[++i];
    } else {
      parts.back().copied.insert(arguments[i]);
    }
  }
  return parts;
}

/// Leaves a file alone that says the same, so that nothing is compiled for nothing.
void write(const fs::path& path, const std::string& text) {
  if (fs::exists(path) && read_text(path) == text) return;
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error("cannot be written: " + path.string());
}

void plant(std::span<char*> arguments) {
  if (arguments.size() < 7) throw std::runtime_error("too few arguments");
  const fs::path source = arguments[1];
  const std::string root = arguments[3];
  const int share = std::stoi(arguments[4]);
  const int shares = std::stoi(arguments[5]);
  const std::vector<Part> parts = read_parts(arguments.subspan(6));
  std::string text = "// Made by plant.cpp from the table of planted bugs.\n";
  int taken = 0;
  for (Edit& edit : read_edits(arguments[0])) {
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const Part& candidate) { return candidate.has(edit.file); });
    if (part == parts.end() || taken++ % shares != share) continue;
    edited(edit, read_text(source / edit.file));  // wherever it is, it must apply
    edit.bug += part->suffix;
    Copies copies(source, edit, *part);
    copies.add(root);
    text += opening(edit) + copies.text();
  }
  write(arguments[2], text);
}

}  // namespace

int main(int count, char** arguments) try {
  plant(std::span(arguments, static_cast<std::size_t>(count)).subspan(1));
  return 0;
} catch (const std::exception& error) {
  std::cerr << "plant: " << (count > 1 ? arguments[1] : "") << ": " << error.what() << "\n";
  return 2;
}
