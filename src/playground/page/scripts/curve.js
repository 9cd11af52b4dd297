// The penetration curve: for each direction, how far B must be moved that way to leave A. As the report draws it.

const PLOT = 580;
const LEVEL = 150;   // the radius of depth 0
const REACH = 270;   // the farthest that the curve gets from the middle
const CRATER = 60;   // the nearest
const SHAPES = 52;   // the radius that both shapes fit into, in the middle

const atAngle = (angle) => [Math.cos(angle), Math.sin(angle)];

function curveScale({ least, samples }) {
  const deepest = Math.max(...samples.map(([, depth]) => depth), 0);
  const out = deepest > 0 ? (REACH - LEVEL) / deepest : Infinity;
  const scale = least < 0 ? Math.min(out, (LEVEL - CRATER) / -least) : out;
  return Number.isFinite(scale) ? scale : 1;
}

// 1, 2 or 5 times a power of ten, not above the value.
function roundBelow(value) {
  const power = 10 ** Math.floor(Math.log10(value));
  return [5, 2, 1].map((times) => times * power).find((round) => round <= value) ?? power;
}

function drawCurve(painter, told, shapes) {
  const { curve } = told;
  const scale = curveScale(curve);
  const center = [PLOT / 2, PLOT / 2];
  const place = ([x, y], depth) => along(center, [x, -y], LEVEL + scale * depth);
  drawSmallShapes(painter, shapes, center);
  const level = (key, depth, text) => {
    const radius = LEVEL + scale * depth;
    painter.put("levels", key, "circle", { class: "level", cx: center[0], cy: center[1], r: pixels(radius) });
    const isBelow = (curve.minima[0]?.[1] ?? 0) > 0;
    painter.put("texts", key, "text", { x: center[0], y: pixels(center[1] + (isBelow ? radius : -radius) + 7), "text-anchor": "middle" }, text);
  };
  level("zero", 0, "depth 0: they touch");
  const round = roundBelow((0.8 * (REACH - LEVEL)) / scale);
  level("round", round, `depth ${brief(round)}`);
  painter.put("line", "curve", "path", { class: "depths", d: pathOf(curve.samples.map(([angle, depth]) => place(atAngle(angle), depth)), true) });
  curve.minima.forEach((normal, i) => {
    const [cx, cy] = place(normal, curve.least).map(pixels);
    painter.put("marks", `ring ${i}`, "circle", { class: "ring", cx, cy, r: 15 });
  });
  drawCurveAnswers(painter, told, center, place);
}

function drawCurveAnswers(painter, told, center, place) {
  for (const i of [1, 0]) {
    const { points, normal } = told.answers[i];
    if (points.length === 0) continue;
    const css = i === 0 ? "subject" : "oracle";
    const at = place(normal, Math.max(...points.map(({ depth }) => depth)));
    const start = along(center, [normal[0], -normal[1]], SHAPES + 8);
    painter.put("marks", `ray ${css}`, "path", { class: `ray ${css}`, d: pathOf([start, at], false) });
    const [cx, cy] = at.map(pixels).map(Number);
    if (i === 0) painter.put("marks", css, "circle", { class: "mark subject", cx, cy, r: 7 });
    else painter.put("marks", css, "path", { class: "mark oracle", d: `M${cx - 9} ${cy - 9}l18 18m0 -18l-18 18` });
  }
}

function drawSmallShapes(painter, shapes, center) {
  const drawn = SIDES.map((side) => ({ ...shapes[side], radius: shapes[side].corners === "round" ? shapes[side].radius : 0 }));
  const outlines = drawn.map((shape) => outlineOf(shape, (from, to, sagitta) => sagitta < 0.02 * shape.radius));
  const box = boxOf(outlines.flat());
  const middleOfBox = centerOf(box);
  const scale = SHAPES / (Math.hypot(box.right - box.left, box.top - box.bottom) / 2 || 1);
  SIDES.forEach((side, i) => {
    const d = pathOf(outlines[i].map((point) => {
      const [x, y] = minus(point, middleOfBox);
      return [center[0] + scale * x, center[1] - scale * y];
    }), true);
    painter.put("shapes", `fill ${side}`, "path", { class: `fill ${side}`, d });
    painter.put("shapes", `edge ${side}`, "path", { class: `edge ${side}`, d });
  });
}

function curveInWords({ curve }) {
  const normals = curve.minima.map((normal) => `(${normal.map(brief).join(", ")})`);
  const name = normals.length > 1 ? "The least depth, which ties," : "The least depth";
  return `${name} is ${brief(curve.least)}, along ${normals.join(" and ")}.`;
}
