// Campaigns: cases by verdict and by regime, and what the ledger explains.

function verdictMark(verdict) {
  const kind = UNEXPLAINED.has(verdict) ? "bad" : verdict;
  return element("span", { class: `dot ${kind}`, "aria-hidden": "true" });
}

function meter(value, most, kind = "") {
  const share = most > 0 && value > 0 ? value / most : 0;
  const bar = element("span", { class: `meter ${kind}`, "aria-hidden": "true" }, element("i", {}));
  bar.firstChild.style.width = share > 0 ? `max(2px, ${(100 * share).toFixed(2)}%)` : "0";
  return bar;
}

function verdictBars(result) {
  const all = result.cases ?? 0;
  const rows = Object.entries(result.verdicts ?? {});
  rows.sort(([p], [q]) => VERDICTS.indexOf(q) - VERDICTS.indexOf(p));
  return table("Cases by verdict", [
    ["verdict", ([verdict]) => element("span", { class: "verdict-name" }, verdictMark(verdict), words(verdict))],
    ["cases", ([, count]) => whole(count), "number"],
    ["share", ([, count]) => percent(all > 0 ? count / all : 0), "number quiet"],
    ["", ([verdict, count]) => meter(count, all, UNEXPLAINED.has(verdict) ? "bad" : ""), "wide"],
  ], rows);
}

function countWithMeter(count, most, kind) {
  return element("span", { class: "with-meter" }, meter(count, most, kind), element("span", {}, whole(count)));
}

function regimesTable(result) {
  const regimes = result.regimes ?? [];
  const column = (name, kind) => [name,
    (regime) => countWithMeter(regime[name] ?? 0, kind ? Math.max(1, result.unexplained ?? 0) : regime.cases, kind), "number"];
  return table("Cases by regime", [["regime", ({ name }) => words(name)], ["cases", ({ cases }) => whole(cases), "number"],
    column("touching"), column("near"), column("unexplained", "bad")], regimes);
}

function ledgerTable(result) {
  const entries = result.ledger ?? [];
  if (entries.length === 0) return null;
  const most = Math.max(...entries.map(({ hits }) => hits ?? 0));
  const where = (entry) => Object.entries(entry.regimes ?? {}).sort(([, p], [, q]) => q - p)
    .map(([name, hits]) => `${words(name)} ${whole(hits)}`).join(", ");
  const over = (entry) => (entry.over_budget ?? []).map((one) => (typeof one === "string" ? one : JSON.stringify(one))).join(", ");
  const columns = [["known as", ({ id }) => element("code", {}, id ?? "")],
    ["hits", ({ hits }) => countWithMeter(hits ?? 0, most), "number"], ["in regimes", where, "text"]];
  if (entries.some((entry) => over(entry) !== "")) columns.push(["over budget", over, "text bad"]);
  return element("div", { class: "block" }, element("h3", {}, "Known deviations met"), table("Known deviations met", columns, entries));
}

function bucketLink(bucket) {
  const one = report.caseOf.get(bucket.file);
  return one ? element("a", { href: caseHash(one) }, bucket.bucket) : element("span", {}, bucket.bucket);
}

function bucketsTable(result) {
  const buckets = result.buckets ?? [];
  if (buckets.length === 0) return null;
  const worstFirst = (p, q) => VERDICTS.indexOf(p.verdict) - VERDICTS.indexOf(q.verdict) || (q.count ?? 0) - (p.count ?? 0);
  return disclosure(`${counted(buckets.length, "bucket")} met, with the command of each`, () => table("Buckets met", [
    ["bucket", (bucket) => element("code", {}, verdictMark(bucket.verdict), bucketLink(bucket))],
    ["count", ({ count }) => whole(count), "number"], ["magnitude", ({ magnitude }) => short(magnitude), "number"],
    ["regime", ({ regime }) => words(regime ?? "")], ["first", ({ first_index }) => whole(first_index), "number"],
    ["command", ({ command }) => (command ? copyButton("Copy", command) : "")],
  ], [...buckets].sort(worstFirst)));
}

function runFacts(path, result) {
  return provenance(path, result, [["cases", whole(result.cases)], ["seconds", short(result.seconds)],
    ["cases a second", whole(Math.round(result.cases_per_second ?? NaN))], ["touching", whole(result.touching)],
    ["near", whole(result.near)], ["unexplained", whole(result.unexplained)], ["jobs", whole(result.jobs)]]);
}

function fuzzRun({ path, result }) {
  const state = [result.vacuous && "vacuous: nothing touched", result.interrupted && "interrupted", result.stopped_early && "stopped early"];
  return element("article", { class: "run" },
    element("h3", {}, `${result.subject ?? "subject"} against ${result.oracle ?? "oracle"}`,
      state.filter(Boolean).map((text) => element("span", { class: "state" }, text))),
    runFacts(path, result),
    element("div", { class: "columns" }, verdictBars(result), regimesTable(result)),
    ledgerTable(result), bucketsTable(result));
}

function fuzzSection() {
  return report.fuzz.length === 0 ? null : section("campaigns", "Campaigns", ...report.fuzz.map(fuzzRun));
}
