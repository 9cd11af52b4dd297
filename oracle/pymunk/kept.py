"""The contacts of a Munk2D space, step after step, for manifuzz:
`manifuzz fuzz --sequences --subject-command
"oracle/pymunk/installed/bin/python oracle/pymunk/kept.py"`.

Both bodies are put where a frame has them, and the space takes a step of next to no time. It detects
every contact anew, so each point is born in its frame; by its hash an arbiter knows it again."""
import math

from pymunk._chipmunk_cffi import ffi, lib

from adapter import DECLARATION, Shape, reference_of
from manifuzz_adapter import serve_sequences

DECLARED = {**DECLARATION, "name": "pymunk-kept", "rotation": "angle", "snippet": "",
            "keeping": {"points_max": 2}}

# cpSpaceStep returns at once where there is none.
STEP = 1e-9


@ffi.callback("void(struct cpBody *, cpFloat)")
def stays(_body, _step):
    """Poses are given, not computed."""


def as_turned_by_angle(body):
    """A body has an angle, so that its rotation is unit; what the stored one lacks of it goes into
    the vertices."""
    cos, sin = body.rotation
    length = math.sqrt(cos * cos + sin * sin)
    angle = math.atan2(sin, cos)
    return body._replace(vertices=[(length * x, length * y) for x, y in body.vertices],
                         rotation=(math.cos(angle), math.sin(angle))), angle


class Space:
    """Two bodies of one sequence, and what their arbiter holds."""

    def __init__(self, body_a, body_b):
        self.space = ffi.gc(lib.cpSpaceNew(), lib.cpSpaceFree)
        self.bodies, self.shapes = [], []
        for body in (body_a, body_b):
            owner = ffi.gc(lib.cpBodyNew(1, 1), lib.cpBodyFree)
            lib.cpBodySetPositionUpdateFunc(owner, stays)
            lib.cpSpaceAddBody(self.space, owner)
            self.bodies.append(owner)
            self.shapes.append(self.added(body, owner))
        self.ids, self.frame, self.points = {}, 0, []
        self.pre_solve = ffi.callback(ffi.typeof("cpCollisionPreSolveFunc"), self.record)
        lib.cpSpaceAddGlobalCollisionHandler(self.space).preSolveFunc = self.pre_solve

    def added(self, body, owner):
        shape = Shape(body, owner)
        lib.cpSpaceAddShape(self.space, shape.shape)
        return shape

    def close(self):
        """What is freed must not be in the space, nor the space be freed with it."""
        for shape, owner in zip(self.shapes, self.bodies):
            lib.cpSpaceRemoveShape(self.space, shape.shape)
            lib.cpSpaceRemoveBody(self.space, owner)

    def following(self, body_a, body_b):
        for i, given in enumerate((body_a, body_b)):
            body, angle = as_turned_by_angle(given)
            lib.cpBodySetPosition(self.bodies[i], body.position)
            lib.cpBodySetAngle(self.bodies[i], angle)
            self.set_vertices(i, body)
            self.shapes[i].place(body)
        self.is_round = body_a.round or body_b.round
        self.points = []
        lib.cpSpaceStep(self.space, STEP)
        self.frame += 1
        return {"points": self.points}

    def set_vertices(self, i, body):
        shape = self.shapes[i].shape
        if len(body.vertices) == 1:
            lib.cpCircleShapeSetOffset(shape, body.vertices[0])
        elif len(body.vertices) > 2:
            lib.cpPolyShapeSetVertsRaw(shape, len(body.vertices), body.vertices)
        else:  # made anew: cpSegmentShapeSetEndpoints turns the normal to the other side
            lib.cpSpaceRemoveShape(self.space, shape)
            self.shapes[i] = self.added(body, self.bodies[i])

    def placed(self, body, from_body):
        at = lib.cpBodyGetPosition(self.bodies[body])
        return at.x + from_body.x, at.y + from_body.y

    def record(self, arbiter, _space, _data):
        lib.cpArbiterSetProcessCollision(arbiter, False)  # bodies are not pushed
        is_turned = arbiter.a != self.shapes[0].shape
        sign = -1 if is_turned else 1
        nx, ny = sign * arbiter.n.x, sign * arbiter.n.y
        reference = None if self.is_round else reference_of(*self.shapes, (nx, ny))
        hashes = []
        for contact in arbiter.contacts[0:arbiter.count]:
            of_a, of_b = (contact.r2, contact.r1) if is_turned else (contact.r1, contact.r2)
            (ax, ay), (bx, by) = self.placed(0, of_a), self.placed(1, of_b)
            depth = (ax - bx) * nx + (ay - by) * ny
            # Each contact has a place on either edge: that on the incident one is the clip's.
            on_a = (ax, ay) if reference == "b" else (bx + depth * nx, by + depth * ny)
            # Both contacts may have one hash: those of the corners 0 and 1 of a space's first shapes do.
            number = self.ids.setdefault((contact.hash, contact.hash in hashes), len(self.ids))
            hashes.append(contact.hash)
            self.points.append({"id": number, "born": self.frame, "position": on_a, "depth": depth,
                                "normal": (nx, ny)})


last = None


def begin(body_a, body_b):
    global last
    if last is not None:
        last.close()
    last = Space(body_a, body_b)
    return last.following


serve_sequences(DECLARED, begin)
