// Sequences: each with its verdict and its filmstrip, the unexplained first.

// As a picture of its own, so that nothing in it is read as a part of this page.
function filmstrip({ svg, sentence }) {
  if (!svg) return element("p", { class: "quiet" }, "Its collider is not there to be asked; the file tells the verdict alone.");
  return element("img", { class: "filmstrip", alt: sentence, src: `data:image/svg+xml,${encodeURIComponent(svg)}` });
}

function sequenceParts(one) {
  return element("article", { class: "run" },
    element("h3", {}, namedVerdict(one.verdict), `: ${bucketWords(one.bucket)}`),
    facts([["file", one.file], ["subject", one.subject], ["motion", words(one.regime)], ["frames", whole(one.frames)],
      ["met", Number.isFinite(one.count) && counted(one.count, "time")], ["note", one.note]]),
    element("div", { class: "scroll" }, filmstrip(one)), one.commands.map(copyLine));
}

function sequencesParts() {
  const rank = ({ verdict }) => VERDICTS.indexOf(verdict);
  return report.sequences.toSorted((p, q) => rank(p) - rank(q) || (q.count ?? 0) - (p.count ?? 0)).map(sequenceParts);
}
