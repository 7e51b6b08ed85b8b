import { setCacheNameDetails } from "workbox-core";
import { ExpirationPlugin } from "workbox-expiration";
import { PrecacheController } from "workbox-precaching";
import { NetworkFirst, StaleWhileRevalidate } from "workbox-strategies";
import { HELD, transact } from "./offline/database.js";
import { cacheNames } from "./offline/names.js";

/**
 * The site without a network. Viewer, interpreter, core and the catalogue's shell are kept on the first visit: scripts and the
 * interpreter carry their content's hash in their address and never change under it. Pages and lists come from the network
 * where there is one. Meshes, and what is to be kept until it is freed, are kept by the pages themselves (`offline/shelf.js`,
 * `offline/keeper.js`).
 *
 * A new version waits until the page says `{ take: true }`, or until no page is open. What the old one kept goes when
 * the last page that it served is closed: such a page may still ask for a part of it.
 *
 * The build writes `precache` before this script: the files to keep, and what each is.
 *
 * @typedef {{ url: string, revision: string | null, integrity?: string }} Kept
 */

const worker = /** @type {ServiceWorkerGlobalScope & { precache: Kept[] }} */ (
  /** @type {unknown} */ (globalThis)
);

const root = worker.registration.scope;
const names = cacheNames(root);
setCacheNameDetails({ prefix: "hexalab" });
const shell = new PrecacheController();
shell.addToCacheList(worker.precache);

/** Seconds to wait for a slow network where something is kept. */
const PATIENCE = 4;

/** Pages and pictures that are kept by themselves. */
const MOST_PAGES = 300;
const MOST_PICTURES = 600;

worker.addEventListener("install", (event) => {
  event.waitUntil(shell.install(event));
});

worker.addEventListener("activate", (event) => {
  event.waitUntil(activate(event));
});

worker.addEventListener("message", (event) => {
  if (event.data?.take) event.waitUntil(worker.skipWaiting());
});

worker.addEventListener("fetch", (event) => {
  const answer = answerTo(event);
  if (answer !== null) event.respondWith(answer);
  if (event.request.mode === "navigate") event.waitUntil(cleanUp(event));
});

/** @param {ExtendableEvent} event */
async function activate(event) {
  const open = await worker.clients.matchAll({ type: "window", includeUncontrolled: true });
  const notes = await caches.open(names.notes);
  await notes.put(`${root}old-pages`, Response.json(open.map(({ id }) => id)));
  await worker.clients.claim();
  await cleanUp(event);
}

/** Let go of what older versions kept, once no page of theirs is open. @param {ExtendableEvent} event */
async function cleanUp(event) {
  const notes = await caches.open(names.notes);
  const noted = await notes.match(`${root}old-pages`);
  if (!noted) return;
  /** @type {string[]} */
  const old = await noted.json();
  const open = await Promise.all(old.map((id) => worker.clients.get(id)));
  if (open.some(Boolean)) return;
  try {
    await renewPages();
  } catch {
    return; // no network: the kept pages still need what they were made with
  }
  await notes.delete(`${root}old-pages`);
  await shell.activate(event);
}

/** Pages that are kept ask for the scripts and styles of their version: they have to be of this one. */
async function renewPages() {
  for (const name of [names.pages, names.kept]) {
    const cache = await caches.open(name);
    for (const { url } of await cache.keys()) {
      if (!/\.(html|json)$/.test(url)) continue;
      const response = await fetch(url, { cache: "no-cache" });
      if (response.status === 200) await cache.put(url, response);
      else if (response.status === 404) await cache.delete(url);
    }
  }
}

/** A page may take the place of one with a query or without a file's name. @param {string | URL} address */
function pageOf(address) {
  const { origin, pathname } = new URL(address);
  return `${origin}${pathname.replace(/\/$/, "/index.html")}`;
}

/** @type {import("workbox-core").WorkboxPlugin} */
const asPage = { cacheKeyWillBeUsed: async ({ request }) => pageOf(request.url) };

/** What is whole may be kept. @type {import("workbox-core").WorkboxPlugin} */
const whole = { cacheWillUpdate: async ({ response }) => (response.status === 200 ? response : null) };

const pages = new NetworkFirst({
  cacheName: names.pages,
  networkTimeoutSeconds: PATIENCE,
  plugins: [asPage, whole, new ExpirationPlugin({ maxEntries: MOST_PAGES, purgeOnQuotaError: true })],
});
const lists = new NetworkFirst({
  cacheName: names.pages,
  networkTimeoutSeconds: PATIENCE,
  plugins: [whole],
});
const pictures = new StaleWhileRevalidate({
  cacheName: names.pictures,
  plugins: [whole, new ExpirationPlugin({ maxEntries: MOST_PICTURES, purgeOnQuotaError: true })],
});

/** Drawn where a picture would be that is not kept. */
const NO_PICTURE =
  '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 480"><rect width="720" height="480" fill="#8882"/></svg>';

/** @param {FetchEvent} event @returns {Promise<Response> | null} null for what the browser fetches by itself */
function answerTo(event) {
  const { request } = event;
  const { url, method, mode, destination } = request;
  if (!url.startsWith(root)) return null;
  if (method === "POST" && url === `${root}share`) return shared(request);
  if (method !== "GET") return null;
  if (mode === "navigate") return page(event);
  if (/\.json$/.test(new URL(url).pathname) && !/\/runtime-/.test(url)) return list(event);
  if (shell.getCacheKeyForURL(url)) return kept(event);
  if (destination === "image" || /\.(preview|webp)$/.test(new URL(url).pathname)) return picture(event);
  return other(request);
}

/** @param {FetchEvent} event */
async function page(event) {
  const address = pageOf(event.request.url);
  try {
    const response = await pages.handle({ event, request: event.request });
    if (response) return response;
  } catch {
    // no network, and it was not visited
  }
  return (
    (await shell.matchPrecache(address)) ??
    (await toBeKept(address)) ??
    Response.redirect(`${root}offline/missing/index.html`)
  );
}

/** @param {FetchEvent} event */
async function list(event) {
  const { request } = event;
  try {
    return await lists.handle({ event, request });
  } catch {
    return (await shell.matchPrecache(request.url)) ?? Response.error();
  }
}

/** What carries its hash, or was kept with the version of this worker; what the browser has thrown out is kept anew. @param {FetchEvent} event */
async function kept(event) {
  const { request } = event;
  const found = await shell.matchPrecache(request.url);
  if (found) return found;
  const response = await fetch(request);
  if (response.status === 200) event.waitUntil(keepAnew(request.url, response.clone()));
  return response;
}

/** @param {string} address @param {Response} response */
async function keepAnew(address, response) {
  const key = shell.getCacheKeyForURL(address);
  const cache = await caches.open(shell.strategy.cacheName);
  if (key) await cache.put(key, response).catch(() => {}); // a full storage: it came from the network all the same
}

/** @param {FetchEvent} event */
async function picture(event) {
  const { request } = event;
  try {
    return await pictures.handle({ event, request });
  } catch {
    const here = await toBeKept(request.url);
    if (here) return here;
    if (request.destination !== "image") return Response.error();
    return new Response(NO_PICTURE, { headers: { "content-type": "image/svg+xml" } });
  }
}

/** What a page shows or links: a mesh's file, a citation. @param {Request} request */
async function other(request) {
  try {
    return await fetch(request);
  } catch {
    return (
      (await toBeKept(request.url)) ??
      (await (await caches.open(names.meshes)).match(request.url)) ??
      Response.error()
    );
  }
}

/** @param {string} address @returns {Promise<Response | undefined>} */
async function toBeKept(address) {
  return (await caches.open(names.kept)).match(address);
}

/** Files, or an address, that another application shares with this one: the viewer takes them. @param {Request} request */
async function shared(request) {
  const form = await request.formData();
  const files = form.getAll("files").filter((file) => file instanceof File);
  const words = ["url", "text", "title"].map((name) => String(form.get(name) ?? ""));
  const address = words.join(" ").match(/https?:\/\/\S+/)?.[0];
  if (files.length) {
    const found = files.map((file) => ({ path: file.name, file }));
    await transact("readwrite", (store) => store.put({ files: found }, HELD));
    return Response.redirect(`${root}viewer/index.html?held`, 303);
  }
  const query = address ? `?mesh=${encodeURIComponent(address)}` : "";
  return Response.redirect(`${root}viewer/index.html${query}`, 303);
}
