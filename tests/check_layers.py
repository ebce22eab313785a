# SPDX-License-Identifier: MIT
"""check_layers.py ROOT: a folder of penumbra/ includes only itself and the folders listed before it, and scene_io is
used by programs, tests and benches alone."""
import pathlib
import re
import sys

INCLUDE = re.compile(r'\s*#\s*include\s*[<"]penumbra/(\w+)/')


def complaints(root):
    layers = {path.name for path in (root / "penumbra").iterdir() if path.is_dir()}
    for path in sorted((root / "penumbra").glob("*/**/*")):
        if path.suffix not in {".h", ".cpp"}:
            continue
        here = path.relative_to(root / "penumbra").parts[0]
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            there = match[1]
            place = f"{path.relative_to(root)}:{number}"
            if there not in layers:
                yield f"{place}: there is no layer {there}"
            elif there > here:
                yield f"{place}: {here} may not include {there}, which stands below it"
            elif there == "scene_io" != here:
                yield f"{place}: only programs, tests and benches use scene_io"


def main():
    found = list(complaints(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "layers ok")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
