#include "cli/bench_subjects.hpp"

#include "cli/colliders.hpp"
#include "measure/bench/own_bench_subjects.hpp"
#include "oracle/box2d/box2d.hpp"
#include "oracle/chipmunk/chipmunk_pass.hpp"

namespace manifuzz {

std::vector<BenchSubject> bench_subjects() {
  std::vector<BenchSubject> all{{.name = "box2d", .prepare = box2d_pass, .collider = make_box2d},
                                {.name = "chipmunk", .prepare = chipmunk_pass, .collider = [] {
                                   return find_collider("chipmunk");
                                 }}};
  for (BenchSubject& ours : own_bench_subjects()) all.push_back(std::move(ours));
  return all;
}

}  // namespace manifuzz
