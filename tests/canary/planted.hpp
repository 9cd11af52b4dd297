#pragma once

#include <functional>
#include <span>
#include <vector>

#include "canary/acting.hpp"
#include "collider/collider.hpp"
#include "judging/bucket.hpp"
#include "own_colliders/own_colliders.hpp"

namespace manifuzz::canary {

/// A collider with a bug in it.
using MakeCollider = std::function<Collider(double tie_bias)>;

/// The planted colliders registered so far.
std::vector<MakeCollider>& planted_colliders();

/// The collider with the bug acting whenever it is asked.
Collider with_bug(const Bug& bug, Collider collider);

/// A collider that gives a second point of round shapes by this policy, with a bug in it.
using MakeWithSecondPoint = Collider (*)(SecondPoint second_point);

/// Planted colliders of round shapes: of each bug in float, in double and under policies of the
/// second point.
std::vector<Collider>& planted_round_colliders();

/// A collider by another method than clipping, with a bug in it.
using MakeMethod = Collider (*)();

/// A judge with a bug in it: what it makes of a subject's and an oracle's answer to a case.
using JudgeOf = Bucket (*)(const PairCase& pair, const Declaration& subject,
                           const Answer& of_subject, const Declaration& oracle,
                           const Answer& of_oracle);

/// What the kernel for one pair says of a pair, query by query.
struct PairAnswers {
  Manifold<float> manifold;
  bool touches = false;
  bool separation_touches = false;  ///< as `separation` sees it
  float separation = 0;
};

/// A kernel for one pair, with a bug in it, about each pair in turn: every query without a hint, or
/// with the one that it left before.
using AskPair = std::vector<PairAnswers> (*)(std::span<const PairCase> pairs, float tie_bias,
                                             bool hinted);

/// Named here: copies of the clean code have a namespace `clipping` of their own.
template <class Scalar>
using Placed = clipping::PlacedPair<Scalar>;

/// A kernel for many pairs, with a bug in it: the manifolds of all of them by one call.
template <class Scalar>
struct PlantedBatch {
  using Collide = void (*)(std::span<const Placed<Scalar>> pairs, Scalar tie_bias,
                           Manifold<Scalar>* out);
  Collide from_indices;
  Collide packed;
};

/// Registers for each planted bug the test that it is caught. To be called before main.
bool add_colliders(const std::vector<Bug>& bugs, const MakeCollider& make);
bool add_round_colliders(const std::vector<Bug>& bugs, const MakeCollider& make,
                         MakeWithSecondPoint make_with_second_point);
bool add_methods(const std::vector<Bug>& bugs, const std::vector<MakeMethod>& makes);
bool add_judges(const std::vector<Bug>& bugs, JudgeOf judge_of);
bool add_pairs(const std::vector<Bug>& bugs, AskPair ask);
bool add_batches(const std::vector<Bug>& bugs, const PlantedBatch<float>& batch,
                 const PlantedBatch<double>& batch64);

}  // namespace manifuzz::canary
