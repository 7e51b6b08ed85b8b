import { scriptAddress } from "./trusted.js";

/**
 * Have the site kept for when there is no network: its service worker, and what happens when there is a new version.
 *
 *     const registration = new Registration(new URL("../", location.href));
 *     registration.addEventListener("update", () => ...);  // a new version waits
 *     await registration.start();
 *
 * Events: "update" when a new version waits to be taken; "taken" when this page is served by another version than before,
 * because this page or another one took it; "failed" when the site could not be kept.
 */
export class Registration extends EventTarget {
  #root;
  /** @type {ServiceWorkerRegistration | null} */
  #registration = null;
  /** Why the site could not be kept though the browser keeps pages. */
  #failure = "";

  /** @param {URL} root of the site */
  constructor(root) {
    super();
    this.#root = root;
  }

  /** Why this browser keeps nothing, in words; empty where it does. */
  get lack() {
    if (!globalThis.isSecureContext)
      return "the page does not come over https: browsers keep pages of secure sites alone";
    if (!("serviceWorker" in navigator))
      return "this browser keeps no pages here: it may be a private window, or service workers are switched off";
    return this.#failure;
  }

  /** @returns {Promise<string>} why the site is not kept, in words; empty if it is, or will be */
  async start() {
    if (this.lack) return this.lack;
    const { serviceWorker } = navigator;
    let served = Boolean(serviceWorker.controller);
    serviceWorker.addEventListener("controllerchange", () => {
      if (served) this.dispatchEvent(new Event("taken"));
      served = true;
    });
    try {
      const address = scriptAddress(new URL("service_worker.js", this.#root));
      const registration = await serviceWorker.register(address, {
        scope: this.#root.pathname,
        updateViaCache: "none",
      });
      this.#registration = registration;
      if (registration.waiting) this.#tell();
      registration.addEventListener("updatefound", () => {
        const coming = registration.installing;
        coming?.addEventListener("statechange", () => {
          if (coming.state === "installed" && serviceWorker.controller) this.#tell();
          if (coming.state === "redundant" && !registration.active) this.#fail();
        });
      });
      return "";
    } catch (error) {
      this.#failure = error instanceof Error ? error.message : String(error);
      return this.#failure;
    }
  }

  /** Look whether there is a new version. */
  async look() {
    await this.#registration?.update().catch(() => {}); // without a network there is none
  }

  /** Take the new version: "taken" follows, and the page is to be loaded again. @returns {boolean} whether one waits */
  take() {
    const waiting = this.#registration?.waiting;
    waiting?.postMessage({ take: true });
    return Boolean(waiting);
  }

  #fail() {
    this.#failure = "a file could not be fetched, or the browser's storage is full";
    this.dispatchEvent(new Event("failed"));
  }

  #tell() {
    this.dispatchEvent(new Event("update"));
  }
}
