// Copied for each bug planted into the judge, and compiled under the bug's namespace.
#include "canary/planted.hpp"
#include "judging/judge.cpp"

namespace manifuzz {
namespace {

[[maybe_unused]] const bool planted = canary::add_judge("PLANTED_BUG", [](const PairCase& pair,
                                                                          const Declaration&
                                                                              subject,
                                                                          const Answer& of_subject,
                                                                          const Declaration& oracle,
                                                                          const Answer& of_oracle) {
  return judge(pair, ColliderAnswer{subject, of_subject}, ColliderAnswer{oracle, of_oracle}).bucket;
});

}  // namespace
}  // namespace manifuzz
