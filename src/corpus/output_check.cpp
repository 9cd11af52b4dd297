#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file.hpp"
#include "base/text.hpp"
#include "corpus/corpus.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const OutputPath& output, std::string_view what) {
  throw BadOutput(fmt::format("{}: {}", output.option, what), {output.option});
}

bool is_folder(const OutputPath& output) {
  return output.kind == OutputPath::Kind::folder || output.kind == OutputPath::Kind::corpus;
}

bool is_stdout(const OutputPath& output) {
  return output.path == "-" && output.kind == OutputPath::Kind::data;
}

/// Whether nothing can lie below it: a file, or one to be; what is a folder where a file is
/// expected has nothing to do with others.
bool excludes_below(const OutputPath& output) {
  std::error_code unknown;
  return !is_folder(output) && !fs::is_directory(output.path, unknown);
}

/// Whether both cannot be: two files in one place, or one below the other.
bool exclude_each_other(const OutputPath& one, const OutputPath& other) {
  if (is_stdout(one) || is_stdout(other)) return is_stdout(one) && is_stdout(other);
  const Place of_one(one.path);
  const Place of_other(other.path);
  return (excludes_below(other) && of_one.is_within(of_other)) ||
         (excludes_below(one) && of_other.is_within(of_one));
}

void expect_apart(const OutputPath& output, const std::vector<OutputPath>& others) {
  for (const OutputPath& other : others) {
    if (other.path.empty() || !exclude_each_other(output, other)) continue;
    throw BadOutput(fmt::format("{}: {} writes to {} already; name another file", output.option,
                                other.option, printable_path(other.path)),
                    {output.option, other.option});
  }
}

/// A file below a folder of cases that is none of them, and would be taken for one.
void expect_outside(const OutputPath& output, const fs::path& folder) {
  const bool looks_like_case = output.path.ends_with(".json") || output.path.ends_with(".jsonl");
  if (is_folder(output) || !looks_like_case) return;
  if (!Place(output.path).is_within(Place(folder))) return;
  fail(output, fmt::format("{} would be taken for a case of {}; name another",
                           printable_path(output.path), printable_path(folder)));
}

/// A file that is read, one of a folder too; and a folder for cases in one whose cases are read.
void expect_not_read(const OutputPath& output, const std::vector<fs::path>& inputs) {
  const Place place(output.path);
  if (output.kind == OutputPath::Kind::corpus) {
    for (const fs::path& input : inputs) {
      const Place read(input);
      if (place.is_same(read) || !place.is_within(read)) continue;
      fail(output, fmt::format("{} lies in {}, whose cases are read; name another",
                               printable_path(output.path), printable_path(input)));
    }
  }
  if (is_folder(output) || !place.file) return;
  std::vector<std::string> unread;
  std::vector<fs::path> files = find_case_files(inputs, unread);
  files.insert(files.end(), inputs.begin(), inputs.end());  // whatever their names end in
  if (!output.replaces.empty() && place.is_same(Place(output.replaces))) return;
  const bool is_read = std::ranges::any_of(
      files, [&](const fs::path& file) { return file != "-" && place.is_same(Place(file)); });
  if (!is_read) return;
  fail(output, printable_path(output.path) + " is one of the files that are read; name another");
}

void check_places(const OutputPath& output, const std::vector<OutputPath>& others,
                  const std::vector<fs::path>& inputs) {
  expect_apart(output, others);
  if (is_stdout(output)) return;
  for (const fs::path& input : inputs) {
    std::error_code unknown;
    if (input != "-" && fs::is_directory(input, unknown)) expect_outside(output, input);
  }
  for (const OutputPath& other : others) {
    const bool is_corpus = other.kind == OutputPath::Kind::corpus && !other.path.empty();
    if (is_corpus) expect_outside(output, other.path);
  }
  expect_not_read(output, inputs);
}

void expect_ending(const OutputPath& output) {
  const auto has = [&](std::string_view ending) { return output.path.ends_with(ending); };
  if (output.endings.empty() || is_stdout(output) || std::ranges::any_of(output.endings, has))
    return;
  fail(output, fmt::format("{}: a name that ends in {} is expected", printable_path(output.path),
                           fmt::join(output.endings, " or ")));
}

/// What is missing of it is made and taken away again.
void expect_possible(const OutputPath& output) {
  if (output.path == "-") {
    fail(output, fmt::format("- cannot be used here; a {} is expected",
                             is_folder(output) ? "folder" : "file"));
  }
  const auto expect = [&](const fs::path& path, const std::string& why) {
    if (!why.empty()) fail(output, fmt::format("{}: {}", printable_path(path), why));
  };
  expect(output.path,
         is_folder(output) ? why_no_folder(output.path) : why_not_writable(output.path));
  if (output.kind != OutputPath::Kind::corpus) return;
  for (const std::string_view name : kCorpusFolders) {
    const fs::path folder = fs::path(output.path) / name;
    if (fs::exists(fs::symlink_status(folder))) expect(folder, why_no_folder(folder));
  }
}

}  // namespace

bool BadOutput::concerns(std::string_view option) const {
  return std::ranges::find(options, option) != options.end();
}

bool check_outputs(const CommandFiles& files) {
  std::vector<OutputPath> checked;
  bool takes_stdout = false;
  for (const OutputPath& output : files.outputs) {
    if (output.path.empty()) continue;
    expect_ending(output);
    check_places(output, checked, files.inputs);
    takes_stdout = takes_stdout || is_stdout(output);
    checked.push_back(output);
  }
  for (const OutputPath& output : checked) {
    if (!is_stdout(output)) expect_possible(output);
  }
  return takes_stdout;
}

bool is_apart(const OutputPath& output, const CommandFiles& files) {
  if (output.path.empty()) return true;
  try {
    check_places(output, files.outputs, files.inputs);
    return true;
  } catch (const BadOutput&) {
    return false;
  }
}

}  // namespace manifuzz
