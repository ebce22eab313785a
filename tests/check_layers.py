# SPDX-License-Identifier: MIT
"""check_layers.py ROOT: a folder of penumbra/ includes only itself and the folders listed before it, scene_io is used
by programs, tests and benches alone, and a source includes the header of its name before all others."""
import pathlib
import re
import sys

INCLUDE = re.compile(r'\s*#\s*include\s*[<"]penumbra/(\w+)/')
FIRST_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)', re.MULTILINE)


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


def complaints_of_sources(root):
    for path in sorted((root / "penumbra").glob("*/**/*.cpp")):
        header = path.with_suffix(".h")
        if not header.exists():
            continue
        first = FIRST_INCLUDE.search(path.read_text(encoding="utf-8"))
        if not first or root / first[1] != header:
            yield f"{path.relative_to(root)}: does not include {header.relative_to(root)} before all others"


def main():
    root = pathlib.Path(sys.argv[1])
    found = [*complaints(root), *complaints_of_sources(root)]
    print("\n".join(found) or "layers ok")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
