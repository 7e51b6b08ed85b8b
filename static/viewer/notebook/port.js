/**
 * One view's way to the kernel. What is large goes in pieces: hosts lose in silence what has more than some ten megabytes.
 *
 * @typedef {import("./widget.js").Model} Model
 * @typedef {(message: any, block: ArrayBuffer | null, blocks: ArrayBuffer[]) => void} Hear
 *
 * @typedef {object} WidgetPort
 * @property {(message: Record<string, unknown> & { kind: string }, bytes?: ArrayBuffer) => void} send
 * @property {(kind: string, hear: Hear) => void} on
 * @property {(name: string) => any} get
 * @property {(name: string, value: unknown) => void} set
 * @property {(name: string, changed: (value: any) => void) => void} follow
 * @property {() => WidgetPort} another
 * @property {() => void} close
 */

/** Bytes of a piece. */
const PIECE = 4 * 2 ** 20;

/** @param {Model} model @returns {WidgetPort} */
export function portOf(model) {
  const view = crypto.randomUUID();
  /** @type {Map<string, Hear>} */
  const heard = new Map();
  /** @type {[string, (value: unknown) => void][]} */
  const followed = [];
  let number = 0;

  /** @param {any} message @param {readonly DataView[]} buffers */
  function hear(message, buffers) {
    if (message?.view !== undefined && message.view !== view) return;
    const blocks = buffers.map(own);
    heard.get(message?.kind)?.(message, blocks[0] ?? null, blocks);
  }
  model.on("msg:custom", hear);

  return {
    send(message, bytes) {
      const parts = Math.max(1, Math.ceil((bytes?.byteLength ?? 0) / PIECE));
      const told = { number: ++number, ...message, view };
      for (let part = 0; part < parts; part++) {
        // A view by itself: some hosts take nothing but a DataView, some send the whole buffer behind it.
        const piece = bytes ? [new DataView(bytes.slice(part * PIECE, (part + 1) * PIECE))] : [];
        model.send({ ...told, part, parts }, undefined, piece);
      }
    },
    on: (kind, listener) => heard.set(kind, listener),
    get: (name) => model.get(name),
    set(name, value) {
      model.set(name, value);
      model.save_changes();
    },
    follow(name, changed) {
      const listener = () => changed(model.get(name));
      followed.push([name, listener]);
      model.on(`change:${name}`, listener);
    },
    another: () => portOf(model),
    close() {
      model.off("msg:custom", hear);
      for (const [name, listener] of followed) model.off(`change:${name}`, listener);
      try {
        model.send({ kind: "closed", view });
      } catch {
        return; // the kernel is gone, and with it the session
      }
    },
  };
}

/** A block by itself, aligned as arrays want it. @param {DataView} buffer @returns {ArrayBuffer} */
function own({ buffer, byteOffset, byteLength }) {
  return /** @type {ArrayBuffer} */ (buffer.slice(byteOffset, byteOffset + byteLength));
}
