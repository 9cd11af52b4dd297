// Rapier's contact manifolds for manifuzz: `manifuzz fuzz --subject-command "node oracle/rapier/manifold.mjs"`.
import { serve, toWorld } from "../../scripts/colliders/js/protocol.mjs";
import { collidersOf, declaration, snippetThat } from "./bodies.mjs";

const snippet = snippetThat(`@figures by way of A's frame, so to a few roundings of the largest
@point in the world on A $a, contactDist $s
world.timestep = 0, world.step();
let found = ["0 points"];
const onA = ({ x, y }, at = a.translation(), c = Math.cos(a.rotation()), s = Math.sin(a.rotation())) => [c * x - s * y + at.x, s * x + c * y + at.y];
world.@asked(contactPair)@(a, b, (m, flipped) => { // flipped: 1 is B, 2 is A
  const points = [0, 1].slice(0, m.numContacts()).map((i) => [onA(flipped ? m.localContactPoint2(i) : m.localContactPoint1(i)), m.contactDist(i)]);
  found = [points.filter(([, dist]) => dist <= 0).length + " points", points, flipped ? "B to A" : "A to B", m.normal()];
});
console.log(...found);
`);

const manifold = {
  ...declaration,
  name: "rapier2d",
  claims: "manifold",
  snippet,
  one_point_enough: true, // of capsules at an angle of more than 22.5 degrees
};

// Its narrow phase may have turned the pair about. Points across a gap are there for its solver.
function answerOf(world, [a, b], [placed], { pose }) {
  world.step();
  let answer = { points: [] };
  world.contactPair(a, b, (found, flipped) => {
    const local = (i) => (flipped ? found.localContactPoint2(i) : found.localContactPoint1(i));
    const outward = flipped ? found.localNormal2() : found.localNormal1();
    const points = Array.from({ length: found.numContacts() }, (_, i) => i)
      .filter((i) => !(found.contactDist(i) > 0))
      .map((i) => ({ local: pairOf(placed.toCase(local(i))), depth: -found.contactDist(i) }));
    const normal = toWorld({ p: { x: 0, y: 0 }, q: pose.q }, placed.turned(outward));
    if (points.length > 0) answer = { points, normal };
  });
  return answer;
}

const pairOf = ({ x, y }) => [x, y];

serve(manifold, (a, b) => collidersOf(a, b, (...made) => answerOf(...made, a)));
