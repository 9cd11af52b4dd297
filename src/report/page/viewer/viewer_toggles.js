// What is drawn of a case: a switch for each collider, for the side planes and for the numbers.

function toggle(viewing, name, mark, label) {
  const box = element("input", { type: "checkbox", checked: viewing.show[name], "data-show": name, on: { change: () => {
    viewing.show = { ...viewing.show, [name]: box.checked };
    viewing.redraw();
  } } });
  return element("label", { class: "toggle" }, box, mark, label);
}

function planeMark() {
  return markSvg((svg) => svg.append(svgElement("path", { class: "plane", d: "M1 12H23" })));
}

function toggles(viewing) {
  const answers = ROLES.map((role) => answerOf(viewing.one, role)).filter(Boolean);
  return element("div", { class: "toggles", role: "group", "aria-label": "What is drawn" },
    answers.map(({ role, name }) => toggle(viewing, role, roleMark(role), role === "truth" ? "truth" : name)),
    toggle(viewing, "planes", planeMark(), "side planes"),
    toggle(viewing, "numbers", null, "vertex numbers"));
}

// Where several manifolds are right: a step to the next.
function rightStepper(viewing) {
  const rights = answerOf(viewing.one, "truth")?.manifolds.length ?? 0;
  if (rights < 2) return null;
  const step = (by) => () => viewing.stepRight(by);
  return element("div", { class: "stepper", role: "group", "aria-label": "Right manifolds" },
    button("\u2039", step(-1), { "aria-label": "previous right manifold" }),
    element("span", { id: "right-count", "aria-live": "polite" }, `right manifold ${viewing.right + 1} of ${rights}`),
    button("\u203a", step(1), { "aria-label": "next right manifold" }));
}

function zoomButtons(viewing) {
  return element("div", { class: "zoom", role: "group", "aria-label": "Zoom" },
    button("\u2212", () => viewing.zoom(1 / 2), { "aria-label": "zoom out", title: "zoom out (-)" }),
    element("output", { id: "zoom-factor", "aria-label": "zoom" }),
    button("+", () => viewing.zoom(2), { "aria-label": "zoom in", title: "zoom in (+)" }),
    button("Whole", () => viewing.reset(), { title: "show everything (0)" }),
    button("Fit points", () => viewing.fitPoints(), { title: "zoom to the contact (f)" }),
    button("Fit overlap", () => viewing.fitOverlap(), { title: "zoom to the overlap (o)" }),
    button("Fit thickness", () => viewing.fitThickness(), { title: "zoom to the overlap's thickness (t)" }));
}
