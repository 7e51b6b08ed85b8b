import { free, freeEverything, inventory } from "../offline/inventory.js";
import { fetchSources } from "../offline/parcel.js";
import { Registration } from "../offline/registration.js";
import { Shelf } from "../offline/shelf.js";
import { fileSize } from "../offline/sizes.js";
import { askLasting, isLasting, quota } from "../offline/storage.js";

/**
 * The page that shows what this browser keeps, and frees it.
 *
 * @typedef {{ name: string, page: string }} Known  of a mesh of the catalogue
 */

const root = new URL(document.body.dataset.root || "./", location.href);
const shelf = new Shelf(root);
const registration = new Registration(root);
/** @type {Map<string, Known> | null} */
let catalogue = null;

/** @template {HTMLElement} E @param {string} id @param {new () => E} type @returns {E} */
function part(id, type) {
  const element = document.getElementById(id);
  if (!(element instanceof type)) throw new Error(`the page has no ${id}`);
  return element;
}

const body = part("offline", HTMLElement);
const state = part("offline-state", HTMLElement);
const total = part("offline-total", HTMLElement);
const lasting = part("offline-lasting", HTMLElement);
const ask = part("offline-ask", HTMLButtonElement);
const lots = part("offline-lots", HTMLTableSectionElement);
const meshes = part("offline-meshes", HTMLTableSectionElement);
const none = part("offline-none", HTMLElement);
const limit = part("offline-limit", HTMLInputElement);
const everything = part("offline-everything", HTMLButtonElement);

ask.addEventListener("click", async () => {
  const agreed = await askLasting();
  await show();
  if (!agreed) lasting.textContent += " It was asked, and did not agree.";
});
limit.addEventListener("change", async () => {
  const megabytes = Number(limit.value);
  if (limit.value !== "" && megabytes >= 0) await shelf.setLimit(megabytes * 1e6);
  await show();
});
everything.addEventListener("click", async () => {
  const meant = everything.textContent?.startsWith("Really");
  everything.textContent = meant ? "Free everything" : "Really free everything, meshes too?";
  if (!meant) return;
  await freeEverything(root);
  await show();
});
everything.addEventListener("blur", () => (everything.textContent = "Free everything"));
registration.addEventListener("failed", show);
void show();
void registration.start().then((lack) => (lack ? show() : navigator.serviceWorker.ready.then(show)));

async function show() {
  const { lack } = registration;
  if (lack || !shelf.works) {
    state.textContent = `Nothing is kept: ${lack || "this browser keeps nothing here"}.`;
    body.classList.add("keeps-nothing");
    body.setAttribute("aria-busy", "false");
    return;
  }
  const [found, rows] = await Promise.all([inventory(root), shelf.list()]);
  const kept = found.some(({ id }) => id === "program") && navigator.serviceWorker.controller !== null;
  state.textContent = kept
    ? "Catalogue and viewer are kept in this browser: they work without a network."
    : "Catalogue and viewer are not kept yet: that happens while you look at a page, and takes a moment.";
  state.className = kept ? "mark mark-valid" : "mark mark-unknown";
  const bytes = [...found, ...rows].reduce((sum, one) => sum + ("bytes" in one ? one.bytes : one.size), 0);
  const most = await quota();
  total.textContent = `${fileSize(bytes)} are kept${most ? ` of at most ${fileSize(most)} that the browser grants` : ""}.`;
  const stays = await isLasting();
  lasting.textContent = stays
    ? "The browser has agreed to throw nothing away."
    : "The browser may throw all of it away when the disk gets full.";
  ask.hidden = stays;
  limit.value = String(Math.round(shelf.limit / 1e5) / 10);
  lots.replaceChildren(...found.map(lotRow));
  /** @type {HTMLElement} */ (lots.parentElement).hidden = !found.length;
  if (rows.length) catalogue ??= await knownMeshes();
  meshes.replaceChildren(...rows.map(meshRow));
  none.hidden = rows.length > 0;
  /** @type {HTMLElement} */ (meshes.parentElement).hidden = !rows.length;
  everything.disabled = !found.length && !rows.length;
  body.setAttribute("aria-busy", "false");
}

/** @param {import("../offline/inventory.js").Lot} lot */
function lotRow({ id, name, bytes, count }) {
  return row(
    [heading(name), number(count.toLocaleString("en-GB")), number(fileSize(bytes))],
    `Free: ${name}`,
    () => free(root, id),
  );
}

/** @param {import("../offline/shelf.js").Row} mesh */
function meshRow({ address, name, size, date, kept }) {
  const known = catalogue?.get(address);
  const first = heading(known ? "" : name);
  if (known) first.append(link(known.name, known.page));
  const viewer = new URL("viewer/index.html", root);
  viewer.searchParams.set("mesh", known ? known.page.split("/").slice(1, 3).join("/") : address);
  return row(
    [
      first,
      cell(address.startsWith(root.href) ? "this site" : new URL(address).host),
      number(fileSize(size)),
      cell(date.toLocaleDateString("en-GB", { dateStyle: "medium" })),
      cell(kept ? "until you free it" : "opened"),
      wrapped(link("Open", viewer.href)),
    ],
    `Free: ${known?.name ?? name}`,
    () => shelf.remove(address),
  );
}

/** @param {readonly HTMLElement[]} cells @param {string} label @param {() => Promise<unknown>} press */
function row(cells, label, press) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = "plain";
  button.textContent = "Free";
  button.setAttribute("aria-label", label);
  button.addEventListener("click", async () => {
    button.disabled = true;
    await press();
    await show();
  });
  const element = document.createElement("tr");
  element.append(...cells, wrapped(button));
  return element;
}

/** @param {string} text */
function heading(text) {
  const element = document.createElement("th");
  element.scope = "row";
  element.textContent = text;
  return element;
}

/** @param {string} text */
function cell(text) {
  const element = document.createElement("td");
  element.textContent = text;
  return element;
}

/** @param {string} text */
function number(text) {
  const element = cell(text);
  element.className = "number";
  return element;
}

/** @param {Node} content */
function wrapped(content) {
  const element = cell("");
  element.append(content);
  return element;
}

/** @param {string} text @param {string} address below the root, or whole */
function link(text, address) {
  const element = document.createElement("a");
  element.textContent = text;
  element.href = new URL(address, root).href;
  return element;
}

/** Meshes of the catalogue by their files' addresses. @returns {Promise<Map<string, Known>>} */
async function knownMeshes() {
  try {
    const sources = await fetchSources(root);
    const rows = sources.flatMap((source) =>
      source.meshes.map(
        ({ slug, name, url }) =>
          /** @type {[string, Known]} */ ([
            new URL(url, root).href,
            { name, page: `sources/${source.slug}/${slug}/index.html` },
          ]),
      ),
    );
    return new Map(rows);
  } catch {
    return new Map(); // names of files have to do
  }
}
