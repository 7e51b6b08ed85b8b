import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { Steps } from "../../../static/viewer/app/steps.js";

const PAGE = "https://meshes.example/viewer.html";

/** The browser's history, as far as a page sees it. */
class FakeHistory {
  /** @type {{ state: any, href: string }[]} */
  entries;
  at = 0;
  /** @type {(event: { state: any }) => void} */
  popped = () => {};

  /** @param {string} href */
  constructor(href) {
    this.entries = [{ state: null, href }];
  }

  get present() {
    return this.entries[this.at];
  }

  get state() {
    return this.present.state;
  }

  /** @param {any} state @param {string} _ @param {URL} address */
  replaceState(state, _, address) {
    this.entries[this.at] = { state, href: String(address) };
  }

  /** @param {any} state @param {string} _ @param {URL} address */
  pushState(state, _, address) {
    this.entries.splice(++this.at, Infinity, { state, href: String(address) });
  }

  /** @param {number} steps */
  async go(steps) {
    this.at += steps;
    this.popped({ state: this.state });
    await new Promise((resolve) => setTimeout(resolve));
  }
}

let browser = new FakeHistory(PAGE);

/** A page at an address, whose meshes are names. @param {string} [search] */
function page(search = "", host = { steps: true }) {
  browser = new FakeHistory(PAGE + search);
  const opened = /** @type {string[]} */ ([]);
  const layers = /** @type {any[]} */ ([]);
  const app = /** @type {any} */ ({
    host,
    store: { status: { name: "" } },
    documents: {
      replaceBy: async (/** @type {any[]} */ [status]) => {
        layers.push(status);
        app.store.status = status;
      },
    },
    drawing: { update: async () => {} },
  });
  const steps = new Steps(app);
  steps.start();
  /** @param {string | null} mesh @param {string} [name] */
  const open = (mesh, name = mesh ?? "a file") => {
    steps.leave();
    app.store.status = { name };
    steps.add(mesh, async () => void opened.push(name));
  };
  return { steps, open, opened, layers };
}

beforeEach(() => {
  Object.assign(globalThis, {
    window: {
      addEventListener: (/** @type {string} */ _, /** @type {any} */ listener) => (browser.popped = listener),
    },
    history: {
      get state() {
        return browser.state;
      },
      replaceState: (/** @type {[any, string, URL]} */ ...all) => browser.replaceState(...all),
      pushState: (/** @type {[any, string, URL]} */ ...all) => browser.pushState(...all),
    },
    location: {
      get href() {
        return browser.present.href;
      },
    },
  });
});

const search = () => new URL(browser.present.href).search;

test("S6: the address names the mesh and the one beside it, as a link to both is read", () => {
  const { steps, open } = page();
  open("duck/fine");
  assert.equal(search(), "?mesh=duck/fine");
  steps.beside("duck/coarse");
  assert.equal(search(), "?mesh=duck/fine&with=duck/coarse");
  const address = "https://other.example/a mesh.vtk?x=1&y=2";
  steps.beside(address);
  const named = new URL(browser.present.href).searchParams;
  assert.equal(named.get("mesh"), "duck/fine");
  assert.equal(named.get("with"), address);
  assert.equal(browser.entries.length, 1, "what stands beside is no step of its own");
});

test("S6: a second mesh goes out of the address when it is closed, and a file of this machine is not in it", () => {
  const { steps, open } = page();
  open("duck/fine");
  steps.beside("duck/coarse");
  steps.beside(null);
  assert.equal(search(), "?mesh=duck/fine");
});

test("S6: beside a file of this machine nothing is named: the comparison can't be shared", () => {
  const { steps, open } = page();
  open(null);
  steps.beside("duck/coarse");
  assert.equal(search(), "");
  open("duck/fine");
  assert.equal(search(), "?mesh=duck/fine&with=duck/coarse", "it stands beside the next one");
});

test("S6: both change places in the address", () => {
  const { steps, open } = page();
  open("duck/fine");
  steps.beside("duck/coarse");
  steps.swap(async () => {});
  assert.equal(search(), "?mesh=duck/coarse&with=duck/fine");
  steps.swap(async () => {});
  assert.equal(search(), "?mesh=duck/fine&with=duck/coarse");
  steps.beside(null);
  steps.swap(async () => {});
  assert.equal(search(), "", "a file has come to the first place");
});

test("S6: an address that the page was opened by stays as it is", () => {
  const before = "?mesh=duck/fine&with=duck/coarse#H4sI";
  const { steps, open } = page(before);
  open("duck/fine");
  assert.equal(browser.present.href, PAGE + before);
  steps.beside("duck/coarse");
  assert.equal(browser.present.href, PAGE + before);
});

test("going back opens the mesh before under its settings, and is no step of its own", async () => {
  const { open, opened, layers } = page();
  open("duck/fine");
  open("cube/one");
  assert.equal(browser.entries.length, 2);
  await browser.go(-1);
  assert.deepEqual(opened, ["duck/fine"]);
  assert.deepEqual(layers, [{ name: "duck/fine" }]);
  assert.equal(browser.entries.length, 2);
  await browser.go(1);
  assert.deepEqual(opened, ["duck/fine", "cube/one"]);
  assert.deepEqual(
    layers.at(-1),
    { name: "cube/one" },
    "settings at leaving are those that are come back to",
  );
});

test("what is opened while a step is gone to is none of its own, and what fails then is no end of steps", async () => {
  const { steps, open } = page();
  steps.add("duck/fine", async () => {
    steps.leave();
    steps.add("duck/fine", async () => {});
    throw new Error("it can't be fetched");
  });
  open("cube/one");
  await browser.go(-1);
  assert.equal(browser.entries.length, 2);
  open("cube/two");
  assert.equal(browser.entries.length, 2, "it takes the place of the one that could be gone forward to");
  assert.equal(search(), "?mesh=cube/two");
});

test("S6: after going back the address names the mesh gone back to, and what stands beside it now", async () => {
  const { steps, open } = page();
  open("duck/fine");
  open("cube/one");
  steps.beside("cube/two");
  await browser.go(-1);
  assert.equal(search(), "?mesh=duck/fine&with=cube/two");
  steps.beside("duck/coarse");
  assert.equal(search(), "?mesh=duck/fine&with=duck/coarse");
  steps.beside(null);
  await browser.go(1);
  assert.equal(search(), "?mesh=cube/one");
});

test("S6: of a step at which both changed places, going back opens the one that had come to the first", async () => {
  const { steps, open, opened } = page();
  open("duck/fine");
  steps.beside("duck/coarse");
  steps.swap(async () => void opened.push("swapped"));
  open("cube/one");
  await browser.go(-1);
  assert.deepEqual(opened, ["swapped"]);
  assert.equal(search(), "?mesh=duck/coarse&with=duck/fine");
});

test("S6: a page that keeps no steps leaves its address alone", () => {
  const { steps, open } = page("?embed", { steps: false });
  open("duck/fine");
  steps.beside("duck/coarse");
  steps.swap(async () => {});
  assert.equal(browser.present.href, `${PAGE}?embed`);
  assert.equal(browser.entries.length, 1);
});
