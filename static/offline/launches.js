/**
 * What the operating system hands to the installed application: files that were opened with it, shortcuts.
 *
 * @typedef {object} Launch
 * @property {readonly { getFile: () => Promise<File> }[]} [files]
 * @property {string} [targetURL]
 */

/**
 * @param {(files: File[]) => unknown} open
 */
export function takeLaunches(open) {
  const { launchQueue } =
    /** @type {{ launchQueue?: { setConsumer: (take: (launch: Launch) => void) => void } }} */ (
      /** @type {unknown} */ (globalThis)
    );
  launchQueue?.setConsumer(async ({ files = [], targetURL }) => {
    if (files.length) open(await Promise.all(files.map((file) => file.getFile())));
    else if (targetURL && !isHere(targetURL)) location.assign(targetURL);
  });
}

/** Whether the window shows that page: what else its address says is the user's. @param {string} address */
function isHere(address) {
  const { origin, pathname } = new URL(address);
  return origin === location.origin && pathname === location.pathname;
}
