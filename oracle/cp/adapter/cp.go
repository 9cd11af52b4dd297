// cp's ShapesCollide for manifuzz, as a shared library: `manifuzz fuzz --subject oracle/cp/installed/libmanifuzz_cp.so`.
package main

// #cgo CFLAGS: -I${SRCDIR}/../../../src/external
// #include "manifuzz_collider.h"
import "C"

import (
	"math"

	"github.com/jakecoffman/cp/v2"
)

// How far from parallel, as a sine, a face may be to be the one that the normal was taken from.
const parallel = 1e-9

// What segments ask for their rotation, of use with tangents alone, which these do not have.
var bodyOfAll = cp.NewStaticBody()

func vectorOf(v C.manifuzz_float2) cp.Vector {
	return cp.Vector{X: float64(v.x), Y: float64(v.y)}
}

func shapeOf(body *C.manifuzz_body) *cp.Shape {
	vertices := make([]cp.Vector, body.count)
	for i := range vertices {
		vertices[i] = vectorOf(body.vertices[i])
	}
	radius := float64(body.radius)
	var shape *cp.Shape
	switch len(vertices) {
	case 1:
		shape = cp.NewCircle(bodyOfAll, radius, vertices[0])
	case 2:
		shape = cp.NewSegment(bodyOfAll, vertices[0], vertices[1], radius)
	default:
		shape = cp.NewPolyShapeRaw(bodyOfAll, len(vertices), vertices, radius)
	}
	turn, position := vectorOf(body.rotation), vectorOf(body.position)
	shape.Update(cp.NewTransformTranspose(turn.X, -turn.Y, position.X, turn.Y, turn.X, position.Y))
	return shape
}

// The sine of the angle between a normal and the nearest of a polygon's outward ones.
func apartFrom(normal cp.Vector, shape *cp.Shape) float64 {
	polygon := shape.Class.(*cp.PolyShape)
	least := 2.0
	for i := range polygon.Count() {
		from := polygon.TransformVert(i)
		edge := polygon.TransformVert((i + 1) % polygon.Count()).Sub(from)
		outward := edge.ReversePerp().Mult(1 / edge.Length())
		if outward.Dot(normal) > 0 {
			least = min(least, math.Abs(outward.Cross(normal)))
		}
	}
	return least
}

// cp does not say whose face is the reference; its normal, A to B, tells.
func referenceOf(a, b *cp.Shape, normal cp.Vector) C.int32_t {
	ofA, ofB := apartFrom(normal, a), apartFrom(normal.Neg(), b)
	if min(ofA, ofB) > parallel {
		return C.MANIFUZZ_NO_REFERENCE
	}
	if ofA <= ofB {
		return C.MANIFUZZ_A
	}
	return C.MANIFUZZ_B
}

func isRound(body *C.manifuzz_body) bool {
	return body.count < 3 || body.round != 0
}

//export collideInGo
func collideInGo(bodyA, bodyB *C.manifuzz_body, manifold *C.manifuzz_manifold) C.int {
	a, b := shapeOf(bodyA), shapeOf(bodyB)
	set := cp.ShapesCollide(a, b)
	if set.Count == 0 {
		return 0
	}
	// Round shapes touch where they are nearest: no face is the reference.
	if !isRound(bodyA) && !isRound(bodyB) {
		manifold.reference = referenceOf(a, b, set.Normal)
	}
	manifold.count = C.int32_t(set.Count)
	manifold.normal = C.manifuzz_double2{x: C.double(set.Normal.X), y: C.double(set.Normal.Y)}
	for i, point := range set.Points[:set.Count] {
		// Each point is there twice, on either polygon's edge: the incident edge's is the clip point.
		at := point.PointB
		if manifold.reference == C.MANIFUZZ_B {
			at = point.PointA
		}
		manifold.points[i].position = C.manifuzz_double2{x: C.double(at.X), y: C.double(at.Y)}
		manifold.points[i].depth = C.double(max(-point.Distance, 0))
	}
	return 0
}

func main() {}
