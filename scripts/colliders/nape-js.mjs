// Nape's collisions for manifuzz: `manifuzz fuzz --subject-command "node nape-js.mjs"`.
import initNape from "@newkrok/nape-js";
import { serve, versionOf } from "./protocol.mjs";

initNape(); // which leaves `nape` with globalThis
const { callbacks, geom, phys, shape, space } = globalThis.nape;

const snippet = `import initNape from "@newkrok/nape-js";

initNape();
const { callbacks, geom, phys, shape, space } = globalThis.nape;

function bodyOf(type, corners, radius, [x, y], [c, s]) {
  const at = corners.map(([u, v]) => new geom.Vec2(c * u - s * v + x, s * u + c * v + y));
  const body = new phys.Body(type);
  body.get_shapes().add(at.length > 1 ? new shape.Polygon(at) : new shape.Circle(radius, at[0]));
  return body;
}

const still = new space.Space(new geom.Vec2(0, 0));
const a = bodyOf(phys.BodyType.get_STATIC(), @a.vertices[]@, @a.radius@, @a.position[]@, @a.rotation[]@);
const b = bodyOf(phys.BodyType.get_DYNAMIC(), @b.vertices[]@, @b.radius@, @b.position[]@, @b.rotation[]@);
const any = callbacks.CbType.get_ANY_BODY();
const type = callbacks.InteractionType.get_COLLISION();
let found = [];
new callbacks.PreListener(type, any, any, (met) => {
  const arbiter = met.get_arbiter().get_collisionArbiter();
  const contacts = arbiter.get_contacts();
  found = Array.from({ length: contacts.get_length() }, (_, i) => contacts.at(i)).map((contact) =>
    [contact.get_position().toString(), contact.get_penetration()]);
  console.log(arbiter.get_shape1().get_body() === a ? "from A" : "from B", arbiter.get_normal().toString());
}).set_space(still);
for (const body of [a, b]) body.set_space(still);
still.step(1e-9);
console.log(found.length, "points", found);
`;

const declaration = {
  name: "nape-js",
  version: versionOf("@newkrok/nape-js"),
  scalar: "float64",
  frame: "world",
  vertices_max: 8,
  takes_radius: false,
  vertices_min: 1,
  points: "midpoint",
  normal: "a_to_b",
  snippet,
};

function shapeOf({ world, count, radius }) {
  const at = world.map(({ x, y }) => new geom.Vec2(x, y));
  return count === 1 ? new shape.Circle(radius, at[0]) : new shape.Polygon(at);
}

// Its mass is no matter here, but may not be computed of slivers: Nape then has no pair of bodies.
function bodyOf(type, of) {
  const body = new phys.Body(type);
  body.get_shapes().add(shapeOf(of));
  return body;
}

// A new space for each case, stepped until its narrow phase has called.
function contactsOf(a, b) {
  const still = new space.Space(new geom.Vec2(0, 0));
  const [fixed, free] = [phys.BodyType.get_STATIC(), phys.BodyType.get_DYNAMIC()];
  const bodies = [bodyOf(fixed, a), bodyOf(free, b)];
  bodies[1].set_mass(1);
  bodies[1].set_inertia(1);
  const any = callbacks.CbType.get_ANY_BODY();
  let answer = { points: [] };
  const listen = (met) => {
    answer = answerOf(met.get_arbiter().get_collisionArbiter(), bodies[0]);
  };
  const collision = callbacks.InteractionType.get_COLLISION();
  new callbacks.PreListener(collision, any, any, listen).set_space(still);
  for (const body of bodies) body.set_space(still);
  still.step(1e-9);
  return answer;
}

function answerOf(arbiter, bodyA) {
  const contacts = arbiter.get_contacts();
  const points = Array.from({ length: contacts.get_length() }, (_, i) => {
    const contact = contacts.at(i);
    const { x, y } = valueOf(contact.get_position());
    return { position: [x, y], depth: contact.get_penetration() };
  });
  const sign = arbiter.get_shape1().get_body() === bodyA ? 1 : -1;
  const { x, y } = valueOf(arbiter.get_normal());
  return { points, normal: [sign * x, sign * y] };
}

const valueOf = (vector) => ({ x: vector.get_x(), y: vector.get_y() });

function collide(a, b) {
  const lacks = [a, b].find(({ count, radius }) => count === 2 || (count > 2 && radius > 0));
  if (lacks) return { unsupported: "has neither capsules nor polygons with a radius" };
  return contactsOf(a, b);
}

serve(declaration, collide);
