"""What every adapter in Python does: `serve(declaration, collide)` reads case lines from stdin and
writes the declaration and then an answer a line to stdout.

src/external/README.md has all that may be declared and answered. `collide(a, b)` returns the
answer as a dict; where it raises, the case is counted as crashed."""
import json
import math
import struct
import sys
from typing import NamedTuple


class Body(NamedTuple):
    """A shape and its pose, as stored: every number is a float."""

    vertices: list  # (x, y), counter-clockwise: 1 of a circle, 2 of a segment or capsule
    radius: float
    round: bool  # whether corners are round, as those of circles and segments are
    position: tuple
    rotation: tuple  # (cos, sin), a unit vector to a float's bits only


def serve(declaration, collide):
    serve_cases(declaration, lambda case: collide(read(case["a"]), read(case["b"])))


def serve_sequences(declaration, begin):
    """Of a program that keeps points from frame to frame: `begin(a, b)` is called at the first frame
    of each sequence, and what it returns with (a, b) for that frame and each after it."""
    following = None

    def answer(case):
        nonlocal following
        a, b = read(case["a"]), read(case["b"])
        if case["frame"] == 0:
            following = begin(a, b)
        return following(a, b)

    serve_cases(declaration, answer)


def serve_cases(declaration, answer):
    print(json.dumps({"declaration": declaration}), flush=True)
    for line in sys.stdin:
        if line.strip():
            print(json.dumps(answer(json.loads(line))), flush=True)


def read(body):
    vertices = [floats(vertex) for vertex in body["vertices"]]
    is_round = len(vertices) < 3 or body.get("rounding") == "round"
    return Body(vertices, floats([body.get("radius", 0)])[0], is_round,
                floats(body.get("position", (0, 0))), floats(body.get("rotation", (1, 0))))


def floats(numbers):
    """A line has the shortest decimals of floats."""
    form = f"{len(numbers)}f"
    return struct.unpack(form, struct.pack(form, *numbers))


def normals_of(vertices):
    """Of the face from each vertex to the next: outward, of length 1."""
    normals = []
    for (x, y), (u, v) in zip(vertices, vertices[1:] + vertices[:1]):
        length = math.hypot(u - x, v - y)
        normals.append(((v - y) / length, (x - u) / length))
    return normals
