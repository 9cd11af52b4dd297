// What stands beside the picture of a case, and what its tooltips say.

function featureWords(features) {
  return features.map((feature, i) => `${"AB"[i]} ${feature}`).join(", ");
}

function describePoint(one, role, index, right) {
  const answer = answerOf(one, role);
  const { points } = manifoldOf(answer, right);
  const { world, depth, features } = points[index];
  const off = differenceToTruth(one, answer)?.points[index];
  return [`${answer.name} (${role}), point ${index + 1} of ${points.length}`, `world ${place(world)}`, `depth ${full(depth)}`,
    `features ${featureWords(features)}`, off && `off the truth by ${short(off.position)}, depth by ${short(off.depth)}`];
}

// The lines of a tooltip. `key` is "point <role> <index>", "vertex <side><index>" or "face <side><index>".
function describeTarget(one, key, right) {
  const [kind, what, index] = key.split(" ");
  if (kind === "point") return describePoint(one, what, Number(index), right).filter(Boolean);
  const number = Number(what.slice(1));
  const { vertices, radius } = one.bodies[SIDES.indexOf(what[0])];
  const title = `${what[0].toUpperCase()} ${kind} ${number}`;
  if (kind === "vertex") return [title, `world ${place(along(one.origin, vertices[number], 1))}`, ...(radius > 0 ? [`radius ${full(radius)}`] : [])];
  const face = facesOf(vertices)[number];
  return [title, `vertex ${number} to vertex ${(number + 1) % vertices.length}`, `length ${brief(distance(...face))}`,
    `outward ${place(outwardOf(face))}`];
}

// A mark of the pictures, to stand in a text.
function markSvg(mark) {
  const svg = svgElement("svg", { class: "role-mark picture", viewBox: "0 0 24 24", width: 20, height: 20, "aria-hidden": "true" });
  svg.append(mark);
  return svg;
}

function lineMark(css) {
  return markSvg(svgElement("path", { class: css, d: "M2 12H22" }));
}

function roleMark(role) {
  let mark;
  const painter = { put: (layer, key, tag, attributes) => { mark = svgElement(tag, attributes); } };
  putMark({ painter }, role, role, [12, 12]);
  return markSvg(mark);
}

function pointFacts(role, { world, depth, features }, index, off) {
  return facts([["point", button(String(index + 1), () => locate(role, index), { class: "cell", "aria-label": `show point ${index + 1} closely` })],
    ["world position", element("code", {}, place(world))], ["depth", element("code", {}, full(depth))],
    ["features", featureWords(features)], ["off by", short(off?.position)], ["depth off by", short(off?.depth)]]);
}

function answerBlock(one, answer, right) {
  const { points = [], reference, normal } = manifoldOf(answer, right) ?? {};
  const difference = differenceToTruth(one, answer);
  const inWords = differenceInWords(difference, one);
  const frame = [reference && `reference ${reference.toUpperCase()}`, isPoint(normal) && `normal ${place(normal)}`].filter(Boolean);
  return element("section", { class: `answer ${answer.role}` },
    element("h4", {}, roleMark(answer.role), `${answer.name} ${answer.version}`.trim(), element("span", { class: "quiet" }, answer.role)),
    element("p", {}, answer.words),
    inWords && element("p", { class: "difference" }, inWords),
    points.map((point, i) => pointFacts(answer.role, point, i, difference?.points[i])),
    frame.length > 0 && element("p", { class: "quiet digits" }, frame.join(", ")));
}

function namedVersions(versions) {
  return Object.entries(versions ?? {}).map(([name, version]) => `${name} ${version}`.trim()).join(", ");
}

function caseFacts(one) {
  const found = one.found ?? {};
  const number = (name) => [name.replace("_", " "), Number.isFinite(one[name]) && full(one[name])];
  return facts([["bucket", one.bucket], ["regime", words(one.regime || found.regime)], number("separation"),
    one.total_radius > 0 ? number("total_radius") : [], number("size"), number("extent"), number("magnitude"), number("severity"),
    ["met", whole(one.count)], ["property", one.property], ["seed", String(found.seed ?? "")], ["index", whole(found.index)],
    ["found with", namedVersions(found.versions)], ["A stands at", place(one.origin)]]);
}

function mapFigure(one) {
  return /^data:image\/png;base64,/.test(one.map ?? "") && element("figure", {},
    element("img", { src: one.map, alt: `Neighbourhood map. ${one.map_words.join(" ")}` }),
    element("figcaption", {}, one.map_words.map((line) => element("span", {}, line))));
}

function curveFigure(one) {
  return /^<\?xml [^>]*>\s*<svg /.test(one.curve ?? "") && element("figure", {},
    element("img", { src: `data:image/svg+xml,${encodeURIComponent(one.curve)}`, alt: one.curve_words.join(" ") }),
    element("figcaption", {}, one.curve_words.map((line) => element("span", {}, line))));
}

function relatedCase(one) {
  const other = one.role === "worst" ? report.caseOf.get(one.smallest) : report.cases.find(({ smallest }) => smallest === one.file);
  return other && element("p", {}, element("a", { href: caseHash(other) }, `The ${other.role} witness of this bucket`));
}

function caseDetails(one, right) {
  return [one.note && element("p", { class: "note" }, one.note), relatedCase(one),
    ...one.answers.map((answer) => answerBlock(one, answer, right)),
    element("h4", {}, "This case"), caseFacts(one), curveFigure(one), mapFigure(one),
    element("h4", {}, "Run it again"), ...one.commands.map(copyLine),
    element("div", { class: "copies" }, copyButton("Copy the case", one.case), copyButton("Copy the file name", one.file)),
  ].filter(Boolean);
}
