// Verdicts by regime, counted from the files that are shown; beside them what the runs counted. A count filters the list.

const NO_REGIME = "by hand";

function regimeOf(one) {
  return one.regime || NO_REGIME;
}

function runCounts() {
  const counts = new Map();
  for (const { result } of report.fuzz) {
    for (const { name, cases, unexplained } of result.regimes ?? []) {
      const before = counts.get(name) ?? { cases: 0, unexplained: 0 };
      counts.set(name, { cases: before.cases + (cases ?? 0), unexplained: before.unexplained + (unexplained ?? 0) });
    }
  }
  return counts;
}

function matrixCell(count, most, regime, verdict) {
  if (count === 0) return element("span", { class: "none" }, "0");
  const node = button(whole(count), () => filterBy(regime, verdict),
    { class: "cell", "aria-label": `show ${counted(count, "file")}: ${words(verdict)}, ${words(regime)}` });
  node.style.setProperty("--share", `${Math.round(10 + 50 * Math.sqrt(count / most))}%`);
  return node;
}

function verdictMatrix() {
  const verdicts = VERDICTS.filter((verdict) => report.cases.some((one) => one.verdict === verdict));
  const ran = runCounts();
  const regimes = [...new Set([...ran.keys(), ...report.cases.map(regimeOf)])];
  if (verdicts.length === 0 || regimes.length < 2) return null;
  const counts = new Map();
  for (const one of report.cases) {
    const key = `${regimeOf(one)} ${one.verdict}`;
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  const most = Math.max(...counts.values());
  const columns = [["regime", words]];
  for (const verdict of verdicts) {
    columns.push([words(verdict), (regime) => matrixCell(counts.get(`${regime} ${verdict}`) ?? 0, most, regime, verdict), "number"]);
  }
  if (ran.size > 0) {
    columns.push(["run: cases", (regime) => whole(ran.get(regime)?.cases), "number quiet"],
      ["run: unexplained", (regime) => whole(ran.get(regime)?.unexplained), "number quiet"]);
  }
  return element("div", { class: "block matrix" }, element("h3", {}, "Files by regime and verdict"),
    table("Files by regime and verdict", columns, regimes));
}
