// planck's Collide functions for manifuzz: `manifuzz fuzz --subject-command "node planck.mjs"`.
import {
  CircleShape, CollideCircles, CollideEdgeCircle, CollideEdgePolygon, CollidePolygonCircle,
  CollidePolygons, ContactFeatureType, EdgeShape, Manifold, ManifoldType, PolygonShape, Settings,
} from "planck";
import { centroidOf, serve, toWorld, versionOf } from "./protocol.mjs";

const snippet = `import * as planck from "planck";

function shapeOf(vertices, radius, unit) {
  const scaled = vertices.map(([x, y]) => ({ x: unit * x, y: unit * y }));
  if (scaled.length === 1) return new planck.CircleShape(scaled[0], radius);
  if (scaled.length === 2) return Object.assign(new planck.EdgeShape(...scaled), { m_radius: radius });
  const shape = new planck.PolygonShape(); // filled as it stands: PolygonShape(vertices) would weld
  vertices.forEach(([x, y], i, all) => {
    const [u, v] = all[(i + 1) % all.length].map((next, k) => next - [x, y][k]);
    const length = Math.sqrt(u * u + v * v);
    shape.m_normals.push({ x: v / length, y: -u / length });
  });
  return Object.assign(shape, { m_vertices: scaled, m_count: scaled.length, m_radius: radius });
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
const kinds = ["Edge", "Polygon", "Circle"];
const kind = ([shape]) => kinds.findIndex((name) => shape instanceof planck[name + "Shape"]);
const [first, second] = kind(a) > kind(b) ? [b, a] : [a, b];
const [i, j] = [kind(first), kind(second)];
const name = "Collide" + (i === j ? kinds[i] + "s" : kinds[i] + kinds[j]);
const manifold = new planck.Manifold();
planck[name](manifold, ...first, ...second);
console.log(name, first === a ? "A first" : "B first", manifold.pointCount, "points");
console.log(manifold.getWorldManifold(
  null, first[1], first[0].m_radius, second[1], second[0].m_radius));
`;

const declaration = {
  name: "planck",
  version: versionOf("planck"),
  scalar: "float64",
  frame: "world",
  tie_bias: 0.1 * Settings.linearSlop,
  vertices_max: 8,
  takes_radius: true,
  vertices_min: 1,
  takes_round: true,
  declines: [["capsule", "capsule"], ["rounded", "capsule"], ["rounded", "polygon"], ["rounded", "rounded"]],
  points: "clip",
  normal: "a_to_b",
  snippet,
};

// Filled as it stands: PolygonShape(vertices) would weld and reorder.
function polygonOf(body) {
  const shape = new PolygonShape();
  shape.m_vertices = body.vertices;
  shape.m_normals = body.normals;
  shape.m_count = body.count;
  shape.m_centroid = centroidOf(body.vertices);
  shape.m_radius = body.radius;
  return shape;
}

function featureName(type, index) {
  return (type === ContactFeatureType.e_face ? "f" : "v") + index;
}

function shapeOf(body) {
  if (body.count > 2) return polygonOf(body);
  if (body.count === 1) return new CircleShape(body.vertices[0], body.radius);
  const edge = new EdgeShape(...body.vertices);
  edge.m_radius = body.radius;
  return edge;
}

// In the order in which planck's functions take them: edges, polygons, circles.
const rank = ({ count }) => (count === 1 ? 2 : count === 2 ? 0 : 1);
const collideBy = [
  [null, CollideEdgePolygon, CollideEdgeCircle],
  [null, CollidePolygons, CollidePolygonCircle],
  [null, null, CollideCircles],
];

// Points are midway between both surfaces; the second's is half of the separation farther.
function collideRound(a, b) {
  const swapped = rank(a) > rank(b);
  const [first, second] = swapped ? [b, a] : [a, b];
  const mitred = [a, b].some(({ count, round }) => count > 2 && round) && a.radius + b.radius > 0;
  if (rank(second) === 0) return { unsupported: "has no edge against edge" };
  if (mitred && rank(second) !== 2) return { unsupported: "its polygons' corners are mitred" };
  const manifold = new Manifold();
  collideBy[rank(first)][rank(second)](
    manifold, shapeOf(first), first.pose, shapeOf(second), second.pose);
  if (manifold.pointCount === 0) return { points: [] };

  const world = manifold.getWorldManifold(
    null, first.pose, first.radius, second.pose, second.radius);
  const { x, y } = world.normal;
  const points = world.points.slice(0, manifold.pointCount).map((midpoint, i) => ({
    position: [
      midpoint.x + (world.separations[i] / 2) * x, midpoint.y + (world.separations[i] / 2) * y],
    depth: Math.max(0, -world.separations[i]),
  }));
  return { points, normal: swapped ? [-x, -y] : [x, y] };
}

function collide(a, b) {
  if (a.round || b.round) return collideRound(a, b);
  const manifold = new Manifold();
  CollidePolygons(manifold, shapeOf(a), a.pose, shapeOf(b), b.pose);
  if (manifold.pointCount === 0) return { points: [] };

  const world = manifold.getWorldManifold(null, a.pose, a.radius, b.pose, b.radius);
  const byA = manifold.type === ManifoldType.e_faceA;
  const incident = byA ? b : a;
  const points = manifold.points.slice(0, manifold.pointCount).map(({ localPoint, id }, i) => ({
    position: toWorld(incident.pose, localPoint),
    depth: Math.max(0, -world.separations[i]),
    features: [featureName(id.typeA, id.indexA), featureName(id.typeB, id.indexB)],
  }));
  return { points, normal: [world.normal.x, world.normal.y], reference: byA ? "a" : "b" };
}

serve(declaration, collide);
