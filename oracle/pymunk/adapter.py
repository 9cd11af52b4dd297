"""Munk2D, pymunk's Chipmunk, for manifuzz:
`manifuzz fuzz --subject-command "oracle/pymunk/installed/bin/python oracle/pymunk/adapter.py"`."""
import sys
from pathlib import Path

import pymunk
from pymunk._chipmunk_cffi import ffi, lib

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/colliders/python"))
from manifuzz_adapter import serve

SNIPPET = '''@language python
@point point $p, distance $s
from pymunk._chipmunk_cffi import ffi, lib

@each @*.circle? @* = lib.cpCircleShapeNew(ffi.NULL, @*.wide_radius@, @*.vertices(($X, $Y))@)
@each @*.segment? @* = lib.cpSegmentShapeNew(ffi.NULL, @*.vertices(($X, $Y))@, @*.wide_radius@)
@each @*.polygon? # pymunk.Poly would take the hull; this is what it calls
@each @*.polygon? @* = lib.cpPolyShapeNewRaw(ffi.NULL, @*.count@, [@*.vertices(($X, $Y))@], @*.wide_radius@)
@each @!*.placed? lib.cpShapeUpdate(@*, (1, 0, 0, 1, 0, 0))  # cos, sin, -sin, cos, x, y
@each @*.placed? lib.cpShapeUpdate(@*, (@*.rotation($X, $Y, -1 * $Y, $X)@, @*.position($X, $Y)@))
set = lib.@asked(cpShapesCollide)@(a, b)  # what Shape.shapes_collide calls
print(set.count, "points, normal", (set.normal.x, set.normal.y))
for point in set.points[0:set.count]:
    print((point.pointA.x, point.pointA.y), (point.pointB.x, point.pointB.y), point.distance)
'''

DECLARATION = {"name": "pymunk", "version": pymunk.version, "scalar": "float64", "frame": "world",
               "tie_bias": 0, "vertices_max": 8, "takes_radius": False, "vertices_min": 1,
               "takes_round": True, "points": "clip", "normal": "a_to_b", "snippet": SNIPPET}

# How far from parallel, as a sine, a face may be to be the one that the normal was taken from.
PARALLEL = 1e-9


class Shape:
    """One of Munk2D's, with the corners that it has in the world."""

    def __init__(self, body, owner=ffi.NULL):
        count, radius = len(body.vertices), body.radius
        if count == 1:
            shape = lib.cpCircleShapeNew(owner, radius, body.vertices[0])
        elif count == 2:
            shape = lib.cpSegmentShapeNew(owner, *body.vertices, radius)
        else:  # as it stands: pymunk.Poly would take the hull
            shape = lib.cpPolyShapeNewRaw(owner, count, body.vertices, radius)
        self.shape = ffi.gc(shape, lib.cpShapeFree)
        self.place(body)

    def place(self, body):
        c, s = body.rotation
        x, y = body.position
        lib.cpShapeUpdate(self.shape, (c, s, -s, c, x, y))
        self.corners = [(c * u - s * v + x, s * u + c * v + y) for u, v in body.vertices]

    def apart_from(self, normal):
        """The sine of the angle between a normal and the nearest of a polygon's outward ones."""
        sines = [2.0]
        for (x, y), (u, v) in zip(self.corners, self.corners[1:] + self.corners[:1]):
            length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
            outward = ((v - y) / length, (x - u) / length) if length else (0, 0)
            if outward[0] * normal[0] + outward[1] * normal[1] > 0:
                sines.append(abs(outward[0] * normal[1] - outward[1] * normal[0]))
        return min(sines)


def reference_of(a, b, normal):
    """Munk2D does not say whose face is the reference; its normal, A to B, tells."""
    of_a, of_b = a.apart_from(normal), b.apart_from((-normal[0], -normal[1]))
    if min(of_a, of_b) > PARALLEL:
        return None
    return "a" if of_a <= of_b else "b"


def collide(body_a, body_b):
    a, b = Shape(body_a), Shape(body_b)
    found = lib.cpShapesCollide(a.shape, b.shape)
    if found.count == 0:
        return {"points": []}
    normal = (found.normal.x, found.normal.y)
    # Round shapes touch where they are nearest: no face is the reference.
    reference = None if body_a.round or body_b.round else reference_of(a, b, normal)
    points = []
    for point in found.points[0:found.count]:
        # Each point is there twice, on either polygon's edge: the incident edge's is the clip point.
        at = point.pointA if reference == "b" else point.pointB
        points.append({"position": (at.x, at.y), "depth": max(-point.distance, 0.0)})
    answer = {"points": points, "normal": normal}
    return answer if reference is None else {**answer, "reference": reference}


if __name__ == "__main__":
    serve(DECLARATION, collide)
