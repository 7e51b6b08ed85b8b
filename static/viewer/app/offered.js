import { Superseded } from "../core/client.js";

/**
 * Meshes that the core has at hand: the first is opened, the others can be chosen; one whose file was written anew is opened
 * again, under all its settings.
 *
 * @typedef {import("../hosts/offers.js").Offer} Offer
 */
export class Offered {
  #app;
  #offers;
  #begun = false;

  /** @param {import("./app.js").App} app @param {import("../hosts/offers.js").Offers} offers */
  constructor(app, offers) {
    this.#app = app;
    this.#offers = offers;
  }

  start() {
    const offers = this.#offers;
    const id = (/** @type {Event} */ event) => /** @type {CustomEvent<{ id: string }>} */ (event).detail.id;
    offers.addEventListener("offered", () => this.#take());
    offers.addEventListener("changed", (event) => void this.#again(id(event)));
    offers.addEventListener("gone", (event) => this.#tellGone(id(event)));
    offers.addEventListener("slow", (event) =>
      this.#tellSlow(/** @type {CustomEvent<{ slow: boolean }>} */ (event).detail.slow),
    );
    offers.addEventListener("stopped", () => this.#tellStopped());
    if (offers.list.length) this.#take();
  }

  /** @param {string} id @param {unknown} [status] */
  async open(id, status) {
    const { opening, steps } = this.#app;
    const offer = this.#offers.list.find((one) => one.id === id);
    if (!offer) throw new Error(`nothing is offered by the name of ${id}`);
    steps.leave();
    const origin = { name: offer.name, offered: id };
    const summary = await opening.open({ ...origin, status });
    steps.add(null, () => opening.open(origin));
    return summary;
  }

  #take() {
    const { list, opens } = this.#offers;
    this.#app.facts.set({ offers: list });
    if (this.#begun || !opens || !list.length) return;
    this.#begun = true;
    this.#begin().catch(() => {}); // said in a message by whoever failed
  }

  /** The first, and what it is compared with. */
  async #begin() {
    const { list, status, compare } = this.#offers;
    await this.open(list[0].id, status ?? undefined);
    if (compare !== null) await this.#app.comparing.openOffered(compare);
  }

  /** The file of the open mesh was written anew, or that of what it is compared with. @param {string} id */
  async #again(id) {
    const { opening, messages, facts, cells, comparing } = this.#app;
    if (await comparing.renew(id)) {
      const name = this.#offers.list.find((one) => one.id === id)?.name;
      messages.say("note", `${name} was written anew, and is compared with as it is now`, { topic: "watch" });
    }
    if (facts.get("offered") !== id) return;
    const before = facts.get("summary")?.cells;
    const inspected = facts.get("cell")?.cell;
    try {
      const summary = await opening.renew();
      if (!summary) return;
      const alike = summary.cells === before;
      messages.say("note", `${summary.name} was written anew, and is shown as it is now`, { topic: "watch" });
      if (alike && inspected !== undefined) await cells.inspect(inspected);
    } catch (error) {
      if (!(error instanceof Superseded))
        messages.say(
          "warning",
          "The mesh from before is still shown; the next change of the file is waited for",
          {
            topic: "watch",
          },
        );
    }
  }

  /** @param {string} id */
  #tellGone(id) {
    const { facts, messages } = this.#app;
    const name = this.#offers.list.find((one) => one.id === id)?.name;
    if (facts.get("offered") !== id || !name) return;
    messages.say(
      "warning",
      `${name} is not there any more: the mesh is shown as it was read, until the file comes back`,
      {
        topic: "watch",
      },
    );
  }

  /** @param {boolean} slow */
  #tellSlow(slow) {
    const { messages } = this.#app;
    const words =
      "The notebook's kernel does not answer: it is busy with a cell; or it is gone, then run the cell again";
    if (slow) messages.say("warning", words, { topic: "kernel" });
    else messages.settle("kernel");
  }

  #tellStopped() {
    this.#app.facts.set({ core: "failed" });
    this.#app.messages.say(
      "warning",
      "The program on this machine has ended: the picture can be turned and saved, and nothing more can be asked",
      { topic: "core" },
    );
  }
}
