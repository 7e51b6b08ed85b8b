/** Whether a colour is dark, by its luminance; null for one that can't be seen. @param {string} colour "rgb(r, g, b)" @returns {boolean | null} */
export function isDark(colour) {
  const [red, green, blue, alpha = 1] = (colour.match(/[\d.]+/g) ?? []).map(Number);
  if (blue === undefined || alpha === 0) return null;
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue < 128;
}

/** What the notebook says of itself: JupyterLab, VS Code, marimo. @param {HTMLElement} body @returns {boolean | null} */
function said({ dataset, classList }) {
  if (dataset.jpThemeLight) return dataset.jpThemeLight === "false";
  if (["vscode-dark", "vscode-high-contrast", "dark", "dark-theme"].some((name) => classList.contains(name)))
    return true;
  if (["vscode-light", "light", "light-theme"].some((name) => classList.contains(name))) return false;
  return null;
}

/** Follow whether the notebook is dark. @param {(dark: boolean) => void} tell @returns {() => void} what ends it */
export function darkness(tell) {
  const { body, documentElement } = document;
  const look = () =>
    tell(said(body) ?? said(documentElement) ?? isDark(getComputedStyle(body).backgroundColor) ?? false);
  const observer = new MutationObserver(look);
  for (const element of [body, documentElement])
    observer.observe(element, {
      attributes: true,
      attributeFilter: ["class", "data-jp-theme-light", "data-vscode-theme-kind", "style"],
    });
  look();
  return () => observer.disconnect();
}
