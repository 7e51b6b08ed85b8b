import { count } from "../state/numbers.js";
import { fill } from "../widgets/choice.js";
import { watch } from "../widgets/bind.js";
import { h, setText } from "../widgets/dom.js";
import { meshOptions, sourceOptions } from "./catalogue.js";

/** @typedef {import("../widgets/bind.js").Context} Context */

/**
 * Choose what the mesh is compared with: a file, a mesh of the catalogue, or what the core has at hand; then, what it is.
 *
 * @param {Context} context
 */
export function compareChoice(context) {
  const { app, facts } = context;
  const { comparing } = app;
  const tried = (/** @type {Promise<unknown>} */ opening) => opening.catch(() => {}).then(show); // said in a message by whoever failed
  const file = h("input", {
    type: "file",
    id: "compare-file",
    multiple: true,
    class: "visually-hidden",
    tabindex: -1,
    "aria-label": "Mesh or surface to compare with",
    onchange: () => {
      const files = [...(file.files ?? [])];
      file.value = "";
      if (files.length) void tried(comparing.openFiles(files));
    },
  });
  const open = h(
    "button",
    {
      type: "button",
      class: "button",
      id: "compare-open",
      title:
        "A second mesh; or a surface (STL, OBJ, OFF, PLY, ...) to measure distances to. Or drop it on the right half of the picture",
      onclick: () => file.click(),
    },
    "Open a file…",
  );
  let slug = "";
  const sources = h("select", {
    id: "compare-source",
    class: "choice",
    onchange: () => {
      slug = sources.value;
      const source = facts.get("catalogue")?.source(slug);
      if (source?.meshes.length === 1) void tried(comparing.openEntry(slug, source.meshes[0].slug));
      show();
    },
  });
  const meshes = h("select", {
    id: "compare-mesh",
    class: "choice",
    onchange: () => meshes.value && void tried(comparing.openEntry(slug, meshes.value)),
  });
  const offers = h("select", {
    id: "compare-offer",
    class: "choice",
    onchange: () => offers.value && void tried(comparing.openOffered(offers.value)),
  });
  const rows = {
    file: row("With", open, file),
    sources: row("Source", sources),
    meshes: row("Mesh", meshes),
    offers: row("File", offers),
  };
  const told = h("p", { class: "headline" });
  const element = h("div", { class: "compare-choice" }, ...Object.values(rows), told);

  function show() {
    const summary = facts.get("summary");
    const catalogue = facts.get("catalogue");
    const comparison = facts.get("comparison");
    const source = catalogue?.source(slug) ?? null;
    open.disabled = !summary;
    const others = facts.get("offers").filter(({ id }) => id !== facts.get("offered"));
    rows.sources.hidden = !summary || !comparing.possible || !catalogue?.sources.length;
    rows.meshes.hidden = rows.sources.hidden || !source;
    rows.offers.hidden = !summary || !others.length;
    fill(sources, sourceOptions(catalogue, ""));
    fill(meshes, meshOptions(source));
    fill(offers, [
      { value: "", name: "Choose a file…" },
      ...others.map(({ id, name }) => ({ value: id, name })),
    ]);
    sources.value = slug;
    const second = facts.get("second");
    const entry = second?.get("entry");
    meshes.value = entry && entry.source.slug === slug ? entry.mesh.slug : "";
    offers.value = second?.get("offered") ?? "";
    setText(told, comparison ? inWords(comparison) : "");
    told.hidden = !comparison;
  }
  watch(context, { facts: ["summary", "catalogue", "offers", "offered", "second", "comparison"] }, show);
  return element;
}

/** @param {string} label @param {...HTMLElement} controls */
function row(label, ...controls) {
  const [first] = controls;
  return h(
    "div",
    { class: "row row-wide" },
    h("label", { class: "row-label", for: first.id }, label),
    ...controls,
  );
}

/** What it is compared with, and whether cells can be told one by one. @param {import("../state/answers.js").Compared} told */
export function inWords({ name, same_cells: same, difference, surface, displacement }) {
  if (surface) {
    const volume = surface.closed ? "closed" : "open";
    return `${name}: a surface of ${count(surface.triangles)} triangles, ${volume}`;
  }
  if (!same) return `${name}: other cells (${difference})`;
  const moved = displacement?.moved ?? 0;
  return `${name}: the same cells, ${count(moved)} vertices moved`;
}
