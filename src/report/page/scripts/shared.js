// What the report's page and src/playground share: the theme, numbers in words, pictures that are drawn again and again,
// and how one holds the other.

const SIDES = ["a", "b"];
const NOT_FINITE = "not finite";

// As `%.4g` writes it: four figures. A number that was not finite comes as null.
function brief(value) {
  if (!Number.isFinite(value)) return NOT_FINITE;
  const size = Math.abs(value);
  if (size === 0 || (size >= 1e-4 && size < 1e6)) return String(Number(value.toPrecision(size >= 1e4 ? 6 : 4)));
  return String(Number(value.toPrecision(4)).toExponential()).replace("e+", "e");
}

// Every figure: reads back to the same double.
function full(value) {
  if (!Number.isFinite(value)) return NOT_FINITE;
  return value !== 0 && Math.abs(value) < 1e-4 ? value.toExponential() : String(value);
}

const pixels = (value) => String(Math.round(value * 1000) / 1000);

function pathOf(points, isClosed) {
  return points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${pixels(x)} ${pixels(y)}`).join("") + (isClosed ? "Z" : "");
}

// Draws the same picture again and again: elements keep their keys from one drawing to the next, so that focus and hover
// stay where they are. `layers` names the groups from the bottom to the top.
function makePainter(svg, layers) {
  const groups = new Map(layers.map((name) => [name, svg.appendChild(svgElement("g", { class: name }))]));
  const elements = new Map();
  const painted = new Set();
  return {
    put(layer, key, tag, attributes, text = "") {
      const name = `${layer} ${key}`;
      if (!elements.has(name)) elements.set(name, groups.get(layer).appendChild(svgElement(tag)));
      const node = setAttributes(elements.get(name), attributes);
      if (node.textContent !== text) node.textContent = text;
      painted.add(name);
    },
    // Takes away what was not painted since the last time.
    finish() {
      for (const [name, node] of elements) {
        if (painted.has(name)) continue;
        node.remove();
        elements.delete(name);
      }
      painted.clear();
    },
  };
}

// What the button said is kept, where the browser keeps anything of a page from a file.
function storage() {
  try {
    return localStorage;
  } catch {
    return {};
  }
}

// Light or dark: as the system says, until the button says otherwise.
function startTheme() {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const { dataset } = document.documentElement;
  const other = () => ((dataset.theme ?? (system.matches ? "dark" : "light")) === "dark" ? "light" : "dark");
  const name = () => {
    byId("theme").textContent = other() === "dark" ? "Dark" : "Light";
    byId("theme").setAttribute("aria-label", `Switch to the ${other()} colours`);
  };
  const kept = storage()["manifuzz-theme"];
  if (kept === "dark" || kept === "light") dataset.theme = kept;
  byId("theme").addEventListener("click", () => {
    dataset.theme = storage()["manifuzz-theme"] = other();
    name();
  });
  system.addEventListener("change", name);
  name();
}

// The bytes that an element of the page holds: packed by gzip, as base64.
async function unpacked(node) {
  const packed = Uint8Array.from(atob(node.textContent.trim()), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

// What the playground tells the page that holds it, once it can be given a case.
const PLAYGROUND_IS_READY = "manifuzz playground";
