#include "corpus/corpus.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <system_error>

#include <fmt/format.h>

#include "base/random.hpp"

namespace manifuzz {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".json";
constexpr std::string_view kWorstEnding = ".worst.json";

/// By how its first line begins. What is no file is not opened: a pipe may never answer.
bool is_conformance_suite(const fs::path& path) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown)) return false;
  const std::string begin = fmt::format(R"({{"format":"{}")", kConformanceFormat);
  std::string found(begin.size(), ' ');
  std::ifstream(path).read(found.data(), static_cast<std::streamsize>(found.size()));
  return found == begin;
}

bool holds_cases(const fs::path& path) {
  if (path.filename() == "subjects.json") return false;  // names colliders
  if (path.extension() == ".jsonl" && is_conformance_suite(path)) return false;
  return path.extension() == ".json" || path.extension() == ".jsonl";
}

/// Adds the files of cases in `folder` and below; a folder that cannot be read is an error line.
void add_folder(const fs::path& folder, std::vector<fs::path>& files,
                std::vector<std::string>& errors) {
  std::error_code error;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code unknown;
    if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) {
      add_folder(entry->path(), files, errors);
    } else if (holds_cases(entry->path()) && !entry->is_other(unknown)) {
      files.push_back(entry->path());
    }
  }
  if (error) {
    errors.push_back(
        fmt::format("{}: cannot read the folder: {}", printable_path(folder), error.message()));
  }
}

void read_lines_file(const std::string& path, Corpus& corpus) {
  InputFile file(path);
  LineReader lines(file);
  std::size_t good = 0;
  std::size_t bad = 0;
  std::string first_error;
  while (const auto line = lines.next()) {
    try {
      CorpusCase one = parse_line(*line, CaseKind::either);
      one.path = fmt::format("{}:{}", path, line->number);
      corpus.add(std::move(one));
      ++good;
    } catch (const UserError& error) {
      if (bad++ == 0)
        first_error = fmt::format("{}:{}: {}", file.name(), line->number, error.what());
    }
  }
  if (bad > 1) first_error += fmt::format(" (and {} more bad lines)", bad - 1);
  if (bad > 0) throw UserError(first_error);
  if (good == 0) throw UserError(file.name() + ": is empty; one case a line is expected");
}

/// What names a case's look: the first part of its file's name.
std::string look_of(const CorpusCase& corpus_case) {
  std::string look = "case";
  if (!corpus_case.property.empty()) look = "property-" + corpus_case.property;
  if (corpus_case.expect && !corpus_case.expect->bucket.empty()) look = corpus_case.expect->bucket;
  constexpr std::size_t longest = 150;
  look.resize(std::min(look.size(), longest));
  std::replace_if(
      look.begin(), look.end(),
      [](unsigned char c) { return c >= 0x80 || (std::isalnum(c) == 0 && c != '_'); }, '-');
  return look;
}

bool is_same_finding(const CorpusCase& known, const CorpusCase& other) {
  const Expectation expect = known.expect.value_or(Expectation{});
  const Expectation of_other = other.expect.value_or(Expectation{});
  return known.any == other.any && known.property == other.property &&
         expect.bucket == of_other.bucket && expect.subject == of_other.subject &&
         expect.oracle == of_other.oracle;
}

bool holds(const fs::path& file, const CorpusCase& corpus_case) {
  try {
    return is_same_finding(read_case_file(file.string(), CaseKind::either), corpus_case);
  } catch (const UserError&) {
    return false;
  }
}

}  // namespace

void Corpus::add(CorpusCase one) {
  (kind_of(one.any) == CaseKind::pair ? cases : others).push_back(std::move(one));
}

void Corpus::add(Corpus more) {
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::move_iterator(from.begin()), std::move_iterator(from.end()));
  };
  append(cases, more.cases);
  append(errors, more.errors);
  append(files, more.files);
  append(others, more.others);
}

std::vector<CorpusCase> Corpus::all() const {
  std::vector<CorpusCase> both = cases;
  both.insert(both.end(), others.begin(), others.end());
  return both;
}

std::vector<fs::path> find_case_files(std::span<const fs::path> paths,
                                      std::vector<std::string>& errors) {
  std::vector<fs::path> files;
  for (const auto& path : paths) {
    std::error_code error;
    if (fs::is_directory(path, error)) {
      add_folder(path, files, errors);
    } else if (fs::exists(path, error) && !holds_cases(path)) {
      errors.push_back(fmt::format("{}: not a file of cases; *.json or *.jsonl is expected",
                                   printable_path(path)));
    } else {
      files.push_back(path);
    }
  }
  std::sort(files.begin(), files.end());
  std::set<fs::path> places;
  std::erase_if(files, [&](const fs::path& file) { return !places.insert(resolved(file)).second; });
  return files;
}

void add_case_file(const fs::path& path, Corpus& corpus) {
  try {
    if (path.extension() == ".jsonl") {
      read_lines_file(path.string(), corpus);
    } else {
      corpus.add(read_case_file(path.string(), CaseKind::either));
    }
  } catch (const UserError& error) {
    corpus.errors.emplace_back(error.what());
  }
}

Corpus read_corpus(std::span<const fs::path> paths) {
  Corpus corpus;
  corpus.files = find_case_files(paths, corpus.errors);
  for (const auto& path : corpus.files) add_case_file(path, corpus);
  return corpus;
}

std::string corpus_file_name(const CorpusCase& corpus_case) {
  std::string text;
  append_case_line(text, corpus_case.any);
  return fmt::format("{}-{:08x}.json", look_of(corpus_case), mix(hash_of(text)) >> 32);
}

fs::path corpus_file(const fs::path& folder, const CorpusCase& corpus_case) {
  const fs::path usual = folder / corpus_file_name(corpus_case);
  fs::path file = usual;
  std::error_code unknown;
  for (int turn = 2; fs::is_regular_file(file, unknown) && !holds(file, corpus_case); ++turn) {
    file = folder / fmt::format("{}-{}{}", usual.stem().string(), turn, kEnding);
  }
  return file;
}

fs::path write_corpus_case(const fs::path& folder, const CorpusCase& corpus_case) {
  const fs::path file = corpus_file(folder, corpus_case);
  std::error_code unknown;
  const bool holds_it = fs::is_regular_file(file, unknown);  // else it would have another name
  if (!holds_it) write_file(file, format_case(corpus_case));
  return file;
}

void write_acceptance(const std::string& file, const std::optional<Acceptance>& acceptance) {
  if (!file.ends_with(kEnding)) {
    throw UserError(fmt::format("{}: holds lines; a file of one case, *.json, is expected",
                                printable_path(file)));
  }
  CorpusCase known = read_case_file(file, CaseKind::either);
  std::string text = InputFile(file).read_all();  // all else stays as it is written
  if (known.accepted) {
    const std::string member = acceptance_member(*known.accepted);
    const std::size_t at = text.find(member);
    if (at == std::string::npos) {
      known.accepted.reset();
      text = format_case(known);
    } else {
      text.erase(at, member.size());
    }
  }
  if (acceptance) {
    const std::size_t end = text.find_last_not_of(" \t\r\n", text.rfind('}') - 1) + 1;
    text.insert(end, acceptance_member(*acceptance));
  }
  write_file(file, text);
}

fs::path worst_beside(const fs::path& file) {
  return fs::path(file).replace_extension(kWorstEnding);
}

bool is_worst(std::string_view path) {
  return path.ends_with(kWorstEnding);
}

std::string collider_of_hunted(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  return folder.parent_path().filename() == "worst" ? folder.filename().string() : "";
}

std::string shrunk_beside(std::string_view path) {
  if (!is_worst(path)) return std::string(path);
  path.remove_suffix(kWorstEnding.size());
  return std::string(path) + std::string(kEnding);
}

void write_worst_case(const fs::path& file, const CorpusCase& worst) {
  write_file(worst_beside(file), format_case(worst));
}

void answer_each(const std::string& path, CaseKind kind, const AnswerCase& answer) {
  InputFile file(path);
  Output out;
  const bool is_one_case = path.ends_with(".json");
  std::string lines;
  std::size_t cases = 0;
  std::size_t bad = 0;
  std::string first_error;
  const auto write_answer = [&](std::size_t number, const auto& read) {
    lines.clear();
    ++cases;
    try {
      answer(read().any, cases - 1, lines);
    } catch (const UserError& error) {
      const std::string place = is_one_case ? "" : fmt::format(":{}", number);
      if (bad++ == 0) first_error = fmt::format("{}{}: {}", file.name(), place, error.what());
      lines = "{\"error\": ";
      append_string(lines, error.what());
      lines += fmt::format(", \"line\": {}}}", number);
    }
    out.write(lines += '\n');
  };
  if (is_one_case) {
    const std::string text = file.read_all();
    write_answer(1, [&] { return parse_case(text, FormatKey::required, kind); });
  } else {
    LineReader reader(file, [&] { out.flush(); });
    while (const auto line = reader.next()) {
      write_answer(line->number, [&] { return parse_line(*line, kind); });
    }
  }
  out.flush();
  if (cases == 0) throw UserError(file.name() + ": is empty; one case a line is expected");
  if (bad == 0) return;
  throw UserError(is_one_case ? first_error
                              : fmt::format("{} ({} bad of {})", first_error, bad, cases));
}

}  // namespace manifuzz
