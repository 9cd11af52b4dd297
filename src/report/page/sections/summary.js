// The head of the page: what ran, and what came of it in one sentence.

function section(id, title, ...children) {
  const node = element("section", { id, "aria-labelledby": `${id}-title` },
    element("h2", { id: `${id}-title` }, title), ...children);
  byId("sections").append(element("a", { href: `#${id}` }, title));
  return node;
}

function facts(pairs) {
  const shown = pairs.filter(([, value]) => value !== "" && value !== null && value !== undefined);
  return element("dl", { class: "facts" }, shown.map(([name, value]) =>
    element("div", {}, element("dt", {}, name), element("dd", {}, value))));
}

function versionsOf(result) {
  return Object.entries(result.versions ?? {}).map(([name, version]) => `${name} ${version}`.trim()).join(", ");
}

function machineOf(result) {
  const { processor, cores, instruction_set } = result.machine ?? {};
  return [processor, cores && counted(cores, "core"), instruction_set].filter(Boolean).join(", ");
}

// What every command that measures says of itself.
function provenance(path, result, more = []) {
  return facts([["file", path], ...more, ["seed", result.seed === undefined ? "" : String(result.seed)],
    ["versions", versionsOf(result)], ["machine", machineOf(result)], ["compiler", result.compiler]]);
}

// Buckets that no right collider and no ledger entry explains, in the runs. A corpus keeps what was wrong once.
function unexplainedBuckets() {
  const buckets = report.fuzz.flatMap(({ result }) => result.buckets ?? []);
  return new Set(buckets.filter(({ verdict }) => UNEXPLAINED.has(verdict)).map(({ bucket }) => bucket)).size;
}

// What a corpus keeps of pairs of colliders that no run here is of, and of properties.
function recordedWrongs() {
  const ran = new Set([...report.fuzz, ...report.replay].map(({ result }) => pairOf(result)));
  const wrong = report.cases.filter((one) => UNEXPLAINED.has(one.verdict) && !ran.has(pairOf(one)));
  const failed = report.cases.filter(({ property }) => property);
  return [[new Set(wrong.map((one) => one.bucket || one.id)).size, "bucket"], [new Set(failed.map(({ property }) => property)).size, "property", "properties"]]
    .filter(([count]) => count > 0).map((entry) => `${counted(...entry)} recorded as wrong`);
}

function pairOf({ subject, oracle }) {
  return `${subject} against ${oracle}`;
}

// What keeps the buckets and figures of runs from being all there is to say of them.
function runsFellShort() {
  const runs = report.fuzz.map(({ result }) => result);
  const over = runs.flatMap((run) => run.ledger ?? []).filter((entry) => entry.over_budget?.length > 0).length;
  return [over > 0 && `${counted(over, "known defect", "known defects")} over budget`,
    runs.some((run) => run.vacuous) && "a vacuous run",
    runs.some((run) => run.stopped_early) && "a run that stopped early",
    [...runs, ...report.stress.map(({ result }) => result)].some((run) => run.interrupted) && "a run that was interrupted"].filter(Boolean);
}

// What results count, as far as it is a number.
function summed(results, countOf) {
  return results.reduce((sum, { result }) => sum + Math.abs(Number(countOf(result)) || 0), 0);
}

function fellShort() {
  const failed = summed(report.replay, (result) => Math.max(result.failures?.length ?? 0, result.failed ?? 0));
  const unread = report.errors.length + summed(report.replay, (result) => result.unread);
  const leftOut = summed(report.replay, (result) => result.left_out);
  const mismatches = report.scene.flatMap(({ result }) => result.rows ?? []).reduce((sum, row) => sum + Math.abs(Number(row.mismatches) || 0), 0);
  const worse = summed(report.stress, (result) => Object.keys(result.worse ?? {}).length);
  return [failed > 0 && `${counted(failed, "replayed case")} failed`,
    leftOut > 0 && `${counted(leftOut, "case")} left out`,
    mismatches > 0 && counted(mismatches, "mismatch", "mismatches"),
    worse > 0 && counted(worse, "breaking point got worse", "breaking points got worse"), ...runsFellShort(),
    unread > 0 && `${counted(unread, "file")} unread`].filter(Boolean);
}

function verdictSentence() {
  const unexplained = unexplainedBuckets();
  const bad = [unexplained > 0 && `${counted(unexplained, "bucket")} unexplained`, ...fellShort()].filter(Boolean);
  if (bad.length === 0 && report.fuzz.some(({ result }) => result.failed)) bad.push("a run that failed");
  bad.push(...recordedWrongs());
  if (bad.length > 0) return { text: bad.join(", "), isBad: true };
  if (report.fuzz.length > 0 || report.replay.length > 0) return { text: "Nothing unexplained", isBad: false };
  if (report.cases.length > 0) return { text: "Nothing recorded as unexplained", isBad: false };
  const measured = ["bench", "stress", "scene"].filter((kind) => report[kind].length > 0);
  return { text: measured.length > 0 ? `Measured: ${measured.join(", ")}` : "Nothing to show", isBad: false };
}

function pairsOfColliders() {
  const runs = report.fuzz.map(({ result }) => result);
  const pairs = new Set([...runs, ...report.cases].filter(({ subject, oracle }) => subject && oracle)
    .map(pairOf));
  return [...pairs];
}

function headline() {
  const pairs = pairsOfColliders();
  const ran = report.fuzz.reduce((sum, { result }) => sum + (result.cases ?? 0), 0);
  const seconds = report.fuzz.reduce((sum, { result }) => sum + (result.seconds ?? 0), 0);
  return [pairs.slice(0, 3).join("; ") + (pairs.length > 3 ? ` and ${counted(pairs.length - 3, "more pair")}` : ""),
    ran > 0 && `${counted(ran, "case")} in ${short(seconds)} s`,
    report.cases.length > 0 && `${counted(report.cases.length, "file")} shown`].filter(Boolean).join(" \u00b7 ");
}

function errorsBox() {
  if (report.errors.length === 0) return null;
  return element("div", { class: "errors", role: "alert" },
    element("strong", {}, `${counted(report.errors.length, "file or part", "files or parts")} could not be read`),
    element("ul", {}, report.errors.map((error) => element("li", {}, error))));
}

function summarySection() {
  const sentence = verdictSentence();
  const title = pairsOfColliders()[0] ?? "manifuzz";
  document.title = `${title}: ${sentence.text.toLowerCase()}`;
  return element("section", { id: "summary", "aria-label": "Summary" },
    element("h1", { class: sentence.isBad ? "bad" : "good" }, sentence.text),
    element("p", { class: "headline" }, headline()), errorsBox());
}

function footer() {
  const sources = report.sources.map(({ path, kind, cases }) =>
    element("li", {}, element("code", {}, path), ` ${kind}${Number.isFinite(cases) ? `, ${counted(cases, "case")}` : ""}`));
  return [element("p", {}, `manifuzz ${report.version}`), report.command ? copyLine(report.command) : null,
    sources.length > 0 ? element("details", {}, element("summary", {}, `Made from ${counted(sources.length, "source")}`),
      element("ul", {}, sources)) : null];
}
