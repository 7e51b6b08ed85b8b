/** Milliseconds after which a pointer that does not move is taken to rest. */
const REST = 120;

/**
 * What the pointer does on the picture: turn (a click inspects), dig, undig, isolate; ctrl held digs, shift held
 * undigs. The face a click would act on is highlighted before.
 */
export class Tools {
  #app;
  #canvas;
  /** @type {import("../state/facts.js").PickingTool | ""} */
  #held = "";
  /** @type {{ x: number, y: number } | null} */
  #place = null;
  #looking = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #rest;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #telling;

  /**
   * @param {import("../app/side.js").Side} app @param {HTMLCanvasElement} canvas
   * @param {AbortSignal} [signal] that ends it
   */
  constructor(app, canvas, signal) {
    this.#app = app;
    this.#canvas = canvas;
    app.scene.on("click", (at) => this.#click(at));
    app.scene.on("hover", (at) => this.#hover(at));
    app.facts.on("tool", () => this.#show());
    window.addEventListener("keydown", (event) => this.#hold(event), { signal });
    window.addEventListener("keyup", (event) => this.#hold(event), { signal });
    window.addEventListener("blur", () => this.#setHeld(""), { signal });
    this.#show();
  }

  /** The tool at hand, held keys first. */
  get tool() {
    return this.#held || this.#app.facts.get("tool");
  }

  /** @param {KeyboardEvent} event */
  #hold({ ctrlKey, metaKey, shiftKey }) {
    this.#setHeld(ctrlKey || metaKey ? "dig" : shiftKey ? "undig" : "");
  }

  /** @param {import("../state/facts.js").PickingTool | ""} held */
  #setHeld(held) {
    if (held === this.#held) return;
    this.#held = held;
    this.#show();
  }

  #show() {
    this.#canvas.dataset.tool = this.tool;
    if (this.#place) this.#look();
  }

  /** @param {{ x: number, y: number, event: PointerEvent }} at */
  async #click({ x, y, event }) {
    if (!this.#app.facts.get("shown")) return;
    const tool =
      event.ctrlKey || event.metaKey ? "dig" : event.shiftKey ? "undig" : this.#app.facts.get("tool");
    const hit = await this.#app.scene.pick(x, y);
    if (hit) await this.#app.cells.act(tool, hit);
    else if (tool === "turn") this.#app.inspect(null);
  }

  /** @param {{ x: number, y: number } | null} at */
  #hover(at) {
    this.#place = at;
    this.#look();
  }

  /** Look up the face under the pointer: at once where a click would act on it, else when the pointer rests. */
  #look() {
    clearTimeout(this.#rest);
    if (!this.#place) return this.#found(null);
    if (this.tool === "turn") this.#rest = setTimeout(() => this.#pick(), REST);
    else if (!this.#looking) {
      this.#looking = true;
      requestAnimationFrame(() => {
        this.#looking = false;
        void this.#pick();
      });
    }
  }

  async #pick() {
    const { scene, facts } = this.#app;
    const place = this.#place;
    const hit = place && facts.get("shown") ? await scene.pick(place.x, place.y) : null;
    if (place === this.#place) this.#found(hit);
  }

  /** @param {{ cell: number, face: number } | null} hit */
  #found(hit) {
    const { scene, facts, cells } = this.#app;
    scene.highlight(hit && this.tool !== "turn" ? hit.face : null);
    clearTimeout(this.#telling);
    if (hit?.cell !== facts.get("hover")?.cell) facts.set({ hover: hit ? { cell: hit.cell } : null });
    if (hit && facts.get("hover")?.value === undefined)
      this.#telling = setTimeout(() => cells.tell(hit.cell), REST);
  }
}
