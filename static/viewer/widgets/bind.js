/**
 * What every widget is given, and how a control's description is tied to the status.
 *
 * @typedef {import("../state/store.js").StatusStore} StatusStore
 * @typedef {import("../state/store.js").Status} Status
 * @typedef {import("../state/facts.js").Facts} Facts
 *
 * @typedef {object} Context
 * @property {StatusStore} store
 * @property {Facts} facts
 * @property {any} app the actions that are more than a setting: open, download, inspect, ...
 * @property {import("../state/tables.js").Tables} tables the core's tables: metrics, formats, defaults
 *
 * @typedef {{ value: string, name: string, group?: string }} Option
 * @typedef {readonly [number, number, number]} Range
 *
 * @typedef {object} Box  what a control's number or text box does otherwise than the control
 * @property {any} [initial] value that a reset puts back
 * @property {(context: Context) => Range} [range]
 * @property {(context: Context) => number | null} [read]
 * @property {(value: number, context: Context) => any} [write]
 * @property {(value: string, context: Context) => string} [check] names what is wrong with a text
 * @property {(context: Context) => void} [press] the slider is held
 * @property {(context: Context) => void} [release]
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
 * @typedef {object} Control  one row of a panel's table
 * @property {string} kind name of the widget
 * @property {string} [id] unique on the page
 * @property {string} [label]
 * @property {string} [hint] more about it, as a tooltip
 * @property {string} [path] where its value stands in the status
 * @property {(context: Context) => any} [read] its value, where that is not simply what stands at `path`
 * @property {(value: any, context: Context) => any} [write] the partial status that a value makes; null changes nothing
 * @property {string[]} [status] further paths it depends on
 * @property {string[]} [facts] facts it depends on
 * @property {string} [enabled] path of the switch before its label
 * @property {(context: Context) => string} [why] why it has no effect now; empty if it has
 * @property {boolean} [full] whether it takes the whole width, its label for screen readers alone
 * @property {(context: Context) => boolean} [hidden] whether it is left out now
 * @property {readonly Option[] | ((context: Context) => readonly Option[])} [options] of a combo box
 * @property {Range | ((context: Context) => Range)} [range] lowest, highest, step
 * @property {number} [digits] after the point
 * @property {Box} [box]
 * @property {readonly string[]} [names] what the slider's steps are called
 * @property {readonly any[]} [items] parts: see the widget
 * @property {readonly Control[]} [more] rows that stay folded below this one until asked for
 * @property {(context: Context) => HTMLElement} [render]
 */

/**
 * Call `update` now and whenever one of the paths or facts changes.
 *
 * @param {Context} context @param {{ status?: readonly string[], facts?: readonly string[] }} dependencies @param {() => void} update
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

/** What a control depends on. @param {Control} control */
export function dependencies(control) {
  const status = [control.path, control.enabled, ...(control.status ?? [])].filter(
    (path) => path !== undefined,
  );
  return { status, facts: control.facts ?? [] };
}

/** @param {Control} control @param {Context} context @returns {any} */
export function readValue(control, context) {
  return control.read ? control.read(context) : context.store.valueAt(/** @type {string} */ (control.path));
}

/** @param {Control} control @param {any} value @param {Context} context @param {string} [undo] key that merges undo steps */
export function writeValue(control, value, context, undo) {
  const options = undo === undefined ? {} : { undo };
  if (!control.write) return context.store.setAt(/** @type {string} */ (control.path), value, options);
  const partial = control.write(value, context);
  return partial ? context.store.set(partial, options) : [];
}

/** @param {Control} control */
export function canReset(control) {
  return Boolean(control.path && !control.write) || control.box?.initial !== undefined;
}

/** Put a control's value back to the default. @param {Control} control @param {Context} context */
export function reset(control, context) {
  if (control.path && !control.write)
    context.store.setAt(control.path, context.store.defaultAt(control.path));
  else if (control.box?.initial !== undefined) writeValue(control, control.box.initial, context);
}
