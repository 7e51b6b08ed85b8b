/** Addresses that a page can read, and what is to be said of others. */
const REFUSALS = /** @type {Record<string, string>} */ ({
  "file:": "a web page can't read files of the disk by their address: drop the file here",
  "http:":
    "only https addresses, and those of this site and this machine, can be read: use https, or download the file and drop it here",
});

/** Hosts that a page may read from without https. */
const THIS_MACHINE = ["localhost", "127.0.0.1"];

/**
 * The address of a mesh, as a link or a script gives it.
 *
 * @param {string} text an address, whole or relative to `base`
 * @param {string} base the page's own
 * @returns {string} the whole address
 * @throws {Error} it is none, or none that a page can read: why, in words
 */
export function meshAddress(text, base) {
  let address;
  try {
    address = new URL(text, base);
  } catch (cause) {
    throw new Error(`‘${shortened(text)}’ is no address of a mesh`, { cause });
  }
  const { protocol, hostname, origin } = address;
  const near = origin === new URL(base).origin || THIS_MACHINE.includes(hostname);
  if (protocol === "https:" || protocol === "blob:" || (protocol === "http:" && near)) return address.href;
  const reason = REFUSALS[protocol] ?? `addresses that begin with ${protocol} can't be read, expected https`;
  throw new Error(`‘${shortened(text)}’ was not opened: ${reason}`);
}

/** The name of the file that an address leads to. @param {string} address */
export function nameIn(address) {
  const last = new URL(address).pathname.split("/").pop() || "mesh";
  try {
    return decodeURIComponent(last);
  } catch {
    return last; // a % that is no escape stands for itself
  }
}

/** @param {string} text */
function shortened(text) {
  return text.length > 80 ? `${text.slice(0, 79)}…` : text;
}
