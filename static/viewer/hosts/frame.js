import { CoreClient } from "../core/client.js";
import { KernelTransport } from "../core/kernel_transport.js";
import { nothingAhead } from "./host.js";
import { Offers } from "./offers.js";

/** Milliseconds that the kernel may take to give the frame of a page. */
const PATIENCE = 60_000;

/** @param {import("../core/kernel_transport.js").Port} port @returns {Promise<string>} */
function askedSheet(port) {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error("the notebook's kernel does not answer")), PATIENCE);
    port.on("sheet", (_, block) => {
      clearTimeout(late);
      resolve(new TextDecoder().decode(block ?? new ArrayBuffer(0)));
    });
    port.send({ kind: "sheet" });
  });
}

/**
 * A notebook: the page stands in a frame of the widget, which has put its port on the frame's window; the kernel's own core
 * answers.
 *
 * @returns {import("./host.js").Host}
 */
export function frame() {
  const { hexalabPort: port } = /** @type {{ hexalabPort: import("../core/kernel_transport.js").Port }} */ (
    /** @type {unknown} */ (window)
  );
  const offers = new Offers();
  const transport = new KernelTransport(port, {
    hello: (hello) => offers.take(hello),
    slow: (slow) => offers.tellSlow(slow),
  });
  return {
    root: "",
    keeps: false,
    shares: false,
    steps: false,
    embedded: false,
    addressed: "",
    beside: "",
    client: new CoreClient(transport),
    another: () =>
      new CoreClient(
        new KernelTransport(port.another(), { hello: () => {}, slow: (slow) => offers.tellSlow(slow) }),
      ),
    ahead: nothingAhead(),
    sheet: () => askedSheet(port),
    offers,
    port,
  };
}
