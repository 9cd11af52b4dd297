#include "campaign/judged_case.hpp"

#include "campaign/in_child.hpp"

namespace manifuzz {

DeclaredAnswer declared_answer(const Collider& collider, const PairCase& pair,
                               Interruption& interruption) {
  return {collider.declaration, ask_in_child(collider, pair, interruption)};
}

JudgedCase judged_case(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                       Interruption& interruption) {
  return {given, declared_answer(subject, given.pair, interruption),
          declared_answer(oracle, given.pair, interruption),
          judge_in_child(given.pair, subject, oracle, interruption)};
}

}  // namespace manifuzz
