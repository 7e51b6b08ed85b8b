import { Messages } from "../app/messages.js";
import { Side } from "../app/side.js";
import { Tools } from "../input/tools.js";
import { inspector } from "../panels/inspector.js";
import { Facts } from "../state/facts.js";
import { SecondStore } from "../state/second_store.js";
import { h } from "../widgets/dom.js";
import { cellLabel } from "./cell_label.js";
import { followSize } from "./canvas_size.js";
import { pictureInWords } from "./picture_in_words.js";
import { progressBar } from "./progress_bar.js";

/**
 * The part of the view where a second mesh is, beside the first or upon it; with a core and a scene of its own.
 *
 * @param {object} parts
 * @param {import("../app/app.js").App} parts.first
 * @param {() => import("../core/client.js").CoreClient} parts.another starts a core
 * @param {(canvas: HTMLCanvasElement, camera: import("../state/status.js").Status["camera"]) => import("../scene/scene_like.js").SceneLike} parts.makeScene
 * @returns {import("../app/comparing.js").Second}
 */
export function secondPane({ first, another, makeScene }) {
  const ending = new AbortController();
  const caption = h("p", { class: "visually-hidden", id: "second-picture-in-words" });
  const canvas = h("canvas", {
    class: "canvas",
    id: "second-canvas",
    tabindex: 0,
    role: "img",
    "aria-label": "No second mesh is open",
    "aria-describedby": caption.id,
  });
  const pane = h("div", { class: "pane pane-second", id: "second-pane" }, canvas, caption);
  document.getElementById("pane")?.after(pane);
  const store = new SecondStore(first.store);
  const facts = new Facts({ catalogue: first.facts.get("catalogue"), tool: first.facts.get("tool") });
  const client = another();
  const scene = makeScene(canvas, store.status.camera);
  const { tables, host } = first;
  const parts = { store, facts, client, scene, tables, canvas, host };
  const messages = new Messages(first.facts, "second ");
  const side = new Side(parts, messages);
  side.followCore();
  scene.on("camera", (camera) => store.set({ camera }, { undo: "camera" }));
  const context = { store, facts, app: side, tables };
  pane.append(progressBar(context), cellLabel(context, scene), inspector(context, "second-inspector-title"));
  pictureInWords(context, canvas, caption);
  new Tools(side, canvas, ending.signal);
  followSize(scene, canvas, facts, ending.signal);
  const lookApart = lookAtTheSame(first, side);
  const close = () => {
    ending.abort();
    lookApart();
    messages.end(); // that its core was closed under what was asked of it is no news
    store.stop();
    client.dispose();
    scene.dispose();
    pane.remove();
  };
  return Object.assign(side, { store, close });
}

/** Of meshes of the same cells the inspectors tell of the same one, where there is room for both. @param {import("../app/side.js").Side} first @param {import("../app/side.js").Side} second @returns {() => void} ends it */
function lookAtTheSame(first, second) {
  const wide = matchMedia("(min-width: 721px)");
  const follow = (
    /** @type {import("../app/side.js").Side} */ from,
    /** @type {import("../app/side.js").Side} */ to,
  ) =>
    from.facts.on("cell", (cell) => {
      const here = first.facts.get("second") === second.facts && first.facts.get("comparison")?.same_cells;
      const row = cell?.cell ?? null;
      if (here && wide.matches && row !== (to.facts.get("cell")?.cell ?? null)) void to.inspect(row);
    });
  const stops = [follow(first, second), follow(second, first)];
  return () => stops.forEach((stop) => stop());
}
