// Making elements, tables, copying and the tooltip. Texts go in as text nodes: nothing of the data is ever read as HTML.

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

// A function listens to the event of its name.
function setAttributes(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") node.addEventListener(name, value);
    else if (value === null || value === undefined || value === false) node.removeAttribute(name);
    else node.setAttribute(name, value === true ? "" : value);
  }
  return node;
}

// A child is a node or a text; one that is missing or empty is left out.
function element(tag, attributes = {}, ...children) {
  const node = setAttributes(document.createElement(tag), attributes);
  node.append(...children.flat().filter(Boolean));
  return node;
}

function svgElement(tag, attributes = {}, text = "") {
  const node = setAttributes(document.createElementNS(SVG_NAMESPACE, tag), attributes);
  node.textContent = text;
  return node;
}

function button(text, action, attributes = {}) {
  return element("button", { type: "button", click: action, ...attributes }, text);
}

function field(label, control, css = "field") {
  return element("label", { class: css }, element("span", {}, label), control);
}

// An option is [value, text].
function select(label, options, chosen, action, attributes = {}) {
  const list = element("select", { change: () => action(list.value), ...attributes },
    options.map(([value, text]) => element("option", { value, selected: value === chosen }, text)));
  return field(label, list);
}

function byId(id) {
  return document.getElementById(id);
}

function announce(text) {
  byId("announcer").textContent = text;
}

// Names and values; a pair without a value is left out.
function facts(pairs) {
  return element("dl", { class: "facts" }, pairs.filter(([, value]) => value).map(([name, value]) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, value))));
}

// A table that scrolls within itself. A column is [title, cell of a row, class]; a cell is a node or a text.
function table(caption, columns, rows) {
  const head = columns.map(([title, , css]) => element("th", { scope: "col", class: css }, title));
  const body = rows.map((row) => element("tr", {}, columns.map(([, cell, css], i) =>
    element(i === 0 ? "th" : "td", { class: css, scope: i === 0 && "row" }, cell(row)))));
  return element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": caption },
    element("table", {}, element("caption", { class: "unseen" }, caption),
      element("thead", {}, element("tr", {}, head)), element("tbody", {}, body)));
}

// Part of a page that is built when it is first opened.
function disclosure(title, build) {
  const details = element("details", {}, element("summary", {}, title));
  details.addEventListener("toggle", () => details.append(build()), { once: true });
  return details;
}

// Where the browser keeps the clipboard from the page, by a field beside `neighbour`: a dialog lets nothing outside it be
// selected.
async function copyText(text, neighbour) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const selected = element("textarea", { class: "unseen", readonly: true, "aria-hidden": "true" }, text);
    neighbour.after(selected);
    selected.select();
    const isCopied = document.execCommand("copy");
    selected.remove();
    neighbour.focus();
    return isCopied;
  }
}

// A button that copies; says so for a moment.
function copyButton(label, text) {
  const node = button(label, async () => {
    const isCopied = await copyText(text, node);
    node.textContent = isCopied ? "Copied" : "Not copied";
    node.classList.toggle("done", isCopied);
    announce(isCopied ? "Copied to the clipboard" : "The browser does not let this page copy");
    setTimeout(() => {
      node.textContent = label;
      node.classList.remove("done");
    }, 1200);
  }, { class: "copy", "aria-label": `${label}: ${text.slice(0, 80)}` });
  return node;
}

function copyLine(text) {
  return element("div", { class: "copy-line" }, element("code", {}, text), copyButton("Copy", text));
}

// The first line of each block is its title. `box` is what they explain, in the window's coordinates.
function showTooltip(blocks, box) {
  const tip = byId("tooltip");
  tip.replaceChildren(...blocks.flatMap((lines) => lines.map((line, i) => element(i === 0 ? "strong" : "span", {}, line))));
  tip.togglePopover(true);
  const { width, height } = tip.getBoundingClientRect();
  const room = { right: document.documentElement.clientWidth, bottom: window.innerHeight };
  const left = Math.min(Math.max(4, (box.left + box.right) / 2 - width / 2), Math.max(4, room.right - width - 4));
  const above = box.top - height - 10;
  tip.style.left = `${left}px`;
  tip.style.top = `${above >= 4 ? above : Math.min(box.bottom + 10, room.bottom - height - 4)}px`;
}

function hideTooltip() {
  byId("tooltip").togglePopover(false);
}

// Under the pointer, everything of the same layer; else the target alone.
function coincident(target, event, selector) {
  if (!(event instanceof PointerEvent)) return [target];
  const here = document.elementsFromPoint(event.clientX, event.clientY).filter((node) => node.matches(selector));
  return here.includes(target) ? here.filter((node) => node.parentNode === target.parentNode) : [target];
}

// Shows `describe(target)` for what lies under the pointer or has the focus, of what `selector` finds.
function explainTargets(root, selector, describe) {
  const explain = (event) => {
    const target = event.target.closest?.(selector);
    if (target) showTooltip(coincident(target, event, selector).map(describe), target.getBoundingClientRect());
    else hideTooltip();
  };
  for (const name of ["pointerover", "pointerdown", "focusin"]) root.addEventListener(name, explain);
  // A finger leaves as soon as it is lifted: what it pointed at stays explained.
  root.addEventListener("pointerleave", (event) => event.pointerType === "touch" || hideTooltip());
  root.addEventListener("focusout", hideTooltip);
}
