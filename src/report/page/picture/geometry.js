// Points are [x, y] in doubles: world lengths, from A's position.

const along = (p, direction, length) => [p[0] + length * direction[0], p[1] + length * direction[1]];
const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const middle = (p, q) => [p[0] + (q[0] - p[0]) / 2, p[1] + (q[1] - p[1]) / 2];
const cross = (p, q) => p[0] * q[1] - p[1] * q[0];
const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
const quarterLeft = (p) => [-p[1], p[0]];

function unit(p) {
  const length = Math.hypot(p[0], p[1]);
  return length > 0 ? [p[0] / length, p[1] / length] : [0, 0];
}

function faceOf(body, index) {
  const { vertices } = body;
  if (!Number.isInteger(index) || index < 0 || index >= vertices.length) return null;
  return [vertices[index], vertices[(index + 1) % vertices.length]];
}

function outwardOf([from, to]) {
  const [x, y] = unit(minus(to, from));
  return [y, -x];
}

function boxOf(points, margin = 0) {
  const box = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const [x, y] of points) {
    box.left = Math.min(box.left, x - margin);
    box.right = Math.max(box.right, x + margin);
    box.bottom = Math.min(box.bottom, y - margin);
    box.top = Math.max(box.top, y + margin);
  }
  return box;
}

// The part of a convex polygon at which `height`, linear in the point, is not negative.
function clipPolygon(polygon, height) {
  const kept = [];
  for (let i = 0; i < polygon.length; ++i) {
    const from = polygon[i];
    const to = polygon[(i + 1) % polygon.length];
    const [start, end] = [height(from), height(to)];
    if (start >= 0) kept.push(from);
    if ((start < 0 && end > 0) || (start > 0 && end < 0)) {
      kept.push(along(from, minus(to, from), start / (start - end)));
    }
  }
  return kept;
}

function clipPolygonToBox(polygon, box) {
  const sides = [(p) => p[0] - box.left, (p) => box.right - p[0], (p) => p[1] - box.bottom, (p) => box.top - p[1]];
  return sides.reduce(clipPolygon, polygon);
}

// The part of the segment in the box, or null; ends that lie inside stay as they are, bit for bit.
function clipSegmentToBox([from, to], box) {
  const step = minus(to, from);
  let [enter, leave] = [0, 1];
  const edges = [[from[0] - box.left, step[0]], [box.right - from[0], -step[0]],
    [from[1] - box.bottom, step[1]], [box.top - from[1], -step[1]]];
  for (const [height, slope] of edges) {
    if (slope === 0 && height < 0) return null;
    if (slope > 0) enter = Math.max(enter, -height / slope);
    if (slope < 0) leave = Math.min(leave, height / -slope);
  }
  if (enter > leave) return null;
  return [enter === 0 ? from : along(from, step, enter), leave === 1 ? to : along(from, step, leave)];
}

// What two convex polygons, counter-clockwise, have in common.
function overlapOf(a, b) {
  let common = a;
  for (let i = 0; i < b.length && common.length > 0; ++i) {
    const from = b[i];
    const direction = unit(minus(b[(i + 1) % b.length], from));
    if (direction[0] !== 0 || direction[1] !== 0) {
      common = clipPolygon(common, (p) => cross(direction, minus(p, from)));
    }
  }
  return common.length >= 3 ? common : [];
}

// How thick a convex polygon is where it is thinnest.
function thicknessOf(polygon) {
  return Math.min(...polygon.map((from, i) => {
    const direction = unit(minus(polygon[(i + 1) % polygon.length], from));
    const away = polygon.map((point) => cross(direction, minus(point, from)));
    return direction[0] === 0 && direction[1] === 0 ? Infinity : Math.max(...away);
  }));
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

// The polygon widened by its radius.
function outlineOf(body, isFlat) {
  const { vertices, radius } = body;
  if (!(radius > 0)) return vertices;
  const points = [];
  vertices.forEach((vertex, i) => {
    const before = outwardOf(faceOf(body, (i + vertices.length - 1) % vertices.length));
    const after = outwardOf(faceOf(body, i));
    const from = Math.atan2(before[1], before[0]);
    const turn = Math.atan2(cross(before, after), before[0] * after[0] + before[1] * after[1]);
    points.push(...arcPoints(vertex, radius, from, from + turn, isFlat), along(vertex, after, radius));
  });
  return points;
}
