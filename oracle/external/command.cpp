#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "oracle/external/external_collider.hpp"

namespace manifuzz {
namespace {

/// An answer too many may take so long.
constexpr double kExtraLineSeconds = 0.002;

/// One of two words, the first of which is what is meant where there is none.
template <class Choice>
Choice choice_in(const JsonView& object, std::string_view key,
                 std::initializer_list<std::string_view> names) {
  const auto value = object.find(key);
  if (!value) return Choice{};
  const auto* const found = std::ranges::find(names, value->string());
  if (found == names.end()) {
    value->fail(fmt::format("\"{}\" is expected", fmt::join(names, "\" or \"")));
  }
  return static_cast<Choice>(found - names.begin());
}

bool flag_in(const JsonView& object, std::string_view key, bool usual) {
  const auto value = object.find(key);
  return value ? value->boolean() : usual;
}

double number_in(const JsonView& object, std::string_view key) {
  const auto value = object.find(key);
  return value ? value->number() : 0;
}

int vertices_max_in(const JsonView& object) {
  const auto value = object.find("vertices_max");
  if (!value) return kMaxVertices;
  if (value->whole_number() < 3) value->fail("3 or more is expected");
  return static_cast<int>(std::min<std::uint64_t>(value->whole_number(), kMaxVertices));
}

/// "clip", "never", or an angle in radians.
SecondPoint second_point_in(const JsonView& value) {
  if (!value.is_string()) {
    const double angle = value.number();
    if (!(angle >= 0 && angle <= std::numbers::pi / 2)) {
      value.fail(fmt::format("{} is no angle; one from 0 to pi / 2 is expected", angle));
    }
    return SecondPoint::within(angle);
  }
  const std::string_view word = value.string();
  if (word != "clip" && word != "never") {
    value.fail(fmt::format("'{}' is unknown; \"clip\", \"never\" or an angle is", printable(word)));
  }
  return word == "never" ? SecondPoint::never() : SecondPoint{};
}

/// 3 or more, unless it says what it does with curved shapes.
int vertices_min_in(const JsonView& object) {
  const auto value = object.find("vertices_min");
  if (!value) return object.find("second_point") ? 1 : kMinVertices;
  if (value->whole_number() < 1 || value->whole_number() > kMinVertices) {
    value->fail("1, 2 or 3 is expected");
  }
  return static_cast<int>(value->whole_number());
}

/// What is left out is taken to be the least that a collider can promise: float, in the world.
Declaration read_declaration(const JsonView& object, const std::string& usual_name) {
  object.expect_keys({"name",        "version",          "scalar",       "frame",
                      "tie_bias",    "vertices_max",     "takes_radius", "points",
                      "normal",      "snippet",          "claims",       "clips",
                      "depths",      "one_point_enough", "speculative",  "least_depth",
                      "rotation",    "alters_shapes",    "tolerance",    "vertices_min",
                      "takes_round", "second_point"});
  const auto bias = object.find("tie_bias");
  const auto tolerance = object.find("tolerance");
  const auto second_point = object.find("second_point");
  if (tolerance) tolerance->expect_keys({"absolute", "relative", "source"});
  return {.name = object.string_or("name", usual_name),
          .version = object.string_or("version", "unknown"),
          .description = "a program",
          .scalar = choice_in<ScalarType>(object, "scalar", {"float32", "float64"}),
          .frame = choice_in<bool>(object, "frame", {"world", "local"}) ? RoundingFrame::local
                                                                        : RoundingFrame::world,
          .takes_angles = choice_in<bool>(object, "rotation", {"matrix", "angle"}),
          .tie_bias = bias ? read_tie_bias(*bias) : TieBias{},
          .max_vertices = vertices_max_in(object),
          .takes_radius = flag_in(object, "takes_radius", true),
          .min_vertices = vertices_min_in(object),
          .takes_round = flag_in(object, "takes_round", second_point.has_value()),
          .second_point = second_point ? second_point_in(*second_point) : SecondPoint{},
          .claims =
              choice_in<Claims>(object, "claims", {"manifold", "point", "separation", "touching"}),
          .clips = flag_in(object, "clips", true),
          .points = choice_in<PointsAt>(object, "points",
                                        {"clip", "midpoint", "vertex", "surface_a", "surface_b"}),
          .shares_depth = choice_in<bool>(object, "depths", {"point", "shared"}),
          .one_point_enough = flag_in(object, "one_point_enough", false),
          .speculative = number_in(object, "speculative"),
          .least_depth = number_in(object, "least_depth"),
          .alters_shapes = flag_in(object, "alters_shapes", false),
          .tolerance = tolerance ? Tolerance{number_in(*tolerance, "absolute"),
                                             number_in(*tolerance, "relative")}
                                 : Tolerance{},
          .tolerance_source = tolerance ? tolerance->string_or("source", "") : "",
          .snippet = object.string_or("snippet", "")};
}

/// "planck" of "node scripts/planck.mjs --fast".
std::string name_in(const std::string& command) {
  std::string name;
  std::size_t start = 0;
  while (start < command.size()) {
    const std::size_t end = std::min(command.find(' ', start), command.size());
    const std::string word = command.substr(start, end - start);
    if (!word.empty() && word.front() != '-') name = word;
    start = end + 1;
  }
  name = name.substr(name.rfind('/') + 1);  // npos + 1 is 0
  name = name.substr(0, name.find('.'));
  return is_collider_name(name) ? name : "command";
}

PairCase overlapping_boxes() {
  const std::array<Vector2<float>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  PairCase pair{{make_polygon<float>(corners), {}}, {make_polygon<float>(corners), {}}};
  pair.b.pose.position = {1.5F, 0.25F};
  return pair;
}

class CommandCollider {
 public:
  CommandCollider(const std::string& command, double start_seconds, double case_seconds)
      : command_(command), program_(command, start_seconds, case_seconds) {}

  /// Asks one case, before whose answer it may declare itself. One that answers goes on running;
  /// one that dies over it or answers nothing is left to the campaign.
  Declaration ask_declaration() {
    const PairCase pair = overlapping_boxes();
    Answer answer;
    const BatchResult result = program_.ask({&pair, 1}, {&answer, 1}, [] { return true; });
    const std::string declaration = program_.declaration();
    const std::string death = result.end == BatchEnd::answered ? "" : program_.stop();
    const bool cannot_run = death.ends_with("status 127") || death.ends_with("status 126");
    if (result.end == BatchEnd::exited && cannot_run) {
      throw UserError(fmt::format("'{}' cannot be run: it {}", command_, death));
    }
    const JsonTree tree = parse_json(declaration.empty() ? "{\"declaration\": {}}" : declaration);
    try {
      const JsonView object = JsonView(tree).at("declaration");
      const Declaration read = read_declaration(object, name_in(command_));
      program_.conventions = conventions_of(read);
      program_.conventions.normal_from_b = choice_in<bool>(object, "normal", {"a_to_b", "b_to_a"});
      check_declaration(read, "$.declaration.");
      return read;
    } catch (const UserError& error) {
      throw UserError(fmt::format("'{}' declares: {}", command_, error.what()));
    }
  }

  /// The longest that a case may take, where the program dies before it and has to be started.
  double seconds_max() const { return program_.start_seconds + 2 * program_.case_seconds; }

  /// Answers at least one, unless told to stop. What was sent ahead to one that died is asked
  /// again; where lines and cases may have lost step, all are, one at a time.
  std::size_t answer_batch(std::span<const PairCase> pairs, std::span<Answer> answers,
                           const std::function<bool()>& go_on) {
    BatchResult result = program_.ask(pairs, answers, go_on);
    if (result.end == BatchEnd::answered && pairs.size() > 1 &&
        program_.writes_more(kExtraLineSeconds)) {
      result.end = BatchEnd::extra_lines;
    }
    if (result.end == BatchEnd::answered || result.end == BatchEnd::stopped) return result.answered;
    const Lost lost = lost_by(result);
    if (pairs.size() == 1) {
      answers[0] = lost;
      return 1;
    }
    if (result.end != BatchEnd::exited) return answer_one_by_one(pairs, answers, go_on);
    const std::size_t at = result.answered;
    return at + answer_up_to_crash(pairs.subspan(at), answers.subspan(at), lost, go_on);
  }

 private:
  Lost lost_by(const BatchResult& result) {
    const std::string death = program_.stop();
    if (result.end == BatchEnd::exited) {
      return {Lost::How::crashed, death.empty() ? "closed its output" : death};
    }
    const bool is_late = result.end == BatchEnd::timed_out;
    if (is_late && !death.empty()) return {Lost::How::crashed, death};  // one of its own lives on
    return {is_late ? Lost::How::timed_out : Lost::How::malformed, result.why};
  }

  /// The program died among these, and answers may have died with it in its buffers: asked one at a
  /// time, it dies over the case that it dies of. Where it dies of none, the first stands for the
  /// crash, which is not to be passed over.
  std::size_t answer_up_to_crash(std::span<const PairCase> pairs, std::span<Answer> answers,
                                 const Lost& crash, const std::function<bool()>& go_on) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const BatchResult result = program_.ask(pairs.subspan(i, 1), answers.subspan(i, 1), go_on);
      if (result.end == BatchEnd::stopped) return i;
      if (result.end == BatchEnd::answered) continue;
      answers[i] = lost_by(result);
      return i + 1;
    }
    answers[0] = Lost{crash.how, crash.why + ", among other cases; alone it answers each"};
    return pairs.size();
  }

  std::size_t answer_one_by_one(std::span<const PairCase> pairs, std::span<Answer> answers,
                                const std::function<bool()>& go_on) {
    std::size_t done = 0;
    while (done < pairs.size() && go_on() && !is_unresponsive(answers, done)) {
      const BatchResult result =
          program_.ask(pairs.subspan(done, 1), answers.subspan(done, 1), go_on);
      if (result.end == BatchEnd::stopped) break;
      if (result.end != BatchEnd::answered) {
        answers[done] = lost_by(result);
      } else if (program_.writes_more(kExtraLineSeconds)) {
        program_.stop();
        answers[done] = Lost{Lost::How::malformed, "more answers than cases"};
      }
      ++done;
    }
    return done;
  }

  std::string command_;
  ProgramProcess program_;
};

}  // namespace

Collider collider_of_command(const std::string& command, double seconds_max,
                             double start_seconds_max) {
  const auto program = std::make_shared<CommandCollider>(command, start_seconds_max, seconds_max);
  const Declaration declaration = program->ask_declaration();
  return isolated(declaration, program->seconds_max(),
                  [program](auto pairs, auto answers, const auto& go_on) {
                    return program->answer_batch(pairs, answers, go_on);
                  });
}

}  // namespace manifuzz
