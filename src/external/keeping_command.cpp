#include <memory>

#include <fmt/format.h>

#include "base/json.hpp"
#include "base/text.hpp"
#include "exchange/kept_json.hpp"
#include "external/external_collider.hpp"

namespace manifuzz {
namespace {

/// Fails where an answer says that it is to another question.
void check_number(const JsonView& answer, std::string_view key, std::size_t asked) {
  const auto said = answer.is_object() ? answer.find(key) : std::nullopt;
  if (!said || said->whole_number() == asked) return;
  said->fail(fmt::format("is {}, but the question was {}", said->whole_number(), asked));
}

/// A program that is asked frame after frame, and what its answers are read by.
class KeepingProgram {
 public:
  KeepingProgram(const std::string& command, double start_seconds, double frame_seconds)
      : command_(command), program_(command, start_seconds, frame_seconds) {}

  /// Asks one frame, before whose answer it declares itself.
  ProgramDeclaration ask_declaration() {
    KeptReader reader;
    const Asked asked = ask({0, 0}, overlapping_boxes(), reader);
    const std::string declaration = program_.declaration();
    if (asked.end == BatchEnd::exited && declaration.empty()) {
      const std::string death = std::get<Lost>(asked.answer).why;
      throw UserError(fmt::format("'{}' declares nothing: it {}", printable(command_, 200), death));
    }
    ProgramDeclaration read = program_declaration(command_, declaration);
    if (!read.keeping) {
      throw UserError(
          fmt::format("'{}' declares: \"keeping\" is missing; it says across which gaps, "
                      "drifts and turns the program keeps points",
                      printable(command_, 200)));
    }
    normal_from_b_ = read.declaration.normal_from_b;
    program_.scalar = read.declaration.scalar;
    return read;
  }

  /// What it answers to the frames of the next sequence.
  std::function<KeptAnswer(const PairCase&)> begin_sequence(
      const std::shared_ptr<KeepingProgram>& self) {
    return [self, sequence = ++sequences_, frame = std::size_t{0},
            reader = KeptReader(normal_from_b_)](const PairCase& pair) mutable {
      return self->ask({sequence, frame++}, pair, reader).answer;
    };
  }

 private:
  struct Asked {
    KeptAnswer answer;
    BatchEnd end = BatchEnd::answered;
  };

  Asked ask(const FrameNumber& number, const PairCase& pair, KeptReader& reader) {
    Asked asked;
    ProgramProcess::Lines line{
        .text = {},
        .count = 1,
        .take =
            [&](std::size_t, const JsonView& answer) {
              check_number(answer, "sequence", number.sequence);
              check_number(answer, "frame", number.frame);
              asked.answer = reader.read(answer, pair);
            },
        .refuse =
            [&](std::size_t, const std::string& why) {
              asked.answer = Lost{Lost::How::malformed, why};
            },
        .may_restart = number.frame == 0};  // else it has forgotten what it kept
    append_frame_line(line.text, pair, number, program_.scalar);
    line.text += '\n';
    const BatchResult result = program_.ask(line, [] { return true; });
    asked.end = result.end;
    if (result.end == BatchEnd::stopped) {
      asked.answer = Lost{Lost::How::timed_out, "interrupted"};
    } else if (result.end != BatchEnd::answered) {
      asked.answer = program_.lost_by(result);
    }
    return asked;
  }

  std::string command_;
  ProgramProcess program_;
  bool normal_from_b_ = false;
  std::size_t sequences_ = 0;
};

}  // namespace

SequenceCollider keeper_of_command(const std::string& command, double seconds_max,
                                   double start_seconds_max) {
  const auto program = std::make_shared<KeepingProgram>(command, start_seconds_max, seconds_max);
  const ProgramDeclaration declared = program->ask_declaration();
  SequenceCollider keeper;
  keeper.declaration = declared.declaration;
  // Whoever gives points claims them, whatever else.
  if (declared.declaration.claims != Claims::manifold) keeper.declaration.claims = Claims::point;
  keeper.declaration.points = PointsAt::surface_a;
  keeper.keeping = *declared.keeping;
  keeper.begin = [program] { return program->begin_sequence(program); };
  keeper.is_isolated = true;
  return keeper;
}

}  // namespace manifuzz
