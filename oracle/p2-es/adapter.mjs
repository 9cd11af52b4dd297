// p2's narrowphase for manifuzz: `manifuzz fuzz --subject-command "node oracle/p2-es/adapter.mjs"`.
import * as p2 from "p2-es";
import { serve, toWorld, versionOf } from "../../scripts/colliders/js/protocol.mjs";

const snippet = `@language js
@point in the world contactPointB $p, gap $s
@!a.circle? @b.circle? @b_first
import * as p2 from "p2-es";
@each @*.polygon? const @* = new p2.Convex({ vertices: [@*.vertices([$X, $Y])@] });
@each @*.polygon? const body@^ = new p2.Body({ position: [@*.position($X, $Y)@], angle: Math.atan2(@*.rotation($Y, $X)@) });
@each @*.circle? const @* = new p2.Circle({ radius: @*.wide_radius@ });
@each @*.circle? const body@^ = new p2.Body({ position: @*.world([$X, $Y])@ });
@each @*.segment? const of@^ = [@*.world([$X, $Y])@]; // a capsule lies along its x axis
@each @*.segment? const @* = new p2.Capsule({ length: Math.hypot(of@^[1][0] - of@^[0][0], of@^[1][1] - of@^[0][1]), radius: @*.wide_radius@ });
@each @*.segment? const body@^ = new p2.Body({ position: [(of@^[0][0] + of@^[1][0]) / 2, (of@^[0][1] + of@^[1][1]) / 2],
@each @*.segment?   angle: Math.atan2(of@^[1][1] - of@^[0][1], of@^[1][0] - of@^[0][0]) });
const narrowphase = new p2.Narrowphase();
narrowphase.currentContactMaterial = new p2.ContactMaterial(new p2.Material(), new p2.Material());
const [first, second] = [[bodyA, a], [bodyB, b]].sort(([, p], [, q]) => p.type - q.type)
  .map(([body, shape]) => [body, shape, body.position, body.angle]);
narrowphase.@asked(narrowphases)@[a.type | b.type](...first, ...second);
const gapOf = ({ bodyA, bodyB, normalA, contactPointA, contactPointB }) => p2.vec2.dot(normalA, // as computeB has it
  bodyB.position.map((x, k) => x + contactPointB[k] - bodyA.position[k] - contactPointA[k]));
const inWorld = (body, place) => Array.from(body.position, (x, k) => x + place[k]); // not rounded to floats
console.log(narrowphase.contactEquations.length, "points", narrowphase.contactEquations.map((of) => [
  of.bodyA === bodyA ? "A to B" : "B to A", of.normalA, // from its own body A
  inWorld(of.bodyA, of.contactPointA), inWorld(of.bodyB, of.contactPointB), "gap", gapOf(of)]));
`;

const declaration = {
  name: "p2-es",
  version: versionOf("p2-es", import.meta.url),
  scalar: "float32", // its vectors are Float32Arrays
  frame: "world",
  rotation: "angle",
  vertices_max: 8,
  takes_radius: false,
  vertices_min: 1,
  declines: [["capsule", "capsule"], ["capsule", "polygon"]],
  points: "clip",
  normal: "a_to_b",
  snippet,
};

const bodyAt = (position, angle) => new p2.Body({ position, angle });

// Vertices go as they are stored: what the rotation is short of unit, no float holds.
// A capsule lies along its x axis, about its middle.
function capsuleOf({ stored: { vertices: [from, to] }, radius, pose, angle }) {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  const length = Math.sqrt(x * x + y * y);
  return { body: bodyAt(toWorld(pose, middle), Math.atan2(y, x) + angle), shape: new p2.Capsule({ length, radius }) };
}

function convexOf({ stored, pose: { p }, angle }) {
  const shape = new p2.Convex({ vertices: stored.vertices.map(({ x, y }) => [x, y]) });
  return { body: bodyAt([p.x, p.y], angle), shape };
}

function placedOf(body) {
  if (body.count > 2) return convexOf(body);
  if (body.count === 2) return capsuleOf(body);
  const shape = new p2.Circle({ radius: body.radius });
  return { body: bodyAt([body.world[0].x, body.world[0].y], 0), shape };
}

// Of vertices that rounding to floats has made clockwise it makes no Convex, and throws.
function placedOrNull(body) {
  try {
    return placedOf(body);
  } catch {
    return null;
  }
}

function whyNot(a, b) {
  if ([a, b].some(({ count, radius }) => count > 2 && radius > 0)) return "has no rounded polygons";
  if ([a, b].every(({ count }) => count > 1) && (a.count === 2 || b.count === 2)) {
    return "has several contacts of capsules, each with a normal of its own";
  }
  return null;
}

function collide(a, b) {
  const unsupported = whyNot(a, b);
  if (unsupported) return { unsupported };
  const [placedA, placedB] = [placedOrNull(a), placedOrNull(b)];
  if (!placedA || !placedB) return { unsupported: "its Convex is not counter-clockwise in floats" };
  const swapped = placedA.shape.type > placedB.shape.type;
  const [first, second] = swapped ? [placedB, placedA] : [placedA, placedB];
  const narrowphase = new p2.Narrowphase();
  narrowphase.currentContactMaterial = new p2.ContactMaterial(new p2.Material(), new p2.Material());
  narrowphase.narrowphases[first.shape.type | second.shape.type](
    first.body, first.shape, first.body.position, first.body.angle,
    second.body, second.shape, second.body.position, second.body.angle);
  return answerOf(narrowphase.contactEquations, placedA.body);
}

// Of polygons contactPointA is on the reference face, contactPointB on the edge that it clips.
function answerOf(equations, bodyA) {
  const points = equations.map((equation) => {
    const { bodyB, contactPointB } = equation;
    const [x, y] = contactPointB;
    return { position: [bodyB.position[0] + x, bodyB.position[1] + y], depth: depthOf(equation) };
  });
  if (points.length === 0) return { points };
  const [{ bodyA: reference, normalA }] = equations;
  const sign = reference === bodyA ? 1 : -1;
  const normal = [sign * normalA[0], sign * normalA[1]];
  return { points, normal, reference: sign === 1 ? "a" : "b" };
}

// As ContactEquation.computeB has it: the gap between both points, along the normal, that the
// solver closes.
function depthOf({ bodyA, bodyB, normalA, contactPointA, contactPointB }) {
  const [x, y] = [0, 1].map((k) =>
    Math.fround(bodyB.position[k] + contactPointB[k] - bodyA.position[k] - contactPointA[k]));
  return Math.max(0, -p2.vec2.dot(normalA, [x, y]));
}

serve(declaration, collide);
