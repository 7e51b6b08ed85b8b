/**
 * What every widget is given, and how a control's description is tied to the status.
 *
 * @typedef {import("../state/store.js").StatusStore} StatusStore
 * @typedef {import("../state/status.js").PartialStatus} PartialStatus
 * @typedef {import("../state/facts.js").Facts} Facts
 * @typedef {keyof import("../state/facts.js").FactTable} FactName
 *
 * @typedef {object} MeshContext  of one mesh, which need not be the page's first
 * @property {StatusStore} store
 * @property {Facts} facts
 * @property {CellActions} app
 * @property {import("../state/tables.js").Tables} tables the core's tables: metrics, formats, defaults
 *
 * @typedef {MeshContext & { app: Actions }} Context
 *
 * @typedef {object} CellActions  what can be done with single cells of a mesh
 * @property {(cell: number | null) => unknown} inspect
 * @property {(cell: number) => Promise<void>} flyTo
 * @property {(cell: number) => unknown} cutTo
 * @property {(tool: import("../state/facts.js").PickingTool, cell: number) => void} pick
 * @property {(kind: "cell" | "vertex", number: number) => Promise<boolean>} goTo by the file's number; tells whether one is there
 * @property {(cells: readonly number[], form: string, name: string) => Promise<string | null>} listCells as a text for other programs
 * @property {(finding: import("../state/answers.js").Finding) => unknown} showFinding
 * @property {Pick<Structured, "trace">} structured
 * @property {{ reset: () => void, fitShown: () => void, flyToShown: () => Promise<void> }} views
 *
 * @typedef {CellActions & PageActions} Actions  what the page asks of the application that is more than a setting
 *
 * @typedef {object} PageActions
 * @property {Comparing} comparing
 * @property {Pick<import("../hosts/host.js").Host, "root" | "keeps" | "shares" | "embedded">} host
 * @property {{ open: (id: string) => Promise<unknown> } | null} offered meshes that the core has at hand
 * @property {(files: readonly File[]) => Promise<unknown>} openFiles
 * @property {(source: string) => Promise<void>} chooseSource
 * @property {(source: string, mesh: string) => Promise<void>} chooseEntry
 * @property {{ measure: () => Promise<void>, meet: (origin: string) => Promise<void> }} grouped
 * @property {Structured} structured
 * @property {() => Promise<void>} saveWorst
 * @property {() => Promise<void>} saveValues
 * @property {(format: ChartFormat) => unknown} saveHistogram
 * @property {{ dismiss: (id: number) => void }} messages
 * @property {{ file: (format: "png" | "svg" | "pdf", wanted?: Size | null, which?: "both" | "first" | "second") => Promise<Blob>,
 *   size: (shown: Size) => Size, shown: Size, lastSize: Size }} figures
 * @property {{ text: () => string, apply: (document: unknown) => Promise<import("../state/answers.js").Rejection[]> }} documents
 * @property {{ stem: string, saveStatus: () => void, link: () => Promise<string> }} saving
 * @property {import("../state/leaving.js").Leaving} leaving files for other programs
 * @property {import("../state/leaving.js").SinglePage} singlePage
 * @property {import("../state/leaving.js").Turntable} turntable
 * @property {import("../state/leaving.js").Reports} reports
 * @property {(files: readonly File[]) => Promise<void>} offerBatch
 * @property {{ run: (entries: import("../files/zip.js").Entry[], options: Size & Run & { figures: boolean }) => Promise<{ zip: Blob, failed: { name: string, problem: string }[] }> }} batch
 * @property {{ toggle: () => unknown }} keeping offline, the open mesh
 * @property {import("../scene/scene_like.js").SceneLike} scene
 *
 * @typedef {object} Comparing  a second mesh, or a reference surface
 * @property {boolean} possible whether this page can show a second mesh
 * @property {(files: readonly File[]) => Promise<void>} openFiles
 * @property {(source: string, mesh: string) => Promise<void>} openEntry
 * @property {(id: string) => Promise<void>} openOffered
 * @property {() => void} close
 * @property {() => Promise<void>} swap
 * @property {(quantity: string) => Promise<void>} measure statistics of both
 * @property {(metric: string) => Promise<import("../state/answers.js").Changes | null>} changes
 * @property {() => Promise<void>} trace the structure of both
 * @property {() => void} saveTable the metrics of both, as CSV
 * @property {readonly (number | null)[]} memory bytes that each core holds
 * @property {{ measure: () => Promise<import("../state/facts.js").Apart | null>, save: () => Promise<void> }} distances
 *
 * @typedef {import("../state/structure.js").Kind} Kind
 * @typedef {import("../state/answers.js").StructureTable} StructureTable
 *
 * @typedef {object} Structured  the structure of the open mesh
 * @property {() => Promise<boolean>} trace whether it is traced then
 * @property {(kind: Kind | "nodes") => Promise<StructureTable | null>} table
 * @property {(kind: Kind) => Promise<string | null>} csv
 * @property {() => Promise<import("../state/answers.js").StructureFacts | null>} facts with hashes of all labels
 * @property {() => Promise<import("../state/answers.js").SheetPairs | null>} pairs
 * @property {(kind: Kind, numbers: readonly number[]) => Promise<void>} flyTo
 * @property {(kind: Kind, numbers: readonly number[], keep: "inside" | "outside") => void} filter
 *
 * @typedef {"png" | "svg" | "pdf" | "csv"} ChartFormat
 * @typedef {{ width: number, height: number }} Size  in pixels
 * @typedef {{ signal: AbortSignal, report: (done: number, of: number, name: string, failed: number) => void }} Run
 *
 * @typedef {{ value: string, name: string, group?: string }} Option
 * @typedef {readonly [number, number, number]} Range  lowest, highest, step
 *
 * @typedef {object} Dependencies
 * @property {readonly string[]} [status] paths
 * @property {readonly FactName[]} [facts]
 *
 * @typedef {object} Row  what every control has
 * @property {string} [id] unique on the page
 * @property {string} [label]
 * @property {(context: Context) => string} [unit] of its numbers, if they have one that is named; stands in the place of the label
 * @property {string} [hint] more about it, as a tooltip
 * @property {string} [path] where its value stands in the status
 * @property {readonly string[]} [status] further paths it depends on
 * @property {readonly FactName[]} [facts] facts it depends on
 * @property {string} [enabled] path of the switch before its label
 * @property {(context: Context) => string} [why] why it has no effect now; empty if it has
 * @property {boolean} [full] whether it takes the whole width, its label for screen readers alone
 * @property {(context: Context) => boolean} [hidden] whether it is left out now
 * @property {readonly Control[]} [more] rows that stay folded below this one until asked for
 */

/**
 * A value that is not simply what stands at `path`: how it is read, the partial status that it makes (null changes
 * nothing), and what a reset puts back.
 *
 * @template Value
 * @typedef {{ path?: string, read?: (context: Context) => Value, initial?: Value,
 *   write?: (value: Value, context: Context) => PartialStatus | null | void }} Valued
 */

/**
 * @typedef {object} Box  what a slider's number box does otherwise than the slider
 * @property {(context: Context) => Range} [range]
 * @property {(context: Context) => number} [read]
 * @property {(value: number, context: Context) => PartialStatus | null} [write]
 *
 * @typedef {object} NumberField  one of several number boxes side by side
 * @property {string} name
 * @property {(context: Context) => number | null} read
 * @property {(value: number | null, context: Context) => PartialStatus | null} write null: the box was emptied
 * @property {boolean} [optional] whether it may be empty
 * @property {(context: Context) => Range} [range]
 * @property {(context: Context) => string} [placeholder]
 *
 * @typedef {object} Action  a button
 * @property {string} name
 * @property {string} [text]
 * @property {string} [icon]
 * @property {string} [hint]
 * @property {(context: Context, event: MouseEvent) => void} press
 * @property {(context: Context) => boolean} [pressed]
 * @property {(context: Context) => boolean} [disabled]
 *
 * @typedef {object} SliderParts
 * @property {"slider"} kind
 * @property {Range | ((context: Context) => Range)} [range]
 * @property {number} [digits] after the point
 * @property {Box} [box]
 * @property {readonly string[]} [names] what the slider's steps are called
 * @property {(context: Context) => void} [press] it is held
 * @property {(context: Context) => void} [release]
 *
 * @typedef {object} ChoiceParts
 * @property {"choice"} kind
 * @property {readonly Option[] | ((context: Context) => readonly Option[])} options
 *
 * @typedef {object} TextParts
 * @property {"text"} kind
 * @property {(value: string, context: Context) => string} [check] names what is wrong with a text
 *
 * @typedef {Row & Valued<number> & SliderParts} SliderControl
 * @typedef {Row & Valued<string> & ChoiceParts} ChoiceControl
 * @typedef {Row & Valued<boolean> & { kind: "toggle" }} ToggleControl
 * @typedef {Row & Valued<string> & TextParts} TextControl
 * @typedef {Row & { kind: "colours", items: readonly { path: string, name: string }[] }} ColoursControl
 * @typedef {Row & { kind: "numbers", items: readonly NumberField[], digits?: number }} NumbersControl
 * @typedef {Row & { kind: "actions", items: readonly Action[] }} ActionsControl
 * @typedef {Row & { kind: "more", id: string, items: readonly Control[] }} MoreControl  rows that are folded away
 * @typedef {Row & { kind: "custom", render: (context: Context) => HTMLElement }} CustomControl
 *
 * @typedef {SliderControl | ChoiceControl | ToggleControl | TextControl | ColoursControl | NumbersControl | ActionsControl
 *   | MoreControl | CustomControl} Control  one row of a panel's table
 */

/**
 * Call `update` now and whenever one of the paths or facts changes.
 *
 * @param {Pick<MeshContext, "store" | "facts">} context @param {Dependencies} dependencies @param {() => void} update
 */
export function watch({ store, facts }, { status = [], facts: names = [] }, update) {
  let told = false;
  const once = () => {
    if (told) return;
    told = true;
    queueMicrotask(() => {
      told = false;
      update();
    });
  };
  for (const path of status) store.on(path, once);
  for (const name of names) facts.on(name, once);
  update();
}

/** What a control depends on. @param {Row} control @returns {Dependencies} */
export function dependencies(control) {
  const status = [control.path, control.enabled, ...(control.status ?? [])].filter(
    (path) => path !== undefined,
  );
  return { status, facts: control.facts ?? [] };
}

/** @template Value @param {Valued<Value>} control @param {Context} context @returns {Value} */
export function readValue({ read, path }, context) {
  return read ? read(context) : /** @type {Value} */ (context.store.valueAt(path ?? ""));
}

/**
 * @template Value
 * @param {Valued<Value>} control @param {Value} value @param {Context} context @param {string} [undo] key that merges undo steps
 */
export function writeValue({ write, path }, value, context, undo) {
  const options = undo === undefined ? {} : { undo };
  if (!write) return context.store.setAt(path ?? "", value, options);
  const partial = write(value, context);
  return partial ? context.store.set(partial, options) : [];
}

/** @param {object} control @returns {boolean} */
export function canReset(control) {
  const { path, write, initial } = /** @type {Valued<unknown>} */ (control);
  return Boolean(path && !write) || initial !== undefined;
}

/** Put a control's value back to the default. @param {object} control @param {Context} context */
export function reset(control, context) {
  const valued = /** @type {Valued<unknown>} */ (control);
  const { path, write, initial } = valued;
  if (path && !write) context.store.setAt(path, context.store.defaultAt(path));
  else if (initial !== undefined) writeValue(valued, initial, context);
}
