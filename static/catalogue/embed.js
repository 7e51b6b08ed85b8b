/**
 * The poster of a mesh that another page shows in a frame: nothing but a picture is loaded until somebody asks for the mesh.
 * The frame's address says which (`?mesh=source/mesh`, or an address), under which settings (its hash), and who embeds it
 * (`origin=`, see the viewer's `app/parent.js`).
 */

/** A mesh of the catalogue. */
const ENTRY = /^[\w.-]+\/[\w.-]+$/;

/** @param {Document} page @param {Location} location */
function show(page, location) {
  const asked = new URLSearchParams(location.search);
  const mesh = asked.get("mesh") ?? "";
  const root = new URL(page.body.dataset.root || "../", location.href);
  const link = page.getElementById("load");
  const name = page.getElementById("name");
  if (!(link instanceof HTMLAnchorElement) || !name) return;
  asked.set("embed", "");
  const viewer = new URL("viewer/", root);
  viewer.search = asked.toString();
  viewer.hash = location.hash;
  link.href = viewer.href;
  name.textContent = asked.get("title") || mesh.split("/").pop() || "HexaLab";
  if (!ENTRY.test(mesh)) return;
  const poster = page.createElement("img");
  poster.className = "embed-poster";
  poster.alt = "";
  poster.addEventListener("error", () => poster.remove()); // the catalogue has no picture of it
  poster.src = new URL(`pictures/${mesh}.png`, root).href;
  link.prepend(poster);
}

show(document, location);
