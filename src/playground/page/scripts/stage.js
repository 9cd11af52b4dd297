// The picture of the two shapes and of one step. Places are the world's, seen from `origin`, where A stood when the case was
// opened: so that A can be moved, and cases far from the origin are drawn as exactly as others.

const STAGE_LAYERS = ["fills", "overlap", "edges", "lines", "thick", "points", "labels", "handles"];

function turn([cos, sin], [x, y]) {
  return [cos * x - sin * y, sin * x + cos * y];
}

// A body's vertices in the picture.
function placedVertices({ vertices, position, rotation }, origin) {
  const at = minus(position, origin);
  return vertices.map((vertex) => along(at, turn(rotation, vertex), 1));
}

function placedShapes(pair, origin) {
  return Object.fromEntries(SIDES.map((side) => [side,
    { vertices: placedVertices(pair[side], origin), radius: pair[side].radius, corners: pair[side].rounding }]));
}

// The corners of a radius that is mitred reach farther, and are not waited for.
const shapesBox = (shapes) => boxOf(SIDES.flatMap((side) => {
  const { vertices, radius } = shapes[side];
  return vertices.flatMap((vertex) => [along(vertex, [radius, radius], -1), along(vertex, [radius, radius], 1)]);
}));

// What draws on a picture: every method takes places of the world.
function makePen(painter, camera, seen) {
  const at = (place) => toScreen(camera, place);
  return {
    camera,
    line(layer, key, css, from, to) {
      const part = clipSegmentToBox([from, to], seen);
      if (part) painter.put(layer, key, "path", { class: css, d: pathOf(part.map(at), false) });
    },
    area(layer, key, css, polygon) {
      const part = clipPolygonToBox(polygon, seen);
      if (part.length >= 3) painter.put(layer, key, "path", { class: css, d: pathOf(part.map(at), true) });
    },
    dot(layer, key, css, place, radius) {
      const [cx, cy] = at(place).map(pixels);
      painter.put(layer, key, "circle", { class: css, cx, cy, r: radius });
    },
    cross(layer, key, css, place, reach) {
      const [x, y] = at(place).map(Number);
      painter.put(layer, key, "path", { class: css,
        d: `M${pixels(x - reach)} ${pixels(y - reach)}l${2 * reach} ${2 * reach}m0 ${-2 * reach}l${-2 * reach} ${2 * reach}` });
    },
    arrow(key, css, from, direction, length) {
      const start = at(from);
      const [x, y] = [direction[0], -direction[1]];
      const tip = along(start, [x, y], length);
      const barb = (side) => along(along(tip, [x, y], -9), [-y, x], 4.5 * side);
      painter.put("lines", `${key} shaft`, "path", { class: css, d: pathOf([start, along(tip, [x, y], -7)], false) });
      painter.put("lines", `${key} head`, "path", { class: `${css} arrow`, d: pathOf([tip, barb(1), barb(-1)], true) });
    },
    label(key, css, place, text, right = 0, down = 0) {
      const [x, y] = at(place);
      painter.put("labels", key, "text", { class: css, x: pixels(x + right), y: pixels(y + down + 4), "text-anchor": "middle" }, text);
    },
  };
}

const faceOf = (shape, i) => [shape.vertices[i], shape.vertices[(i + 1) % shape.vertices.length]];
const nameOf = (side) => side.toUpperCase();
const otherSide = (side) => (side === "a" ? "b" : "a");

function drawShapes(pen, shapes, isFlat) {
  const outlines = SIDES.map((side) => outlineOf(shapes[side], isFlat));
  SIDES.forEach((side, i) => {
    pen.area("fills", side, `fill ${side}`, outlines[i]);
    facesOf(outlines[i]).forEach(([from, to], j) => pen.line("edges", `rim ${side} ${j}`, `edge ${side}`, from, to));
    if (shapes[side].radius > 0) {
      facesOf(shapes[side].vertices).forEach(([from, to], j) => pen.line("edges", `core ${side} ${j}`, `skin ${side}`, from, to));
    }
    const center = centroidOf(shapes[side].vertices);
    pen.label(`name ${side}`, `letter ${side}`, center, nameOf(side), 14, -14);
  });
  const common = overlapOf(outlines[0], outlines[1]);
  if (common.length >= 3) pen.area("overlap", "overlap", "overlap", common);
}

function centroidOf(vertices) {
  return vertices.reduce((sum, vertex) => along(sum, vertex, 1 / vertices.length), [0, 0]);
}

// The face of greatest separation of a side, and the distance to the other's deepest vertex.
function drawSeparation(pen, shapes, told, side) {
  const { faces, greatest } = told.sides[side];
  if (greatest < 0) return;
  const [from, to] = faceOf(shapes[side], greatest);
  const { separation, deepest } = faces[greatest];
  const vertex = shapes[otherSide(side)].vertices[deepest];
  const outward = outwardOf([from, to]);
  const foot = along(vertex, outward, -separation);
  pen.line("thick", `greatest ${side}`, `greatest ${side}`, from, to);
  pen.line("lines", `extended ${side}`, "plane", from, foot);
  pen.line("lines", `separation ${side}`, `measure ${side}`, foot, vertex);
  pen.dot("points", `deepest ${side}`, `deepest ${side}`, vertex, 4);
}

function drawNearest(pen, told) {
  const [onA, onB] = told.nearest.places;
  pen.line("lines", "nearest", "measure", onA, onB);
  pen.dot("points", "nearest a", "deepest a", onA, 4);
  pen.dot("points", "nearest b", "deepest b", onB, 4);
}

function drawReference(pen, shapes, told) {
  const face = faceOf(shapes[told.features.side], told.features.reference);
  pen.line("thick", "reference", "reference", ...face);
  pen.arrow("reference", "normal", middle(...face), told.outward, 46);
}

function drawIncident(pen, told) {
  const [from, to] = told.whole.map(({ at }) => at);
  pen.line("thick", "incident", "incident whole", from, to);
}

function drawSideClip(pen, told, i, isNow) {
  const { corner, inward, leaves, edge } = told.sideClips[i];
  const base = along(corner, inward, -told.margin);
  pen.line("lines", `plane ${i}`, isNow ? "plane now" : "plane", along(base, told.outward, 1e4 / pen.camera.scale),
    along(base, told.outward, -1e4 / pen.camera.scale));
  if (isNow) pen.arrow(`plane ${i}`, "inward", along(base, told.outward, 60 / pen.camera.scale), inward, 34);
  if (isNow && leaves) drawKept(pen, edge);
}

function drawKept(pen, edge) {
  pen.line("thick", "kept", "incident", ...edge.map(({ at }) => at));
  edge.forEach(({ at }, i) => pen.dot("points", `end ${i}`, "end", at, 4.5));
}

// The reference face's line, moved out by the total radius, and how far each end lies behind it.
function drawLastClip(pen, shapes, told) {
  const [from, to] = faceOf(shapes[told.features.side], told.features.reference)
    .map((place) => along(place, told.outward, told.totalRadius));
  const far = 1e4 / pen.camera.scale;
  const direction = unit(minus(to, from));
  pen.line("lines", "face", "plane now", along(from, direction, -far), along(to, direction, far));
  told.sideClips[1].edge.forEach(({ at }, i) => {
    const depth = told.totalRadius - told.inFront[i];
    pen.dot("points", `end ${i}`, depth >= 0 ? "end kept" : "end dropped", at, 4.5);
    if (depth >= 0) pen.line("lines", `depth ${i}`, "depth", at, along(at, told.outward, depth));
  });
}

function drawAnswers(pen, told) {
  told.answers.forEach(({ points, normal }, i) => {
    const css = i === 0 ? "subject" : "oracle";
    points.forEach(({ at, depth }, j) => {
      pen.line("lines", `depth ${css} ${j}`, `depth-bar ${css}`, at, along(at, normal, (told.answers[i].side === "a" ? 1 : -1) * depth));
      if (i === 0) pen.dot("points", `point ${css} ${j}`, `mark ${css}`, at, 5);
      else pen.cross("points", `point ${css} ${j}`, `mark ${css}`, at, 6);
    });
    if (i === 0 && points.length > 0) pen.arrow("normal", "normal", centroidOf(points.map(({ at }) => at)), normal, 46);
  });
}

// What the step shows, over the shapes.
function drawStep(pen, shapes, told, step) {
  const { isThere } = told.features;
  if (step === 0) {
    if (told.nearest.isThere) drawNearest(pen, told);
    else for (const side of SIDES) drawSeparation(pen, shapes, told, side);
    return;
  }
  if (isThere) drawReference(pen, shapes, told);
  if (isThere && step >= 2) drawIncident(pen, told);
  if (isThere && step >= 3) drawSideClip(pen, told, 0, step === 3);
  if (isThere && step >= 4 && told.sideClips[0].leaves) drawSideClip(pen, told, 1, step === 4);
  if (isThere && step >= 5 && told.sideClips[1].leaves) {
    if (step === 5) drawKept(pen, told.sideClips[1].edge);
    if (step === 5) drawLastClip(pen, shapes, told);
  }
  if (step === LAST_STEP) drawAnswers(pen, told);
}
