import assert from "node:assert/strict";
import { test } from "node:test";

import { CoreClient, CoreError, Superseded } from "../../../static/viewer/core/client.js";

/** A worker that answers when told to, and remembers what it was sent. */
class ManualWorker {
  sent = [];
  terminated = false;
  postMessage(message) {
    this.sent.push(message);
  }
  reply(data) {
    this.onmessage({ data });
  }
  terminate() {
    this.terminated = true;
  }
}

function client() {
  const workers = [];
  const made = new CoreClient({
    worker: "worker.js",
    runtime: "runtime/",
    makeWorker: () => (workers.push(new ManualWorker()), workers.at(-1)),
  });
  return { client: made, workers, worker: workers[0] };
}

const boot = (worker) => worker.reply({ ready: { interpreter: 1, core: 1 } });
const calls = (worker) => worker.sent.filter((message) => message.method);

test("the worker is told where the runtime is, and calls wait until Python is ready", async () => {
  const { client: core, worker } = client();
  assert.deepEqual(worker.sent, [{ boot: "runtime/" }]);
  const answer = core.call("schema");
  assert.equal(calls(worker).length, 0);
  boot(worker);
  await core.ready;
  worker.reply({ id: calls(worker)[0].id, result: { a: 1 }, milliseconds: 5 });
  assert.deepEqual(await answer, { a: 1 });
  assert.equal(core.milliseconds.schema, 5);
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
  for (const result of ["one", "histogram", "three"]) worker.reply({ id: calls(worker).at(-1).id, result });
  assert.deepEqual(await Promise.all([first, other, third]), ["one", "histogram", "three"]);
  assert.deepEqual(
    calls(worker).map(({ method, args }) => [method, ...args]),
    [["update", 1], ["histogram"], ["update", 3]],
  );
});

test("R10 an error of Python rejects the call by its kind, and the next call goes on", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const broken = core.call("open", ["a.mesh", new ArrayBuffer(3)]);
  const next = core.call("schema");
  worker.reply({
    id: 1,
    error: { kind: "MeshReadError", message: "a.mesh: the file is empty", fatal: false },
  });
  await assert.rejects(broken, (error) => error instanceof CoreError && error.kind === "MeshReadError");
  worker.reply({ id: 2, result: "fine" });
  assert.equal(await next, "fine");
});

test("V9 a worker that dies is replaced; calls under way are rejected and the page is told", async () => {
  const { client: core, workers, worker } = client();
  boot(worker);
  await core.ready;
  const told = [];
  for (const name of ["died", "restarted"]) core.addEventListener(name, () => told.push(name));
  const lost = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  const waiting = core.call("schema");
  worker.reply({
    id: 1,
    error: { kind: "RuntimeError", message: "memory access out of bounds", fatal: true },
  });
  await assert.rejects(lost, { message: "memory access out of bounds" });
  await assert.rejects(waiting, { kind: "WorkerError" });
  assert.ok(worker.terminated);
  boot(workers[1]);
  await core.ready;
  await new Promise(setImmediate);
  assert.deepEqual(told, ["died", "restarted"]);
  const again = core.call("schema");
  workers[1].reply({ id: calls(workers[1])[0].id, result: 1 });
  assert.equal(await again, 1);
});

test("a core that can't start rejects `ready` and every call", async () => {
  const { client: core, worker } = client();
  const call = core.call("schema");
  worker.reply({ failed: { kind: "TypeError", message: "no WebAssembly" } });
  await assert.rejects(core.ready, { message: "no WebAssembly" });
  await assert.rejects(call, { message: "no WebAssembly" });
});

test("events tell when the core is busy, idle, and which file was opened", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const told = [];
  core.addEventListener("busy", (event) => told.push(event.detail.method));
  core.addEventListener("idle", () => told.push("idle"));
  core.addEventListener("identified", (event) => told.push(event.detail.sha256));
  const call = core.call("open", ["a.mesh", new ArrayBuffer(1)]);
  worker.reply({ id: 1, result: {} });
  worker.reply({ opened: 1, sha256: "ab" });
  await call;
  assert.deepEqual(told, ["open", "idle", "ab"]);
});

test("a file that could not be read, or was followed by another, does not name the open mesh", async () => {
  const { client: core, worker } = client();
  boot(worker);
  const told = [];
  core.addEventListener("identified", (event) => told.push(event.detail.sha256));
  const calls = [1, 2, 3].map((id) => core.call("open", [`${id}.mesh`, new ArrayBuffer(1)]));
  worker.reply({ id: 1, result: {} });
  worker.reply({ id: 2, result: {} });
  worker.reply({ opened: 1, sha256: "a" });
  worker.reply({ opened: 2, sha256: "b" });
  worker.reply({ id: 3, error: { kind: "MeshReadError", message: "no mesh", fatal: false } });
  worker.reply({ opened: 3, sha256: "c" });
  await assert.rejects(calls[2], { message: "no mesh" });
  assert.deepEqual(told, ["b"]);
});
