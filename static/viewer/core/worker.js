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
  checkWebAssembly();
  pyodide = await Promise.race([load(runtime), missingFile(runtime), brokenCode()]);
  const interpreter = performance.now();
  pyodide.pyimport("numpy").destroy();
  const numpy = performance.now();
  const { Door } = pyodide.pyimport("hexalab.session.door");
  door = Door();
  pyodide.pyimport("gc").freeze(); // what is there from the start is never looked through for what can go
  setTimeout(() => asked || pyodide.pyimport("hexalab.session.warm_up").warm_up(Door()), IDLE);
  return {
    interpreter: interpreter - began,
    numpy: numpy - interpreter,
    core: performance.now() - numpy,
  };
}

/** @param {string} runtime @returns {Promise<import("pyodide").PyodideAPI>} */
async function load(runtime) {
  const { loadPyodide } = await import(/* @vite-ignore */ `${runtime}pyodide.mjs`);
  return loadPyodide({
    indexURL: runtime,
    lockFileURL: `${runtime}pyodide-lock.json`,
    stdLibURL: `${runtime}python_stdlib.zip`,
    packages: ["hexalab"],
    checkIntegrity: true,
  });
}

/** The smallest module: its magic number and version. */
const NOTHING = Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0);

/** Where WebAssembly is missing or blocked, `loadPyodide` never settles. */
function checkWebAssembly() {
  if (typeof WebAssembly !== "object")
    throw new Error("this browser has no WebAssembly, or it is switched off");
  try {
    new WebAssembly.Module(NOTHING);
  } catch (cause) {
    const reason = cause instanceof Error ? cause.message : String(cause);
    throw new Error(
      `WebAssembly is blocked here, by the page's Content-Security-Policy or a setting of the browser (${reason})`,
      { cause },
    );
  }
}

/**
 * Rejects when one of the interpreter's files can't be had, after which `loadPyodide` may never settle; else it stays
 * open. Each file that comes is told.
 *
 * @param {string} runtime
 * @returns {Promise<never>}
 */
function missingFile(runtime) {
  return new Promise((_, reject) => {
    const fetching = self.fetch;
    self.fetch = async (what, options) => {
      const address = what instanceof Request ? what.url : String(what);
      const file = address.split("/").pop();
      try {
        const response = await fetching(what, options);
        if (!response.ok && address.startsWith(runtime))
          reject(new Error(`${file} is missing on the server (status ${response.status})`));
        else postMessage({ loading: file });
        return response;
      } catch (cause) {
        if (address.startsWith(runtime))
          reject(new Error(`${file} could not be fetched: the network may be gone`, { cause }));
        throw cause;
      }
    };
  });
}

/** Rejects when the interpreter's code can't be compiled, after which `loadPyodide` never settles. @returns {Promise<never>} */
function brokenCode() {
  return new Promise((_, reject) => {
    const compiling = WebAssembly.instantiateStreaming;
    Object.assign(WebAssembly, {
      instantiateStreaming: (/** @type {Parameters<typeof compiling>} */ ...given) => {
        const made = compiling(...given);
        made.catch((cause) => reject(new Error(`it can't be compiled: ${cause.message}`, { cause })));
        return made;
      },
    });
  });
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
  const { _module: module } = /** @type {{ _module: { HEAPU8: Uint8Array } }} */ (
    /** @type {unknown} */ (pyodide)
  );
  const memory = module.HEAPU8.byteLength;
  postMessage({ id, packed, milliseconds: performance.now() - began, memory }, [packed]);
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
  const sha256 = await hashed(bytes);
  postMessage({ id, sha256, bytes }, [bytes]);
}

/** Bytes that Python hashes at a time: they are copied into its memory. */
const SHARE = 2 ** 24;

/** SHA-256 in hexadecimal: by the browser, or by Python where the page is not secure (plain http). @param {ArrayBuffer} bytes */
async function hashed(bytes) {
  if (self.crypto?.subtle) {
    const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
    return Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
  }
  const sha256 = pyodide.pyimport("hashlib").sha256();
  for (let start = 0; start < bytes.byteLength; start += SHARE) {
    const share = pyodide.toPy(new Uint8Array(bytes, start, Math.min(SHARE, bytes.byteLength - start)));
    sha256.update(share);
    share.destroy();
  }
  const text = sha256.hexdigest();
  sha256.destroy();
  return text;
}

/** Whether a message is a question. @param {any} data @returns {data is Question} */
function isQuestion(data) {
  return (
    typeof data?.id === "number" &&
    typeof data.method === "string" &&
    typeof data.text === "string" &&
    Array.isArray(data.blocks)
  );
}

/** @param {unknown} error @returns {{ kind: string, message: string }} */
function described(error) {
  return error instanceof Error
    ? { kind: error.name, message: error.message }
    : { kind: "Error", message: String(error) };
}

/** While it starts, what fails is told by `boot`: what else failed because of it is no news. */
self.addEventListener("unhandledrejection", (event) => {
  if (!door) event.preventDefault();
});

/** Which of the interpreter's files is damaged, in words. @param {string} runtime @returns {Promise<string>} */
async function damageOf(runtime) {
  try {
    const { damageInWords } = await import("./damage.js");
    return await damageInWords(runtime);
  } catch {
    return ""; // it can't be told: there may be no network
  }
}

self.onmessage = async ({ data }) => {
  if (data?.boot) {
    try {
      postMessage({ ready: await boot(data.boot) });
    } catch (error) {
      const damage = await damageOf(data.boot);
      postMessage({ failed: damage ? { kind: "DamageError", message: damage } : described(error) });
    }
    return;
  }
  if (!isQuestion(data)) {
    postMessage({ id: data?.id, refused: { kind: "RequestError", message: "the question can't be read" } });
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
