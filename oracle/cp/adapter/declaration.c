/* The interface over cp.go: cgo exports neither constants nor functions that take pointers to const. */
#include "_cgo_export.h"
#include "manifuzz_collider.h"

/* CP_VERSION is given to the compiler by the install script, which asks go.mod. */
#define AS_WRITTEN(x) #x
#define AS_TEXT(x) AS_WRITTEN(x)

static const char kSnippet[] =
    "@language go\n"
    "@point point $p, Distance $s\n"
    "package main\n"
    "import \"fmt\"\n"
    "import \"github.com/jakecoffman/cp/v2\"\n"
    "func main() {\n"
    "\tbody := cp.NewStaticBody()\n"
    "@each @*.circle? \t@* := cp.NewCircle(body, @*.wide_radius@, @*.vertices(cp.Vector{$X, $Y})@)\n"
    "@each @*.segment? \t@* := cp.NewSegment(body, @*.vertices(cp.Vector{$X, $Y})@, @*.wide_radius@)\n"
    "@each @*.polygon? \t@* := cp.NewPolyShapeRaw(body, @*.count@, []cp.Vector{@*.vertices({$X, $Y})@}, @*.wide_radius@)\n"
    "@each @*.placed? \t@*.Update(cp.NewTransformTranspose(@*.rotation($X, -1 * $Y)@, @*.position($X)@, @*.rotation($Y, $X)@, @*.position($Y)@))\n"
    "@each @!*.placed? \t@*.Update(cp.NewTransformIdentity())\n"
    "\tset := cp.@asked(ShapesCollide)@(a, b)\n"
    "\tfmt.Println(set.Count, \"points, normal\", set.Normal.X, set.Normal.Y)\n"
    "\tfor _, p := range set.Points[:set.Count] {\n"
    "\t\tfmt.Println(p.PointA.X, p.PointA.Y, p.PointB.X, p.PointB.Y, p.Distance)\n"
    "\t}\n"
    "}\n";

const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "cp",
    .version = AS_TEXT(CP_VERSION),
    .scalar = MANIFUZZ_FLOAT64,
    .rounds_in = MANIFUZZ_WORLD,
    .answers_in = MANIFUZZ_WORLD,
    .points = MANIFUZZ_CLIP_POINTS,
    .normal = MANIFUZZ_A_TO_B,
    .tie_bias = 0,
    .vertices_max = MANIFUZZ_VERTICES_MAX,
    .takes_radius = 0,
    .snippet = kSnippet,
    .claims = {.vertices_min = 1, .takes_round = 1},
};

int manifuzz_collide(const manifuzz_body* a, const manifuzz_body* b, manifuzz_manifold* manifold) {
  return collideInGo((manifuzz_body*)a, (manifuzz_body*)b, manifold); /* which are only read */
}
