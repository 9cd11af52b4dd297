// What can be dragged: vertices, a body as a whole, its rotation about its middle, its radius. A handle is [side, kind, index];
// `moved` gives the pair with a handle at a place of the picture, or a little farther.

const HANDLE_KINDS = { vertex: "vertex", move: "position", turn: "rotation", radius: "radius" };

function handlesOf(pair) {
  return SIDES.flatMap((side) => [["move", 0], ["turn", 0], ["radius", 0], ...pair[side].vertices.map((_, i) => ["vertex", i])]
    .map(([kind, index]) => ({ side, kind, index, key: `${side} ${kind} ${index}` })));
}

// A place on a body's core and the direction that its radius is dragged along.
function radiusBase(body, origin) {
  const vertices = placedVertices(body, origin);
  if (vertices.length === 1) return { base: vertices[0], outward: turn(body.rotation, [1, 0]) };
  const face = [vertices[0], vertices[1]];
  return { base: middle(...face), outward: outwardOf(face) };
}

// Where a handle is in the picture. That of a rotation stands off the body, by pixels.
function handlePlace({ side, kind, index }, pair, origin, camera) {
  const body = pair[side];
  const vertices = placedVertices(body, origin);
  if (kind === "vertex") return vertices[index];
  if (kind === "radius") {
    const { base, outward } = radiusBase(body, origin);
    return along(base, outward, body.radius);
  }
  const center = centroidOf(vertices);
  if (kind === "move") return vertices.length === 1 ? along(center, [0, 1], -16 / camera.scale) : center;
  const reach = Math.max(...vertices.map((vertex) => distance(vertex, center))) + body.radius;
  const up = turn(body.rotation, side === "a" ? [-Math.SQRT1_2, -Math.SQRT1_2] : [Math.SQRT1_2, Math.SQRT1_2]);
  return along(center, up, reach + 22 / camera.scale);
}

const floats = (pair) => pair.map(Math.fround);

// The body turned so that its middle stays where it is.
function turned(body, rotation) {
  const center = centroidOf(body.vertices);
  const before = along(body.position, turn(body.rotation, center), 1);
  const now = floats(rotation);
  return { ...body, rotation: now, position: floats(minus(before, turn(now, center))) };
}

function turnedBack([cos, sin], v) {
  const [x, y] = turn([cos, -sin], v);
  const square = cos * cos + sin * sin;
  return [x / square, y / square];
}

// The pair with the handle moved by [x, y] from where it was in `start`, the pair when the drag began.
function moved(start, { side, kind, index }, by, origin, camera) {
  const body = start[side];
  const changed = (change) => ({ ...start, [side]: { ...body, ...change } });
  if (kind === "move") return changed({ position: floats(along(body.position, by, 1)) });
  if (kind === "vertex") {
    const vertices = body.vertices.map((vertex, i) => (i === index ? floats(along(vertex, turnedBack(body.rotation, by), 1)) : vertex));
    return changed({ vertices });
  }
  if (kind === "radius") {
    return changed({ radius: Math.fround(Math.max(0, body.radius + dot(radiusBase(body, origin).outward, by))) });
  }
  const center = centroidOf(placedVertices(body, origin));
  const from = minus(handlePlace({ side, kind, index }, start, origin, camera), center);
  const to = along(from, by, 1);
  const [cos, sin] = unit([dot(from, to), cross(from, to)]);
  return { ...start, [side]: turned(body, unit(turn([cos, sin], body.rotation))) };
}

const TURN_STEP = Math.PI / 180;

// The pair with the handle moved by keys: right and up, in steps of `step`, a length; rotations in degrees.
function nudged(pair, handle, [right, up], step, origin, camera) {
  if (handle.kind === "turn") {
    const angle = TURN_STEP * (up - right);
    const body = pair[handle.side];
    return { ...pair, [handle.side]: turned(body, unit(turn([Math.cos(angle), Math.sin(angle)], body.rotation))) };
  }
  if (handle.kind === "radius") {
    const body = pair[handle.side];
    return { ...pair, [handle.side]: { ...body, radius: Math.fround(Math.max(0, body.radius + step * (right + up))) } };
  }
  return moved(pair, handle, [right * step, up * step], origin, camera);
}

// Where the handle is, in words.
function handleValue({ side, kind, index }, pair) {
  const body = pair[side];
  if (kind === "vertex") return `x ${brief(body.vertices[index][0])}, y ${brief(body.vertices[index][1])}`;
  if (kind === "move") return `x ${brief(body.position[0])}, y ${brief(body.position[1])}`;
  if (kind === "radius") return brief(body.radius);
  return `${brief(Math.atan2(body.rotation[1], body.rotation[0]) / TURN_STEP)} degrees`;
}

const handleName = ({ side, kind, index }) => `${nameOf(side)} ${HANDLE_KINDS[kind]}${kind === "vertex" ? ` ${index}` : ""}`;

// How far from the start of a drag the handle may go: all the way, or as far as the shape stays one, by halving.
function farthest(check, at) {
  const wanted = at(1);
  if (check(wanted) === "") return wanted;
  let [low, high] = [0, 1];
  let best = null;
  for (let i = 0; i < 12; ++i) {
    const share = (low + high) / 2;
    const candidate = at(share);
    if (check(candidate) === "") {
      best = candidate;
      low = share;
    } else {
      high = share;
    }
  }
  return best;
}

function drawHandles(painter, pair, origin, camera) {
  for (const handle of handlesOf(pair)) {
    const [x, y] = toScreen(camera, handlePlace(handle, pair, origin, camera)).map(pixels).map(Number);
    const { side, kind, key } = handle;
    if (kind === "turn") {
      const [cx, cy] = toScreen(camera, centroidOf(placedVertices(pair[side], origin)));
      const [from, to] = [[cx, cy], [x, y]];
      painter.put("handles", `${key} stalk`, "path", { class: `stalk ${side}`, d: pathOf([along(to, unit(minus(from, to)), 20), to], false) });
    }
    const label = { role: "slider", tabindex: 0, "aria-label": handleName(handle), "aria-valuetext": handleValue(handle, pair),
      "aria-valuenow": 0, "data-handle": key };
    const shape = kind === "radius"
      ? `M${x - 5} ${y}l5 -5l5 5l-5 5Z` : kind === "move" ? `M${x - 7} ${y}h14M${x} ${y - 7}v14` : null;
    if (shape) painter.put("handles", `${key} sign`, "path", { class: `sign ${kind} ${side}`, d: shape });
    else painter.put("handles", `${key} sign`, "circle", { class: `sign ${kind} ${side}`, cx: x, cy: y, r: 5 });
    painter.put("handles", key, "circle", { class: `handle ${kind}`, cx: x, cy: y, r: 14, ...label });
  }
}
