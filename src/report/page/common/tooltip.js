// One tooltip for pictures and plots. It lies in the dialog that is open: what is outside is covered.

// The first line of each block is its title. `box` is what they explain, in the window's coordinates.
function showTooltip(blocks, box, host) {
  const tip = byId("tooltip");
  host.append(tip);
  tip.replaceChildren(...blocks.flatMap((lines) =>
    lines.filter(Boolean).map((line, i) => element(i === 0 ? "strong" : "span", {}, line))));
  tip.hidden = false;
  const { width, height } = tip.getBoundingClientRect();
  const room = { right: document.documentElement.clientWidth, bottom: window.innerHeight };
  const left = Math.min(Math.max(4, (box.left + box.right) / 2 - width / 2), Math.max(4, room.right - width - 4));
  const above = box.top - height - 10;
  tip.style.left = `${left}px`;
  tip.style.top = `${above >= 4 ? above : Math.min(box.bottom + 10, room.bottom - height - 4)}px`;
}

// Back to the page: the dialog's contents are replaced.
function hideTooltip() {
  const tip = byId("tooltip");
  if (tip.hidden) return;
  tip.hidden = true;
  document.body.append(tip);
}

// Under the pointer, everything of the same layer; else the target alone.
function coincident(target, event, selector) {
  if (!(event instanceof PointerEvent)) return [target];
  const here = document.elementsFromPoint(event.clientX, event.clientY).filter((node) => node.matches(selector));
  return here.includes(target) ? here.filter((node) => node.parentNode === target.parentNode) : [target];
}

// Shows `describe(target)` for what lies under the pointer or has the focus, of what `selector` finds.
function explainTargets(root, selector, describe, host = document.body) {
  const explain = (event) => {
    const target = event.target.closest?.(selector);
    if (!target) return hideTooltip();
    return showTooltip(coincident(target, event, selector).map(describe), target.getBoundingClientRect(), host);
  };
  root.addEventListener("pointerover", explain);
  root.addEventListener("pointerdown", explain);
  root.addEventListener("focusin", explain);
  // A finger leaves as soon as it is lifted: what it pointed at stays explained.
  root.addEventListener("pointerleave", (event) => event.pointerType === "touch" || hideTooltip());
  root.addEventListener("focusout", hideTooltip);
}
