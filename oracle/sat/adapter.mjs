// SAT.js's tests for manifuzz: `manifuzz fuzz --subject-command "node oracle/sat/adapter.mjs"`.
import SAT from "sat";
import { serve, versionOf } from "../../scripts/colliders/js/protocol.mjs";

const snippet = `@language js
import SAT from "sat";

@each @*.circle? const @* = new SAT.Circle(@*.world(new SAT.Vector($X, $Y))@, @*.wide_radius@);
@each @!*.circle? const @* = new SAT.Polygon(new SAT.Vector(), [
@each @!*.circle?   @*.world(new SAT.Vector($X, $Y))@]);
const response = new SAT.Response(); // its overlapN points from A to B
@a.circle? @b.circle? const touch = SAT.@asked(testCircleCircle)@(a, b, response);
@a.circle? @!b.circle? const touch = SAT.@asked(testCirclePolygon)@(a, b, response);
@!a.circle? @b.circle? const touch = SAT.@asked(testPolygonCircle)@(a, b, response);
@!a.circle? @!b.circle? const touch = SAT.@asked(testPolygonPolygon)@(a, b, response);
console.log(touch ? "they touch" : "no contact", response.overlap, response.overlapN);
`;

const declaration = {
  name: "sat",
  version: versionOf("sat", import.meta.url),
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
