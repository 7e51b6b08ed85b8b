import { compare } from "../panels/compare.js";
import { drawing } from "../panels/drawing.js";
import { features } from "../panels/features.js";
import { filters } from "../panels/filters.js";
import { groups } from "../panels/groups.js";
import { inspector } from "../panels/inspector.js";
import { mesh } from "../panels/mesh.js";
import { quality } from "../panels/quality.js";
import { structure } from "../panels/structure.js";
import { surroundings } from "../panels/surroundings.js";
import { renderSection } from "../widgets/section.js";
import { bar } from "./bar.js";
import { tellChanges } from "./changes_told.js";
import { batchDialog } from "../dialogs/batch.js";
import { helpDialog } from "../dialogs/help.js";
import { imageDialog } from "../dialogs/image.js";
import { saveDialog } from "../dialogs/save.js";
import { shareDialog } from "../dialogs/share.js";
import { statusDialog } from "../dialogs/status_editor.js";
import { fitButton } from "./fit_button.js";
import { meshName } from "./mesh_name.js";
import { messageList } from "./message_list.js";
import { progressBar } from "./progress_bar.js";
import { cellLabel } from "./cell_label.js";
import { embeddedCorner } from "./embedded.js";
import { compareView } from "./compare_view.js";
import { centreBeside } from "./covered.js";
import { emptyState } from "./empty_state.js";
import { followSize } from "./canvas_size.js";
import { statusLine } from "./status_line.js";
import { portrait } from "./portrait.js";
import { pictureInWords } from "./picture_in_words.js";

/** The panel's sections, in their order. */
export const SECTIONS = [mesh, groups, filters, drawing, quality, features, structure, compare, surroundings];

/** Everything of the page around the canvas. */
export class Page {
  /** @param {import("../widgets/bind.js").Context} context @param {HTMLCanvasElement} canvas */
  constructor(context, canvas) {
    this.dialogs = {
      batch: batchDialog(context),
      help: helpDialog(context),
      image: imageDialog(context),
      save: saveDialog(context),
      share: shareDialog(context),
      status: statusDialog(context),
    };
    place("bar", ...bar(context, this.dialogs));
    meshName(context);
    place("panel", ...SECTIONS.map((section) => renderSection(context, section)));
    const cellInspector = inspector(context);
    place(
      "pane",
      portrait(context),
      progressBar(context),
      fitButton(context),
      cellLabel(context, context.app.scene),
      cellInspector,
    );
    place(
      "view",
      emptyState(context),
      messageList(context),
      ...(context.app.host.embedded ? [embeddedCorner(context)] : []),
    );
    place("status-line", ...statusLine(context));
    document.body.append(...Object.values(this.dialogs));
    pictureInWords(context, canvas, /** @type {HTMLElement} */ (document.getElementById("picture-in-words")));
    compareView(context);
    tellChanges(context, SECTIONS);
    centreBeside(context, cellInspector, canvas);
    followSize(context.app.scene, canvas, context.facts);
    followModality();
  }

  /** The reader came to choose what the mesh is compared with. */
  chooseSecond() {
    const section = /** @type {HTMLDetailsElement} */ (document.getElementById(`section-${compare.id}`));
    section.open = true;
    section.scrollIntoView({ block: "start" });
    document.getElementById("compare-open")?.focus();
  }
}

/** @param {string} id @param {...Node} nodes */
function place(id, ...nodes) {
  document.getElementById(id)?.append(...nodes);
}

/** The picture takes the focus when it is clicked; it shows that only to those who work by keyboard. */
function followModality() {
  const pointing = (/** @type {boolean} */ on) => () => document.body.classList.toggle("pointing", on);
  window.addEventListener("pointerdown", pointing(true), true);
  window.addEventListener("keydown", pointing(false), true);
}
