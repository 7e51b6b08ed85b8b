import { SURFACE_FORMATS } from "../exchange/formats.js";
import { FRAMES, MOST_FRAMES, MOST_SECONDS, MOST_SLICES, SECONDS } from "../state/leaving.js";
import { metricOf } from "../state/tables.js";
import { h } from "../widgets/dom.js";
import { numberField } from "../widgets/number_field.js";
import { STRUCTURE } from "./quantity_list.js";

/**
 * The ways in which a mesh leaves the page, as rows of a table.
 *
 * @typedef {import("../widgets/bind.js").Context} Context
 * @typedef {import("../state/leaving.js").Left} Left
 *
 * @typedef {object} Chosen
 * @property {string} format
 * @property {readonly string[]} quantities
 * @property {AbortSignal} signal
 * @property {(done: number, of: number) => void} report
 * @property {Record<string, number>} [numbers]
 * @property {boolean} [light]
 *
 * @typedef {object} Rows  further settings of a way
 * @property {HTMLElement} element
 * @property {() => void} begin the dialog opens
 * @property {(format: string) => void} show
 * @property {() => Partial<Chosen>} values
 *
 * @typedef {object} Way
 * @property {string} id
 * @property {string} name
 * @property {string} words what it is good for
 * @property {import("./quantity_list.js").Listed} quantities
 * @property {boolean} [stops] whether it can be stopped
 * @property {string} [first] the format that is chosen when nothing else is
 * @property {(context: Context) => readonly { id: string, name: string }[]} formats none: there is but one
 * @property {(context: Context) => Rows} rows
 * @property {(context: Context, chosen: Chosen) => Promise<Left>} save
 */

/** @type {readonly Way[]} */
export const WAYS = [
  {
    id: "cells",
    name: "The shown cells, as a mesh",
    words: "A mesh of its own for solvers and other programs; each cell can carry what was measured of it.",
    quantities: "whole",
    first: "vtu", // it has room for all that cells carry
    formats: ({ tables }) =>
      tables.writers.map(({ id, name, extension }) => ({ id, name: `${name} (${extension})` })),
    rows: () => none(),
    save: ({ app, tables }, { format, quantities }) =>
      app.leaving.cells(format, {
        metrics: quantities.filter((id) => metricOf(tables, id)),
        attributes: quantities.filter((id) => !metricOf(tables, id) && id !== STRUCTURE.value),
        structure: quantities.includes(STRUCTURE.value),
      }),
  },
  {
    id: "surface",
    name: "The shown surface, for 3D programs",
    words: "As it is drawn: colours at its corners, light from all around in them where you like.",
    quantities: "none",
    formats: () => SURFACE_FORMATS.map(({ id, name }) => ({ id, name: `${name} (.${id})` })),
    rows: lightRow,
    save: ({ app }, { format, light }) => app.leaving.surface(format, { light }),
  },
  {
    id: "page",
    name: "A page in one file",
    words: "Opens from a disk without a network: the mesh to turn, its colours, light, legend and reference.",
    quantities: "all",
    formats: () => [],
    rows: () =>
      numberRows([
        {
          id: "slices",
          label: "Slices",
          value: 1,
          range: [1, MOST_SLICES, 1],
          hint: "Places of the first slice to choose from, evenly from 0 on; 1: as it is now",
        },
      ]),
    async save({ app }, { quantities, numbers = {} }) {
      const { slices = 1 } = numbers;
      const places = slices > 1 ? Array.from({ length: slices }, (_, k) => k / slices) : [];
      const file = await app.singlePage.file({ metrics: quantities, slices: places });
      return { file, ending: "html", notes: [] };
    },
  },
  {
    id: "report",
    name: "A report",
    words:
      "What is known of the file: identity, findings, validity, quality by the file's own numbers. It prints well.",
    quantities: "none",
    formats: () => [
      { id: "html", name: "A page with pictures (.html)" },
      { id: "md", name: "Markdown (.md)" },
      { id: "json", name: "JSON (.json)" },
      { id: "xml", name: "JUnit XML (.xml)" },
    ],
    rows: () => none(),
    async save({ app }, { format }) {
      return { ...(await app.reports.file(format)), part: "-report" };
    },
  },
  {
    id: "turntable",
    name: "A turntable",
    words: "Pictures around the mesh, once about what is upright: an archive of them, or a video.",
    quantities: "none",
    stops: true,
    formats: () => [
      { id: "zip", name: "Pictures (.zip of PNG)" },
      { id: "webm", name: "Video (.webm)" },
      { id: "mp4", name: "Video (.mp4)" },
    ],
    rows: () =>
      numberRows([
        { id: "frames", label: "Pictures", value: FRAMES, range: [2, MOST_FRAMES, 1] },
        {
          id: "seconds",
          label: "Seconds",
          value: SECONDS,
          range: [1, MOST_SECONDS, 1],
          formats: ["webm", "mp4"],
        },
        { id: "width", label: "Width", value: 1280, range: [2, 4096, 2] },
        { id: "height", label: "Height", value: 960, range: [2, 4096, 2] },
      ]),
    async save({ app }, { format, numbers = {}, signal, report }) {
      const turn = /** @type {import("../state/leaving.js").TurnFormat} */ (format);
      const file = await app.turntable.file({ format: turn, ...numbers, signal, report });
      return { file, ending: format, notes: [] };
    },
  },
];

/** @returns {Rows} */
function none() {
  return { element: h("div", { hidden: true }), begin: () => {}, show: () => {}, values: () => ({}) };
}

/** @param {Context} context @returns {Rows} */
function lightRow({ app }) {
  const box = h("input", { type: "checkbox", id: "save-light" });
  const element = h("div", {}, h("label", { class: "check" }, box, h("span", {}, "Light in the colours")));
  return {
    element,
    begin: () => void (box.checked = app.leaving.lit),
    show(format) {
      const coloured = SURFACE_FORMATS.find(({ id }) => id === format)?.coloured ?? true;
      box.disabled = !coloured;
      element.title = coloured ? "" : "This format has no place for colours";
    },
    values: () => ({ light: box.checked }),
  };
}

/**
 * @typedef {{ id: string, label: string, value: number, range: readonly [number, number, number], hint?: string,
 *   formats?: readonly string[] }} NumberRow  formats: those that it is for; all without
 *
 * @param {readonly NumberRow[]} rows @returns {Rows}
 */
function numberRows(rows) {
  /** @type {Record<string, number>} */
  const numbers = Object.fromEntries(rows.map(({ id, value }) => [id, value]));
  const fields = rows.map(({ id, label, value, range, hint, formats }) => {
    const box = numberField({
      label,
      digits: 0,
      range: () => range,
      write: (typed) => void (numbers[id] = typed ?? numbers[id]),
    });
    box.show(value);
    const element = h("div", { class: "field", title: hint }, h("span", {}, label), box.element);
    return { element, formats };
  });
  return {
    element: h("div", { class: "fields" }, ...fields.map(({ element }) => element)),
    begin: () => {},
    show(format) {
      for (const { element, formats } of fields) element.hidden = formats ? !formats.includes(format) : false;
    },
    values: () => ({ numbers: { ...numbers } }),
  };
}
