import { s } from "./dom.js";

/** Icons as strokes on a 16 by 16 grid. @type {Record<string, string>} */
const STROKES = {
  open: "M2 12.5v-9h4l1.5 2H14v7z",
  share: "M4 9.5v4h8v-4M8 2v7.5M5 4.8 8 2l3 2.8",
  image: "M2.5 3h11v10h-11zM2.5 11l3.2-3.4 2.6 2.6 2-2 3.2 3M10.4 6h.1",
  help: "M6 6.2a2 2 0 1 1 2.9 1.8c-.6.3-.9.7-.9 1.5M8 12v.1",
  undo: "M3 7h6.5a3.5 3.5 0 0 1 0 7H7M6 4 3 7l3 3",
  redo: "M13 7H6.5a3.5 3.5 0 0 0 0 7H9M10 4l3 3-3 3",
  home: "M3 7.5 8 3l5 4.5M4.5 6.5V13h7V6.5",
  view: "M1.5 8S4 3.8 8 3.8 14.5 8 14.5 8 12 12.2 8 12.2 1.5 8 1.5 8zM8 6.2a1.8 1.8 0 1 1 0 3.6 1.8 1.8 0 0 1 0-3.6",
  invert: "M2.5 5.5h10M10 3l2.5 2.5L10 8M13.5 10.5h-10M6 8l-2.5 2.5L6 13",
  dig: "M3 4.5 8 2l5 2.5v6.5L8 14l-5-3zM6 7.5h4",
  undig: "M3 4.5 8 2l5 2.5v6.5L8 14l-5-3zM6 7.5h4M8 5.5v4",
  isolate: "M6 6h4v4H6zM2 5V2h3M11 2h3v3M14 11v3h-3M5 14H2v-3",
  clear: "M4 4l8 8M12 4l-8 8",
  plus: "M8 3.5v9M3.5 8h9",
  minus: "M3.5 8h9",
  copy: "M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3",
  save: "M8 2.5v7.5M5 7.2 8 10l3-2.8M3 13.5h10",
  inspect: "M7 2.5a4.5 4.5 0 1 1 0 9 4.5 4.5 0 0 1 0-9M10.3 10.3 14 14",
  flip: "M3 13V8M6.3 13V3.5M9.7 13V6M13 13v-3",
  target: "M8 3a5 5 0 1 1 0 10A5 5 0 0 1 8 3M8 1v4M8 11v4M1 8h4M11 8h4",
  fit: "M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3M5.5 6h5v4h-5z",
  swap: "M2.5 5.5h11M10.5 2.5l3 3-3 3M13.5 10.5h-11M5.5 7.5l-3 3 3 3",
  edit: "M3 13l.6-2.8L11 2.8 13.2 5 5.8 12.4z",
};

/** @param {string} name */
export function icon(name) {
  const path = s("path", { d: STROKES[name] });
  return s("svg", { class: "icon", viewBox: "0 0 16 16", "aria-hidden": "true" }, path);
}
