# SPDX-License-Identifier: MIT
"""bake_gltf.py PENUMBRA [FOLDER]: soft shadows baked into a glTF file, for viewers that have none.

Blocks on a floor, a place in the texture for each of their sides: model.glb. `penumbra bake` fills the texture with
what each texel sees of a lamp and a sky: shadow.png. The same model with that as its colour, times that of its
material, not lit again (KHR_materials_unlit): baked.glb, for any viewer or game engine. PENUMBRA is the program.
"""
import json
import pathlib
import struct
import subprocess
import sys

import numpy as np

CELLS = 6  # a side of the texture; each holds one quad
TEXELS = 480
LIGHTS = ["--light", "sphere", "-4", "5", "-1", "0.5", "--light", "disk", "0", "9", "0", "0", "1", "0", "7"]
COLORS = {"floor": (0.9, 0.88, 0.84), "red": (0.85, 0.3, 0.22), "blue": (0.25, 0.45, 0.8),
          "green": (0.4, 0.65, 0.3), "yellow": (0.95, 0.75, 0.25)}


def block(color, center, size):
    """Its five sides that can be seen, as (color, corner, edge, edge); edges' cross product looks outwards. y is up."""
    x, y, z = np.diag(size)
    low = np.array(center) - np.array(size) / 2
    return [(color, low + y, z, x), (color, low + z, x, y), (color, low + x + z, -z, y), (color, low + x, -x, y),
            (color, low, z, y)]


def model():
    """All quads. The floor is of 16, side by side in space and each elsewhere in the texture: no seam is to be seen."""
    quads = [("floor", np.array([2.0 * i - 4, 0, 2.0 * j - 4]), np.array([0, 0, 2.0]), np.array([2.0, 0, 0]))
             for i in range(4) for j in range(4)]
    quads += block("red", (-0.8, 1, -1.2), (1, 2, 1))
    quads += block("blue", (1, 0.6, 0.2), (1.4, 1.2, 0.8))
    quads += block("green", (-1.4, 0.4, 1.2), (0.8, 0.8, 0.8))
    quads += block("yellow", (1.2, 2.3, 0.2), (2.6, 0.2, 1.6))
    return quads


def write_glb(path, quads, texture=None):
    """One mesh, a primitive a color. `texture` is the bytes of a PNG, which becomes the color as it is."""
    blobs, views, accessors = [], [], []

    def view(data):
        views.append({"buffer": 0, "byteOffset": sum(map(len, blobs)), "byteLength": len(data)})
        blobs.append(data + b"\0" * (-len(data) % 4))
        return len(views) - 1

    def accessor(array, kind):
        accessors.append({"bufferView": view(array.tobytes()), "type": kind, "count": len(array),
                          "componentType": 5126 if array.dtype == np.float32 else 5125,
                          "min": array.min(axis=0).tolist(), "max": array.max(axis=0).tolist()})
        return len(accessors) - 1

    def primitive(number, color):
        positions, uvs, triangles = [], [], []
        for index, (_, corner, u, v) in enumerate(quads):
            if quads[index][0] == color:
                cell = np.array([index % CELLS, index // CELLS])
                for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    positions.append(corner + a * u + b * v)
                    uvs.append((cell + 0.05 + 0.9 * np.array([a, b])) / CELLS)  # room for the padding around
                triangles += [len(positions) - 4 + k for k in (0, 1, 2, 0, 2, 3)]
        return {"material": number, "indices": accessor(np.array(triangles, np.uint32).reshape(-1, 1), "SCALAR"),
                "attributes": {"POSITION": accessor(np.array(positions, np.float32), "VEC3"),
                               "TEXCOORD_0": accessor(np.array(uvs, np.float32), "VEC2")}}

    gltf = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"name": "blocks", "primitives": [primitive(i, color) for i, color in enumerate(COLORS)]}]}
    surface = {"metallicFactor": 0}
    if texture:
        surface["baseColorTexture"] = {"index": 0}
        gltf.update(textures=[{"source": 0}], images=[{"bufferView": view(texture), "mimeType": "image/png"}],
                    extensionsUsed=["KHR_materials_unlit"])
    gltf["materials"] = [{"name": name, "pbrMetallicRoughness": {**surface, "baseColorFactor": [*color, 1]},
                          **({"extensions": {"KHR_materials_unlit": {}}} if texture else {})}
                         for name, color in COLORS.items()]
    data = b"".join(blobs)
    gltf.update(accessors=accessors, bufferViews=views, buffers=[{"byteLength": len(data)}])
    text = json.dumps(gltf).encode()
    text += b" " * (-len(text) % 4)
    path.write_bytes(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(data))
                     + struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data)


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else ".")
    quads = model()
    write_glb(folder / "model.glb", quads)
    subprocess.run([program, "bake", folder / "model.glb", "-o", folder / "shadow.png", "--channel", "mean", "--srgb",
                    "--weight", "cosine", "--size", f"{TEXELS}x{TEXELS}", *LIGHTS], check=True)
    write_glb(folder / "baked.glb", quads, (folder / "shadow.png").read_bytes())
    # A look at it, by no more light than shows textures as they are.
    subprocess.run([program, "render", folder / "baked.glb", "-o", folder / "baked.png", "--ground", "none",
                    "--spp", "4", "--ambient", "1,1,1", "--light", "point", "0", "9", "0", "0", "0", "0",
                    "--from", "5,6,9", "--at", "0.2,0.4,0.3", "--fov", "36", "--size", "640x480"], check=True)


if __name__ == "__main__":
    main()
