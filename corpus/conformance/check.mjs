#!/usr/bin/env node
// Holds a port of the article's clipping against cases.jsonl: node check.mjs ANSWERS.jsonl, a line a
// case, or node check.mjs -- COMMAND, a program that is asked. README.md beside it has the rules.
import { spawnSync } from "node:child_process";
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";

const dot = (p, q) => p[0] * q[0] + p[1] * q[1];
const cross = (p, q) => p[0] * q[1] - p[1] * q[0];
const minus = (p, q) => [p[0] - q[0], p[1] - q[1]];
const lengthOf = (v) => Math.sqrt(dot(v, v));
const off = (p, q, low) => lengthOf(minus(minus(p, q), low));
const turn = ([c, s], [x, y]) => [c * x - s * y, s * x + c * y]; // R v
const turnBack = ([c, s], [x, y]) => [c * x + s * y, c * y - s * x]; // R^T v
const inFrameOfA = (r, normal) => turnBack(r, normal).map((x) => x / lengthOf(r));

// Every number of a shape and its pose is a float; the file has its shortest decimals.
const asFloats = (key, value) => (typeof value === "number" ? Math.fround(value) : value);

// The answer's points, in A's frame, and its normal, in the world; throws what is wrong. Null is nothing.
function read({ a, b }, answer) {
  const expect = (is, what) => { if (!is) throw new TypeError(what); };
  const isTwo = (v) => Array.isArray(v) && v.length === 2 && v.every(Number.isFinite);
  expect(Array.isArray(answer?.points) && answer.points.length <= 2, 'an answer has 0 to 2 "points"');
  const counts = [a, b].map(({ vertices }) => vertices.length);
  const points = answer.points.map((point) => {
    const { local, position, features } = point ?? {};
    const depth = point?.depth ?? answer.depth;
    expect(isTwo(local ?? position), "a point has no place of two finite numbers");
    expect(Number.isFinite(depth) && depth >= 0, "a depth is not a finite number of 0 or more");
    const isFeature = (f, i) => typeof f === "string" && /^[fv][0-7]$/.test(f) && f[1] < counts[i];
    const areFeatures = Array.isArray(features) && features.length === 2 && features.every(isFeature);
    expect(areFeatures || (features ?? null) === null, "the features are not one of each shape");
    const r = a.rotation;
    const at = local ?? turnBack(r, minus(position, a.position)).map((x) => x / dot(r, r));
    return { at, depth, features };
  });
  expect(["a", "b"].includes(answer.reference ?? "a"), "the reference is neither a nor b");
  expect(!points.length || isTwo(answer.normal), "the normal is not two finite numbers");
  return { points, normal: answer.normal };
}

// Why the answer is not this right manifold, or nothing. All figures are in A's frame.
function whyNoClip(right, scalar, { reference }, points, normal) {
  const within = right[scalar];
  const low = within.low ?? Array(8).fill(0); // what the figures lost where they were written as doubles
  if ((reference ?? right.reference) !== right.reference) return "reference";
  if (!(off(normal, right.normal, low) <= within.normal)) return "normal";
  const named = points.every(({ features }) => features);
  const isNear = ({ at, depth }, k) => off(at, right.points[k].local, low.slice(2 + 3 * k)) <= within.local[k]
    && Math.abs(depth - right.points[k].depth - low[4 + 3 * k]) <= within.depth[k];
  const near = points.map((point) => [...right.points.keys()].filter((k) => isNear(point, k)));
  const isOther = ({ features }, k) => within.features.includes(k)
    && features.join() !== right.points[k].features.join();
  for (const [i, ks] of near.entries()) {
    if (!ks.length) return "position or depth of a point";
    if (named && ks.every((k) => isOther(points[i], k))) return "features";
  }
  const missing = within.needed.find((k) => !near.flat().includes(k));
  if (missing !== undefined) return `no point is point ${missing + 1} of the right manifold`;
}

// The distance of two directions on the unit circle, to the last digits where they are near; m is unit and has
// its low parts behind it.
function angleChord(n, m) {
  const by = minus(minus(n, m), m.slice(2));
  return 2 * Math.sin(Math.abs(Math.atan2(cross(m, by), 1 + dot(m, by))) / 2);
}

// The heights along the normal, least and most, of what of a core faces the other one from low to high.
function heights(shape, normal, side, low, high, thin) {
  const ends = shape.map((v) => [cross(normal, v), dot(normal, v)]);
  const places = ends.map(([x]) => x);
  const isThin = Math.max(...places) - Math.min(...places) <= thin; // rounding alone says which side faces
  const seen = ends.filter(([x]) => isThin && low <= x && x <= high).map(([, y]) => y);
  for (const [i, p] of ends.entries()) {
    const q = ends[(i + 1) % ends.length];
    const [[x, y], [u, v]] = side === "a" ? [p, q] : [q, p];
    const [from, to] = [Math.max(x, low), Math.min(u, high)];
    if (u > x && from <= to) seen.push(...[from, to].map((at) => y + (v - y) * ((at - x) / (u - x))));
  }
  return seen.length ? [Math.min(...seen), Math.max(...seen)] : null;
}

// Why it is no right contact of round shapes, or nothing. All is seen from A's position, in the world.
function whyNoContact({ a, b, round: right }, scalar, points, normal) {
  const within = right[scalar];
  const length = lengthOf(normal);
  if (!(Math.abs(lengthOf(inFrameOfA(a.rotation, normal)) - 1) <= within.unit)) return "length of the normal";
  const n = normal.map((x) => x / length);
  const offset = minus(a.position, b.position);
  const cores = {
    a: a.vertices.map((v) => turn(a.rotation, v)),
    b: b.vertices.map((v) => minus(turn(b.rotation, v), offset)),
  };
  const radii = a.radius + b.radius;
  const [ofA, ofB] = [cores.a, cores.b].map((core) => core.map((v) => dot(n, v)));
  const along = Math.max(...ofA) - Math.min(...ofB); // D(n) without the radii
  const excess = along + radii - right.least;
  const isNearest = within.nearest?.some((m) => angleChord(normal, m) <= within.turn);
  if (!isNearest && !(Math.abs(excess) <= within.excess)) return "normal";
  const depths = points.map(({ depth }) => depth);
  const deepest = Math.max(...depths);
  const isOfCurve = "shortfall" in within && Math.abs(deepest - along - radii) <= within.consistency;
  if (!(Math.abs(deepest - right.least) <= within.depth) && !isOfCurve) return "depth";
  const places = points.map(({ at }) => turn(a.rotation, at));
  const isWitness = (p, i) => {
    const [low, high] = [-within.along, within.along].map((x) => cross(n, p) + x);
    const [top, bottom] = ["a", "b"].map((side) => heights(cores[side], n, side, low, high, within.across));
    if (!top || !bottom) return false;
    const isDeepest = i === depths.indexOf(deepest) && "shortfall" in within;
    const [least, most] = [-within.consistency, within.consistency].map((x) => depths[i] + x - radii);
    const atLeast = isDeepest ? Math.max(least, along - within.shortfall) : least;
    const narrowed = ([from, to], h) => [Math.max(from, h - within.across), Math.min(to, h + within.across)];
    const isThere = (t, s) => t[0] <= t[1] && s[0] <= s[1]
      && Math.max(t[0] - s[1], atLeast) <= Math.min(t[1] - s[0], most);
    const height = dot(n, p);
    return isThere(narrowed(top, height - a.radius), bottom) || isThere(top, narrowed(bottom, height + b.radius));
  };
  if (!places.every(isWitness)) return "a point is not where they overlap by its depth";
  if (points.length < within.points[0] || points.length > within.points[1]) return `${points.length} points`;
  const spanned = points.length === 2 ? Math.abs(cross(n, minus(places[0], places[1]))) : Infinity;
  if (spanned < within.span) return "the points span too little";
}

// Nothing where the answer is right.
function whyWrong(given, answer, scalar) {
  let points, normal;
  try {
    ({ points, normal } = read(given, answer));
  } catch (error) {
    return `malformed: ${error.message}`;
  }
  if (!points.length) return given.empty.includes(scalar) ? undefined : "missed contact";
  if (given.round && !(scalar in given.round)) return "phantom contact";
  if (given.round) return whyNoContact(given, scalar, points, normal);
  const local = inFrameOfA(given.a.rotation, normal);
  const reasons = given.right.filter((right) => scalar in right)
    .map((right) => whyNoClip(right, scalar, answer, points, local));
  return reasons.includes(undefined) ? undefined : (reasons[0] ?? "phantom contact");
}

// What a program says when it is given the cases, their numbers with all digits.
function ask([program, ...words], cases) {
  const unit = ([x, y]) => [y, -x].map((c) => c / lengthOf([x, y]));
  const withNormals = (body) => {
    const edges = body.vertices.map((v, i, all) => minus(all[(i + 1) % all.length], v));
    return { ...body, normals: edges.length > 1 ? edges.map(unit) : [] };
  };
  const input = cases.map(({ a, b }) => JSON.stringify({ a: withNormals(a), b: withNormals(b) }) + "\n").join("");
  const stdio = ["pipe", "pipe", "inherit"];
  const { stdout, error, status, signal } = spawnSync(program, words, { input, stdio, maxBuffer: 1e9 });
  if (error && error.code !== "EPIPE") throw error;
  const how = signal ?? `status ${status}`;
  if (status !== 0) throw new Error(`${program} ended with ${how}; 0 is expected, after an answer to each case`);
  return textOf(stdout);
}

const textOf = (bytes) => new TextDecoder("utf-8", { fatal: true }).decode(bytes);

// The lines that are not empty, with their numbers.
const linesOf = (text) => text.split("\n").map((line, i) => [i + 1, line])
  .filter(([, line]) => /[^ \t\r]/.test(line));

// What a port declares, if it does, and its answers.
function parse(text, name) {
  const answers = linesOf(text).map(([i, line]) => {
    try {
      return JSON.parse(line);
    } catch (error) {
      throw new Error(`${name}:${i}: no JSON: ${error.message}`);
    }
  });
  let declared = answers[0]?.declaration === undefined ? {} : answers.shift().declaration;
  if (Object.getPrototypeOf(declared ?? 0) !== Object.prototype) throw new Error(`${name}: its declaration is no object`);
  declared = Object.fromEntries(Object.entries(declared).filter(([, value]) => value !== null));
  const only = { tie_bias: [0], claims: ["manifold"], clips: [true], points: ["clip"], normal: ["a_to_b"],
    second_point: ["clip", "never"], scalar: ["float32", "float64"],
    vertices_min: [1, 2, 3], takes_round: [true, false] };
  for (const [key, value] of Object.entries(declared)) {
    if (!Object.hasOwn(only, key) || only[key].includes(value)) continue;
    throw new Error(`${name} declares ${key} ${JSON.stringify(value)}; it is not what this suite is for`);
  }
  return { declared, answers };
}

// Whether a program is asked about the case: about round shapes only as it declares.
function takes(declared, { a, b, round }) {
  const isAll = "second_point" in declared;
  const { vertices_min: least = isAll ? 1 : 3, takes_round: takesRound = isAll } = declared;
  return !round || [a, b].every(({ vertices, radius, rounding }) =>
    vertices.length >= least && (vertices.length < 3 || takesRound || (!rounding && radius === 0)));
}

const isNumber = (x) => typeof x === "number" && Number.isFinite(Math.fround(x));
const isVertex = (v) => Array.isArray(v) && v.length === 2 && v.every(isNumber);
const isBody = ({ radius, vertices }) => isNumber(radius) && vertices.length > 0 && vertices.every(isVertex);
const isObject = (value) => typeof value === "object" && value !== null && !Array.isArray(value);

function readCase(line, place) {
  try {
    const read = JSON.parse(line);
    const isRight = read.round === undefined ? Array.isArray(read.right) : isObject(read.round);
    const isOne = typeof read.name === "string" && Array.isArray(read.empty) && isRight && isBody(read.a) && isBody(read.b);
    if (read.format === "manifuzz/conformance/1" && isOne) return read;
  } catch {
    // It is no JSON.
  }
  throw new Error(`${place}: a case of manifuzz/conformance/1 is expected`);
}

const kOptions = "--cases FILE, --scalar float32|float64, --each";

function check(words) {
  const end = [...words, "--"].indexOf("--");
  const [own, command] = [words.slice(0, end), words.slice(end + 1)];
  if (own.some((word) => ["-h", "--help"].includes(word))) {
    writeFileSync(1, `usage: check.mjs [${kOptions}] ANSWERS.jsonl | -- COMMAND...\n`);
    return 0;
  }
  const taken = (option) => own.includes(option) ? own.splice(own.indexOf(option), 2)[1] : undefined;
  const [file, chosen] = [taken("--cases"), taken("--scalar")];
  const each = own.includes("--each") && own.splice(own.indexOf("--each"), 1).length > 0;
  if (own.length + (command.length > 0) !== 1) {
    throw new Error(`either a file of answers or, after --, a command is expected; ${kOptions}`);
  }
  const suite = file ?? fileURLToPath(new URL("cases.jsonl", import.meta.url));
  const all = linesOf(textOf(readFileSync(suite))).map(([i, line]) => {
    const { a, b, ...rest } = readCase(line, `${suite}:${i}`);
    const placed = (body) => ({ position: [0, 0], rotation: [1, 0], ...JSON.parse(JSON.stringify(body), asFloats) });
    return { ...rest, a: placed(a), b: placed(b) };
  });
  const first = all.filter(({ round }) => !round).slice(0, 1);
  const asked = command.length ? parse(ask(command, first), command[0]) : null;
  const cases = asked ? all.filter((given) => takes(asked.declared, given)) : all;
  const { declared, answers } = parse(asked ? ask(command, cases) : textOf(readFileSync(own[0])), command[0] ?? own[0]);
  const scalar = chosen ?? declared.scalar ?? "float32";
  if (!/^float(32|64)$/.test(scalar)) throw new Error(`--scalar: ${scalar}; float32 or float64 is expected`);
  const isNever = declared.second_point === "never"; // one point of round shapes
  for (const { round } of isNever ? cases : []) {
    for (const within of [round?.float32, round?.float64]) Object.assign(within ?? {}, { points: [1, 1], span: 0 });
  }
  if (answers.length !== cases.length) {
    throw new Error(`${answers.length} answers; ${cases.length} are expected, a line a case`);
  }
  let [wrong, unsupported] = [0, all.length - cases.length];
  const lines = [];
  if (answers.filter((answer) => answer?.unsupported === undefined).length === 0) {
    throw new Error(`none of ${all.length} cases was answered; nothing is checked`);
  }
  for (const [i, given] of cases.entries()) {
    const isAsked = answers[i]?.unsupported === undefined;
    const why = isAsked ? whyWrong(given, answers[i], scalar) : undefined;
    wrong += why ? 1 : 0;
    unsupported += isAsked ? 0 : 1;
    const said = why ?? (isAsked ? "right" : "unsupported");
    if (each || (why && wrong <= 10)) lines.push(`${given.name}: ${said}`);
  }
  lines.push(`${wrong ? "fail" : "pass"}: ${wrong} of ${cases.length} wrong, ${unsupported} unsupported, as ${scalar}`);
  writeFileSync(1, lines.join("\n") + "\n");
  return wrong ? 1 : 0;
}

try {
  process.exitCode = check(process.argv.slice(2));
} catch (error) {
  console.error(`check.mjs: ${error.message}`);
  process.exitCode = 2;
}
