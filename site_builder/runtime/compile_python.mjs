// Compiles the Python modules of zip archives to byte code, under the very Python that will run them:
// Pyodide in Node. Byte code starts faster than source, and a module needs to be shipped only once.
//
//     node compile_python.mjs PYODIDE_FOLDER PLAN.json
//
// PLAN.json is a list of {"source": path, "target": path, "leave_out": [regular expressions], "optimize": 1 or 2 (2: no
// docstrings)}; each source archive is
// rewritten to its target with every .py replaced by a .pyc beside which no source is needed. The output depends on the
// input alone: no time stamps, names in order.

import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";

const [folder, plan] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(resolve(folder, "pyodide.mjs")).href);
const pyodide = await loadPyodide({ indexURL: resolve(folder) });

pyodide.runPython(`
import hashlib, base64, io, re, zipfile
from importlib._bootstrap_external import _code_to_timestamp_pyc

def byte_code(name, source, optimize):
    return bytes(_code_to_timestamp_pyc(compile(source, name, "exec", dont_inherit=True, optimize=optimize), 0, 0))

def record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\\n"

def rewrite(data, leave_out, optimize):
    unwanted = [re.compile(pattern) for pattern in leave_out]
    files, record = {}, None
    with zipfile.ZipFile(io.BytesIO(bytes(data))) as archive:
        for name in sorted(archive.namelist()):
            if name.endswith("/") or any(pattern.search(name) for pattern in unwanted):
                continue
            content = archive.read(name)
            if name.endswith(".dist-info/RECORD"):
                record = name
            elif name.endswith(".py"):
                files[name + "c"] = byte_code(name, content, optimize)
            else:
                files[name] = content
    if record:
        files[record] = ("".join(record_line(*item) for item in files.items()) + f"{record},,\\n").encode()
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED, 9)
    return out.getvalue()
`);
const rewrite = pyodide.globals.get("rewrite");
for (const { source, target, leave_out = [], optimize = 2 } of JSON.parse(readFileSync(plan, "utf8"))) {
  const result = rewrite(
    pyodide.toPy(new Uint8Array(readFileSync(source))),
    pyodide.toPy(leave_out),
    optimize,
  );
  const buffer = result.getBuffer();
  writeFileSync(target, buffer.data);
  buffer.release();
}
