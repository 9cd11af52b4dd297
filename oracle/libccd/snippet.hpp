#pragma once

namespace manifuzz_libccd {

/// The program of reports on libccd: MANIFUZZ_LIBCCD_ASKED, a string, is its function,
/// MANIFUZZ_LIBCCD_HEIGHT_A and _B are how high the prisms are, MANIFUZZ_LIBCCD_MIDDLE what the
/// function needs besides a support; report/upstream fills it in.
inline constexpr const char* kSnippet =
    R"(@language c
#include <ccd/ccd.h>
#include <stdio.h>
typedef struct { int count; ccd_vec3_t at[8]; double z; } prism; // so high that the least depth is in the plane
void support(const void* object, const ccd_vec3_t* to, ccd_vec3_t* out) {
  const prism* p = object; const ccd_vec3_t* best = p->at;
  for (int i = 1; i < p->count; ++i) if (ccdVec3Dot(&p->at[i], to) > ccdVec3Dot(best, to)) best = &p->at[i];
  ccdVec3Set(out, best->v[0], best->v[1], to->v[2] < 0 ? -p->z : p->z); }
)" MANIFUZZ_LIBCCD_MIDDLE R"(int main(void) {
  prism a = {@a.count@, {@a.world({{$X, $Y, 0}})@}, )" MANIFUZZ_LIBCCD_HEIGHT_A
    R"( * (@a.wide_reach@ + @b.wide_reach@)};
  prism b = {@b.count@, {@b.world({{$X, $Y, 0}})@}, )" MANIFUZZ_LIBCCD_HEIGHT_B
    R"( * (@a.wide_reach@ + @b.wide_reach@)};
  ccd_t ccd; double depth = 0, part; ccd_vec3_t to, at; CCD_INIT(&ccd); ccd.max_iterations = 1000;
  ccd.support1 = ccd.support2 = support;)" MANIFUZZ_LIBCCD_SET_MIDDLE R"(
  if (@asked()" MANIFUZZ_LIBCCD_ASKED
    R"()@(&a, &b, &ccd, &depth, &to, &at) != 0 || (part = hypot(to.v[0], to.v[1])) == 0) return puts("no contact"), 0;
  printf("they touch, depth %.9g, direction (%.9g, %.9g)\n", depth * part, to.v[0] / part, to.v[1] / part); // in the plane
}
)";

}  // namespace manifuzz_libccd
