import { CoreClient } from "../core/client.js";
import { KernelTransport } from "../core/kernel_transport.js";
import { nothingAhead } from "./host.js";
import { Offers } from "./offers.js";

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
    addressed: "",
    client: new CoreClient(transport),
    ahead: nothingAhead(),
    offers,
    port,
  };
}
