#pragma once

#include <vector>

#include "geometry/collider.hpp"
#include "judging/bucket.hpp"

namespace manifuzz::canary {

/// A collider with a bug in it.
using MakeCollider = Collider (*)(double tie_bias);

/// Those registered so far.
std::vector<MakeCollider>& planted_colliders();

/// A judge with a bug in it: what it makes of a subject's and an oracle's answer to a case.
using JudgeOf = Bucket (*)(const PairCase& pair, const Declaration& subject,
                           const Answer& of_subject, const Declaration& oracle,
                           const Answer& of_oracle);

/// Registers the test that a planted bug is caught. To be called before main.
bool add_collider(const char* bug, MakeCollider make);
bool add_judge(const char* bug, JudgeOf judge_of);

}  // namespace manifuzz::canary
