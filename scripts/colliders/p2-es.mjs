// p2's narrowphase for manifuzz: `manifuzz fuzz --subject-command "node p2-es.mjs"`.
import * as p2 from "p2-es";
import { serve, toWorld, versionOf } from "./protocol.mjs";

const snippet = `import * as p2 from "p2-es";

function bodyOf(corners, radius, [x, y], [c, s]) {
  const vertices = corners.map(([u, v]) => [Math.hypot(c, s) * u, Math.hypot(c, s) * v]);
  const body = new p2.Body({ position: [x, y], angle: Math.atan2(s, c) });
  const [[x0, y0], [x1, y1] = [x0, y0]] = vertices;
  if (corners.length > 2) return [body, new p2.Convex({ vertices }), body.position, body.angle];
  body.toWorldFrame(body.position, [(x0 + x1) / 2, (y0 + y1) / 2]);
  body.angle += Math.atan2(y1 - y0, x1 - x0); // a capsule lies along its x axis
  const shape = corners.length === 1
    ? new p2.Circle({ radius })
    : new p2.Capsule({ length: Math.hypot(x1 - x0, y1 - y0), radius });
  return [body, shape, body.position, body.angle];
}

const a = bodyOf(@a.vertices[]@, @a.radius@, @a.position[]@, @a.rotation[]@);
const b = bodyOf(@b.vertices[]@, @b.radius@, @b.position[]@, @b.rotation[]@);
const narrowphase = new p2.Narrowphase();
narrowphase.currentContactMaterial = new p2.ContactMaterial(new p2.Material(), new p2.Material());
const [first, second] = a[1].type > b[1].type ? [b, a] : [a, b];
narrowphase.narrowphases[first[1].type | second[1].type](...first, ...second);
console.log(narrowphase.contactEquations.length, "points");
for (const equation of narrowphase.contactEquations) {
  const { bodyA, normalA, contactPointA, contactPointB } = equation; // relative to the bodies
  console.log(bodyA === a[0] ? "from A" : "from B", normalA, contactPointA, contactPointB);
}
`;

const declaration = {
  name: "p2-es",
  version: versionOf("p2-es"),
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

// A capsule lies along its x axis, about its middle.
function capsuleOf({ vertices: [from, to], radius, pose }) {
  const [x, y] = [to.x - from.x, to.y - from.y];
  const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  const angle = Math.atan2(y, x) + Math.atan2(pose.q.s, pose.q.c);
  const length = Math.sqrt(x * x + y * y);
  return { body: bodyAt(toWorld(pose, middle), angle), shape: new p2.Capsule({ length, radius }) };
}

function convexOf({ vertices, pose }) {
  const shape = new p2.Convex({ vertices: vertices.map(({ x, y }) => [x, y]) });
  return { body: bodyAt([pose.p.x, pose.p.y], Math.atan2(pose.q.s, pose.q.c)), shape };
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
