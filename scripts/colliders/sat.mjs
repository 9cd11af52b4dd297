// SAT.js's tests for manifuzz: `manifuzz fuzz --subject-command "node sat.mjs"`.
import SAT from "sat";
import { serve, versionOf } from "./protocol.mjs";

const snippet = `import SAT from "sat";

function shapeOf(corners, radius, [x, y], [c, s]) {
  const at = corners.map(([u, v]) => new SAT.Vector(c * u - s * v + x, s * u + c * v + y));
  return at.length === 1 ? new SAT.Circle(at[0], radius) : new SAT.Polygon(new SAT.Vector(), at);
}

const a = shapeOf(@a.vertices[]@, @a.radius@, @a.position[]@, @a.rotation[]@);
const b = shapeOf(@b.vertices[]@, @b.radius@, @b.position[]@, @b.rotation[]@);
const kind = (shape) => (shape instanceof SAT.Circle ? "Circle" : "Polygon");
const response = new SAT.Response(); // its overlapN points from A to B
const touch = SAT["test" + kind(a) + kind(b)](a, b, response);
console.log(touch ? "they touch" : "no contact", response.overlap, response.overlapN);
`;

const declaration = {
  name: "sat",
  version: versionOf("sat"),
  scalar: "float64",
  frame: "world",
  vertices_max: 8,
  takes_radius: false,
  vertices_min: 1,
  declines: [["capsule", "circle"], ["capsule", "capsule"], ["capsule", "polygon"]],
  claims: "separation",
  normal: "a_to_b",
  snippet,
};

function shapeOf({ world, count, radius }) {
  const at = world.map(({ x, y }) => new SAT.Vector(x, y));
  return count === 1 ? new SAT.Circle(at[0], radius) : new SAT.Polygon(new SAT.Vector(), at);
}

const testBy = [
  [SAT.testPolygonPolygon, SAT.testPolygonCircle],
  [SAT.testCirclePolygon, SAT.testCircleCircle],
];

function collide(a, b) {
  const lacks = [a, b].find(({ count, radius }) => count === 2 || (count > 2 && radius > 0));
  if (lacks) return { unsupported: "has neither capsules nor polygons with a radius" };
  const response = new SAT.Response();
  const touch = testBy[+(a.count === 1)][+(b.count === 1)](shapeOf(a), shapeOf(b), response);
  if (!touch) return { touching: false };
  const { overlap, overlapN } = response;
  return { normal: [overlapN.x, overlapN.y], depth: overlap };
}

serve(declaration, collide);
