// Random walks of one contact: what a collider did from frame to frame that the truth does not do.

const WALK_EVENTS = [["flickers", "flickers"], ["jumps", "jumps"], ["features", "features changed"]];

// What happened with a margin is wrong; what is within bound may be.
function walkCell(counts) {
  const { with_margin: wrong, within_bound: excused } = counts ?? {};
  const text = excused > 0 ? `${whole(wrong)} (+${whole(excused)} within bound)` : whole(wrong);
  return wrong > 0 ? element("span", { class: "bad" }, text) : text;
}

function walkCount(count) {
  return count > 0 ? element("span", { class: "bad" }, whole(count)) : whole(count);
}

function walkTable(walks) {
  return table("Walks", [["walk", ({ walk }) => words(walk ?? "")], ["collider", ({ collider }) => collider ?? "", "text"],
    ["frames", ({ cases }) => whole(cases), "number"], ["touching", ({ touching }) => whole(touching), "number"],
    ...WALK_EVENTS.map(([key, title]) => [title, (row) => walkCell(row[key]), "number"]),
    ...["missed", "phantom", "lost"].map((key) => [key, (row) => walkCount(row[key]), "number"])], walks);
}
