// The viewer: one case, large, with everything that is known of it.

const viewing = { one: null, camera: null, whole: null, show: SHOW_ALL, right: 0, svg: null, painter: null, isWaiting: false };

const WHOLE_MARGIN = 46;

Object.assign(viewing, {
  redraw() {
    if (viewing.isWaiting) return;
    viewing.isWaiting = true;
    requestAnimationFrame(() => {
      viewing.isWaiting = false;
      if (byId("viewer").open && viewing.camera) drawViewing();
    });
  },
  look(camera) {
    viewing.camera = limited(camera, viewing.whole);
    viewing.redraw();
  },
  zoom(factor, at) {
    const { scale, width, height } = viewing.camera;
    const next = limited({ scale: scale * factor }, viewing.whole).scale;
    viewing.look(zoomAt(viewing.camera, at ?? [width / 2, height / 2], next / scale));
  },
  reset() {
    viewing.look(viewing.whole);
  },
  fitPlaces(places) {
    if (places.length === 0) announce("There is nothing to zoom to");
    else viewing.look(cameraOn(places, viewing.one, viewing.camera.width, viewing.camera.height));
  },
  fitPoints() {
    viewing.fitPlaces(contactPlaces(viewing));
  },
  fitOverlap() {
    viewing.fitPlaces(overlapOf(...viewing.one.bodies.map((body) => outlineOf(body, flatFor(viewing.whole)))));
  },
  // So closely that the overlap, or else the thinner polygon, has a width to see.
  fitThickness() {
    const overlap = overlapOf(...viewing.one.bodies.map(({ vertices }) => vertices));
    const shapes = overlap.length > 0 ? [overlap] : viewing.one.bodies.map(({ vertices }) => vertices);
    const thin = shapes.reduce((best, next) => (thicknessOf(next) < thicknessOf(best) ? next : best));
    const thickness = thicknessOf(thin);
    if (!(thickness > 0)) return viewing.fitPlaces(thin);
    const { width, height } = viewing.camera;
    const [x, y] = [0, 1].map((axis) => thin.reduce((sum, point) => sum + point[axis] / thin.length, 0));
    return viewing.look({ x, y, width, height, scale: Math.min(width, height) / 4 / thickness });
  },
  // A point so closely that its distance to the truth, where there is one, can be seen.
  locate(role, index) {
    const answer = answerOf(viewing.one, role);
    if (!viewing.camera) return;
    const { position } = answer.manifolds[role === "truth" ? viewing.right : 0].points[index];
    if (!isPoint(position)) return;
    const off = differenceToTruth(viewing.one, answer)?.points[index]?.position;
    const span = off > 0 ? off * 4 : (viewing.one.size || 1) / 50;
    const { width, height } = viewing.camera;
    viewing.look({ x: position[0], y: position[1], width, height, scale: Math.min(width, height) / span });
  },
  stepRight(by) {
    const rights = answerOf(viewing.one, "truth")?.manifolds.length ?? 0;
    if (rights < 2) return;
    viewing.right = (viewing.right + by + rights) % rights;
    byId("right-count").textContent = `right manifold ${viewing.right + 1} of ${rights}`;
    fillDetails();
    viewing.redraw();
  },
  go(step) {
    const order = list.order.includes(viewing.one) ? list.order : report.cases;
    const at = order.indexOf(viewing.one) + step;
    if (at < 0 || at >= order.length) return announce("There are no more cases");
    history.replaceState(null, "", caseHash(order[at]));
    return openCase(order[at]);
  },
});

function drawViewing() {
  const { camera, one, whole, show, right, painter, svg } = viewing;
  drawCase({ painter, camera, one, show, right, isThumbnail: false, describe: (key) => describeTarget(one, key, right) });
  svg.dataset.camera = [camera.x, camera.y, camera.scale].join(" ");
  byId("zoom-factor").textContent = `${brief(Number((camera.scale / whole.scale).toPrecision(2)))}\u00d7`;
  const focused = svg.contains(document.activeElement) ? document.activeElement : null;
  if (focused?.matches(".target")) focused.dispatchEvent(new FocusEvent("focusin", { bubbles: true }));
  else hideTooltip();
}

// Keeps what is at the middle when the window changes.
function resizeStage() {
  const { width, height } = byId("stage").getBoundingClientRect();
  if (!viewing.one?.isDrawable || width === 0 || height === 0) return;
  const zoomed = viewing.camera ? viewing.camera.scale / viewing.whole.scale : 1;
  viewing.whole = wholeCamera(viewing.one, width, height, Math.min(WHOLE_MARGIN, width / 8));
  viewing.camera = viewing.camera ? { ...viewing.camera, width, height, scale: viewing.whole.scale * zoomed } : viewing.whole;
  if (zoomed === 1) viewing.camera = viewing.whole;
  viewing.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  viewing.redraw();
}

const stageSize = new ResizeObserver(resizeStage);

function viewerHeader(one) {
  const order = list.order.includes(one) ? list.order : report.cases;
  const at = order.indexOf(one);
  return element("header", {},
    element("div", { class: "viewer-title" },
      element("h2", { id: "viewer-title", tabindex: "-1" }, verdictMark(one.verdict), one.sentence || (one.verdict && words(one.verdict)) || baseName(one.file)),
      element("p", { class: "quiet digits" }, `${at + 1} of ${order.length}: ${one.file}`)),
    element("div", { class: "viewer-buttons" },
      button("\u2039 Previous", () => viewing.go(-1), { disabled: at <= 0, title: "previous case (k)" }),
      button("Next \u203a", () => viewing.go(1), { disabled: at >= order.length - 1, title: "next case (j)" }),
      button("Close", () => byId("viewer").close(), { title: "close (Esc)" })));
}

function viewerStage(one) {
  if (!one.isDrawable) return element("div", { id: "stage" }, element("p", { class: "no-picture" }, "This case cannot be drawn: a coordinate is not finite."));
  viewing.svg = svgElement("svg", { class: "picture", tabindex: "0", role: "group",
    "aria-label": "The two polygons and their contact. Plus and minus zoom, shift and arrows move, full stop and comma step through points, vertices and faces." });
  viewing.painter = makePainter(viewing.svg, CASE_LAYERS);
  onWheel(viewing.svg, viewing);
  onPointers(viewing.svg, viewing);
  explainTargets(viewing.svg, ".target", (target) => describeTarget(one, target.dataset.key, viewing.right), byId("viewer"));
  return element("div", { id: "stage" }, viewing.svg);
}

function fillDetails() {
  byId("details").replaceChildren(...caseDetails(viewing.one, viewing.right, viewing.locate));
}

function openCase(one) {
  Object.assign(viewing, { one, camera: null, right: 0, painter: null });
  hideTooltip();
  const dialog = byId("viewer");
  stageSize.disconnect();
  const controls = one.isDrawable ? [zoomButtons(viewing), rightStepper(viewing), toggles(viewing)].filter(Boolean) : [];
  dialog.replaceChildren(viewerHeader(one), element("div", { class: "viewer-body" },
    element("div", { class: "stage-column" }, viewerStage(one), element("div", { class: "controls" }, controls)),
    element("div", { id: "details", class: "details", tabindex: "0", role: "region", "aria-label": "Details" })));
  fillDetails();
  if (!dialog.open) dialog.showModal();
  byId("viewer-title").focus();
  stageSize.observe(byId("stage"));
}

function openFromHash() {
  const [, id] = /^#case=(.*)$/.exec(location.hash) ?? [];
  if (id === undefined) return;
  let one;
  try {
    one = report.caseOf.get(decodeURIComponent(id));
  } catch {
    one = undefined;
  }
  if (one) openCase(one);
  else announce("This page has no such case");
}

function closeViewer() {
  hideTooltip();
  history.replaceState(null, "", location.href.split("#")[0]);
  const links = [...document.querySelectorAll("#cards a[data-case]")];
  links.find((link) => link.dataset.case === viewing.one.id)?.focus();
}

function startViewer() {
  const dialog = byId("viewer");
  onKeys(dialog, () => ({ ...caseKeys(viewing), ...(viewing.camera ? pictureKeys(viewing) : {}), "?": openHelp }));
  dialog.addEventListener("close", closeViewer);
  addEventListener("hashchange", openFromHash);
  openFromHash();
}
