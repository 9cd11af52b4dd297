// Corpus cases that were run again: passed, failed, and what each failure was.

function replayFailures(failures) {
  const file = (failure) => {
    const one = report.caseOf.get(failure.file);
    return one ? element("a", { href: caseHash(one) }, failure.file) : element("code", {}, failure.file ?? "");
  };
  return table("Cases that failed", [["file", file], ["expected", ({ expected }) => expected ?? "", "text"],
    ["got", ({ got }) => got ?? "", "text"]], failures);
}

function replayRun({ path, result }) {
  const { cases = 0, passed = 0, failed = 0, failures = [] } = result;
  const sentence = failed > 0 ? `${whole(failed)} of ${counted(cases, "case")} failed` : `All ${counted(cases, "case")} passed`;
  return element("article", { class: "run" },
    element("h3", { class: failed > 0 ? "bad" : "" }, sentence),
    provenance(path, result, [["passed", whole(passed)], ["failed", whole(failed)], ["seconds", short(result.seconds)]]),
    failures.length > 0 ? replayFailures(failures) : null);
}

function replaySection() {
  return report.replay.length === 0 ? null : section("replay", "Replay", ...report.replay.map(replayRun));
}
