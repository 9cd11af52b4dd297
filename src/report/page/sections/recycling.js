// What keeping a contact that moved a little costs, and what it saves.

function drawRecycled(chart, { scene, bodies, points = [] }, quantity, color) {
  const there = points.map((point) => ({ point, x: point.skipped, y: point[quantity]?.p999 }))
    .filter(({ x, y }) => Number.isFinite(x) && Number.isFinite(y));
  const at = ({ x, y }) => [chart.x(x), chart.y(Math.max(y, chart.y.from))];
  chartLine(chart, `line ${color}`, there.map(at));
  for (const one of there) {
    const [cx, cy] = at(one).map(pixels);
    chartMark(chart, "circle", { class: `line-point ${color}`, cx, cy, r: 4 }, [`${words(scene ?? "")} ${whole(bodies)} bodies`,
      `motion up to ${short(one.point.motion)}`, `${percent(one.x)} skipped`, `${quantity} error ${short(one.y)} (p999)`,
      `${whole(one.point.wrong)} of ${whole(one.point.judged)} wrong`]);
  }
}

function recyclingChart(scenes, quantity) {
  const chart = makeChart({ width: 380, height: 250, label: `${quantity} error by the share of candidates that are skipped` });
  const { left, right, bottom, top } = chart.inner;
  chart.x = (share) => left + 8 + share * (right - left - 16);
  const errors = scenes.flatMap(({ points = [] }) => points.map((point) => point[quantity]?.p999));
  chart.y = logScale(...decadesAround(errors), bottom, top);
  drawLogY(chart, `${quantity} error`, 6);
  drawLogX(chart, "share skipped", [0, 0.25, 0.5, 0.75, 1].map((share) => ({ at: chart.x(share), text: `${100 * share}%` })));
  scenes.forEach((scene, i) => drawRecycled(chart, scene, quantity, `c${i % LINE_COLORS}`));
  return [element("div", { class: "small-plots" }, element("div", { class: "small-plot" }, explainChart(chart), element("ul", { class: "legend" }, scenes.map(({ scene, bodies }, i) => element("li", {},
    element("i", { class: `swatch c${i % LINE_COLORS}`, "aria-hidden": "true" }), `${words(scene ?? "")}, ${whole(bodies)} bodies`)))))];
}

function recyclingFigure(scenes) {
  const options = ["depth", "position", "normal"].map((name) => [name, name]);
  return [element("h3", {}, "Recycling"),
    element("p", { class: "quiet" }, "A contact is kept while its bodies moved by less than a share of their size: errors, as a share of the size, against what that skips."),
    chosenFigure([{ name: "quantity", label: "Error of", options }], ({ quantity }) => recyclingChart(scenes, quantity))];
}
