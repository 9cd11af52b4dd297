#pragma once

#include <array>
#include <string>

#include "campaign/plan.hpp"
#include "engines/colliders.hpp"
#include "generating/regime.hpp"

namespace manifuzz::test {

/// A case as `clip` and `box2d` see it, without the guard of a child process.
inline JudgedCase judged_case(const PairCase& pair, const std::string& subject = "clip",
                              const std::string& oracle = "box2d") {
  const Collider of_subject = find_collider(subject);
  const Collider of_oracle = find_collider(oracle);
  JudgedCase judged;
  judged.given.any = pair;
  judged.subject = {of_subject.declaration, of_subject.collide(pair)};
  judged.oracle = {of_oracle.declaration, of_oracle.collide(pair)};
  judged.judgement = judge(pair, {judged.subject.declaration, judged.subject.answer},
                           {judged.oracle.declaration, judged.oracle.answer});
  return judged;
}

inline ConvexPolygon<float> box_polygon(float half_width, float half_height, float radius = 0) {
  const std::array<Vector2<float>, 4> corners{
      Vector2<float>(-half_width, -half_height), Vector2<float>(half_width, -half_height),
      Vector2<float>(half_width, half_height), Vector2<float>(-half_width, half_height)};
  return make_polygon<float>(corners, radius);
}

/// A box of 2 by 2 at the origin, and below its middle a box of 1 by 1 that overlaps it by `depth`.
inline PairCase box_on_box(float depth, float radius = 0) {
  PairCase pair;
  pair.a.polygon = box_polygon(1, 1, radius);
  pair.b.polygon = box_polygon(0.5F, 0.5F);
  pair.b.pose.position = {0, -1.5F + depth};
  return pair;
}

}  // namespace manifuzz::test
