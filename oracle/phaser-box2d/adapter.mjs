// phaser-box2d's b2Collide functions for manifuzz: `manifuzz fuzz --subject-command "node oracle/phaser-box2d/adapter.mjs"`.
import {
  b2Capsule, b2Circle, b2CollideCapsuleAndCircle, b2CollideCapsules, b2CollideCircles,
  b2CollidePolygonAndCapsule, b2CollidePolygonAndCircle, b2CollidePolygons, b2Manifold, b2Polygon,
} from "phaser-box2d/dist/PhaserBox2D.js";
import { serve, versionOf } from "../../scripts/colliders/js/protocol.mjs";

const snippet = `@language js
@point point $m, separation $s
@none no point of a separation of 0 or less
import * as phaser from "phaser-box2d/dist/PhaserBox2D.js";

@each @*.circle? const @* = Object.assign(new phaser.b2Circle(), {
@each @*.circle?   center: @*.unit_vertices({ x: $X, y: $Y })@, radius: @*.wide_radius@ });
@each @*.segment? const @* = Object.assign(new phaser.b2Capsule(), { radius: @*.wide_radius@ });
@each @*.segment? [@*.center1, @*.center2] = [@*.unit_vertices({ x: $X, y: $Y })@];
@each @*.polygon? const @* = Object.assign(new phaser.b2Polygon(), { // b2ComputeHull would weld vertices
@each @*.polygon?   vertices: [@*.unit_vertices({ x: $X, y: $Y })@],
@each @*.polygon?   normals: [@*.unit_normals({ x: $X, y: $Y })@], count: @*.count@, radius: @*.wide_radius@ });
@each const at@^ = { p: { @*.position(x: $X, y: $Y)@ }, q: { @*.unit_rotation(c: $X, s: $Y)@ } };
const manifold = new phaser.b2Manifold();
@a.polygon? @b.polygon? phaser.@asked(b2CollidePolygons)@(a, atA, b, atB, manifold);
@a.segment? @b.segment? phaser.@asked(b2CollideCapsules)@(a, atA, b, atB, manifold);
@a.circle? @b.circle? phaser.@asked(b2CollideCircles)@(a, atA, b, atB, manifold);
@a.polygon? @b.segment? phaser.@asked(b2CollidePolygonAndCapsule)@(a, atA, b, atB, manifold);
@a.polygon? @b.circle? phaser.@asked(b2CollidePolygonAndCircle)@(a, atA, b, atB, manifold);
@a.segment? @b.circle? phaser.@asked(b2CollideCapsuleAndCircle)@(a, atA, b, atB, manifold);
@a.segment? @b.polygon? phaser.@asked(b2CollidePolygonAndCapsule)@(b, atB, a, atA, manifold);
@a.circle? @b.polygon? phaser.@asked(b2CollidePolygonAndCircle)@(b, atB, a, atA, manifold);
@a.circle? @b.segment? phaser.@asked(b2CollideCapsuleAndCircle)@(b, atB, a, atA, manifold);
@a.segment? @b.polygon? @b_first
@a.circle? @!b.circle? @b_first
console.log(manifold.pointCount, "points, normal", [manifold.normalX, manifold.normalY], manifold);
`;

const declaration = {
  name: "phaser-box2d",
  version: versionOf("phaser-box2d", import.meta.url),
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
