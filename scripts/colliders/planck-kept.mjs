// planck's clips of polygons, kept from frame to frame, for manifuzz:
// `manifuzz fuzz --subject-command "node planck-kept.mjs" --sequences`.
import { keeping, KeptPoints } from "./kept-points.mjs";
import { collide, declaration } from "./planck.mjs";
import { serveSequences } from "./protocol.mjs";

serveSequences({
  ...declaration, name: "planck-kept", vertices_min: 3, takes_round: false, declines: [], snippet: "",
  keeping,
}, () => {
  const kept = new KeptPoints();
  return (a, b) => kept.next(a, b, collide(a, b));
});
