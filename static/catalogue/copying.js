/**
 * Buttons that copy the text of the element they name in `data-copy`.
 *
 * @param {Document} page
 */
export function enableCopying(page) {
  page.addEventListener("click", async (event) => {
    const button = event.target instanceof Element ? event.target.closest("button[data-copy]") : null;
    if (!(button instanceof HTMLButtonElement)) return;
    const text = page.getElementById(button.dataset.copy ?? "");
    if (!text) return;
    const done = await copy(text);
    const label = button.textContent;
    button.textContent = done ? "Copied" : "Press Ctrl+C";
    setTimeout(() => (button.textContent = label), 1600);
  });
}

/**
 * @param {HTMLElement} element
 * @returns {Promise<boolean>} false if the clipboard is barred: then the text is selected, to be copied by hand
 */
async function copy(element) {
  try {
    await navigator.clipboard.writeText((element.textContent ?? "").trim());
    return true;
  } catch {
    getSelection()?.selectAllChildren(element);
    return false;
  }
}
