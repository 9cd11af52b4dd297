// Draws the same picture again and again: elements keep their keys from one drawing to the next, so that focus and hover
// stay where they are.

const pixels = (value) => String(Math.round(value * 1000) / 1000);

function pathOf(points, isClosed) {
  return points.map(([x, y], i) => `${i === 0 ? "M" : "L"}${pixels(x)} ${pixels(y)}`).join("") + (isClosed ? "Z" : "");
}

// `layers` names the groups from the bottom to the top.
function makePainter(svg, layers) {
  const groups = new Map(layers.map((name) => [name, svg.appendChild(svgElement("g", { class: name }))]));
  const elements = new Map();
  let painted = new Set();
  return {
    put(layer, key, tag, attributes, text) {
      const name = `${layer} ${key}`;
      let node = elements.get(name);
      if (node === undefined) {
        node = groups.get(layer).appendChild(svgElement(tag));
        elements.set(name, node);
      }
      setAttributes(node, attributes);
      if (text !== undefined && node.textContent !== text) node.textContent = text;
      painted.add(name);
      return node;
    },
    // Takes away what was not painted since the last time.
    finish() {
      for (const [name, node] of elements) {
        if (painted.has(name)) continue;
        node.remove();
        elements.delete(name);
      }
      painted = new Set();
    },
  };
}
