/** @typedef {import("./index.js").Row} Row */

const NOT_KNOWN = "–";
const MARKS = /(?<=\w[_.]+)(?=[^\W_])/;
const count = new Intl.NumberFormat("en-GB");

/**
 * What was found as cards, like those that the page came with.
 *
 * @param {Row[]} rows
 * @param {string} root
 */
export function cards(rows, root) {
  const list = element("ul", "cards");
  for (const row of rows) {
    const link = element("a", "card-link");
    link.href = pageOf(row, root);
    const name = element("span", "card-name");
    name.append(...breakable(row.name));
    link.append(picture(row, root), name);
    const facts = element("span", "card-facts");
    if (row.cells !== null)
      facts.append(element("span", "", row.cells === 1 ? "1 cell" : `${number(row.cells)} cells`));
    if (row.low !== null) facts.append(element("span", "", `min SJ ${decimal(row.low)}`));
    if (VALIDITY[row.validity]?.[0] === "invalid")
      facts.append(element("span", "mark mark-invalid", "invalid"));
    const card = element("li", "card");
    card.append(link, element("span", "card-source", row.source.short), facts);
    list.append(card);
  }
  return list;
}

/**
 * What was found as a table.
 *
 * @param {Row[]} rows
 * @param {string} root
 */
export function table(rows, root) {
  const made = element("table", "meshes");
  const head = made.createTHead().insertRow();
  const heads = [["Name"], ["Source"], ...NUMBERS.map(([title]) => [title, "number"]), ["Validity"]];
  for (const [title, kind] of heads) {
    const cell = element("th", kind, title);
    cell.scope = "col";
    head.append(cell);
  }
  const body = made.createTBody();
  for (const row of rows) {
    const line = body.insertRow();
    const name = element("th");
    name.scope = "row";
    const link = element("a", "", row.name);
    link.href = pageOf(row, root);
    name.append(link);
    line.append(name, element("td", "", row.source.short));
    for (const [, text] of NUMBERS) line.append(element("td", "number", text(row)));
    const [state, word] = VALIDITY[row.validity];
    const cell = element("td");
    cell.append(element("span", `mark mark-${state}`, word));
    line.append(cell);
  }
  const scroll = element("section", "scroll");
  scroll.tabIndex = 0;
  scroll.setAttribute("aria-label", "Table of meshes");
  scroll.append(made);
  return scroll;
}

/** A name that breaks after its marks, if it has to: file names are long words. @param {string} name */
function breakable(name) {
  return name.split(MARKS).flatMap((part, index) => (index ? [element("wbr"), part] : [part]));
}

/** The table's columns of numbers: title, and what stands in a row. @type {[string, (row: Row) => string][]} */
const NUMBERS = [
  ["Cells", (row) => number(row.cells)],
  ["SJ min", (row) => decimal(row.low)],
  ["SJ mean", (row) => decimal(row.mean)],
  ["Irregular edges", (row) => number(row.irregular)],
  ["Sheets", (row) => number(row.sheets)],
  ["Blocks", (row) => number(row.blocks)],
];

/** The facet "validity", option by option: class of the mark and its word. */
const VALIDITY = [
  ["good", "valid"],
  ["positive", "SJ > 0"],
  ["invalid", "invalid"],
  ["warning", "undecided"],
  ["unknown", "not measured"],
];

/**
 * @param {Row} row
 * @param {string} root
 */
function picture(row, root) {
  const frame = element("span", row.picture ? "card-picture" : "card-picture is-empty");
  if (row.picture) {
    const image = element("img");
    image.src = `${root}pictures/${row.source.slug}/${row.slug}.${row.picture}`;
    image.alt = "";
    image.width = 480;
    image.height = 320;
    image.loading = "lazy";
    frame.append(image);
  } else {
    const words = row.low === null ? "not measured yet" : "Scaled Jacobian, −1 to 1";
    frame.append(range(row), element("span", "card-glyph-text", words));
  }
  return frame;
}

/** @param {Row} row */
function range(row) {
  const place = (/** @type {number} */ value) => (50 + 48 * Math.min(1, Math.max(-1, value))).toFixed(1);
  const glyph = document.createElementNS("http://www.w3.org/2000/svg", "svg");
  glyph.setAttribute("viewBox", "0 0 100 12");
  glyph.setAttribute("class", "range");
  glyph.setAttribute("aria-hidden", "true");
  const paths = [["range-axis", "M2 6H98"]];
  if (row.low !== null && row.mean !== null && row.high !== null) {
    paths.push(["range-zero", "M50 1V11"]);
    const bad = row.low <= 0 ? " is-bad" : "";
    paths.push([`range-bar${bad}`, `M${place(row.low)} 6H${place(row.high)}`]);
    paths.push(["range-mean", `M${place(row.mean)} 2V10`]);
  }
  for (const [name, data] of paths) {
    const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
    path.setAttribute("class", name);
    path.setAttribute("d", data);
    glyph.append(path);
  }
  return glyph;
}

/**
 * @param {Row} row
 * @param {string} root
 */
function pageOf(row, root) {
  return `${root}sources/${row.source.slug}/${row.slug}/index.html`;
}

/** @param {number | null} value */
function number(value) {
  return value === null ? NOT_KNOWN : count.format(value);
}

/**
 * Three decimals, an exponent where they would read 0: as the pages made at build write it.
 *
 * @param {number | null} value
 */
export function decimal(value) {
  if (value === null) return NOT_KNOWN;
  if (value === 0) return "0";
  const text = Math.abs(value) < 0.0005 ? value.toExponential(3) : value.toFixed(3);
  return text.replaceAll("-", "−");
}

/**
 * @template {keyof HTMLElementTagNameMap} T
 * @param {T} tag
 * @param {string} [name] class
 * @param {string} [text]
 * @returns {HTMLElementTagNameMap[T]}
 */
function element(tag, name = "", text = "") {
  const made = document.createElement(tag);
  if (name) made.className = name;
  if (text) made.textContent = text;
  return made;
}
