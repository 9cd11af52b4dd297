// What each step says, and what the answers are.

const times = (count, one) => `${count} ${one}${count === 1 ? "" : "s"}`;
const featureName = ({ isFace, index }) => `${isFace ? "face" : "vertex"} ${index}`;

function separationTable(told) {
  const rows = SIDES.flatMap((side) => told.sides[side].faces.map((face, i) => ({ side, i, ...face, isGreatest: i === told.sides[side].greatest })));
  if (rows.length === 0) return null;
  return table("The separation of each face", [
    ["face", ({ side, i }) => `${nameOf(side)} face ${i}`],
    ["separation", ({ separation, isGreatest }) => element(isGreatest ? "b" : "span", {}, brief(separation)), "number"],
    ["deepest vertex", ({ side, deepest }) => `${nameOf(otherSide(side))} vertex ${deepest}`],
  ], rows);
}

function greatestInWords(told) {
  return SIDES.filter((side) => told.sides[side].greatest >= 0).map((side) => {
    const { faces, greatest } = told.sides[side];
    return `${nameOf(side)}'s greatest is ${brief(faces[greatest].separation)}, of face ${greatest}`;
  }).join("; ");
}

function apartInWords(told) {
  return `They are ${brief(told.separation)} apart, and the radii reach ${brief(told.totalRadius)}: there is no contact, and nothing follows.`;
}

function separationInWords(told) {
  if (told.nearest.isThere) {
    const [onA, onB] = told.nearest.features.map(featureName);
    return `The cores are apart, so the separation is between their nearest places: A's ${onA} and B's ${onB}, ${brief(told.separation)} apart.`;
  }
  const start = "The separation of a face is the signed distance to the other shape's deepest vertex; below 0 they overlap along it.";
  return `${start} ${greatestInWords(told)}.`;
}

function sideClipInWords(told, i) {
  const clip = told.sideClips[i];
  if (i === 1 && !told.sideClips[0].leaves) return "The first clip left nothing.";
  const plane = `The plane through the ${i === 0 ? "first" : "second"} end of the reference face`
    + (told.margin > 0 ? `, moved out by ${brief(told.margin)},` : "");
  if (!clip.leaves) return `${plane} cuts off all of the incident edge: the clip has no points.`;
  const before = i === 0 ? told.whole : told.sideClips[0].edge;
  const cut = clip.edge.findIndex(({ at }, j) => at[0] !== before[j].at[0] || at[1] !== before[j].at[1]);
  return cut < 0 ? `${plane} cuts nothing off.` : `${plane} cuts off the end at ${featureName(before[cut].incident)}; the crossing takes its place.`;
}

function lastClipInWords(told) {
  if (!told.sideClips[1].leaves) return "The side planes left nothing to keep.";
  const ends = told.inFront.map((inFront) => told.totalRadius - inFront);
  const kept = ends.filter((depth) => depth >= 0);
  return `What lies behind the reference face is kept, each with its own depth: ${kept.length === 0 ? "no end" : kept.map(brief).join(" and ")}`
    + (kept.length === 1 ? "; the other end is in front of it." : ".");
}

function contactInWords(told) {
  const [clip] = told.answers;
  if (clip.count === 0) return "There is no contact.";
  const start = `clip64 gives ${times(clip.count, "point")}.`;
  return told.isReplaced ? `${start} It is not what these clips keep: that misses the deepest vertex, or is less than round shapes have.` : start;
}

function stepInWords(told, step) {
  if (step === 0) return separationInWords(told);
  if (step === LAST_STEP) return told.way === "apart" ? apartInWords(told) : contactInWords(told);
  if (told.way === "apart") return apartInWords(told);
  if (told.way === "circle") {
    return "A circle's feature is one point, the farthest along the normal: there is no edge to clip, and that point is the contact.";
  }
  if (!told.features.isThere) return "One of them gives an end, and not an edge: nothing is clipped, and where they are nearest is the contact.";
  const { side, reference, incident } = told.features;
  if (step === 1) {
    const why = told.nearest.isThere ? "its edge is the more perpendicular to the normal"
      : told.sides.a.greatest < 0 || told.sides.b.greatest < 0 ? "it is the only one" : `its separation is the greater of both${side === "a" ? ", or equal" : ""}`;
    return `The reference is ${nameOf(side)}'s face ${reference}: ${why}. Its normal is the contact's.`;
  }
  if (step === 2) return `The incident edge is ${nameOf(otherSide(side))}'s edge ${incident}: of all its normals this one points most against the reference's.`;
  return step === 5 ? lastClipInWords(told) : sideClipInWords(told, step - 3);
}

function answerBlock(told, i) {
  const [name, css] = [["clip64", "subject"], ["gjk64", "oracle"]][i];
  const answer = told.answers[i];
  const verdict = answer.isRight ? "right" : `wrong: ${answer.bucket.split("/")[2].replaceAll("_", " ")}, by ${brief(answer.magnitude)} of the size`;
  const head = element("h3", {}, element("i", { class: `sign-of ${css}`, "aria-hidden": "true" }), `${name}: ${times(answer.count, "point")}, `,
    element("span", { class: answer.isRight ? "right" : "bad" }, verdict));
  if (answer.count === 0) return element("div", { class: "answer" }, head);
  const rows = answer.points.map((point, j) => ({ ...point, j }));
  const columns = [
    ["point", ({ features: [a, b] }) => `A ${featureName(a)}, B ${featureName(b)}`],
    ["x, y", ({ world }) => world.map(brief).join(", "), "number"],
    ["depth", ({ depth }) => brief(depth), "number"],
  ];
  return element("div", { class: "answer" }, head, element("p", { class: "quiet" }, `normal ${answer.normal.map(brief).join(", ")}`),
    table(`Contact points of ${name}`, columns, rows));
}

function standingInWords(told) {
  const amount = brief(Math.abs(told.separation));
  if (told.separation > 0) return `${told.isTouching ? "They touch" : "They are apart"}: the separation is ${amount}, the radii reach ${brief(told.totalRadius)}`;
  return `They overlap: the separation is ${brief(told.separation)}`;
}
