import assert from "node:assert/strict";
import { test } from "node:test";
import { Messages } from "../../../static/viewer/app/messages.js";
import { StartWatch } from "../../../static/viewer/app/start_watch.js";
import { Facts } from "../../../static/viewer/state/facts.js";

const later = (/** @type {number} */ milliseconds) =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

test("O4 a start in which nothing comes is told, and taken back when something does", async () => {
  const facts = new Facts();
  const client = new EventTarget();
  const watch = new StartWatch(client, new Messages(facts), 30);
  const said = () => facts.get("messages").map(({ text }) => text);
  assert.deepEqual(said(), []);
  await later(60);
  assert.match(said()[0], /nothing has come for 0 s\. The network/);
  client.dispatchEvent(new CustomEvent("loading", { detail: { file: "pyodide.asm.wasm" } }));
  assert.deepEqual(said(), []);
  await later(60);
  assert.match(said()[0], /, after pyodide\.asm\.wasm\./);
  watch.end();
  assert.deepEqual(said(), []);
  await later(60);
  assert.deepEqual(said(), []);
});
