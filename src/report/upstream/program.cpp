#include "report/upstream/program.hpp"

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.hpp"
#include "collider/snippet.hpp"
#include "judging/faults/rounded_sum.hpp"
#include "report/rows.hpp"

namespace manifuzz {
namespace {

using namespace std::string_view_literals;

using Place = Vector2<double>;

template <class Number>
std::string number_text(Number value) {
  return digits(value + Number{0});  // no negative zeros
}

/// Two numbers of an engine in double, which may be no floats any more.
struct Figures {
  std::vector<Place> wide;
  bool is_list = true;  ///< else one alone
};

/// In doubles, the length that a stored rotation has.
double length_of(const Place& rotation) {
  return std::sqrt(rotation.x() * rotation.x() + rotation.y() * rotation.y());
}

std::vector<Place> wide(std::span<const Vector2<float>> floats) {
  std::vector<Place> all;
  for (const Vector2<float>& v : floats) all.push_back(v.cast<double>());
  return all;
}

/// Outward, of each face, as doubles have it.
std::vector<Place> unit_normals(const std::vector<Place>& vertices) {
  std::vector<Place> normals;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Place along = vertices[(i + 1) % vertices.size()] - vertices[i];
    const double length = length_of(along);
    normals.emplace_back(along.y() / length, -along.x() / length);
  }
  return normals;
}

/// The centroid of a polygon's area, as seen from its first corner.
Place centroid_of(const std::vector<Place>& vertices) {
  const Place& corner = vertices.front();
  Place sum(0, 0);
  double area = 0;
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i) {
    const Place p = vertices[i] - corner;
    const Place q = vertices[i + 1] - corner;
    const double part = cross(p, q);
    sum += part * (p + q);
    area += part;
  }
  return corner + sum / (3 * area);
}

/// What a template may ask for of a body.
Figures figures_of(std::string_view key, const Body& body) {
  const auto count = static_cast<std::size_t>(body.polygon.count);
  const std::vector<Place> vertices = wide(body.polygon.corners());
  const Place at = body.pose.position.cast<double>();
  const Place turn = body.pose.rotation.cast<double>();
  if (key == "vertices") return {vertices};
  if (key == "normals") return {wide(std::span(body.polygon.normals).first(count))};
  if (key == "position") return {{at}, false};
  if (key == "rotation") return {{turn}, false};
  if (key == "unit_normals") return {unit_normals(vertices)};
  const double length = length_of(turn);
  if (key == "unit_rotation") return {{{turn.x() / length, turn.y() / length}}, false};
  if (key == "centroid") return {{Place(length * centroid_of(vertices))}, false};
  std::vector<Place> moved;
  for (const Place& v : vertices) {
    if (key == "unit_vertices") {
      moved.emplace_back(length * v.x(), length * v.y());
    } else {  // world
      moved.emplace_back(ledger_of::sum_rounded_once(turn.x() * v.x(), -turn.y() * v.y(), at.x()),
                         ledger_of::sum_rounded_once(turn.y() * v.x(), turn.x() * v.y(), at.y()));
    }
  }
  return {moved};
}

/// `$x` the shortest decimal of a float, `$X` of a double.
std::string in_form(std::string form, const Place& place) {
  boost::replace_all(form, "$x", number_text(static_cast<float>(place.x())));
  boost::replace_all(form, "$y", number_text(static_cast<float>(place.y())));
  boost::replace_all(form, "$X", number_text(place.x()));
  boost::replace_all(form, "$Y", number_text(place.y()));
  return form;
}

std::string list_in_form(const std::string& form, const Figures& figures) {
  std::vector<std::string> parts;
  for (const Place& place : figures.wide) parts.push_back(in_form(form, place));
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string bracketed(std::string_view brackets, const Figures& figures) {
  const std::string form = fmt::format("{}$x, $y{}", brackets.front(), brackets.back());
  const std::string list = list_in_form(form, figures);
  return figures.is_list ? fmt::format("{}{}{}", brackets.front(), list, brackets.back()) : list;
}

void fill_in_forms(std::string& line, const std::string& start, const Figures& figures) {
  for (std::size_t at = line.find(start); at != std::string::npos; at = line.find(start, at)) {
    const std::size_t end = line.find(")@", at);
    if (end == std::string::npos) return;
    const std::string form = line.substr(at + start.size(), end - at - start.size());
    line.replace(at, end + 2 - at, list_in_form(form, figures));
  }
}

/// How far a shape reaches from its origin, as floats or doubles have it.
template <class Number>
Number reach_of(const ConvexPolygon<float>& shape) {
  Number farthest = 0;
  for (const Vector2<float>& v : shape.corners()) {
    farthest = std::max(farthest, std::hypot(Number{v.x()}, Number{v.y()}));
  }
  return farthest + Number{shape.radius};
}

void fill_in(std::string& line, char name, const Body& body) {
  for (const std::string_view key : kSnippetKeys) {
    const std::string start = fmt::format("@{}.{}", name, key);
    if (line.find(start) == std::string::npos) continue;
    if (key == "radius") {
      boost::replace_all(line, start + "@", number_text(body.polygon.radius));
    } else if (key == "wide_radius") {
      boost::replace_all(line, start + "@", number_text(static_cast<double>(body.polygon.radius)));
    } else if (key == "reach") {
      boost::replace_all(line, start + "@", number_text(reach_of<float>(body.polygon)));
    } else if (key == "wide_reach") {
      boost::replace_all(line, start + "@", number_text(reach_of<double>(body.polygon)));
    } else if (key == "count") {
      boost::replace_all(line, start + "@", std::to_string(body.polygon.count));
    } else {
      const Figures figures = figures_of(key, body);
      for (const std::string_view brackets : {"[]", "{}"}) {
        boost::replace_all(line, fmt::format("{}{}@", start, brackets),
                           bracketed(brackets, figures));
      }
      fill_in_forms(line, start + '(', figures);
    }
  }
}

bool holds(std::string_view condition, const Body& body) {
  const int count = body.polygon.count;
  const bool is_moved = body.pose.position != Vector2<float>(0, 0);
  const bool is_turned = body.pose.rotation != Vector2<float>(1, 0);
  if (condition == "circle") return count == 1;
  if (condition == "segment") return count == 2;
  if (condition == "polygon") return count >= kMinVertices;
  if (condition == "rounded") return body.polygon.radius > 0;
  if (condition == "moved") return is_moved;
  if (condition == "turned") return is_turned;
  return is_moved || is_turned;  // placed
}

/// Takes the conditions off a line's beginning; false where one of them does not hold.
bool take_conditions(std::string& line, const PairCase& pair) {
  const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
  bool stands = true;
  while (line.compare(start, 1, "@") == 0) {
    const bool is_not = line.compare(start + 1, 1, "!") == 0;
    const std::size_t name = start + (is_not ? 2 : 1);
    const std::size_t end = line.find("? ", name);
    if (end == std::string::npos || end < name + 2 || line[name + 1] != '.') return stands;
    const std::string condition = line.substr(name + 2, end - name - 2);
    if (std::ranges::find(kSnippetConditions, condition) == kSnippetConditions.end()) return stands;
    stands = stands && holds(condition, line[name] == 'a' ? pair.a : pair.b) != is_not;
    line.erase(start, end + 2 - start);
  }
  return stands;
}

/// Whether the line is no part of the program, but says something of it.
bool take_directive(const std::string& line, Program& program) {
  const std::size_t start = std::min(line.find_first_not_of(" \t"), line.size());
  const auto said = [&](std::string_view word) -> std::optional<std::string> {
    if (line.compare(start, word.size(), word) != 0) return std::nullopt;
    return line.substr(start + word.size());
  };
  if (const auto language = said("@language ")) return program.language = *language, true;
  if (const auto point = said("@point ")) return program.point = *point, true;
  if (const auto none = said("@none ")) return program.none = *none, true;
  if (const auto figures = said("@figures ")) return program.figures = *figures, true;
  if (said("@no_normal")) return program.has_normal = false, true;
  return said("@b_first") && (program.is_b_first = true);
}

/// `@asked(NAME)@` is the name of the function that is asked, at its call.
void take_function(std::string& line, Program& program) {
  constexpr std::string_view start = "@asked(";
  const std::size_t at = line.find(start);
  if (at == std::string::npos) return;
  const std::size_t end = line.find(")@", at);
  if (end == std::string::npos) return;
  program.function = line.substr(at + start.size(), end - at - start.size());
  line.replace(at, end + 2 - at, program.function);
}

/// `@*` becomes the name, but before what is asked of the body or decides over a line.
std::string for_one(std::string block, std::string_view name, std::string_view capital) {
  const auto keep = [&](std::string_view word, std::string_view end) {
    boost::replace_all(block, fmt::format("@*.{}{}", word, end),
                       fmt::format("@{}.{}{}", name, word, end));
    boost::replace_all(block, fmt::format("@!*.{}{}", word, end),
                       fmt::format("@!{}.{}{}", name, word, end));
  };
  for (const std::string_view word : kSnippetConditions) keep(word, "? ");
  for (const std::string_view word : kSnippetKeys) {
    for (const std::string_view end : {"@", "[", "{", "("}) keep(word, end);
  }
  boost::replace_all(block, "@*", name);
  boost::replace_all(block, "@^", capital);
  return block;
}

/// Blocks of lines that begin with `@each ` stand twice: `@*` is a, then b, `@^` A, then B.
std::string with_each_twice(const std::string& snippet) {
  constexpr std::string_view each = "@each ";
  std::string text;
  std::string block;
  const auto end_block = [&] {
    for (const std::array<std::string_view, 2> names : {std::array{"a"sv, "A"sv}, {"b"sv, "B"sv}}) {
      text += for_one(block, names[0], names[1]);
    }
    block.clear();
  };
  for (std::size_t start = 0; start < snippet.size();) {
    const std::size_t end = std::min(snippet.find('\n', start), snippet.size() - 1) + 1;
    const std::string line = snippet.substr(start, end - start);
    start = end;
    if (line.starts_with(each)) {
      block += line.substr(each.size());
    } else {
      end_block();
      text += line;
    }
  }
  end_block();
  return text;
}

}  // namespace

Program program_for(const std::string& given, const PairCase& pair) {
  const std::string snippet = with_each_twice(given);
  Program program;
  std::size_t start = 0;
  while (start < snippet.size()) {
    const std::size_t end = std::min(snippet.find('\n', start), snippet.size());
    std::string line = snippet.substr(start, end - start);
    start = end + 1;
    if (!take_conditions(line, pair) || take_directive(line, program)) continue;
    take_function(line, program);
    fill_in(line, 'a', pair.a);
    fill_in(line, 'b', pair.b);
    program.text += line;
    if (end < snippet.size()) program.text += '\n';
  }
  return program;
}

std::string filled_in(const std::string& snippet, const PairCase& pair) {
  return program_for(snippet, pair).text;
}

}  // namespace manifuzz
