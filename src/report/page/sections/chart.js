// Axes, lines, marks and bars: all plots of the page.

const LINE_COLORS = 7;
const CHART_EDGE = { left: 54, right: 14, top: 10, bottom: 40 };

// Maps [from, to] logarithmically to pixels; what is 0 or less stands at the low end.
function logScale(from, to, start, end) {
  const [low, high] = [Math.log10(from), Math.log10(to)];
  const scale = (value) => (value > 0 ? start + ((Math.log10(value) - low) / (high - low || 1)) * (end - start) : start);
  return Object.assign(scale, { from, to });
}

// The powers of ten about the values; at least one decade.
function decadesAround(values) {
  const there = values.filter((value) => Number.isFinite(value) && value > 0);
  if (there.length === 0) return [1, 10];
  const low = Math.floor(Math.log10(Math.min(...there)) + 1e-9);
  const high = Math.ceil(Math.log10(Math.max(...there)) - 1e-9);
  return [10 ** low, 10 ** Math.max(high, low + 1)];
}

function powerWord(exponent) {
  if (exponent >= 0 && exponent <= 3) return String(10 ** exponent);
  return `1e${exponent}`;
}

function decadeTicks(scale, most) {
  const low = Math.round(Math.log10(scale.from));
  const high = Math.round(Math.log10(scale.to));
  const step = Math.max(1, Math.ceil((high - low) / most));
  const ticks = [];
  for (let power = low; power <= high; power += step) ticks.push(power);
  return ticks;
}

// An empty chart: {svg, x, y, inner}. `label` says what it shows to those who do not see it.
function makeChart({ width, height, label, edge = CHART_EDGE }) {
  const svg = svgElement("svg", { class: "chart", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": label });
  const inner = { left: edge.left, right: width - edge.right, top: edge.top, bottom: height - edge.bottom };
  svg.append(svgElement("rect", { class: "chart-frame", x: inner.left, y: inner.top,
    width: inner.right - inner.left, height: inner.bottom - inner.top }));
  return { svg, inner, width, height };
}

function chartText(chart, css, x, y, text, anchor = "middle", more = {}) {
  chart.svg.append(svgElement("text", { class: css, x: pixels(x), y: pixels(y), "text-anchor": anchor, ...more }, text));
}

function chartLine(chart, css, points) {
  chart.svg.append(svgElement("path", { class: css, d: pathOf(points, false) }));
}

function drawLogY(chart, title, most = 6) {
  const { inner, y } = chart;
  for (const power of decadeTicks(y, most)) {
    const at = y(10 ** power);
    chartLine(chart, "grid", [[inner.left, at], [inner.right, at]]);
    chartText(chart, "tick", inner.left - 6, at + 4, powerWord(power), "end");
  }
  const middleY = (inner.top + inner.bottom) / 2;
  chartText(chart, "axis", 12, middleY, title, "middle", { transform: `rotate(-90 12 ${pixels(middleY)})` });
}

function drawLogX(chart, title, ticks) {
  const { inner } = chart;
  for (const { at, text } of ticks) {
    chartLine(chart, "grid", [[at, inner.top], [at, inner.bottom]]);
    chartText(chart, "tick", at, inner.bottom + 15, text);
  }
  chartText(chart, "axis", (inner.left + inner.right) / 2, chart.height - 5, title);
}

// A mark with values to show: `lines` are the tooltip's.
function chartMark(chart, tag, attributes, lines) {
  const node = svgElement(tag, { ...attributes, tabindex: "0", role: "img", "aria-label": lines.join(", ") });
  node.classList.add("mark-target");
  chart.svg.append(node);
}

function explainChart(chart) {
  explainTargets(chart.svg, ".mark-target", (node) => node.getAttribute("aria-label").split(", "));
  return chart.svg;
}

// A figure that is drawn again whenever one of its choices changes.
function chosenFigure(choices, draw) {
  const chosen = Object.fromEntries(choices.map(({ name, options }) => [name, options[0][0]]));
  const drawing = element("div", { class: "drawing" });
  const redraw = () => drawing.replaceChildren(...draw(chosen));
  const fields = choices.filter(({ options }) => options.length > 1).map(({ name, label, options }) =>
    select(label, options, chosen[name], (value) => { chosen[name] = value; redraw(); }));
  redraw();
  return element("figure", { class: "chosen" }, fields.length > 0 ? element("div", { class: "fields" }, fields) : null, drawing);
}
