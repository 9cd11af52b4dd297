// Points [x, y], boxes and cameras, in doubles: world lengths, seen from A's position. A camera is {x, y, scale, width, height}:
// the world point at the middle, pixels a world length, pixels. Everything is clipped to what can be seen before it becomes
// pixels: browsers draw in floats, which zoom 1e6 exceeds.

const CLOSEST = 1e12;  // times the scale that shows everything: there doubles end
const FARTHEST = 1e-2;

const along = (p, direction, length) => [p[0] + length * direction[0], p[1] + length * direction[1]];
const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const middle = (p, q) => [p[0] + (q[0] - p[0]) / 2, p[1] + (q[1] - p[1]) / 2];
const cross = (p, q) => p[0] * q[1] - p[1] * q[0];
const dot = (p, q) => p[0] * q[0] + p[1] * q[1];
const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);

function unit(p) {
  const length = Math.hypot(p[0], p[1]);
  return length > 0 ? [p[0] / length, p[1] / length] : [0, 0];
}

// Each face of an outline, from its corner of the same number to the next.
const facesOf = (outline) => outline.map((point, i) => [point, outline[(i + 1) % outline.length]]);

function outwardOf([from, to]) {
  const [x, y] = unit(minus(to, from));
  return [y, -x];
}

function boxOf(points, margin = 0) {
  const [xs, ys] = [0, 1].map((axis) => points.map((point) => point[axis]));
  return { left: Math.min(...xs) - margin, right: Math.max(...xs) + margin,
    bottom: Math.min(...ys) - margin, top: Math.max(...ys) + margin };
}

const centerOf = ({ left, right, bottom, top }) => middle([left, bottom], [right, top]);

function meets(box, other) {
  return box.left <= other.right && other.left <= box.right && box.bottom <= other.top && other.bottom <= box.top;
}

const contains = (box, [x, y]) => meets(box, { left: x, right: x, bottom: y, top: y });

// The part of a convex polygon at which `height`, linear in the point, is not negative.
function clipPolygon(polygon, height) {
  return facesOf(polygon).flatMap(([from, to]) => {
    const [start, end] = [height(from), height(to)];
    const isCut = (start < 0 && end > 0) || (start > 0 && end < 0);
    return [...(start >= 0 ? [from] : []), ...(isCut ? [along(from, minus(to, from), start / (start - end))] : [])];
  });
}

function sidesOf({ left, right, bottom, top }) {
  return [([x]) => x - left, ([x]) => right - x, ([, y]) => y - bottom, ([, y]) => top - y];
}

const clipPolygonToBox = (polygon, box) => sidesOf(box).reduce(clipPolygon, polygon);

// The part of the segment in the box, or null; ends that lie inside stay as they are, bit for bit.
function clipSegmentToBox(segment, box) {
  // Of a cut segment the last corner is the cut once more.
  const part = sidesOf(box).reduce((rest, height) => clipPolygon(rest, height).slice(0, 2), segment);
  return part.length === 2 ? part : null;
}

// What two convex polygons, counter-clockwise, have in common.
function overlapOf(a, b) {
  const common = facesOf(b).filter(([from, to]) => distance(from, to) > 0).reduce((rest, face) => {
    const outward = outwardOf(face);
    return clipPolygon(rest, (point) => dot(outward, minus(face[0], point)));
  }, a);
  return common.length >= 3 ? common : [];
}

// The arc from angle `from` to `to`, in steps that `isFlat(start, end, sagitta)` accepts as straight; without its end.
function arcPoints(center, radius, from, to, isFlat, depth = 0) {
  const at = (angle) => along(center, [Math.cos(angle), Math.sin(angle)], radius);
  const sagitta = radius * (1 - Math.cos((to - from) / 2));
  if (depth >= 24 || isFlat(at(from), at(to), sagitta)) return [at(from)];
  const half = (from + to) / 2;
  return [...arcPoints(center, radius, from, half, isFlat, depth + 1),
    ...arcPoints(center, radius, half, to, isFlat, depth + 1)];
}

// The shape with its radius; `corners` are round, or as sharp as the core's.
function outlineOf({ vertices, radius, corners }, isFlat) {
  if (!(radius > 0)) return vertices;
  const arc = (center, from, to) => arcPoints(center, radius, from, to, isFlat);
  if (vertices.length === 1) return [...arc(vertices[0], 0, Math.PI), ...arc(vertices[0], Math.PI, 2 * Math.PI)];
  const outwards = facesOf(vertices).map(outwardOf);
  return vertices.flatMap((vertex, i) => {
    const [before, after] = [outwards.at(i - 1), outwards[i]];
    // Both faces are a radius farther out: their sum is 2 cos of half the turn long.
    const span = 1 + dot(before, after);
    if (corners === "mitre" && span > 0) return [along(vertex, along(before, after, 1), radius / span)];
    const from = Math.atan2(before[1], before[0]);
    const turn = Math.abs(Math.atan2(cross(before, after), dot(before, after)));
    return [...arc(vertex, from, from + turn), along(vertex, after, radius)];
  });
}

function toScreen(camera, [x, y]) {
  return [(x - camera.x) * camera.scale + camera.width / 2, camera.height / 2 - (y - camera.y) * camera.scale];
}

function toWorld(camera, [x, y]) {
  return [camera.x + (x - camera.width / 2) / camera.scale, camera.y - (y - camera.height / 2) / camera.scale];
}

function fitBox(box, width, height, margin) {
  const [across, up] = [box.right - box.left, box.top - box.bottom];
  const scale = Math.min((width - 2 * margin) / across, (height - 2 * margin) / up);
  const [x, y] = centerOf(box);
  return { x, y, width, height, scale: Number.isFinite(scale) && scale > 0 ? scale : 1 };
}

const panBy = (camera, right, down) => ({ ...camera, x: camera.x - right / camera.scale, y: camera.y + down / camera.scale });

// A scale within reach of the camera that shows everything.
const limitedScale = (scale, whole) => Math.min(Math.max(scale, whole.scale * FARTHEST), whole.scale * CLOSEST);

// What can be seen, and a little around it, in the world.
function seenBox(camera, around = 40) {
  return boxOf([toWorld(camera, [-around, -around]), toWorld(camera, [camera.width + around, camera.height + around])]);
}

// Whether a piece of an arc looks straight, or cannot be seen.
function flatFor(camera) {
  const seen = seenBox(camera);
  return (from, to, sagitta) => sagitta * camera.scale < 0.15 || !meets(boxOf([from, to], sagitta), seen);
}
