// planck's clips of polygons, kept from frame to frame, for manifuzz:
// `manifuzz fuzz --subject-command "node oracle/planck/kept.mjs" --sequences`.
import { keeping, KeptPoints } from "../../scripts/colliders/js/kept-points.mjs";
import { collide, declaration } from "./adapter.mjs";
import { serveSequences } from "../../scripts/colliders/js/protocol.mjs";

serveSequences({
  ...declaration, name: "planck-kept", vertices_min: 3, takes_round: false, declines: [], snippet: "",
  keeping,
}, () => {
  const kept = new KeptPoints();
  return (a, b) => kept.next(a, b, collide(a, b));
});
