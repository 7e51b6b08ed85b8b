// Runs one of the benchmarks inside Pyodide, under Node.
//
//     node benchmarks/in_pyodide.mjs distance

import { start } from "../tests/pyodide_under_node.mjs";

const pyodide = await start();
pyodide.globals.set("NAME", process.argv[2]);
pyodide.runPython(`
from importlib import import_module
from pathlib import Path
import_module("benchmarks." + NAME).run(Path("/tmp"))
`);
