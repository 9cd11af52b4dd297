// Rapier's contactCollider for manifuzz: `manifuzz fuzz --subject-command "node oracle/rapier/contact.mjs"`.
import { serve } from "../../scripts/colliders/js/protocol.mjs";
import { collidersOf, declaration, snippetThat } from "./bodies.mjs";

const snippet = snippetThat(`@point point1 $a, distance $s
const contact = a.@asked(contactCollider)@(b, 0);
console.log(contact === null ? "0 points" : "1 points", contact);
`);

const contact = { ...declaration, name: "rapier2d-contact", claims: "point", snippet };

function answerOf(_, [a, b]) {
  const found = a.contactCollider(b, 0);
  if (found === null || found.distance > 0) return { points: [] };
  const { distance, point1, normal1 } = found;
  const points = [{ position: [point1.x, point1.y], depth: -distance }];
  return { points, normal: [normal1.x, normal1.y] };
}

serve(contact, (a, b) => collidersOf(a, b, answerOf));
