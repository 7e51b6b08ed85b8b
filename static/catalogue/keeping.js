import { Keeper, StorageFull } from "../offline/keeper.js";
import { fetchSources, parcelOf } from "../offline/parcel.js";
import { Shelf } from "../offline/shelf.js";
import { fileSize } from "../offline/sizes.js";
import { askLasting } from "../offline/storage.js";

/**
 * "Keep offline" on the pages of sources and meshes: an element that names what in `data-keep`, as "source" or
 * "source/mesh", with a button, a bar and a line of words.
 *
 * @param {Document} page @param {URL} root of the site
 */
export function enableKeeping(page, root) {
  for (const element of page.querySelectorAll("[data-keep]"))
    if (element instanceof HTMLElement) void new KeepControl(element, root).start();
}

class KeepControl {
  #root;
  #keeper;
  #shelf;
  #what;
  #button;
  #bar;
  #words;
  #weight;
  /** @type {AbortController | null} while it is fetched */
  #running = null;
  /** Whether all of it is kept. */
  #kept = false;

  /** @param {HTMLElement} element @param {URL} root */
  constructor(element, root) {
    this.#root = root;
    this.#keeper = new Keeper(root);
    this.#shelf = new Shelf(root);
    this.#what = element.dataset.keep ?? "";
    this.#button = /** @type {HTMLButtonElement} */ (element.querySelector("button"));
    this.#bar = /** @type {HTMLProgressElement} */ (element.querySelector("progress"));
    this.#words = /** @type {HTMLElement} */ (element.querySelector("[role=status]"));
    this.#weight = this.#words.textContent ?? "";
    this.#button.addEventListener("click", () => void this.#press());
  }

  async start() {
    if (!this.#shelf.works) {
      this.#button.disabled = true;
      this.#words.textContent = globalThis.isSecureContext
        ? "This browser keeps nothing here: it may be a private window"
        : "Pages that do not come over https can't be kept";
      return;
    }
    try {
      if ((await this.#shelf.list()).length) await this.#show();
    } catch {
      // the page is being left, or its list can't be had: the button says so when it is pressed
    }
  }

  async #press() {
    if (this.#running) return this.#running.abort();
    try {
      if (this.#kept) {
        await this.#keeper.free(await this.#parcel());
        await this.#show();
      } else await this.#keep();
    } catch (error) {
      this.#say(error instanceof Error ? error.message : String(error));
    }
  }

  async #keep() {
    this.#running = new AbortController();
    const { signal } = this.#running;
    this.#button.textContent = "Cancel";
    this.#bar.hidden = false;
    this.#bar.removeAttribute("value");
    void askLasting();
    let problem = "";
    try {
      const { failed } = await this.#keeper.keep(await this.#parcel(), {
        signal,
        report: (done, of, bytes) => {
          this.#bar.max = of;
          this.#bar.value = done;
          this.#words.textContent = `${done} of ${of} files${bytes ? `, ${fileSize(bytes)}` : ""}`;
        },
      });
      if (failed.length) problem = failureInWords(failed);
    } catch (error) {
      if (error instanceof StorageFull) problem = "The browser's storage is full; what has come is kept";
      else if (!signal.aborted) throw error;
    } finally {
      this.#running = null;
      this.#bar.hidden = true;
      await this.#show();
    }
    if (problem) this.#say(problem);
  }

  async #show() {
    const { meshes, of, bytes } = await this.#keeper.state(await this.#parcel());
    this.#kept = meshes === of;
    this.#button.textContent = this.#kept ? "Free" : "Keep offline";
    this.#button.title = this.#kept ? "Let this browser keep it no more" : "";
    if (this.#kept) this.#say(`Kept in this browser, ${fileSize(bytes)}`);
    else if (meshes) this.#say(`${meshes} of ${of} meshes are kept, ${fileSize(bytes)}`);
    else this.#words.textContent = this.#weight;
  }

  /** Words, and the way to what is kept. @param {string} text */
  #say(text) {
    const link = document.createElement("a");
    link.href = new URL("offline/index.html", this.#root).href;
    link.textContent = "All that is kept";
    this.#words.replaceChildren(`${text}. `, link);
  }

  async #parcel() {
    const sources = await fetchSources(this.#root);
    const [slug, mesh = ""] = this.#what.split("/");
    const source = sources.find((one) => one.slug === slug);
    if (!source) throw new Error(`The catalogue's list has no source ${slug}: load the page again`);
    return parcelOf(source, mesh, this.#root.href);
  }
}

/** @param {readonly string[]} failed reasons */
function failureInWords([first, ...others]) {
  return others.length ? `${first}; ${others.length} more could not be kept` : first;
}
