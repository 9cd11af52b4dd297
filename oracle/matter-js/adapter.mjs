// Matter.Collision.collides for manifuzz: `manifuzz fuzz --subject-command "node oracle/matter-js/adapter.mjs"`.
import Matter from "matter-js";
import { serve, toWorld, versionOf } from "../../scripts/colliders/js/protocol.mjs";

const { Body, Vertices } = Matter;

// Before 0.18 another module had it, whose answer says itself whether they touch.
const { collides } = Matter.Collision ?? Matter.SAT;

const snippet = `@language js
@point support $p, depth $d
import Matter from "matter-js";

const { Body, Collision, Vertices } = Matter;
@each const of@^ = [@*.unit_vertices({ x: $X, y: $Y })@];
@each @!*.placed? const @* = Body.create({ vertices: of@^, position: Vertices.centre(of@^) });
@each @*.placed? const { x: x@^, y: y@^ } = Vertices.centre(of@^), [c@^, s@^] = [@*.unit_rotation($X, $Y)@];
@each @*.placed? const @* = Body.create({ vertices: of@^, angle: Math.atan2(s@^, c@^), position: {
@each @*.placed?   x: c@^ * x@^ - s@^ * y@^ + @*.position($X)@, y: s@^ * x@^ + c@^ * y@^ + @*.position($Y)@ } });
const collision = Collision.@asked(collides)@(a, b); // its normal points from B to A
console.log(collision?.supportCount ?? 0, "points", collision?.supports.slice(0, collision.supportCount).map(({ x, y }) => [x, y]));
console.log(collision?.depth, collision?.normal);
`;

const declaration = {
  name: "matter-js",
  version: versionOf("matter-js", import.meta.url),
  scalar: "float64",
  frame: "world",
  rotation: "angle",
  vertices_max: 8,
  takes_radius: false, // chamfers are more vertices, circles polygons
  claims: "manifold",
  clips: false,
  points: "vertex",
  depths: "shared",
  normal: "b_to_a",
  snippet,
};

// Where Body.create puts the centre of the vertices, as it computes that.
function bodyOf({ vertices, pose }) {
  const [x, y] = toWorld(pose, Vertices.centre(vertices));
  return Body.create({ vertices, position: { x, y }, angle: Math.atan2(pose.q.s, pose.q.c) });
}

function collide(a, b) {
  const bodies = [bodyOf(a), bodyOf(b)];
  const placed = bodies.every(({ position: { x, y } }) => Number.isFinite(x) && Number.isFinite(y));
  if (!placed) return { unsupported: "has no centre for a polygon whose area rounds to 0" };
  const collision = collides(...bodies);
  if (!collision?.collided) return { points: [] };
  const { depth, normal, supports, supportCount = supports.length } = collision;
  const points = supports.slice(0, supportCount).map(({ x, y }) => ({ position: [x, y] }));
  return { points, normal: [normal.x, normal.y], depth };
}

serve(declaration, collide);
