// What stands beside the picture of a case, and what its tooltips say.

function worldOf(one, point) {
  return isPoint(point) ? [one.origin[0] + point[0], one.origin[1] + point[1]] : point;
}

function featureWords(features) {
  return (features ?? []).map((feature, i) => feature && `${"AB"[i]} ${feature}`).filter(Boolean).join(", ");
}

function describePoint(one, role, index, right) {
  const answer = answerOf(one, role);
  const manifold = answer.manifolds[role === "truth" ? right : 0];
  const point = manifold.points[index];
  const off = differenceToTruth(one, answer)?.points[index];
  const features = featureWords(point.features);
  return [`${answer.name} (${role}), point ${index + 1} of ${manifold.points.length}`,
    `world ${place(point.world ?? worldOf(one, point.position))}`, `depth ${full(point.depth)}`,
    features && `features ${features}`,
    off && `off the truth by ${short(off.position)}, depth by ${short(off.depth)}`];
}

function describeFace(one, side, index) {
  const body = one.bodies[SIDES.indexOf(side)];
  const face = faceOf(body, index);
  return [`${side.toUpperCase()} face ${index}`, `vertex ${index} to vertex ${(index + 1) % body.vertices.length}`,
    `length ${brief(distance(...face))}`, `outward ${place(outwardOf(face))}`];
}

// `key` is "point <role> <index>", "vertex <side><index>" or "face <side><index>".
function describeTarget(one, key, right) {
  const [kind, what, index] = key.split(" ");
  if (kind === "point") return describePoint(one, what, Number(index), right).filter(Boolean);
  const [side, number] = [what[0], Number(what.slice(1))];
  if (kind === "face") return describeFace(one, side, number);
  const body = one.bodies[SIDES.indexOf(side)];
  return [`${side.toUpperCase()} vertex ${number}`, `world ${place(worldOf(one, body.vertices[number]))}`,
    ...(body.radius > 0 ? [`radius ${full(body.radius)}`] : [])];
}

// A mark of the pictures, to stand in a text.
function markSvg(draw) {
  const svg = svgElement("svg", { class: "role-mark picture", viewBox: "0 0 24 24", width: 20, height: 20, "aria-hidden": "true" });
  draw(svg);
  return svg;
}

function roleMark(role) {
  return markSvg((svg) => {
    const painter = { put: (layer, key, tag, attributes) => svg.append(svgElement(tag, attributes)) };
    putMark({ painter, isThumbnail: false }, role, role, [12, 12]);
  });
}

function pointRow(one, role, right, point, index, locate) {
  const off = differenceToTruth(one, answerOf(one, role))?.points[index];
  const columns = [["point", () => button(String(index + 1), () => locate(role, index),
    { class: "cell", "aria-label": `show point ${index + 1} closely` })],
  ["world position", () => element("code", {}, place(point.world ?? worldOf(one, point.position)))],
  ["depth", () => element("code", {}, full(point.depth))], ["features", () => featureWords(point.features)]];
  if (off) columns.push(["off by", () => short(off.position)], ["depth off by", () => short(off.depth)]);
  return facts(columns.map(([name, cell]) => [name, cell()]));
}

function answerBlock(one, answer, right, locate) {
  const manifold = answer.manifolds[answer.role === "truth" ? right : 0];
  const difference = differenceInWords(differenceToTruth(one, answer), one);
  const reference = manifold?.reference && `reference ${manifold.reference.toUpperCase()}`;
  const normal = isPoint(manifold?.normal) ? `normal ${place(manifold.normal)}` : "";
  return element("section", { class: `answer ${answer.role}` },
    element("h4", {}, roleMark(answer.role), `${answer.name} ${answer.version}`.trim(), element("span", { class: "quiet" }, answer.role)),
    element("p", {}, answer.words || "no answer"),
    difference ? element("p", { class: "difference" }, difference) : null,
    (manifold?.points ?? []).map((point, i) => pointRow(one, answer.role, right, point, i, locate)),
    reference || normal ? element("p", { class: "quiet digits" }, [reference, normal].filter(Boolean).join(", ")) : null);
}

function caseFacts(one) {
  const found = one.found ?? {};
  const versions = Object.entries(found.versions ?? {}).map(([name, version]) => `${name} ${version}`).join(", ");
  const number = (value) => (Number.isFinite(value) ? full(value) : "");
  return facts([["bucket", one.bucket], ["regime", words(one.regime || found.regime || "")],
    ["separation", number(one.separation)], ["total radius", one.total_radius > 0 ? full(one.total_radius) : ""],
    ["size", number(one.size)], ["extent", number(one.extent)], ["magnitude", number(one.magnitude)],
    ["severity", number(one.severity)], ["met", whole(one.count)], ["property", one.property],
    ["seed", found.seed === undefined ? "" : String(found.seed)], ["index", whole(found.index)], ["found with", versions],
    ["A stands at", place(one.origin)]]);
}

function mapFigure(one) {
  if (!/^data:image\/png;base64,/.test(one.map ?? "")) return null;
  return element("figure", {},
    element("img", { src: one.map, alt: `Neighbourhood map. ${one.map_words.join(" ")}` }),
    element("figcaption", {}, one.map_words.map((line) => element("span", {}, line))));
}

function relatedCase(one) {
  const other = one.role === "worst" ? report.caseOf.get(one.smallest)
    : report.cases.find((worst) => worst.role === "worst" && worst.smallest === one.file);
  if (!other) return null;
  return element("p", {}, element("a", { href: caseHash(other) }, other.role === "worst" ? "The worst witness of this bucket" : "The smallest witness of this bucket"));
}

function caseDetails(one, right, locate) {
  const order = one.answers.toSorted((p, q) => ROLES.indexOf(p.role) - ROLES.indexOf(q.role));
  return [one.note ? element("p", { class: "note" }, one.note) : null, relatedCase(one),
    ...order.map((answer) => answerBlock(one, answer, right, locate)),
    element("h4", {}, "This case"), caseFacts(one), mapFigure(one),
    element("h4", {}, "Run it again"), ...one.commands.map(copyLine),
    element("div", { class: "copies" }, one.case ? copyButton("Copy the case", one.case) : null, copyButton("Copy the file name", one.file)),
  ].filter(Boolean);
}
