"""The article's clipping for manifuzz: `manifuzz fuzz --subject-command "python3 FILE"`.

Reads case lines from stdin, writes its declaration and then an answer a line to stdout."""
import json
import math
import struct
import sys

DECLARATION = {"name": "clip-python", "version": "1", "scalar": "float64", "frame": "local",
               "tie_bias": 0, "vertices_max": 8, "takes_radius": True, "points": "clip"}


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1])


def turn(rotation, v):
    c, s = rotation
    return (c * v[0] - s * v[1], s * v[0] + c * v[1])


def floats(pair):
    """Every number of a case is a float; its line has the shortest decimals of them."""
    return struct.unpack("2f", struct.pack("2f", *pair))


class Body:
    """Corners turned and moved into the world, whose origin is A's position: it is subtracted
    first, so that distance from the origin costs nothing. Normals are those of the stored corners,
    for those of turned corners would be off by what the turn of a long polygon rounds away."""

    def __init__(self, body, origin):
        stored = [floats(v) for v in body["vertices"]]
        self.rotation = floats(body.get("rotation", (1, 0)))
        offset = minus(floats(body.get("position", (0, 0))), origin)
        self.corners = [(x + offset[0], y + offset[1])
                        for x, y in (turn(self.rotation, v) for v in stored)]
        self.radius = floats((body.get("radius", 0), 0))[0]
        self.normals = []
        for corner, following in zip(stored, stored[1:] + stored[:1]):
            x, y = minus(following, corner)
            length = math.hypot(x, y) * math.hypot(*self.rotation)
            self.normals.append(turn(self.rotation, (y / length, -x / length)))

    def edge(self, i):
        return [self.corners[i], self.corners[(i + 1) % len(self.corners)]]


def separation(face, reference, opposing):
    corner, normal = reference.corners[face], reference.normals[face]
    return min(dot(normal, minus(v, corner)) for v in opposing.corners)


def clip(face, reference, opposing, radius):
    """The incident edge, between the face's side planes and behind it: a (point, depth) each."""
    normal, (start, end) = reference.normals[face], reference.edge(face)
    incident = min(range(len(opposing.normals)), key=lambda i: dot(opposing.normals[i], normal))
    points = opposing.edge(incident)[::-1]  # in the direction of the reference face
    tangent = (-normal[1], normal[0])
    for i, plane, sign in ((0, start, 1), (1, end, -1)):
        here, there = (sign * dot(tangent, minus(p, plane)) + radius for p in (points[i], points[1 - i]))
        if here < 0 and there < 0:
            return []
        if here < 0:
            x, y = minus(points[1 - i], points[i])
            share = here / (here - there)
            points[i] = (points[i][0] + share * x, points[i][1] + share * y)
    with_depths = ((p, radius - dot(normal, minus(p, start))) for p in points)
    return [(p, depth) for p, depth in with_depths if depth >= 0]


def collide(case):
    origin = floats(case["a"].get("position", (0, 0)))
    bodies = {"a": Body(case["a"], origin), "b": Body(case["b"], origin)}
    a, b = bodies["a"], bodies["b"]
    radius = a.radius + b.radius
    faces = [(separation(i, a, b), "a", i) for i in range(len(a.corners))]
    faces += [(separation(i, b, a), "b", i) for i in range(len(b.corners))]
    faces.sort(key=lambda face: -face[0])  # of equal ones, A's first
    greatest = faces[0][0]
    if greatest > radius:
        return {"points": []}
    # The slab of a face that leads by rounding alone may miss what overlaps: the next one's then.
    rounding = 2**-50 * max(abs(x) for corner in a.corners + b.corners for x in corner)
    for _, name, face in faces:
        reference, opposing = (a, b) if name == "a" else (b, a)
        points = clip(face, reference, opposing, radius)
        if points or greatest > -rounding:
            break
    if not points:
        return {"points": []}
    x, y = reference.normals[face]
    c, s = a.rotation
    squared = c * c + s * s  # 1 to a float's bits only: the inverse is the transpose over it
    local = [[value / squared for value in turn((c, -s), p)] for p, _ in points]
    return {"points": [{"local": at, "depth": depth} for at, (_, depth) in zip(local, points)],
            "normal": [x, y] if name == "a" else [-x, -y], "reference": name}


print(json.dumps({"declaration": DECLARATION}), flush=True)
for line in sys.stdin:
    if line.strip():
        print(json.dumps(collide(json.loads(line))), flush=True)
