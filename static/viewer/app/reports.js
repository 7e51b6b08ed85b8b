import { toBase64 } from "../files/base64.js";
import { posed } from "./posing.js";

/**
 * @typedef {import("../state/leaving.js").Left} Left
 * @typedef {import("../state/leaving.js").ReportWanted} ReportWanted
 * @typedef {{ title: string, alt: string, picture: Blob }} Taken
 */

/** The report of the open mesh: the core writes it, with pictures that are taken here. */
export class Reports {
  #app;

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /** @param {string} [form] "html", "md", "json" or "xml"; only the first has pictures @param {ReportWanted} [wanted] @returns {Promise<Left & { passed: boolean }>} */
  async file(form = "html", { criteria = null, strict = false, pictures = true } = {}) {
    const { client, opening, store, facts } = this.#app;
    const summary = facts.get("summary");
    if (!summary) throw new Error("no mesh is open: there is nothing to report");
    await opening.identified;
    const { taken, notes } = pictures && form === "html" ? await this.#taken() : NOTHING;
    if (facts.get("summary") !== summary)
      throw new Error("another mesh was opened while the report was made");
    const { mesh, unit } = store.status;
    const { text, ending, passed } = await client.call("report", [
      form,
      { sha256: mesh.sha256, unit, notes },
      await Promise.all(taken.map(within)),
      criteria,
      strict,
    ]);
    return { file: new Blob([text], { type: TYPES[ending] }), ending, passed, notes };
  }

  /** The pictures; a browser that can't draw makes a report without. @returns {Promise<{ taken: readonly Taken[], notes: readonly string[] }>} */
  async #taken() {
    try {
      return { taken: await this.pictures(), notes: [] };
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      return { taken: [], notes: [`Pictures are left out: ${reason}.`] };
    }
  }

  /** The pictures that the core asks for, one after the other; all settings are then what they were. @returns {Promise<Taken[]>} */
  async pictures() {
    const { client, store, figures } = this.#app;
    const poses = await client.call("report_poses", [store.status.unit]);
    const taken = await posed(
      this.#app,
      poses.map(({ status }) => status),
      () => figures.file("png", null, "first"), // which completes its own light
    );
    return poses.map(({ title, alt }, k) => ({ title, alt, picture: taken[k] }));
  }
}

/** @type {{ taken: readonly Taken[], notes: readonly string[] }} */
const NOTHING = { taken: [], notes: [] };

/** @type {Readonly<Record<string, string>>} */
const TYPES = {
  html: "text/html",
  md: "text/markdown",
  json: "application/json",
  xml: "application/xml",
};

/** A picture as it stands in the page. @param {Taken} taken */
async function within({ title, alt, picture }) {
  const bytes = new Uint8Array(await picture.arrayBuffer());
  return { title, alt, address: `data:image/png;base64,${toBase64(bytes)}` };
}
