// The first screen of a campaign: who is wrong in how many of the cases, how badly and by what causes, each with a small picture.

const CAUSES_SHOWN = 5;
const VERDICT_WORDS = [["agree", "both right and the same"], ["tie", "both right and not the same"],
  ["ill_posed", "too near for float to tell"], ["unsupported", "not taken by one of both"]];
const LOST = ["crashed", "timed_out", "malformed"];

function partsOfBucket({ bucket }) {
  const [fault, verdict, kind, tieClass] = bucket.split("/");
  return { fault, verdict, kind, tieClass };
}

function shareInWords(count, cases) {
  if (!(cases > 0)) return "";
  const share = 100 * count / cases;
  if (count === 0 || count === cases) return count === 0 ? "0%" : "100%";
  if (share >= 99.9) return "more than 99.9%";
  if (share >= 10) return `${share.toFixed(1)}%`;
  return share < 0.01 ? "less than 0.01%" : `${Number(share.toPrecision(2))}%`;
}

function sizes(magnitude) {
  return Number.isFinite(magnitude) ? `${short(magnitude)} of the size` : "more than any number";
}

// The buckets in which the subject or the oracle is at fault.
function wrongBuckets(result, fault) {
  return (result.buckets ?? []).filter((found) => [fault, "both"].includes(partsOfBucket(found).fault));
}

function wrongSentence(name, buckets, cases, errors) {
  const count = buckets.reduce((sum, found) => sum + (found.count ?? 0), 0);
  if (count === 0) return `${name}: no wrong answer`;
  const explained = buckets.filter(({ verdict }) => verdict === "known").reduce((sum, found) => sum + (found.count ?? 0), 0);
  const accepted = buckets.filter((found) => found.accepted).reduce((sum, found) => sum + (found.count ?? 0), 0);
  const worst = Math.max(...Object.values(errors ?? {}).map((error) => error ?? Infinity), 0);
  return [`${name}: wrong in ${whole(count)} (${shareInWords(count, cases)})${worst > 0 ? `, by ${sizes(worst)} at worst` : ""}`,
    explained > 0 && `${whole(explained)} explained by the ledger`, accepted > 0 && `${whole(accepted)} accepted`].filter(Boolean).join("; ");
}

// The subject's name, or the oracle's, told apart where both have one name.
function nameOf(result, fault) {
  return result.subject === result.oracle ? `${result[fault]} (${fault})` : result[fault];
}

function decidesStatus(found) {
  if (found.accepted || found.in_baseline || !UNEXPLAINED.has(found.verdict)) return false;
  return LOST.includes(found.verdict) || partsOfBucket(found).fault !== "oracle" || found.new;
}

// Buckets of one kind and of whoever is at fault, the subject where both are: its own first, lost answers before wrong ones, then the
// most wrong. Of each, new buckets first; of these the clearest: no near tie, plainly wrong, the most frequent.
function findingGroups(result) {
  const order = (found) => [found.new ? 0 : 1, partsOfBucket(found).tieClass === "none" ? 0 : 1, found.bucket.endsWith("/gross") ? 0 : 1, -found.count];
  const groups = Map.groupBy((result.buckets ?? []).filter(decidesStatus), (found) => {
    const { fault, verdict, kind } = partsOfBucket(found);
    return `${nameOf(result, fault === "oracle" ? "oracle" : "subject")}: ${words(kind === "none" ? verdict : kind)}`;
  });
  return [...groups].map(([name, buckets]) => ({
    name, count: buckets.reduce((sum, found) => sum + (found.count ?? 0), 0), magnitude: Math.max(...buckets.map((found) => found.magnitude ?? Infinity)),
    isNew: buckets.some((found) => found.new), buckets: sortedBy(buckets, order),
    place: [partsOfBucket(buckets[0]).fault === "oracle" ? 1 : 0, LOST.includes(buckets[0].verdict) ? 0 : 1],
  })).sort((p, q) => p.place[0] - q.place[0] || p.place[1] - q.place[1] || q.magnitude - p.magnitude);
}

// By the first of these numbers in which two differ.
function sortedBy(all, numbersOf) {
  return all.toSorted((p, q) => numbersOf(p).map((number, i) => number - numbersOf(q)[i]).find((difference) => difference !== 0) ?? 0);
}

function findingItem(group) {
  const [clearest] = group.buckets;
  const one = report.caseOf.get(clearest.file);
  return element("li", { class: "cause" }, one && caseLink(one, thumbnail(one)),
    element("div", {}, element("p", { class: "cause-head bad" }, `${group.isNew ? "new " : ""}${group.name}`),
      element("p", {}, [`${counted(group.count, "time")}${group.buckets.length > 1 ? ` in ${counted(group.buckets.length, "bucket")}` : ""}`,
        group.magnitude > 0 && `by ${sizes(group.magnitude)} at worst`].filter(Boolean).join(", ")),
      clearest.command && copyButton("Copy the command", clearest.command)));
}

function causeItem({ id, hits }) {
  const known = report.ledger?.[id];
  const one = report.cases.find(({ file }) => known && file.endsWith(known.witness));
  return element("li", { class: "cause" }, one && caseLink(one, thumbnail(one)),
    element("div", {}, element("p", { class: "cause-head" }, counted(hits, "time")), element("p", {}, known?.words ?? id)));
}

function causesOf(result) {
  const met = (result.ledger ?? []).filter(({ hits }) => hits > 0).sort((p, q) => q.hits - p.hits);
  const rest = met.slice(CAUSES_SHOWN);
  return [met.length > 0 && element("ul", { class: "causes" }, met.slice(0, CAUSES_SHOWN).map(causeItem)),
    rest.length > 0 && element("p", { class: "quiet" }, `${counted(rest.length, "other cause")}: ${whole(rest.reduce((sum, { hits }) => sum + hits, 0))} times`)];
}

function overviewOf({ result }) {
  const groups = findingGroups(result);
  return element("article", { class: "overview" },
    element("h2", {}, pairOf(result)),
    element("p", {}, `${counted(result.cases ?? 0, "case")}: ${VERDICT_WORDS.filter(([verdict]) => result.verdicts?.[verdict] > 0).map(([verdict, text]) => `${text} ${shareInWords(result.verdicts[verdict], result.cases)}`).join(", ")}`),
    element("h3", {}, wrongSentence(nameOf(result, "subject"), wrongBuckets(result, "subject"), result.cases, result.worst_error?.subject)),
    groups.length > 0 ? element("ul", { class: "causes" }, groups.slice(0, CAUSES_SHOWN).map(findingItem))
      : element("p", { class: "quiet" }, "Nothing that is new or unexplained."),
    groups.length > CAUSES_SHOWN && element("p", { class: "quiet" }, `${counted(groups.length - CAUSES_SHOWN, "other kind")}: see the buckets below`),
    (result.hints ?? []).map(({ text }) => element("p", { class: "hint" }, `Hint: ${text}`)),
    result.oracle && element("h3", {}, wrongSentence(nameOf(result, "oracle"), wrongBuckets(result, "oracle"), result.cases, result.worst_error?.oracle)), ...causesOf(result));
}
