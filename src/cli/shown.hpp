#pragma once

#include "cases/corpus.hpp"
#include "geometry/collider.hpp"
#include "oracle/external/process.hpp"
#include "report/shown_case.hpp"
#include "report/test_suite.hpp"

namespace manifuzz {

/// The case and what these two answer now, asked in child processes where they could take this one
/// along. Throws Interrupted.
ShownCase ask_both(const CorpusCase& given, const Collider& subject, const Collider& oracle,
                   Interruption& interruption);

/// Draws the case into the failure; what there is no time for is left out.
void add_picture(TestFailure& failure, const CorpusCase& given, const Collider& subject,
                 const Collider& oracle, Interruption& interruption);
/// The same with the subject alone.
void add_picture(TestFailure& failure, const PairCase& pair, const Collider& subject,
                 Interruption& interruption);

}  // namespace manifuzz
