// Puts the page together, from what the report holds.

// On paper: the whole list, with every picture.
function preparePrint() {
  if (report.cases.length === 0) return;
  isPrinting = true;
  growWhole();
  drawAllThumbnails();
}

function startPrinting() {
  const paper = matchMedia("print");
  paper.addEventListener("change", () => (paper.matches ? preparePrint() : endPrint()));
  addEventListener("beforeprint", preparePrint);
  addEventListener("afterprint", endPrint);
}

function endPrint() {
  isPrinting = false;
}

function start() {
  const sections = [summarySection(), fuzzSection(), replaySection(), casesSection(), benchSection(), stressSection(), sceneSection()];
  byId("main").replaceChildren(...sections.filter(Boolean));
  byId("footer").append(...footer().filter(Boolean));
  startTheme();
  if (report.cases.length > 0) refreshList();
  startHelp();
  startViewer();
  startPrinting();
}

start();
