// What the measuring commands wrote: bench, stress and scene.

const BENCH_CHOICES = ["query", "target", "vertices", "touching", "regime"];
const WALK_EVENTS = [["flickers", "flickers"], ["jumps", "jumps"], ["features", "features changed"]];
const SKIP_COLORS = 5;

// Some rows of a choice stand for every choice: theirs is "".
function benchPoints(rows, chosen) {
  const isChosen = (row) => BENCH_CHOICES.every((key) => {
    const value = String(row[key] ?? "");
    return value === "" || chosen[key] === undefined || value === chosen[key];
  });
  return rows.filter(isChosen).map((row) => ({ row, name: [row.collider, row.input !== "pair" && row.input].filter(Boolean).join(" "),
    x: row.ns_per_pair, y: row.error?.[chosen.quantity]?.p999 }))
    .filter(({ x, y }) => x > 0 && Number.isFinite(y));
}

// Those that no other is left of and below.
function benchFront(points) {
  const isBeaten = (p) => points.some((q) => q.x <= p.x && q.y <= p.y && (q.x < p.x || q.y < p.y));
  return points.filter((point) => !isBeaten(point)).sort((p, q) => p.x - q.x);
}

// Names stand above or below their points; one that finds no room is left out.
function drawBenchNames(chart, names, places) {
  const { left, right, top, bottom } = chart.inner;
  const room = { frame: { left, right, bottom: top, top: bottom }, taken: places.map((at) => boxOf([at], 6)) };
  const directions = [-1, 1, -2, 2, -3, 3, -4, 4].map((down) => [0, down]);
  places.forEach((at, i) => {
    const found = freePlace(room, at, names[i], 8, directions);
    if (!found) return;
    if (distance(found, at) > 20) chartLine(chart, "leader", [at, along(found, [0, Math.sign(at[1] - found[1])], 6)]);
    chartText(chart, "point-name", found[0], found[1] + 4, names[i]);
  });
}

function benchChart(rows, chosen) {
  const { quantity } = chosen;
  const points = benchPoints(rows, chosen);
  if (points.length === 0) return [element("p", { class: "quiet" }, "No row has both a time and this error.")];
  const chart = makeChart(Math.min(Math.max(620, byId("main").clientWidth - 48), 1152), 430, `Time a pair against ${quantity} error`);
  const times = decadesAround(points.map(({ x }) => x));
  const x = logScale(times, chart.inner.left, chart.inner.right);
  // Room for the names above and below the extreme points.
  const [low, high] = decadesAround(points.map((point) => point.y));
  const y = logScale([low / 10, high * 10], chart.inner.bottom, chart.inner.top);
  drawLogY(chart, y, `${quantity} error, p999, in 2^-24 of the extent`, 8);
  const ticks = decadeTicks(x.low, x.high, 9).flatMap(({ value }) => [1, 2, 5].map((step) => step * value));
  drawX(chart, x, "nanoseconds a pair", ticks.filter((value) => value <= times[1]).map((value) => ({ value, text: String(value) })));
  const placeOf = (point) => [x(point.x), y(point.y)];
  chartLine(chart, "front", benchFront(points).map(placeOf));
  drawBenchNames(chart, points.map(({ name }) => name), points.map(placeOf));
  for (const { row, name, ...point } of points) {
    chartMark(chart, row.collider === "box2d" ? "bench-point other" : "bench-point", placeOf(point), 5, [name,
      `${short(point.x)} ns a pair`, `${quantity} error ${short(point.y)} (p999)`,
      Number.isFinite(row.speedup_over_box2d) && `${short(row.speedup_over_box2d)} times as fast as box2d`,
      row.target && `target ${row.target}`, `missed ${row.missed ?? 0}`, `phantom ${row.phantom ?? 0}`]);
  }
  return [element("div", { class: "scroll" }, chart.svg),
    element("p", { class: "quiet" }, "Left and down is better. The line joins what nothing beats in both.")];
}

function benchTable(rows) {
  const text = (key) => [key, (row) => String(row[key] ?? ""), "text"];
  const number = (key, title = key, format = short) => [title, (row) => format(row[key]), "number"];
  const error = (quantity) => [`${quantity} p999`, (row) => short(row.error?.[quantity]?.p999), "number"];
  return table("Every row", [["collider", ({ collider }) => collider], ...["query", "input", "target"].map(text),
    number("vertices", "vertices", (vertices) => String(vertices ?? "")), number("touching"), ["regime", ({ regime }) => words(regime), "text"],
    number("ns_per_pair", "ns a pair"), number("speedup_over_box2d", "over box2d"), ...["depth", "position", "normal"].map(error),
    number("missed", "missed", whole), number("phantom", "phantom", whole)], rows);
}

function benchParts({ rows = [] }) {
  const judged = rows.filter((row) => row.error);
  const choices = BENCH_CHOICES.map((name) => ({ name, label: words(name),
    options: [...new Set(judged.map((row) => String(row[name] ?? "")))].filter(Boolean).map((value) => [value, words(value)]) }));
  return [element("h3", {}, "Run time against error"),
    chosenFigure([QUANTITY, ...choices.filter(({ options }) => options.length > 0)], (chosen) => benchChart(judged, chosen)),
    rows.length > 0 && disclosure(`Table of ${counted(rows.length, "row")}`, () => benchTable(rows))];
}

// Steps run to the right from the easiest to the hardest; a step at 0 stands one place beyond the last.
function stepScale(steps) {
  const logs = steps.map(({ x }) => (x > 0 ? Math.log10(x) : null));
  const there = logs.filter((log) => log !== null);
  const [first, last] = [there[0] ?? 0, there.at(-1) ?? 1];
  const beyond = logs.includes(null) ? Math.sign(last - first || 1) : 0;
  const ticks = decadeTicks(Math.ceil(Math.min(first, last) - 1e-9), Math.floor(Math.max(first, last) + 1e-9), 5);
  return (left, right) => Object.assign(
    (x) => left + (((x > 0 ? Math.log10(x) : last + beyond) - first) / (last + beyond - first || 1)) * (right - left),
    { ticks: beyond === 0 ? ticks : [...ticks, { value: 0, text: "0" }] });
}

// Numerical stability: how errors grow as a case gets harder. Colliders that answer alike are one line, with their names.
function stressChart(name, sweeps, quantity, colors) {
  const unit = sweeps[0].unit ?? "";
  const alike = Map.groupBy(sweeps, ({ steps = [], breaking_point }) => JSON.stringify([steps.map((step) => step[quantity]?.p999), breaking_point]));
  const lines = [...alike.values()].map((same) => {
    const names = same.map(({ collider }) => collider);
    const [{ steps = [], breaking_point }] = same;
    return { name: names.join(", "), color: names.includes("ideal") ? "ideal" : colors.get(names[0]), points: steps.map((step) => {
      const isBreak = breaking_point !== null && step.x === breaking_point;
      const error = step[quantity]?.p999;
      return { x: step.x, y: error, isBreak, lines: [`${short(step.x)} ${unit}`, `${quantity} error ${short(error)} (p999)`, isBreak && "breaks here"] };
    }) };
  });
  return lineChart({ caption: words(name), label: `${words(name)}: ${quantity} error by step`, titles: [unit, `${quantity} error`],
    scaleOfX: stepScale(sweeps[0].steps ?? []), lines });
}

function breakingPoints(sweeps, colliders) {
  const cell = (collider) => ([, all]) => {
    const sweep = all.find((one) => one.collider === collider);
    return sweep && (sweep.breaking_point === null ? element("span", { class: "none" }, "holds") : short(sweep.breaking_point));
  };
  return table("Breaking points", [["sweep", ([name]) => words(name)], ["x is", ([, all]) => all[0].unit, "text quiet"],
    ...colliders.map((collider) => [collider, cell(collider), "number"])], [...sweeps]);
}

// What a collider did from frame to frame that the truth does not do. What happened with a margin is wrong; what is within
// bound may be.
function walkTable(walks) {
  const bad = (count, text = whole(count)) => (count > 0 ? element("span", { class: "bad" }, text) : text);
  const event = ({ with_margin: wrong, within_bound: excused } = {}) =>
    bad(wrong, excused > 0 ? `${whole(wrong)} (+${whole(excused)} within bound)` : whole(wrong));
  return table("Walks", [["walk", ({ walk }) => words(walk)], ["collider", ({ collider }) => collider, "text"],
    ["frames", ({ cases }) => whole(cases), "number"], ["touching", ({ touching }) => whole(touching), "number"],
    ...WALK_EVENTS.map(([key, title]) => [title, (row) => event(row[key] ?? {}), "number"]),
    ...["missed", "phantom", "lost"].map((key) => [key, (row) => bad(row[key]), "number"])], walks);
}

function stressParts({ sweeps = [], walks = [] }) {
  const colliders = [...new Set(sweeps.map(({ collider }) => collider))];
  const colors = new Map(colliders.filter((name) => name !== "ideal").map((name, i) => [name, `c${i % LINE_COLORS}`]));
  const bySweep = Map.groupBy(sweeps, ({ sweep }) => sweep);
  return [element("p", { class: "quiet" }, "Errors as a share of the size: what one contact in a thousand exceeds. Steps get harder to the right; a cross marks where a collider breaks."),
    chosenFigure([QUANTITY], ({ quantity }) => [element("div", { class: "small-plots" },
      [...bySweep].map(([name, all]) => stressChart(name, all, quantity, colors)))]),
    element("h3", {}, "Breaking points"), breakingPoints(bySweep, colliders),
    ...(walks.length > 0 ? [element("h3", {}, "Walks"), walkTable(walks)] : [])];
}

function sceneName(row, rows) {
  const differs = (key) => rows.some((other) => other[key] !== row[key]);
  return [words(row.scene), differs("bodies") && whole(row.bodies), differs("mode") && row.mode].filter(Boolean).join(", ");
}

// Shares of all candidates: each reason to skip, then what was computed.
function sceneShares(row) {
  const parts = [...Object.entries(row.skipped ?? {}), ["computed", row.computed]];
  const all = parts.reduce((sum, [, count]) => sum + (count ?? 0), 0);
  return parts.map(([name, count], i) => ({ name: words(name), count: count ?? 0, share: all > 0 ? (count ?? 0) / all : 0,
    color: name === "computed" ? name : `s${i % SKIP_COLORS}` }));
}

function shareBar(row) {
  const shares = sceneShares(row);
  return element("span", { class: "stack", role: "img", "aria-label": shares.map(({ name, share }) => `${name} ${percent(share)}`).join(", ") },
    shares.filter(({ count }) => count > 0).map(({ name, count, share, color }) => element("i", { class: `mark-target ${color}`,
      style: `width: ${100 * share}%`, "data-lines": `${name}|${whole(count)} of the candidates|${percent(share)}` })));
}

// Speedups differ by factors of ten: the bars are logarithmic, from 1.
function speedColumn(title, key, most, css) {
  return [title, (row) => withMeter(row[key] > 1 && most > 1 ? Math.log(row[key]) / Math.log(most) : 0,
    Number.isFinite(row[key]) && `${short(row[key])}\u00d7`, css), "number speed"];
}

function sceneTable(rows) {
  const most = greatest(rows.flatMap((row) => [row.speedup_over_box2d, row.speedup_over_box2d_moved])) ?? 1;
  const number = (key) => [key, (row) => whole(Math.round(row[key] ?? NaN)), "number"];
  const columns = [["scene", (row) => sceneName(row, rows)], speedColumn("over box2d", "speedup_over_box2d", most, ""),
    rows.some((row) => Number.isFinite(row.speedup_over_box2d_moved))
      && speedColumn("over box2d on what moved", "speedup_over_box2d_moved", most, "second"),
    ["skipped and computed", shareBar, "shares"], ["ns a step", number("ns_per_step")[1], "number"],
    ...["bodies", "moving", "candidates", "mismatches", "bytes"].map(number)];
  return table("Scenes", columns.filter(Boolean), rows);
}

// What keeping a contact that moved a little costs, and what it saves.
function recyclingChart(scenes, quantity) {
  const scaleOfX = (left, right) => Object.assign((share) => left + share * (right - left),
    { ticks: [0, 0.25, 0.5, 0.75, 1].map((value) => ({ value, text: `${100 * value}%` })) });
  const lines = scenes.map(({ scene, bodies, points = [] }, i) => ({
    name: `${words(scene)}, ${counted(bodies, "body", "bodies")}`, color: `c${i % LINE_COLORS}`,
    points: points.map((point) => ({ x: point.skipped, y: point[quantity]?.p999, lines: [`motion up to ${short(point.motion)}`,
      `${percent(point.skipped)} skipped`, `${quantity} error ${short(point[quantity]?.p999)} (p999)`,
      `${whole(point.wrong)} of ${whole(point.judged)} wrong`] })) }));
  return [element("div", { class: "small-plots" }, lineChart({ label: `${quantity} error by the share of candidates that are skipped`,
    titles: ["share skipped", `${quantity} error`], scaleOfX, lines }))];
}

// How much faster than Box2D, and what was skipped for which reason.
function sceneParts({ rows: all = [], exponents = [], recycling = [] }) {
  const rows = all.filter(({ baseline = "box2d" }) => baseline === "box2d");
  const drawn = element("div", {}, sceneTable(rows),
    legend(sceneShares(rows[0] ?? {}).map(({ name, color }) => [color, name]), "swatch block-swatch"));
  explainTargets(drawn, ".mark-target", (node) => node.dataset.lines.split("|"));
  return [element("p", { class: "quiet" }, "Speedup bars are logarithmic and start at 1."), drawn,
    exponents.length > 0 && element("div", { class: "narrow" }, table("Exponents", [["scene", ({ scene }) => words(scene)],
      ["time grows with bodies to the power", ({ exponent }) => short(exponent), "number"]], exponents)),
    ...(recycling.length > 0 ? [element("h3", {}, "Recycling"),
      element("p", { class: "quiet" }, "A contact is kept while its bodies moved by less than a share of their size: errors, as a share of the size, against what that skips."),
      chosenFigure([QUANTITY], ({ quantity }) => recyclingChart(recycling, quantity))] : [])];
}
