// Making elements. Texts go in as text nodes: nothing of the data is ever read as HTML.

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

function setAttributes(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (name === "on") {
      for (const [event, listener] of Object.entries(value)) node.addEventListener(event, listener);
    } else if (value === null || value === undefined || value === false) {
      node.removeAttribute(name);
    } else {
      node.setAttribute(name, value === true ? "" : value);
    }
  }
}

// `attributes.on` holds listeners by event; a child is a node, a text, or null for nothing.
function element(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  setAttributes(node, attributes);
  node.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return node;
}

function svgElement(tag, attributes = {}, text = "") {
  const node = document.createElementNS(SVG_NAMESPACE, tag);
  setAttributes(node, attributes);
  if (text !== "") node.textContent = text;
  return node;
}

function button(text, action, attributes = {}) {
  return element("button", { type: "button", on: { click: action }, ...attributes }, text);
}

function select(label, options, chosen, action) {
  const list = element("select", { on: { change: () => action(list.value) } });
  for (const [value, text] of options) {
    list.append(element("option", { value, selected: value === chosen }, text));
  }
  return element("label", { class: "field" }, element("span", {}, label), list);
}

function byId(id) {
  return document.getElementById(id);
}

function announce(text) {
  byId("announcer").textContent = text;
}

// A table that scrolls within itself. A column is [title, cell of a row, class]; a cell is a node or a text.
function table(caption, columns, rows) {
  const head = columns.map(([title, , kind]) => element("th", { scope: "col", class: kind }, title));
  const body = rows.map((row) => {
    const cells = columns.map(([, cell, kind], i) => {
      const attributes = i === 0 ? { class: kind, scope: "row" } : { class: kind };
      return element(i === 0 ? "th" : "td", attributes, cell(row));
    });
    return element("tr", {}, cells);
  });
  return element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    element("table", {}, element("caption", { class: "unseen" }, caption),
      element("thead", {}, element("tr", {}, head)), element("tbody", {}, body)));
}

// Part of a page that is built when it is first opened.
function disclosure(title, build) {
  const details = element("details", {}, element("summary", {}, title));
  details.addEventListener("toggle", () => {
    if (details.open && details.childElementCount === 1) details.append(build());
  });
  return details;
}
