#include "sequence/sequence_json.hpp"

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/json.hpp"

namespace manifuzz {
namespace {

FramePoses read_frame(const JsonView& object) {
  object.expect_keys({"a", "b"});
  return {read_pose(object.at("a")), read_pose(object.at("b"))};
}

void append_frame(std::string& out, const FramePoses& frame) {
  append_pose(out += "{\"a\": ", frame.a);
  append_pose(out += ", \"b\": ", frame.b);
  out += '}';
}

/// The white space before a member and before a frame; empty: all are on one line.
struct LineBreaks {
  std::string_view member;
  std::string_view frame;
};

/// Appends what stands between two members or frames.
void append_comma(std::string& out, std::string_view line_break) {
  out.append(",").append(line_break.empty() ? " " : line_break);
}

/// Without the closing brace.
void append_sequence(std::string& out, const Sequence& sequence, const LineBreaks& breaks) {
  out.append("{").append(breaks.member).append("\"format\": \"").append(kSequenceFormat) += '"';
  append_comma(out, breaks.member);
  append_polygon(out += "\"a\": ", sequence.a);
  append_comma(out, breaks.member);
  append_polygon(out += "\"b\": ", sequence.b);
  append_comma(out, breaks.member);
  out.append("\"frames\": [").append(breaks.frame);
  for (const FramePoses& frame : sequence.frames) {
    if (&frame != &sequence.frames.front()) append_comma(out, breaks.frame);
    append_frame(out, frame);
  }
  out.append(breaks.member) += ']';
}

}  // namespace

bool is_sequence(const JsonView& object) {
  if (!object.is_object()) return false;
  const auto format = object.find("format");
  if (!format || !format->is_string()) return object.find("frames").has_value();
  return format->string().starts_with(kSequenceFormat.substr(0, kSequenceFormat.rfind('/') + 1));
}

Sequence read_sequence(const JsonView& object) {
  const auto format = object.find("format");
  if (format && format->string() != kSequenceFormat) {
    format->fail(fmt::format("unknown format \"{}\"; \"{}\" is expected",
                             printable(format->string()), kSequenceFormat));
  }
  Sequence sequence{read_polygon(object.at("a")), read_polygon(object.at("b")), {}};
  const JsonView frames = object.at("frames");
  const std::size_t count = frames.length("an array of frames");
  if (count == 0 || count > kFramesMax) {
    frames.fail(fmt::format("has {} frames; 1 to {} are expected", count, kFramesMax));
  }
  sequence.frames.reserve(count);
  for (const JsonView& frame : frames.elements()) sequence.frames.push_back(read_frame(frame));
  return sequence;
}

void append_case_line(std::string& out, const Sequence& sequence) {
  append_sequence(out, sequence, {});
  out += '}';
}

void append_case_start(std::string& out, const Sequence& sequence) {
  append_sequence(out, sequence, {"\n  ", "\n    "});
}

}  // namespace manifuzz
