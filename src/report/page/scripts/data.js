// What the page shows: the JSON in it, with each case ready to be searched; numbers in words; and how far answers are off.

// From the most to the least urgent.
const VERDICTS = ["crashed", "timed_out", "malformed", "subject_wrong", "both_wrong", "oracle_wrong",
  "known", "tie", "ill_posed", "unsupported", "agree"];
const UNEXPLAINED = new Set(VERDICTS.slice(0, 6));
const ROLES = ["truth", "subject", "oracle"];

const report = readReport();

function words(name) {
  return name?.replaceAll("_", " ") ?? "";
}

function folderOf(file) {
  return file.slice(0, Math.max(0, file.lastIndexOf("/")));
}

function baseName(file) {
  return file.slice(file.lastIndexOf("/") + 1);
}

// A bucket is <at fault>/<verdict>/<kind>/<tie class>/<reference>.
function bucketWords(bucket) {
  const [, , kind, tieClass, reference] = bucket.split("/");
  if (reference === undefined) return bucket;
  return [kind === "none" ? "no difference" : words(kind), tieClass !== "none" && `tie of ${words(tieClass)}`,
    `reference ${reference.toUpperCase()}`].filter(Boolean).join(", ");
}

// Reads a case; its `id` is its file, with a number where files repeat.
function readCase(one, times) {
  return Object.assign(one, {
    id: times === 1 ? one.file : `${one.file}~${times}`,
    vertices: one.bodies.reduce((sum, body) => sum + body.vertices.length, 0),
    isDrawable: one.bodies.every((body) => body.vertices.every(isPoint)),
    group: [one.bucket || `${one.verdict}:${folderOf(one.file)}`, one.subject, one.oracle].join("|"),
    searched: [one.file, one.bucket, one.verdict, one.regime, one.subject, one.oracle, one.property, one.sentence, one.note]
      .join("\n").toLowerCase(),
  });
}

function readReport() {
  const read = JSON.parse(byId("data").textContent);
  const seen = new Map();
  for (const one of read.cases) {
    seen.set(one.file, (seen.get(one.file) ?? 0) + 1);
    readCase(one, seen.get(one.file));
  }
  return Object.assign(read, { caseOf: new Map(read.cases.map((one) => [one.id, one])) });
}

function answerOf(one, role) {
  return one.answers.find((answer) => answer.role === role);
}

// The manifold of an answer that is shown: of the truth's, the one that was stepped to.
function manifoldOf(answer, right) {
  return answer.manifolds[answer.role === "truth" ? right : 0];
}

// How often each key is met.
function tally(keys) {
  const counts = new Map();
  for (const key of keys) counts.set(key, (counts.get(key) ?? 0) + 1);
  return counts;
}

// The greatest of the numbers that are there; null if none is.
function greatest(values) {
  const there = values.filter(Number.isFinite);
  return there.length === 0 ? null : Math.max(...there);
}

function place(point) {
  return `(${full(point?.[0])}, ${full(point?.[1])})`;
}

// A number beyond 2^53 comes as its digits.
function whole(value) {
  if (typeof value === "string") return value;
  return Number.isFinite(value) ? value.toLocaleString("en-US") : "";
}

function counted(count, noun, nouns = `${noun}s`) {
  return `${whole(count)} ${count === 1 ? noun : nouns}`;
}

function percent(share) {
  if (!Number.isFinite(share) || share === 0) return share === 0 ? "0" : "";
  return share < 0.001 ? "<0.1%" : `${(100 * share).toFixed(share < 0.1 ? 1 : 0)}%`;
}

// An error or a time, short enough for a table.
function short(value) {
  if (!Number.isFinite(value)) return "";
  const size = Math.abs(value);
  if (size >= 1000 && size < 1e5) return whole(Number(value.toPrecision(3)));
  if (size === 0 || (size >= 0.001 && size < 1000)) return String(Number(value.toPrecision(3)));
  return value.toExponential(1).replace("e+", "e");
}

function isPoint(point) {
  return Array.isArray(point) && Number.isFinite(point[0]) && Number.isFinite(point[1]);
}

// How far a point is from the nearest one of a manifold, in position and depth.
function pointDifference(point, right) {
  const all = right.points.filter(({ position }) => isPoint(position) && isPoint(point.position))
    .map((other) => ({ position: distance(other.position, point.position), depth: Math.abs((other.depth ?? NaN) - (point.depth ?? NaN)) }));
  return all.sort((p, q) => p.position - q.position)[0];
}

function manifoldDifference(manifold, right) {
  const points = manifold.points.map((point) => pointDifference(point, right));
  const [p, q] = [manifold.normal, right.normal];
  return { points, count: manifold.points.length - right.points.length, worst: greatest(points.map((one) => one?.position)) ?? Infinity,
    normal: isPoint(p) && isPoint(q) ? Math.atan2(Math.abs(cross(p, q)), dot(p, q)) : null };
}

// From the nearest right manifold; undefined where there is nothing to compare.
function differenceToTruth(one, { role, manifolds: [manifold] }) {
  if (!manifold || role === "truth") return undefined;
  return answerOf(one, "truth").manifolds.map((right) => manifoldDifference(manifold, right))
    .sort((p, q) => Math.abs(p.count) - Math.abs(q.count) || (p.worst === q.worst ? 0 : p.worst - q.worst))[0];
}

function differenceInWords(difference, one) {
  if (!difference) return "";
  const { points, count, worst, normal } = difference;
  if (points.length === 0) return count === 0 ? "as the truth" : `leaves out ${counted(-count, "point")}`;
  const depth = greatest(points.map((point) => point?.depth));
  const share = one.size > 0 ? `, ${short(worst / one.size)} of the size` : "";
  return [count !== 0 && `${counted(Math.abs(count), "point")} too ${count > 0 ? "many" : "few"}`,
    worst === 0 ? "position as the truth" : Number.isFinite(worst) && `position off by ${short(worst)}${share}`,
    depth !== null && `depth by ${short(depth)}`, Number.isFinite(normal) && `normal by ${short(normal)} rad`].filter(Boolean).join("; ");
}
