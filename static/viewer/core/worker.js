/**
 * The core's worker: boots Pyodide once, then answers `{id, method, args}` by calling that method of `Session`.
 *
 * Arrays in a result leave as typed arrays on the transfer list, after the one copy that WebAssembly memory needs.
 * File bytes come in as an ArrayBuffer and are copied once into Python.
 */

/** @typedef {{id: number, method: string, args: unknown[]}} Question */

/** @type {any} */
let pyodide;
/** @type {any} */
let session;
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
    convertNullToNone: true,
    checkIntegrity: true,
  });
  const interpreter = performance.now();
  const { Session } = pyodide.pyimport("hexalab.session");
  session = Session();
  setTimeout(() => asked || pyodide.pyimport("hexalab.session.warm_up").warm_up(Session()), IDLE);
  return { interpreter: interpreter - began, core: performance.now() - interpreter };
}

/**
 * A Python value as JavaScript; numpy arrays become typed arrays of their own memory, noted in `transfer`.
 * @param {any} value
 * @param {Transferable[]} transfer
 */
function toJavaScript(value, transfer) {
  if (!(value instanceof pyodide.ffi.PyProxy)) return value;
  const converted = value.toJs({
    create_pyproxies: false,
    dict_converter: Object.fromEntries,
    default_converter: (/** @type {any} */ proxy) => leaf(proxy, transfer),
  });
  value.destroy();
  return withNulls(converted);
}

/**
 * None as null, as JSON has it: Pyodide makes it undefined, which in a settings document would mean "not said".
 * @param {any} value changed in place
 * @returns {any}
 */
function withNulls(value) {
  if (value === undefined) return null;
  if (typeof value === "object" && value !== null && !ArrayBuffer.isView(value))
    for (const key of Object.keys(value)) value[key] = withNulls(value[key]);
  return value;
}

/**
 * @param {any} proxy
 * @param {Transferable[]} transfer
 */
function leaf(proxy, transfer) {
  if (!(proxy instanceof pyodide.ffi.PyBuffer)) return proxy.item();
  const buffer = proxy.getBuffer();
  try {
    const copy = buffer.data.slice();
    transfer.push(copy.buffer);
    return copy;
  } finally {
    buffer.release();
  }
}

/** @param {unknown} argument */
function toPython(argument) {
  if (argument instanceof ArrayBuffer) return pyodide.toPy(new Uint8Array(argument));
  return pyodide.toPy(argument, { depth: -1 });
}

/** @param {any} error @returns {{kind: string, message: string, fatal: boolean}} */
function describeError(error) {
  if (pyodide && error instanceof pyodide.ffi.PythonError) {
    const lines = error.message.trimEnd().split("\n");
    const last = lines.findLastIndex((/** @type {string} */ line) => /^[\w.]+(:|$)/.test(line));
    const [, path, message] = /^([\w.]+):?\s*([\s\S]*)$/.exec(lines.slice(last).join("\n")) ?? [];
    return {
      kind: (path ?? error.type).split(".").pop() ?? error.type,
      message: message ?? "",
      fatal: false,
    };
  }
  return { kind: error?.name ?? "Error", message: String(error?.message ?? error), fatal: true };
}

/** @param {Question} question */
function answer({ id, method, args }) {
  const began = performance.now();
  /** @type {any[]} */
  let given = [];
  try {
    given = args.map(toPython);
    /** @type {Transferable[]} */
    const transfer = [];
    const result = toJavaScript(session[method](...given), transfer);
    postMessage({ id, result, milliseconds: performance.now() - began }, transfer);
  } catch (error) {
    postMessage({ id, error: describeError(error) });
  } finally {
    for (const argument of given) argument?.destroy?.();
  }
}

/** The file that is to be identified once nothing else is asked for. @type {{ opened: number, bytes: ArrayBuffer } | null} */
let unidentified = null;
let waiting = 0;

/** Hashing takes a core for a while: the first picture and the first numbers come before. */
function identifySoon() {
  clearTimeout(waiting);
  if (unidentified) waiting = setTimeout(identify, REST);
}

async function identify() {
  if (!unidentified) return;
  const { opened, bytes } = unidentified;
  unidentified = null;
  const digest = new Uint8Array(await crypto.subtle.digest("SHA-256", bytes));
  const sha256 = Array.from(digest, (byte) => byte.toString(16).padStart(2, "0")).join("");
  postMessage({ opened, sha256 });
}

self.onmessage = async ({ data }) => {
  if (data.boot) {
    try {
      postMessage({ ready: await boot(data.boot) });
    } catch (error) {
      postMessage({ failed: describeError(error) });
    }
    return;
  }
  asked = true;
  answer(data);
  const bytes = data.method === "open" && data.args[1];
  if (bytes instanceof ArrayBuffer) unidentified = { opened: data.id, bytes };
  identifySoon();
};
