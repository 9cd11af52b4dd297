#include "canary/edits.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <stdexcept>

namespace manifuzz::canary {
namespace {

std::string without_indentation(const std::string& line) {
  const std::size_t start = line.find_first_not_of(' ');
  return start == std::string::npos ? std::string() : line.substr(start);
}

bool is_identifier(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

[[noreturn]] void refuse(int line, const std::string& why) {
  throw std::runtime_error("line " + std::to_string(line) + ": " + why);
}

/// The first line of a block.
Edit headed(const std::string& line, int number) {
  const std::size_t colon = line.find(": ");
  if (colon == std::string::npos) refuse(number, "a block begins with 'bug: what is wrong'");
  Edit edit;
  edit.bug = line.substr(0, colon);
  edit.why = line.substr(colon + 2);
  edit.line = number;
  if (!is_identifier(edit.bug)) refuse(number, "a bug's name is made of a-z, 0-9 and _");
  return edit;
}

void add_line(Edit& edit, const std::string& line, int number) {
  if (edit.file.empty()) {
    edit.file = line;
  } else if (line[0] == '-' && edit.old_line.empty()) {
    edit.old_line = without_indentation(line.substr(1));
  } else if (line[0] == '+' && !edit.old_line.empty()) {
    edit.new_lines += line.substr(1) + "\n";
  } else {
    refuse(number, "a block has a file, one -line and any +lines, in this order");
  }
}

}  // namespace

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot be read: " + path.string());
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<Edit> read_edits(const std::filesystem::path& table) {
  std::istringstream stream(read_text(table));
  std::vector<Edit> edits;
  std::set<std::string> names;
  std::string line;
  bool within = false;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (!line.empty() && line[0] == '#') continue;
    if (line.empty()) {
      within = false;
    } else if (within) {
      add_line(edits.back(), line, number);
    } else {
      edits.push_back(headed(line, number));
      if (!names.insert(edits.back().bug).second) refuse(number, "a name is used once");
      within = true;
    }
  }
  return edits;
}

std::string edited(const Edit& edit, const std::string& text) {
  if (edit.old_line.empty()) return text;
  std::istringstream stream(text);
  std::string line;
  std::string result;
  int found = 0;
  while (std::getline(stream, line)) {
    const bool is_old = without_indentation(line) == edit.old_line;
    found += is_old ? 1 : 0;
    result += is_old ? edit.new_lines : line + "\n";
  }
  if (found != 1) {
    refuse(edit.line, edit.bug + ": the old line must be in " + edit.file + " once, it is there " +
                          std::to_string(found) + " times: " + edit.old_line);
  }
  return result;
}

}  // namespace manifuzz::canary
