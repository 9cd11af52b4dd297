// Puts the page together: sections, theme, help, paper.

const PAGE_KEYS = [["/", "search"], ["j  k", "next and previous case in the list"], ["Enter", "open the case"], ["?", "this help"]];
const CASE_KEYS = [["j  k", "next and previous case; also the arrows"], ["+  \u2212", "zoom; also the wheel, or two fingers"],
  ["Shift + arrows", "move; also by dragging"], ["0", "show everything; also a double click"], ["f", "zoom to the contact points"],
  ["o", "zoom to the overlap"], ["t", "zoom to the overlap's thickness"], [".  ,", "step through points, vertices and faces"], ["[  ]", "step through the right manifolds"], ["Esc", "close"]];
const MARKS = [[() => roleMark("truth"), "the truth: a point that is right"],
  [() => roleMark("subject"), "a point of the subject, the collider under test"],
  [() => roleMark("oracle"), "a point of the oracle, the collider it is held against"],
  [() => lineMark("depth-bar oracle"), "depth at a point of the oracle; the subject's is red, the truth's grey"],
  [() => lineMark("reference"), "reference face"], [() => lineMark("incident"), "incident edge"], [() => lineMark("plane"), "side plane"]];

function keyList(keys) {
  return facts(keys.map(([key, does]) => [key.split("  ").map((one) => element("kbd", {}, one)), does]), "keys");
}

function openHelp() {
  const dialog = byId("help");
  dialog.replaceChildren(
    element("header", {}, element("h2", { id: "help-title" }, "Keys, marks and words"), button("Close", () => dialog.close())),
    element("h3", {}, "On the page"), keyList(PAGE_KEYS), element("h3", {}, "In a case"), keyList(CASE_KEYS),
    element("h3", {}, "In a picture"), facts(MARKS.map(([mark, name]) => [mark(), name]), "keys"),
    element("h3", { id: "words" }, "Words"), facts(Object.entries(report.words ?? {}), "keys"));
  if (!dialog.open) dialog.showModal();
}

// On paper: the whole list, with every picture.
function preparePrint() {
  if (report.cases.length === 0) return;
  growList(list.groups.length);
  document.querySelectorAll(".thumbnail-holder").forEach(drawThumbnail);
}

function section(id, title, parts) {
  if (parts.length === 0) return null;
  byId("sections").append(element("a", { href: `#${id}` }, title));
  return element("section", { id, "aria-labelledby": `${id}-title` }, element("h2", { id: `${id}-title` }, title), ...parts);
}

// An article for each result of a kind.
function runs(results, partsOf) {
  return results.map(({ path, result }) => element("article", { class: "run" }, partsOf(result, path)));
}

function measured(results, partsOf) {
  return runs(results, (result, path) => [...partsOf(result), provenance(path, result)]);
}

function start() {
  byId("main").replaceChildren(...[summarySection(), ...report.fuzz.map(overviewOf),
    section("campaigns", "Campaigns", runs(report.fuzz, fuzzParts)),
    section("replay", "Replay", runs(report.replay, replayParts)),
    section("cases", "Cases", report.cases.length > 0 ? casesParts() : []),
    section("sequences", "Sequences", sequencesParts()),
    section("bench", "Bench", measured(report.bench, benchParts)),
    section("stress", "Stress", measured(report.stress, stressParts)),
    section("scenes", "Scenes", measured(report.scene, sceneParts))].filter(Boolean));
  byId("footer").append(...footer());
  startTheme();
  if (report.cases.length > 0) refreshList();
  byId("help-open").addEventListener("click", openHelp);
  onKeys(document, () => (document.querySelector("dialog[open]") ? {}
    : { "/": () => byId("search")?.focus(), j: () => walkList(1), k: () => walkList(-1), "?": openHelp }));
  startViewer();
  addEventListener("beforeprint", preparePrint);
  paper.addEventListener("change", () => paper.matches && preparePrint());
}

start();
