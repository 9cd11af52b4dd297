// Rapier's colliders of a case, for both of its adapters. It computes in float.
import { readFileSync } from "node:fs";

import { versionOf } from "../../scripts/colliders/js/protocol.mjs";

// Up to 0.17 the package names a file for node that node cannot read.
const { default: RAPIER } = await import("@dimforge/rapier2d-compat").catch(
  () => import("@dimforge/rapier2d-compat/rapier.es.js"));
await RAPIER.init();
const { ActiveCollisionTypes, ColliderDesc, RigidBodyDesc, World } = RAPIER;

// `ask` prints how many points there are, and them.
export const snippetThat = (ask) => `@language js
@none no point of a distance of 0 or less
import RAPIER from "@dimforge/rapier2d-compat"; await RAPIER.init();
const { ColliderDesc, RigidBodyDesc } = RAPIER, world = new RAPIER.World({ x: 0, y: 0 });
@each @*.circle? const of@^ = ColliderDesc.ball(@*.radius@).setTranslation(@*.vertices($x, $y)@);
@each @*.segment? @!*.rounded? const of@^ = ColliderDesc.segment(@*.vertices({ x: $x, y: $y })@);
@each @*.segment? @*.rounded? const [p@^, q@^] = [@*.vertices({ x: $x, y: $y })@]; // a capsule lies along y
@each @*.segment? @*.rounded? const of@^ = ColliderDesc.capsule(Math.hypot(q@^.x - p@^.x, q@^.y - p@^.y) / 2, @*.radius@).setTranslation((p@^.x + q@^.x) / 2, (p@^.y + q@^.y) / 2).setRotation(Math.atan2(p@^.x - q@^.x, q@^.y - p@^.y));
@each @*.polygon? @!*.rounded? const of@^ = ColliderDesc.convexPolyline(new Float32Array([@*.vertices($x, $y)@]));
@each @*.polygon? @*.rounded? const of@^ = ColliderDesc.roundConvexPolyline(new Float32Array([@*.vertices($x, $y)@]), @*.radius@);
const bodyA = RigidBodyDesc.fixed().setTranslation(@a.position($x, $y)@).setRotation(Math.atan2(@a.rotation($y, $x)@));
const bodyB = RigidBodyDesc.kinematicPositionBased().setTranslation(@b.position($x, $y)@).setRotation(Math.atan2(@b.rotation($y, $x)@));
const [a, b] = [[ofA, bodyA], [ofB, bodyB]].map(([of, body]) =>
  world.createCollider(of.setActiveCollisionTypes(RAPIER.ActiveCollisionTypes.ALL), world.createRigidBody(body)));
${ask}`;

// What its ledger cites: a release of Rapier does not say which parry it holds.
const { cited_as: parry } = JSON.parse(readFileSync(new URL("engine.json", import.meta.url), "utf8"));

export const declaration = {
  version: versionOf("@dimforge/rapier2d-compat", import.meta.url),
  scalar: "float32",
  frame: "world", // a circle's centre is placed there
  rotation: "angle",
  vertices_max: 8,
  takes_radius: false,
  vertices_min: 1,
  takes_round: true,
  // Rapier makes none of fewer than three corners whose normals' product is at most 1 - sqrt(2^-23)
  // (parry2d, src/shape/convex_polygon.rs, from_convex_polyline): that of an angle of 0.02628.
  least_polygon: { turn: 0.0263 },
  clips: false,
  points: "surface_a",
  alters_shapes: true,
  normal: "a_to_b",
  tolerance: {
    absolute: 100 * 2 ** -23,
    source: `${parry}, src/query/epa/epa2.rs, closest_points: max_dist - curr_dist < _eps_tol`,
  },
};

// As its own frame has it: where the body is, how it is turned, and a length along its first axis.
function framed(desc, position, angle, { x, y }, turn) {
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const turned = (p) => ({ x: c * p.x - s * p.y, y: s * p.x + c * p.y });
  const toCase = (p) => ({ x: turned(p).x + x, y: turned(p).y + y });
  return { desc, position, angle, turned, toCase };
}

const none = { x: 0, y: 0 };

function polygonOf({ stored, radius, pose }) {
  const flat = new Float32Array(stored.vertices.flatMap(({ x, y }) => [x, y]));
  const desc = radius > 0
    ? ColliderDesc.roundConvexPolyline(flat, radius)
    : ColliderDesc.convexPolyline(flat);
  return framed(desc, pose.p, angleOf(stored), none, 0);
}

const angleOf = ({ rotation: { c, s } }) => Math.atan2(s, c);

// A circle's frame is that of the world; a capsule lies along its y axis, about its middle.
function circleOf({ stored, radius, world }) {
  return framed(ColliderDesc.ball(radius), world[0], 0, stored.vertices[0], -angleOf(stored));
}

function capsuleOf({ stored, radius, world: [from, to], pose }) {
  const [p, q] = stored.vertices;
  if (radius === 0) return framed(ColliderDesc.segment(p, q), pose.p, angleOf(stored), none, 0);
  const turn = Math.atan2(p.x - q.x, q.y - p.y);
  const desc = ColliderDesc.capsule(Math.hypot(q.x - p.x, q.y - p.y) / 2, radius);
  const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
  const inCase = { x: (p.x + q.x) / 2, y: (p.y + q.y) / 2 };
  return framed(desc, middle, turn + angleOf(stored), inCase, turn);
}

const kinds = [circleOf, capsuleOf];

// Of a polygon it drops corners that turn by little, and makes none of what is left if that is two.
function isTaken({ desc }) {
  const made = desc.shape.intoRaw();
  made?.free();
  return made !== undefined;
}

// A new world for each case, with a body that is fixed and one that is not: its narrow phase leaves
// out two fixed ones. `shapes`: the vertices that a polygon has kept.
export function collidersOf(a, b, use) {
  const placed = [a, b].map((body) => (kinds[body.count - 1] ?? polygonOf)(body));
  if (!placed.every(isTaken)) return { unsupported: "it makes no polygon of three of its corners" };
  const world = new World({ x: 0, y: 0 });
  world.timestep = 0;
  try {
    const colliders = placed.map(({ desc, position, angle }, i) => {
      const fixed = i === 0 ? RigidBodyDesc.fixed() : RigidBodyDesc.kinematicPositionBased();
      const body = fixed.setTranslation(position.x, position.y).setRotation(angle);
      desc.setActiveCollisionTypes(ActiveCollisionTypes.ALL);
      return world.createCollider(desc, world.createRigidBody(body));
    });
    const [ofA, ofB] = [a, b].map((body, i) => usedBy(body, colliders[i]));
    return { ...use(world, colliders, placed), shapes: { a: ofA, b: ofB } };
  } finally {
    world.free();
  }
}

function usedBy({ stored, count }, collider) {
  if (count < 3) return stored.vertices.map(({ x, y }) => [x, y]);
  const flat = [...collider.vertices()];
  return flat.filter((_, i) => i % 2 === 0).map((x, i) => [x, flat[2 * i + 1]]);
}
