// The head of the page, what ran and what came of it in one sentence; campaigns; and corpus cases that were run again.

function machineOf(result) {
  const { processor, cores, instruction_set } = result.machine ?? {};
  return [processor, cores && counted(cores, "core"), instruction_set].filter(Boolean).join(", ");
}

// What every command that measures says of itself.
function provenance(path, result, more = []) {
  return facts([["file", path], ...more, ["seed", String(result.seed ?? "")], ["versions", namedVersions(result.versions)],
    ["machine", machineOf(result)], ["compiler", result.compiler]]);
}

function pairOf({ subject, oracle }) {
  return `${subject} against ${oracle}`;
}

function different(values) {
  return new Set(values).size;
}

// Of what results count, as far as it is a number.
function summed(results, countOf) {
  return results.reduce((sum, { result }) => sum + Math.abs(Number(countOf(result)) || 0), 0);
}

function countedIf(count, ...nouns) {
  return count > 0 && counted(count, ...nouns);
}

// Pair cases and sequences.
function shownFiles() {
  return [...report.cases, ...report.sequences];
}

// What a corpus keeps and no run here counts: it was wrong once.
function recordedWrongs() {
  const met = new Set(report.fuzz.flatMap(({ result }) => (result.buckets ?? []).map(({ bucket }) => `${bucket} ${pairOf(result)}`)));
  const replayed = new Set(report.replay.map(({ result }) => pairOf(result)));
  const wrong = shownFiles().filter((one) => UNEXPLAINED.has(one.verdict) && !met.has(`${one.bucket} ${pairOf(one)}`) && !replayed.has(pairOf(one)));
  return [countedIf(different(wrong.map((one) => one.bucket || one.file)), "bucket"),
    countedIf(different(report.cases.map(({ property }) => property).filter(Boolean)), "property", "properties")]
    .filter(Boolean).map((count) => `${count} recorded as wrong`);
}

// What went wrong in the results, or keeps them from being all there is to say.
function shortfalls() {
  const runs = report.fuzz.map(({ result }) => result);
  const after = (count, text) => count && `${count} ${text}`;
  const buckets = runs.flatMap((run) => run.buckets ?? []).filter(({ verdict }) => UNEXPLAINED.has(verdict));
  const over = runs.flatMap((run) => run.ledger ?? []).filter((entry) => entry.over_budget?.length > 0);
  const mismatches = report.scene.map(({ result }) => summed((result.rows ?? []).map((row) => ({ result: row })), (row) => row.mismatches));
  return [after(countedIf(different(buckets.map(({ bucket }) => bucket)), "bucket"), "unexplained"),
    after(countedIf(summed(report.replay, ({ failures, failed }) => Math.max(failures?.length ?? 0, failed ?? 0)), "replayed case"), "failed"),
    after(countedIf(summed(report.replay, ({ left_out }) => left_out), "case"), "left out"),
    countedIf(mismatches.reduce((sum, count) => sum + count, 0), "mismatch", "mismatches"),
    countedIf(summed(report.stress, ({ worse }) => Object.keys(worse ?? {}).length), "breaking point got worse", "breaking points got worse"),
    after(countedIf(over.length, "known defect"), "over budget"),
    runs.some((run) => run.vacuous) && "a vacuous run",
    runs.some((run) => run.stopped_early) && "a run that stopped early",
    [...report.fuzz, ...report.stress].some(({ result }) => result.interrupted) && "a run that was interrupted",
    after(countedIf(report.errors.length + summed(report.replay, ({ unread }) => unread), "file"), "unread")].filter(Boolean);
}

function verdictSentence() {
  const bad = shortfalls();
  if (bad.length === 0 && report.fuzz.some(({ result }) => result.failed)) bad.push("a run that failed");
  bad.push(...recordedWrongs());
  if (bad.length > 0) return { text: bad.join(", "), css: "bad" };
  const measured = ["bench", "stress", "scene"].filter((kind) => report[kind].length > 0);
  if (report.fuzz.length + report.replay.length > 0) return { text: "Nothing unexplained", css: "good" };
  if (shownFiles().length > 0) return { text: "Nothing recorded as unexplained", css: "good" };
  return { text: measured.length > 0 ? `Measured: ${measured.join(", ")}` : "Nothing to show", css: "good" };
}

function summarySection() {
  const { text, css } = verdictSentence();
  const all = [...report.fuzz.map(({ result }) => result), ...report.cases];
  const pairs = [...new Set(all.filter(({ subject, oracle }) => subject && oracle).map(pairOf))];
  const ran = countedIf(summed(report.fuzz, ({ cases }) => cases), "case");
  document.title = `${pairs[0] ?? "manifuzz"}: ${text.toLowerCase()}`;
  return element("section", { id: "summary", "aria-label": "Summary" }, element("h1", { class: css }, text),
    element("p", { class: "headline" }, [pairs.slice(0, 3).join("; ") + (pairs.length > 3 ? ` and ${counted(pairs.length - 3, "more pair")}` : ""),
      ran && `${ran} in ${short(summed(report.fuzz, ({ seconds }) => seconds))} s`,
      shownFiles().length > 0 && `${counted(shownFiles().length, "file")} shown`].filter(Boolean).join(" \u00b7 ")),
    report.errors.length > 0 && element("div", { class: "errors", role: "alert" },
      element("strong", {}, `${counted(report.errors.length, "file or part", "files or parts")} could not be read`),
      element("ul", {}, report.errors.map((error) => element("li", {}, error)))));
}

function footer() {
  const sources = report.sources.map(({ path, kind, cases }) =>
    element("li", {}, element("code", {}, path), ` ${kind}${Number.isFinite(cases) ? `, ${counted(cases, "case")}` : ""}`));
  return [element("p", {}, `manifuzz ${report.version}`), report.command && copyLine(report.command),
    sources.length > 0 && disclosure(`Made from ${counted(sources.length, "source")}`, () => element("ul", {}, sources))].filter(Boolean);
}

function verdictBars({ cases = 0, verdicts = {} }) {
  const rows = Object.entries(verdicts).sort(([p], [q]) => VERDICTS.indexOf(q) - VERDICTS.indexOf(p))
    .map(([verdict, count]) => ({ verdict, count, share: cases > 0 ? count / cases : 0 }));
  return table("Cases by verdict", [["verdict", ({ verdict }) => namedVerdict(verdict)], ["cases", ({ count }) => whole(count), "number"],
    ["share", ({ share }) => percent(share), "number quiet"],
    ["", ({ verdict, share }) => meter(share, UNEXPLAINED.has(verdict) ? "bad" : ""), "wide"]], rows);
}

function regimesTable({ regimes = [], unexplained }) {
  const column = (name, most, css) => [name, (row) => withMeter((row[name] ?? 0) / most(row), whole(row[name] ?? 0), css), "number"];
  return table("Cases by regime", [["regime", ({ name }) => words(name)], ["cases", ({ cases }) => whole(cases), "number"],
    column("touching", ({ cases }) => cases), column("near", ({ cases }) => cases),
    column("unexplained", () => Math.max(1, unexplained ?? 0), "bad")], regimes);
}

function ledgerTable({ ledger = [] }) {
  const met = ledger.filter((entry) => entry.hits > 0 || entry.over_budget?.length > 0);
  if (met.length === 0) return null;
  const most = Math.max(...met.map(({ hits }) => hits ?? 0));
  const where = ({ regimes }) => Object.entries(regimes ?? {}).sort(([, p], [, q]) => q - p)
    .map(([name, hits]) => `${words(name)} ${whole(hits)}`).join(", ");
  const over = ({ over_budget }) => (over_budget ?? []).map((one) => (typeof one === "string" ? one : JSON.stringify(one))).join(", ");
  const columns = [["known as", ({ id }) => element("code", {}, id)],
    ["hits", ({ hits }) => withMeter((hits ?? 0) / most, whole(hits ?? 0)), "number"], ["in regimes", where, "text"]];
  if (met.some(over)) columns.push(["over budget", over, "text bad"]);
  return element("div", { class: "block" }, element("h3", {}, "Known deviations met"), table("Known deviations met", columns, met));
}

function bucketsTable({ buckets = [] }) {
  const worstFirst = (p, q) => VERDICTS.indexOf(p.verdict) - VERDICTS.indexOf(q.verdict) || (q.count ?? 0) - (p.count ?? 0);
  return buckets.length > 0 && disclosure(`${counted(buckets.length, "bucket")} met, with the command of each`, () => table("Buckets met", [
    ["bucket", ({ verdict, bucket, file }) => element("code", {}, verdictMark(verdict), fileLink(file, bucket))],
    ["count", ({ count }) => whole(count), "number"], ["magnitude", ({ magnitude }) => short(magnitude), "number"],
    ["regime", ({ regime }) => words(regime)], ["first", ({ first_index }) => whole(first_index), "number"],
    ["command", ({ command }) => command && copyButton("Copy", command)],
  ], buckets.toSorted(worstFirst)));
}

function fuzzParts(result, path) {
  const number = (key) => [key, whole(result[key])];
  const isTaken = result.cases !== result.verdicts?.unsupported;
  const state = [result.vacuous && `vacuous: ${isTaken ? "nothing touched" : "no case is supported"}`, result.interrupted && "interrupted", result.stopped_early && "stopped early"];
  return [element("h3", {}, `${result.subject ?? "subject"} against ${result.oracle ?? "oracle"}`,
    state.filter(Boolean).map((text) => element("span", { class: "state" }, text))),
  provenance(path, result, [number("cases"), ["seconds", short(result.seconds)],
    ["cases a second", whole(Math.round(result.cases_per_second ?? NaN))], ...["touching", "near", "unexplained", "jobs"].map(number)]),
  element("div", { class: "columns" }, verdictBars(result), regimesTable(result)), ledgerTable(result), bucketsTable(result)];
}

function replayParts(result, path) {
  const { cases = 0, passed = 0, failed = 0, unsupported = 0, failures = [] } = result;
  const whatPassed = unsupported > 0 ? `${whole(passed)} of ${counted(cases, "case")} passed, ${whole(unsupported)} unsupported` : `All ${counted(cases, "case")} passed`;
  const sentence = failed > 0 ? `${whole(failed)} of ${counted(cases, "case")} failed` : whatPassed;
  return [element("h3", { class: failed > 0 && "bad" }, sentence),
    provenance(path, result, [["passed", whole(passed)], ["failed", whole(failed)], ["unsupported", unsupported > 0 && whole(unsupported)],
      ["seconds", short(result.seconds)]]),
    failures.length > 0 && table("Cases that failed", [["file", ({ file }) => fileLink(file ?? "")],
      ["expected", ({ expected }) => expected, "text"], ["got", ({ got }) => got, "text"]], failures)];
}
