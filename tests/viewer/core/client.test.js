import assert from "node:assert/strict";
import { test } from "node:test";

import { CoreClient, CoreError, Superseded } from "../../../static/viewer/core/client.js";
import { WorkerTransport } from "../../../static/viewer/core/worker_transport.js";
import { packed } from "../packed.js";

/** A worker that answers when told to, and remembers what it was sent. */
class ManualWorker {
  /** @type {any[]} */
  sent = [];
  terminated = false;
  /** @type {(event: any) => void} */
  onmessage = () => {};
  /** @param {any} message */
  postMessage(message) {
    this.sent.push(message);
  }
  /** @param {any} data */
  reply(data) {
    this.onmessage({ data });
  }
  /** @param {number} id @param {unknown} result @param {number} [milliseconds] */
  answer(id, result, milliseconds = 1) {
    this.reply({ id, packed: packed({ result }), milliseconds });
  }
  /** @param {number} id @param {{ kind: string, message: string }} error */
  refuse(id, error) {
    this.reply({ id, packed: packed({ error }), milliseconds: 1 });
  }
  terminate() {
    this.terminated = true;
  }
}

function client() {
  /** @type {ManualWorker[]} */
  const workers = [];
  const transport = new WorkerTransport({ worker: "worker.js", runtime: "runtime/" });
  transport.makeWorker = () => {
    workers.push(new ManualWorker());
    return /** @type {any} */ (workers.at(-1));
  };
  // The questions and answers of these tests are none that a core knows.
  const made = /** @type {Omit<CoreClient, "call"> & { call: (...args: any[]) => Promise<any> }} */ (
    new CoreClient(transport)
  );
  return { client: made, workers, worker: workers[0] };
}

/** @returns {{ promise: Promise<void>, resolve: () => void }} */
function withResolvers() {
  let resolve = () => {};
  const promise = /** @type {Promise<void>} */ (new Promise((told) => (resolve = told)));
  return { promise, resolve };
}

/** @param {Event} event */
const detailOf = (event) => /** @type {CustomEvent} */ (event).detail;
/** @param {ManualWorker} worker */
const boot = (worker) => worker.reply({ ready: { interpreter: 1, numpy: 1, core: 1 } });
/** @param {ManualWorker} worker */
const calls = (worker) => worker.sent.filter((message) => message.method);
/** @param {ManualWorker} worker */
const last = (worker) => calls(worker).at(-1).id;

test("the worker is told where the runtime is, and calls wait until Python is ready", async () => {
  const { client: core, worker } = client();
  assert.deepEqual(worker.sent, [{ boot: "runtime/" }]);
  const answer = core.call("validity");
  assert.equal(calls(worker).length, 0);
  boot(worker);
  await core.ready;
  worker.answer(last(worker), { a: 1 }, 5);
  assert.deepEqual(await answer, { a: 1 });
  assert.equal(core.milliseconds.validity, 5);
});

test("O4 what is to come before Python has its turn first", async () => {
  const worker = new ManualWorker();
  const { promise: turn, resolve } = withResolvers();
  const transport = new WorkerTransport({ worker: "worker.js", runtime: "runtime/", turn });
  transport.makeWorker = () => /** @type {any} */ (worker);
  const core = new CoreClient(transport);
  await new Promise((soon) => setTimeout(soon, 5));
  assert.deepEqual(worker.sent, []);
  resolve();
  await turn;
  assert.deepEqual(worker.sent, [{ boot: "runtime/" }]);
  boot(worker);
  await core.ready;
});

test("P2 a newer slice takes the place of one that still waits; the pointer never queues", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const first = core.call("update", [1], { replace: "update" });
  const second = core.call("update", [2], { replace: "update" });
  const other = core.call("histogram", [], { replace: "histogram" });
  const third = core.call("update", [3], { replace: "update" });
  await assert.rejects(second, Superseded);
  assert.equal(core.pending, 3);
  for (const result of ["one", "histogram", "three"]) worker.answer(last(worker), result);
  assert.deepEqual(await Promise.all([first, other, third]), ["one", "histogram", "three"]);
  assert.deepEqual(
    calls(worker).map(({ method, text }) => [method, ...JSON.parse(text)]),
    [["update", 1], ["histogram"], ["update", 3]],
  );
});

test("R10 an error of Python rejects the call by its kind, and the next call goes on", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const broken = core.call("open", ["a.mesh", new ArrayBuffer(3)]);
  const next = core.call("validity");
  worker.refuse(1, { kind: "MeshReadError", message: "a.mesh: the file is empty" });
  await assert.rejects(broken, (error) => error instanceof CoreError && error.kind === "MeshReadError");
  worker.answer(2, "fine");
  assert.equal(await next, "fine");
});

test("V9 a worker that dies is replaced; calls under way are rejected and the page is told", async () => {
  const { client: core, workers, worker } = client();
  boot(worker);
  await core.ready;
  /** @type {string[]} */
  const told = [];
  for (const name of ["died", "restarted"]) core.addEventListener(name, () => told.push(name));
  const lost = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  const waiting = core.call("validity");
  worker.reply({ broken: { kind: "RuntimeError", message: "memory access out of bounds" } });
  await assert.rejects(lost, { message: "memory access out of bounds" });
  await assert.rejects(waiting, { kind: "WorkerError" });
  assert.ok(worker.terminated);
  boot(workers[1]);
  await core.ready;
  await new Promise(setImmediate);
  assert.deepEqual(told, ["died", "restarted"]);
  const again = core.call("validity");
  workers[1].answer(last(workers[1]), 1);
  assert.equal(await again, 1);
});

test("a core that can't start rejects `ready` and every call", async () => {
  const { client: core, worker } = client();
  const call = core.call("validity");
  worker.reply({ failed: { kind: "TypeError", message: "no WebAssembly" } });
  await assert.rejects(/** @type {Promise<unknown>} */ (core.ready), { message: "no WebAssembly" });
  await assert.rejects(call, { message: "no WebAssembly" });
});

test("events tell when the core is busy and idle, and a promise which file was opened", async () => {
  const { client: core, worker } = client();
  boot(worker);
  /** @type {string[]} */
  const told = [];
  core.addEventListener("busy", (event) => told.push(detailOf(event).method));
  core.addEventListener("idle", () => told.push("idle"));
  const call = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  worker.answer(1, {});
  worker.reply({ id: 1, sha256: "ab" });
  await call;
  assert.deepEqual(told, ["open", "idle"]);
  assert.equal((await core.identity).sha256, "ab");
});

test("a file that could not be read, or was followed by another, does not name the open mesh", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const calls = [1, 2, 3].map((id) => core.call("open", [`${id}.mesh`, new ArrayBuffer(1)]));
  worker.answer(1, {});
  const first = core.identity;
  worker.answer(2, {});
  worker.reply({ id: 1, sha256: "a" });
  worker.reply({ id: 2, sha256: "b" });
  worker.refuse(3, { kind: "MeshReadError", message: "no mesh" });
  worker.reply({ id: 3, sha256: "c" });
  await assert.rejects(calls[2], { message: "no mesh" });
  assert.equal((await core.identity).sha256, "b");
  assert.equal((await first).sha256, "", "nobody waits for one that was followed by another");
});

test("a file whose hash comes before its answer, on another way, is identified", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const call = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  worker.reply({ id: 1, sha256: "ab" });
  worker.answer(1, {});
  await call;
  assert.equal((await core.identity).sha256, "ab");
});

test("nobody waits for the hash of a file whose core was started anew", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const call = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  worker.answer(1, {});
  await call;
  const { identity } = core;
  core.restart();
  assert.equal((await identity).sha256, "");
});

test("arguments that a function makes are made when the call is sent, and never for one that is replaced", async () => {
  const { client: core, worker } = client();
  boot(worker);
  let value = 1;
  /** @type {number[]} */
  const made = [];
  const args = () => [made[made.push(value) - 1]];
  const running = core.call("update", args, { replace: "update" });
  const replaced = core.call("update", args, { replace: "update" });
  const waiting = core.call("update", args, { replace: "update" });
  value = 2;
  await assert.rejects(replaced, Superseded);
  worker.answer(last(worker), "one");
  worker.answer(last(worker), "two");
  assert.deepEqual(await Promise.all([running, waiting]), ["one", "two"]);
  assert.deepEqual(made, [1, 2]);
});

test("a file's bytes go beside the question's text, handed over", () => {
  const { client: core, worker } = client();
  boot(worker);
  const bytes = Uint8Array.of(1, 2, 3).buffer;
  core.call("open", ["a.mesh", bytes]).catch(() => {});
  const { text, blocks } = calls(worker)[0];
  assert.deepEqual(JSON.parse(text), ["a.mesh", { $bytes: 0 }]);
  assert.deepEqual(blocks, [bytes]);
});

test("a call that can't be sent is refused, and the queue goes on", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const circle = /** @type {any} */ ({});
  circle.self = circle;
  const bad = core.call("check", [circle]);
  const big = core.call("check", [1n]);
  const throwing = core.call("check", () => {
    throw new Error("no arguments");
  });
  const good = core.call("validity");
  await assert.rejects(bad, {
    kind: "RequestError",
    message: /^This can't be asked of the core: .*circular/i,
  });
  await assert.rejects(big, { kind: "RequestError" });
  await assert.rejects(throwing, /no arguments/);
  worker.answer(last(worker), 5);
  assert.equal(await good, 5);
  assert.equal(core.pending, 0);
});

test("a question that the core can't read is refused", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const call = core.call("validity");
  worker.reply({
    id: last(worker),
    refused: { kind: "RequestError", message: "the question can't be read" },
  });
  await assert.rejects(call, { message: "the question can't be read" });
  worker.reply({ id: undefined, refused: { kind: "RequestError", message: "of nobody" } });
  assert.equal(core.pending, 0);
});

/** Die of an update as often as it is started. @param {ManualWorker[]} workers @param {any} core */
async function die(workers, core) {
  const worker = /** @type {ManualWorker} */ (workers.at(-1));
  boot(worker);
  await core.ready;
  const opened = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  worker.answer(last(worker), {});
  await opened;
  const update = core.call("update", []);
  worker.reply({ broken: { kind: "RuntimeError", message: "unreachable" } });
  await assert.rejects(update, { message: "unreachable" });
}

test("V9 a core that dies of the same thing again and again is left alone, until it is started by hand", async () => {
  const { client: core, workers } = client();
  /** @type {string[]} */
  const told = [];
  for (const name of ["died", "stopped"]) core.addEventListener(name, () => told.push(name));
  await die(workers, core);
  await die(workers, core);
  await die(workers, core);
  assert.deepEqual(told, ["died", "died", "stopped"]);
  assert.equal(workers.length, 3);
  assert.ok(workers.every((worker) => worker.terminated));
  await assert.rejects(core.call("validity"), { message: "unreachable" });
  core.restart();
  await die(workers, core);
  assert.equal(workers.length, 5);
});

test("V9 deaths with work done between them are forgotten", async () => {
  const { client: core, workers } = client();
  for (let round = 0; round < 5; round++) {
    await die(workers, core);
    const worker = /** @type {ManualWorker} */ (workers.at(-1));
    boot(worker);
    await core.ready;
    const update = core.call("update", []);
    worker.answer(last(worker), {});
    await update;
    core.restart();
  }
  assert.equal(workers.length, 11);
});

test("V9 a second start that fails is told", async () => {
  const { client: core, workers, worker } = client();
  boot(worker);
  await core.ready;
  const stopped = new Promise((resolve) =>
    core.addEventListener("stopped", (event) => resolve(detailOf(event))),
  );
  core.restart();
  workers[1].reply({ failed: { kind: "Error", message: "pyodide.asm.wasm is missing" } });
  assert.match(/** @type {any} */ (await stopped).error.message, /asm\.wasm is missing/);
  await assert.rejects(core.call("validity"), /asm\.wasm is missing/);
});

test("where there is no worker the start fails in words", async () => {
  const transport = new WorkerTransport({ worker: "worker.js", runtime: "runtime/" });
  transport.makeWorker = () => {
    throw new Error("Worker is not defined");
  };
  const core = new CoreClient(transport);
  await assert.rejects(core.ready, { message: "no worker can be had here: Worker is not defined" });
  await assert.rejects(core.call("validity"), /no worker/);
});
