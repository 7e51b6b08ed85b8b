import { sizeBefore } from "../scene/camera/portrait.js";
import { h } from "../widgets/dom.js";

/** The portrait of a mesh that is on its way: where the mesh will be, or aside of the one that is open. @param {import("../widgets/bind.js").MeshContext} context */
export function portrait({ facts, store }) {
  const element = h("div", { class: "portrait" });

  function show() {
    const shown = facts.get("portrait");
    element.classList.toggle("portrait-on", shown !== null);
    if (!shown) return; // it fades as it is
    element.classList.toggle("portrait-aside", shown.aside);
    if (!element.contains(shown.image))
      element.replaceChildren(shown.image, h("p", { class: "portrait-name" }, shown.entry.mesh.name));
    element.style.setProperty("--backdrop", store.status.background);
    place();
  }

  function place() {
    const shown = facts.get("portrait");
    const canvas = facts.get("canvas");
    if (!shown || !canvas) return;
    const { naturalWidth, naturalHeight } = shown.image;
    const picture = { width: naturalWidth, height: naturalHeight };
    const { width, height } = shown.size ?? sizeBefore(picture, shown.taken, canvas);
    element.style.setProperty("--portrait-width", `${width}px`);
    element.style.setProperty("--portrait-height", `${height}px`);
  }

  // At once, unlike what is watched: the last size is set when it goes, and it moves there while it fades.
  facts.on("portrait", show);
  facts.on("canvas", place);
  show();
  return element;
}
