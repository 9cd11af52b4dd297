// The two polygons of a case: fills, overlap, edges, and what can be pointed at.

const SIDES = ["a", "b"];

function screenPath(view, points, isClosed) {
  return pathOf(points.map((point) => toScreen(view.camera, point)), isClosed);
}

// The segment as far as it can be seen, in pixels; null if not at all.
function seenSegment(view, segment) {
  const clipped = clipSegmentToBox(segment, view.seen);
  return clipped && clipped.map((point) => toScreen(view.camera, point));
}

function drawSegment(view, layer, key, segment, css) {
  const seen = seenSegment(view, segment);
  if (seen) view.painter.put(layer, key, "path", { class: css, d: pathOf(seen, false) });
  return seen;
}

function drawFill(view, key, polygon, css) {
  const seen = clipPolygonToBox(polygon, view.seen);
  if (seen.length >= 3) view.painter.put("fills", key, "path", { class: css, d: screenPath(view, seen, true) });
  return seen;
}

function outlineFaces(outline) {
  return outline.map((point, i) => [point, outline[(i + 1) % outline.length]]);
}

function drawSkin(view, side, outline) {
  const pieces = outlineFaces(outline).map((face) => clipSegmentToBox(face, view.seen)).filter(Boolean);
  if (pieces.length === 0) return;
  const d = pieces.map((piece) => screenPath(view, piece, false)).join("");
  view.painter.put("edges", `skin ${side}`, "path", { class: `skin ${side}`, d });
}

function drawShapes(view) {
  const isFlat = flatFor(view.camera);
  const outlines = view.one.bodies.map((body) => outlineOf(body, isFlat));
  SIDES.forEach((side, i) => {
    const body = view.one.bodies[i];
    drawFill(view, side, body.vertices, `fill ${side}`);
    outlineFaces(body.vertices).forEach((face, f) => drawSegment(view, "edges", `${side}${f}`, face, `edge ${side}`));
    if (body.radius > 0) drawSkin(view, side, outlines[i]);
  });
  drawFill(view, "overlap", overlapOf(...outlines), "overlap");
}

// The widest piece of `seen` beside the other polygon; all of it where there is none.
function ownPart(view, seen, other) {
  const pieces = outlineFaces(other.vertices).map(([from, to]) => {
    const direction = unit(minus(to, from));
    return clipPolygon(seen, (point) => cross(minus(point, from), direction));
  }).filter((piece) => piece.length >= 3 && thicknessOf(piece) * view.camera.scale > 8);
  return pieces.reduce((best, next) => (best === null || thicknessOf(next) > thicknessOf(best) ? next : best), null) ?? seen;
}

// The letters A and B, in the middle of what can be seen of each alone.
function drawLetters(view) {
  SIDES.forEach((side, i) => {
    const seen = clipPolygonToBox(view.one.bodies[i].vertices, view.frame);
    if (seen.length < 3) return;
    const box = boxOf(ownPart(view, seen, view.one.bodies[1 - i]).map((point) => toScreen(view.camera, point)));
    const center = [(box.left + box.right) / 2, (box.bottom + box.top) / 2];
    const isThin = Math.min(box.right - box.left, box.top - box.bottom) < 26;
    const letter = side.toUpperCase();
    const found = view.labels.find(center, letter, { gaps: isThin ? [9, 18] : [0, 12, 24], towards: i === 0 ? [-0.6, -1] : [0.6, -1], size: 16 });
    putLabel(view, `letter ${side}`, found, letter, `letter ${side}`);
  });
}

function putLabel(view, key, box, text, css) {
  if (box === null) return;
  view.painter.put("labels", key, "text",
    { class: css, x: pixels((box.left + box.right) / 2), y: pixels(box.bottom - 3.5), "text-anchor": "middle" }, text);
}

// From the polygon's middle outward: where the number of a vertex has room.
function awayFrom(body, vertex) {
  const box = boxOf(body.vertices);
  const [x, y] = unit(minus(vertex, [(box.left + box.right) / 2, (box.bottom + box.top) / 2]));
  return [x, -y];
}

function isSeen(view, point) {
  const { left, right, bottom, top } = view.frame;
  return point[0] >= left && point[0] <= right && point[1] >= bottom && point[1] <= top;
}

function drawVertices(view) {
  SIDES.forEach((side, i) => {
    const body = view.one.bodies[i];
    body.vertices.forEach((vertex, v) => {
      if (!isSeen(view, vertex)) return;
      const at = toScreen(view.camera, vertex);
      putTarget(view, `vertex ${side}${v}`, "circle", { cx: pixels(at[0]), cy: pixels(at[1]), r: 7 });
      if (!view.show.numbers || view.isThumbnail) return;
      const box = view.labels.find(at, String(v), { gaps: [5], towards: awayFrom(body, vertex), size: 11, isOptional: true });
      putLabel(view, `number ${side}${v}`, box, String(v), `vertex ${side}`);
    });
  });
}

function drawFaceTargets(view) {
  SIDES.forEach((side, i) => {
    outlineFaces(view.one.bodies[i].vertices).forEach((face, f) => {
      const seen = seenSegment(view, face);
      if (seen) putTarget(view, `face ${side}${f}`, "path", { d: pathOf(seen, false) });
    });
  });
}

// Something that shows a tooltip; `key` says what it is. Points come in the order of tabs, the rest by keys.
function putTarget(view, key, tag, attributes, isInTabs = false) {
  if (!view.describe) return;
  const [kind] = key.split(" ");
  view.painter.put(`${kind}-targets`, key, tag, {
    class: `target ${kind}`, "data-key": key, tabindex: isInTabs ? 0 : -1,
    role: "img", "aria-label": view.describe(key).join(", "), ...attributes,
  });
}
