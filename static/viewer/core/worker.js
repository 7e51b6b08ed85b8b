/**
 * The core's worker: boots Pyodide once, then answers questions (`question.js`) through the Python `Door`.
 *
 * An answer is one packed block: its arrays are copied once, from WebAssembly memory to where the page will have them.
 * File bytes come in as an ArrayBuffer and are copied once into Python.
 *
 * @typedef {import("./question.js").Question} Question
 *
 * @typedef {object} Laid  an answer that is laid out in Python (`hexalab.packing.Packed`)
 * @property {number} size
 * @property {{ toJs: () => Uint8Array }} head
 * @property {Iterable<[offset: number, array: PythonArray] & Passing>} arrays
 *
 * @typedef {{ destroy: () => void }} Passing  what Python holds for us until it is given back
 * @typedef {Passing & { getBuffer: (kind: "u8") => { data: Uint8Array, release: () => void } }} PythonArray
 * @typedef {{ answer: (method: string, text: string, blocks: Passing) => Laid & Passing }} Door
 */

/** @type {import("pyodide").PyodideAPI} */
let pyodide;
/** @type {Door} */
let door;
/** Whether a question has come yet. */
let asked = false;

/** Milliseconds to wait for a question before the core warms up. */
const IDLE = 50;

/** Milliseconds without a question before a file is hashed. */
const REST = 60;

/**
 * @param {string} runtime address of the folder with the interpreter, ending in a slash
 */
async function boot(runtime) {
  const began = performance.now();
  const { loadPyodide } = await import(/* @vite-ignore */ `${runtime}pyodide.mjs`);
  pyodide = await loadPyodide({
    indexURL: runtime,
    lockFileURL: `${runtime}pyodide-lock.json`,
    stdLibURL: `${runtime}python_stdlib.zip`,
    packages: ["hexalab"],
    checkIntegrity: true,
  });
  const interpreter = performance.now();
  const { Door } = pyodide.pyimport("hexalab.session.door");
  door = Door();
  setTimeout(() => asked || pyodide.pyimport("hexalab.session.warm_up").warm_up(Door()), IDLE);
  return { interpreter: interpreter - began, core: performance.now() - interpreter };
}

/**
 * The block that an answer makes.
 *
 * @param {Laid} laidOut
 * @returns {ArrayBuffer}
 */
function joined(laidOut) {
  const block = new Uint8Array(laidOut.size);
  const head = laidOut.head.toJs();
  block.set(head);
  for (const row of laidOut.arrays) {
    const [offset, array] = row; // not [...row]: an iterator at its end destroys what it has given
    const buffer = array.getBuffer("u8");
    block.set(buffer.data, head.length + offset);
    buffer.release();
    array.destroy();
    row.destroy();
  }
  return block.buffer;
}

/** @param {Question} question */
function answer({ id, method, text, blocks }) {
  const began = performance.now();
  const given = pyodide.toPy(blocks.map((block) => new Uint8Array(block)));
  const laidOut = door.answer(method, text, given);
  const packed = joined(laidOut);
  laidOut.destroy();
  given.destroy();
  postMessage({ id, packed, milliseconds: performance.now() - began }, [packed]);
}

/** The file that is to be identified once nothing else is asked for. @type {{ id: number, bytes: ArrayBuffer } | null} */
let unidentified = null;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let waiting;

/** Hashing takes a core for a while: the first picture and the first numbers come before. */
function identifySoon() {
  clearTimeout(waiting);
  if (unidentified) waiting = setTimeout(identify, REST);
}

async function identify() {
  if (!unidentified) return;
  const { id, bytes } = unidentified;
  unidentified = null;
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  const sha256 = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
  postMessage({ id, sha256 });
}

/** @param {unknown} error @returns {{ kind: string, message: string }} */
function described(error) {
  return error instanceof Error
    ? { kind: error.name, message: error.message }
    : { kind: "Error", message: String(error) };
}

self.onmessage = async ({ data }) => {
  if (data.boot) {
    try {
      postMessage({ ready: await boot(data.boot) });
    } catch (error) {
      postMessage({ failed: described(error) });
    }
    return;
  }
  asked = true;
  try {
    answer(data);
  } catch (error) {
    postMessage({ broken: described(error) }); // Python tells its own errors in its answer: this is the end of it
    return;
  }
  if (data.method === "open" && data.blocks.length) unidentified = { id: data.id, bytes: data.blocks[0] };
  identifySoon();
};
