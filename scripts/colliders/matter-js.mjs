// Matter.Collision.collides for manifuzz: `manifuzz fuzz --subject-command "node matter-js.mjs"`.
import Matter from "matter-js";
import { serve, versionOf } from "./protocol.mjs";

const { Axes, Body, Collision, Vertices } = Matter;

const snippet = `import Matter from "matter-js";

const { Axes, Body, Collision, Vertices } = Matter;

function bodyOf(corners, [x, y], [c, s]) {
  const at = corners.map(([u, v]) => ({ x: c * u - s * v + x, y: s * u + c * v + y }));
  const body = Body.create({ vertices: at, position: Vertices.centre(at) });
  at.forEach((corner, i) => Object.assign(body.vertices[i], corner)); // to the bit
  body.axes = Axes.fromVertices(body.vertices);
  return body;
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
  vertices_max: 8,
  takes_radius: false, // chamfers are more vertices, circles polygons
  claims: "manifold",
  clips: false,
  points: "vertex",
  depths: "shared",
  normal: "b_to_a",
  snippet,
};

// As Body.create makes it, which moves the vertices to the centre and back: here they and the axes
// are those of the case, to the bit. The centre is that of the body turned but not yet moved.
function bodyOf({ world, vertices, pose: { p, q } }) {
  const turned = vertices.map(({ x, y }) => ({ x: q.c * x - q.s * y, y: q.s * x + q.c * y }));
  const centre = Vertices.centre(turned);
  const position = { x: centre.x + p.x, y: centre.y + p.y };
  const body = Body.create({ vertices: world.map(({ x, y }) => ({ x, y })), position });
  world.forEach((corner, i) => Object.assign(body.vertices[i], corner));
  body.axes = Axes.fromVertices(body.vertices);
  return body;
}

function collide(a, b) {
  const collision = Collision.collides(bodyOf(a), bodyOf(b));
  if (collision === null) return { points: [] };
  const { depth, normal, supports, supportCount } = collision;
  const points = supports.slice(0, supportCount).map(({ x, y }) => ({ position: [x, y] }));
  return { points, normal: [normal.x, normal.y], depth };
}

serve(declaration, collide);
