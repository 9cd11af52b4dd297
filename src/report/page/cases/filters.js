// Which cases are shown, and in which order.

const filters = { verdicts: new Set(), regime: "", text: "", sort: "verdict" };

const SORTS = {
  verdict: ["verdict, magnitude", verdictRank],
  magnitude: ["magnitude", (group) => -(greatest(group.cases.map((one) => one.magnitude)) ?? -1)],
  count: ["count", (group) => -(greatest(group.cases.map((one) => one.count)) ?? -1)],
  severity: ["severity", (group) => -(greatest(group.cases.map((one) => one.severity)) ?? -1)],
  vertices: ["fewest vertices", (group) => Math.min(...group.cases.map((one) => one.vertices))],
  name: ["name", () => 0],
};

function verdictRank(group) {
  const rank = VERDICTS.indexOf(group.cases[0].verdict);
  return rank < 0 ? VERDICTS.length : rank;
}

function passes(one, but = "") {
  const { verdicts, regime, text } = filters;
  return (but === "verdicts" || verdicts.size === 0 || verdicts.has(one.verdict))
    && (but === "regime" || regime === "" || regimeOf(one) === regime)
    && text.toLowerCase().split(/\s+/).every((word) => one.searched.includes(word));
}

// The cases that pass, by bucket and pair of colliders, in the chosen order.
function shownGroups() {
  const groups = new Map();
  for (const one of report.cases) {
    if (!passes(one)) continue;
    if (!groups.has(one.group)) groups.set(one.group, { key: one.group, cases: [] });
    groups.get(one.group).cases.push(one);
  }
  const list = [...groups.values()];
  for (const group of list) {
    group.order = SORTS[filters.sort][1](group);
    group.magnitude = greatest(group.cases.map((one) => one.magnitude)) ?? -1;
  }
  const byName = (p, q) => (p.key < q.key ? -1 : Number(p.key > q.key));
  const byMagnitude = (p, q) => (filters.sort === "name" ? 0 : q.magnitude - p.magnitude);
  return list.sort((p, q) => p.order - q.order || byMagnitude(p, q) || byName(p, q));
}

function verdictChip(verdict) {
  const node = button("", () => {
    if (!filters.verdicts.delete(verdict)) filters.verdicts.add(verdict);
    refreshList();
  }, { class: "chip", "data-verdict": verdict });
  node.append(verdictMark(verdict), element("span", {}, verdict === "" ? "no verdict" : words(verdict)), element("b", {}));
  return node;
}

// Counts say what a chip would show beside the other filters.
function refreshFilters() {
  const counts = new Map();
  for (const one of report.cases) {
    if (passes(one, "verdicts")) counts.set(one.verdict, (counts.get(one.verdict) ?? 0) + 1);
  }
  for (const chip of document.querySelectorAll(".chip")) {
    const count = counts.get(chip.dataset.verdict) ?? 0;
    chip.querySelector("b").textContent = whole(count);
    chip.classList.toggle("empty", count === 0);
    chip.setAttribute("aria-pressed", filters.verdicts.has(chip.dataset.verdict));
  }
  byId("search").value = filters.text;
  byId("regime").value = filters.regime;
  byId("clear").hidden = filters.verdicts.size === 0 && filters.regime === "" && filters.text === "";
}

function filterBy(regime, verdict) {
  Object.assign(filters, { verdicts: new Set([verdict]), regime, text: "" });
  refreshList();
  byId("filters").scrollIntoView({ block: "start" });
}

function clearFilters() {
  Object.assign(filters, { verdicts: new Set(), regime: "", text: "" });
  refreshList();
}

function searchField() {
  const field = element("input", { id: "search", type: "search", placeholder: "file, collider, bucket, note", autocomplete: "off",
    on: { input: () => { filters.text = field.value; refreshList(); } } });
  return element("label", { class: "field grow" }, element("span", {}, "Search"), field);
}

function filterBar() {
  const verdicts = [...VERDICTS, ""].filter((verdict) => report.cases.some((one) => one.verdict === verdict));
  const regimes = [...new Set(report.cases.map(regimeOf))].sort();
  const regime = select("Regime", [["", "every regime"], ...regimes.map((name) => [name, words(name)])], "",
    (value) => { filters.regime = value; refreshList(); });
  regime.querySelector("select").id = "regime";
  const sort = select("Sort by", Object.entries(SORTS).map(([name, [title]]) => [name, title]), filters.sort,
    (value) => { filters.sort = value; refreshList(); });
  sort.querySelector("select").id = "sort";
  return element("form", { id: "filters", class: "filters", role: "search", on: { submit: (event) => event.preventDefault() } },
    element("div", { class: "chips", role: "group", "aria-label": "Verdicts" }, verdicts.map(verdictChip)),
    element("div", { class: "fields" }, searchField(), regime, sort,
      button("Clear", clearFilters, { id: "clear", hidden: true })));
}
