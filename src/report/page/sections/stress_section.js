// Numerical stability: how each collider's errors grow as a case gets harder.

// Colliders that answer alike are one line, with their names.
function mergedLines(sweeps, quantity) {
  const lines = new Map();
  for (const sweep of sweeps) {
    const values = (sweep.steps ?? []).map((step) => step[quantity]?.p999 ?? null);
    const key = JSON.stringify([values, sweep.breaking_point]);
    const line = lines.get(key) ?? { names: [], values, steps: sweep.steps ?? [], breaking: sweep.breaking_point };
    line.names.push(sweep.collider);
    lines.set(key, line);
  }
  return [...lines.values()];
}

// Steps run to the right from the easiest to the hardest; a step at 0 stands one place beyond the last.
function stepPlaces(steps, left, right) {
  const values = steps.map(({ x }) => x);
  const logs = values.map((x) => (x > 0 ? Math.log10(x) : null));
  const there = logs.filter((log) => log !== null);
  const [first, last] = [there[0] ?? 0, there.at(-1) ?? 1];
  const beyond = logs.includes(null) ? Math.sign(last - first || 1) : 0;
  const span = last + beyond - first || 1;
  const at = (log) => left + ((log - first) / span) * (right - left);
  return { place: (x) => at(x > 0 ? Math.log10(x) : last + beyond), first, last, hasZero: beyond !== 0 };
}

function stepTicks({ place, first, last, hasZero }) {
  const [low, high] = [Math.ceil(Math.min(first, last) - 1e-9), Math.floor(Math.max(first, last) + 1e-9)];
  const step = Math.max(1, Math.ceil((high - low) / 5));
  const ticks = [];
  for (let power = low; power <= high; power += step) ticks.push({ at: place(10 ** power), text: powerWord(power) });
  if (hasZero) ticks.push({ at: place(0), text: "0" });
  return ticks;
}

function lineColor(names, colliders) {
  if (names.includes("ideal")) return "ideal";
  return `c${colliders.filter((name) => name !== "ideal").indexOf(names[0]) % LINE_COLORS}`;
}

function drawStressLine(chart, line, places, color, quantity, unit) {
  const points = line.steps.map(({ x }, i) => ({ x, y: line.values[i] })).filter(({ x, y }) => Number.isFinite(x) && Number.isFinite(y));
  const at = ({ x, y }) => [places.place(x), chart.y(Math.max(y, chart.y.from))];
  chartLine(chart, `line ${color}`, points.map(at));
  for (const point of points) {
    const [cx, cy] = at(point).map(pixels);
    const breaks = line.breaking !== null && point.x === line.breaking;
    const lines = [line.names.join(" "), `${short(point.x)} ${unit}`.replaceAll(", ", " "), `${quantity} error ${short(point.y)} (p999)`,
      breaks ? "breaks here" : ""].filter(Boolean);
    if (breaks) chart.svg.append(svgElement("path", { class: `break ${color}`, d: `M${cx - 5} ${cy - 5}l10 10m0 -10l-10 10` }));
    chartMark(chart, "circle", { class: `line-point ${color}`, cx, cy, r: 4, "data-collider": line.names[0] }, lines);
  }
}

function stressChart(name, sweeps, quantity, colliders) {
  const lines = mergedLines(sweeps, quantity);
  const unit = sweeps[0].unit ?? "";
  const chart = makeChart({ width: 380, height: 250, label: `${words(name)}: ${quantity} error by step` });
  const values = lines.flatMap((line) => line.values).filter((value) => value > 1e-20);
  chart.y = logScale(...decadesAround(values), chart.inner.bottom, chart.inner.top);
  const places = stepPlaces(sweeps[0].steps ?? [], chart.inner.left + 8, chart.inner.right - 8);
  drawLogY(chart, `${quantity} error`, 5);
  drawLogX(chart, unit, stepTicks(places));
  for (const line of lines) drawStressLine(chart, line, places, lineColor(line.names, colliders), quantity, unit);
  return element("figure", { class: "small-plot" }, element("figcaption", {}, words(name)), explainChart(chart),
    element("ul", { class: "legend" }, lines.map((line) => element("li", {},
      element("i", { class: `swatch ${lineColor(line.names, colliders)}`, "aria-hidden": "true" }), line.names.join(", ")))));
}

function bySweep(sweeps) {
  const groups = new Map();
  for (const sweep of sweeps) groups.set(sweep.sweep, [...(groups.get(sweep.sweep) ?? []), sweep]);
  return groups;
}

function breakingPoints(sweeps, colliders) {
  const groups = [...bySweep(sweeps)];
  const cell = (collider) => ([, all]) => {
    const sweep = all.find((one) => one.collider === collider);
    if (!sweep) return "";
    return sweep.breaking_point === null ? element("span", { class: "none" }, "holds") : short(sweep.breaking_point);
  };
  return table("Breaking points", [["sweep", ([name]) => words(name)], ["x is", ([, all]) => all[0].unit ?? "", "text quiet"],
    ...colliders.map((collider) => [collider, cell(collider), "number"])], groups);
}

function stressRun({ path, result }) {
  const sweeps = result.sweeps ?? [];
  const colliders = [...new Set(sweeps.map(({ collider }) => collider))];
  const options = ["depth", "position", "normal"].map((name) => [name, name]);
  const plots = ({ quantity }) => [element("div", { class: "small-plots" },
    [...bySweep(sweeps)].map(([name, all]) => stressChart(name, all, quantity, colliders)))];
  return element("article", { class: "run" },
    element("p", { class: "quiet" }, "Errors as a share of the size: what one contact in a thousand exceeds. Steps get harder to the right; a cross marks where a collider breaks."),
    chosenFigure([{ name: "quantity", label: "Error of", options }], plots),
    element("h3", {}, "Breaking points"), breakingPoints(sweeps, colliders),
    ...(result.walks?.length > 0 ? [element("h3", {}, "Walks"), walkTable(result.walks)] : []), provenance(path, result));
}

function stressSection() {
  return report.stress.length === 0 ? null : section("stress", "Stress", ...report.stress.map(stressRun));
}
