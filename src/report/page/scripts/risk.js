// What is left to find: buckets against cases, and the chance that the next case shows one that was not seen.

const CURVES = [["buckets", "c0", 1], ["with somebody wrong", "c5", 2]];

function inAMillion(chance) {
  const million = 1e6 * chance;
  return million >= 9.95 ? whole(Math.round(million)) : String(Number(million.toPrecision(2)));
}

function intervalInWords({ low, high }) {
  return `${inAMillion(low)} to ${inAMillion(high)}`;
}

function riskSentence({ wrong, ...any }) {
  return `A bucket not yet seen: ${inAMillion(any.next)} in a million further cases (95% interval: ${intervalInWords(any)}). `
    + `A wrong one: ${inAMillion(wrong.next)} (${intervalInWords(wrong)}).`;
}

// Whole steps of 1, 2 or 5 times a power of ten, at most six.
function linearTicks(most) {
  const power = 10 ** Math.floor(Math.log10(Math.max(most, 1)));
  const step = [power / 5, power / 2, power, 2 * power].find((one) => Number.isInteger(one) && most / one <= 6) ?? power;
  return Array.from({ length: Math.ceil(most / step) + 1 }, (_, i) => i * step);
}

// From case to case a curve stays as high as it is.
function stairs(points) {
  return points.flatMap(([x, y], i) => (i === 0 ? [[x, y]] : [[x, points[i - 1][1]], [x, y]]));
}

// A point is [cases, buckets, wrong buckets].
function drawBuckets(chart, { x, y }, curve, [name, color, column]) {
  const steps = curve.filter((point, i) => i === 0 || i === curve.length - 1 || point[column] > curve[i - 1][column]);
  chartLine(chart, `line ${color}`, stairs([[x(1), y(0)], ...steps.map((point) => [x(point[0]), y(point[column])])]));
  for (const point of steps) {
    chartMark(chart, `line-point ${color}`, [x(point[0]), y(point[column])], 4,
      [name, `${counted(point[column], "bucket")} in ${counted(point[0], "case")}`]);
  }
}

function bucketsFigure(read) {
  const curve = read.map((point) => point.map(Number));
  const most = curve.at(-1)?.[1];
  if (!(most > 0)) return null;
  const chart = makeChart(720, 300, "Different buckets seen, against cases");
  const { left, right, top, bottom } = chart.inner;
  const ticks = linearTicks(most);
  const y = (value) => bottom + (value / ticks.at(-1)) * (top - bottom);
  const cases = decadesAround(curve.map(([count]) => count).concat(1));
  const x = logScale(cases, left, right);
  for (const value of ticks) {
    chartLine(chart, "grid", [[left, y(value)], [right, y(value)]]);
    chartText(chart, "tick", left - 6, y(value) + 4, whole(value), "end");
  }
  chartText(chart, "axis", 12, (top + bottom) / 2, "different buckets seen", "middle", { transform: `rotate(-90 12 ${pixels((top + bottom) / 2)})` });
  drawX(chart, x, "cases", decadeTicks(x.low, x.high, 9));
  for (const one of CURVES) drawBuckets(chart, { x, y }, curve, one);
  return element("figure", { class: "curve-plot" }, chart.svg, legend(CURVES.map(([name, color]) => [color, name])));
}

function riskTable(rows) {
  const columns = (of, title) => [[`${title}met once`, (row) => whole(of(row).once), "number"], ["next", (row) => inAMillion(of(row).next), "number"],
    ["95% interval", (row) => intervalInWords(of(row)), "number"]];
  return table("Buckets not yet seen, in a million further cases", [["regime", ({ regime }) => words(regime)], ["cases", ({ cases }) => whole(cases), "number"],
    ...columns((row) => row, ""), ...columns(({ wrong }) => wrong, "wrong: ")], rows);
}

function riskParts({ result: { risk = [] }, curve = [] }) {
  const figure = bucketsFigure(curve);
  if (!figure && risk.length === 0) return [];
  return [element("h3", {}, "What is left to find"), risk.length > 0 && element("p", {}, riskSentence(risk.at(-1))), figure,
    risk.length > 0 && disclosure("By regime, in a million further cases", () => riskTable(risk))];
}
