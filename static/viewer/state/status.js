/**
 * The status document: all settings of a view. What each means, its limits and its default say the core's schema
 * (hexalab.status.schema), from which this file is made: renew it with tests/core/status/status_types.py.
 *
 * @typedef {{
 *   readonly version: 2,
 *   readonly mesh: {
 *     readonly name: string,
 *     readonly sha256: string,
 *     readonly cells: number,
 *   },
 *   readonly unit: "none" | "nm" | "um" | "mm" | "cm" | "m" | "km" | "in" | "ft",
 *   readonly camera: {
 *     readonly fit: boolean,
 *     readonly target: readonly [number, number, number],
 *     readonly direction: readonly [number, number, number],
 *     readonly up: readonly [number, number, number],
 *     readonly distance: number,
 *     readonly projection: "perspective" | "orthographic",
 *     readonly field_of_view: number,
 *   },
 *   readonly filters: {
 *     readonly planes: {
 *       readonly enabled: boolean,
 *       readonly rule: "barycentre" | "any_corner",
 *       readonly items: readonly {
 *         readonly enabled: boolean,
 *         readonly normal: readonly [number, number, number],
 *         readonly offset: number,
 *       }[],
 *     },
 *     readonly peel: {
 *       readonly enabled: boolean,
 *       readonly depth: number,
 *     },
 *     readonly regularisation: {
 *       readonly enabled: boolean,
 *       readonly strength: number,
 *     },
 *     readonly quality: {
 *       readonly enabled: boolean,
 *       readonly items: readonly {
 *         readonly quantity: string,
 *         readonly keep: "inside" | "outside",
 *         readonly minimum: number | null,
 *         readonly maximum: number | null,
 *       }[],
 *     },
 *     readonly parts: {
 *       readonly enabled: boolean,
 *       readonly isolated: boolean,
 *       readonly hidden: readonly number[],
 *       readonly shown: readonly number[],
 *     },
 *     readonly groups: {
 *       readonly enabled: boolean,
 *       readonly isolated: boolean,
 *       readonly hidden: readonly string[],
 *       readonly shown: readonly string[],
 *     },
 *     readonly structure: {
 *       readonly enabled: boolean,
 *       readonly keep: "inside" | "outside",
 *       readonly complex: "whole" | "interior",
 *       readonly blocks: readonly number[],
 *       readonly sheets: readonly number[],
 *       readonly chords: readonly number[],
 *     },
 *     readonly picking: {
 *       readonly enabled: boolean,
 *       readonly isolated: boolean,
 *       readonly hidden: readonly number[],
 *       readonly shown: readonly number[],
 *     },
 *   },
 *   readonly separation: {
 *     readonly mode: "lines" | "darkness_coded_edges" | "fissure" | "rounded",
 *     readonly line_opacity: number,
 *     readonly gap: number,
 *     readonly radius: number,
 *     readonly line_width: number,
 *   },
 *   readonly colour: {
 *     readonly by: "sides" | "quality" | "attribute" | "kind" | "part" | "group" | "block" | "chosen",
 *     readonly outside: string,
 *     readonly inside: string,
 *     readonly metric: string,
 *     readonly attribute: string,
 *     readonly grouping: string,
 *     readonly map: "parula" | "viridis" | "jet" | "red_blue" | "diverging",
 *     readonly reversed: boolean,
 *     readonly steps: number,
 *     readonly missing: string,
 *     readonly beyond: boolean,
 *     readonly above: string,
 *     readonly below: string,
 *     readonly range: readonly [number, number] | null,
 *     readonly reach: readonly [number, number] | null,
 *   },
 *   readonly silhouette: number,
 *   readonly see_through: {
 *     readonly cells: "none" | "all" | "cut" | "quality" | "parts" | "groups" | "structure" | "picking",
 *     readonly opacity: number,
 *   },
 *   readonly marks: {
 *     readonly corners: boolean,
 *     readonly edges: boolean,
 *     readonly faces: boolean,
 *     readonly hidden: readonly string[],
 *     readonly sharp_angle: number,
 *     readonly nodes: readonly string[],
 *     readonly interfaces: string,
 *   },
 *   readonly arrows: {
 *     readonly attribute: string,
 *     readonly length: number,
 *     readonly colour: string,
 *   },
 *   readonly irregular: {
 *     readonly mode: number,
 *     readonly boundary: boolean,
 *     readonly palette: "standard" | "colour_blind",
 *   },
 *   readonly structure: {
 *     readonly kind: "none" | "arcs" | "sheets" | "chords" | "blocks",
 *     readonly chosen: readonly number[],
 *     readonly form: "cells" | "surfaces",
 *     readonly complex: "whole" | "interior",
 *     readonly boundary: boolean,
 *     readonly curves: boolean,
 *     readonly explode: number,
 *   },
 *   readonly compare: {
 *     readonly other: {
 *       readonly name: string,
 *       readonly sha256: string,
 *       readonly cells: number,
 *     },
 *     readonly layout: "beside" | "curtain",
 *     readonly divider: number,
 *     readonly camera: "auto" | "own" | "same",
 *     readonly colours: "common" | "own",
 *     readonly picking: {
 *       readonly isolated: boolean,
 *       readonly hidden: readonly number[],
 *       readonly shown: readonly number[],
 *     },
 *     readonly reference: {
 *       readonly shown: boolean,
 *       readonly opacity: number,
 *       readonly colour: string,
 *     },
 *     readonly labels: boolean,
 *   },
 *   readonly lighting: {
 *     readonly mode: "object_space_ao" | "screen_space_ao" | "direct" | "none",
 *     readonly shade: number,
 *   },
 *   readonly background: string,
 *   readonly histogram: {
 *     readonly orientation: "horizontal" | "vertical",
 *     readonly scale: "linear" | "log",
 *     readonly bins: number,
 *     readonly title: string,
 *     readonly width: number,
 *     readonly height: number,
 *     readonly letters: number,
 *     readonly font: "sans" | "serif",
 *   },
 *   readonly figure: {
 *     readonly unit: "px" | "mm",
 *     readonly width: number | null,
 *     readonly height: number | null,
 *     readonly resolution: number,
 *     readonly letters: number,
 *     readonly margin: number,
 *     readonly transparent: boolean,
 *     readonly crop: boolean,
 *     readonly legend: "none" | "bar" | "histogram",
 *     readonly legend_place: "right" | "left",
 *     readonly legend_title: string,
 *     readonly scale_bar: boolean,
 *     readonly scale_bar_place: "bottom_left" | "bottom_right" | "top_left" | "top_right",
 *     readonly axes: boolean,
 *     readonly axes_place: "bottom_right" | "bottom_left" | "top_left" | "top_right",
 *     readonly caption: boolean,
 *     readonly caption_text: string,
 *     readonly meshes: "together" | "apart",
 *     readonly panels: {
 *       readonly setting: "none" | "peel" | "regularisation" | "irregular" | "separation" | "lighting" | "slice" | "silhouette" | "line_opacity",
 *       readonly values: readonly number[],
 *       readonly labels: boolean,
 *     },
 *   },
 * }} Status
 */

/**
 * A part of a document: any of its settings, at any depth. A list is a value, which a part replaces whole.
 *
 * @template T
 * @typedef {T extends readonly unknown[] | null ? T : T extends object ? { [K in keyof T]?: Part<T[K]> } : T} Part
 */

/** @typedef {Part<Status>} PartialStatus */

/**
 * The settings that are one word out of several, by their paths.
 *
 * @typedef {{
 *   "unit": Status["unit"],
 *   "camera.projection": Status["camera"]["projection"],
 *   "filters.planes.rule": Status["filters"]["planes"]["rule"],
 *   "filters.structure.keep": Status["filters"]["structure"]["keep"],
 *   "filters.structure.complex": Status["filters"]["structure"]["complex"],
 *   "separation.mode": Status["separation"]["mode"],
 *   "colour.by": Status["colour"]["by"],
 *   "colour.map": Status["colour"]["map"],
 *   "see_through.cells": Status["see_through"]["cells"],
 *   "irregular.palette": Status["irregular"]["palette"],
 *   "structure.kind": Status["structure"]["kind"],
 *   "structure.form": Status["structure"]["form"],
 *   "structure.complex": Status["structure"]["complex"],
 *   "compare.layout": Status["compare"]["layout"],
 *   "compare.camera": Status["compare"]["camera"],
 *   "compare.colours": Status["compare"]["colours"],
 *   "lighting.mode": Status["lighting"]["mode"],
 *   "histogram.orientation": Status["histogram"]["orientation"],
 *   "histogram.scale": Status["histogram"]["scale"],
 *   "histogram.font": Status["histogram"]["font"],
 *   "figure.unit": Status["figure"]["unit"],
 *   "figure.legend": Status["figure"]["legend"],
 *   "figure.legend_place": Status["figure"]["legend_place"],
 *   "figure.scale_bar_place": Status["figure"]["scale_bar_place"],
 *   "figure.axes_place": Status["figure"]["axes_place"],
 *   "figure.meshes": Status["figure"]["meshes"],
 *   "figure.panels.setting": Status["figure"]["panels"]["setting"],
 * }} Choices
 */

export {};
