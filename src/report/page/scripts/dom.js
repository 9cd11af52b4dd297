// What everything on the page is made of: elements, tables, copying, the tooltip; axes, lines, marks and bars of plots. Texts go in
// as text nodes: nothing of the data is ever read as HTML.

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

// A function listens to the event of its name.
function setAttributes(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : value);
  }
  return node;
}

// A child is a node or a text; one that is missing or empty is left out.
function element(tag, attributes = {}, ...children) {
  const node = setAttributes(document.createElement(tag), attributes);
  node.append(...children.flat().filter(Boolean));
  return node;
}

function svgElement(tag, attributes = {}, text = "") {
  const node = setAttributes(document.createElementNS(SVG_NAMESPACE, tag), attributes);
  node.textContent = text;
  return node;
}

function button(text, action, attributes = {}) {
  return element("button", { type: "button", click: action, ...attributes }, text);
}

function field(label, control, css = "field") {
  return element("label", { class: css }, element("span", {}, label), control);
}

// An option is [value, text].
function select(label, options, chosen, action, attributes = {}) {
  const list = element("select", { change: () => action(list.value), ...attributes },
    options.map(([value, text]) => element("option", { value, selected: value === chosen }, text)));
  return field(label, list);
}

function byId(id) {
  return document.getElementById(id);
}

function announce(text) {
  byId("announcer").textContent = text;
}

// Names and values; a pair without a value is left out.
function facts(pairs, css = "facts") {
  return element("dl", { class: css }, pairs.filter(([, value]) => value).map(([name, value]) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, value))));
}

// A table that scrolls within itself. A column is [title, cell of a row, class]; a cell is a node or a text.
function table(caption, columns, rows) {
  const head = columns.map(([title, , css]) => element("th", { scope: "col", class: css }, title));
  const body = rows.map((row) => element("tr", {}, columns.map(([, cell, css], i) =>
    element(i === 0 ? "th" : "td", { class: css, scope: i === 0 && "row" }, cell(row)))));
  return element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    element("table", {}, element("caption", { class: "unseen" }, caption),
      element("thead", {}, element("tr", {}, head)), element("tbody", {}, body)));
}

// Part of a page that is built when it is first opened.
function disclosure(title, build) {
  const details = element("details", {}, element("summary", {}, title));
  details.addEventListener("toggle", () => details.append(build()), { once: true });
  return details;
}

// Where the browser keeps the clipboard from the page, by a field beside `neighbour`: a dialog lets nothing outside it be
// selected.
async function copyText(text, neighbour) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const selected = element("textarea", { class: "unseen", readonly: true, "aria-hidden": "true" }, text);
    neighbour.after(selected);
    selected.select();
    const isCopied = document.execCommand("copy");
    selected.remove();
    neighbour.focus();
    return isCopied;
  }
}

// A button that copies; says so for a moment.
function copyButton(label, text) {
  const node = button(label, async () => {
    const isCopied = await copyText(text, node);
    node.textContent = isCopied ? "Copied" : "Not copied";
    node.classList.toggle("done", isCopied);
    announce(isCopied ? "Copied to the clipboard" : "The browser does not let this page copy");
    setTimeout(() => {
      node.textContent = label;
      node.classList.remove("done");
    }, 1200);
  }, { class: "copy", "aria-label": `${label}: ${text.slice(0, 80)}` });
  return node;
}

function copyLine(text) {
  return element("div", { class: "copy-line" }, element("code", {}, text), copyButton("Copy", text));
}

// The first line of each block is its title. `box` is what they explain, in the window's coordinates.
function showTooltip(blocks, box) {
  const tip = byId("tooltip");
  tip.replaceChildren(...blocks.flatMap((lines) => lines.map((line, i) => element(i === 0 ? "strong" : "span", {}, line))));
  tip.togglePopover(true);
  const { width, height } = tip.getBoundingClientRect();
  const room = { right: document.documentElement.clientWidth, bottom: window.innerHeight };
  const left = Math.min(Math.max(4, (box.left + box.right) / 2 - width / 2), Math.max(4, room.right - width - 4));
  const above = box.top - height - 10;
  tip.style.left = `${left}px`;
  tip.style.top = `${above >= 4 ? above : Math.min(box.bottom + 10, room.bottom - height - 4)}px`;
}

function hideTooltip() {
  byId("tooltip").togglePopover(false);
}

// Under the pointer, everything of the same layer; else the target alone.
function coincident(target, event, selector) {
  if (!(event instanceof PointerEvent)) return [target];
  const here = document.elementsFromPoint(event.clientX, event.clientY).filter((node) => node.matches(selector));
  return here.includes(target) ? here.filter((node) => node.parentNode === target.parentNode) : [target];
}

// Shows `describe(target)` for what lies under the pointer or has the focus, of what `selector` finds.
function explainTargets(root, selector, describe) {
  const explain = (event) => {
    const target = event.target.closest?.(selector);
    if (target) showTooltip(coincident(target, event, selector).map(describe), target.getBoundingClientRect());
    else hideTooltip();
  };
  for (const name of ["pointerover", "pointerdown", "focusin"]) root.addEventListener(name, explain);
  // A finger leaves as soon as it is lifted: what it pointed at stays explained.
  root.addEventListener("pointerleave", (event) => event.pointerType === "touch" || hideTooltip());
  root.addEventListener("focusout", hideTooltip);
}

const LINE_COLORS = 7;
const CHART_EDGE = { left: 54, right: 14, top: 10, bottom: 40 };
const QUANTITY = { name: "quantity", label: "Error of", options: ["depth", "position", "normal"].map((name) => [name, name]) };

// Maps [from, to] logarithmically to pixels; what is 0 or less stands at the low end.
function logScale([from, to], start, end) {
  const [low, high] = [Math.log10(from), Math.log10(to)];
  const scale = (value) => (value > 0 ? start + ((Math.log10(Math.max(value, from)) - low) / (high - low || 1)) * (end - start) : start);
  return Object.assign(scale, { low: Math.round(low), high: Math.round(high) });
}

// The powers of ten about the values; at least one decade.
function decadesAround(values) {
  const there = values.filter((value) => Number.isFinite(value) && value > 0);
  if (there.length === 0) return [1, 10];
  const low = Math.floor(Math.log10(Math.min(...there)) + 1e-9);
  const high = Math.ceil(Math.log10(Math.max(...there)) - 1e-9);
  return [10 ** low, 10 ** Math.max(high, low + 1)];
}

// Some powers of ten, {value, text}, `most` or one more.
function decadeTicks(low, high, most) {
  const step = Math.max(1, Math.ceil((high - low) / most));
  return Array.from({ length: Math.max(0, Math.floor((high - low) / step) + 1) }, (_, i) => low + i * step)
    .map((power) => ({ value: 10 ** power, text: power >= 0 && power <= 3 ? String(10 ** power) : `1e${power}` }));
}

// An empty chart. `label` says what it shows to those who do not see it.
function makeChart(width, height, label) {
  const svg = svgElement("svg", { class: "chart", viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": label });
  const inner = { left: CHART_EDGE.left, right: width - CHART_EDGE.right, top: CHART_EDGE.top, bottom: height - CHART_EDGE.bottom };
  svg.append(svgElement("rect", { class: "chart-frame", x: inner.left, y: inner.top,
    width: inner.right - inner.left, height: inner.bottom - inner.top }));
  explainTargets(svg, ".mark-target", (node) => node.getAttribute("aria-label").split(", "));
  return { svg, inner, height };
}

function chartText(chart, css, x, y, text, anchor = "middle", more = {}) {
  chart.svg.append(svgElement("text", { class: css, x: pixels(x), y: pixels(y), "text-anchor": anchor, ...more }, text));
}

function chartLine(chart, css, points) {
  chart.svg.append(svgElement("path", { class: css, d: pathOf(points, false) }));
}

function drawLogY(chart, y, title, most) {
  const { inner } = chart;
  for (const { value, text } of decadeTicks(y.low, y.high, most)) {
    chartLine(chart, "grid", [[inner.left, y(value)], [inner.right, y(value)]]);
    chartText(chart, "tick", inner.left - 6, y(value) + 4, text, "end");
  }
  const middleY = (inner.top + inner.bottom) / 2;
  chartText(chart, "axis", 12, middleY, title, "middle", { transform: `rotate(-90 12 ${pixels(middleY)})` });
}

function drawX(chart, x, title, ticks) {
  const { inner } = chart;
  for (const { value, text } of ticks) {
    chartLine(chart, "grid", [[x(value), inner.top], [x(value), inner.bottom]]);
    chartText(chart, "tick", x(value), inner.bottom + 15, text);
  }
  chartText(chart, "axis", (inner.left + inner.right) / 2, chart.height - 5, title);
}

// A mark with values to show: `lines` are the tooltip's.
function chartMark(chart, css, [x, y], radius, lines) {
  chart.svg.append(svgElement("circle", { class: `${css} mark-target`, cx: pixels(x), cy: pixels(y), r: radius,
    tabindex: "0", role: "img", "aria-label": lines.filter(Boolean).map((line) => line.replaceAll(", ", " ")).join(", ") }));
}

// `entries` are [colour, text].
function legend(entries, css = "swatch") {
  return element("ul", { class: "legend" }, entries.map(([color, text]) =>
    element("li", {}, element("i", { class: `${css} ${color}`, "aria-hidden": "true" }), text)));
}

// A small plot. A line is {name, color, points}, a point {x, y, lines, isBreak}; `scaleOfX(left, right)` places x, with `ticks`.
function lineChart({ caption = "", label, titles: [titleX, titleY], scaleOfX, lines }) {
  const chart = makeChart(380, 250, label);
  const { left, right, top, bottom } = chart.inner;
  const x = scaleOfX(left + 8, right - 8);
  const y = logScale(decadesAround(lines.flatMap(({ points }) => points.map((point) => point.y)).filter((value) => value > 1e-20)), bottom, top);
  drawLogY(chart, y, titleY, 5);
  drawX(chart, x, titleX, x.ticks);
  for (const { name, color, points } of lines) {
    const there = points.filter((point) => Number.isFinite(point.x) && Number.isFinite(point.y))
      .map((point) => ({ ...point, at: [x(point.x), y(point.y)] }));
    chartLine(chart, `line ${color}`, there.map(({ at }) => at));
    for (const { at, isBreak, lines: told } of there) {
      const [cx, cy] = at.map(pixels);
      if (isBreak) chart.svg.append(svgElement("path", { class: `break ${color}`, d: `M${cx - 5} ${cy - 5}l10 10m0 -10l-10 10` }));
      chartMark(chart, `line-point ${color}`, at, 4, [name, ...told]);
    }
  }
  return element("figure", { class: "small-plot" }, caption && element("figcaption", {}, caption), chart.svg,
    legend(lines.map(({ name, color }) => [color, name])));
}

// A figure that is drawn again whenever one of its choices changes.
function chosenFigure(choices, draw) {
  const chosen = Object.fromEntries(choices.map(({ name, options }) => [name, options[0][0]]));
  const drawing = element("div", { class: "drawing" });
  const redraw = () => drawing.replaceChildren(...draw(chosen));
  const fields = choices.filter(({ options }) => options.length > 1).map(({ name, label, options }) =>
    select(label, options, chosen[name], (value) => { chosen[name] = value; redraw(); }));
  redraw();
  return element("figure", { class: "chosen" }, fields.length > 0 && element("div", { class: "fields" }, fields), drawing);
}

// A share as a bar.
function meter(share, css = "") {
  const width = share > 0 ? `max(2px, ${(100 * share).toFixed(2)}%)` : "0";
  return element("span", { class: `meter ${css}`, "aria-hidden": "true" }, element("i", { style: `width: ${width}` }));
}

function withMeter(share, text, css) {
  return element("span", { class: "with-meter" }, meter(share, css), element("span", {}, text));
}
