// The first screen of a campaign: who is wrong in how many of the cases, how badly and by what causes, each with a small picture. Its
// sentences are those of the screen that the campaign ended with.

const SHOWN_FIRST = 5;

// How wrong an answer is, as the page says it everywhere.
function sizes(magnitude) {
  return Number.isFinite(magnitude) ? `${short(magnitude)} of the size` : "more than any number";
}

function item(one, head, css, ...rest) {
  return element("li", { class: "cause" }, one && caseLink(one, thumbnail(one)),
    element("div", {}, element("p", { class: css }, head), ...rest));
}

function findingItem({ new: isNew, what, how, file, command }) {
  return item(report.caseOf.get(file), `${isNew ? "new " : ""}${what}`, "cause-head bad", element("p", {}, how),
    command && copyButton("Copy the command", command));
}

function causeItem({ hits, words: text, witness }) {
  const one = witness && report.cases.find(({ file }) => file.endsWith(witness));
  return item(one, counted(hits, "time"), "cause-head", element("p", {}, text));
}

// The first few as a list, and in words what the rest is.
function listOf(all, itemOf, restInWords) {
  const rest = all.slice(SHOWN_FIRST);
  return [all.length > 0 && element("ul", { class: "causes" }, all.slice(0, SHOWN_FIRST).map(itemOf)),
    rest.length > 0 && element("p", { class: "quiet" }, restInWords(rest))];
}

function overviewOf({ result, overview, curve }) {
  if (!overview) return null;
  const { verdicts, subject, oracle, causes, findings } = overview;
  return element("article", { class: "overview" }, element("h2", {}, pairOf(result)),
    element("p", {}, `${counted(result.cases ?? 0, "case")}: ${verdicts}`), element("h3", {}, subject),
    findings.length === 0 && element("p", { class: "quiet" }, "Nothing that is new or unexplained."),
    ...listOf(findings, findingItem, (rest) => `${counted(rest.length, "other kind")}: see the buckets below`),
    (result.hints ?? []).map(({ text }) => element("p", { class: "hint" }, `Hint: ${text}`)),
    oracle && element("h3", {}, oracle),
    ...listOf(causes, causeItem, (rest) => `${counted(rest.length, "other cause")}: ${whole(rest.reduce((sum, { hits }) => sum + hits, 0))} times`),
    ...riskParts({ result, curve }));
}
