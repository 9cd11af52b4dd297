// @box2d/core's b2Collide functions for manifuzz: `manifuzz fuzz --subject-command "node oracle/box2d-core/adapter.mjs"`.
import * as box2d from "@box2d/core";
import { centroidOf, serve, toWorld, versionOf } from "../../scripts/colliders/js/protocol.mjs";

const snippet = `@language js
@point world.points $m, separations $s
import * as box2d from "@box2d/core";
const { b2Vec2 } = box2d;
@each @*.circle? const @* = new box2d.b2CircleShape().Set(@*.unit_vertices(new b2Vec2($X, $Y))@, @*.wide_radius@);
@each @*.segment? const @* = new box2d.b2EdgeShape().SetTwoSided(@*.unit_vertices(new b2Vec2($X, $Y))@);
@each @*.segment? @*.m_radius = @*.wide_radius@;
@each @*.polygon? const @* = Object.assign(new box2d.b2PolygonShape(), { // Set would weld vertices
@each @*.polygon?   m_vertices: [@*.unit_vertices(new b2Vec2($X, $Y))@],
@each @*.polygon?   m_normals: [@*.unit_normals(new b2Vec2($X, $Y))@],
@each @*.polygon?   m_centroid: @*.centroid(new b2Vec2($X, $Y))@, m_count: @*.count@, m_radius: @*.wide_radius@ });
@each const at@^ = new box2d.b2Transform();
@each @*.moved? at@^.p.Set(@*.position($X, $Y)@);
@each @*.turned? at@^.q.Set(Math.atan2(@*.rotation($Y, $X)@));
const manifold = new box2d.b2Manifold(), world = new box2d.b2WorldManifold();
@a.polygon? @b.polygon? box2d.@asked(b2CollidePolygons)@(manifold, a, atA, b, atB);
@a.circle? @b.circle? box2d.@asked(b2CollideCircles)@(manifold, a, atA, b, atB);
@a.segment? @b.polygon? box2d.@asked(b2CollideEdgeAndPolygon)@(manifold, a, atA, b, atB);
@a.segment? @b.circle? box2d.@asked(b2CollideEdgeAndCircle)@(manifold, a, atA, b, atB);
@a.polygon? @b.circle? box2d.@asked(b2CollidePolygonAndCircle)@(manifold, a, atA, b, atB);
@a.polygon? @b.segment? box2d.@asked(b2CollideEdgeAndPolygon)@(manifold, b, atB, a, atA);
@a.circle? @b.segment? box2d.@asked(b2CollideEdgeAndCircle)@(manifold, b, atB, a, atA);
@a.circle? @b.polygon? box2d.@asked(b2CollidePolygonAndCircle)@(manifold, b, atB, a, atA);
@a.polygon? @b.segment? @b_first
@a.circle? @!b.circle? @b_first
@a.segment? world.Initialize(manifold, atA, a.m_radius, atB, b.m_radius);
@a.polygon? @!b.segment? world.Initialize(manifold, atA, a.m_radius, atB, b.m_radius);
@a.circle? @b.circle? world.Initialize(manifold, atA, a.m_radius, atB, b.m_radius);
@a.polygon? @b.segment? world.Initialize(manifold, atB, b.m_radius, atA, a.m_radius);
@a.circle? @!b.circle? world.Initialize(manifold, atB, b.m_radius, atA, a.m_radius);
@a.polygon? @b.polygon? console.log(manifold.pointCount, "points", world, manifold.points.map(({ id }) => id.cf));
@!a.polygon? console.log(manifold.pointCount, "points", world);
@a.polygon? @!b.polygon? console.log(manifold.pointCount, "points", world);
`;

const declaration = {
  name: "box2d-core",
  version: versionOf("@box2d/core", import.meta.url),
  scalar: "float64",
  frame: "world",
  rotation: "angle",
  tie_bias: 0.1 * box2d.b2_linearSlop,
  vertices_max: 8,
  takes_radius: true,
  vertices_min: 1,
  takes_round: true,
  declines: [["capsule", "capsule"], ["rounded", "capsule"], ["rounded", "polygon"], ["rounded", "rounded"]],
  points: "clip",
  normal: "a_to_b",
  snippet,
};

const vectorOf = ({ x, y }) => new box2d.b2Vec2(x, y);

// By an angle, as a game does it. Then the scaled vertices, of which it takes a face's normal, are
// judged as such.
function poseOf({ pose: { p }, angle }) {
  const pose = new box2d.b2Transform();
  pose.p.Copy(p);
  pose.q.Set(angle);
  return pose;
}

// Filled as it stands: b2PolygonShape.Set would weld and reorder.
function polygonOf(body) {
  const shape = new box2d.b2PolygonShape();
  shape.m_vertices = body.vertices.map(vectorOf);
  shape.m_normals = body.normals.map(vectorOf);
  shape.m_count = body.count;
  shape.m_centroid = vectorOf(centroidOf(body.vertices));
  shape.m_radius = body.radius;
  return shape;
}

function shapeOf(body) {
  if (body.count > 2) return polygonOf(body);
  const corners = body.vertices.map(vectorOf);
  if (body.count === 1) return new box2d.b2CircleShape().Set(corners[0], body.radius);
  const edge = new box2d.b2EdgeShape().SetTwoSided(...corners);
  edge.m_radius = body.radius;
  return edge;
}

function worldManifoldOf(manifold, first, second) {
  const world = new box2d.b2WorldManifold();
  world.Initialize(manifold, poseOf(first), first.radius, poseOf(second), second.radius);
  return world;
}

// In the order in which its functions take them: edges, polygons, circles.
const rank = ({ count }) => (count === 1 ? 2 : count === 2 ? 0 : 1);
const collideBy = [
  [null, box2d.b2CollideEdgeAndPolygon, box2d.b2CollideEdgeAndCircle],
  [null, box2d.b2CollidePolygons, box2d.b2CollidePolygonAndCircle],
  [null, null, box2d.b2CollideCircles],
];

// Points are midway between both surfaces; the second's is half of the separation farther.
function collideRound(a, b) {
  const swapped = rank(a) > rank(b);
  const [first, second] = swapped ? [b, a] : [a, b];
  const mitred = [a, b].some(({ count, round }) => count > 2 && round) && a.radius + b.radius > 0;
  if (rank(second) === 0) return { unsupported: "has no edge against edge" };
  if (mitred && rank(second) !== 2) return { unsupported: "its polygons' corners are mitred" };
  const manifold = new box2d.b2Manifold();
  collideBy[rank(first)][rank(second)](
    manifold, shapeOf(first), poseOf(first), shapeOf(second), poseOf(second));
  if (manifold.pointCount === 0) return { points: [] };

  const world = worldManifoldOf(manifold, first, second);
  const { x, y } = world.normal;
  const points = world.points.slice(0, manifold.pointCount).map((midpoint, i) => ({
    position: [
      midpoint.x + (world.separations[i] / 2) * x, midpoint.y + (world.separations[i] / 2) * y],
    depth: Math.max(0, -world.separations[i]),
  }));
  return { points, normal: swapped ? [-x, -y] : [x, y] };
}

// An index that the shape lacks cannot be written: such a point goes without features.
function featuresOf({ id: { cf } }, a, b) {
  if (cf.indexA >= a.count || cf.indexB >= b.count) return {};
  const name = (type, index) => (type === box2d.b2ContactFeatureType.e_face ? "f" : "v") + index;
  return { features: [name(cf.typeA, cf.indexA), name(cf.typeB, cf.indexB)] };
}

function collide(a, b) {
  if (a.round || b.round) return collideRound(a, b);
  const manifold = new box2d.b2Manifold();
  box2d.b2CollidePolygons(manifold, shapeOf(a), poseOf(a), shapeOf(b), poseOf(b));
  if (manifold.pointCount === 0) return { points: [] };

  const world = worldManifoldOf(manifold, a, b);
  const byA = manifold.type === box2d.b2ManifoldType.e_faceA;
  const incident = byA ? b : a;
  const points = manifold.points.slice(0, manifold.pointCount).map((point, i) => ({
    position: toWorld(poseOf(incident), point.localPoint),
    depth: Math.max(0, -world.separations[i]),
    ...featuresOf(point, a, b),
  }));
  return { points, normal: [world.normal.x, world.normal.y], reference: byA ? "a" : "b" };
}

serve(declaration, collide);
