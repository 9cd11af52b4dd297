// libccd's ccdGJKPenetration, prism against prism.

#include "oracle/libccd/penetration.hpp"

#define MANIFUZZ_LIBCCD_ASKED "ccdGJKPenetration"
#define MANIFUZZ_LIBCCD_HEIGHT_A "2"
#define MANIFUZZ_LIBCCD_HEIGHT_B "1"
#define MANIFUZZ_LIBCCD_MIDDLE ""
#define MANIFUZZ_LIBCCD_SET_MIDDLE ""
#include "oracle/libccd/snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = manifuzz_libccd::declaration(
    "libccd-gjk", MANIFUZZ_LIBCCD_VERSION, manifuzz_libccd::kSnippet,
    manifuzz_libccd::claims_of_separation(1e-4, "ccd.h: CCD_INIT, epa_tolerance 0.0001"));

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  return manifuzz_libccd::collide_prisms(manifuzz_libccd::kGjk, *a, *b, *manifold);
}

}  // extern "C"
