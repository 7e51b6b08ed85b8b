// Runs pyodide-build's byte-compiler inside Pyodide, under Node.
//
//     node compile_python.mjs PYODIDE_FOLDER WHEELS_FOLDER FOLDER
//
// The archives in FOLDER/1 are compiled as by `python -O`, those in FOLDER/2 as by `python -OO`; the compiled ones take
// their place. Prints a JSON object: the name of each archive to its name now.

import { readdirSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";

const [interpreter, wheels, folder] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(resolve(interpreter, "pyodide.mjs")).href);

/**
 * @param {string} level 1 or 2, as in `python -O` or `-OO`
 * @returns {Promise<Record<string, string>>} name of each archive to its name now
 */
async function compile(level) {
  const pyodide = await loadPyodide({
    indexURL: resolve(interpreter),
    args: ["-" + "O".repeat(Number(level))], // the compiler takes the interpreter's own level
    env: { SOURCE_DATE_EPOCH: "0" }, // byte code then carries its source's hash, not the time of the build
    stdout: console.error,
  });
  pyodide.mountNodeFS("/wheels", resolve(wheels));
  pyodide.mountNodeFS("/archives", resolve(folder, level));
  const names = pyodide.runPython(`
import sys
from pathlib import Path
sys.path += map(str, Path("/wheels").glob("*.whl"))
from pyodide_build._py_compile import _py_compile_archive_dir
_py_compile_archive_dir(Path("/archives"), keep=False, verbose=False, compression_level=0)
`);
  return names.toJs({ dict_converter: Object.fromEntries });
}

try {
  const names = {};
  for (const level of readdirSync(folder)) Object.assign(names, await compile(level));
  console.log(JSON.stringify(names));
} catch (error) {
  console.error(error instanceof Error ? error.message : error); // not Pyodide's sources, which Node would print
  process.exitCode = 1;
}
