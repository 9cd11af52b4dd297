// planck's Collide functions for manifuzz: `manifuzz fuzz --subject-command "node oracle/planck/adapter.mjs"`.
import {
  CircleShape, CollideCircles, CollideEdgeCircle, CollideEdgePolygon, CollidePolygonCircle,
  CollidePolygons, ContactFeatureType, EdgeShape, Manifold, ManifoldType, PolygonShape, Rot, Settings,
} from "planck";
import { centroidOf, isProgram, serve, toWorld, versionOf } from "../../scripts/colliders/js/protocol.mjs";

const snippet = `@language js
@point world.points $m, separations $s
import * as planck from "planck";

@each @*.circle? const @* = new planck.CircleShape(@*.unit_vertices({ x: $X, y: $Y })@, @*.wide_radius@);
@each @*.segment? const @* = new planck.EdgeShape(@*.unit_vertices({ x: $X, y: $Y })@);
@each @*.segment? @*.m_radius = @*.wide_radius@;
@each @*.polygon? const @* = Object.assign(new planck.PolygonShape(), { // its constructor would weld vertices
@each @*.polygon?   m_vertices: [@*.unit_vertices({ x: $X, y: $Y })@],
@each @*.polygon?   m_normals: [@*.unit_normals({ x: $X, y: $Y })@],
@each @*.polygon?   m_centroid: { @*.centroid(x: $X, y: $Y)@ }, m_count: @*.count@, m_radius: @*.wide_radius@ });
@each const at@^ = { p: { @*.position(x: $X, y: $Y)@ }, q: new planck.Rot(Math.atan2(@*.rotation($Y, $X)@)) };
const manifold = new planck.Manifold();
@a.polygon? @b.polygon? planck.@asked(CollidePolygons)@(manifold, a, atA, b, atB);
@a.circle? @b.circle? planck.@asked(CollideCircles)@(manifold, a, atA, b, atB);
@a.segment? @b.polygon? planck.@asked(CollideEdgePolygon)@(manifold, a, atA, b, atB);
@a.segment? @b.circle? planck.@asked(CollideEdgeCircle)@(manifold, a, atA, b, atB);
@a.polygon? @b.circle? planck.@asked(CollidePolygonCircle)@(manifold, a, atA, b, atB);
@a.polygon? @b.segment? planck.@asked(CollideEdgePolygon)@(manifold, b, atB, a, atA);
@a.circle? @b.segment? planck.@asked(CollideEdgeCircle)@(manifold, b, atB, a, atA);
@a.circle? @b.polygon? planck.@asked(CollidePolygonCircle)@(manifold, b, atB, a, atA);
@a.polygon? @b.segment? @b_first
@a.circle? @!b.circle? @b_first
console.log(manifold.pointCount, "points");
@a.segment? console.log(manifold.getWorldManifold(null, atA, a.m_radius, atB, b.m_radius));
@a.polygon? @!b.segment? console.log(manifold.getWorldManifold(null, atA, a.m_radius, atB, b.m_radius));
@a.circle? @b.circle? console.log(manifold.getWorldManifold(null, atA, a.m_radius, atB, b.m_radius));
@a.polygon? @b.segment? console.log(manifold.getWorldManifold(null, atB, b.m_radius, atA, a.m_radius));
@a.circle? @!b.circle? console.log(manifold.getWorldManifold(null, atB, b.m_radius, atA, a.m_radius));
`;

const declaration = {
  name: "planck",
  version: versionOf("planck", import.meta.url),
  scalar: "float64",
  frame: "world",
  rotation: "angle",
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

// As a game does it. Then the scaled vertices, of which it takes a face's normal, are judged as such.
function turn(body) {
  body.pose.q = new Rot(body.angle);
}

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
  [a, b].forEach(turn);
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

export { collide, declaration };

if (isProgram(import.meta.url)) serve(declaration, collide);
