import { find, readIndex } from "./index.js";
import { cards, table } from "./results.js";

/** @typedef {import("./index.js").Index} Index */
/** @typedef {import("./index.js").Query} Query */

const PAGE = 48;

/**
 * The search of the front page. What is asked stands in the address's hash, so that it can be linked and gone back to;
 * until something is asked, the page shows what it came with.
 *
 * @param {HTMLFormElement} form
 */
export function startSearch(form) {
  const root = document.body.dataset.root ?? "";
  const results = required("results");
  const found = required("found");
  const more = required("more");
  const models = required("models");
  const clear = /** @type {HTMLElement} */ (form.querySelector("[type=reset]"));
  /** @type {Promise<Index> | undefined} */
  let loading;
  let shown = PAGE;

  async function load() {
    const answer = await fetch(root + (form.dataset.index ?? ""));
    if (!answer.ok) throw new Error(`the index could not be read (${answer.status})`);
    return readIndex(await answer.json());
  }

  /** @returns {Promise<Index | undefined>} */
  async function loaded() {
    loading ??= load();
    try {
      return await loading;
    } catch (error) {
      loading = undefined;
      found.textContent = `Search doesn't work now: ${error instanceof Error ? error.message : error}`;
      return undefined;
    }
  }

  /** The titles of bodies, once somebody is about to type one. */
  async function offer() {
    const index = await loaded();
    if (index && !models.hasChildNodes())
      models.append(...index.models.map((title) => new Option(title, title)));
  }

  async function show() {
    const index = await loaded();
    if (!index) return;
    const query = readForm(form);
    const { rows, counts, forgiven } = find(index, query);
    const draw = form.view.value === "table" ? table : cards;
    results.replaceChildren(draw(rows.slice(0, shown), root));
    found.textContent = inWords(rows.length, forgiven ? query.words.trim() : "");
    more.hidden = rows.length <= shown;
    clear.hidden = addressOf(form) === "";
    showCounts(form, index, counts);
  }

  function asked() {
    shown = PAGE;
    history.replaceState(null, "", `#${addressOf(form)}`);
    void show();
  }

  form.model.addEventListener("focus", offer, { once: true });
  form.addEventListener("input", asked);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    asked();
  });
  form.addEventListener("reset", () => setTimeout(asked));
  more.addEventListener("click", () => {
    shown += PAGE;
    void show();
  });
  addEventListener("hashchange", () => {
    fillForm(form, location.hash.slice(1));
    void show();
  });
  fillForm(form, location.hash.slice(1));
  toggleFilters(form);
  if (location.hash.length > 1) void show();
}

/** @param {number} rows @param {string} like what was typed, where a letter of it was forgiven */
function inWords(rows, like) {
  if (!rows)
    return "Nothing is found. Try fewer words, a part of the name or an author, or take a filter off: “Clear” shows all meshes.";
  const meshes = rows === 1 ? "1 mesh" : `${rows.toLocaleString("en-GB")} meshes`;
  return like ? `${meshes}, of names like “${like}”` : meshes;
}

/**
 * The filters are folded; this button opens them. They are open where one is chosen already.
 *
 * @param {HTMLFormElement} form
 */
function toggleFilters(form) {
  const button = form.querySelector(".filters-toggle");
  button?.setAttribute("aria-expanded", String(form.querySelector(".chip input:checked") !== null));
  button?.addEventListener("click", () => {
    const open = button.getAttribute("aria-expanded") !== "true";
    button.setAttribute("aria-expanded", String(open));
  });
}

/**
 * @param {HTMLFormElement} form
 * @returns {Query}
 */
function readForm(form) {
  /** @type {Record<string, string[]>} */
  const chosen = {};
  for (const chip of form.querySelectorAll(".chip input")) {
    if (chip instanceof HTMLInputElement && chip.checked) (chosen[chip.name] ??= []).push(chip.value);
  }
  return {
    words: form.q.value,
    source: form.source.value,
    model: form.model.value,
    sort: form.sort.value,
    chosen,
  };
}

/**
 * What is asked, as the address says it; "" if nothing is.
 *
 * @param {HTMLFormElement} form
 */
function addressOf(form) {
  const asked = new URLSearchParams();
  for (const [name, value] of new FormData(form)) {
    if (value && !(name === "view" && value === "cards")) asked.append(name, String(value));
  }
  return asked.toString();
}

/**
 * @param {HTMLFormElement} form
 * @param {string} address
 */
function fillForm(form, address) {
  const asked = new URLSearchParams(address);
  form.q.value = asked.get("q") ?? "";
  form.source.value = asked.get("source") ?? "";
  form.model.value = asked.get("model") ?? "";
  form.sort.value = asked.get("sort") ?? "";
  form.view.value = asked.get("view") === "table" ? "table" : "cards";
  for (const chip of form.querySelectorAll(".chip input")) {
    if (chip instanceof HTMLInputElement) chip.checked = asked.getAll(chip.name).includes(chip.value);
  }
}

/**
 * @param {HTMLFormElement} form
 * @param {Index} index
 * @param {number[][]} counts
 */
function showCounts(form, index, counts) {
  for (const chip of form.querySelectorAll(".chip")) {
    const input = chip.querySelector("input");
    const small = chip.querySelector("small");
    if (!input || !small) continue;
    const facet = index.facets.findIndex(({ id }) => id === input.name);
    const number = counts[facet][index.facets[facet].options.indexOf(input.value)];
    small.textContent = number.toLocaleString("en-GB");
    chip.classList.toggle("is-none", number === 0);
  }
}

/** @param {string} id */
function required(id) {
  const found = document.getElementById(id);
  if (!found) throw new Error(`the page has no element ${id}`);
  return found;
}
