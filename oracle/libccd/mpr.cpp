// libccd's ccdMPRPenetration, prism against prism.

#include "oracle/libccd/penetration.hpp"

#define MANIFUZZ_LIBCCD_ASKED "ccdMPRPenetration"
#define MANIFUZZ_LIBCCD_HEIGHT_A "16"
#define MANIFUZZ_LIBCCD_HEIGHT_B "16"
#define MANIFUZZ_LIBCCD_MIDDLE                                                                     \
  "void centre(const void* object, ccd_vec3_t* out) { const prism* p = object; double x = 0, y = " \
  "0;\n"                                                                                           \
  "  for (int i = 0; i < p->count; ++i) x += p->at[i].v[0], y += p->at[i].v[1];\n"                 \
  "  ccdVec3Set(out, x / p->count, y / p->count, 0); }\n"
#define MANIFUZZ_LIBCCD_SET_MIDDLE " ccd.center1 = ccd.center2 = centre;"
#include "oracle/libccd/snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = manifuzz_libccd::declaration(
    "libccd-mpr", MANIFUZZ_LIBCCD_VERSION, manifuzz_libccd::kSnippet,
    manifuzz_libccd::claims_of_separation(1e-4, "ccd.h: CCD_INIT, mpr_tolerance 0.0001", 1e-4));

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  return manifuzz_libccd::collide_prisms(manifuzz_libccd::kMpr, *a, *b, *manifold);
}

}  // extern "C"
