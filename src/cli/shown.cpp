#include "cli/shown.hpp"

#include "campaign/in_child.hpp"
#include "report/picture/text_picture.hpp"

namespace manifuzz {

JudgedCase ask_both(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                    Interruption& interruption) {
  return {given,
          {subject.declaration, ask_in_child(subject, given.pair, interruption)},
          {oracle.declaration, ask_in_child(oracle, given.pair, interruption)},
          judge_in_child(given.pair, subject, oracle, interruption)};
}

void add_picture(TestFailure& failure, const CorpusCase& given, const Collider& subject,
                 const Collider& oracle, Interruption& interruption) {
  try {
    failure.picture = text_picture(ask_both(given, subject, oracle, interruption));
  } catch (const Interrupted&) {
  }
}

void add_picture(TestFailure& failure, const PairCase& pair, const Collider& subject,
                 Interruption& interruption) {
  try {
    const DeclaredAnswer asked{subject.declaration, ask_in_child(subject, pair, interruption)};
    failure.picture = text_picture(pair, {&asked, 1});
  } catch (const Interrupted&) {
  }
}

}  // namespace manifuzz
