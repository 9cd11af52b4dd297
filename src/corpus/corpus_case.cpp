#include <algorithm>
#include <array>
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

/// The first format has no round shapes.
void check_can_say(const JsonView& root, const PairCase& pair) {
  const auto format = root.find("format");
  if (!format || format->string() == kCurvedCaseFormat || !is_round(pair)) return;
  format->fail(fmt::format("\"{}\" has no round shapes; use \"{}\" for them", kCaseFormat,
                           kCurvedCaseFormat));
}

AnyCase read_pair_case(const JsonView& root, FormatKey format_key) {
  root.expect_keys({"format", "a", "b", "found", "expect", "accepted", "property", "note"});
  check_format(root, format_key);
  const PairCase pair{read_body(root.at("a")), read_body(root.at("b"))};
  check_can_say(root, pair);
  return pair;
}

AnyCase read_sequence_case(const JsonView& root, FormatKey format_key) {
  root.expect_keys({"format", "a", "b", "frames", "found", "expect", "accepted", "note"});
  if (format_key == FormatKey::required) root.at("format");
  return read_sequence(root);
}

constexpr std::array<std::string_view, 8> kExpectationOfPair{
    "subject", "oracle", "verdict", "bucket", "severity", "magnitude", "errors", "manifolds"};
/// There is no oracle, and no neighbourhood.
constexpr std::array<std::string_view, 5> kExpectationOfSequence{"subject", "verdict", "bucket",
                                                                 "magnitude", "errors"};

/// How files have a kind of case.
struct CaseFormat {
  bool (*is_of)(const JsonView& root);
  AnyCase (*read)(const JsonView& root, FormatKey format_key);
  std::span<const std::string_view> expectation;  ///< what is recorded of a verdict
  std::string_view what;                          ///< it is, where another kind is expected
  std::string_view expected;                      ///< where it is another
};

/// The kinds, in the order of AnyCase.
constexpr std::array<CaseFormat, std::variant_size_v<AnyCase>> kFormats{
    {{[](const JsonView& root) { return !is_sequence(root); }, read_pair_case, kExpectationOfPair,
      "is a pair case", "a pair case is expected"},
     {is_sequence, read_sequence_case, kExpectationOfSequence,
      "is a sequence, which takes a collider that keeps points",
      "a sequence, \"manifuzz/sequence/1\", is expected"}}};

/// The format of an object. Fails unless the case is of a kind that is read.
const CaseFormat& format_of(const JsonView& root, CaseKind kind) {
  const CaseFormat& format =
      *std::ranges::find_if(kFormats, [&](const CaseFormat& one) { return one.is_of(root); });
  const auto wanted = static_cast<std::size_t>(kind);
  if (kind != CaseKind::either && &format != &kFormats[wanted]) {
    root.find("format").value_or(root).fail(
        fmt::format("{}; {}", format.what, kFormats[wanted].expected));
  }
  return format;
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

/// The right manifolds and answers are of the pair case that `any` is.
Expectation read_expectation(const JsonView& object, const AnyCase& any) {
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
      expect.manifolds.push_back(read_recorded_answer((*manifolds)[i], std::get<PairCase>(any)));
    }
  }
  return expect;
}

/// Appends "key": "text" behind `separator`, or nothing where the text is empty.
void append_member(std::string& out, std::string_view separator, std::string_view key,
                   std::string_view text) {
  if (text.empty()) return;
  out += fmt::format("{}\"{}\": ", separator, key);
  append_string(out, text);
}

/// Appends "found" behind `separator`.
void append_found(std::string& out, std::string_view separator, const Found& found) {
  out += fmt::format("{}\"found\": {{\"seed\": {}, \"regime\": ", separator, found.seed);
  append_string(out, found.regime);
  out += fmt::format(", \"index\": {}", found.index);
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

void append_expectation(std::string& out, const AnyCase& any, const Expectation& expect) {
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
      append_answer(out, std::get<PairCase>(any), expect.manifolds[i].collider,
                    expect.manifolds[i].answer);
    }
    out += "\n    ]";
  }
  if (out.size() > start) out.erase(start, 1);  // the comma before the first member
  out += "\n  }";
}

}  // namespace

CorpusCase parse_case(std::string_view text, FormatKey format_key, CaseKind kind) {
  if (is_blank(text)) throw UserError("is empty; one case is expected");
  const JsonTree tree = parse_json(text);
  return read_case(JsonView(tree), format_key, kind);
}

CorpusCase read_case(const JsonView& root, FormatKey format_key, CaseKind kind) {
  const CaseFormat& format = format_of(root, kind);
  CorpusCase corpus_case{.any = format.read(root, format_key)};
  if (const auto found = root.find("found")) corpus_case.found = read_found(*found);
  if (const auto expect = root.find("expect")) {
    expect->expect_keys(format.expectation);
    corpus_case.expect = read_expectation(*expect, corpus_case.any);
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
  std::visit([&](const auto& one) { append_case_start(out, one); }, corpus_case.any);
  if (corpus_case.found) append_found(out, ",\n  ", *corpus_case.found);
  if (corpus_case.expect) append_expectation(out, corpus_case.any, *corpus_case.expect);
  if (corpus_case.accepted) out += acceptance_member(*corpus_case.accepted);
  append_member(out, ",\n  ", "property", corpus_case.property);
  append_member(out, ",\n  ", "note", corpus_case.note);
  return out + "\n}\n";
}

void append_case_line(std::string& out, const AnyCase& any) {
  std::visit([&](const auto& one) { append_case_line(out, one); }, any);
}

void append_found_case_line(std::string& out, const AnyCase& any, const Found& found,
                            std::string_view property) {
  append_case_line(out, any);
  out.pop_back();  // the brace that closes it
  append_found(out, ", ", found);
  if (!property.empty()) out += fmt::format(R"(, "property": "{}")", property);
  out += '}';
}

}  // namespace manifuzz
