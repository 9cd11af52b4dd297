// A case as a picture: the same one for the thumbnails and for the viewer.

const CASE_LAYERS = ["fills", "planes", "edges", "thick", "normal", "bars", "labels", "marks", "face-targets", "vertex-targets", "point-targets", "scale"];
const SHOW_ALL = { truth: true, subject: true, oracle: true, planes: true, numbers: true };

function wholeBox(one) {
  const boxes = one.bodies.map((body) => boxOf(body.vertices, body.radius || 0));
  return boxOf(boxes.flatMap((box) => [[box.left, box.bottom], [box.right, box.top]]));
}

// Both polygons, and the points that colliders report beside them; what lies far off is left out.
function wholeCamera(one, width, height, margin) {
  const box = wholeBox(one);
  const reach = 2 * Math.max(box.right - box.left, box.top - box.bottom);
  const center = middle([box.left, box.bottom], [box.right, box.top]);
  const points = one.answers.flatMap(({ manifolds }) => manifolds.flatMap((manifold) => manifold.points))
    .map(({ position }) => position).filter((position) => isPoint(position) && distance(position, center) < reach);
  return fitBox(boxOf([[box.left, box.bottom], [box.right, box.top], ...points]), width, height, margin);
}

// Every contact point that is shown, with both ends of its depth.
function contactPlaces(view) {
  return ROLES.flatMap((role) => {
    const manifold = shownManifold(view, role);
    return (manifold?.points ?? []).filter((point) => isPoint(point.position))
      .flatMap((point) => [point.position, ...(depthBar(view.one, manifold, point) ?? [])]);
  });
}

// Fits some places with room around them; a single place is shown at a thousandth of the size.
function cameraOn(places, one, width, height) {
  const box = boxOf(places);
  const span = Math.max(box.right - box.left, box.top - box.bottom);
  const least = span > 0 ? 0 : (one.size || one.extent || 1) / 2000;
  return fitBox(boxOf(places, least), width, height, Math.min(width, height) * 0.2);
}

function drawScaleBar(view) {
  const length = roundLength(view.camera, 110);
  const [left, bottom] = [14, view.camera.height - 14];
  const right = left + length * view.camera.scale;
  const d = `M${left} ${bottom - 4}V${bottom + 4}M${left} ${bottom}H${pixels(right)}M${pixels(right)} ${bottom - 4}V${bottom + 4}`;
  view.painter.put("scale", "bar", "path", { class: "scale-bar", d });
  const text = brief(Number(length.toPrecision(1)));
  view.painter.put("scale", "length", "text", { class: "scale-word", x: pixels(right + 7), y: bottom + 4 }, text);
  view.labels.take({ left, right: right + 20 + labelWidth(text), top: bottom - 12, bottom: bottom + 12 });
}

// `view` is {painter, camera, one, show, right, isThumbnail, describe}: `right` chooses among several right manifolds;
// `describe(key)` gives the lines of a tooltip, and without it nothing can be pointed at.
function drawCase(view) {
  const { camera } = view;
  view.seen = seenBox(camera);
  view.frame = seenBox(camera, 0);
  view.labels = makeLabels({ left: 4, right: camera.width - 4, top: 4, bottom: camera.height - 4 });
  drawShapes(view);
  drawFrame(view);
  drawFaceTargets(view);
  if (!view.isThumbnail) drawScaleBar(view);
  drawPoints(view);
  drawVertices(view);
  if (!view.isThumbnail) drawDepthLabels(view);
  drawLetters(view);
  view.painter.finish();
}
