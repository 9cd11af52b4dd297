// phaser-box2d's b2Collide functions for manifuzz: `manifuzz fuzz --subject-command "node phaser-box2d.mjs"`.
import {
  b2Capsule, b2Circle, b2CollideCapsuleAndCircle, b2CollideCapsules, b2CollideCircles,
  b2CollidePolygonAndCapsule, b2CollidePolygonAndCircle, b2CollidePolygons, b2Manifold, b2Polygon,
} from "phaser-box2d/dist/PhaserBox2D.js";
import { serve, versionOf } from "./protocol.mjs";

const snippet = `import * as phaser from "phaser-box2d/dist/PhaserBox2D.js";

function shapeOf(vertices, radius, unit) {
  const scaled = vertices.map(([x, y]) => ({ x: unit * x, y: unit * y }));
  if (scaled.length === 1) return Object.assign(new phaser.b2Circle(), { center: scaled[0], radius });
  if (scaled.length === 2) {
    const [center1, center2] = scaled;
    return Object.assign(new phaser.b2Capsule(), { center1, center2, radius });
  }
  const polygon = new phaser.b2Polygon(); // filled as it stands: b2ComputeHull would weld
  vertices.forEach(([x, y], i, all) => {
    const [u, v] = all[(i + 1) % all.length].map((next, k) => next - [x, y][k]);
    const length = Math.sqrt(u * u + v * v);
    polygon.normals.push({ x: v / length, y: -u / length });
  });
  return Object.assign(polygon, { vertices: scaled, count: scaled.length, radius });
}

function body(vertices, radius, position, rotation) {
  const floats = (list) => list.map(Math.fround);
  const [c, s] = floats(rotation);
  const unit = Math.sqrt(c * c + s * s); // what it lacks of 1 goes into the vertices
  const [x, y] = floats(position);
  const shape = shapeOf(vertices.map(floats), Math.fround(radius), unit);
  return [shape, { p: { x, y }, q: { c: c / unit, s: s / unit } }];
}

const a = body(@a.vertices[]@, @a.radius@, @a.position[]@, @a.rotation[]@);
const b = body(@b.vertices[]@, @b.radius@, @b.position[]@, @b.rotation[]@);
// In the order in which its functions take them; a circle before a polygon, say, is turned about.
const kinds = ["Polygon", "Capsule", "Circle"];
const kind = ([shape]) => kinds.findIndex((name) => shape instanceof phaser["b2" + name]);
const [first, second] = kind(a) > kind(b) ? [b, a] : [a, b];
const [i, j] = [kind(first), kind(second)];
const name = "b2Collide" + (i === j ? kinds[i] + "s" : kinds[i] + "And" + kinds[j]);
const manifold = new phaser.b2Manifold();
phaser[name](...first, ...second, manifold);
console.log(name, first === a ? "A first" : "B first", manifold.pointCount, "points");
console.log(manifold);
`;

const declaration = {
  name: "phaser-box2d",
  version: versionOf("phaser-box2d"),
  scalar: "float64",
  frame: "world",
  tie_bias: 0,
  vertices_max: 8,
  takes_radius: false, // its corners are round, its side planes not widened by the radius
  vertices_min: 1,
  takes_round: true,
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

function circleOf(body) {
  const circle = new b2Circle();
  circle.center = body.vertices[0];
  circle.radius = body.radius;
  return circle;
}

function capsuleOf(body) {
  const capsule = new b2Capsule();
  [capsule.center1, capsule.center2] = body.vertices;
  capsule.radius = body.radius;
  return capsule;
}

// In the order in which its functions take them: polygons, capsules, circles. A segment is a
// capsule without radius: b2CollideSegmentAndCapsule makes it one, and drops the manifold.
const rank = ({ count }) => (count === 1 ? 2 : count === 2 ? 1 : 0);
const shapeBy = [polygonOf, capsuleOf, circleOf];
const collideBy = [
  [b2CollidePolygons, b2CollidePolygonAndCapsule, b2CollidePolygonAndCircle],
  [null, b2CollideCapsules, b2CollideCapsuleAndCircle],
  [null, null, b2CollideCircles],
];

// A point with a separation above 0 is there for the solver alone: the bodies may touch soon.
function collide(a, b) {
  const swapped = rank(a) > rank(b);
  const [first, second] = swapped ? [b, a] : [a, b];
  const shape = (body) => shapeBy[rank(body)](body);
  const manifold = new b2Manifold();
  collideBy[rank(first)][rank(second)](
    shape(first), first.pose, shape(second), second.pose, manifold);
  const points = manifold.points
    .slice(0, manifold.pointCount)
    .filter(({ separation }) => !(separation > 0))
    .map(({ pointX, pointY, separation }) => ({ position: [pointX, pointY], depth: -separation }));
  const sign = swapped ? -1 : 1;
  const normal = [sign * manifold.normalX, sign * manifold.normalY];
  return points.length > 0 ? { points, normal } : { points };
}

serve(declaration, collide);
