/**
 * What may be asked of the core: its methods (hexalab.session), their arguments and answers, whose shapes stand in
 * `state/answers.js`. The tests hold this map against the door's own list.
 *
 * @typedef {object} Methods
 * @property {{ args: [name: string, data: ArrayBuffer, companions?: Record<string, ArrayBuffer>], answer: Summary }} open
 * @property {{ args: [name: string], answer: Summary }} open_offered
 * @property {{ args: [part?: string], answer: Partial<Description> }} describe
 * @property {{ args: [document: unknown], answer: Checked }} check
 * @property {{ args: [changed?: PartialStatus, lean?: boolean, whole?: boolean], answer: Update }} update
 * @property {{ args: [format: string, metrics?: readonly string[], attributes?: readonly string[] | null, structure?: boolean], answer: SavedCells }} save_cells
 * @property {{ args: [form: string, about?: ReportAbout, pictures?: readonly ReportPicture[], criteria?: unknown, strict?: boolean], answer: Report }} report
 * @property {{ args: [unit?: string], answer: ReportPose[] }} report_poses
 * @property {{ args: [quantity: string], answer: Statistics }} quality
 * @property {{ args: [quantity: string, bins?: number, shown_only?: boolean], answer: Histogram }} histogram
 * @property {{ args: [quantity: string, count?: number], answer: Worst }} worst
 * @property {{ args: [quantity: string], answer: Float64Array }} values
 * @property {{ args: [], answer: GroupMeasures[] }} group_table
 * @property {{ args: [origin: string], answer: Interface[] }} interfaces
 * @property {{ args: [], answer: Validity }} validity
 * @property {{ args: [], answer: Numbers }} numbers
 * @property {{ args: [kind: "cell" | "vertex", number: number, direction?: readonly number[] | null], answer: Found }} find
 * @property {{ args: [cells: readonly number[], form: string, name?: string], answer: string }} cell_list
 * @property {{ args: [cell: number], answer: Inspection }} inspect
 * @property {{ args: [cell: number, quantity: string], answer: CellValue }} value
 * @property {{ args: [], answer: boolean }} measure_sizes
 * @property {{ args: [cell: number], answer: CellView }} cell_view
 * @property {{ args: [cell: number, normal: readonly number[], rule?: string], answer: number }} cut_to
 * @property {{ args: [face_tag: number], answer: number }} neighbour
 * @property {{ args: [finding: string], answer: Uint32Array }} finding_cells
 * @property {{ args: [], answer: Traced }} trace
 * @property {{ args: [labels?: boolean], answer: StructureFacts }} structure_facts
 * @property {{ args: [table: string, variant?: string], answer: StructureTable }} structure_table
 * @property {{ args: [table: string, variant?: string], answer: string }} structure_csv
 * @property {{ args: [], answer: SheetPairs }} sheet_pairs
 * @property {{ args: [kind: string, numbers: readonly number[], variant?: string], answer: Around | null }} structure_box
 * @property {{ args: [], answer: string }} fingerprint
 * @property {{ args: [to?: string], answer: HandedOver }} hand_over
 * @property {{ args: [told: Told, points: ArrayBuffer, triangles: ArrayBuffer, coordinates?: ArrayBuffer | null, second?: boolean], answer: Compared }} compare_with
 * @property {{ args: [name: string, second?: boolean], answer: Compared }} compare_with_offered
 * @property {{ args: [name: string, data: ArrayBuffer, companions?: Record<string, ArrayBuffer>], answer: Compared }} compare_with_surface
 * @property {{ args: [], answer: null }} stop_comparing
 * @property {{ args: [back?: boolean], answer: Measured }} measure_distance
 * @property {{ args: [back?: boolean, diagonal?: number | null], answer: Distances }} distance_facts
 * @property {{ args: [], answer: string }} distance_csv
 * @property {{ args: [metric: string], answer: Changes }} metric_changes
 *
 * @typedef {import("../state/answers.js").Summary} Summary
 * @typedef {import("../state/answers.js").Description} Description
 * @typedef {import("../state/answers.js").Checked} Checked
 * @typedef {import("../state/answers.js").Update} Update
 * @typedef {import("../state/answers.js").Statistics} Statistics
 * @typedef {import("../state/answers.js").Histogram} Histogram
 * @typedef {import("../state/answers.js").SavedCells} SavedCells
 * @typedef {import("../state/answers.js").Report} Report
 * @typedef {import("../state/answers.js").ReportPose} ReportPose
 * @typedef {import("../state/leaving.js").ReportAbout} ReportAbout
 * @typedef {import("../state/leaving.js").ReportPicture} ReportPicture
 * @typedef {import("../state/answers.js").Worst} Worst
 * @typedef {import("../state/answers.js").Validity} Validity
 * @typedef {import("../state/answers.js").GroupMeasures} GroupMeasures
 * @typedef {import("../state/answers.js").Interface} Interface
 * @typedef {import("../state/answers.js").Numbers} Numbers
 * @typedef {import("../state/answers.js").Found} Found
 * @typedef {import("../state/answers.js").Inspection} Inspection
 * @typedef {import("../state/answers.js").CellValue} CellValue
 * @typedef {import("../state/answers.js").CellView} CellView
 * @typedef {import("../state/answers.js").Traced} Traced
 * @typedef {import("../state/answers.js").StructureFacts} StructureFacts
 * @typedef {import("../state/answers.js").StructureTable} StructureTable
 * @typedef {import("../state/answers.js").SheetPairs} SheetPairs
 * @typedef {import("../state/answers.js").HandedOver} HandedOver
 * @typedef {Pick<HandedOver, "name" | "vertices" | "cells" | "volume">} Told  of the other mesh
 * @typedef {import("../state/answers.js").Compared} Compared
 * @typedef {import("../state/answers.js").Distances} Distances
 * @typedef {import("../state/answers.js").Changes} Changes
 * @typedef {import("../state/answers.js").Measured} Measured
 * @typedef {import("../state/answers.js").Around} Around
 * @typedef {import("../state/status.js").PartialStatus} PartialStatus
 */

export {};
