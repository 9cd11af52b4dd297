// Puts the page together: what is shown, what is dragged, and the address.

const KEY_STEPS = ["1", "0.1", "0.01", "0.001"];
const ZOOM = 1.4;

const state = { pair: EXAMPLES[0][1], step: LAST_STEP, keyStep: 0.1, origin: [0, 0], camera: null, drag: null, told: null };
const svg = svgElement("svg", { class: "picture", role: "group", "aria-label": "Both shapes, and the step" });
const curveSvg = svgElement("svg", { class: "picture", viewBox: `0 0 ${PLOT} ${PLOT}`, role: "img", "aria-label": "The penetration curve" });
let library;
let stagePainter;
let curvePainter;
let isAsked = false;

function tellTrouble(text) {
  byId("trouble").textContent = text;
  byId("trouble").hidden = text === "";
}

function fit() {
  const { clientWidth: width, clientHeight: height } = byId("stage");
  state.camera = fitBox(shapesBox(placedShapes(state.pair, state.origin)), width, height, 64);
}

function zoom(factor) {
  state.camera = { ...state.camera, scale: state.camera.scale * factor };
  askToDraw();
}

function showStage(shapes) {
  const { camera, told } = state;
  const pen = makePen(stagePainter, camera, seenBox(camera));
  drawShapes(pen, shapes, flatFor(camera));
  drawStep(pen, shapes, told, state.step);
  drawHandles(stagePainter, state.pair, state.origin, camera);
  stagePainter.finish();
  svg.setAttribute("data-camera", `${camera.x} ${camera.y} ${camera.scale}`);
}

function showWords() {
  const { told } = state;
  for (const answer of told.answers) {
    for (const point of answer.points) point.world = along(point.at, state.pair.a.position, 1);
  }
  byId("step-text").replaceChildren(...[element("p", {}, stepInWords(told, state.step)), state.step === 0 && separationTable(told)].filter(Boolean));
  byId("verdict").replaceChildren(element("h2", {}, standingInWords(told)), answerBlock(told, 0), answerBlock(told, 1));
  byId("curve-text").textContent = curveInWords(told);
  byId("steps").querySelectorAll("button[data-step]").forEach((node) => node.setAttribute("aria-pressed", String(Number(node.dataset.step) === state.step)));
  for (const side of SIDES) {
    const isPolygon = state.pair[side].vertices.length > 2;
    const box = byId(`round-${side}`);
    box.disabled = !isPolygon;
    box.checked = state.pair[side].rounding === "round";
  }
}

function draw() {
  isAsked = false;
  const start = performance.now();
  state.told = library.tell(state.pair);
  const shapes = placedShapes(state.pair, state.origin);
  // The library sees places from where A stands now.
  const stood = minus(state.pair.a.position, state.origin);
  state.told = movedBy(state.told, stood);
  showStage(shapes);
  drawCurve(curvePainter, state.told, shapes);
  curvePainter.finish();
  showWords();
  performance.clearMeasures("manifuzz frame");
  performance.measure("manifuzz frame", { start, end: performance.now() });
}

// Every place of what was told, moved; directions stay.
function movedBy(told, by) {
  const place = (at) => along(at, by, 1);
  const edge = (ends) => ends.map((end) => ({ ...end, at: place(end.at) }));
  return { ...told, whole: edge(told.whole), nearest: { ...told.nearest, places: told.nearest.places.map(place) },
    sideClips: told.sideClips.map((clip) => ({ ...clip, corner: place(clip.corner), edge: edge(clip.edge) })),
    answers: told.answers.map((answer) => ({ ...answer,
      points: answer.points.map((point) => ({ ...point, at: place(point.at) })) })) };
}

function askToDraw() {
  if (isAsked) return;
  isAsked = true;
  requestAnimationFrame(draw);
}

let addressTimer = 0;
// Browsers limit how often an address may change.
function keepAddress() {
  clearTimeout(addressTimer);
  addressTimer = setTimeout(() => history.replaceState(null, "", addressOf(state.pair, state.step)), 120);
}

function change(pair) {
  state.pair = pair;
  tellTrouble("");
  askToDraw();
  keepAddress();
}

// A case from outside: refused in words where it has a defect.
function openCase(pair, step = state.step) {
  const defect = library.check(pair);
  if (defect !== "") {
    tellTrouble(`This case cannot be shown. ${defect}`);
    return;
  }
  state.origin = pair.a.position;
  state.step = step;
  byId("cases").querySelector("select").selectedIndex = EXAMPLES.findIndex(([, one]) => one === pair);
  change(pair);
  fit();
}

function tryToOpen(read) {
  try {
    const opened = read();
    if (opened) openCase(opened.pair, opened.step);
  } catch (error) {
    tellTrouble(`This case cannot be shown. ${error.message}`);
  }
}

async function openFile(file) {
  const text = await file.text();
  tryToOpen(() => ({ pair: caseFromText(text) }));
}

function download() {
  const link = element("a", { download: "case.json", href: URL.createObjectURL(new Blob([fileOf(state.pair)], { type: "application/json" })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

function setStep(step) {
  state.step = Math.min(Math.max(step, 0), LAST_STEP);
  askToDraw();
  keepAddress();
  announce(`${STEP_NAMES[state.step]}: ${stepInWords(state.told, state.step)}`);
}

const handleAt = (key) => handlesOf(state.pair).find((handle) => handle.key === key);

function startDrag(event) {
  const key = event.target.dataset.handle;
  if (event.button !== 0 || (!key && event.pointerType === "touch")) return;
  if (key) event.target.focus();
  svg.setPointerCapture(event.pointerId);
  state.drag = { id: event.pointerId, handle: key && handleAt(key), from: [event.clientX, event.clientY], pair: state.pair, camera: state.camera };
  event.preventDefault();
}

function goOnDragging(event) {
  const { drag, camera } = state;
  if (!drag || drag.id !== event.pointerId) return;
  const [right, down] = [event.clientX - drag.from[0], event.clientY - drag.from[1]];
  if (!drag.handle) {
    state.camera = panBy(drag.camera, right, down);
    askToDraw();
    return;
  }
  const by = [right / camera.scale, -down / camera.scale];
  const pair = farthest(library.check, (share) => moved(drag.pair, drag.handle, [share * by[0], share * by[1]], state.origin, drag.camera));
  if (pair) change(pair);
}

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

function pressKey(event) {
  const handle = handleAt(event.target.dataset?.handle);
  const arrow = ARROWS[event.key];
  if (!handle || !arrow || event.ctrlKey || event.metaKey || event.altKey) return;
  event.preventDefault();
  const times = event.shiftKey ? 10 : 1;
  const pair = nudged(state.pair, handle, arrow.map((by) => by * times), state.keyStep, state.origin, state.camera);
  const defect = library.check(pair);
  if (defect !== "") {
    announce(`It stays: ${defect}`);
    return;
  }
  change(pair);
  announce(`${handleName(handle)}, ${handleValue(handle, pair)}`);
}

function pressAnywhere(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches?.("select, input")) return;
  const action = { "[": () => setStep(state.step - 1), "]": () => setStep(state.step + 1), "+": () => zoom(ZOOM), "-": () => zoom(1 / ZOOM),
    0: () => { fit(); askToDraw(); } }[event.key];
  if (action) action();
}

function setRounding(side, isRound) {
  const pair = { ...state.pair, [side]: { ...state.pair[side], rounding: isRound ? "round" : "mitre" } };
  if (library.check(pair) === "") change(pair);
}

function buildControls() {
  const chooser = select("Example", EXAMPLES.map(([name], i) => [String(i), name]), "0", (i) => openCase(EXAMPLES[Number(i)][1]));
  const file = element("input", { type: "file", accept: ".json,.jsonl,application/json", class: "unseen", id: "file", tabindex: "-1",
    "aria-label": "A case of the corpus", change: () => { if (file.files[0]) openFile(file.files[0]); file.value = ""; } });
  byId("cases").replaceChildren(chooser, button("Open a case…", () => file.click()), file, button("Download the case", download),
    copyButtonOf("Copy the address", () => location.href));
  byId("steps").replaceChildren(...STEP_NAMES.map((name, i) => button(`${i + 1} ${name}`, () => setStep(i), { "data-step": i, class: "chip" })));
  const round = (side) => element("label", { class: "toggle" },
    element("input", { type: "checkbox", id: `round-${side}`, change: (event) => setRounding(side, event.target.checked) }), `${nameOf(side)}'s corners are round`);
  byId("controls").replaceChildren(round("a"), round("b"),
    select("Arrow keys move by", KEY_STEPS.map((text) => [text, text]), "0.1", (text) => { state.keyStep = Number(text); }),
    element("span", { class: "zoom" }, button("+", () => zoom(ZOOM), { "aria-label": "Closer" }), button("−", () => zoom(1 / ZOOM), { "aria-label": "Farther" }),
      button("All", () => { fit(); askToDraw(); })));
  byId("legend").replaceChildren(element("li", {}, element("i", { class: "sign-of subject" }), "clip64"),
    element("li", {}, element("i", { class: "sign-of oracle" }), "gjk64"), element("li", {}, element("i", { class: "sign-of ring" }), "least depth"));
}

// Copies what `text()` gives when it is pressed.
function copyButtonOf(label, text) {
  const node = button(label, async () => {
    history.replaceState(null, "", addressOf(state.pair, state.step));
    announce(await copyText(text(), node) ? "Copied to the clipboard" : "The browser does not let this page copy");
  });
  return node;
}

function listen() {
  svg.addEventListener("pointerdown", startDrag);
  svg.addEventListener("pointermove", goOnDragging);
  for (const name of ["pointerup", "pointercancel"]) svg.addEventListener(name, () => { state.drag = null; });
  svg.addEventListener("keydown", pressKey);
  document.addEventListener("keydown", pressAnywhere);
  addEventListener("hashchange", () => tryToOpen(() => caseFromAddress(location.hash)));
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    if (event.dataTransfer.files[0]) openFile(event.dataTransfer.files[0]);
  });
  new ResizeObserver(() => {
    const { clientWidth: width, clientHeight: height } = byId("stage");
    state.camera = { ...state.camera, width, height };
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    askToDraw();
  }).observe(byId("stage"));
}

// A page that holds this one gives the case, as text.
function askForCase() {
  if (parent === window) return;
  document.documentElement.dataset.held = "true";
  addEventListener("message", ({ source, data }) => {
    if (source === parent && typeof data === "string") tryToOpen(() => ({ pair: caseFromText(data) }));
  });
  parent.postMessage(PLAYGROUND_IS_READY, "*");
}

async function start() {
  startTheme();
  buildControls();
  byId("stage").append(svg);
  byId("curve").append(curveSvg);
  stagePainter = makePainter(svg, STAGE_LAYERS);
  curvePainter = makePainter(curveSvg, ["levels", "shapes", "line", "texts", "marks"]);
  library = await loadModule();
  fit();
  tryToOpen(() => caseFromAddress(location.hash));
  draw();
  listen();
  document.documentElement.dataset.ready = "true";
  askForCase();
}

start().catch((error) => tellTrouble(`This page needs a browser of 2024 or later: ${error.message}`));
