// What every adapter in JavaScript does: `serve(declaration, collide)` reads case lines from stdin,
// writes the declaration and then an answer a line to stdout. src/external/README.md has all
// that may be declared and answered; this is what most need.
//
// `collide(a, b)` is called for each case. A body has
//   vertices  1 to 8 points {x, y} in its own frame: counter-clockwise, strictly convex, multiplied
//             by the length of the stored rotation, which is not quite 1 (see readBody)
//   normals   {x, y}, unit and outward, in that frame: normals[i] is that of the face from
//             vertices[i] to vertices[i + 1]
//   count     how many vertices there are; 2 of a segment or capsule, 1 of a circle, where
//             `vertices_min` declares that these are taken
//   radius    by which the shape is rounded; of two sharp polygons always 0 where
//             `takes_radius: false` is declared
//   round     whether corners are round; always so of circles, segments and capsules
//   pose      {p: {x, y}, q: {c, s}}, the rotation unit to the bits of a double: vertex v stands at
//             toWorld(pose, v) = [c v.x - s v.y + p.x, s v.x + c v.y + p.y] in the world
//   angle     of the stored rotation, for an engine that is given one (`rotation: "angle"`)
//   world     {x, y}, where the vertices stand in the world, each coordinate rounded once: for an
//             engine in double that turns by an angle, which then is 0; what is stored, exactly, is
//   stored    {vertices, rotation}, of floats: with the position, all that an engine in float needs
// Every length, depths too, is in the world's unit. Both bodies are new for each call: the engine
// may keep them and change them.
//
// It returns what is written for the case, positions and normals in the world:
//   {points: [{position: [x, y], depth}, ...], normal: [x, y]}
//                             1 or 2 points, each with the overlap there, 0 or more; the normal is
//                             unit, from A to B (from B to A where `normal: "b_to_a"` is declared)
//   {points: []}              no contact
//   {unsupported: "why"}      it cannot take this case
// It may add reference: "a" or "b", whose face clips, and to each point features: ["f0", "v2"], the
// face or vertex of A, then of B. An engine that gives less than a manifold declares what it
// `claims`, and returns
//   "point"       {points: [{position, depth}], normal}, or {points: []}
//   "separation"  {normal, depth}, the depth negative across a gap, or {touching: false}
//   "touching"    {touching: true} or {touching: false}
// One with a single depth for all points declares `depths: "shared"`, and returns
// {points: [{position}, ...], normal, depth}. Where it throws, the case is counted as crashed.
//
// `serveSequences(declaration, begin)` does the same for a program that keeps points from frame to
// frame: `begin()` is called at the first frame of each sequence, and the function that it returns
// is called with (a, b) for that frame and each after it. What that returns are kept points; see
// "Programs that keep points" of src/external/README.md.
import { readFileSync, realpathSync } from "node:fs";
import { fileURLToPath } from "node:url";

export function serve(declaration, collide) {
  return serveCases(declaration, ({ a, b }) => collide(readBody(a), readBody(b)));
}

export function serveSequences(declaration, begin) {
  let next;
  return serveCases(declaration, ({ frame, a, b }) => {
    if (frame === 0) next = begin();
    return next(readBody(a), readBody(b));
  });
}

// Whether a module, by its import.meta.url, is the program and not what another one imports.
export function isProgram(url) {
  return realpathSync(process.argv[1]) === realpathSync(fileURLToPath(url));
}

async function serveCases(declaration, answer) {
  process.stdout.write(JSON.stringify({ declaration }) + "\n");
  let unfinished = "";
  for await (const chunk of process.stdin.setEncoding("utf8")) {
    const lines = (unfinished + chunk).split("\n");
    unfinished = lines.pop();
    writeAnswers(lines, answer);
  }
  writeAnswers([unfinished], answer);
}

// All in one write. Where the engine throws, those before it still go out: they tell which case.
function writeAnswers(lines, answer) {
  let answers = "";
  try {
    for (const line of lines.filter((line) => line.trim())) {
      answers += JSON.stringify(answer(JSON.parse(line))) + "\n";
    }
  } finally {
    if (answers) process.stdout.write(answers);
  }
}

// Every number of a case is a float. The stored (cos, sin) is a unit vector to 32 bits only; these
// engines compute in 64 and take the transpose of a rotation for its inverse. So what the rotation
// lacks goes into the vertices: (R / length) (length v) + p is the same polygon.
function readBody({ vertices, radius = 0, rounding, position = [0, 0], rotation = [1, 0] }) {
  const stored = vertices.map(vectorOf);
  const { x: cos, y: sin } = vectorOf(rotation);
  const length = Math.sqrt(cos * cos + sin * sin);
  const at = vectorOf(position);
  return {
    stored: { vertices: stored, rotation: { c: cos, s: sin } },
    get world() {
      return stored.map(({ x, y }) => ({
        x: sumOf(cos * x, -sin * y, at.x),
        y: sumOf(sin * x, cos * y, at.y),
      }));
    },
    vertices: stored.map(({ x, y }) => ({ x: length * x, y: length * y })),
    normals: stored.map((corner, i) => normalOf(corner, stored[(i + 1) % stored.length])),
    count: stored.length,
    radius: Math.fround(radius),
    round: stored.length < 3 || rounding === "round",
    pose: { p: at, q: { c: cos / length, s: sin / length } },
    angle: Math.atan2(sin, cos),
  };
}

// Of three numbers; a product of two floats is exact in double, and so is what each sum loses.
function sumOf(a, b, c) {
  const first = a + b;
  const sum = first + c;
  return sum + (lostIn(a, b, first) + lostIn(first, c, sum));
}

function lostIn(a, b, sum) {
  const shareOfB = sum - a;
  return a - (sum - shareOfB) + (b - shareOfB);
}

function vectorOf([x, y]) {
  return { x: Math.fround(x), y: Math.fround(y) };
}

function normalOf(from, to) {
  const x = to.x - from.x;
  const y = to.y - from.y;
  const length = Math.sqrt(x * x + y * y);
  return { x: y / length, y: -x / length };
}

export function toWorld({ p, q }, { x, y }) {
  return [q.c * x - q.s * y + p.x, q.s * x + q.c * y + p.y];
}

// Of a polygon. Box2D's edges take their front by it, and it computes it where a polygon is set.
export function centroidOf([corner, ...others]) {
  let [x, y, area] = [0, 0, 0];
  others.slice(1).forEach((q, i) => {
    const p = others[i];
    const part = (p.x - corner.x) * (q.y - corner.y) - (p.y - corner.y) * (q.x - corner.x);
    x += part * (p.x + q.x - 2 * corner.x);
    y += part * (p.y + q.y - 2 * corner.y);
    area += part;
  });
  return { x: corner.x + x / (3 * area), y: corner.y + y / (3 * area) };
}

export function versionOf(name, url) {
  url = new URL(`./node_modules/${name}/package.json`, url);
  return JSON.parse(readFileSync(url, "utf8")).version;
}
