/**
 * Who shows the viewer: the static site, a server on the user's machine, a notebook. What differs between them is said here
 * once; the rest of the viewer asks for it by name.
 *
 * @typedef {object} Host
 * @property {string} root address of the site with the catalogue, "" where there is none
 * @property {boolean} keeps whether the browser may keep files, and the page itself, for later visits
 * @property {boolean} shares whether the page's address opens the same for others
 * @property {boolean} steps whether opened meshes are steps of the browser's history
 * @property {boolean} embedded whether the picture alone is shown, in a frame of another page
 * @property {string} addressed the mesh that the page's address names: "source/mesh", an address, or nothing
 * @property {string | null} beside the mesh that the page's address names to be compared with it, or nothing; null where one is to be chosen
 * @property {import("../core/client.js").CoreClient} client
 * @property {(() => import("../core/client.js").CoreClient) | null} another starts a second core, for a second mesh
 * @property {Ahead} ahead
 * @property {() => Promise<string>} sheet the frame of a page of one file
 * @property {import("./offers.js").Offers | null} offers meshes that the core has at hand
 * @property {number} [directions] from which light is gathered, where the page's address asks for fewer than all
 * @property {import("../core/kernel_transport.js").Port} [port] to a notebook's kernel, with which settings are shared
 */

/**
 * What comes before the core does.
 *
 * @typedef {Pick<import("../catalogue/ahead.js").Ahead, "shown" | "tellShown" | "bytes">
 *   & { catalogue: Promise<import("../catalogue/catalogue.js").Catalogue | null> }} Ahead
 */

/** The frame of a page of one file, which lies beside the viewer's page. @returns {Promise<string>} */
export async function fetchedSheet() {
  const answer = await fetch(new URL("sheet.txt", document.baseURI));
  if (!answer.ok)
    throw new Error(`the page's frame could not be fetched: ${answer.status} ${answer.statusText}`);
  return answer.text();
}

/** What comes ahead of the core where there is no catalogue: nothing. @returns {Ahead} */
export function nothingAhead() {
  return {
    catalogue: Promise.resolve(null),
    shown: Promise.resolve(),
    tellShown: () => {},
    bytes: (address) => Promise.reject(new Error(`there is nothing at ${address}`)),
  };
}
