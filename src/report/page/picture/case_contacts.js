// What the colliders and the truth say of a case: reference face, incident edge, side planes, normal, points, depths.

const ARROW = 44;

// The manifold of an answer that is drawn: of the truth's, the one that was stepped to.
function shownManifold(view, role) {
  const answer = answerOf(view.one, role);
  if (!answer || !view.show[role]) return null;
  return answer.manifolds[role === "truth" ? view.right : 0] ?? null;
}

// Whose reference face is drawn thick: the truth's, else the subject's, else the oracle's.
function frameManifold(view) {
  return ROLES.map((role) => shownManifold(view, role))
    .find((manifold) => manifold && manifold.points.length > 0 && referenceFace(view.one, manifold)) ?? null;
}

function referenceFace(one, manifold) {
  const body = one.bodies[SIDES.indexOf(manifold.reference)];
  return body ? faceOf(body, manifold.face) : null;
}

function incidentEdge(one, manifold) {
  const body = one.bodies[1 - SIDES.indexOf(manifold.reference)];
  return body ? faceOf(body, manifold.edge) : null;
}

// The direction from the incident side to the reference's outside.
function outwardDirection(manifold) {
  if (!isPoint(manifold.normal)) return null;
  const normal = unit(manifold.normal);
  return manifold.reference === "b" ? [-normal[0], -normal[1]] : normal;
}

// A depth as a line: from the incident skin below the point to the reference skin above it.
function depthBar(one, manifold, point) {
  const outward = outwardDirection(manifold);
  if (!isPoint(point.position) || !outward) return null;
  const incident = one.bodies[manifold.reference === "b" ? 0 : 1];
  const from = along(point.position, outward, -(incident?.radius || 0));
  return [from, along(from, outward, point.depth || 0)];
}

function drawSidePlanes(view, face) {
  const tangent = unit(minus(face[1], face[0]));
  const away = quarterLeft(tangent);
  const reach = 4 * Math.max(view.camera.width, view.camera.height) / view.camera.scale;
  [-1, 1].forEach((sign, i) => {
    const through = along(face[i], tangent, sign * (view.one.total_radius || 0));
    const foot = along(through, away, cross(tangent, minus([view.camera.x, view.camera.y], through)));
    drawSegment(view, "planes", `plane ${i}`, [along(foot, away, -reach), along(foot, away, reach)], "plane");
  });
}

function drawNormal(view, face, manifold) {
  const seen = clipSegmentToBox(face, view.frame);
  if (!seen || !isPoint(manifold.normal)) return;
  const from = toScreen(view.camera, middle(...seen));
  const [x, y] = unit(manifold.normal);
  const length = view.isThumbnail ? ARROW / 2 : ARROW;
  const tip = [from[0] + length * x, from[1] - length * y];
  const head = view.isThumbnail ? 5 : 8;
  const neck = [tip[0] - head * x, tip[1] + head * y];
  const wing = (sign) => [neck[0] + sign * head * 0.42 * y, neck[1] + sign * head * 0.42 * x];
  view.painter.put("normal", "shaft", "path", { class: "normal", d: pathOf([from, neck], false) });
  view.painter.put("normal", "head", "path", { class: "arrow", d: pathOf([tip, wing(1), wing(-1)], true) });
}

function drawFrame(view) {
  const manifold = frameManifold(view);
  if (!manifold) return;
  const face = referenceFace(view.one, manifold);
  const edge = incidentEdge(view.one, manifold);
  if (view.show.planes && !view.isThumbnail) drawSidePlanes(view, face);
  if (edge) drawSegment(view, "thick", "incident", edge, "incident");
  drawSegment(view, "thick", "reference", face, "reference");
  drawNormal(view, face, manifold);
}

// Told apart by shape as well as by colour: a ring for the truth, a disc for the subject, a square for the oracle.
function putMark(view, role, key, [x, y]) {
  const size = view.isThumbnail ? 0.62 : 1;
  const css = `mark ${role}`;
  if (role === "oracle") {
    const half = 6.5 * size;
    view.painter.put("marks", key, "rect",
      { class: css, x: pixels(x - half), y: pixels(y - half), width: 2 * half, height: 2 * half });
  } else {
    const radius = (role === "truth" ? 10 : 5) * size;
    view.painter.put("marks", key, "circle", { class: css, cx: pixels(x), cy: pixels(y), r: radius });
  }
}

function drawPoint(view, role, manifold, index) {
  const point = manifold.points[index];
  if (!isPoint(point.position)) return;
  const key = `point ${role} ${index}`;
  const bar = depthBar(view.one, manifold, point);
  if (bar) drawSegment(view, "bars", key, bar, `depth-bar ${role}`);
  if (!isSeen(view, point.position)) return;
  const at = toScreen(view.camera, point.position);
  putMark(view, role, key, at);
  view.labels.take({ left: at[0] - 8, right: at[0] + 8, top: at[1] - 8, bottom: at[1] + 8 });
  const radius = role === "truth" ? 12 : 9;
  putTarget(view, key, "circle", { cx: pixels(at[0]), cy: pixels(at[1]), r: radius }, true);
}

// Points of the subject lie on top: targets come in the same order.
function drawPoints(view) {
  for (const role of ["truth", "oracle", "subject"]) {
    const manifold = shownManifold(view, role);
    manifold?.points.forEach((point, i) => drawPoint(view, role, manifold, i));
  }
}

// One label a place: what colliders agree on is written once.
function drawDepthLabels(view) {
  const written = [];
  for (const role of ROLES) {
    const manifold = shownManifold(view, role);
    manifold?.points.forEach((point, i) => {
      if (!isPoint(point.position) || !isSeen(view, point.position)) return;
      const at = toScreen(view.camera, point.position);
      const text = brief(point.depth);
      if (written.some((other) => other.text === text && distance(other.at, at) < 24)) return;
      written.push({ at, text });
      const outward = outwardDirection(manifold) ?? [0, 1];
      const box = view.labels.find(at, `depth ${text}`, { gaps: [13, 26], towards: [-outward[0], outward[1]] });
      putLabel(view, `depth ${role} ${i}`, box, `depth ${text}`, `depth-word ${role}`);
    });
  }
}
