// Light and dark: what the page says (furo, JupyterLab, VS Code), else what the reader's system prefers.

const LIGHT = { x: "#c23b00", y: "#00734f", z: "#17479e", ink: "#22262b", quiet: "#5c646d", floor: "#dfe3e7", shadow: "#e9ebee",
  ground: "#ffffff", link: "#b4bcc6", joint: "#7f8b99", other: "#916008", ghost: "#aab2bc", error: "#b3125d", trace: "#8a4fbf" };
const DARK = { x: "#ff8a57", y: "#45cf9b", z: "#86b2ff", ink: "#e8ebee", quiet: "#a5aeb8", floor: "#2c3138", shadow: "#101215",
  ground: "#181b1f", link: "#8d97a3", joint: "#66727f", other: "#e0ae55", ghost: "#6f7985", error: "#ff7eb6", trace: "#c39bff" };
const number = (hex) => [1, 3, 5].map((k) => parseInt(hex.slice(k, k + 2), 16) / 255);
const withNumbers = (colors) => ({ ...colors, rgb: Object.fromEntries(Object.entries(colors).map(([name, hex]) => [name, number(hex)])) });
export const COLORS = { light: withNumbers(LIGHT), dark: withNumbers(DARK) };

const system = matchMedia("(prefers-color-scheme: dark)");

export function theme() {
  const body = document.body?.dataset ?? {}, root = document.documentElement.dataset;
  if (body.jpThemeLight) return body.jpThemeLight === "false" ? "dark" : "light";
  const named = body.theme ?? root.theme;
  if (named === "dark" || named === "light") return named;
  if (document.body?.classList.contains("vscode-dark")) return "dark";
  if (document.body?.classList.contains("vscode-light")) return "light";
  return system.matches ? "dark" : "light";
}

// Call back whenever the theme may have changed; returns the way to stop.
export function watchTheme(changed) {
  const observer = new MutationObserver(changed);
  const what = { attributes: true, attributeFilter: ["data-theme", "data-jp-theme-light", "class"] };
  observer.observe(document.body, what);
  observer.observe(document.documentElement, what);
  system.addEventListener("change", changed);
  return () => {
    observer.disconnect();
    system.removeEventListener("change", changed);
  };
}

const calm = matchMedia("(prefers-reduced-motion: reduce)");
export const prefersStillness = () => calm.matches;
