import { HexaLab } from "./app/api.js";
import { App } from "./app/app.js";
import { Parent } from "./app/parent.js";
import { listenToClipboard } from "./input/clipboard.js";
import { listenToDrops } from "./input/drop.js";
import { listenToLaunches } from "./input/launches.js";
import { listenToKeys } from "./input/keyboard.js";
import { Tools } from "./input/tools.js";
import { soon } from "./core/soon.js";
import { Page } from "./page/page.js";
import { secondPane } from "./page/second_pane.js";
import { BlankScene } from "./page/blank_scene.js";
import { Lighting } from "./lighting/lighting.js";
import { Scene } from "./scene/scene.js";
import { Facts } from "./state/facts.js";
import { statusFromHash } from "./state/link.js";
import { StatusStore } from "./state/store.js";
import { readTables } from "./state/tables.js";
import { host } from "./start.js";

const { client, ahead, addressed, beside, another } = host;
const tables = readTables(document);
const store = new StatusStore(tables.defaults);
const facts = new Facts();
const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById("canvas"));
/** Milliseconds that whole pictures wait for Python, at most: a later one waits for the network. */
const PATIENCE = 4000;
const idle = addressed ? soon(client.ready, PATIENCE).catch(() => {}) : Promise.resolve();
const { scene, lack } = firstScene();
/** A second mesh beside the first. @type {(() => import("./app/comparing.js").Second) | null} */
const makeSecond = another && (() => secondPane({ first: app, another, makeScene }));
const app = new App({ store, facts, client, scene, tables, canvas, host }, makeSecond);
app.start({ addressed: addressed !== "" });
if (lack) app.messages.say("error", lack);

const api = new HexaLab(app);
Object.assign(window, { hexalab: api });
if (host.shares) new Parent(api, facts, location).start();
document.getElementById("could-not-start")?.remove();
openWhatTheAddressNames().catch(() => {}); // said in a message by whoever failed
if (addressed) void soon(ahead.shown, 100).then(buildPage);
else buildPage();

/** All that stands around the picture: a mesh's preview, where there is one at hand, is drawn before. */
function buildPage() {
  const page = new Page({ store, facts, app, tables }, canvas);
  new Tools(app, canvas);
  listenToDrops(app);
  listenToKeys(app, page.dialogs.help);
  listenToClipboard(app);
  listenToLaunches(app);
  if (beside === null) page.chooseSecond();
}

/** @type {import("./lighting/lighting.js").MakeLighting} */
function makeLighting(renderer, layer) {
  return new Lighting(renderer, layer, host.directions);
}

/** @param {HTMLCanvasElement} on @param {import("./state/status.js").Status["camera"]} camera @param {Promise<unknown>} [free] @returns {import("./scene/scene_like.js").SceneLike} */
function makeScene(on, camera, free) {
  return lack ? new BlankScene(camera) : new Scene(on, camera, makeLighting, free);
}

/** @returns {{ scene: import("./scene/scene_like.js").SceneLike, lack: string }} one that draws nothing where the browser lacks WebGL 2 */
function firstScene() {
  const { camera } = store.status;
  try {
    return { scene: new Scene(canvas, camera, makeLighting, idle), lack: "" };
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    return {
      scene: new BlankScene(camera),
      lack: `This browser can't draw the mesh (WebGL 2: ${reason}); its tables are here all the same`,
    };
  }
}

/** `?mesh=source/mesh` or `?mesh=address`, `&with=` another of these, and the status in the hash. */
async function openWhatTheAddressNames() {
  const status = await statusFromHash(location.hash).catch((error) => void app.messages.error(error));
  if (isEntry(addressed)) await app.openEntry(...pair(addressed), status);
  else if (addressed) await app.openUrl(addressed, status);
  else if (status) await app.documents.apply(status);
  if (addressed && beside) {
    if (isEntry(beside)) await app.comparing.openEntry(...pair(beside));
    else await app.comparing.openUrl(beside);
  }
  if (addressed) await app.lastFiles.recall();
}

// A link to this very page with other settings, pasted into its address, changes nothing but the hash.
addEventListener("hashchange", async () => {
  try {
    const status = await statusFromHash(location.hash);
    if (status) await app.documents.apply(status);
  } catch (error) {
    app.messages.error(error, { topic: "status" });
  }
});

/** Whether it names a mesh of the catalogue. @param {string} path */
function isEntry(path) {
  return /^[\w.-]+\/[\w.-]+$/.test(path);
}

/** @param {string} path @returns {[string, string]} */
function pair(path) {
  const [source, mesh] = path.split("/");
  return [source, mesh];
}
