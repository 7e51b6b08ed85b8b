/**
 * Put text into the clipboard, by the way that the page has: pages that came by plain http have only the old one.
 *
 * @param {string} text
 * @param {() => void} select selects the text on the page: the old way copies what is selected, and where both ways are
 *   denied the user can copy it by hand
 * @returns {Promise<boolean>} whether it is there
 */
export async function copyText(text, select) {
  try {
    if (navigator.clipboard) {
      await navigator.clipboard.writeText(text);
      return true;
    }
  } catch {
    // denied: there is another way
  }
  select();
  try {
    return document.execCommand("copy");
  } catch {
    return false;
  }
}

/** What to do where `copyText` could not. */
export const BY_HAND = "Press Ctrl+C";
