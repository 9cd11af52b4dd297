// A case as a picture: the same one for the thumbnails and for the viewer.

const CASE_LAYERS = ["fills", "planes", "edges", "thick", "normal", "bars", "labels", "marks", "face-targets", "vertex-targets", "point-targets", "scale"];
const SHOW_ALL = { truth: true, subject: true, oracle: true, planes: true, numbers: true };
const THUMBNAIL = { width: 264, height: 168 };

// The middle of the first free place for a text beside the anchor, `gap` away in one of these directions; null if all are taken.
// `room` is {frame, taken}, in pixels.
function freePlace({ frame, taken }, [x, y], text, gap, directions) {
  const half = 3.4 * text.length + 2;
  for (const [right, down] of directions) {
    const center = [x + right * (half + gap), y + down * (8 + gap)];
    const box = boxOf([[center[0] - half, center[1] - 8], [center[0] + half, center[1] + 8]]);
    const isInside = box.left >= frame.left && box.right <= frame.right && box.bottom >= frame.bottom && box.top <= frame.top;
    if (!isInside || taken.some((other) => meets(box, other))) continue;
    taken.push(box);
    return center;
  }
  return null;
}

function putLabel(view, key, at, text, css) {
  view.painter.put("labels", key, "text", { class: css, x: pixels(at[0]), y: pixels(at[1] + 4), "text-anchor": "middle" }, text);
}

// Something that shows a tooltip; `key` says what it is. Points come in the order of tabs, the rest by keys.
function putTarget(view, key, tag, attributes) {
  if (!view.describe) return;
  const [kind] = key.split(" ");
  view.painter.put(`${kind}-targets`, key, tag, { class: `target ${kind}`, "data-key": key, tabindex: kind === "point" ? 0 : -1,
    role: "img", "aria-label": view.describe(key).join(", "), ...attributes });
}

// Segments as far as they can be seen.
function drawSegments(view, layer, key, segments, css) {
  const seen = segments.map((segment) => clipSegmentToBox(segment, view.seen)).filter(Boolean);
  if (seen.length === 0) return;
  const d = seen.map((segment) => pathOf(segment.map((point) => toScreen(view.camera, point)), false)).join("");
  view.painter.put(layer, key, "path", { class: css, d });
  if (key.startsWith("face")) putTarget(view, key, "path", { d });
}

function drawFill(view, key, polygon, css) {
  const seen = clipPolygonToBox(polygon, view.seen);
  if (seen.length < 3) return;
  const d = pathOf(seen.map((point) => toScreen(view.camera, point)), true);
  view.painter.put("fills", key, "path", { class: css, d });
}

function drawShapes(view) {
  const { outlines } = view;
  SIDES.forEach((side, i) => {
    const { vertices, radius, corners } = view.one.bodies[i];
    drawFill(view, side, corners === "round" ? outlines[i] : vertices, `fill ${side}`);
    if (vertices.length > 1) facesOf(vertices).forEach((face, f) => drawSegments(view, "edges", `face ${side}${f}`, [face], `edge ${side}`));
    if (radius > 0) drawSegments(view, "edges", `skin ${side}`, facesOf(outlines[i]), `skin ${side}`);
  });
  drawFill(view, "overlap", overlapOf(...outlines), "overlap");
}

function drawVertices(view) {
  SIDES.forEach((side, i) => {
    const { vertices } = view.one.bodies[i];
    const center = centerOf(boxOf(vertices));
    vertices.forEach((vertex, v) => {
      if (!contains(view.frame, vertex)) return;
      const at = toScreen(view.camera, vertex);
      putTarget(view, `vertex ${side}${v}`, "circle", { cx: pixels(at[0]), cy: pixels(at[1]), r: 7 });
      if (!view.show.numbers || view.isThumbnail) return;
      const [x, y] = unit(minus(vertex, center));
      const found = freePlace(view.room, at, String(v), 4, [[x, -y], [-x, -y], [x, y], [-x, y]]);
      if (found) putLabel(view, `number ${side}${v}`, found, String(v), `vertex ${side}`);
    });
  });
}

// The letters A and B where the page's data places them; closer, in the middle of what can be seen of each.
function drawLetters(view) {
  SIDES.forEach((side, i) => {
    const { vertices, corners, letter } = view.one.bodies[i];
    const seen = clipPolygonToBox(corners === "round" ? view.outlines[i] : vertices, view.frame);
    if (seen.length < (corners === "round" ? 2 : 3)) return;
    const at = toScreen(view.camera, contains(view.frame, letter) ? letter : centerOf(boxOf(seen)));
    const { left, right, bottom, top } = boxOf(seen);
    const isThin = Math.min(right - left, top - bottom) * view.camera.scale < 26;
    const aside = right - left < top - bottom ? [-1, 0] : [0, -1];
    const found = freePlace(view.room, at, "M", 4, [isThin ? aside : [0, 0], [0, -1], [0, 1], [-1, 0], [1, 0], [-2, -2], [2, 2]]);
    putLabel(view, `letter ${side}`, found ?? at, side.toUpperCase(), `letter ${side}`);
  });
}

function shownManifold(view, role) {
  return (view.show[role] && manifoldOf(answerOf(view.one, role), view.right)) || null;
}

// Lines without an end: each goes on from two of its points to what can be seen.
function drawSidePlanes(view, { planes }) {
  const { x, y, scale, width, height } = view.camera;
  const reach = 4 * Math.max(width, height) / scale;
  planes.forEach(([from, to], i) => {
    const direction = unit(minus(to, from));
    const foot = along(from, direction, dot(direction, minus([x, y], from)));
    drawSegments(view, "planes", `plane ${i}`, [[along(foot, direction, -reach), along(foot, direction, reach)]], "plane");
  });
}

function drawNormal(view, { face, normal }) {
  const seen = clipSegmentToBox(face, view.frame);
  if (!seen || !isPoint(normal)) return;
  const [right, up] = unit(normal);
  const direction = [right, -up];
  const from = toScreen(view.camera, middle(...seen));
  const [length, head] = view.isThumbnail ? [22, 5] : [44, 8];
  const tip = along(from, direction, length);
  const neck = along(tip, direction, -head);
  const wings = [0.42, -0.42].map((share) => along(neck, [up, right], share * head));
  view.painter.put("normal", "shaft", "path", { class: "normal", d: pathOf([from, neck], false) });
  view.painter.put("normal", "head", "path", { class: "arrow", d: pathOf([tip, ...wings], true) });
}

// The reference face is the truth's, else the subject's, else the oracle's.
function drawFrame(view) {
  const manifold = ROLES.map((role) => shownManifold(view, role)).find((one) => one?.face);
  if (!manifold) return;
  if (view.show.planes && !view.isThumbnail) drawSidePlanes(view, manifold);
  if (manifold.edge) drawSegments(view, "thick", "incident", [manifold.edge], "incident");
  drawSegments(view, "thick", "reference", [manifold.face], "reference");
  drawNormal(view, manifold);
}

// Told apart by shape as well as by colour: a ring for the truth, a disc for the subject, a square for the oracle.
function putMark(view, role, key, [x, y]) {
  const size = view.isThumbnail ? 0.62 : 1;
  if (role === "oracle") {
    const side = 13 * size;
    view.painter.put("marks", key, "rect", { class: "mark oracle", x: pixels(x - side / 2), y: pixels(y - side / 2), width: side, height: side });
  } else {
    view.painter.put("marks", key, "circle", { class: `mark ${role}`, cx: pixels(x), cy: pixels(y), r: (role === "truth" ? 10 : 5) * size });
  }
}

// Every contact point that is shown, those of the subject on top.
function shownPoints(view) {
  return ["truth", "oracle", "subject"].flatMap((role) => {
    const { points = [], outward = null } = shownManifold(view, role) ?? {};
    return points.map((point, i) => ({ role, key: `${role} ${i}`, outward, ...point })).filter(({ position }) => isPoint(position));
  });
}

function drawPoints(view) {
  for (const { role, key, position, bar } of shownPoints(view)) {
    if (bar) drawSegments(view, "bars", key, [bar], `depth-bar ${role}`);
    if (!contains(view.frame, position)) continue;
    const at = toScreen(view.camera, position);
    putMark(view, role, key, at);
    view.room.taken.push(boxOf([at], 8));
    putTarget(view, `point ${key}`, "circle", { cx: pixels(at[0]), cy: pixels(at[1]), r: role === "truth" ? 12 : 9 });
  }
}

// What colliders agree on is written once, on the incident side if there is room.
function drawDepthLabels(view) {
  const written = [];
  for (const { role, key, position, depth, outward } of shownPoints(view)) {
    const [at, text] = [toScreen(view.camera, position), `depth ${brief(depth)}`];
    if (!contains(view.frame, position) || written.some((other) => other.text === text && distance(other.at, at) < 24)) continue;
    written.push({ at, text });
    const [x, y] = outward ?? [0, 1];
    const found = freePlace(view.room, at, text, 12, [[-x, y], [x, -y], [y, x], [-y, -x], [-2 * x, 2 * y], [2 * x, -2 * y]]);
    putLabel(view, `depth ${key}`, found ?? along(at, [-x, y], 25), text, `depth-word ${role}`);
  }
}

function drawScaleBar(view) {
  // 1, 2 or 5 times a power of ten, about 110 pixels wide.
  const wanted = 110 / view.camera.scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const length = power * ([5, 2, 1].find((step) => step * power <= wanted) ?? 1);
  const [left, bottom] = [14, view.camera.height - 14];
  const right = left + length * view.camera.scale;
  const d = `M${left} ${bottom - 4}V${bottom + 4}M${left} ${bottom}H${pixels(right)}M${pixels(right)} ${bottom - 4}V${bottom + 4}`;
  view.painter.put("scale", "bar", "path", { class: "scale-bar", d });
  view.painter.put("scale", "length", "text", { class: "scale-word", x: pixels(right + 7), y: bottom + 4 }, brief(Number(length.toPrecision(1))));
  view.room.taken.push(boxOf([[left, bottom], [right + 60, bottom]], 12));
}

// `view` is {painter, camera, one, show, right, isThumbnail, describe}: `right` chooses among several right manifolds;
// `describe(key)` gives the lines of a tooltip, and without it nothing can be pointed at.
function drawCase(view) {
  const { camera } = view;
  view.seen = seenBox(camera);
  view.frame = seenBox(camera, 0);
  view.outlines = view.one.bodies.map((body) => outlineOf(body, flatFor(camera)));
  view.room = { taken: [], frame: { left: 4, right: camera.width - 4, bottom: 4, top: camera.height - 4 } };
  drawShapes(view);
  drawFrame(view);
  if (!view.isThumbnail) drawScaleBar(view);
  drawPoints(view);
  drawVertices(view);
  if (!view.isThumbnail) drawDepthLabels(view);
  drawLetters(view);
  view.painter.finish();
}

// Both polygons, and the points that colliders report beside them; what lies far off is left out.
function wholeCamera(one, width, height, margin) {
  const corners = one.bodies.flatMap(({ vertices, radius }) => {
    const { left, right, bottom, top } = boxOf(vertices, radius || 0);
    return [[left, bottom], [right, top]];
  });
  const box = boxOf(corners);
  const reach = 2 * Math.max(box.right - box.left, box.top - box.bottom);
  const points = one.answers.flatMap(({ manifolds }) => manifolds.flatMap((manifold) => manifold.points))
    .map(({ position }) => position).filter((position) => isPoint(position) && distance(position, centerOf(box)) < reach);
  return fitBox(boxOf([...corners, ...points]), width, height, margin);
}

// Fits some places with room around them; a single place is shown at a thousandth of the size.
function cameraOn(places, one, { width, height }) {
  const { left, right, bottom, top } = boxOf(places);
  const least = Math.max(right - left, top - bottom) > 0 ? 0 : (one.size || one.extent || 1) / 2000;
  return fitBox(boxOf(places, least), width, height, Math.min(width, height) * 0.2);
}

// Thumbnails are drawn while they are near the window and taken away when they are far: a page of a thousand cases holds a
// few dozen. On paper everything is drawn.
const paper = matchMedia("print");

const nearWindow = new IntersectionObserver((entries) => {
  for (const { isIntersecting, target } of entries) {
    if (isIntersecting || paper.matches) drawThumbnail(target);
    else target.replaceChildren();
  }
}, { rootMargin: "400px 0px" });

function drawThumbnail(holder) {
  const one = report.caseOf.get(holder.dataset.case);
  const { width, height } = THUMBNAIL;
  const svg = svgElement("svg", { viewBox: `0 0 ${width} ${height}`, class: "picture thumbnail", "aria-hidden": "true" });
  holder.replaceChildren(one.isDrawable ? svg : element("span", { class: "no-picture" }, "not drawable: a coordinate is not finite"));
  if (!one.isDrawable) return;
  drawCase({ painter: makePainter(svg, CASE_LAYERS), camera: wholeCamera(one, width, height, 18), one,
    show: SHOW_ALL, right: 0, isThumbnail: true });
}

function thumbnail(one) {
  const holder = element("span", { class: "thumbnail-holder", "data-case": one.id });
  nearWindow.observe(holder);
  return holder;
}
