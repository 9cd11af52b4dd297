// Matter.Collision.collides for manifuzz: `manifuzz fuzz --subject-command "node matter-js.mjs"`.
import Matter from "matter-js";
import { serve, toWorld, versionOf } from "./protocol.mjs";

const { Body, Collision, Vertices } = Matter;

const snippet = `import Matter from "matter-js";

const { Body, Collision, Vertices } = Matter;

function bodyOf(corners, [x, y], [c, s]) {
  const length = Math.hypot(c, s);
  const vertices = corners.map(([u, v]) => ({ x: length * u, y: length * v }));
  const { x: u, y: v } = Vertices.centre(vertices); // which Body.create puts into its position
  const position = { x: (c * u - s * v) / length + x, y: (s * u + c * v) / length + y };
  return Body.create({ vertices, position, angle: Math.atan2(s, c) });
}

const a = bodyOf(@a.vertices[]@, @a.position[]@, @a.rotation[]@);
const b = bodyOf(@b.vertices[]@, @b.position[]@, @b.rotation[]@);
const collision = Collision.collides(a, b); // its normal points from B to A
if (collision === null) console.log("0 points");
else {
  const { depth, normal, supports, supportCount } = collision;
  console.log(supportCount, "points", supports.slice(0, supportCount).map(({ x, y }) => [x, y]));
  console.log({ depth, normal });
}
`;

const declaration = {
  name: "matter-js",
  version: versionOf("matter-js"),
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
  const collision = Collision.collides(...bodies);
  if (collision === null) return { points: [] };
  const { depth, normal, supports, supportCount } = collision;
  const points = supports.slice(0, supportCount).map(({ x, y }) => ({ position: [x, y] }));
  return { points, normal: [normal.x, normal.y], depth };
}

serve(declaration, collide);
