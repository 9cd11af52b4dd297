// libccd's ccdGJKPenetration, prism against prism.

#include "oracle/libccd/prism.hpp"

#define MANIFUZZ_LIBCCD_ASKED "ccdGJKPenetration"
#define MANIFUZZ_LIBCCD_HEIGHT_A "2"
#define MANIFUZZ_LIBCCD_HEIGHT_B "1"
#define MANIFUZZ_LIBCCD_MIDDLE ""
#define MANIFUZZ_LIBCCD_SET_MIDDLE ""
#include "oracle/libccd/snippet.hpp"

extern "C" {

extern const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "libccd-gjk",
    .version = MANIFUZZ_LIBCCD_VERSION,
    .scalar = MANIFUZZ_FLOAT64,
    .rounds_in = MANIFUZZ_WORLD,
    .answers_in = MANIFUZZ_WORLD,
    .points = MANIFUZZ_CLIP_POINTS,
    .normal = MANIFUZZ_A_TO_B,
    .tie_bias = 0,
    .vertices_max = MANIFUZZ_VERTICES_MAX,
    .takes_radius = 0,
    .snippet = manifuzz_libccd::kSnippet,
    .claims = manifuzz_libccd::claims_of_separation(1e-4, "ccd.h: CCD_INIT, epa_tolerance 0.0001"),
};

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  return manifuzz_libccd::collide_prisms(manifuzz_libccd::kGjk, *a, *b, *manifold);
}

}  // extern "C"
