#include "report/upstream.hpp"

#include <fmt/format.h>

#include "base/text.hpp"
#include "base/user_error.hpp"
#include "exchange/json.hpp"
#include "report/words.hpp"

namespace manifuzz {
namespace {

struct Brackets {
  char open;
  char close;
};

std::string text_of(const Vector2<float>& v, Brackets brackets) {
  std::string text(1, brackets.open);
  append_number(text, v.x());
  text += ", ";
  append_number(text, v.y());
  return text + brackets.close;
}

std::string text_of(std::span<const Vector2<float>> list, Brackets brackets) {
  std::string text(1, brackets.open);
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0) text += ", ";
    text += text_of(list[i], brackets);
  }
  return text + brackets.close;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    text.replace(at, from.size(), to);
    at += to.size();
  }
}

void fill_in(std::string& text, const std::string& name, const Body& body) {
  const auto count = static_cast<std::size_t>(body.polygon.count);
  for (const Brackets brackets : {Brackets{'[', ']'}, Brackets{'{', '}'}}) {
    const auto replace = [&](std::string_view key, const std::string& value) {
      replace_all(text, fmt::format("@{}.{}{}{}@", name, key, brackets.open, brackets.close),
                  value);
    };
    replace("vertices", text_of(std::span(body.polygon.vertices.data(), count), brackets));
    replace("normals", text_of(std::span(body.polygon.normals.data(), count), brackets));
    replace("position", text_of(body.pose.position, brackets));
    replace("rotation", text_of(body.pose.rotation, brackets));
  }
  std::string radius;
  append_number(radius, body.polygon.radius);
  replace_all(text, fmt::format("@{}.radius@", name), radius);
  replace_all(text, fmt::format("@{}.count@", name), std::to_string(body.polygon.count));
}

void append_manifold(std::string& out, const PairCase& pair, const Manifold<double>& manifold) {
  if (manifold.count == 0) {
    out += "no contact\n";
    return;
  }
  const Vector2<double> normal = world_normal(pair, manifold.normal);
  out += fmt::format("normal ({}, {}), from A to B, a face of {}\n", normal.x() + 0.0,
                     normal.y() + 0.0, manifold.reference == Side::a ? 'A' : 'B');
  for (int i = 0; i < manifold.count; ++i) {
    const Vector2<double> at = to_world(pair, manifold.points[i].position);
    out += fmt::format("point ({}, {}), depth {}\n", at.x() + 0.0, at.y() + 0.0,
                       manifold.points[i].depth + 0.0);
  }
}

void append_body(std::string& out, char name, const Body& body) {
  const auto count = static_cast<std::size_t>(body.polygon.count);
  constexpr Brackets round{'(', ')'};
  out += fmt::format("{}: vertices {}, radius {}, position {}, (cos, sin) {}\n", name,
                     text_of(std::span(body.polygon.vertices.data(), count), round),
                     body.polygon.radius, text_of(body.pose.position, round),
                     text_of(body.pose.rotation, round));
}

const DeclaredAnswer& answer_at_fault(const JudgedCase& shown) {
  switch (shown.judgement.bucket.fault) {
    case Fault::none:
      throw UserError("--upstream: nobody is at fault in this case; there is nothing to report");
    case Fault::oracle:
      return shown.oracle;
    default:
      return shown.subject;
  }
}

/// What a fence of code says it holds, where that can be told.
std::string_view language_of(const std::string& snippet) {
  if (snippet.find("#include") != std::string::npos) return "cpp";
  const bool is_script =
      snippet.starts_with("import {") || snippet.find("require(") != std::string::npos;
  return is_script ? "js" : "";
}

/// Code between fences that are longer than any of its own.
std::string fenced(std::string_view language, std::string code) {
  std::string fence = "```";
  while (code.find(fence) != std::string::npos) fence += '`';
  if (!code.ends_with('\n')) code += '\n';
  return fmt::format("{}{}\n{}{}\n", fence, language, code, fence);
}

}  // namespace

std::string filled_in(std::string snippet, const PairCase& pair) {
  fill_in(snippet, "a", pair.a);
  fill_in(snippet, "b", pair.b);
  return snippet;
}

std::string upstream_report(const JudgedCase& shown, const std::string& parties) {
  const DeclaredAnswer& asked = answer_at_fault(shown);
  const PairCase& pair = shown.given.pair;
  std::string text = fmt::format("# {} {}: {}\n\n", asked.declaration.name,
                                 asked.declaration.version, verdict_sentence(shown));
  text += "Two convex polygons, numbers as 32-bit floats:\n\n```\n";
  append_body(text, 'A', pair.a);
  append_body(text, 'B', pair.b);
  text += "```\n\n## Got\n\n```\n";
  if (asked.manifold() == nullptr) {
    text += answer_in_words(asked) + '\n';
  } else {
    append_manifold(text, pair, *asked.manifold());
  }
  text += "```\n\n## Expected, in exact arithmetic\n\n";
  const auto rights = right_manifolds(admissible(pair, asked.declaration));
  if (rights.size() > 1) text += "Any of these:\n\n";
  text += "```\n";
  for (std::size_t i = 0; i < rights.size(); ++i) {
    if (i > 0) text += "\n";
    append_manifold(text, pair, rights[i]);
  }
  text += "```\n";
  if (shown.judgement.explanation != nullptr) {
    text += fmt::format("\n## Cause\n\n{}: {}.\n", shown.judgement.explanation->source,
                        shown.judgement.explanation->description);
  }
  const std::string& snippet = asked.declaration.snippet;
  text += "\n## A program that shows it\n\n";
  if (!snippet.empty()) {
    return text + fenced(language_of(snippet), filled_in(snippet, pair));
  }
  std::string line;
  append_case_line(line, pair);
  return text + fenced("sh", fmt::format("manifuzz judge {} <<'END'\n{}\nEND\n", parties, line));
}

}  // namespace manifuzz
