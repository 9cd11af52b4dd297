#include "sequence/sequence_judge.hpp"

namespace manifuzz {

std::vector<KeptAnswer> ask_sequence(const SequenceCollider& subject, const Sequence& sequence) {
  std::vector<KeptAnswer> answers;
  const auto ask = subject.begin();
  for (std::size_t frame = 0; frame < sequence.frames.size(); ++frame) {
    answers.push_back(ask(sequence.at(frame)));
    if (!std::holds_alternative<KeptManifold>(answers.back())) break;
  }
  return answers;
}

}  // namespace manifuzz
