// Copying text, also where the browser keeps the clipboard from a page that came from a file.

// Selects the text in a field beside `neighbour`: within a dialog nothing outside it can be selected.
function copyBySelecting(text, neighbour) {
  const field = element("textarea", { class: "unseen", readonly: true, "aria-hidden": "true" });
  field.value = text;
  neighbour.after(field);
  field.select();
  const isCopied = document.execCommand("copy");
  field.remove();
  neighbour.focus();
  return isCopied;
}

async function copyText(text, neighbour) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return copyBySelecting(text, neighbour);
  }
}

// A button that copies; says so for a moment.
function copyButton(label, text) {
  const node = button(label, async () => {
    const isCopied = await copyText(text, node);
    node.textContent = isCopied ? "Copied" : "Not copied";
    node.classList.toggle("done", isCopied);
    announce(isCopied ? "Copied to the clipboard" : "The browser does not let this page copy");
    setTimeout(() => {
      node.textContent = label;
      node.classList.remove("done");
    }, 1200);
  }, { class: "copy", "aria-label": `${label}: ${text.slice(0, 80)}` });
  return node;
}

function copyLine(text) {
  return element("div", { class: "copy-line" }, element("code", {}, text), copyButton("Copy", text));
}
