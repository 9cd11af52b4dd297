// Wheel, drag, pinch and keys, as changes of the camera.

const DRAG_STARTS = 3;  // pixels: less is a tap

function placeIn(svg, event) {
  const box = svg.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

function onWheel(svg, viewing) {
  svg.addEventListener("wheel", (event) => {
    event.preventDefault();
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
    const pinch = event.ctrlKey ? 4 : 1;
    viewing.zoom(2 ** (-event.deltaY * lines * pinch / 240), placeIn(svg, event));
  }, { passive: false });
}

// Two fingers: what lay under them stays under them.
function pinched(viewing, before, after) {
  const [from, to] = [middle(...before), middle(...after)];
  viewing.look(panBy(viewing.camera, to[0] - from[0], to[1] - from[1]));
  viewing.zoom(distance(...after) / Math.max(1, distance(...before)), to);
}

function onPointers(svg, viewing) {
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
    const others = [...fingers].filter(([id]) => id !== event.pointerId).map(([, place]) => place);
    moved += distance(before, at);
    if (others.length === 0 && moved < DRAG_STARTS) return;
    svg.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, at);
    if (others.length > 0) pinched(viewing, [others[0], before], [others[0], at]);
    else viewing.look(panBy(viewing.camera, at[0] - before[0], at[1] - before[1]));
  });
  for (const end of ["pointerup", "pointercancel"]) svg.addEventListener(end, (event) => fingers.delete(event.pointerId));
  svg.addEventListener("dblclick", () => viewing.reset());
}

// Goes through everything that can be pointed at.
function focusTarget(svg, step) {
  const targets = [...svg.querySelectorAll(".target")].reverse();
  const at = targets.indexOf(document.activeElement);
  targets[(at + step + targets.length + (at < 0 && step < 0 ? 1 : 0)) % targets.length]?.focus({ preventScroll: true });
}

function pictureKeys(viewing) {
  const pan = (right, down) => () => viewing.look(panBy(viewing.camera, right, down));
  return {
    "0": () => viewing.reset(), f: () => viewing.fitPoints(), o: () => viewing.fitOverlap(), t: () => viewing.fitThickness(),
    "+": () => viewing.zoom(2), "=": () => viewing.zoom(2), "-": () => viewing.zoom(1 / 2),
    "[": () => viewing.stepRight(-1), "]": () => viewing.stepRight(1),
    ".": () => focusTarget(viewing.svg, 1), ",": () => focusTarget(viewing.svg, -1),
    "Shift ArrowRight": pan(-60, 0), "Shift ArrowLeft": pan(60, 0), "Shift ArrowDown": pan(0, -60), "Shift ArrowUp": pan(0, 60),
  };
}

function caseKeys(viewing) {
  const [next, previous] = [() => viewing.go(1), () => viewing.go(-1)];
  return { j: next, ArrowRight: next, ArrowDown: next, k: previous, ArrowLeft: previous, ArrowUp: previous };
}

// What is typed into a field, or with a modifier of the browser's, is none of ours.
function isTyping(event) {
  return event.ctrlKey || event.metaKey || event.altKey || event.target.matches?.("input:not([type=checkbox]), select, textarea");
}

// `keysNow()` gives what each key does at the moment.
function onKeys(node, keysNow) {
  node.addEventListener("keydown", (event) => {
    const name = event.shiftKey && event.key.startsWith("Arrow") ? `Shift ${event.key}` : event.key;
    const keys = keysNow();
    if (isTyping(event) || !keys[name]) return;
    event.preventDefault();
    keys[name]();
  });
}
