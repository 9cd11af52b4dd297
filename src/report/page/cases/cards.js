// One card a bucket: its smallest and its worst witness side by side, and every further file by name.

function caseHash(one) {
  return `#case=${encodeURIComponent(one.id)}`;
}

function witness(one, title) {
  const sentence = one.sentence || one.note || one.file;
  return element("a", { class: "witness", href: caseHash(one), "data-case": one.id, "aria-label": `${title}: ${sentence}` },
    thumbnail(one),
    element("span", { class: "witness-line" }, element("b", {}, title), element("span", {}, `${one.vertices} vertices`),
      Number.isFinite(one.magnitude) ? element("span", {}, `magnitude ${short(one.magnitude)}`) : null));
}

// The two to draw: a smallest one with its worst where that is shown, else the first two.
function witnessesOf(cases) {
  const worst = cases.find((one) => one.role === "worst" && cases.some((other) => other.file === one.smallest));
  if (worst) return [cases.find((one) => one.file === worst.smallest), worst];
  return cases.slice(0, 2);
}

function witnessTitle(one) {
  if (one.role === "worst") return "Worst";
  return one.bucket ? "Smallest" : "Case";
}

function fileList(cases) {
  return element("ul", { class: "files" }, cases.map((one) => element("li", {},
    element("a", { href: caseHash(one), "data-case": one.id }, one.file),
    element("span", {}, [`${one.vertices} vertices`, Number.isFinite(one.magnitude) ? `magnitude ${short(one.magnitude)}` : "",
      one.property && `property ${one.property}`].filter(Boolean).join(", ")))));
}

function figures(cases) {
  const count = greatest(cases.map((one) => one.count));
  const magnitude = greatest(cases.map((one) => one.magnitude));
  const severity = greatest(cases.map((one) => one.severity));
  return facts([["met", whole(count)], ["magnitude", Number.isFinite(magnitude) ? short(magnitude) : ""],
    ["severity", Number.isFinite(severity) ? short(severity) : ""], ["files", whole(cases.length)]]);
}

function cardTitle(one) {
  if (one.bucket) return bucketWords(one.bucket);
  return folderOf(one.file) || baseName(one.file);
}

function card({ cases }) {
  const [first] = cases;
  const drawn = witnessesOf(cases);
  const rest = cases.filter((one) => !drawn.includes(one));
  const pair = [first.subject, first.oracle].filter(Boolean).join(" against ");
  return element("article", { class: "card" },
    element("header", {},
      element("span", { class: "verdict-name" }, verdictMark(first.verdict), first.verdict ? words(first.verdict) : "no verdict"),
      element("span", { class: "pair" }, pair)),
    element("h3", {}, cardTitle(first)),
    first.sentence ? element("p", { class: "sentence" }, first.sentence) : null,
    element("div", { class: "witnesses" }, drawn.map((one) => witness(one, witnessTitle(one)))),
    figures(cases),
    rest.length > 0 ? disclosure(counted(rest.length, "further file"), () => fileList(rest)) : null);
}
