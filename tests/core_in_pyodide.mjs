// Runs pytest inside Pyodide, under Node: the core's tests on the interpreter and the numpy that browsers get.
//
//     node tests/core_in_pyodide.mjs SITE_PACKAGES [pytest arguments]
//
// SITE_PACKAGES is where pytest itself is taken from (pure Python). Tests of what only exists natively skip themselves.

import { resolve } from "node:path";
import { start } from "./pyodide_under_node.mjs";

const [sitePackages, ...pytestArguments] = process.argv.slice(2);
const pyodide = await start();
pyodide.mountNodeFS("/packages", resolve(sitePackages));

const exit = pyodide.runPython(
  `
import importlib.util, sys
from pathlib import Path

class Borrowed:
    """Finds just the pure-Python packages that pytest needs; everything else stays native."""
    NAMES = ("pytest", "_pytest", "py", "pluggy", "iniconfig", "packaging", "pygments")

    def find_spec(self, name, path=None, target=None):
        if path is not None or name not in self.NAMES:
            return None
        folder = Path("/packages") / name
        if (folder / "__init__.py").is_file():
            return importlib.util.spec_from_file_location(
                name, folder / "__init__.py", submodule_search_locations=[str(folder)])
        module = folder.with_suffix(".py")
        return importlib.util.spec_from_file_location(name, module) if module.is_file() else None

sys.meta_path.append(Borrowed())
import pytest
int(pytest.main(ARGUMENTS))
`,
  { globals: pyodide.toPy({ ARGUMENTS: ["-p", "no:cacheprovider", ...pytestArguments] }) },
);
process.exit(exit);
