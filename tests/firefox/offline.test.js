import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import puppeteer from "puppeteer-core";
import { Host } from "./host.js";

/** Firefox, driven over WebDriver BiDi: what the tests of Chromium hold in detail, held here in one visit. */

const PLACES = [process.env.HEXALAB_FIREFOX, "/usr/bin/firefox-esr", "/usr/bin/firefox"];
const firefox = PLACES.find((place) => place && existsSync(place));
const skip = firefox ? false : "needs Firefox: install one, or set HEXALAB_FIREFOX to its path";

const CUBE = `MeshVersionFormatted 2
Dimension 3
Vertices
8
0 0 0 0
1 0 0 0
1 1 0 0
0 1 0 0
0 0 1 0
1 0 1 0
1 1 1 0
0 1 1 0
Hexahedra
1
1 2 3 4 5 6 7 8 0
End
`;

/** What Firefox itself says of a fetch without a network. */
const NO_NETWORK = /Failed to load|Cross-Origin Request Blocked|NetworkError when attempting/;

/** Whether something is so in the end. @param {() => Promise<unknown>} question @param {string} what */
async function until(question, what) {
  const last = Date.now() + 60e3;
  for (;;) {
    if (await question().catch(() => false)) return; // while a page goes there is none to ask
    if (Date.now() > last) throw new Error(`after a minute still not so: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
  }
}

test("O1 in Firefox: a second visit without a network, keep offline, a new version", { skip }, async (t) => {
  const site = new Host("build/site");
  const folder = await mkdtemp(join(tmpdir(), "hexalab-"));
  await writeFile(join(folder, "far.mesh"), CUBE);
  const far = new Host(folder);
  await site.listen();
  await far.listen();
  const browser = await puppeteer.launch({
    browser: "firefox",
    executablePath: firefox,
    headless: !process.env.DISPLAY, // headless, it has no WebGL 2: tables alone
  });
  t.after(async () => {
    await browser.close();
    await Promise.all([site.cut(), far.cut()]);
  });
  const page = await browser.newPage();
  await page.setViewport({ width: 1280, height: 800 });
  /** @type {string[]} */
  const errors = [];
  page.on("pageerror", (error) =>
    errors.push(`${error instanceof Error ? error.stack : error} at ${page.url()}`),
  );
  const go = (/** @type {string} */ path) => page.goto(site.root + path);
  const text = () => page.evaluate(() => document.body.innerText);
  const says = (/** @type {string} */ words) => until(async () => (await text()).includes(words), words);
  const press = async (/** @type {string} */ name) => {
    const button = `::-p-xpath(//*[self::button or self::a][normalize-space()="${name}"])`;
    await (await page.waitForSelector(button, { visible: true }))?.click();
  };
  const opened = async (/** @type {number} */ cells) => {
    const there = () => page.evaluate((n) => window.hexalab?.summary()?.cells === n, cells);
    await until(there, `${cells} cells`).catch(async (error) => {
      throw new Error(`${error.message}; the page says: ${await text()}`);
    });
    // Firefox gives up going to another page when the one that is left writes its history.
    await until(() => page.evaluate(() => history.state !== null), "a step of the history");
  };

  await t.test("the first visit", async () => {
    await go("viewer/index.html?mesh=shapes/cube");
    await opened(512);
    await page.evaluate(() => navigator.serviceWorker.ready.then(() => true));
    await until(
      () => page.evaluate(() => navigator.serviceWorker.controller !== null),
      "a page that is served",
    );
    await go("sources/structures/index.html");
    await press("Keep offline");
    await says("Kept in this browser");
  });

  await t.test("a mesh of another host is kept", async () => {
    await go(`viewer/index.html?mesh=${far.root}far.mesh`);
    await opened(1);
    await press("Keep offline");
    await says("Kept offline");
  });

  await t.test("without a network", async () => {
    await Promise.all([site.cut(), far.cut()]);
    await go("index.html");
    await page.type("input[type=search]", "twisted");
    await says("Twisted bar");
    await go("sources/faults/index.html");
    await says("HexaLab faults");
    await go("sources/structures/octree/index.html"); // never visited, but kept
    assert.doesNotMatch(await text(), /not kept here/);
    await go("sources/shapes/bar/index.html");
    await says("This page is not kept here");
    await go("viewer/index.html?mesh=shapes/cube");
    await opened(512);
    await go("viewer/index.html?mesh=structures/octree"); // never opened, but kept
    await opened(1208);
    await go(`viewer/index.html?mesh=${far.root}far.mesh`);
    await opened(1);
    await page.evaluate(async (mesh) => window.hexalab.open(new File([mesh], "own.mesh")), CUBE);
    assert.equal(await page.evaluate(() => window.hexalab.summary()?.name), "own.mesh");
    await go("offline/index.html");
    await says("they work without a network");
    assert.match(await text(), /until you free it/);
  });

  await t.test("a new version is offered and taken, with a mesh open", async () => {
    await site.listen();
    await far.listen();
    await go("viewer/index.html");
    await page.evaluate(() => window.hexalab.ready);
    await page.evaluate(async (mesh) => window.hexalab.open(new File([mesh], "own.mesh")), CUBE);
    await page.evaluate(() => window.hexalab.setStatus({ separation: { mode: "fissure" } }));
    const worker = await readFile("build/site/service_worker.js", "utf8");
    site.instead.set("/service_worker.js", worker.replace(/("about\/index.html","revision":")\w+/, "$1next"));
    await page.evaluate(async () => void (await (await navigator.serviceWorker.getRegistration())?.update()));
    await says("A new version of HexaLab is there");
    await Promise.all([page.waitForNavigation(), press("reload")]);
    await opened(1);
    const mode = () => page.evaluate(() => window.hexalab.getStatus().separation.mode === "fissure");
    await until(mode, "the settings as before");
  });
  const others = errors.filter((error) => !NO_NETWORK.test(error));
  assert.deepEqual(others, []);
});
