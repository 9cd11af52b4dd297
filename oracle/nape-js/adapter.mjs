// Nape's collisions for manifuzz: `manifuzz fuzz --subject-command "node oracle/nape-js/adapter.mjs"`.
import initNape from "@newkrok/nape-js";
import { serve, versionOf } from "../../scripts/colliders/js/protocol.mjs";

globalThis.window = globalThis; // where it leaves `nape`
initNape();
const { callbacks, geom, phys, shape, space } = globalThis.nape;

const snippet = `@language js
@point position $m, penetration $d
import initNape from "@newkrok/nape-js";
globalThis.window = globalThis, initNape(); // it leaves nape in a window
const { callbacks, geom: { Vec2 }, phys: { Body, BodyType }, shape, space } = globalThis.nape;
const a = new Body(BodyType.get_STATIC(), @a.position(new Vec2($X, $Y))@);
const b = new Body(BodyType.get_DYNAMIC(), @b.position(new Vec2($X, $Y))@);
@each @*.turned? @*.set_rotation(Math.atan2(@*.rotation($Y, $X)@));
@each @*.circle? @*.get_shapes().add(new shape.Circle(@*.wide_radius@, @*.unit_vertices(new Vec2($X, $Y))@));
@each @!*.circle? @*.get_shapes().add(new shape.Polygon([@*.unit_vertices(new Vec2($X, $Y))@]));
b.set_mass(1), b.set_inertia(1); // of a sliver it would compute none
const still = new space.Space(new Vec2(0, 0)), any = callbacks.CbType.get_ANY_BODY(), collision = callbacks.InteractionType.get_COLLISION();
let found = "0 points";
new callbacks.PreListener(collision, any, any, (met) => {
  const arbiter = met.get_arbiter().get_collisionArbiter(), contacts = arbiter.get_contacts();
  found = contacts.get_length() + " points, normal " + arbiter.get_normal();
  contacts.foreach((at) => { found += ", " + at.get_position() + " " + at.get_penetration(); });
}).set_space(still);
for (const body of [a, b]) body.set_space(still);
still.@asked(step)@(1e-9), console.log(found);
`;

const declaration = {
  name: "nape-js",
  version: versionOf("@newkrok/nape-js", import.meta.url),
  scalar: "float64",
  frame: "world",
  rotation: "angle",
  vertices_max: 8,
  takes_radius: false,
  vertices_min: 1,
  // ZPP_Polygon.valid: degenerate where area < nape.Config.epsilon, of the corners that are kept.
  least_polygon: { area: 1e-8 },
  declines: [["capsule", "circle"], ["capsule", "capsule"], ["capsule", "polygon"]],
  points: "midpoint",
  normal: "a_to_b",
  snippet,
};

function shapeOf({ vertices, count, radius }) {
  const corners = vertices.map(({ x, y }) => new geom.Vec2(x, y));
  return count === 1 ? new shape.Circle(radius, corners[0]) : new shape.Polygon(corners);
}

// At an angle: its normals are those of a polygon's own corners, turned.
function bodyOf(type, of) {
  const { p } = of.pose;
  const body = new phys.Body(type, new geom.Vec2(p.x, p.y));
  body.set_rotation(of.angle);
  body.get_shapes().add(shapeOf(of));
  return body;
}

const any = callbacks.CbType.get_ANY_BODY();
const collision = callbacks.InteractionType.get_COLLISION();

// A new space for each case: one that is used again may leave points out. Only one of the bodies
// may be fixed; the other's mass is given, lest it be computed, of a sliver as 0.
function contactsOf(bodies) {
  bodies[1].set_mass(1);
  bodies[1].set_inertia(1);
  let answer = { points: [] };
  const still = new space.Space(new geom.Vec2(0, 0));
  const listener = new callbacks.PreListener(collision, any, any, (met) => {
    answer = answerOf(met.get_arbiter().get_collisionArbiter(), bodies[0]);
    return null;
  });
  for (const part of [listener, ...bodies]) part.set_space(still);
  still.step(1e-9);
  for (const part of [listener, ...bodies]) part.set_space(null); // else each makes the next slower
  return answer;
}

// A point across a gap is there for its solver of positions alone.
function answerOf(arbiter, bodyA) {
  const contacts = arbiter.get_contacts();
  const points = Array.from({ length: contacts.get_length() }, (_, i) => {
    const contact = contacts.at(i);
    const { x, y } = valueOf(contact.get_position());
    return { position: [x, y], depth: contact.get_penetration() };
  }).filter(({ depth }) => !(depth < 0));
  const sign = arbiter.get_shape1().get_body() === bodyA ? 1 : -1;
  const { x, y } = valueOf(arbiter.get_normal());
  return points.length > 0 ? { points, normal: [sign * x, sign * y] } : { points };
}

const valueOf = (vector) => ({ x: vector.get_x(), y: vector.get_y() });

const [STATIC, DYNAMIC] = [phys.BodyType.get_STATIC(), phys.BodyType.get_DYNAMIC()];

const polygonOf = (body) => body.get_shapes().at(0).get_castPolygon();

function isValid(body) {
  const polygon = polygonOf(body);
  return polygon === null || polygon.validity() === shape.ValidationResult.get_VALID();
}

// It drops corners that lie together or on a line, each within 1e-8: those that it has kept.
function keptOf({ vertices, stored }, body) {
  const kept = polygonOf(body)?.get_localVerts();
  const corners = kept && Array.from({ length: kept.get_length() }, (_, i) => valueOf(kept.at(i)));
  const has = ({ x, y }) => !corners || corners.some((corner) => corner.x === x && corner.y === y);
  return stored.vertices.filter((_, i) => has(vertices[i])).map(({ x, y }) => [x, y]);
}

function collide(a, b) {
  const lacks = [a, b].find(({ count, radius }) => count === 2 || (count > 2 && radius > 0));
  if (lacks) return { unsupported: "has neither capsules nor polygons with a radius" };
  const bodies = [bodyOf(STATIC, a), bodyOf(DYNAMIC, b)];
  if (!bodies.every(isValid)) return { unsupported: "takes no such polygon: its validity() is none" };
  const shapes = { a: keptOf(a, bodies[0]), b: keptOf(b, bodies[1]) };
  const altered = shapes.a.length < a.count || shapes.b.length < b.count;
  return altered ? { ...contactsOf(bodies), shapes } : contactsOf(bodies);
}

serve(declaration, collide);
