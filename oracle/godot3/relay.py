"""Godot's Shape2D.collide_and_get_contacts for manifuzz: `manifuzz fuzz --subject-command "python3 oracle/godot3/relay.py"`.

godot3-server takes no pipe as its standard input: collide.gd connects to a port of this machine.
A case goes there as its length in bytes, then of A and of B: how many points, a radius, the points,
the position, (cos, sin). Back come how many points, and these: one on A, one on B, and so on."""
import math
import os
import re
import socket
import struct
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts/colliders/python"))

from manifuzz_adapter import serve  # noqa: E402

SNIPPET = """@language gdscript
@no_normal
@figures by way of A's frame, so to a few roundings of the largest
@point on A $a, on B $b
extends SceneTree # godot3-server --no-window -s snippet.gd
func _init():
@each 	var at@^ = Transform2D(@*.rotation(Vector2($x, $y), Vector2(-1 * $y, $x))@, @*.position(Vector2($x, $y))@)
@each @*.circle? 	var @* = CircleShape2D.new(); @*.radius = @*.radius@
@each @*.circle? 	at@^.origin = at@^.xform(@*.vertices(Vector2($x, $y))@)
@each @*.segment? 	var of@^ = [@*.vertices(Vector2($x, $y))@]
@each @*.segment? @!*.rounded? 	var @* = SegmentShape2D.new()
@each @*.segment? @!*.rounded? 	@*.a = of@^[0]; @*.b = of@^[1]
@each @*.segment? @*.rounded? 	var @* = CapsuleShape2D.new(); @*.radius = @*.radius@; @*.height = of@^[0].distance_to(of@^[1])
@each @*.segment? @*.rounded? 	var up@^ = at@^.basis_xform(of@^[1] - of@^[0]).normalized(); at@^ = Transform2D(Vector2(up@^.y, -up@^.x), up@^, at@^.xform((of@^[0] + of@^[1]) / 2))
@each @*.polygon? 	var @* = ConvexPolygonShape2D.new()
@each @*.polygon? 	@*.points = PoolVector2Array([@*.vertices(Vector2($x, $y))@])
	var contacts = a.@asked(collide_and_get_contacts)@(atA, b, atB)
	print(contacts.size() / 2, " points, on A and on B:")
	for point in contacts: print("(", digits(point.x), ", ", digits(point.y), ")")
	quit()
func digits(x): # nine, which tell floats apart: str() gives six decimals
	var power = floor(log(abs(x)) / log(10)) if x else 0.0
	return "%.8fe%d" % [x / pow(10, power), power]
"""

SAID = subprocess.run(["godot3-server", "--version"], stdin=subprocess.DEVNULL, capture_output=True,
                      text=True).stdout  # its number, .stable and more

# second_point: an edge is one where its normal is within the angle of the cosine
# _SEGMENT_IS_VALID_SUPPORT_THRESHOLD, 0.99998 (servers/physics_2d/shape_2d_sw.h); else its farther
# end. least_depth: CMP_EPSILON, 1e-5, by which _generate_contacts_edge_edge asks points to overlap.
# Both points of two edges are as deep as the plane through the first end of the other edge.
DECLARATION = {"name": "godot3", "version": re.match(r"[\d.]*\d", SAID)[0], "scalar": "float32",
               "frame": "world", "tie_bias": 0, "vertices_max": 8, "takes_radius": False,
               "vertices_min": 1, "takes_round": False, "second_point": math.acos(0.99998), "clips": False,
               "points": "surface_a", "depths": "shared", "one_point_enough": True,
               "least_depth": 1e-5, "normal": "a_to_b", "snippet": SNIPPET}


def message_of(body):
    """Circles and capsules lie about their own origin, capsules along the y axis."""
    (c, s), (x, y), points = body.rotation, body.position, body.vertices
    placed = [(c * u - s * v + x, s * u + c * v + y) for u, v in points]
    if len(points) == 1:
        x, y = placed[0]
        points = [(0, 0)]
    elif len(points) == 2 and body.radius > 0:
        across, up = (q - p for p, q in zip(*placed))
        height = math.hypot(across, up)
        x, y = ((p + q) / 2 for p, q in zip(*placed))
        (c, s), points = (up / height, -across / height), [(0, 0), (0, height)]
    numbers = [body.radius, *(number for point in points for number in point), x, y, c, s]
    return struct.pack(f"<h{len(numbers)}f", len(points), *numbers)


class Godot:
    def __init__(self):
        listener = socket.create_server(("127.0.0.1", 0))
        environment = {**os.environ, "MANIFUZZ_PORT": str(listener.getsockname()[1]), "LANG": "en"}
        self.process = subprocess.Popen(
            ["godot3-server", "--no-window", "--path", str(Path(__file__).parent.resolve()),
             "-s", "collide.gd"],
            env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
        listener.settimeout(30)
        self.connection = listener.accept()[0]
        self.connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.answers = self.connection.makefile("rb")

    def contacts(self, a, b):
        """Pairs of points in the world, on A and on B."""
        message = message_of(a) + message_of(b)
        self.connection.sendall(struct.pack("<i", len(message)) + message)
        size = self.answers.read(4)
        if len(size) < 4:
            sys.exit("godot3-server has died")
        count, = struct.unpack("<i", size)
        numbers = struct.unpack(f"<{2 * count}f", self.answers.read(8 * count))
        return list(zip(zip(numbers[0::4], numbers[1::4]), zip(numbers[2::4], numbers[3::4])))


def collide(godot, a, b):
    if any(len(body.vertices) > 2 and body.radius > 0 for body in (a, b)):
        return {"unsupported": "its polygons have no radius"}
    # Godot's own solver takes normal and depth from the points too (body_pair_2d_sw.cpp).
    contacts = []
    for (x, y), (u, v) in godot.contacts(a, b):
        if (x, y) != (u, v):
            contacts.append((math.hypot(x - u, y - v), (x - u, y - v), (x, y)))
    if not contacts:
        return {"points": []}
    depth, (x, y), _ = max(contacts)
    return {"points": [{"position": position} for _, _, position in contacts],
            "normal": (x / depth, y / depth), "depth": depth}


def main():
    godot = Godot()
    serve(DECLARATION, lambda a, b: collide(godot, a, b))
    godot.connection.shutdown(socket.SHUT_RDWR)
    godot.process.wait()


main()
