// Run time against error.

const BENCH_CHOICES = ["query", "target", "vertices", "touching", "regime"];

// The run's values of a key, as text, the first one first; `""` goes with every choice.
function benchValues(rows, key) {
  return [...new Set(rows.map((row) => String(row[key] ?? "")))].filter((value) => value !== "");
}

function benchName(row) {
  return [row.collider, row.input === "pair" ? "" : row.input].filter(Boolean).join(" ");
}

// The rows that no other is left of and below.
function benchFront(rows) {
  let least = Infinity;
  return [...rows].sort((p, q) => p.x - q.x || p.y - q.y).filter(({ y }) => {
    if (y >= least) return false;
    least = y;
    return true;
  });
}

function benchPoints(rows, chosen, quantity) {
  return rows.filter((row) => BENCH_CHOICES.every((key) => {
    const value = String(row[key] ?? "");
    return value === "" || chosen[key] === undefined || value === chosen[key];
  })).map((row) => ({ row, name: benchName(row), x: row.ns_per_pair, y: row.error?.[quantity]?.p999 }))
    .filter(({ x, y }) => x > 0 && Number.isFinite(y));
}

function rowLines({ row, x, y }, quantity) {
  const speedup = Number.isFinite(row.speedup_over_box2d) ? `${short(row.speedup_over_box2d)} times as fast as box2d` : "";
  return [benchName(row), `${short(x)} ns a pair`, `${quantity} error ${short(y)} (p999)`, speedup,
    row.target && `target ${row.target}`, `missed ${row.missed ?? 0}`, `phantom ${row.phantom ?? 0}`].filter(Boolean);
}

function drawBenchLabels(chart, points) {
  const labels = makeLabels(chart.inner);
  const places = points.map(({ x, y }) => [chart.x(x), chart.y(y)]);
  for (const [x, y] of places) labels.take({ left: x - 6, right: x + 6, top: y - 6, bottom: y + 6 });
  points.forEach(({ name }, i) => {
    const found = labels.find(places[i], name, { gaps: [8, 20, 34, 50, 66], towards: [0.1, -1], isOptional: true });
    if (found === null) return;
    const center = [(found.left + found.right) / 2, found.bottom - 3.5];
    if (Math.abs(center[1] - 4 - places[i][1]) > 20) {
      chartLine(chart, "leader", [places[i], [center[0], found.top > places[i][1] ? found.top + 2 : found.bottom]]);
    }
    chartText(chart, "point-name", center[0], center[1], name);
  });
}

function benchChart(rows, chosen) {
  const { quantity } = chosen;
  const points = benchPoints(rows, chosen, quantity);
  if (points.length === 0) return [element("p", { class: "quiet" }, "No row has both a time and this error.")];
  const width = Math.min(Math.max(620, byId("main").clientWidth - 48), 1152);
  const chart = makeChart({ width, height: 430, label: `Time a pair against ${quantity} error` });
  const times = decadesAround(points.map(({ x }) => x));
  // Room for the names above and below the extreme points.
  const [low, high] = decadesAround(points.map(({ y }) => y));
  chart.x = logScale(...times, chart.inner.left, chart.inner.right);
  chart.y = logScale(low / 10, high * 10, chart.inner.bottom, chart.inner.top);
  drawLogY(chart, `${quantity} error, p999, in 2^-24 of the extent`, 8);
  const ticks = [];
  for (let power = times[0]; power <= times[1]; power *= 10) {
    for (const step of [1, 2, 5]) if (step * power <= times[1]) ticks.push({ at: chart.x(step * power), text: String(step * power) });
  }
  drawLogX(chart, "nanoseconds a pair", ticks);
  chartLine(chart, "front", benchFront(points).map(({ x, y }) => [chart.x(x), chart.y(y)]));
  drawBenchLabels(chart, points);
  for (const point of points) {
    const css = point.row.collider === "box2d" ? "bench-point other" : "bench-point";
    chartMark(chart, "circle", { class: css, cx: pixels(chart.x(point.x)), cy: pixels(chart.y(point.y)), r: 5 }, rowLines(point, quantity));
  }
  return [element("div", { class: "scroll" }, explainChart(chart)),
    element("p", { class: "quiet" }, "Left and down is better. The line joins what nothing beats in both.")];
}

function benchTable(rows) {
  const error = (quantity) => [`${quantity} p999`, (row) => short(row.error?.[quantity]?.p999), "number"];
  return table("Every row", [["collider", ({ collider }) => collider ?? ""], ["query", ({ query }) => query ?? "", "text"],
    ["input", ({ input }) => input ?? "", "text"], ["target", ({ target }) => target ?? "", "text"],
    ["vertices", ({ vertices }) => String(vertices ?? ""), "number"], ["touching", ({ touching }) => short(touching), "number"],
    ["regime", ({ regime }) => words(regime ?? ""), "text"], ["ns a pair", (row) => short(row.ns_per_pair), "number"],
    ["over box2d", (row) => short(row.speedup_over_box2d), "number"], error("depth"), error("position"), error("normal"),
    ["missed", ({ missed }) => whole(missed), "number"], ["phantom", ({ phantom }) => whole(phantom), "number"]], rows);
}

function benchRun({ path, result }) {
  const rows = result.rows ?? [];
  const judged = rows.filter((row) => row.error);
  const choices = [{ name: "quantity", label: "Error of", options: ["depth", "position", "normal"].map((name) => [name, name]) },
    ...BENCH_CHOICES.map((name) => ({ name, label: words(name), options: benchValues(judged, name).map((value) => [value, words(value)]) }))
      .filter(({ options }) => options.length > 0)];
  return element("article", { class: "run" }, element("h3", {}, "Run time against error"),
    chosenFigure(choices, (chosen) => benchChart(judged, chosen)), provenance(path, result),
    rows.length > 0 ? disclosure(`Table of ${counted(rows.length, "row")}`, () => benchTable(rows)) : null);
}

function benchSection() {
  return report.bench.length === 0 ? null : section("bench", "Bench", ...report.bench.map(benchRun));
}
