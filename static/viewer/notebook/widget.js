import { darkness } from "./darkness.js";
import { portOf } from "./port.js";

/**
 * The widget's front end (anywidget): a frame with the viewer's page, whose script the kernel gives once for all widgets.
 *
 * @typedef {object} Model  what anywidget gives
 * @property {(name: string) => any} get
 * @property {(name: string, value: unknown) => void} set
 * @property {() => void} save_changes
 * @property {(event: string, hear: (...given: any[]) => void) => void} on
 * @property {(event: string, hear?: (...given: any[]) => void) => void} off
 * @property {(content: unknown, callbacks?: unknown, buffers?: readonly (ArrayBuffer | ArrayBufferView)[]) => void} send
 */

/** Milliseconds that the kernel may take to give the viewer. */
const PATIENCE = 60_000;

/**
 * The viewer's page and the address of its script: evaluated from one place by all widgets of one version.
 *
 * @param {import("./port.js").WidgetPort} port @param {string} version
 * @returns {Promise<{ html: string, script: string }>}
 */
function bundle(port, version) {
  const shared = /** @type {Record<symbol, Promise<{ html: string, script: string }> | undefined>} */ (
    /** @type {unknown} */ (globalThis)
  );
  const key = Symbol.for(`hexalab viewer ${version}`);
  const asked = (shared[key] ??= fetched(port));
  asked.catch(() => delete shared[key]);
  return asked;
}

/** @param {import("./port.js").WidgetPort} port @returns {Promise<{ html: string, script: string }>} */
function fetched(port) {
  return new Promise((resolve, reject) => {
    const late = setTimeout(
      () => reject(new Error("the notebook's kernel does not answer: run the cell again")),
      PATIENCE,
    );
    port.on("bundle", (_, __, blocks) => {
      clearTimeout(late);
      const [html, script] = blocks;
      resolve({
        html: new TextDecoder().decode(html),
        script: URL.createObjectURL(new Blob([script], { type: "text/javascript" })),
      });
    });
    port.send({ kind: "bundle" });
  });
}

/** @param {{ model: Model, el: HTMLElement }} given @returns {() => void} what ends it */
function render({ model, el }) {
  const port = portOf(model);
  const frame = document.createElement("iframe");
  frame.title = "HexaLab";
  Object.assign(frame.style, { width: "100%", border: "0", display: "block" });
  const size = () => Object.assign(frame.style, { height: `${model.get("height")}px` });
  size();
  model.on("change:height", size);
  const undarken = darkness((dark) => Object.assign(frame.style, { colorScheme: dark ? "dark" : "light" }));
  el.classList.add("hexalab-live");
  el.append(frame);
  bundle(port, model.get("_version")).then(
    ({ html, script }) => {
      frame.addEventListener("load", () => begin(frame, port, script), { once: true });
      frame.srcdoc = html;
    },
    (error) => {
      el.classList.remove("hexalab-live");
      frame.replaceWith(
        Object.assign(document.createElement("p"), { textContent: `HexaLab: ${error.message}` }),
      );
    },
  );
  return () => {
    model.off("change:height", size);
    undarken();
    frame.remove();
    port.close();
  };
}

/** @param {HTMLIFrameElement} frame @param {import("./port.js").WidgetPort} port @param {string} address */
function begin(frame, port, address) {
  const { contentWindow, contentDocument } = frame;
  if (!contentWindow || !contentDocument) return;
  Object.assign(contentWindow, { hexalabPort: port });
  const script = contentDocument.createElement("script");
  script.type = "module";
  script.src = address;
  contentDocument.head.append(script);
}

// biome-ignore lint/style/noDefaultExport: anywidget asks for one
export default { render };
