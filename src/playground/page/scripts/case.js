// Cases: {a, b}, each {vertices: [[x, y], ...], radius, rounding, position, rotation}, of floats. As files of the corpus, and as
// addresses: "a=m;0;0,0;1,0;-1,-1;...": rounding, radius, position, rotation, vertices.

const STEP_NAMES = ["separation", "reference", "incident", "clip 1", "clip 2", "clip 3", "contact"];
const LAST_STEP = STEP_NAMES.length - 1;

// The shortest decimal that reads back as the float.
function digitsOf(float) {
  for (let digits = 1; digits < 9; ++digits) {
    const text = String(Number(float.toPrecision(digits)));
    if (Math.fround(Number(text)) === float) return Object.is(float, -0) ? "-0.0" : text;
  }
  return String(Number(float.toPrecision(9)));
}

const pairText = (pair) => pair.map(digitsOf).join(",");

function bodyToAddress({ vertices, radius, rounding, position, rotation }) {
  return [rounding[0], digitsOf(radius), pairText(position), pairText(rotation), ...vertices.map(pairText)].join(";");
}

function addressOf({ a, b }, step) {
  return `#a=${bodyToAddress(a)}&b=${bodyToAddress(b)}&step=${step}`;
}

const isPair = (value) => Array.isArray(value) && value.length === 2 && value.every(Number.isFinite);

// The body with every number rounded to float. Throws what is wrong, with its place.
function bodyOf(given, name) {
  const expect = (holds, place, what) => {
    if (!holds) throw new Error(`$.${name}${place}: ${what}`);
  };
  expect(given !== null && typeof given === "object", "", "an object is expected, with vertices");
  const { vertices, radius = 0, position = [0, 0], rotation = [1, 0] } = given;
  expect(Array.isArray(vertices) && vertices.length >= 1 && vertices.length <= MAX_VERTICES && vertices.every(isPair),
    ".vertices", "1 to 8 points [x, y] are expected");
  expect(Number.isFinite(radius), ".radius", "a number is expected");
  expect(isPair(position), ".position", "[x, y] is expected");
  expect(isPair(rotation), ".rotation", "[cos, sin] is expected");
  const rounding = vertices.length < 3 ? "round" : given.rounding ?? "mitre";
  expect(rounding === "round" || rounding === "mitre", ".rounding", "\"mitre\" or \"round\" is expected");
  const floats = (pair) => pair.map(Math.fround);
  return { vertices: vertices.map(floats), radius: Math.fround(radius), rounding, position: floats(position), rotation: floats(rotation) };
}

// The case of a file of the corpus, or of a line of one.
function caseFromText(text) {
  let given;
  try {
    given = JSON.parse(text.trimStart().split(/\n(?=\{"a"|\{"format")/)[0]);
  } catch (error) {
    throw new Error(`the file is no JSON: ${error.message}`);
  }
  if (given === null || typeof given !== "object" || !given.a || !given.b) throw new Error("$: a case is expected, an object with a and b");
  return { a: bodyOf(given.a, "a"), b: bodyOf(given.b, "b") };
}

function bodyFromAddress(text, name) {
  const [rounding, radius, ...pairs] = text.split(";");
  const [position, rotation, ...vertices] = pairs.map((pair) => pair.split(",").map(Number));
  return bodyOf({ vertices, radius: Number(radius), rounding: rounding === "r" ? "round" : "mitre", position, rotation }, name);
}

// {pair, step}, or nothing where the address has no case.
function caseFromAddress(hash) {
  const parts = new Map(hash.replace(/^#/, "").split("&").map((part) => part.split("=").map(decodeURIComponent)));
  if (!parts.has("a") && !parts.has("b")) return null;
  const step = Number(parts.get("step") ?? LAST_STEP);
  return { pair: { a: bodyFromAddress(parts.get("a") ?? "", "a"), b: bodyFromAddress(parts.get("b") ?? "", "b") },
    step: STEP_NAMES[step] ? step : LAST_STEP };
}

// As a file of the corpus.
function fileOf({ a, b }) {
  const isCurved = a.rounding === "round" || b.rounding === "round";
  const points = (pairs) => `[${pairs.map((pair) => `[${pairText(pair)}]`).join(",")}]`;
  const body = ({ vertices, radius, rounding, position, rotation }) => ["{",
    `    "vertices": ${points(vertices)},`,
    `    "radius": ${digitsOf(radius)},`,
    ...(rounding === "round" ? ["    \"rounding\": \"round\","] : []),
    `    "position": [${pairText(position)}],`,
    `    "rotation": [${pairText(rotation)}]`,
    "  }"].join("\n");
  return `{\n  "format": "manifuzz/case/${isCurved ? 2 : 1}",\n  "a": ${body(a)},\n  "b": ${body(b)}\n}\n`;
}

const polygon = (vertices, position, rotation = [1, 0], radius = 0, rounding = "mitre") => ({ vertices, position, rotation, radius, rounding });
const BOX = [[-1.5, -1], [1.5, -1], [1.5, 1], [-1.5, 1]];
const EXAMPLES = [
  ["A box on a box", { a: polygon(BOX, [0, 0]), b: polygon([[-1, -0.8], [1, -0.8], [1, 0.8], [-1, 0.8]], [0.9, 1.5], [0.96, 0.28]) }],
  ["A corner in a face", { a: polygon(BOX, [0, 0]), b: polygon([[0, -1.2], [1.3, 0.9], [-1.1, 0.7]], [0.4, 1.9]) }],
  ["Two that planck and Box2D miss", { a: polygon([[0, 0], [1.2, -5.6], [4.6, -3.2]], [0, 0]),
    b: polygon([[0.8, -5.1], [-0.9, -6.3], [1.8, -4.4]], [0, 0]) }],
  ["Two octagons", { a: polygon([[2, -0.8], [2, 0.8], [0.8, 2], [-0.8, 2], [-2, 0.8], [-2, -0.8], [-0.8, -2], [0.8, -2]], [0, 0]),
    b: polygon([[1.5, -0.6], [1.5, 0.6], [0.6, 1.5], [-0.6, 1.5], [-1.5, 0.6], [-1.5, -0.6], [-0.6, -1.5], [0.6, -1.5]], [2.6, 1.4], [0.8, 0.6]) }],
  ["A capsule on a box", { a: polygon(BOX, [0, 0]), b: polygon([[-1, 0], [1, 0]], [0.8, 1.3], [1, 0], 0.5, "round") }],
  ["A circle and a polygon with round corners", { a: polygon([[-1, -0.6], [1.2, -0.8], [0.3, 0.9]], [0, 0], [1, 0], 0.3, "round"),
    b: polygon([[0, 0]], [1.3, 0.9], [1, 0], 0.7, "round") }],
].map(([name, pair]) => [name, { a: bodyOf(pair.a, "a"), b: bodyOf(pair.b, "b") }]);
