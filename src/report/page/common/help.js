// What the keys do, and what the marks in the pictures mean.

const PAGE_KEYS = [["/", "search"], ["j  k", "next and previous case in the list"], ["Enter", "open the case"], ["?", "this help"]];
const CASE_KEYS = [["j  k", "next and previous case; also the arrows"], ["+  \u2212", "zoom; also the wheel, or two fingers"],
  ["Shift + arrows", "move; also by dragging"], ["0", "show everything; also a double click"], ["f", "zoom to the contact points"],
  ["o", "zoom to the overlap"], ["t", "zoom to the overlap's thickness"], [".  ,", "step through points, vertices and faces"], ["[  ]", "step through the right manifolds"], ["Esc", "close"]];
const MARKS = [["reference", "reference face"], ["incident", "incident edge"], ["plane", "side plane"]];

function keyList(keys) {
  return element("dl", { class: "keys" }, keys.map(([key, does]) =>
    element("div", {}, element("dt", {}, key.split("  ").map((one) => element("kbd", {}, one))), element("dd", {}, does))));
}

function lineMark(css) {
  return markSvg((svg) => svg.append(svgElement("path", { class: css, d: "M3 12H21" })));
}

function markList() {
  const roles = { truth: "the truth: a point that is right", subject: "a point of the subject, the collider under test",
    oracle: "a point of the oracle, the collider it is held against" };
  return element("dl", { class: "keys" },
    ROLES.map((role) => element("div", {}, element("dt", {}, roleMark(role)), element("dd", {}, roles[role]))),
    MARKS.map(([css, name]) => element("div", {}, element("dt", {}, lineMark(css)), element("dd", {}, name))));
}

function openHelp() {
  const dialog = byId("help");
  if (dialog.childElementCount === 0) {
    dialog.append(element("header", {}, element("h2", { id: "help-title" }, "Keys and marks"), button("Close", () => dialog.close())),
      element("h3", {}, "On the page"), keyList(PAGE_KEYS), element("h3", {}, "In a case"), keyList(CASE_KEYS),
      element("h3", {}, "In a picture"), markList());
  }
  if (!dialog.open) dialog.showModal();
}

function startHelp() {
  byId("help-open").addEventListener("click", openHelp);
  document.addEventListener("keydown", (event) => {
    if (isTyping(event) || document.querySelector("dialog[open]")) return;
    const keys = { "/": () => byId("search")?.focus(), j: () => walkList(1), k: () => walkList(-1), "?": openHelp };
    if (!keys[event.key]) return;
    event.preventDefault();
    keys[event.key]();
  });
}
