# SPDX-License-Identifier: MIT
"""The commands of README.md and docs/library.md: the files they name, and what of them is not run here and why."""
import pathlib
import re
import shutil
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples"))
import bake_gltf  # noqa: E402

# Nothing else is left out.
NOT_RUN = {
    "./demo": "builds all there is",
    "./test": "runs this",
    "tools/prepare release installable": "installs packages",
    "sudo cmake --install build && sudo ldconfig": "changes the system; the test `install` does it elsewhere",
    "cmake --install build --prefix ~/penumbra": "done before all others, to another place",
    "cd build && cpack -G DEB": "takes a minute",
    "sudo apt-get install ./penumbra_*_amd64.deb": "changes the system",
    "penumbra reproduce -o reproduction": "takes 20 minutes",
    "penumbra reproduce -o mine --quick --bust scan.ply --molecule 1hpv.pdb": "the test `cli.reproduce` does so",
}

RAD = "void light on\n0\n0\n3 9 9 9\non sphere lamp\n0\n0\n4 2 1 2.7 .1\nvoid plastic grey\n0\n0\n5 .5 .5 .5 0 0\n"
RAD += "".join(
    f"grey polygon {name}\n0\n0\n12 {corners}\n" for name, corners in (
        ("floor", "0 -5 0 5 -5 0 5 5 0 0 5 0"), ("wall", "0 5 0 5 5 0 5 5 3 0 5 3")))
PBRT = ('LookAt 0 -6 2 0 0 0 0 0 1\nCamera "perspective"\nWorldBegin\nAreaLightSource "diffuse" "rgb L" [9 9 9]\n'
        'Shape "trianglemesh" "point3 P" [-1 -1 3 1 -1 3 0 1 3] "integer indices" [0 2 1]\n')
PBRT += 'AttributeBegin\nShape "sphere" "float radius" 1\nAttributeEnd\n'
PDB = "".join(f"HETATM{i:5d}  {e}   LIG A   1    {x:8.3f}{y:8.3f}{z:8.3f}  1.00  0.00           {e}\n"
              for i, (e, x, y, z) in enumerate((("C", 0, 0, 0), ("O", 1.2, 0, 0), ("N", -0.7, 1.2, 0)), 1))


def make_files(folder, run):
    """What the commands name, small; `run` runs programs there."""
    if (folder / "bust.ply").exists():
        return
    run("penumbra", "generate", "bust", "-o", "bust.ply")
    run("penumbra", "generate", "balls:4", "-o", "balls4.nff")
    shutil.copy(folder / "bust.ply", folder / "city.ply")
    bake_gltf.write_glb(folder / "room.glb", bake_gltf.model())
    text = (ROOT / "tests/scene_io/corpus/gltf/lights.gltf").read_bytes()
    text += b" " * (-len(text) % 4)
    (folder / "lamp.glb").write_bytes(struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text), len(text), b"JSON") + text)
    (folder / "kitchen").mkdir()
    (folder / "kitchen" / "scene.pbrt").write_text(PBRT)
    (folder / "office.rad").write_text(RAD)
    (folder / "1crn.pdb").write_text(PDB)
    (folder / "facade.csv").write_text("0 -3 0 0 -1 0\n0 -3 1 0 -1 0\n")
    (folder / "scan.ply").write_text("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                                     "property float z\nend_header\n0 1 0\n1 1 0\n")
    run(sys.executable, "-c", "import numpy; numpy.save('grid.npy', numpy.zeros((4, 6), 'f4'))")
    for name in ("a.exr", "b.exr"):
        run("penumbra", "render", "balls:1", "-o", name, "--size", "8x8")


def quick(command):
    """The same for a small picture: sizes, samples a pixel, rounds and lists are not what is shown."""
    if re.match(r"penumbra (render|bench|bake)\b", command) and "--pixel" not in command:
        command = re.sub(r" --size \S+| --spp \S+", "", command) + " --size 16x16"
    if command.startswith("penumbra bench"):
        command = re.sub(r"( --[\w-]+ [^ ,]+),\S+", r"\1", command) + " --rounds 1"  # the first of each list
    return re.sub(r" --verify \d+", " --verify 50", command)
