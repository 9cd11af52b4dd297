// The cases: verdicts by regime, filters, and one card a bucket. The list grows as it is scrolled, so that a thousand cases
// cost no more than what is looked at.

const CARDS_AT_ONCE = 16;
const NO_REGIME = "by hand";
const filters = { verdicts: new Set(), regime: "", text: "", sort: "verdict" };
const list = { groups: [], shown: 0, order: [] };

const greatestOf = (key) => (group) => -(greatest(group.cases.map((one) => one[key])) ?? -1);
const SORTS = {
  verdict: ["verdict, magnitude", ({ cases: [{ verdict }] }) => (VERDICTS.includes(verdict) ? VERDICTS.indexOf(verdict) : VERDICTS.length)],
  magnitude: ["magnitude", greatestOf("magnitude")],
  count: ["count", greatestOf("count")],
  severity: ["severity", greatestOf("severity")],
  vertices: ["fewest vertices", (group) => Math.min(...group.cases.map((one) => one.vertices))],
  name: ["name", () => 0],
};

function caseHash(one) {
  return `#case=${encodeURIComponent(one.id)}`;
}

function caseLink(one, ...children) {
  return element("a", { href: caseHash(one), "data-case": one.id }, ...children);
}

// The file's name, linked to its case where the page has it.
function fileLink(file, text = file) {
  const one = report.caseOf.get(file);
  return one ? element("a", { href: caseHash(one) }, text) : element("span", {}, text);
}

function regimeOf(one) {
  return one.regime || NO_REGIME;
}

function verdictMark(verdict) {
  return element("span", { class: `dot ${UNEXPLAINED.has(verdict) ? "bad" : verdict}`, "aria-hidden": "true" });
}

function namedVerdict(verdict) {
  return element("span", { class: "verdict-name" }, verdictMark(verdict), words(verdict) || "no verdict");
}

function matrixCell(count, most, regime, verdict) {
  if (count === 0) return element("span", { class: "none" }, "0");
  const filter = () => {
    setFilters({ verdicts: new Set([verdict]), regime, text: "" });
    byId("filters").scrollIntoView({ block: "start" });
  };
  return button(whole(count), filter, { class: "cell", style: `--share: ${Math.round(10 + 50 * Math.sqrt(count / most))}%`,
    "aria-label": `show ${counted(count, "file")}: ${words(verdict)}, ${words(regime)}` });
}

// Counted from the files that are shown; beside them what the runs counted. A count filters the list.
function verdictMatrix() {
  const verdicts = VERDICTS.filter((verdict) => report.cases.some((one) => one.verdict === verdict));
  const ran = report.fuzz.flatMap(({ result }) => result.regimes ?? []);
  const regimes = [...new Set([...ran.map(({ name }) => name), ...report.cases.map(regimeOf)])];
  if (verdicts.length === 0 || regimes.length < 2) return null;
  const counts = tally(report.cases.map((one) => `${regimeOf(one)} ${one.verdict}`));
  const most = Math.max(...counts.values());
  const columns = [["regime", words], ...verdicts.map((verdict) =>
    [words(verdict), (regime) => matrixCell(counts.get(`${regime} ${verdict}`) ?? 0, most, regime, verdict), "number"])];
  if (ran.length > 0) {
    columns.push(...["cases", "unexplained"].map((key) => [`run: ${key}`, (regime) => {
      const rows = ran.filter(({ name }) => name === regime);
      return rows.length > 0 && whole(rows.reduce((sum, row) => sum + (row[key] ?? 0), 0));
    }, "number quiet"]));
  }
  return element("div", { class: "block matrix" }, element("h3", {}, "Files by regime and verdict"),
    table("Files by regime and verdict", columns, regimes));
}

function passes(one, but = "") {
  const { verdicts, regime, text } = filters;
  return (but === "verdicts" || verdicts.size === 0 || verdicts.has(one.verdict)) && (regime === "" || regimeOf(one) === regime)
    && text.toLowerCase().split(/\s+/).every((word) => one.searched.includes(word));
}

// The cases that pass, by bucket and pair of colliders, in the chosen order.
function shownGroups() {
  const groups = Map.groupBy(report.cases.filter((one) => passes(one)), ({ group }) => group);
  const all = [...groups].map(([key, cases]) => ({ key, cases }));
  const order = new Map(all.map((group) => [group, [SORTS[filters.sort][1](group), filters.sort === "name" ? 0 : SORTS.magnitude[1](group)]]));
  return all.sort((p, q) => {
    const [first, second] = [order.get(p), order.get(q)];
    return first[0] - second[0] || first[1] - second[1] || (p.key < q.key ? -1 : Number(p.key > q.key));
  });
}

// Counts say what a chip would show beside the other filters.
function refreshFilters() {
  const counts = tally(report.cases.filter((one) => passes(one, "verdicts")).map(({ verdict }) => verdict));
  for (const chip of document.querySelectorAll(".chip")) {
    const { verdict } = chip.dataset;
    chip.querySelector("b").textContent = whole(counts.get(verdict) ?? 0);
    chip.classList.toggle("empty", !counts.has(verdict));
    chip.setAttribute("aria-pressed", filters.verdicts.has(verdict));
  }
  byId("search").value = filters.text;
  byId("regime").value = filters.regime;
  byId("clear").hidden = filters.verdicts.size === 0 && filters.regime === "" && filters.text === "";
}

function setFilters(changes) {
  Object.assign(filters, changes);
  refreshList();
}

function verdictChip(verdict) {
  const node = button("", () => {
    if (!filters.verdicts.delete(verdict)) filters.verdicts.add(verdict);
    refreshList();
  }, { class: "chip", "data-verdict": verdict });
  node.append(namedVerdict(verdict), element("b"));
  return node;
}

function filterBar() {
  const verdicts = [...VERDICTS, ""].filter((verdict) => report.cases.some((one) => one.verdict === verdict));
  const regimes = [...new Set(report.cases.map(regimeOf))].sort();
  const search = element("input", { id: "search", type: "search", placeholder: "file, collider, bucket, note", autocomplete: "off",
    input: () => setFilters({ text: search.value }) });
  return element("form", { id: "filters", class: "filters", role: "search", submit: (event) => event.preventDefault() },
    element("div", { class: "chips", role: "group", "aria-label": "Verdicts" }, verdicts.map(verdictChip)),
    element("div", { class: "fields" }, field("Search", search, "field grow"),
      select("Regime", [["", "every regime"], ...regimes.map((name) => [name, words(name)])], "", (regime) => setFilters({ regime }), { id: "regime" }),
      select("Sort by", Object.entries(SORTS).map(([name, [title]]) => [name, title]), filters.sort, (sort) => setFilters({ sort }), { id: "sort" }),
      button("Clear", () => setFilters({ verdicts: new Set(), regime: "", text: "" }), { id: "clear", hidden: true })));
}

function witness(one) {
  const title = one.role === "worst" ? "Worst" : one.bucket ? "Smallest" : "Case";
  const link = caseLink(one, thumbnail(one), element("span", { class: "witness-line" }, element("b", {}, title),
    element("span", {}, counted(one.vertices, "vertex", "vertices")), Number.isFinite(one.magnitude) && element("span", {}, `error ${sizes(one.magnitude)}`)));
  return setAttributes(link, { class: "witness", "aria-label": `${title}: ${one.sentence || one.note || one.file}` });
}

// The two to draw: a smallest one with its worst where that is shown, else the first two.
function witnessesOf(cases) {
  const worst = cases.find((one) => cases.some(({ file }) => file === one.smallest));
  return worst ? [cases.find(({ file }) => file === worst.smallest), worst] : cases.slice(0, 2);
}

function fileList(cases) {
  return element("ul", { class: "files" }, cases.map((one) => element("li", {}, caseLink(one, one.file),
    element("span", {}, [counted(one.vertices, "vertex", "vertices"), Number.isFinite(one.magnitude) && `error ${sizes(one.magnitude)}`,
      one.property && `property ${one.property}`].filter(Boolean).join(", ")))));
}

function card({ cases }) {
  const [first] = cases;
  const drawn = witnessesOf(cases);
  const rest = cases.filter((one) => !drawn.includes(one));
  const most = (key) => greatest(cases.map((one) => one[key]));
  return element("article", { class: "card" },
    element("header", {}, namedVerdict(first.verdict),
      element("span", { class: "pair" }, [first.subject, first.oracle].filter(Boolean).join(" against "))),
    element("h3", {}, first.bucket ? bucketWords(first.bucket) : folderOf(first.file) || baseName(first.file)),
    first.sentence && element("p", { class: "sentence" }, first.sentence),
    element("div", { class: "witnesses" }, drawn.map(witness)),
    facts([["met", whole(most("count"))], ["error", most("magnitude") !== null && sizes(most("magnitude"))], ["severity", short(most("severity"))],
      ["files", whole(cases.length)]]),
    rest.length > 0 && disclosure(counted(rest.length, "further file"), () => fileList(rest)));
}

// What lies above the window does not count: a jump to a later section must not fill the list.
const nearEnd = new IntersectionObserver((entries) => {
  if (entries.some((entry) => entry.isIntersecting)) growList();
}, { rootMargin: "-25% 0px 800px 0px" });

function growList(most = CARDS_AT_ONCE) {
  const next = list.groups.slice(list.shown, list.shown + most);
  list.shown += next.length;
  byId("cards").append(...next.map(card));
  const more = byId("more");
  more.hidden = list.shown >= list.groups.length;
  // Observing anew reports again, as long as the end stays in sight.
  nearEnd.unobserve(more);
  if (!more.hidden) nearEnd.observe(more);
}

function refreshList() {
  const groups = shownGroups();
  Object.assign(list, { groups, shown: 0, order: groups.flatMap(({ cases }) => cases) });
  for (const holder of byId("cards").querySelectorAll(".thumbnail-holder")) nearWindow.unobserve(holder);
  byId("cards").replaceChildren();
  growList();
  refreshFilters();
  byId("shown-count").textContent = groups.length === 0 ? "No file passes these filters."
    : `${counted(list.order.length, "file")} of ${whole(report.cases.length)}, in ${counted(groups.length, "group")}`;
}

// The keys j and k walk through what the list shows.
function walkList(step) {
  const links = [...document.querySelectorAll("#cards a[data-case]")];
  const link = links[Math.min(Math.max(links.indexOf(document.activeElement) + step, 0), links.length - 1)];
  link?.focus();
  link?.scrollIntoView({ block: "nearest" });
}

function casesParts() {
  const marks = MARKS.map(([mark, name]) => element("span", {}, mark(), name));
  return [verdictMatrix(), filterBar(), element("div", { class: "marks", "aria-label": "What the pictures show" }, marks), element("p", { id: "shown-count", class: "quiet", role: "status" }),
    element("div", { id: "cards", class: "cards" }), element("div", { id: "more", class: "quiet" }, "more below")];
}
