// The library and the judge, which were compiled to WebAssembly: a case in, what there is to show of it out. numbers.hpp says in
// which order numbers stand.

const MAX_VERTICES = 8;
const WAYS = ["apart", "faces", "cores", "circle"];

// It asks the system for nothing but its environment, which is empty.
function systemOf(module, memory) {
  const system = {};
  const nothing = 52;  // "there is no such function", as WASI counts errors
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    system[from] ??= {};
    system[from][name] = () => nothing;
  }
  if (system.wasi_snapshot_preview1?.environ_sizes_get) {
    system.wasi_snapshot_preview1.environ_get = () => 0;
    system.wasi_snapshot_preview1.environ_sizes_get = (...places) => {
      for (const place of places) new DataView(memory().buffer).setUint32(place, 0, true);
      return 0;
    };
  }
  return system;
}

function numbersOf({ vertices, radius, rounding, position, rotation }) {
  const numbers = [vertices.length, rounding === "round" ? 1 : 0, radius, ...position, ...rotation, ...vertices.flat()];
  return [...numbers, ...Array(7 + 2 * MAX_VERTICES - numbers.length).fill(0)];
}

// Reads the row in its order.
function readTold(numbers, buckets) {
  let at = 0;
  const next = () => numbers[at++];
  const flag = () => next() !== 0;
  const point = () => [next(), next()];
  const feature = () => {
    const code = next();
    return { isFace: code >= MAX_VERTICES, index: code % MAX_VERTICES };
  };
  const list = (count, read) => Array.from({ length: count }, read);
  const both = (read) => list(2, read);
  const end = () => ({ at: point(), reference: feature(), incident: feature() });
  const side = () => ({ faces: list(next(), () => ({ separation: next(), deepest: next() })), greatest: next() });
  const answer = (_, i) => ({
    bucket: buckets[i], isRight: flag(), magnitude: next(), count: next(), side: flag() ? "b" : "a",
    normal: point(), points: both(() => ({ at: point(), depth: next(), features: both(feature) })),
  });
  const told = {
    way: WAYS[next()], totalRadius: next(), separation: next(), isTouching: flag(), sides: { a: side(), b: side() },
    nearest: { isThere: flag(), places: both(point), features: both(feature) },
    features: { isThere: flag(), side: flag() ? "b" : "a", reference: next(), incident: next() },
    outward: point(), margin: next(), whole: both(end),
    sideClips: both(() => ({ corner: point(), inward: point(), leaves: flag(), edge: both(end) })),
    inFront: both(next), isReplaced: flag(), answers: both(answer),
    curve: { least: next(), minima: list(next(), point), samples: list(next(), point) },
  };
  for (const one of told.answers) one.points.length = one.count;
  return told;
}

// {check, tell}, both of a case. `check` gives what is wrong with it, or nothing; `tell` takes one that has no defect.
async function loadModule() {
  const module = await WebAssembly.compile(await unpacked(byId("module")));
  let exports;
  ({ exports } = await WebAssembly.instantiate(module, systemOf(module, () => exports.memory)));
  exports._initialize?.();
  const put = ({ a, b }) => {
    const numbers = [...numbersOf(a), ...numbersOf(b)];
    new Float64Array(exports.memory.buffer, exports.playground_case(), numbers.length).set(numbers);
  };
  const text = () => new TextDecoder().decode(
    new Uint8Array(exports.memory.buffer, exports.playground_text(), exports.playground_text_size()));
  return {
    check(pair) {
      put(pair);
      return exports.playground_check() === 1 ? "" : text();
    },
    tell(pair) {
      put(pair);
      const count = exports.playground_tell();
      const numbers = new Float64Array(exports.memory.buffer, exports.playground_numbers(), count);
      return readTold(numbers, text().split("\n"));
    },
  };
}
