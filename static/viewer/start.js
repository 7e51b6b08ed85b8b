import { frame } from "./hosts/frame.js";
import { server } from "./hosts/server.js";
import { site } from "./hosts/site.js";

/**
 * What is begun before the page is built, by a script of its own: the core starts and the preview comes while the larger
 * script is still on its way, and keeps the page busy.
 */

/** Who may show the viewer, by the word that its page has for it. @type {Record<string, () => import("./hosts/host.js").Host>} */
const HOSTS = { site, server, frame };

export const host = HOSTS[document.documentElement.dataset.host ?? "site"]();
