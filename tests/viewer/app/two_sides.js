import { App } from "../../../static/viewer/app/app.js";
import { Messages } from "../../../static/viewer/app/messages.js";
import { Side } from "../../../static/viewer/app/side.js";
import { BlankScene } from "../../../static/viewer/page/blank_scene.js";
import { Facts } from "../../../static/viewer/state/facts.js";
import { SecondStore } from "../../../static/viewer/state/second_store.js";
import { StatusStore } from "../../../static/viewer/state/store.js";
import { DEFAULTS } from "../defaults.js";
import { Core } from "./fake_core.js";

/** Rest of what is under way, and of what follows from it. */
export async function settled() {
  for (let round = 0; round < 40; round++) await new Promise((resolve) => setTimeout(resolve));
}

/** A scene that notes what is seen beside its mesh. */
export class NotingScene extends BlankScene {
  beside = /** @type {Float32Array | null} */ (null);
  disposed = false;
  /** @override @param {Float32Array | null} [points] */
  setBeside(points = null) {
    this.beside = points;
  }
  /** @override */
  dispose() {
    this.disposed = true;
  }
}

const METRIC = {
  variant: "",
  better: "high",
  length_power: 0,
  full_range: [null, null],
  acceptable_range: null,
};

const COMPARED = { better: "low", length_power: 1, metric: "" };

export const tables = /** @type {import("../../../static/viewer/state/tables.js").Tables} */ (
  /** @type {unknown} */ ({
    core_paths: ["filters", "colour.by", "colour.attribute", "colour.reach", "arrows.attribute"],
    described: [],
    metrics: [
      { ...METRIC, id: "scaled_jacobian", name: "Scaled Jacobian", symbol: "SJ" },
      { ...METRIC, id: "volume", name: "Volume", symbol: "V" },
    ],
    traced: [{ id: "structure:block", name: "Block" }],
    compared: [
      { ...COMPARED, id: "compare:distance", name: "Distance", cellwise: false },
      { ...COMPARED, id: "compare:displacement", name: "Displacement", cellwise: true },
      { ...COMPARED, id: "change:volume", name: "Change", cellwise: true, metric: "volume", better: "high" },
    ],
    formats: [
      { id: "medit", name: "MEDIT", extensions: [".mesh"] },
      { id: "vtk", name: "VTK", extensions: [".vtk"] },
    ],
    surfaces: [
      { id: "stl", name: "STL", extensions: [".stl"] },
      { id: "vtk", name: "VTK", extensions: [".vtk"] },
    ],
  })
);

/** What of a browser the application asks for. */
function pretendBrowser() {
  const listeners = { addEventListener() {} };
  Object.assign(globalThis, {
    document: { baseURI: "https://meshes.example/", ...listeners, documentElement: { dataset: {} } },
    window: listeners,
    requestAnimationFrame: (/** @type {() => void} */ next) => setTimeout(next),
  });
}

/** A page with room for two meshes and no browser: the application itself, and the second meshes that it made. @param {{ alone?: boolean, offers?: import("./fake_core.js").Offers }} [options] */
export function page({ alone = false, offers = {} } = {}) {
  pretendBrowser();
  const store = new StatusStore(DEFAULTS);
  const facts = new Facts({ core: "ready" });
  const core = new Core(offers);
  const scene = new NotingScene(store.status.camera);
  const host = /** @type {any} */ ({
    root: "./",
    keeps: false,
    steps: false,
    ahead: { tellShown() {}, catalogue: Promise.resolve(null) },
    offers: null,
    port: null,
  });
  const canvas = /** @type {any} */ ({});
  /** @type {{ core: Core, scene: NotingScene, closed: boolean, side: import("../../../static/viewer/app/comparing.js").Second }[]} */
  const seconds = [];
  const make = () => {
    const own = { core: new Core(offers), scene: new NotingScene(store.status.camera), closed: false };
    const second = new SecondStore(store);
    const messages = new Messages(facts, "second ");
    const side = new Side(
      {
        store: second,
        facts: new Facts({ core: "ready" }),
        client: /** @type {any} */ (own.core),
        scene: own.scene,
        tables,
        canvas,
        host,
      },
      messages,
    );
    const close = () => {
      made.closed = true;
      messages.end();
      second.stop();
      own.core.dispose();
      own.scene.dispose();
    };
    const made = { ...own, side: Object.assign(side, { store: second, close }) };
    seconds.push(made);
    return made.side;
  };
  const client = /** @type {any} */ (core);
  const app = new App({ store, facts, client, scene, tables, canvas, host }, alone ? null : make);
  const said = () => facts.get("messages").map(({ severity, text }) => [severity, text]);
  return { app, store, facts, core, scene, seconds, said, comparing: app.comparing };
}
