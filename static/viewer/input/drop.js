import { foundOf } from "../app/files.js";
import { droppedFiles } from "./folders.js";

/**
 * Files dropped anywhere in the window open; on the right half of the picture they are compared with the mesh that is open.
 *
 * @param {import("../app/app.js").App} app
 */
export function listenToDrops(app) {
  let depth = 0;
  const view = /** @type {HTMLElement} */ (document.getElementById("view"));
  const show = (/** @type {boolean} */ on) => {
    document.body.classList.toggle("dropping", on);
    view.classList.toggle("drop-two", on && app.facts.get("summary") !== null);
  };
  const onRight = (/** @type {DragEvent} */ { clientX, clientY }) => {
    const { left, right, top, bottom } = view.getBoundingClientRect();
    const within = clientX > (left + right) / 2 && clientX < right && clientY > top && clientY < bottom;
    return within && app.facts.get("summary") !== null;
  };
  const carriesFiles = (/** @type {DragEvent} */ event) =>
    [...(event.dataTransfer?.types ?? [])].includes("Files");

  window.addEventListener("dragenter", (event) => {
    if (!carriesFiles(event)) return;
    depth++;
    show(true);
  });
  window.addEventListener("dragleave", () => {
    depth = Math.max(0, depth - 1);
    if (!depth) show(false);
  });
  window.addEventListener("dragover", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    view.classList.toggle("drop-right", onRight(event));
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
  });
  window.addEventListener("drop", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    depth = 0;
    const beside = onRight(event);
    show(false);
    if (event.dataTransfer) void open(app, event.dataTransfer, beside);
  });
}

/** What is settings, a picture that carries them, or an archive, wherever it is dropped. */
const NO_MESH = /\.(json|png|zip)$/i;

/** @param {import("../app/app.js").App} app @param {DataTransfer} transfer @param {boolean} beside whether to compare with it */
async function open(app, transfer, beside) {
  try {
    const { files, more } = await droppedFiles(transfer);
    if (more)
      app.messages.say("note", "The folder holds more files than are looked at (2,000)", { topic: "drop" });
    const meshes = foundOf(files).flatMap(({ path, file }) => (NO_MESH.test(path) ? [] : [file]));
    if (beside && meshes.length) await app.comparing.openFiles(meshes).catch(() => {});
    else if (files.length)
      await app.openFiles(files).catch(() => {}); // said in a message by whoever failed
    else app.messages.say("warning", "The folder holds no file", { topic: "drop" });
  } catch (error) {
    app.messages.error(error, { topic: "drop" });
  }
}
