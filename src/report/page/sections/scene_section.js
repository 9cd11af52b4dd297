// Scenes: how much faster than Box2D, and what was skipped for which reason.

const SKIP_COLORS = ["s0", "s1", "s2", "s3", "s4"];

function sceneName(row, rows) {
  const others = (key) => new Set(rows.map((other) => other[key])).size > 1;
  return [words(row.scene ?? ""), others("bodies") && whole(row.bodies), others("mode") && row.mode].filter(Boolean).join(", ");
}

// Shares of all candidates: each reason to skip, then what was computed.
function sceneShares(row) {
  const parts = [...Object.entries(row.skipped ?? {}), ["computed", row.computed ?? 0]];
  const all = parts.reduce((sum, [, count]) => sum + (count ?? 0), 0);
  return parts.map(([name, count]) => ({ name, count: count ?? 0, share: all > 0 ? (count ?? 0) / all : 0 }));
}

function shareColor(name, i) {
  return name === "computed" ? "computed" : SKIP_COLORS[i % SKIP_COLORS.length];
}

function shareBar(row) {
  const bar = element("span", { class: "stack", role: "img",
    "aria-label": sceneShares(row).map(({ name, share }) => `${words(name)} ${percent(share)}`).join(", ") });
  sceneShares(row).forEach(({ name, count, share }, i) => {
    const piece = element("i", { class: `mark-target ${shareColor(name, i)}`, "data-lines": `${words(name)}|${whole(count)} of the candidates|${percent(share)}` });
    piece.style.width = `${100 * share}%`;
    if (count > 0) bar.append(piece);
  });
  return bar;
}

// Speedups differ by factors of ten: the bars are logarithmic, from 1.
function speedBar(speed, most, kind) {
  const bar = element("span", { class: `meter ${kind}`, "aria-hidden": "true" }, element("i", {}));
  const share = speed > 1 && most > 1 ? Math.log(speed) / Math.log(most) : 0;
  bar.firstChild.style.width = `${(100 * share).toFixed(1)}%`;
  return element("span", { class: "with-meter" }, bar, element("span", {}, Number.isFinite(speed) ? `${short(speed)}\u00d7` : ""));
}

function sceneTable(rows) {
  const most = greatest(rows.flatMap((row) => [row.speedup_over_box2d, row.speedup_over_box2d_moved])) ?? 1;
  const columns = [["scene", (row) => sceneName(row, rows)],
    ["over box2d", (row) => speedBar(row.speedup_over_box2d, most, ""), "number speed"]];
  if (rows.some((row) => Number.isFinite(row.speedup_over_box2d_moved))) {
    columns.push(["over box2d on what moved", (row) => speedBar(row.speedup_over_box2d_moved, most, "second"), "number speed"]);
  }
  columns.push(["skipped and computed", shareBar, "shares"], ["ns a step", (row) => whole(Math.round(row.ns_per_step ?? NaN)), "number"],
    ["bodies", (row) => whole(row.bodies), "number"], ["moving", (row) => whole(Math.round(row.moving ?? NaN)), "number"],
    ["candidates", (row) => whole(row.candidates), "number"], ["mismatches", (row) => whole(row.mismatches), "number"],
    ["bytes", (row) => whole(row.bytes), "number"]);
  return table("Scenes", columns, rows);
}

function sceneLegend(rows) {
  const names = sceneShares(rows[0] ?? {}).map(({ name }, i) => [name, shareColor(name, i)]);
  return element("ul", { class: "legend" }, names.map(([name, color]) => element("li", {},
    element("i", { class: `swatch block-swatch ${color}`, "aria-hidden": "true" }), words(name))));
}

function sceneRun({ path, result }) {
  const rows = result.rows ?? [];
  const exponents = result.exponents ?? [];
  const drawn = element("div", {}, sceneTable(rows), sceneLegend(rows));
  explainTargets(drawn, ".mark-target", (node) => node.dataset.lines.split("|"));
  return element("article", { class: "run" },
    element("p", { class: "quiet" }, "Speedup bars are logarithmic and start at 1."), drawn,
    exponents.length > 0 ? element("div", { class: "narrow" }, table("Exponents", [["scene", ({ scene }) => words(scene ?? "")],
      ["time grows with bodies to the power", ({ exponent }) => short(exponent), "number"]], exponents)) : null,
    ...(result.recycling?.length > 0 ? recyclingFigure(result.recycling) : []), provenance(path, result));
}

function sceneSection() {
  return report.scene.length === 0 ? null : section("scenes", "Scenes", ...report.scene.map(sceneRun));
}
