#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "external/external_collider.hpp"

namespace manifuzz {
namespace {

/// An answer too many may take so long.
constexpr double kExtraLineSeconds = 0.002;

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
    const std::string shown = printable(command_, 200);
    if (result.end == BatchEnd::stopped) {
      throw UserError(fmt::format("'{}': interrupted before it had declared itself", shown));
    }
    const bool cannot_run = death.ends_with("status 127") || death.ends_with("status 126");
    if (result.end == BatchEnd::exited && cannot_run) {
      throw UserError(fmt::format("'{}' cannot be run: it {}", shown, death));
    }
    const ProgramDeclaration read = program_declaration(command_, declaration);
    program_.conventions = conventions_of(read.declaration);
    program_.scalar = read.declaration.scalar;
    program_.conventions.normal_from_b = read.declaration.normal_from_b;
    return read.declaration;
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
    const Lost lost = program_.lost_by(result);
    if (pairs.size() == 1) {
      answers[0] = lost;
      return 1;
    }
    if (result.end != BatchEnd::exited) return answer_one_by_one(pairs, answers, go_on);
    const std::size_t at = result.answered;
    return at + answer_up_to_crash(pairs.subspan(at), answers.subspan(at), lost, go_on);
  }

 private:
  /// The program died among these, and answers may have died with it in its buffers: asked one at a
  /// time, it dies over the case that it dies of. Where it dies of none, the first stands for the
  /// crash, which is not to be passed over.
  std::size_t answer_up_to_crash(std::span<const PairCase> pairs, std::span<Answer> answers,
                                 const Lost& crash, const std::function<bool()>& go_on) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const BatchResult result = program_.ask(pairs.subspan(i, 1), answers.subspan(i, 1), go_on);
      if (result.end == BatchEnd::stopped) return i;
      if (result.end == BatchEnd::answered) continue;
      answers[i] = program_.lost_by(result);
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
        answers[done] = program_.lost_by(result);
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
