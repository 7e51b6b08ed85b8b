// Pyodide under Node, with the numpy that browsers get; the project lies at /project, its packages can be imported.

import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { resolve } from "node:path";

const root = resolve(fileURLToPath(import.meta.url), "../..");
const interpreter = resolve(root, "node_modules/pyodide");
const { loadPyodide } = await import(resolve(interpreter, "pyodide.mjs"));

export async function start() {
  const pyodide = await loadPyodide({ indexURL: interpreter });
  const numpy = JSON.parse(readFileSync(resolve(interpreter, "pyodide-lock.json"), "utf8")).packages.numpy
    .file_name;
  const carrier = resolve(root, "node_modules/@galaxyproject/vintent/static/pyodide", numpy);
  await pyodide.loadPackage(carrier, { messageCallback: () => {} });
  pyodide.mountNodeFS("/project", root);
  pyodide.runPython(`
import os, sys
sys.path[:0] = ["/project/core", "/project"]
sys.dont_write_bytecode = True
os.chdir("/project")
`);
  return pyodide;
}
