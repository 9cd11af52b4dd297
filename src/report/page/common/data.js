// What the page shows: the JSON in it, with every list there and each case ready to be searched.

// From the most to the least urgent.
const VERDICTS = ["crashed", "timed_out", "malformed", "subject_wrong", "both_wrong", "oracle_wrong",
  "known", "tie", "ill_posed", "unsupported", "agree"];
const UNEXPLAINED = new Set(VERDICTS.slice(0, 6));
const ROLES = ["truth", "subject", "oracle"];

function words(name) {
  return name.replaceAll("_", " ");
}

function folderOf(file) {
  const slash = file.lastIndexOf("/");
  return slash < 0 ? "" : file.slice(0, slash);
}

function baseName(file) {
  return file.slice(file.lastIndexOf("/") + 1);
}

// A bucket is <at fault>/<verdict>/<kind>/<tie class>/<reference>.
function bucketWords(bucket) {
  const [, , kind, tieClass, reference] = bucket.split("/");
  if (reference === undefined) return bucket;
  const parts = [kind === "none" ? "no difference" : words(kind)];
  if (tieClass !== "none") parts.push(`tie of ${words(tieClass)}`);
  parts.push(`reference ${reference.toUpperCase()}`);
  return parts.join(", ");
}

function readAnswer(answer) {
  const manifolds = (answer.manifolds ?? []).map((manifold) => ({
    normal: null, reference: null, face: null, edge: null, ...manifold, points: manifold.points ?? [],
  }));
  return { role: "", name: "", words: "", version: "", ...answer, manifolds };
}

function readCase(given, index) {
  const read = {
    role: "smallest", smallest: null, bucket: "", verdict: "", regime: "", subject: "", oracle: "",
    sentence: "", note: "", severity: null, magnitude: null, count: null, property: "", found: null,
    case: "", separation: null, total_radius: null, size: null, extent: null, origin: [0, 0], map: null,
    ...given, index,
    file: given.file ?? `case ${index + 1}`,
    commands: given.commands ?? [], map_words: given.map_words ?? [],
    bodies: given.bodies ?? [], answers: (given.answers ?? []).map(readAnswer),
  };
  read.vertices = read.bodies.reduce((sum, body) => sum + (body.vertices?.length ?? 0), 0);
  read.isDrawable = read.bodies.length === 2 && read.bodies.every((body) =>
    body.vertices?.length >= 3 && body.vertices.every(isPoint));
  read.group = [read.bucket || `${read.verdict}:${folderOf(read.file)}`, read.subject, read.oracle].join("|");
  read.searched = [read.file, read.bucket, read.verdict, read.regime, read.subject, read.oracle,
    read.property, read.sentence, read.note].join("\n").toLowerCase();
  return read;
}

// A name for each case that no other has: its file, with a number where files repeat.
function nameCases(cases) {
  const seen = new Map();
  for (const one of cases) {
    const times = (seen.get(one.file) ?? 0) + 1;
    seen.set(one.file, times);
    one.id = times === 1 ? one.file : `${one.file}~${times}`;
  }
}

function readReport() {
  const given = JSON.parse(byId("data").textContent);
  const report = { version: "", command: "", ...given };
  for (const list of ["sources", "errors", "fuzz", "replay", "bench", "stress", "scene", "cases"]) {
    report[list] = given[list] ?? [];
  }
  report.cases = report.cases.map(readCase);
  nameCases(report.cases);
  report.caseOf = new Map(report.cases.map((one) => [one.id, one]));
  return report;
}

function answerOf(one, role) {
  return one.answers.find((answer) => answer.role === role);
}

// The greatest of the numbers that are there; null if none is.
function greatest(values) {
  const there = values.filter(Number.isFinite);
  return there.length === 0 ? null : Math.max(...there);
}

const report = readReport();
