import { Keeper, StorageFull } from "../../offline/keeper.js";
import { parcelOf } from "../../offline/parcel.js";
import { Shelf } from "../../offline/shelf.js";
import { fileSize } from "../../offline/sizes.js";
import { askLasting } from "../../offline/storage.js";
import { nameIn } from "./address.js";

/** @typedef {import("../../offline/parcel.js").Parcel} Parcel */

/** "Keep offline" for the mesh that is open, if it came from an address. */
export class Keeping {
  #app;
  #root;
  #keeper;
  #shelf;
  /** @type {AbortController | null} while it is fetched */
  #running = null;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
    this.#root = new URL(app.host.root, document.baseURI);
    this.#keeper = new Keeper(this.#root);
    this.#shelf = new Shelf(this.#root);
    app.facts.on("address", () => void this.#look());
  }

  /** Keep the open mesh until it is freed; free it if it is kept; cancel if it is on its way. */
  async toggle() {
    const parcel = this.#parcel();
    const { facts, messages } = this.#app;
    if (!parcel) return;
    if (this.#running) return this.#running.abort();
    try {
      if (facts.get("offline") === "kept") await this.#keeper.free(parcel);
      else await this.#keep(parcel);
    } catch (error) {
      messages.error(error, { topic: "keep" });
    }
    await this.#look();
  }

  /** @param {Parcel} parcel */
  async #keep(parcel) {
    const { facts, messages, progress } = this.#app;
    this.#running = new AbortController();
    const { signal } = this.#running;
    facts.set({ offline: "coming" });
    const task = progress.begin("keeping it offline");
    void askLasting();
    try {
      const { failed } = await this.#keeper.keep(parcel, {
        signal,
        report: (done, of, bytes) => task.report(done / of, `keeping it offline, ${fileSize(bytes)}`),
      });
      if (failed.length)
        messages.say("warning", `Not all is kept offline: ${failed.join("; ")}`, { topic: "keep" });
    } catch (error) {
      if (error instanceof StorageFull)
        messages.say("warning", "The browser's storage is full: the mesh is not kept offline", {
          topic: "keep",
          action: { name: "see what is kept", press: () => this.show() },
        });
      else if (!signal.aborted) throw error;
    } finally {
      this.#running = null;
      task.end();
    }
  }

  /** Show all that is kept, in a window of its own: what is open stays. */
  show() {
    window.open(new URL("offline/index.html", this.#root), "_blank", "noopener");
  }

  async #look() {
    const { facts } = this.#app;
    const parcel = this.#parcel();
    if (!parcel || !this.#shelf.works) return facts.set({ offline: null });
    try {
      const { meshes, of } = await this.#keeper.state(parcel);
      if (!this.#running) facts.set({ offline: meshes === of ? "kept" : "free" });
    } catch {
      facts.set({ offline: null }); // a browser that keeps nothing
    }
  }

  /** @returns {Parcel | null} null for a mesh that came as a file */
  #parcel() {
    const { facts } = this.#app;
    const address = facts.get("address");
    const entry = facts.get("entry");
    if (!this.#app.host.keeps || !/^https?:/.test(address)) return null;
    if (entry) return parcelOf(entry.source, entry.mesh.slug, this.#root.href);
    return { meshes: [{ name: nameIn(address), address, bytes: null, sha256: "" }], pages: [], previews: [] };
  }
}
