// Copied with the bugs planted into the kernel for one pair, and compiled under a namespace of
// theirs.
#include "canary/one_target.hpp"
#include "canary/planted.hpp"
#include "kernel/deepest_contact.cpp"
#include "kernel/pair.cpp"
#include "kernel/round_pairs.cpp"
#include "kernel/shapes.cpp"

namespace manifuzz {
namespace {

std::vector<canary::PairAnswers> ask(std::span<const PairCase> pairs, float tie_bias, bool hinted) {
  kernel::FaceHint hints[3];
  const auto hint = [&](int query) { return hinted ? &hints[query] : nullptr; };
  std::vector<canary::PairAnswers> answers;
  for (const PairCase& pair : pairs) {
    const kernel::ShapeRows a = kernel::rows_of(pair.a.polygon);
    const kernel::ShapeRows b = kernel::rows_of(pair.b.polygon);
    const Pose<float> b_in_a = relative_pose(pair.a.pose, pair.b.pose);
    const auto found = kernel::separation(a, b, b_in_a, hint(0));
    answers.push_back({kernel::collide(a, b, b_in_a, tie_bias, hint(1)),
                       kernel::touches(a, b, b_in_a, hint(2)), found.touches, found.separation});
  }
  return answers;
}

[[maybe_unused]] const bool planted = canary::add_pairs({PLANTED_BUGS}, ask);

}  // namespace
}  // namespace manifuzz
