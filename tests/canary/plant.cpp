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
#include "canary/switches.hpp"

// Writes a translation unit that holds planted bugs:
//
//   plant TABLE SOURCE_DIR OUTPUT ROOT {--edits PATH [--as SUFFIX] FILE...}...
//
// ROOT is the file to compile. A bug whose edit is in PATH, a file or a folder, is in copies of the
// FILEs that ROOT includes, which have a namespace of their own; all else is shared, and a source
// that is none of the FILEs is linked. Bugs that fit behind switches have copies together, each
// other has copies alone. SUFFIX makes a bug's name another one, where several roots have the bug.

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
std::string with_own_guard(std::string line, const std::string& name) {
  constexpr std::string_view ending = "_INL";
  if (line.starts_with('#') && line.find("MANIFUZZ_") != std::string::npos) {
    const std::size_t at = line.find(ending);
    if (at != std::string::npos) line.insert(at + ending.size(), "_" + name);
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

/// The bugs that have copies in common: one, or all those behind switches.
struct Planting {
  std::string name;  ///< of the namespace
  std::string table;
  std::vector<Edit> edits;
  bool is_switched = false;
};

/// The copies of a planting, put into one text in the order in which they include each other.
class Copies {
 public:
  Copies(const fs::path& source, const Planting& planting, const Part& part)
      : source_(source), planting_(planting), part_(part) {}

  void add(const std::string& file) {
    if (!added_.insert(file).second) return;
    std::istringstream lines(planted(file, read_text(source_ / file)));
    std::string line;
    while (std::getline(lines, line)) add_line(line);
  }

  const std::string& text() const { return text_; }

 private:
  std::string planted(const std::string& file, const std::string& text) const {
    std::vector<Edit> edits;
    std::ranges::copy_if(planting_.edits, std::back_inserter(edits),
                         [&](const Edit& edit) { return edit.file == file; });
    if (planting_.is_switched) return switched(edits, text);
    return edits.empty() ? text : edited(edits.front(), text);
  }

  void add_line(const std::string& line) {
    constexpr std::string_view include = "#include \"";
    if (line == "#pragma once") return;
    if (line.starts_with(include)) {
      const std::size_t start = include.size();
      const std::string included = line.substr(start, line.find('"', start) - start);
      if (const auto file = copied(included)) {
        add(*file);
      } else if (!included.ends_with(".cpp")) {  // which is linked instead
        text_ += line + "\n";
      }
      return;
    }
    const std::string guarded = with_own_guard(line, planting_.name);
    const std::string named = with_word_replaced(guarded, "PLANTED_BUGS", bugs());
    text_ += with_word_replaced(named, "manifuzz", "manifuzz::planted::" + planting_.name) + "\n";
  }

  /// The elements of a list of Bug.
  std::string bugs() const {
    std::string list;
    for (const Edit& edit : planting_.edits) {
      list += "{\"" + edit.bug + part_.suffix + "\", " + std::to_string(edit.line) + ", \"" +
              planting_.table + "\"}, ";
    }
    return list;
  }

  /// The file that an include means, if it is one to be copied.
  std::optional<std::string> copied(const std::string& included) const {
    for (const std::string& file : {"src/" + included, included}) {
      if (part_.copied.count(file) > 0) return file;
    }
    return std::nullopt;
  }

  const fs::path& source_;
  const Planting& planting_;
  const Part& part_;
  std::set<std::string> added_;
  std::string text_;
};

/// What copies do not redefine is found in the project's own namespace.
std::string opening(const Planting& planting) {
  std::string text;
  for (const Edit& edit : planting.edits) text += "\n// " + edit.bug + ": " + edit.why;
  return text + "\nnamespace manifuzz {}\nnamespace manifuzz::planted::" + planting.name +
         " {\nusing namespace ::manifuzz;\n}\n";
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

std::string identifier(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return !is_word_character(c); }, '_');
  return text;
}

/// The part's bugs, those behind switches first. Throws std::runtime_error where an edit does not
/// apply.
std::vector<Planting> plantings_of(const Part& part, std::span<const Edit> edits,
                                   const fs::path& source, const std::string& table) {
  std::vector<Planting> plantings{
      {identifier(table + "_" + part.path) + part.suffix, table, {}, true}};
  for (const Edit& edit : edits) {
    if (!part.has(edit.file)) continue;
    const std::string text = read_text(source / edit.file);
    edited(edit, text);
    if (edit.old_line.empty() || fits_switch(edit, text)) {
      plantings.front().edits.push_back(edit);
    } else {
      plantings.push_back({edit.bug + part.suffix, table, {edit}});
    }
  }
  return plantings;
}

void plant(std::span<char*> arguments) {
  if (arguments.size() < 5) throw std::runtime_error("too few arguments");
  const fs::path table = arguments[0];
  const fs::path source = arguments[1];
  const std::vector<Edit> edits = read_edits(table);
  std::string text =
      "// Made by plant.cpp from the table of planted bugs.\n#include \"canary/acting.hpp\"\n";
  for (const Part& part : read_parts(arguments.subspan(4))) {
    for (const Planting& planting : plantings_of(part, edits, source, table.stem().string())) {
      if (planting.edits.empty()) continue;
      Copies copies(source, planting, part);
      copies.add(arguments[3]);
      text += opening(planting) + copies.text();
    }
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
