import { beside } from "../charts/steps.js";
import { categoryColour, mapColours } from "../colours/palettes.js";
import { chosenKeys } from "../state/structure.js";
import { composed, textOf } from "../figure/compose.js";
import { FAMILY, INK } from "../figure/legend.js";
import { keysOf } from "../figure/keys.js";
import { layOut, wrapped } from "../figure/layout.js";
import { cutTo, LARGEST } from "../figure/cut.js";
import { FigureSides } from "./figure_sides.js";
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

  /** CSS pixels that what a figure shows takes on the screen. */
  get shown() {
    const apart = this.#app.store.status.figure.meshes === "apart";
    return new FigureSides(this.#app, apart ? "first" : "both").shown;
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

  /**
   * Make the figure that the status asks for.
   *
   * @param {Size | null} [wanted] in pixels, instead of what the status asks for
   * @param {import("./figure_sides.js").Which} [which] of two meshes that are compared
   * @returns {Promise<Made>}
   */
  async make(wanted = null, which = "both") {
    const { store, tables } = this.#app;
    await this.#app.drawing.drawn();
    const { status } = store;
    const { figure: asked } = status;
    const panels = panelsOf(status, tables.choices);
    const sides = new FigureSides(this.#app, which);
    const labels = sides.labels(panels.length, panels.length > 1 && asked.panels.labels);
    const count = panels.length * sides.perPose;
    let { width, height, point } = this.size(sides.shown, wanted);
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
      panels: count,
      lettered: labels.length > 0,
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
      const content = await this.#content(panels, box, sides);
      if (content) {
        const cut = cutTo(content, box);
        take = cut;
        width -= count * (box.width - cut.part.width);
        height -= box.height - cut.part.height;
        layout = layOut({ ...laid, width, height });
        [box] = layout.pictures;
      }
    }
    const pictures = await this.#pictures(panels, take, asked.transparent, sides);
    const { scene, facts } = this.#app;
    const diagonal = facts.get("summary")?.diagonal ?? 1;
    const ownPlaces = sides.perPose > 1 && !facts.get("together"); // then a length of the first is none of the second
    const half = scene.halfHeight(take.whole.width / take.whole.height);
    return {
      pictures,
      figure: {
        width,
        height,
        background: asked.transparent ? "none" : status.background,
        layout,
        style,
        labels,
        scale,
        scaleBar: asked.scale_bar
          ? {
              corner: ownPlaces ? inFirst(asked.scale_bar_place) : asked.scale_bar_place,
              pixels: take.whole.height / (2 * half * diagonal),
              unit: unitOf(status, 1),
            }
          : null,
        axes: asked.axes ? { corner: asked.axes_place, tips: this.#tips() } : null,
        caption,
      },
    };
  }

  /**
   * The figure as a file; a PNG carries the status.
   *
   * @param {FigureFormat} format @param {Size | null} [wanted] @param {import("./figure_sides.js").Which} [which] of two meshes that
   *   are compared
   * @returns {Promise<Blob>}
   */
  async file(format, wanted = null, which = "both") {
    const { figure, pictures } = await this.make(wanted, which);
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
   * @param {{ whole: { width: number, height: number }, part: Box | null }} take @param {boolean} transparent @param {FigureSides} sides
   */
  async #pictures(panels, { whole, part }, transparent, sides) {
    const { figure: _, unit: __, ...seen } = this.#app.store.status;
    const key = JSON.stringify([seen, panels, whole, part, transparent, sides.key]);
    if (this.#last?.key !== key) {
      const size = { width: Math.round(whole.width), height: Math.round(whole.height), transparent };
      const taken = await this.#take(panels, size, sides);
      const pictures = part ? await Promise.all(taken.map((one) => cropped(one, part))) : taken;
      this.#last = { key, pictures };
    }
    return this.#last.pictures;
  }

  /** @param {readonly import("../state/status.js").PartialStatus[]} panels @param {Box} box @param {FigureSides} sides */
  async #content(panels, { width, height }, sides) {
    const scale = LOOKED_AT / Math.max(width, height);
    const size = {
      width: Math.max(1, Math.round(width * scale)),
      height: Math.max(1, Math.round(height * scale)),
      transparent: true,
    };
    // Where something is does not depend on light, which takes its time.
    const unlit = panels.map((panel) => ({ ...panel, lighting: /** @type {const} */ ({ mode: "none" }) }));
    return contentOf(await this.#take(unlit, size, sides));
  }

  /** Pictures of each panel. @param {readonly import("../state/status.js").PartialStatus[]} panels @param {import("./figure_sides.js").Size} size @param {FigureSides} sides */
  async #take(panels, size, sides) {
    return (await posed(this.#app, panels, () => sides.take(size))).flat();
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
    const own = await client.call("histogram", [quantity.id, asked]);
    const data = { ...own, beside: await this.#beside(own, quantity.id, asked) };
    const highFirst = facts.get("colour")?.high_first ?? false;
    return {
      data,
      colour: mapColours(colour, highFirst),
      keys: keysOf(data, colour, highFirst),
      acceptable: quantity.acceptable,
      title: figure.legend_title || titled(quantity.name, quantity.unit) || facts.get("colour")?.label || "",
    };
  }

  /** The same counts of a second mesh. @param {import("../state/answers.js").Histogram} own @param {string} quantity @param {number} bins */
  async #beside(own, quantity, bins) {
    const { second } = this.#app.comparing;
    if (!second) return null;
    const other = await second.client.call("histogram", [quantity, bins]).catch(() => null); // it lacks the attribute
    return other && beside(own, other);
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
    const second = facts.get("second");
    const first = whereFrom(facts);
    if (second) return `A: ${first}${first.endsWith(".") ? "" : ";"} B: ${whereFrom(second)}`;
    return first;
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

/** A mesh, and its reference if it is the catalogue's. @param {import("../state/facts.js").Facts} facts */
function whereFrom(facts) {
  const entry = facts.get("entry");
  if (!entry) return facts.get("summary")?.name ?? "";
  return `${entry.mesh.name}. ${inOneLine(entry.source, true)}`;
}

/** The same corner at the left, where the first picture is. @param {import("../figure/overlay.js").Corner} corner */
function inFirst(corner) {
  return corner.startsWith("top") ? "top_left" : "bottom_left";
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
