import { count, counted, decimal } from "../state/numbers.js";
import { measured } from "../state/units.js";
import { h, setText } from "../widgets/dom.js";

/**
 * @typedef {import("../exchange/sheet.js").Sheet} Sheet
 * @typedef {import("./shown.js").Shown} Shown
 */

/**
 * What stands around the picture: legend, quantity, slice, what is under the pointer, where the mesh is from.
 *
 * @param {Sheet} sheet @param {Shown} shown @param {HTMLCanvasElement} canvas
 */
export function controls(sheet, shown, canvas) {
  const legend = h("img", { class: "legend", alt: "" });
  const counts = h("p", { class: "counts" });
  const pointed = h("p", { class: "pointed", role: "status" });

  function show() {
    const { cells } = shown.shot;
    const { name, legend: drawn } = shown.colouring;
    legend.src = drawn ? `data:image/svg+xml,${encodeURIComponent(drawn)}` : "";
    legend.hidden = !drawn;
    legend.alt = `Legend: ${name}`;
    setText(counts, `${count(cells)} of ${counted(sheet.about.cells, "cell")} shown`);
    setText(pointed, "");
    canvas.setAttribute("aria-label", `${sheet.about.name}, ${counts.textContent}, coloured by ${name}`);
  }

  const rows = [
    chooser(sheet, (place) => {
      shown.colour(place);
      show();
    }),
    slider(sheet, (place) => {
      shown.slice(place);
      show();
    }),
    h("button", { type: "button", class: "button", onclick: () => shown.reset() }, "Reset the view"),
  ];
  document.getElementById("controls")?.append(legend, ...rows.filter((row) => row !== null));
  document.getElementById("facts")?.append(counts, pointed);
  document.getElementById("links")?.append(...links(sheet.about));
  for (const event of /** @type {const} */ (["hover", "click"]))
    shown.on(event, (at) => setText(pointed, at ? inWords(shown, at) : ""));
  show();
}

/** @param {Sheet} sheet @param {(place: number) => void} choose */
function chooser({ colours }, choose) {
  if (colours.length < 2) return null;
  const select = h(
    "select",
    { id: "quantity", class: "choice", onchange: () => choose(select.selectedIndex) },
    ...colours.map(({ name }) => h("option", {}, name)),
  );
  return h("label", { class: "field", for: select.id }, h("span", {}, "Colour"), select);
}

/** @param {Sheet} sheet @param {(place: number) => void} choose */
function slider({ shots }, choose) {
  if (shots.length < 2) return null;
  const told = h("output", { class: "number", for: "slice" });
  const tell = (/** @type {number} */ place) => setText(told, decimal(shots[place].slice ?? 0, 2));
  const input = h("input", {
    id: "slice",
    class: "slider",
    type: "range",
    min: 0,
    max: shots.length - 1,
    step: 1,
    value: 0,
    oninput: () => {
      tell(input.valueAsNumber);
      input.setAttribute("aria-valuetext", told.value);
      choose(input.valueAsNumber);
    },
  });
  tell(0);
  return h("label", { class: "field", for: input.id }, h("span", {}, "Slice"), input, told);
}

/** @param {Shown} shown @param {{ x: number, y: number }} at */
function inWords(shown, { x, y }) {
  const hit = shown.cellAt(x, y);
  if (!hit) return "";
  const { name, unit } = shown.colouring;
  const value =
    hit.value === null ? "" : `, ${name} ${Number.isFinite(hit.value) ? measured(hit.value, unit) : "none"}`;
  return `cell ${hit.cell}${value}`;
}

/** Links that are web addresses. @param {Sheet["about"]} about @returns {HTMLElement[]} */
function links({ doi, link, version }) {
  const rows = [
    ["The paper", doi && `https://doi.org/${doi}`],
    ["Open in HexaLab", link],
  ];
  const found = rows
    .filter(([, address]) => /^https?:\/\//.test(address))
    .map(([name, address]) => h("a", { href: address, target: "_blank", rel: "noopener" }, name));
  return [...found, h("span", {}, `made by HexaLab ${version}`)];
}
