#include <boost/algorithm/string/replace.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "exchange/json.hpp"
#include "report/round_truth.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

/// `brackets`: the opening and the closing one.
std::string text_of(const Vector2<float>& v, std::string_view brackets) {
  std::string text(1, brackets.front());
  append_number(text, v.x());
  text += ", ";
  append_number(text, v.y());
  return text + brackets.back();
}

std::string text_of(std::span<const Vector2<float>> list, std::string_view brackets) {
  std::vector<std::string> parts;
  for (const Vector2<float>& v : list) parts.push_back(text_of(v, brackets));
  return fmt::format("{}{}{}", brackets.front(), fmt::join(parts, ", "), brackets.back());
}

void fill_in(std::string& text, const std::string& name, const Body& body) {
  const auto count = static_cast<std::size_t>(body.polygon.count);
  for (const std::string_view brackets : {"[]", "{}"}) {
    const auto replace = [&](std::string_view key, const std::string& value) {
      boost::replace_all(text, fmt::format("@{}.{}{}@", name, key, brackets), value);
    };
    replace("vertices", text_of(body.polygon.corners(), brackets));
    replace("normals", text_of(std::span(body.polygon.normals).first(count), brackets));
    replace("position", text_of(body.pose.position, brackets));
    replace("rotation", text_of(body.pose.rotation, brackets));
  }
  std::string radius;
  append_number(radius, body.polygon.radius);
  boost::replace_all(text, fmt::format("@{}.radius@", name), radius);
  boost::replace_all(text, fmt::format("@{}.count@", name), std::to_string(body.polygon.count));
}

std::string manifold_in_words(const PairCase& pair, const Manifold<double>& manifold) {
  if (manifold.count == 0) return "no contact\n";
  const Vector2<double> normal = without_negative_zeros(world_normal(pair, manifold.normal));
  std::string text = fmt::format("normal ({}, {}), from A to B", normal.x(), normal.y());
  // A round shape's may be from vertex to vertex.
  if (!is_round(pair)) {
    text += fmt::format(", a face of {}", manifold.reference == Side::a ? 'A' : 'B');
  }
  text += '\n';
  for (int i = 0; i < manifold.count; ++i) {
    const Vector2<double> at = without_negative_zeros(to_world(pair, manifold.points[i].position));
    text +=
        fmt::format("point ({}, {}), depth {}\n", at.x(), at.y(), manifold.points[i].depth + 0.0);
  }
  return text;
}

void append_body(std::string& out, char name, const Body& body) {
  constexpr std::string_view round = "()";
  const bool has_round_corners = body.polygon.count >= kMinVertices && body.polygon.is_round();
  out += fmt::format("{}: vertices {}, radius {}{}, position {}, (cos, sin) {}\n", name,
                     text_of(body.polygon.corners(), round), body.polygon.radius,
                     has_round_corners ? " with round corners" : "",
                     text_of(body.pose.position, round), text_of(body.pose.rotation, round));
}

const DeclaredAnswer& answer_at_fault(const JudgedCase& judged) {
  const Fault fault = judged.judgement.bucket.fault;
  if (fault == Fault::none) {
    throw UserError("--upstream: nobody is at fault in this case; there is nothing to report");
  }
  return fault == Fault::oracle ? judged.oracle : judged.subject;
}

/// What a fence of code says it holds, where that can be told.
std::string_view language_of(const std::string& snippet) {
  if (snippet.find("#include") != std::string::npos) return "cpp";
  const bool is_script = snippet.starts_with("import {") || snippet.starts_with("import * as ") ||
                         snippet.find("require(") != std::string::npos;
  return is_script ? "js" : "";
}

}  // namespace

std::string filled_in(std::string snippet, const PairCase& pair) {
  fill_in(snippet, "a", pair.a);
  fill_in(snippet, "b", pair.b);
  return snippet;
}

std::string upstream_report(const JudgedCase& judged, const std::string& options) {
  const DeclaredAnswer& asked = answer_at_fault(judged);
  const PairCase& pair = judged.given.pair;
  std::string text = fmt::format("# {} {}: {}\n\n", asked.declaration.name,
                                 asked.declaration.version, verdict_sentence(judged));
  std::string bodies;
  append_body(bodies, 'A', pair.a);
  append_body(bodies, 'B', pair.b);
  text += is_round(pair) ? "Two shapes, numbers as 32-bit floats; one vertex is a circle's center, "
                           "two are the ends of a segment or capsule:\n\n"
                         : "Two convex polygons, numbers as 32-bit floats:\n\n";
  text += code_block(bodies, "");
  std::string got = answer_in_words(asked) + '\n';
  if (asked.manifold() != nullptr) got = manifold_in_words(pair, *asked.manifold());
  text += "\n## Got\n\n" + code_block(got, "") + "\n## Expected, in exact arithmetic\n\n";
  std::vector<std::string> expected;
  for (const Manifold<double>& right :
       manifolds_to_show(admissible(pair, asked.declaration), asked.declaration)) {
    expected.push_back(manifold_in_words(pair, right));
  }
  if (expected.size() > 1) text += "Any of these:\n\n";
  text += code_block(fmt::format("{}", fmt::join(expected, "\n")), "");
  if (judged.judgement.explanation != nullptr) {
    text += fmt::format("\n## Cause\n\n{}: {}.\n", judged.judgement.explanation->source,
                        judged.judgement.explanation->description);
  }
  text += "\n## A program that shows it\n\n";
  const std::string& snippet = asked.declaration.snippet;
  if (!snippet.empty()) return text + code_block(filled_in(snippet, pair), language_of(snippet));
  std::string line;
  append_case_line(line, pair);
  return text +
         code_block(fmt::format("manifuzz judge {} <<'END'\n{}\nEND\n", options, line), "sh");
}

}  // namespace manifuzz
