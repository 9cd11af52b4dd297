#include "support/bad_cases.hpp"

#include <array>

namespace manifuzz::test {
namespace {

using Rows = std::vector<BadCase>;

// Functions, since tables are built before main.
std::string square() {
  return "[[-1,-1],[1,-1],[1,1],[-1,1]]";
}
std::string body_b() {
  return R"({"vertices": [[0,0],[2,0],[1,2]], "position": [0.5,0.75]})";
}

std::string with_bodies(const std::string& a, const std::string& b, const std::string& more = "") {
  return R"({"format": "manifuzz/case/1", "a": )" + a + R"(, "b": )" + b + more + "}";
}

std::string with_a(const std::string& body) {
  return with_bodies(body, body_b());
}

std::string with_vertices(const std::string& vertices) {
  return with_a(R"({"vertices": )" + vertices + "}");
}

/// A square and one more member, such as `"radius": -1`.
std::string with_member(const std::string& member) {
  return with_a(R"({"vertices": )" + square() + ", " + member + "}");
}

/// A good pair and one more member of the case, such as `"note": 1`.
std::string with_more(const std::string& member) {
  return with_bodies(R"({"vertices": )" + square() + "}", body_b(), ", " + member);
}

std::string repeat(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

/// `"k0": 0, "k1": 1, ...`
std::string numbered_keys(int count) {
  std::string out;
  for (int i = 0; i < count; ++i) {
    const std::string number = std::to_string(i);
    out.append(i > 0 ? ", " : "").append("\"k").append(number).append("\": ").append(number);
  }
  return out;
}

Rows text_rows() {
  const std::string good = good_case();
  return {
      {"truncated in a string", good.substr(0, 40), "missing closing quote"},
      {"truncated in an array", good.substr(0, good.find("[1,1]") + 3), "unexpected end of input"},
      {"truncated before the last brace", good.substr(0, good.size() - 1),
       "unexpected end of input"},
      {"garbage behind the case", good + " x", "not JSON"},
      {"two cases on a line", good + " " + good, "expected end of input"},
      {"trailing comma", with_vertices("[[0,0],[1,0],[0,1],]"), "unexpected ']'"},
      {"comment", good + " // why", "not JSON"},
      {"single quotes", "{'format': 'manifuzz/case/1'}", "not JSON"},
      {"missing colon", R"({"format" "manifuzz/case/1"})", "expected ':'"},
      {"NUL byte behind the case", good + std::string(1, '\0') + "{", "a NUL byte"},
      {"binary",
       std::string("\x7f"
                   "ELF\x02\x01\x01\xff\xfe\xc3\x28\x1b[31m",
                   16),
       "UTF-8 text"},
      {"UTF-16", std::string("\xff\xfe{\0}\0", 6), "a NUL byte"},
      {"invalid UTF-8 in a string", with_more("\"note\": \"\xc3\x28\""), "ill-formed UTF-8"},
      {"invalid UTF-8 in a key", with_more("\"\xff\": 1"), "ill-formed UTF-8"},
      {"control character in a string", with_more("\"note\": \"\x1b[31m\""), "control character"},
      {"lone surrogate", with_more(R"("note": "\ud800")"), "surrogate"},
      {"100000 open brackets", repeat("[", 100000), "nested deeper than 32"},
      {"deep objects in a note", with_more(R"("note": )" + repeat(R"({"x": )", 5000)),
       "nested deeper than 32"},
      {"an array", "[" + good + "]", "$: is an array; an object is expected"},
      {"a string", R"("manifuzz/case/1")", "$: is a string; an object"},
      {"a number", "17", "$: is a number; an object"},
      {"null", "null", "$: is null; an object"},
      {"an empty object", "{}", "missing"},
  };
}

Rows size_rows() {
  return {
      {"two megabytes of note", with_more("\"note\": \"" + std::string(2 << 20, 'x') + "\""),
       "1 MiB"},
      {"two megabytes of blanks", std::string(2 << 20, ' '), "1 MiB"},
  };
}

Rows number_rows() {
  return {
      {"NaN", with_vertices("[[NaN,0],[1,0],[0,1]]"), "numbers must be finite"},
      {"nan", with_vertices("[[nan,0],[1,0],[0,1]]"), "numbers must be finite"},
      {"Infinity", with_vertices("[[0,0],[Infinity,0],[0,1]]"), "numbers must be finite"},
      {"minus Infinity", with_member(R"("position": [-Infinity,0])"), "numbers must be finite"},
      {"1e999 as a coordinate", with_vertices("[[0,0],[1,0],[0,1e999]]"),
       "$.a.vertices[2][1]: 1e999"},
      {"1e999 as a radius", with_member(R"("radius": 1e999)"), "$.a.radius: 1e999"},
      {"1e39 as a coordinate", with_vertices("[[0,0],[1e39,0],[0,1]]"),
       "$.a.vertices[1][0]: 1e+39"},
      {"1e39 as a radius", with_member(R"("radius": 1e39)"), "beyond the largest float"},
      {"1e39 as a position", with_member(R"("position": [0,-1e39])"), "$.a.position[1]: -1e+39"},
      {"1e39 as a rotation", with_member(R"("rotation": [1e39,0])"), "$.a.rotation[0]"},
      {"half beyond the largest float", with_member(R"("position": [3.4028235677973366e38,0])"),
       "beyond the largest float"},
      {"leading zero", with_vertices("[[00,0],[1,0],[0,1]]"), "not JSON"},
      {"plus sign", with_vertices("[[+1,0],[1,0],[0,1]]"), "not JSON"},
      {"hexadecimal", with_vertices("[[0x1,0],[1,0],[0,1]]"), "not JSON"},
  };
}

Rows polygon_rows() {
  const std::string nine = "[[4,0],[3,3],[0,4],[-3,3],[-4,0],[-3,-3],[0,-4],[3,-3],[3.9,-1]]";
  return {
      {"0 vertices", with_vertices("[]"), "$.a.vertices: too few vertices"},
      {"2 vertices in format 1", with_vertices("[[0,0],[1,0]]"),
       "$.format: \"manifuzz/case/1\" has no round shapes"},
      {"9 vertices", with_vertices(nine), "$.a.vertices: too many vertices"},
      {"clockwise", with_vertices("[[0,0],[0,1],[1,0]]"), "clockwise"},
      {"repeated vertex", with_vertices("[[0,0],[1,0],[1,0],[0,1]]"), "repeated"},
      {"repeated vertex of opposite zeros", with_vertices("[[0,0],[1,0],[0,1],[-0.0,0]]"),
       "repeated"},
      {"repeated as floats", with_vertices("[[0,0],[1,0],[1.00000001,0],[0,1]]"), "repeated"},
      {"collinear", with_vertices("[[0,0],[1,0],[2,0]]"), "not strictly convex"},
      {"collinear corner", with_vertices("[[0,0],[1,0],[2,0],[0,2]]"), "not strictly convex"},
      {"collinear as floats", with_vertices("[[0,0],[1,1],[2,2.00000001],[0,2]]"),
       "not strictly convex as floats"},
      {"reflex corner", with_vertices("[[0,0],[4,0],[1,1],[0,4]]"), "not strictly convex"},
      {"crossing", with_vertices("[[0,0],[1,1],[1,0],[0,1]]"), "not strictly convex"},
      {"winds twice", with_vertices("[[0,10],[-6,-8],[9.5,3],[-9.5,3],[6,-8]]"), "more than once"},
      {"all at one point", with_vertices("[[1,1],[1,1],[1,1]]"), "repeated"},
      {"underflow to one point", with_vertices("[[0,0],[1e-60,0],[0,1]]"), "repeated"},
      {"bad polygon b",
       with_bodies(R"({"vertices": )" + square() + "}", R"({"vertices": [[0,0]]})"),
       "$.b.vertices: one vertex without a radius"},
      {"segment of one point", with_vertices("[[1,1],[1,1]]"), "repeated"},
      {"mitred capsule", with_a(R"({"vertices": [[0,0],[1,0]], "rounding": "mitre"})"),
       "$.a.rounding: only polygons of 3 to 8 vertices may be"},
      {"unknown rounding", with_member(R"("rounding": "bevel")"), "unknown rounding \"bevel\""},
      {"rounding a number", with_member(R"("rounding": 1)"), "$.a.rounding: is a number"},
      {"negative radius", with_member(R"("radius": -0.5)"), "$.a.radius: -0.5 is negative"},
      {"rotation not unit", with_member(R"("rotation": [1,1])"), "$.a.rotation: [1, 1]"},
      {"rotation a little off", with_member(R"("rotation": [1.00001,0])"), "not a rotation"},
      {"rotation zero", with_member(R"("rotation": [0,0])"), "not a rotation"},
      {"rotation of three numbers", with_member(R"("rotation": [1,0,0])"), "3 elements"},
      {"rotation of one number", with_member(R"("rotation": [1])"), "1 elements"},
      {"rotation as an angle", with_member(R"("rotation": 0.5)"), "$.a.rotation: is a number"},
      {"position of three numbers", with_member(R"("position": [1,0,0])"), "3 elements"},
  };
}

Rows type_rows() {
  return {
      {"vertices null", with_vertices("null"), "$.a.vertices: is null"},
      {"vertices a number", with_vertices("3"), "$.a.vertices: is a number"},
      {"vertices a string", with_vertices("\"square\""), "$.a.vertices: is a string"},
      {"vertices an object", with_vertices("{}"), "$.a.vertices: is an object"},
      {"vertex a number", with_vertices("[0,0,1,0,0,1]"), "$.a.vertices[0]: is a number"},
      {"vertex an object", with_vertices(R"([[0,0],{"x":1,"y":0},[0,1]])"),
       "$.a.vertices[1]: is an"},
      {"vertex of one number", with_vertices("[[0,0],[1],[0,1]]"),
       "$.a.vertices[1]: has 1 elements"},
      {"vertex of three numbers", with_vertices("[[0,0],[1,0,0],[0,1]]"), "has 3 elements"},
      {"coordinate a string", with_vertices(R"([[0,0],["1",0],[0,1]])"),
       "$.a.vertices[1][0]: is a str"},
      {"coordinate null", with_vertices("[[0,0],[1,null],[0,1]]"), "$.a.vertices[1][1]: is null"},
      {"coordinate a boolean", with_vertices("[[0,0],[true,0],[0,1]]"), "is a boolean"},
      {"coordinate an array", with_vertices("[[0,0],[[1],0],[0,1]]"), "is an array"},
      {"radius a string", with_member(R"("radius": "0")"), "$.a.radius: is a string"},
      {"radius null", with_member(R"("radius": null)"), "$.a.radius: is null"},
      {"position a number", with_member(R"("position": 0)"), "$.a.position: is a number"},
      {"position of strings", with_member(R"("position": ["0","0"])"),
       "$.a.position[0]: is a string"},
      {"a null", with_a("null"), "$.a: is null; an object is expected"},
      {"a an array", with_a(square()), "$.a: is an array; an object is expected"},
      {"format a number", R"({"format": 1, "a": {}, "b": {}})", "$.format: is a number"},
      {"note a number", with_more(R"("note": 1)"), "$.note: is a number"},
      {"property an array", with_more(R"("property": [])"), "$.property: is an array"},
      {"found a string", with_more(R"("found": "today")"), "$.found: is a string"},
      {"expect an array", with_more(R"("expect": [])"), "$.expect: is an array"},
  };
}

Rows key_rows() {
  const std::string body = R"({"vertices": )" + square() + "}";
  return {
      {"wrong format", R"({"format": "manifuzz/case/3", "a": {}, "b": {}})", "unknown format"},
      {"missing a", R"({"format": "manifuzz/case/1", "b": )" + body_b() + "}",
       "key \"a\" is missing"},
      {"missing b", R"({"format": "manifuzz/case/1", "a": )" + body + "}", "key \"b\" is missing"},
      {"missing vertices", with_a(R"({"radius": 0})"), "$.a: the key \"vertices\" is missing"},
      {"unknown key", with_more(R"("c": 1)"), "$: unknown key \"c\"; the keys are format, a, b"},
      {"unknown key of a body", with_member(R"("raduis": 0)"),
       "$.a: unknown key \"raduis\"; did you mean \"radius\"? The keys are vertices, radius,"},
      {"unknown key with odd bytes", with_more("\"\\u001b[31m\\u00e9\": 1"), "\\x1b[31m\\xc3\\xa9"},
      {"unknown key of 100 kB", with_more("\"" + std::string(100000, 'k') + "\": 1"), "kkk..."},
      {"empty key", with_more(R"("": 1)"), "unknown key \"\""},
      {"a hundred keys", with_more(R"("found": {)" + numbered_keys(100) + "}"),
       "$.found: has more than 64 keys"},
      {"repeated key", with_more(R"("a": )" + body), "$: the key \"a\" is repeated"},
      {"repeated key of a body", with_member(R"("radius": 0, "radius": 0)"),
       "$.a: the key \"radius\" is repeated"},
      {"repeated key in an ignored place", with_more(R"("found": [{"x": 1, "x": 2}])"),
       "$.found[0]: the key \"x\" is repeated"},
  };
}

Rows record_rows() {
  const auto found = [](const std::string& members) {
    return with_more(R"("found": {)" + members + "}");
  };
  const auto expect = [](const std::string& member) {
    return with_more(R"("expect": {)" + member + "}");
  };
  const auto manifold = [&expect](const std::string& members) {
    return expect(R"("manifolds": [{"collider": "clip", )" + members + "}]");
  };
  const auto point = [&manifold](const std::string& members) {
    return manifold(R"("normal": [1,0], "reference": "a", "points": [{)" + members + "}]");
  };
  const std::string place = R"("position": [0,0], "local": [0,0])";
  return {
      {"found without a seed", found(R"("regime": "generic", "index": 1)"), "\"seed\" is missing"},
      {"negative seed", found(R"("seed": -1, "regime": "generic", "index": 1)"),
       "$.found.seed: -1"},
      {"fractional seed", found(R"("seed": 0.5, "regime": "generic", "index": 1)"), "$.found.seed"},
      {"seed of 2^64", found(R"("seed": 18446744073709551616, "regime": "x", "index": 1)"),
       "18446744073709551615"},
      {"seed a string", found(R"("seed": "1", "regime": "generic", "index": 1)"), "is a string"},
      {"unknown key of found", found(R"("sede": 1)"), "$.found: unknown key \"sede\""},
      {"version a number",
       found(R"("seed": 1, "regime": "x", "index": 1, "versions": {"clip": 1})"),
       "$.found.versions.clip: is a number"},
      {"unknown key of expect", expect(R"("verdikt": "agree")"), "$.expect: unknown key"},
      {"verdict a number", expect(R"("verdict": 1)"), "$.expect.verdict: is a number"},
      {"severity a string", expect(R"("severity": "high")"), "$.expect.severity: is a string"},
      {"severity above 1", expect(R"("severity": 1.001)"),
       "$.expect.severity: 1.001 is not a share"},
      {"negative severity", expect(R"("severity": -0.5)"), "a number from 0 to 1 is expected"},
      {"manifolds an object", expect(R"("manifolds": {})"), "$.expect.manifolds: is an object"},
      {"manifold without points", manifold(R"("normal": [1,0])"), "\"points\" is missing"},
      {"unknown key of a manifold", manifold(R"("points": [], "time": 1)"), "unknown key \"time\""},
      {"manifold without a normal", manifold(R"("reference": "a", "points": [{)" + place + "}]"),
       "\"normal\" is missing"},
      {"reference c", manifold(R"("normal": [1,0], "reference": "c", "points": [{}])"),
       "\"a\" or \"b\""},
      {"three points", manifold(R"("points": [{}, {}, {}])"), "has 3 points"},
      {"point without a depth", point(place + R"(, "features": ["f0","v0"])"),
       "\"depth\" is missing"},
      {"one feature", point(place + R"(, "depth": 0, "features": ["f0"])"), "has 1 elements"},
      {"unknown feature", point(place + R"(, "depth": 0, "features": ["f0","e1"])"),
       "\"e1\" is not"},
      {"feature without index", point(place + R"(, "depth": 0, "features": ["f","v1"])"),
       "\"f\" is"},
  };
}

std::array<Rows, 7> kinds() {
  return {text_rows(), size_rows(), number_rows(), polygon_rows(),
          type_rows(), key_rows(),  record_rows()};
}

}  // namespace

std::string good_case() {
  return with_bodies(R"({"vertices": )" + square() + "}", body_b());
}

const std::vector<BadCase>& bad_cases() {
  static const Rows all = [] {
    Rows rows;
    for (const Rows& kind : kinds()) rows.insert(rows.end(), kind.begin(), kind.end());
    return rows;
  }();
  return all;
}

std::vector<BadCase> bad_case_of_each_kind() {
  std::vector<BadCase> rows;
  for (const Rows& kind : kinds()) rows.push_back(kind.front());
  return rows;
}

}  // namespace manifuzz::test
