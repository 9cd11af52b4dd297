// One tooltip for pictures and plots. It lies in the dialog that is open: what is outside is covered.

// The first line is the title. `box` is what it explains, in the window's coordinates.
function showTooltip(lines, box, host) {
  const tip = byId("tooltip");
  host.append(tip);
  tip.replaceChildren(...lines.filter(Boolean).map((line, i) => element(i === 0 ? "strong" : "span", {}, line)));
  tip.hidden = false;
  const { width, height } = tip.getBoundingClientRect();
  const room = { right: document.documentElement.clientWidth, bottom: window.innerHeight };
  const left = Math.min(Math.max(4, (box.left + box.right) / 2 - width / 2), Math.max(4, room.right - width - 4));
  const above = box.top - height - 10;
  tip.style.left = `${left}px`;
  tip.style.top = `${above >= 4 ? above : Math.min(box.bottom + 10, room.bottom - height - 4)}px`;
}

function hideTooltip() {
  byId("tooltip").hidden = true;
}

// Shows `describe(target)` for what lies under the pointer or has the focus, of what `selector` finds.
function explainTargets(root, selector, describe, host = document.body) {
  const explain = (event) => {
    const target = event.target.closest?.(selector);
    if (!target) return hideTooltip();
    return showTooltip(describe(target), target.getBoundingClientRect(), host);
  };
  root.addEventListener("pointerover", explain);
  root.addEventListener("pointerdown", explain);
  root.addEventListener("focusin", explain);
  root.addEventListener("pointerleave", hideTooltip);
  root.addEventListener("focusout", hideTooltip);
}
