// Numbers in words. A number that was not finite comes as null.

const NOT_FINITE = "not finite";

// As `%.4g` writes it: four figures.
function brief(value) {
  if (!Number.isFinite(value)) return NOT_FINITE;
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-4 && size < 1e6) return String(Number(value.toPrecision(size >= 1e4 ? 6 : 4)));
  return String(Number(value.toPrecision(4)).toExponential()).replace("e+", "e");
}

// Every figure: reads back to the same double.
function full(value) {
  if (!Number.isFinite(value)) return NOT_FINITE;
  return value !== 0 && Math.abs(value) < 1e-4 ? value.toExponential() : String(value);
}

function place(point) {
  return `(${full(point?.[0])}, ${full(point?.[1])})`;
}

function whole(value) {
  return Number.isFinite(value) ? value.toLocaleString("en-US") : "";
}

function counted(count, noun, nouns = `${noun}s`) {
  return `${whole(count)} ${count === 1 ? noun : nouns}`;
}

function percent(share) {
  if (!Number.isFinite(share) || share === 0) return share === 0 ? "0" : "";
  if (share < 0.001) return "<0.1%";
  return `${(100 * share).toFixed(share < 0.1 ? 1 : 0)}%`;
}

// An error or a time, short enough for a table.
function short(value) {
  if (!Number.isFinite(value)) return "";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1000 && size < 1e5) return whole(Number(value.toPrecision(3)));
  if (size >= 0.001 && size < 1000) return String(Number(value.toPrecision(3)));
  return value.toExponential(1).replace("e+", "e");
}

function isPoint(point) {
  return Array.isArray(point) && Number.isFinite(point[0]) && Number.isFinite(point[1]);
}
