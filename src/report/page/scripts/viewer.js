// The viewer: one case, large, moved by wheel, drag, pinch and keys, with everything that is known of it.

const WHOLE_MARGIN = 46;
const DRAG_STARTS = 3;  // pixels: less is a tap

const viewing = { one: null, camera: null, whole: null, show: SHOW_ALL, right: 0, svg: null, painter: null, frame: 0 };

function redraw() {
  cancelAnimationFrame(viewing.frame);
  viewing.frame = requestAnimationFrame(drawViewing);
}

function drawViewing() {
  const { camera, one, whole, show, right, painter, svg } = viewing;
  if (!byId("viewer").open || !camera) return;
  drawCase({ painter, camera, one, show, right, isThumbnail: false, describe: (key) => describeTarget(one, key, right) });
  svg.dataset.camera = [camera.x, camera.y, camera.scale].join(" ");
  byId("zoom-factor").textContent = `${brief(Number((camera.scale / whole.scale).toPrecision(2)))}\u00d7`;
  const focused = svg.contains(document.activeElement) && document.activeElement.matches(".target");
  if (focused) document.activeElement.dispatchEvent(new FocusEvent("focusin", { bubbles: true }));
  else hideTooltip();
}

function look(camera) {
  viewing.camera = { ...camera, scale: limitedScale(camera.scale, viewing.whole) };
  redraw();
}

// `span`, a world length, fills the picture.
function lookAt([x, y], span) {
  const { width, height } = viewing.camera;
  look({ x, y, width, height, scale: Math.min(width, height) / span });
}

// What lies at `at` stays there.
function zoom(factor, at) {
  const { x, y, scale, width, height } = viewing.camera;
  const [right, down] = at ? [at[0] - width / 2, at[1] - height / 2] : [0, 0];
  const zoomed = limitedScale(scale * factor, viewing.whole);
  const share = 1 / scale - 1 / zoomed;
  look({ x: x + right * share, y: y - down * share, width, height, scale: zoomed });
}

function lookAtAll(places) {
  if (places.length === 0) announce("There is nothing to zoom to");
  else look(cameraOn(places, viewing.one, viewing.camera));
}

// A point so closely that its distance to the truth, where there is one, can be seen.
function locate(role, index) {
  const answer = answerOf(viewing.one, role);
  const { position } = manifoldOf(answer, viewing.right).points[index];
  if (!viewing.camera || !isPoint(position)) return;
  const off = differenceToTruth(viewing.one, answer)?.points[index]?.position;
  lookAt(position, off > 0 ? off * 4 : (viewing.one.size || 1) / 50);
}

function stepRight(by) {
  const rights = answerOf(viewing.one, "truth").manifolds.length;
  if (rights < 2) return;
  viewing.right = (viewing.right + by + rights) % rights;
  byId("right-count").textContent = `right manifold ${viewing.right + 1} of ${rights}`;
  fillDetails();
  redraw();
}

function orderOfCases() {
  return list.order.includes(viewing.one) ? list.order : report.cases;
}

function goToCase(step) {
  const order = orderOfCases();
  const next = order[order.indexOf(viewing.one) + step];
  if (!next) return announce("There are no more cases");
  history.replaceState(null, "", caseHash(next));
  return openCase(next);
}

// Goes through everything that can be pointed at.
function focusTarget(step) {
  const targets = [...viewing.svg.querySelectorAll(".target")].reverse();
  const at = targets.indexOf(document.activeElement);
  targets[(at + step + targets.length + (at < 0 && step < 0 ? 1 : 0)) % targets.length]?.focus({ preventScroll: true });
}

// What each key does at the moment.
function viewerKeys() {
  const [next, previous] = [() => goToCase(1), () => goToCase(-1)];
  const keys = { j: next, ArrowRight: next, ArrowDown: next, k: previous, ArrowLeft: previous, ArrowUp: previous, "?": openHelp };
  if (!viewing.camera) return keys;
  const pan = (right, down) => () => look(panBy(viewing.camera, right, down));
  const { bodies, thinnest: { center, thickness } } = viewing.one;
  return { ...keys,
    "0": () => look(viewing.whole),
    f: () => lookAtAll(shownPoints(viewing).flatMap(({ position, bar }) => [position, ...(bar ?? [])])),
    o: () => lookAtAll(overlapOf(...bodies.map((body) => outlineOf(body, flatFor(viewing.whole))))),
    t: () => (thickness > 0 ? lookAt(center, 4 * thickness) : lookAtAll([center])),
    "+": () => zoom(2), "=": () => zoom(2), "-": () => zoom(1 / 2), "[": () => stepRight(-1), "]": () => stepRight(1),
    ".": () => focusTarget(1), ",": () => focusTarget(-1),
    "Shift ArrowRight": pan(-60, 0), "Shift ArrowLeft": pan(60, 0), "Shift ArrowDown": pan(0, -60), "Shift ArrowUp": pan(0, 60) };
}

// What is typed into a field, or with a modifier of the browser's, is none of ours.
function onKeys(node, keysNow) {
  node.addEventListener("keydown", (event) => {
    const action = keysNow()[event.shiftKey && event.key.startsWith("Arrow") ? `Shift ${event.key}` : event.key];
    const isTyping = event.ctrlKey || event.metaKey || event.altKey || event.target.matches?.("input:not([type=checkbox]), select, textarea");
    if (isTyping || !action) return;
    event.preventDefault();
    action();
  });
}

function placeIn(svg, event) {
  const { left, top } = svg.getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

function onWheel(event) {
  event.preventDefault();
  const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
  const pinch = event.ctrlKey ? 4 : 1;
  zoom(2 ** (-event.deltaY * lines * pinch / 240), placeIn(viewing.svg, event));
}

// What lay under the fingers, one or two, stays under them.
function dragged(before, after) {
  const [from, to] = [before, after].map((places) => centerOf(boxOf(places)));
  look(panBy(viewing.camera, to[0] - from[0], to[1] - from[1]));
  if (before.length > 1) zoom(distance(...after) / Math.max(1, distance(...before)), to);
}

function onPointers(svg) {
  const fingers = new Map();
  let moved = 0;
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    fingers.set(event.pointerId, placeIn(svg, event));
    moved = 0;
  });
  svg.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const at = placeIn(svg, event);
    const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, place]) => place).slice(0, 1);
    moved += distance(before, at);
    if (others.length === 0 && moved < DRAG_STARTS) return;
    svg.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, at);
    dragged([...others, before], [...others, at]);
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, (event) => fingers.delete(event.pointerId));
}

// Keeps what is at the middle when the window changes.
const stageSize = new ResizeObserver(() => {
  const { width, height } = byId("stage").getBoundingClientRect();
  if (!viewing.one.isDrawable || width === 0 || height === 0) return;
  const zoomed = viewing.camera ? viewing.camera.scale / viewing.whole.scale : 1;
  viewing.whole = wholeCamera(viewing.one, width, height, Math.min(WHOLE_MARGIN, width / 8));
  viewing.camera = zoomed === 1 ? viewing.whole : { ...viewing.camera, width, height, scale: viewing.whole.scale * zoomed };
  viewing.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  redraw();
});

function viewerHeader(one) {
  const order = orderOfCases();
  const at = order.indexOf(one);
  return element("header", {},
    element("div", { class: "viewer-title" },
      element("h2", { id: "viewer-title", tabindex: "-1" }, verdictMark(one.verdict), one.sentence || words(one.verdict) || baseName(one.file)),
      element("p", { class: "quiet digits" }, `${at + 1} of ${order.length}: ${one.file}`)),
    element("div", { class: "viewer-buttons" }, dragButton(one),
      button("\u2039 Previous", () => goToCase(-1), { disabled: at <= 0, title: "previous case (k)" }),
      button("Next \u203a", () => goToCase(1), { disabled: at >= order.length - 1, title: "next case (j)" }),
      button("Close", () => byId("viewer").close(), { title: "close (Esc)" })));
}

function viewerStage(one) {
  if (!one.isDrawable) return element("p", { class: "no-picture" }, "This case cannot be drawn: a coordinate is not finite.");
  const svg = svgElement("svg", { class: "picture", tabindex: "0", role: "group", dblclick: () => look(viewing.whole),
    "aria-label": "The two polygons and their contact. Plus and minus zoom, shift and arrows move, full stop and comma step through points, vertices and faces." });
  svg.addEventListener("wheel", onWheel, { passive: false });
  onPointers(svg);
  explainTargets(svg, ".target", (target) => describeTarget(one, target.dataset.key, viewing.right));
  Object.assign(viewing, { svg, painter: makePainter(svg, CASE_LAYERS) });
  return svg;
}

// What is drawn of a case: a switch for each collider, for the side planes and for the numbers.
function toggles({ answers }) {
  const toggle = (name, mark, label) => {
    const change = (event) => {
      viewing.show = { ...viewing.show, [name]: event.target.checked };
      redraw();
    };
    return element("label", { class: "toggle" },
      element("input", { type: "checkbox", checked: viewing.show[name], "data-show": name, change }), mark, label);
  };
  return element("div", { class: "toggles", role: "group", "aria-label": "What is drawn" },
    answers.map(({ role, name }) => toggle(role, roleMark(role), role === "truth" ? "truth" : name)),
    toggle("planes", lineMark("plane"), "side planes"), toggle("numbers", null, "vertex numbers"));
}

// Where several manifolds are right: a step to the next.
function rightStepper(one) {
  const rights = answerOf(one, "truth").manifolds.length;
  return rights > 1 && element("div", { class: "stepper", role: "group", "aria-label": "Right manifolds" },
    button("\u2039", () => stepRight(-1), { "aria-label": "previous right manifold" }),
    element("span", { id: "right-count", "aria-live": "polite" }, `right manifold 1 of ${rights}`),
    button("\u203a", () => stepRight(1), { "aria-label": "next right manifold" }));
}

function zoomButtons() {
  const press = (text, key, does, label) =>
    button(text, () => viewerKeys()[key]?.(), { title: `${does} (${key})`, "aria-label": label });
  return element("div", { class: "zoom", role: "group", "aria-label": "Zoom" }, press("\u2212", "-", "zoom out", "zoom out"),
    element("output", { id: "zoom-factor", "aria-label": "zoom" }), press("+", "+", "zoom in", "zoom in"),
    press("Whole", "0", "show everything"), press("Fit points", "f", "zoom to the contact"),
    press("Fit overlap", "o", "zoom to the overlap"), press("Fit thickness", "t", "zoom to the overlap's thickness"));
}

// Puts the playground in the place of the picture and the details, with this case in it.
async function drag(one) {
  const page = URL.createObjectURL(new Blob([await unpacked(byId("playground"))], { type: "text/html" }));
  const frame = element("iframe", { class: "playground-frame", src: page, title: "The case, to be dragged" });
  const giveCase = ({ source, data }) => {
    if (source !== frame.contentWindow || data !== PLAYGROUND_IS_READY) return;
    removeEventListener("message", giveCase);
    URL.revokeObjectURL(page);
    frame.contentWindow.postMessage(one.case, "*");
  };
  addEventListener("message", giveCase);
  stageSize.disconnect();
  viewing.camera = null;
  byId("viewer").querySelector(".viewer-body").replaceChildren(frame);
}

// Where this page holds the playground.
function dragButton(one) {
  if (byId("playground").textContent === "" || !one.isDrawable) return null;
  const node = button("Drag", () => {
    node.disabled = true;
    drag(one);
  }, { title: "drag the shapes, and see clip64, gjk64 and the judge answer" });
  return node;
}

function fillDetails() {
  byId("details").replaceChildren(...caseDetails(viewing.one, viewing.right));
}

function openCase(one) {
  Object.assign(viewing, { one, camera: null, right: 0 });
  hideTooltip();
  const dialog = byId("viewer");
  stageSize.disconnect();
  dialog.replaceChildren(viewerHeader(one), element("div", { class: "viewer-body" },
    element("div", { class: "stage-column" }, element("div", { id: "stage" }, viewerStage(one)),
      element("div", { class: "controls" }, one.isDrawable ? [zoomButtons(), rightStepper(one), toggles(one)] : [])),
    element("div", { id: "details", class: "details", tabindex: "0", role: "region", "aria-label": "Details" })));
  fillDetails();
  if (!dialog.open) dialog.showModal();
  byId("viewer-title").focus();
  stageSize.observe(byId("stage"));
}

function openFromHash() {
  const id = new URLSearchParams(location.hash.slice(1)).get("case");
  if (id === null) return;
  if (report.caseOf.has(id)) openCase(report.caseOf.get(id));
  else announce("This page has no such case");
}

function startViewer() {
  const dialog = byId("viewer");
  onKeys(dialog, viewerKeys);
  dialog.addEventListener("close", () => {
    hideTooltip();
    history.replaceState(null, "", location.href.split("#")[0]);
    [...document.querySelectorAll("#cards a[data-case]")].find((link) => link.dataset.case === viewing.one.id)?.focus();
  });
  addEventListener("hashchange", openFromHash);
  openFromHash();
}
