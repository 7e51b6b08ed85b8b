import { categoryColour, mapColours } from "../colours/palettes.js";
import { chosenKeys } from "../state/structure.js";
import { composed, textOf } from "../figure/compose.js";
import { FAMILY, INK } from "../figure/legend.js";
import { keysOf } from "../figure/keys.js";
import { layOut, wrapped } from "../figure/layout.js";
import { cutTo, LARGEST } from "../figure/cut.js";
import { contentOf, cropped, dataAddress, rasterised } from "../figure/raster.js";
import { writeStatus } from "../files/png_text.js";
import { groupKeys, groupName, groupsOf, originName } from "../state/groups.js";
import { KIND_NAMES, KINDS } from "../state/kinds.js";
import { inOneLine } from "../state/entry.js";
import { panelsOf } from "../state/panels.js";
import { posed } from "./posing.js";
import { quantityOf } from "../state/quantity.js";
import { titled, unitOf } from "../state/units.js";

/**
 * @typedef {import("../figure/compose.js").Figure} Figure
 * @typedef {import("../figure/layout.js").Box} Box
 * @typedef {"png" | "svg" | "pdf"} FigureFormat
 * @typedef {{ width?: number, height?: number }} Size
 *
 * @typedef {object} Made  a figure with its pictures
 * @property {Figure} figure
 * @property {Blob[]} pictures
 */

/** Pixels of the picture in which the content is looked for, along its longer side. */
const LOOKED_AT = 480;

/** Bins of the legend's bar, and of its histogram at most. */
const STEPS = 128;
const BARS = 60;

/** Groups that a legend names. */
const MOST_KEYS = 12;

/** Points to an inch, and pixels of the screen. */
const POINTS = 72;
const SCREEN = 96;
const MILLIMETRES = 25.4;

/** Width of a column of most journals, in mm: what a figure in mm is as wide as while no width is given. */
const COLUMN = 85;

/** Pictures with what stands around them: legend, scale bar, axes, caption, several in a row. */
export class Figures {
  #app;
  /** The pictures made last, and what they were made of. @type {{ key: string, pictures: Blob[] } | null} */
  #last = null;

  /** Pixels of the figure made last. */
  lastSize = { width: 0, height: 0 };

  /** @param {import("./app.js").App} app */
  constructor(app) {
    this.#app = app;
  }

  /**
   * Pixels of the figure, and of a point in it.
   *
   * @param {{ width: number, height: number }} canvas in CSS pixels
   * @param {Size | null} [wanted] in pixels, instead of what the status asks for
   */
  size(canvas, wanted = null) {
    const asked = this.#app.store.status.figure;
    const { unit, width, height, resolution } = wanted ? { ...asked, unit: "px", ...wanted } : asked;
    const shape = canvas.height / canvas.width;
    if (unit === "mm") {
      const dots = resolution / MILLIMETRES;
      const wide = (width ?? COLUMN) * dots;
      return { ...bounded(wide, (height ?? 0) * dots || wide * shape), point: resolution / POINTS };
    }
    const ratio = devicePixelRatio;
    const wide = width ?? canvas.width * ratio;
    const high = height ?? (width ? width * shape : canvas.height * ratio);
    return { ...bounded(wide, high), point: (SCREEN / POINTS) * (wide / canvas.width) };
  }

  /** Make the figure that the status asks for. @param {HTMLCanvasElement} canvas @param {Size | null} [wanted] @returns {Promise<Made>} */
  async make(canvas, wanted = null) {
    const { store, tables } = this.#app;
    await this.#app.drawing.drawn();
    const { status } = store;
    const { figure: asked } = status;
    const panels = panelsOf(status, tables.choices);
    let { width, height, point } = this.size(
      { width: canvas.clientWidth, height: canvas.clientHeight },
      wanted,
    );
    const style = {
      point,
      size: asked.letters,
      ink: INK,
      family: FAMILY,
      counts: asked.legend === "histogram",
    };
    const scale = asked.legend === "none" ? null : await this.scale();
    const measure = measureText(asked.letters * point);
    const caption = asked.caption ? wrapped(this.#caption(), width - 2 * asked.margin * point, measure) : [];
    const laid = {
      width,
      height,
      point,
      letters: asked.letters,
      margin: asked.margin,
      panels: panels.length,
      lettered: panels.length > 1 && asked.panels.labels,
      legend: !scale
        ? /** @type {const} */ ("none")
        : "data" in scale
          ? asked.legend
          : /** @type {const} */ ("list"),
      legendPlace: asked.legend_place,
      lines: caption.length,
    };
    let layout = layOut(laid);
    let [box] = layout.pictures;
    /** @type {{ whole: { width: number, height: number }, part: Box | null }} */
    let take = { whole: box, part: null };
    if (asked.crop) {
      const content = await this.#content(panels, box);
      if (content) {
        const cut = cutTo(content, box);
        take = cut;
        width -= panels.length * (box.width - cut.part.width);
        height -= box.height - cut.part.height;
        layout = layOut({ ...laid, width, height });
        [box] = layout.pictures;
      }
    }
    const pictures = await this.#pictures(panels, take, asked.transparent);
    const { scene, facts } = this.#app;
    const diagonal = facts.get("summary")?.diagonal ?? 1;
    const half = scene.halfHeight(take.whole.width / take.whole.height);
    return {
      pictures,
      figure: {
        width,
        height,
        background: asked.transparent ? "none" : status.background,
        layout,
        style,
        letters: laid.lettered,
        scale,
        scaleBar: asked.scale_bar
          ? {
              corner: asked.scale_bar_place,
              pixels: take.whole.height / (2 * half * diagonal),
              unit: unitOf(status, 1),
            }
          : null,
        axes: asked.axes ? { corner: asked.axes_place, tips: this.#tips() } : null,
        caption,
      },
    };
  }

  /** The figure as a file; a PNG carries the status. @param {FigureFormat} format @param {HTMLCanvasElement} canvas @param {Size | null} [wanted] @returns {Promise<Blob>} */
  async file(format, canvas, wanted = null) {
    const { figure, pictures } = await this.make(canvas, wanted);
    this.lastSize = { width: figure.width, height: figure.height };
    if (format === "png") {
      const placed = pictures.map((picture, k) => ({ picture, box: figure.layout.pictures[k] }));
      const png = await rasterised(figure, placed, textOf(composed(figure)));
      return writeStatus(png, JSON.stringify(this.#app.store.status));
    }
    const svg = composed(figure, await Promise.all(pictures.map(dataAddress)));
    if (format === "svg") return new Blob([textOf(svg)], { type: "image/svg+xml" });
    const { toPdf } = await import("../figure/pdf.js");
    const { point } = figure.style;
    return toPdf(svg, figure.width / point, figure.height / point);
  }

  /**
   * @param {readonly import("../state/status.js").PartialStatus[]} panels
   * @param {{ whole: { width: number, height: number }, part: Box | null }} take @param {boolean} transparent
   */
  async #pictures(panels, { whole, part }, transparent) {
    const { figure: _, unit: __, ...seen } = this.#app.store.status;
    const key = JSON.stringify([seen, panels, whole, part, transparent]);
    if (this.#last?.key !== key) {
      const size = { width: Math.round(whole.width), height: Math.round(whole.height), transparent };
      const taken = await this.#take(panels, size);
      const pictures = part ? await Promise.all(taken.map((one) => cropped(one, part))) : taken;
      this.#last = { key, pictures };
    }
    return this.#last.pictures;
  }

  /** @param {readonly import("../state/status.js").PartialStatus[]} panels @param {Box} box */
  async #content(panels, { width, height }) {
    const scale = LOOKED_AT / Math.max(width, height);
    const size = {
      width: Math.max(1, Math.round(width * scale)),
      height: Math.max(1, Math.round(height * scale)),
      transparent: true,
    };
    // Where something is does not depend on light, which takes its time.
    const unlit = panels.map((panel) => ({ ...panel, lighting: /** @type {const} */ ({ mode: "none" }) }));
    return contentOf(await this.#take(unlit, size));
  }

  /** A picture of each panel. @param {readonly import("../state/status.js").PartialStatus[]} panels @param {{ width: number, height: number, transparent: boolean }} size */
  #take(panels, size) {
    return posed(this.#app, panels, () => this.#app.scene.screenshot(size));
  }

  /** What the legend tells. @param {number} [bins] of its histogram @returns {Promise<Figure["scale"]>} */
  async scale(bins) {
    const { store, client, facts } = this.#app;
    const { colour, figure, histogram } = store.status;
    if (colour.by === "sides")
      return {
        title: figure.legend_title,
        colours: [
          { colour: colour.outside, name: "boundary" },
          { colour: colour.inside, name: "inside" },
        ],
      };
    if (colour.by === "group") return { title: this.#groupTitle(), colours: this.#groupColours() };
    if (colour.by === "block") return null; // too many, and none has a name
    if (colour.by === "chosen")
      return { title: figure.legend_title, colours: chosenKeys(store.status.structure) };
    if (colour.by === "kind" || colour.by === "part")
      return { title: figure.legend_title, colours: this.#categories(colour.by) };
    const quantity = quantityOf(this.#app);
    const asked = bins ?? (figure.legend === "bar" ? STEPS : Math.min(BARS, histogram.bins));
    const data = await client.call("histogram", [quantity.id, asked]);
    const highFirst = facts.get("colour")?.high_first ?? false;
    return {
      data,
      colour: mapColours(colour, highFirst),
      keys: keysOf(data, colour, highFirst),
      acceptable: quantity.acceptable,
      title: figure.legend_title || titled(quantity.name, quantity.unit) || facts.get("colour")?.label || "",
    };
  }

  /** @param {"kind" | "part"} by */
  #categories(by) {
    const description = this.#app.facts.get("description");
    if (by === "kind")
      return KINDS.filter((kind) => description?.shapes?.[kind]).map((kind) => ({
        colour: categoryColour("kind", KINDS.indexOf(kind)),
        name: KIND_NAMES[kind][1],
      }));
    return (description?.part_cells ?? []).slice(0, 8).map((_, part) => ({
      colour: categoryColour("part", part),
      name: `part ${part + 1}`,
    }));
  }

  #groupTitle() {
    const { store, facts } = this.#app;
    return store.status.figure.legend_title || originName(facts.get("colour")?.label ?? "");
  }

  /** Colours of the groups, of the largest where there are many; what is in none is grey. */
  #groupColours() {
    const { store, facts } = this.#app;
    const drawn = facts.get("colour");
    const { keys, more } = groupKeys(drawn, groupsOf(facts), MOST_KEYS);
    return [
      ...keys.map(({ colour, group }) => ({
        colour: categoryColour("group", colour),
        name: groupName(group),
      })),
      ...(more > 0 ? [{ colour: store.status.background, name: `and ${more} more` }] : []),
      ...(drawn?.without ? [{ colour: store.status.colour.missing, name: "in none" }] : []),
    ];
  }

  /** The mesh and where it comes from, or what was typed. */
  #caption() {
    const { store, facts } = this.#app;
    const own = store.status.figure.caption_text.trim();
    if (own) return own;
    const entry = facts.get("entry");
    if (!entry) return facts.get("summary")?.name ?? "";
    return `${entry.mesh.name}. ${inOneLine(entry.source, true)}`;
  }

  /** Tips of the axes in the view's frame. @returns {[number, number, number][]} */
  #tips() {
    const { direction, up } = this.#app.scene.camera;
    const right = [
      direction[1] * up[2] - direction[2] * up[1],
      direction[2] * up[0] - direction[0] * up[2],
      direction[0] * up[1] - direction[1] * up[0],
    ];
    return [0, 1, 2].map((axis) => [right[axis], up[axis], -direction[axis]]);
  }
}

/** @param {number} width @param {number} height */
function bounded(width, height) {
  const most = Math.min(1, LARGEST / Math.max(width, height));
  return { width: Math.max(1, Math.round(width * most)), height: Math.max(1, Math.round(height * most)) };
}

/** Width of a text in letters of a size. @param {number} letter @returns {(text: string) => number} */
function measureText(letter) {
  const pen = document.createElement("canvas").getContext("2d");
  if (pen) pen.font = `${letter}px ${FAMILY}`;
  return (text) => pen?.measureText(text).width ?? 0.56 * letter * text.length;
}
