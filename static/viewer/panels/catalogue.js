import { count } from "../state/numbers.js";
import { fill } from "../widgets/choice.js";
import { watch } from "../widgets/bind.js";
import { h } from "../widgets/dom.js";

/** @typedef {import("../widgets/bind.js").Context} Context @typedef {import("../state/entry.js").CatalogueSource} Source */

/**
 * Choose a source, then one of its meshes (SPEC C4); where the open mesh comes from the catalogue, its reference stands below.
 *
 * @param {Context} context
 */
export function catalogueChooser(context) {
  const { facts, app } = context;
  const sources = h("select", {
    id: "catalogue-source",
    class: "choice",
    onchange: () => app.chooseSource(sources.value).then(show),
  });
  const meshes = h("select", {
    id: "catalogue-mesh",
    class: "choice",
    onchange: () => app.chooseEntry(sources.value, meshes.value).then(show),
  });
  const rows = [
    h(
      "div",
      { class: "row row-wide" },
      h("label", { class: "row-label", for: sources.id }, "Source"),
      sources,
    ),
    h("div", { class: "row row-wide" }, h("label", { class: "row-label", for: meshes.id }, "Mesh"), meshes),
  ];
  const reference = h("div", { class: "reference" });
  const element = h("div", { class: "catalogue-chooser" }, ...rows, reference);

  /** What is on the screen. */
  function show() {
    const catalogue = facts.get("catalogue");
    const source = facts.get("source");
    const entry = facts.get("entry");
    for (const row of rows) row.hidden = !catalogue?.sources.length;
    rows[1].hidden ||= !source;
    fill(sources, sourceOptions(catalogue, entry ? "" : (facts.get("summary")?.name ?? "")));
    sources.value = source?.slug ?? "";
    fill(meshes, meshOptions(source));
    meshes.value = entry && entry.source.slug === source?.slug ? entry.mesh.slug : "";
    reference.replaceChildren(...(entry ? shortReference(entry.source) : []));
  }
  watch(context, { facts: ["catalogue", "source", "entry", "summary"] }, show);
  return element;
}

/** @param {import("../state/entry.js").Index | null} catalogue @param {string} local name of the file that is open, if it is not the catalogue's */
export function sourceOptions(catalogue, local) {
  const first = { value: "", name: local ? `File: ${local}` : "Choose a source…" };
  const rows = (catalogue?.sources ?? []).map((source) => ({
    value: source.slug,
    name: `${source.year ? `${source.year} · ` : ""}${source.title}`,
  }));
  return [first, ...rows];
}

/** @param {Source | null} source */
export function meshOptions(source) {
  const rows = (source?.meshes ?? []).map((mesh) => ({
    value: mesh.slug,
    name: mesh.cells ? `${mesh.name} (${count(mesh.cells)})` : mesh.name,
  }));
  return [{ value: "", name: "Choose a mesh…" }, ...rows];
}

/** Authors in one line, where and when, links. @param {Source} source */
function shortReference(source) {
  const authors = source.authors.join(", ");
  const place = [source.venue, source.year].filter(Boolean).join(", ");
  return [
    authors ? h("p", { class: "reference-line quiet", title: authors }, authors) : h("p"),
    h(
      "p",
      { class: "links" },
      h("span", { class: "reference-line quiet", title: place }, place),
      ...linksOf(source),
    ),
  ];
}

/** The whole reference. @param {Source} source */
export function referenceOf(source) {
  const authors = source.authors.join(", ");
  const place = [source.venue, source.year].filter(Boolean).join(", ");
  return h(
    "div",
    {},
    h("p", { class: "reference-title" }, source.title),
    h("p", { class: "quiet" }, [authors, place].filter(Boolean).join(". ")),
    h("p", { class: "links" }, ...linksOf(source)),
  );
}

/** Links to the paper, only to http(s) addresses. @param {Source} source */
function linksOf(source) {
  const links = [
    ["DOI", source.doi && `https://doi.org/${source.doi}`],
    ["PDF", source.pdf],
    ["Web", source.web],
  ];
  return links
    .filter(([, address]) => /^https?:\/\//.test(address ?? ""))
    .map(([name, address]) => h("a", { href: address, target: "_blank", rel: "noopener" }, name));
}
