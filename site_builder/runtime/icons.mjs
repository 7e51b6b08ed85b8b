// Draws an SVG as a PNG: node icons.mjs SIDE < icon.svg > icon.png
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { Resvg, initWasm } from "@resvg/resvg-wasm";

const [side] = process.argv.slice(2).map(Number);
const require = createRequire(import.meta.url);
await initWasm(readFileSync(require.resolve("@resvg/resvg-wasm/index_bg.wasm")));
const drawing = new Resvg(readFileSync(0, "utf8"), { fitTo: { mode: "width", value: side } });
process.stdout.write(drawing.render().asPng());
