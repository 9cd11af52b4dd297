// What every adapter in JavaScript does: reads case lines from stdin, writes its declaration and
// then an answer a line to stdout. `collide` gets two bodies and returns what is to be written.
import { readFileSync } from "node:fs";

export async function serve(declaration, collide) {
  process.stdout.write(JSON.stringify({ declaration }) + "\n");
  let unfinished = "";
  for await (const chunk of process.stdin.setEncoding("utf8")) {
    const lines = (unfinished + chunk).split("\n");
    unfinished = lines.pop();
    writeAnswers(lines, collide);
  }
  writeAnswers([unfinished], collide);
}

// All in one write. Where the engine throws, those before it still go out: they tell which case.
function writeAnswers(lines, collide) {
  let answers = "";
  try {
    for (const line of lines.filter((line) => line.trim())) {
      const { a, b } = JSON.parse(line);
      answers += JSON.stringify(collide(readBody(a), readBody(b))) + "\n";
    }
  } finally {
    if (answers) process.stdout.write(answers);
  }
}

// Every number of a case is a float. The stored (cos, sin) is a unit vector to 32 bits only; these
// engines compute in 64 and take the transpose of a rotation for its inverse. So what the rotation
// lacks goes into the vertices: (R / length) (length v) + p is the same polygon.
function readBody({ vertices, radius = 0, position = [0, 0], rotation = [1, 0] }) {
  const stored = vertices.map(vectorOf);
  const { x: cos, y: sin } = vectorOf(rotation);
  const length = Math.sqrt(cos * cos + sin * sin);
  return {
    vertices: stored.map(({ x, y }) => ({ x: length * x, y: length * y })),
    normals: stored.map((corner, i) => normalOf(corner, stored[(i + 1) % stored.length])),
    count: stored.length,
    radius: Math.fround(radius),
    pose: { p: vectorOf(position), q: { c: cos / length, s: sin / length } },
  };
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

export function versionOf(name) {
  const url = new URL(`./node_modules/${name}/package.json`, import.meta.url);
  return JSON.parse(readFileSync(url, "utf8")).version;
}
