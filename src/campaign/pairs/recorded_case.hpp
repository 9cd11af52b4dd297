#pragma once

#include "corpus/corpus.hpp"
#include "judging/judge.hpp"
#include "process/interruption.hpp"

namespace manifuzz {

/// The corpus case of a pair as these colliders see it: what is right, answers, verdict, severity
/// and a note. A severity that is not there until the deadline, or, once there is hurry, after a
/// second, is left out. Throws Interrupted.
CorpusCase recorded_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                         const Collider& oracle, Interruption& interruption,
                         const Deadline& severity_until = {});

/// The corpus case of a pair without asking anybody: it has neither answers nor severity.
CorpusCase unasked_case(const PairCase& pair, const Judgement& judgement, const Collider& subject,
                        const Collider& oracle);

}  // namespace manifuzz
