// The article's clipping in float with the bugs of rare_bugs.cpp, each of which loses the contact.
// That file is a part of this one, so libFuzzer sees what each bug asks of the exact truth.

#include "../../scripts/colliders/cpp/clip.hpp"
#include "planted_counts.hpp"
#include "rare_bugs.cpp"

namespace {

manifuzz::Body body_of(const manifuzz_body& body) {
  return {clip::shape_of(body), clip::pose_of(body)};
}

}  // namespace

extern "C" {

const manifuzz_declaration manifuzz_collider = clip::declaration("planted");

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  planted::begin_evaluation();
  clip::collide(*a, *b, *manifold);
  const manifuzz::exact::Truth truth({body_of(*a), body_of(*b)});
  const std::uint64_t met = manifuzz::test::rare_bugs_met_by(truth);
  for (std::size_t i = 0; met >> i != 0; ++i) {
    if ((met >> i & 1) != 0) planted::meet(i, *manifold);
  }
  return 0;
}
}
