/**
 * Drives a viewer in a frame: a question goes to it by `postMessage`, the answer comes back under the question's number.
 *
 * @param {HTMLIFrameElement} frame whose address names this page's origin: `embed/?mesh=...&origin=https://...`
 * @returns {(method: string, ...args: unknown[]) => Promise<unknown>}
 */
export function viewerIn(frame) {
  const address = new URL(frame.src);
  /** @type {Map<number, { resolve: (result: unknown) => void, reject: (error: Error) => void }>} */
  const waiting = new Map();
  let last = 0;
  addEventListener("message", ({ source, origin, data }) => {
    if (source !== frame.contentWindow || origin !== address.origin) return;
    const asked = waiting.get(data.id);
    waiting.delete(data.id);
    if ("error" in data) asked?.reject(new Error(data.error));
    else asked?.resolve(data.result);
  });
  return (method, ...args) =>
    new Promise((resolve, reject) => {
      const id = ++last;
      waiting.set(id, { resolve, reject });
      frame.contentWindow?.postMessage({ hexalab: method, version: 1, id, args }, address.origin);
    });
}
