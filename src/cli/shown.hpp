#pragma once

#include "collider/collider.hpp"
#include "corpus/corpus.hpp"
#include "process/interruption.hpp"
#include "report/judged_case.hpp"
#include "report/test_suite.hpp"

namespace manifuzz {

/// The case and what these two answer now, asked in child processes where they could take this one
/// along. Throws Interrupted.
JudgedCase ask_both(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                    Interruption& interruption);

/// Draws the case into the failure; what there is no time for is left out.
void add_picture(TestFailure& failure, const CorpusCase& given, const Collider& subject,
                 const Collider& oracle, Interruption& interruption);
/// The same with the subject alone.
void add_picture(TestFailure& failure, const PairCase& pair, const Collider& subject,
                 Interruption& interruption);

}  // namespace manifuzz
