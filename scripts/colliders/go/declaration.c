/* The interface over cp.go: cgo exports neither constants nor functions that take pointers to const. */
#include "_cgo_export.h"
#include "manifuzz_collider.h"

static const char kSnippet[] =
    "package main\n"
    "\n"
    "import (\n"
    "\t\"fmt\"\n"
    "\n"
    "\t\"github.com/jakecoffman/cp/v2\"\n"
    ")\n"
    "\n"
    "func vector(v [2]float32) cp.Vector { return cp.Vector{X: float64(v[0]), Y: float64(v[1])} }\n"
    "\n"
    "func shape(vertices [][2]float32, radius float32, position, rotation [2]float32) *cp.Shape {\n"
    "\tbody, r := cp.NewStaticBody(), float64(radius)\n"
    "\tvar at []cp.Vector\n"
    "\tfor _, v := range vertices {\n"
    "\t\tat = append(at, vector(v))\n"
    "\t}\n"
    "\tmade := cp.NewCircle(body, r, at[0])\n"
    "\tif len(at) == 2 {\n"
    "\t\tmade = cp.NewSegment(body, at[0], at[1], r)\n"
    "\t} else if len(at) > 2 {\n"
    "\t\tmade = cp.NewPolyShapeRaw(body, len(at), at, r)\n"
    "\t}\n"
    "\tturn, p := vector(rotation), vector(position)\n"
    "\tmade.Update(cp.NewTransformTranspose(turn.X, -turn.Y, p.X, turn.Y, turn.X, p.Y))\n"
    "\treturn made\n"
    "}\n"
    "\n"
    "func main() {\n"
    "\ta := shape([][2]float32@a.vertices{}@, @a.radius@,\n"
    "\t\t[2]float32@a.position{}@, [2]float32@a.rotation{}@)\n"
    "\tb := shape([][2]float32@b.vertices{}@, @b.radius@,\n"
    "\t\t[2]float32@b.position{}@, [2]float32@b.rotation{}@)\n"
    "\tset := cp.ShapesCollide(a, b)\n"
    "\tfmt.Println(set.Count, \"points, normal\", set.Normal)\n"
    "\tfor _, point := range set.Points[:set.Count] {\n"
    "\t\tfmt.Println(point.PointA, \"on A,\", point.PointB, \"on B, distance\", point.Distance)\n"
    "\t}\n"
    "}\n";

const manifuzz_declaration manifuzz_collider = {
    .interface = MANIFUZZ_INTERFACE,
    .name = "cp",
    .version = "2.4.0",
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
