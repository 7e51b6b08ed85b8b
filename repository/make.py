"""Make HexaLab's own meshes: ``python repository/make.py [--check] [SOURCE ...]``.

Each source's make.py has a table FILES of file name to a function that gives the file's bytes. Files that source.yaml
lists as ``file`` are written beside it and committed; those it lists as ``made`` are left to the site's build.
``--check`` writes nothing and fails if a committed file isn't what its script makes.
"""

import importlib.util
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent


def files_of(source):
    """The table FILES of a source's make.py."""
    if str(HERE) not in sys.path:
        sys.path.insert(0, str(HERE))
    spec = importlib.util.spec_from_file_location(f"make_{source.name}", source / "make.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.FILES


def main(arguments):
    """Write or check the files of all sources, or of those named."""
    check = "--check" in arguments
    names = [argument for argument in arguments if not argument.startswith("--")]
    differ = 0
    for source in sorted(HERE.iterdir()):
        if not (source / "make.py").exists() or (names and source.name not in names):
            continue
        listed = (source / "source.yaml").read_text("utf-8")
        for name, make in files_of(source).items():
            if f"file: {name}" not in listed:
                continue
            data = make()
            file = source / name
            if not check:
                file.write_bytes(data)
            elif not file.exists() or file.read_bytes() != data:
                differ += 1
                print(f"{source.name}/{name} is not what make.py makes", file=sys.stderr)
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
