// Light or dark: as the system says, until the button says otherwise. What it said is kept, where the browser keeps anything.

const systemIsDark = matchMedia("(prefers-color-scheme: dark)");

function keptTheme() {
  try {
    return localStorage.getItem("manifuzz-theme");
  } catch {
    return null;
  }
}

function keepTheme(theme) {
  try {
    localStorage.setItem("manifuzz-theme", theme);
  } catch {
    // The page from a file may have no storage: the choice lasts as long as the page.
  }
}

function currentTheme() {
  return document.documentElement.dataset.theme ?? (systemIsDark.matches ? "dark" : "light");
}

function nameThemeButton() {
  const next = currentTheme() === "dark" ? "light" : "dark";
  byId("theme").textContent = next === "dark" ? "Dark" : "Light";
  byId("theme").setAttribute("aria-label", `Switch to the ${next} colours`);
}

function startTheme() {
  const kept = keptTheme();
  if (kept === "dark" || kept === "light") document.documentElement.dataset.theme = kept;
  byId("theme").addEventListener("click", () => {
    const next = currentTheme() === "dark" ? "light" : "dark";
    document.documentElement.dataset.theme = next;
    keepTheme(next);
    nameThemeButton();
  });
  systemIsDark.addEventListener("change", nameThemeButton);
  nameThemeButton();
}
