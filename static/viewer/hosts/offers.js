/**
 * Meshes that the core can open without their bytes being sent, and what is told of them.
 *
 * Events: "offered" when the list has come or changed; "changed" and "gone" ({id}) when a file was written anew or is there no
 * more; "slow" ({slow}) when an answer has been missing for long, and when it came; "stopped" when the core's program has ended.
 *
 * @typedef {{ id: string, name: string, surface?: boolean }} Offer  surface: whether it is a reference surface, and no mesh
 */
export class Offers extends EventTarget {
  /** @type {readonly Offer[]} */
  list = [];
  /** Settings that the first one is to be opened under. @type {object | null} */
  status = null;
  /** Whether the first one is opened without being asked for. */
  opens = true;

  /** The one that the first is compared with. @type {string | null} */
  compare = null;

  /** @param {{ offers: readonly Offer[], status: object | null, opens: boolean, compare?: string | null }} given */
  take({ offers, status, opens, compare = null }) {
    this.list = offers;
    this.compare = compare;
    this.status = status;
    this.opens = opens;
    this.dispatchEvent(new Event("offered"));
  }

  /** @param {"changed" | "gone"} what @param {string} id */
  tell(what, id) {
    this.dispatchEvent(new CustomEvent(what, { detail: { id } }));
  }

  /** @param {boolean} slow whether an answer is missing */
  tellSlow(slow) {
    this.dispatchEvent(new CustomEvent("slow", { detail: { slow } }));
  }

  tellStopped() {
    this.dispatchEvent(new Event("stopped"));
  }
}
