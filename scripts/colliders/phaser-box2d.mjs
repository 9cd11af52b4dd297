// phaser-box2d's b2CollidePolygons for manifuzz: `manifuzz fuzz --subject-command "node phaser-box2d.mjs"`.
import { b2CollidePolygons, b2Manifold, b2Polygon } from "phaser-box2d/dist/PhaserBox2D.js";
import { serve, versionOf } from "./protocol.mjs";

const snippet = `import { b2CollidePolygons, b2Manifold, b2Polygon } from
  "phaser-box2d/dist/PhaserBox2D.js";

function body(vertices, position, rotation) {
  const floats = (list) => list.map(Math.fround);
  const [c, s] = floats(rotation);
  const unit = Math.sqrt(c * c + s * s); // what it lacks of 1 goes into the vertices
  const polygon = new b2Polygon(); // filled as it stands: b2ComputeHull would weld
  vertices.map(floats).forEach(([x, y], i, all) => {
    const [u, v] = all[(i + 1) % all.length].map((next, k) => next - [x, y][k]);
    const length = Math.sqrt(u * u + v * v);
    polygon.vertices.push({ x: unit * x, y: unit * y });
    polygon.normals.push({ x: v / length, y: -u / length });
  });
  polygon.count = vertices.length;
  const [x, y] = floats(position);
  return [polygon, { p: { x, y }, q: { c: c / unit, s: s / unit } }];
}

const a = body(@a.vertices[]@, @a.position[]@, @a.rotation[]@);
const b = body(@b.vertices[]@, @b.position[]@, @b.rotation[]@);
console.log(b2CollidePolygons(...a, ...b, new b2Manifold()));
`;

const declaration = {
  name: "phaser-box2d",
  version: versionOf("phaser-box2d"),
  scalar: "float64",
  frame: "world",
  tie_bias: 0,
  vertices_max: 8,
  takes_radius: false, // its side planes are not widened by the radius
  points: "midpoint",
  normal: "a_to_b",
  snippet,
};

// Filled as it stands: b2ComputeHull would weld and reorder.
function polygonOf(body) {
  const polygon = new b2Polygon();
  polygon.vertices = body.vertices;
  polygon.normals = body.normals;
  polygon.count = body.count;
  polygon.radius = body.radius;
  return polygon;
}

// A point with a separation above 0 is there for the solver alone: the bodies may touch soon.
function collide(a, b) {
  const manifold = new b2Manifold();
  b2CollidePolygons(polygonOf(a), a.pose, polygonOf(b), b.pose, manifold);
  const points = manifold.points
    .slice(0, manifold.pointCount)
    .filter(({ separation }) => !(separation > 0))
    .map(({ pointX, pointY, separation }) => ({ position: [pointX, pointY], depth: -separation }));
  return points.length > 0 ? { points, normal: [manifold.normalX, manifold.normalY] } : { points };
}

serve(declaration, collide);
