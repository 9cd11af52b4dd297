#include <iterator>

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "corpus/corpus.hpp"
#include "sequence/sequence_json.hpp"

namespace manifuzz {
namespace {

void check_format(const JsonView& root, FormatKey format_key) {
  const auto format = root.find("format");
  if (!format && format_key == FormatKey::optional) return;
  if (!format)
    root.fail(
        fmt::format("the key \"format\" is missing; it must be \"{}\", or \"{}\" for round shapes",
                    kCaseFormat, kCurvedCaseFormat));
  if (format->string() != kCaseFormat && format->string() != kCurvedCaseFormat) {
    format->fail(fmt::format("unknown format \"{}\"; \"{}\" or \"{}\" is expected",
                             printable(format->string()), kCaseFormat, kCurvedCaseFormat));
  }
}

/// Fails unless the case is of a kind that is read.
void check_kind(const JsonView& root, CaseKind kind) {
  if (kind == CaseKind::either || is_sequence(root) == (kind == CaseKind::sequence)) return;
  root.find("format").value_or(root).fail(
      kind == CaseKind::pair
          ? "is a sequence, which takes a collider that keeps points; a pair case is expected"
          : fmt::format("is a pair case; a sequence, \"{}\", is expected", kSequenceFormat));
}

/// The first format has no round shapes.
void check_can_say(const JsonView& root, const PairCase& pair) {
  const auto format = root.find("format");
  if (!format || format->string() == kCurvedCaseFormat || !is_round(pair)) return;
  format->fail(fmt::format("\"{}\" has no round shapes; use \"{}\" for them", kCaseFormat,
                           kCurvedCaseFormat));
}

Found read_found(const JsonView& object) {
  object.expect_keys({"seed", "regime", "index", "versions", "seen", "unshrunk"});
  Found found;
  found.seed = object.at("seed").whole_number();
  found.regime = object.at("regime").string();
  found.index = object.at("index").whole_number();
  if (const auto versions = object.find("versions")) {
    for (const std::string_view name : versions->keys()) {
      found.versions[std::string(name)] = versions->at(name).string();
    }
  }
  if (const auto seen = object.find("seen")) found.seen = read_seen(*seen);
  if (const auto unshrunk = object.find("unshrunk")) found.is_unshrunk = unshrunk->boolean();
  return found;
}

double read_share(const JsonView& value) {
  const double share = value.number();
  if (share >= 0 && share <= 1) return share;
  value.fail(fmt::format("{} is not a share; a number from 0 to 1 is expected", share));
}

/// Of a sequence there is no oracle, and no neighbourhood.
Expectation read_expectation(const JsonView& object, const CorpusCase& given) {
  if (given.is_sequence()) {
    object.expect_keys({"subject", "verdict", "bucket", "magnitude", "errors"});
  } else {
    object.expect_keys(
        {"subject", "oracle", "verdict", "bucket", "severity", "magnitude", "errors", "manifolds"});
  }
  Expectation expect{object.string_or("subject", ""),
                     object.string_or("oracle", ""),
                     object.string_or("verdict", ""),
                     object.string_or("bucket", ""),
                     {}};
  if (const auto severity = object.find("severity")) expect.severity = read_share(*severity);
  if (const auto magnitude = object.find("magnitude")) expect.magnitude = magnitude->magnitude();
  if (const auto errors = object.find("errors")) expect.errors = read_errors(*errors);
  if (const auto manifolds = object.find("manifolds")) {
    for (std::size_t i = 0; i < manifolds->length("an array of manifolds"); ++i) {
      expect.manifolds.push_back(read_recorded_answer((*manifolds)[i], given.pair));
    }
  }
  return expect;
}

/// Appends "key": "text" behind `separator`, or nothing where the text is empty.
void append_member(std::string& out, std::string_view separator, std::string_view key,
                   std::string_view text) {
  if (text.empty()) return;
  fmt::format_to(std::back_inserter(out), "{}\"{}\": ", separator, key);
  append_string(out, text);
}

/// Appends "found" behind `separator`.
void append_found(std::string& out, std::string_view separator, const Found& found) {
  fmt::format_to(std::back_inserter(out), "{}\"found\": {{\"seed\": {}, \"regime\": ", separator,
                 found.seed);
  append_string(out, found.regime);
  fmt::format_to(std::back_inserter(out), ", \"index\": {}", found.index);
  std::string_view before = ", \"versions\": {";
  for (const auto& [name, version] : found.versions) {
    out += before;
    append_string(out, name);
    out += ": ";
    append_string(out, version);
    before = ", ";
  }
  if (!found.versions.empty()) out += '}';
  if (found.is_unshrunk) out += ", \"unshrunk\": true";
  if (found.seen) append_seen(out += ",\n    \"seen\": ", *found.seen);
  out += '}';
}

void append_expectation(std::string& out, const PairCase& pair, const Expectation& expect) {
  out += ",\n  \"expect\": {";
  constexpr std::string_view separator = ",\n    ";
  const std::size_t start = out.size();
  append_member(out, separator, "subject", expect.subject);
  append_member(out, separator, "oracle", expect.oracle);
  append_member(out, separator, "verdict", expect.verdict);
  append_member(out, separator, "bucket", expect.bucket);
  if (expect.severity) {
    out.append(separator) += "\"severity\": ";
    append_number(out, *expect.severity);
  }
  if (expect.magnitude) {
    out.append(separator) += "\"magnitude\": ";
    append_number(out, *expect.magnitude);
  }
  if (expect.errors) append_errors(out.append(separator) += "\"errors\": ", *expect.errors);
  if (!expect.manifolds.empty()) {
    out.append(separator) += "\"manifolds\": [";
    for (std::size_t i = 0; i < expect.manifolds.size(); ++i) {
      out += i > 0 ? ",\n      " : "\n      ";
      append_answer(out, pair, expect.manifolds[i].collider, expect.manifolds[i].answer);
    }
    out += "\n    ]";
  }
  if (out.size() > start) out.erase(start, 1);  // the comma before the first member
  out += "\n  }";
}

}  // namespace

void CorpusCase::set(const Sequence& sequence) {
  pair = sequence.at(0);
  frames = sequence.frames;
}

CorpusCase parse_case(std::string_view text, FormatKey format_key, CaseKind kind) {
  if (is_blank(text)) throw UserError("is empty; one case is expected");
  const JsonTree tree = parse_json(text);
  return read_case(JsonView(tree), format_key, kind);
}

CorpusCase read_case(const JsonView& root, FormatKey format_key, CaseKind kind) {
  CorpusCase corpus_case;
  check_kind(root, kind);
  if (is_sequence(root)) {
    root.expect_keys({"format", "a", "b", "frames", "found", "expect", "accepted", "note"});
    if (format_key == FormatKey::required) root.at("format");
    corpus_case.set(read_sequence(root));
  } else {
    root.expect_keys({"format", "a", "b", "found", "expect", "accepted", "property", "note"});
    check_format(root, format_key);
    corpus_case.pair = {read_body(root.at("a")), read_body(root.at("b"))};
    check_can_say(root, corpus_case.pair);
  }
  if (const auto found = root.find("found")) corpus_case.found = read_found(*found);
  if (const auto expect = root.find("expect")) {
    corpus_case.expect = read_expectation(*expect, corpus_case);
  }
  if (const auto accepted = root.find("accepted")) {
    corpus_case.accepted = read_acceptance(*accepted);
  }
  corpus_case.property = root.string_or("property", "");
  corpus_case.note = root.string_or("note", "");
  return corpus_case;
}

CorpusCase parse_line(const Line& line, CaseKind kind) {
  if (line.too_long) throw UserError("longer than 1 MiB; one case a line is expected");
  return parse_case(line.text, FormatKey::optional, kind);
}

CorpusCase read_case_file(const std::string& path, CaseKind kind) {
  InputFile file(path);
  const std::string text = file.read_all();
  try {
    CorpusCase corpus_case =
        parse_case(text, path.ends_with(".json") ? FormatKey::required : FormatKey::optional, kind);
    corpus_case.path = path;
    return corpus_case;
  } catch (const UserError& error) {
    throw UserError(fmt::format("{}: {}", file.name(), error.what()));
  }
}

std::string format_case(const CorpusCase& corpus_case) {
  std::string out;
  if (corpus_case.is_sequence()) {
    append_sequence_start(out, corpus_case.sequence());
  } else {
    append_case_start(out, corpus_case.pair);
  }
  if (corpus_case.found) append_found(out, ",\n  ", *corpus_case.found);
  if (corpus_case.expect) append_expectation(out, corpus_case.pair, *corpus_case.expect);
  if (corpus_case.accepted) out += acceptance_member(*corpus_case.accepted);
  append_member(out, ",\n  ", "property", corpus_case.property);
  append_member(out, ",\n  ", "note", corpus_case.note);
  return out + "\n}\n";
}

namespace {

/// Adds where it came from to a case's line.
void append_found_to_line(std::string& out, const Found& found) {
  out.pop_back();  // the brace that closes it
  append_found(out, ", ", found);
  out += '}';
}

}  // namespace

void append_found_case_line(std::string& out, const PairCase& pair, const Found& found) {
  append_case_line(out, pair);
  append_found_to_line(out, found);
}

void append_found_case_line(std::string& out, const Sequence& sequence, const Found& found) {
  append_sequence_line(out, sequence);
  append_found_to_line(out, found);
}

}  // namespace manifuzz
