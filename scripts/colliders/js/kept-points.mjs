// Keeps the contact points of clips from frame to frame, as dyn4j's article describes it: each has
// an anchor on either body, its depth is what lies between them now, and it goes where it has become
// stale, or where one that is detected is at its place. The rules are those that `keeping` declares.

// What a point may move by, as a share of the smaller shape, and the radians that move it by as much.
const share = 0.02;

export const keeping = {
  gap: { relative: share }, drift: { relative: share }, turn: share,
  match: { relative: share }, match_by: "either", points_max: 3,
};

// How far a shape reaches from its own origin.
function reachOf({ stored, radius }) {
  return Math.max(...stored.vertices.map(({ x, y }) => Math.sqrt(x * x + y * y))) + radius;
}

const plus = (p, scale, q) => ({ x: p.x + scale * q.x, y: p.y + scale * q.y });
const dot = (p, q) => p.x * q.x + p.y * q.y;
const cross = (p, q) => p.x * q.y - p.y * q.x;
const apart = (p, q) => Math.hypot(p.x - q.x, p.y - q.y);
const unit = (v) => plus({ x: 0, y: 0 }, 1 / Math.hypot(v.x, v.y), v);

// What is kept lies in a body's own frame, that of the stored rotation: its length is not quite 1,
// and another one in each frame.
const rotationOf = ({ stored: { rotation: { c, s } } }) => ({ c, s });
const turned = ({ c, s }, v) => ({ x: c * v.x - s * v.y, y: s * v.x + c * v.y });
const turnedBack = ({ c, s }, v) => {
  const squared = c * c + s * s;
  return { x: (c * v.x + s * v.y) / squared, y: (c * v.y - s * v.x) / squared };
};
const placed = (body, v) => plus(body.pose.p, 1, turned(rotationOf(body), v));
const brought = (body, p) => turnedBack(rotationOf(body), plus(p, -1, body.pose.p));
const pairOf = ({ x, y }) => [x, y];

// A's rotation as B sees it.
function turnOf(a, b) {
  const { c, s } = rotationOf(a);
  return turnedBack(rotationOf(b), { x: c, y: s });
}

export class KeptPoints {
  points = [];
  frame = 0;
  nextId = 0;

  // `manifold` is that of polygons: {points: [{position, depth}], normal, reference}, the positions
  // on the incident edge of the core.
  next(a, b, manifold) {
    const length = share * Math.min(reachOf(a), reachOf(b));
    this.points = this.points.map((point) => this.now(point, a, b))
      .filter((point) => this.isFresh(point, a, b, length));
    const old = [...this.points];
    for (const found of manifold.points) this.add(this.bornOf(found, manifold, a, b), old, length);
    this.reduce();
    ++this.frame;
    return { points: this.points.map(saidOf) };
  }

  // As it is in this frame.
  now(point, a, b) {
    const normal = unit(turned(rotationOf(point.carrier === "a" ? a : b), point.ownNormal));
    const onA = placed(a, point.anchorA);
    const toA = plus(onA, -1, placed(b, point.anchorB));
    return { ...point, normal, onA, toA, depth: dot(normal, toA) };
  }

  isFresh(point, a, b, length) {
    const turn = turnOf(a, b);
    const angle = Math.atan2(cross(point.turn, turn), dot(point.turn, turn));
    return -point.depth <= length && Math.abs(cross(point.normal, point.toA)) <= length &&
      Math.abs(angle) <= share;
  }

  bornOf({ position, depth }, { normal: [nx, ny], reference }, a, b) {
    const normal = { x: nx, y: ny };
    const place = { x: position[0], y: position[1] };
    // From the incident edge to its surface, and through the overlap to the other one.
    const onA = plus(place, reference === "b" ? a.radius : depth - b.radius, normal);
    const onB = plus(place, reference === "b" ? a.radius - depth : -b.radius, normal);
    const carrier = reference;
    return {
      born: this.frame, carrier, normal, onA, depth, turn: turnOf(a, b),
      ownNormal: turnedBack(rotationOf(carrier === "a" ? a : b), normal),
      anchorA: brought(a, onA), anchorB: brought(b, onB),
    };
  }

  // It takes the place of the nearest of the old points that is within the match distance.
  add(point, old, length) {
    const distance = ({ anchorA, anchorB }) =>
      Math.min(apart(anchorA, point.anchorA), apart(anchorB, point.anchorB));
    const near = old.filter((other) => distance(other) <= length)
      .sort((p, q) => distance(p) - distance(q));
    const id = near.length > 0 ? near[0].id : this.nextId++;
    if (near.length > 0) {
      old.splice(old.indexOf(near[0]), 1);
      this.points.splice(this.points.indexOf(near[0]), 1);
    }
    this.points.push({ id, ...point });
  }

  // The deepest stays, and what is farthest to either side.
  reduce() {
    if (this.points.length < 3) return;
    const deepest = this.points.reduce((p, q) => (q.depth >= p.depth ? q : p));
    const place = ({ onA }) => cross(deepest.normal, onA);
    const first = this.points.reduce((p, q) => (place(q) < place(p) ? q : p));
    const last = this.points.reduce((p, q) => (place(q) > place(p) ? q : p));
    this.points = this.points.filter((point) => [deepest, first, last].includes(point));
  }
}

function saidOf({ id, born, depth, carrier, normal, anchorA, anchorB }) {
  return {
    id, born, depth, travels_with: carrier, normal: pairOf(normal),
    anchor_a: pairOf(anchorA), anchor_b: pairOf(anchorB),
  };
}
