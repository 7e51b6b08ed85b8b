import { Registration } from "../../offline/registration.js";

/**
 * Keeps the site for when there is no network, and offers a new version of it. It is taken when the user says so: the page is
 * loaded again, with the mesh, all settings and what can be undone as they were.
 */
export class NewVersion {
  #app;
  #registration;
  #taking = false;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
    this.#registration = new Registration(new URL(app.host.root, document.baseURI));
    this.#registration.addEventListener("update", () => this.#offer());
    this.#registration.addEventListener("taken", () => (this.#taking ? location.reload() : this.#tell()));
  }

  /** Once the core has come: what is kept for later takes nothing from what is wanted now. */
  async start() {
    const tell = () => this.#app.facts.set({ lack: this.#registration.lack });
    this.#registration.addEventListener("failed", tell);
    await this.#registration.start();
    tell();
    addEventListener("online", () => void this.#registration.look());
    addEventListener("visibilitychange", () => {
      if (document.visibilityState === "visible") void this.#registration.look();
    });
  }

  #offer() {
    this.#app.messages.say("note", "A new version of HexaLab is there", {
      topic: "version",
      action: { name: "reload", press: () => void this.take() },
    });
  }

  #tell() {
    this.#app.messages.say(
      "note",
      "Another window took a new version of HexaLab; this one goes on with the old",
      {
        topic: "version",
        action: { name: "reload", press: () => void this.take() },
      },
    );
  }

  /** Hold what is open, and load the page again with the new version. */
  async take() {
    try {
      await this.#app.lastFiles.hold();
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      const name = this.#app.facts.get("summary")?.name ?? "the mesh";
      this.#app.messages.say(
        "warning",
        `${name} can't be kept over the reload (${reason}): it has to be opened again afterwards`,
        { topic: "version", action: { name: "reload all the same", press: () => this.#go() } },
      );
      return;
    }
    this.#go();
  }

  #go() {
    this.#taking = true;
    if (!this.#registration.take()) location.reload();
  }
}
