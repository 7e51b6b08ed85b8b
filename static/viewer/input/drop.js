import { droppedFiles } from "./folders.js";

/** Files dropped anywhere in the window open. @param {import("../app/app.js").App} app */
export function listenToDrops(app) {
  let depth = 0;
  const show = (/** @type {boolean} */ on) => document.body.classList.toggle("dropping", on);
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
    if (event.dataTransfer) event.dataTransfer.dropEffect = "copy";
  });
  window.addEventListener("drop", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    depth = 0;
    show(false);
    if (event.dataTransfer) void open(app, event.dataTransfer);
  });
}

/** @param {import("../app/app.js").App} app @param {DataTransfer} transfer */
async function open(app, transfer) {
  try {
    const { files, more } = await droppedFiles(transfer);
    if (more)
      app.messages.say("note", "The folder holds more files than are looked at (2,000)", { topic: "drop" });
    if (files.length)
      await app.openFiles(files).catch(() => {}); // said in a message by whoever failed
    else app.messages.say("warning", "The folder holds no file", { topic: "drop" });
  } catch (error) {
    app.messages.error(error, { topic: "drop" });
  }
}
