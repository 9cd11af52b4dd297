// Small pictures of cases, drawn while they are near the window and taken away when they are far: a page of a thousand
// cases holds a few dozen.

const THUMBNAIL = { width: 264, height: 168 };

let isPrinting = false;

function drawThumbnail(holder) {
  if (holder.querySelector("svg")) return;
  const one = report.caseOf.get(holder.dataset.case);
  if (!one.isDrawable) {
    holder.replaceChildren(element("span", { class: "no-picture" }, "not drawable: a coordinate is not finite"));
    return;
  }
  const { width, height } = THUMBNAIL;
  const svg = svgElement("svg", { viewBox: `0 0 ${width} ${height}`, class: "picture thumbnail", "aria-hidden": "true" });
  drawCase({ painter: makePainter(svg, CASE_LAYERS), camera: wholeCamera(one, width, height, 18), one,
    show: SHOW_ALL, right: 0, isThumbnail: true });
  holder.replaceChildren(svg);
}

const nearWindow = new IntersectionObserver((entries) => {
  for (const entry of entries) {
    if (entry.isIntersecting || isPrinting) drawThumbnail(entry.target);
    else entry.target.replaceChildren();
  }
}, { rootMargin: "400px 0px" });

function thumbnail(one) {
  const holder = element("span", { class: "thumbnail-holder", "data-case": one.id });
  nearWindow.observe(holder);
  return holder;
}

// On paper everything is drawn.
function drawAllThumbnails() {
  for (const holder of document.querySelectorAll(".thumbnail-holder")) drawThumbnail(holder);
}
