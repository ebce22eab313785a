# SPDX-License-Identifier: MIT
"""bake_test.py PROGRAM [TEST...]: `penumbra bake`, from files to textures."""
import base64
import json
import struct

from cli_case import CliTest, main

SMALL = ["--size", "32x32", "--shadow-samples", "4"]
LAMP = ["--light", "sphere", "1", "5", "1", "0.5"]


def floor_obj(uvs="0 0\nvt 1 0\nvt 1 1\nvt 0 1"):
    """The square [0, 4]^2 at y = 0, seen from above, and a small square over its middle."""
    return ("v 0 0 0\nv 0 0 4\nv 4 0 4\nv 4 0 0\nvt " + uvs + "\nf 1/1 2/2 3/3 4/4\n"
            "v 1.5 1 1.5\nv 1.5 1 2.5\nv 2.5 1 2.5\nv 2.5 1 1.5\nf 5 6 7 8\n")


def gltf(meshes, nodes):
    """Meshes as (name, uvs): squares as above, beside each other."""
    corners = [(0, 0, 0), (0, 0, 4), (4, 0, 4), (4, 0, 0)]
    data = b"".join(struct.pack("<3f", *c) for c in corners) + struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    views = [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}]
    accessors = [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 4},
                 {"bufferView": 1, "componentType": 5123, "type": "SCALAR", "count": 6}]
    written = []
    for name, uvs in meshes:
        attributes = {"POSITION": 0}
        if uvs:
            views.append({"buffer": 0, "byteOffset": len(data), "byteLength": 32})
            data += b"".join(struct.pack("<2f", *uv) for uv in uvs)
            attributes["TEXCOORD_1"] = len(accessors)
            accessors.append({"bufferView": len(views) - 1, "componentType": 5126, "type": "VEC2", "count": 4})
        written.append({"name": name, "primitives": [{"attributes": attributes, "indices": 1}]})
    uri = "data:application/octet-stream;base64," + base64.b64encode(data).decode()
    return json.dumps({"asset": {"version": "2.0"}, "scenes": [{"nodes": list(range(len(nodes)))}],
                       "nodes": [{"mesh": mesh, "translation": [5 * i, 0, 0]} for i, mesh in enumerate(nodes)],
                       "meshes": written, "accessors": accessors, "bufferViews": views,
                       "buffers": [{"byteLength": len(data), "uri": uri}]})


WHOLE = [(0, 0), (0, 1), (1, 1), (1, 0)]


class Bake(CliTest):
    def setUp(self):
        super().setUp()
        (self.folder / "floor.obj").write_text(floor_obj())
        (self.folder / "two.gltf").write_text(gltf([("a b/c", WHOLE), ("d", WHOLE)], [0, 1]))

    def bake(self, *arguments):
        return self.succeed("bake", *arguments, *SMALL, *LAMP)

    def test_exr_with_all_layers_and_stats(self):
        result = self.bake("floor.obj", "-o", "map.exr", "--layers", "class,coverage", "--stats", "map.json",
                           "--light", "sun", "0", "1", "0", "5")
        self.assertRegex(result.stderr, r"wrote map.exr: 32x32, 2 lights, 1024 texels; lit \d+ %, penumbra \d+ %, "
                                        r"umbra \d+ %; \d+\.\d s")
        data = (self.folder / "map.exr").read_bytes()
        for name in [b"visibility.light0", b"visibility.light1", b"class.light1", b"coverage", b"ShadowSamples"]:
            self.assertIn(name + b"\0", data)
        stats = json.loads((self.folder / "map.json").read_text())
        for key in ["version", "scene", "method", "shadow_samples", "texel_samples", "size", "padding", "weight",
                    "seed", "threads", "lights", "files", "uv_set", "seconds", "texels", "texel_classes", "samples",
                    "shadow_rays", "triangles", "peak_rss_bytes"]:
            self.assertIn(key, stats)
        self.assertEqual(stats["texels"]["covered"], 1024)
        self.assertEqual(sum(stats["texel_classes"].values()), 2048)

    def test_png_one_a_light(self):
        self.bake("floor.obj", "-o", "map.png", "--bits", "16", "--light", "sun", "0", "1", "0", "5")
        self.assertEqual(self.files(), ["floor.obj", "map-light0.png", "map-light1.png", "small.nff", "two.gltf"])
        header = (self.folder / "map-light0.png").read_bytes()[16:26]
        self.assertEqual(struct.unpack(">IIBB", header), (32, 32, 16, 0))
        self.bake("floor.obj", "-o", "mean.png", "--channel", "mean", "--light", "sun", "0", "1", "0", "5")
        self.assertIn("mean.png", self.files())

    def test_all_methods_and_threads_bake_the_same(self):
        sixteen = ["--channel", "mean", "--bits", "16"]
        self.bake("floor.obj", "-o", "judge.png", "--method", "stochastic", *sixteen)
        for options in [["--method", "umbra"], ["--threads", "1"], ["--threads", "3"]]:
            self.bake("floor.obj", "-o", "other.png", *sixteen, *options)
            self.succeed("compare", "judge.png", "other.png")
        self.bake("floor.obj", "-o", "other.png", "--seed", "1", *sixteen)
        self.assertEqual(self.run_program("compare", "judge.png", "other.png").returncode, 1)

    def test_overlapping_meshes_are_told_and_get_a_texture_each(self):
        result = self.bake("two.gltf", "-o", "map.png")
        self.assertRegex(result.stderr, r"warning: two.gltf: \d+ texels lie in two triangles or more.*--per-mesh")
        result = self.bake("two.gltf", "-o", "map.png", "--per-mesh")
        self.assertNotIn("two triangles", result.stderr)
        self.assertIn("map-a_b_c.png", self.files())
        self.assertIn("map-d.png", self.files())
        for which in ["d", "1"]:
            self.assertNotIn("warning", self.bake("two.gltf", "-o", "one.png", "--mesh", which).stderr)

    def test_no_two_meshes_share_a_file(self):
        names = ["a-3", "a", "b", "a"]
        (self.folder / "four.gltf").write_text(gltf([(name, WHOLE) for name in names], range(4)))
        self.bake("four.gltf", "-o", "o.png", "--per-mesh", "--stats", "s.json")
        files = json.loads((self.folder / "s.json").read_text())["files"]
        self.assertEqual(files[:3], ["o-a-3.png", "o-a.png", "o-b.png"])
        self.assertEqual(len(set(files)), 4)
        self.assertLessEqual(set(files), set(self.files()))

    def test_what_cannot_be_baked_is_refused_or_told(self):
        def fail(model, *more, says):
            self.fail_with(1, "bake", model, "-o", "x.png", *more, *LAMP, says=says)

        fail("small.nff", says="no mesh has texture coordinates.*xatlas")
        fail("two.gltf", "--uv-set", "1", says="Lightmap Pack")
        fail("two.gltf", "--mesh", "x", says="no mesh x .*0 a b/c, 1 d")
        fail("floor.obj", "--mesh", "x", says=r"no mesh x .*: 0 \(no name\)")
        fail("none.obj", says="no such file")
        (self.folder / "flat.obj").write_text(floor_obj("0 0\nvt 0 0\nvt 0 0\nvt 0 0"))
        fail("flat.obj", says="none of its .* triangles has a place")
        (self.folder / "tiled.obj").write_text(floor_obj("0 0\nvt 3 0\nvt 3 3\nvt 0 3"))
        self.assertRegex(self.bake("tiled.obj", "-o", "x.png").stderr, "2 of 4 triangles reach out of the texture")

    def test_neither_lights_nor_ground_are_added(self):
        self.fail_with(1, "bake", "floor.obj", "-o", "x.png", says=r"^floor\.obj: has no lights; .*--light sun")
        below = ["--light", "sphere", "1", "-5", "1", "0.5"]
        result = self.succeed("bake", "floor.obj", "-o", "x.png", *SMALL, *LAMP, *below)
        self.assertRegex(result.stderr, r"light0: sphere 1 5 1 0\.5.*\nlight1: sphere 1 -5 1 0\.5")
        # Seen from below, with the turn of its corners.
        (self.folder / "below.obj").write_text(floor_obj().replace("f 1/1 2/2 3/3 4/4", "f 4/4 3/3 2/2 1/1"))
        for ground, lit in {"none": 0.5, "-1": 0}.items():
            self.succeed("bake", "below.obj", "-o", "x.png", *SMALL, *below, "--ground", ground, "--stats", "s.json")
            stats = json.loads((self.folder / "s.json").read_text())
            self.assertGreaterEqual(stats["texel_classes"]["lit"], lit * stats["texels"]["covered"])
            self.assertEqual(stats["texel_classes"]["lit"] == 0, lit == 0)

    def test_instances_share_no_texels(self):
        (self.folder / "many.gltf").write_text(gltf([("a", WHOLE), ("d", None)], [0, 0, 1]))
        # So few triangles are shapes of their own, which lie in one place of the texture.
        self.assertRegex(self.bake("many.gltf", "-o", "x.png").stderr, "two triangles or more")

    def test_usage(self):
        bad = {"--size": ["0x0", "x"], "--padding": ["-1", "5000"], "--texel-samples": ["0", "x"],
               "--bits": ["12", "32"], "--channel": ["red"], "--layers": ["depth"], "--uv-set": ["3"],
               "--weight": ["sine"], "--method": ["magic"], "--shadow-samples": ["0"]}
        for option, values in bad.items():
            for value in values:
                self.fail_with(2, "bake", "floor.obj", "-o", "x.png", option, value, says=f"{option}.* {value}")
        self.fail_with(2, "bake", "floor.obj", "-o", "x.jpg", says="ends in .png or .exr")
        self.fail_with(2, "bake", "floor.obj", says="-o FILE is missing")
        self.fail_with(2, "bake", "-o", "x.png", says="MODEL is missing")
        self.fail_with(2, "bake", "floor.obj", "-o", "x.png", "--layers", "class", says="needs an .exr")
        self.fail_with(2, "bake", "floor.obj", "-o", "x.exr", "--bits", "16", says="for .png")
        self.fail_with(2, "bake", "floor.obj", "-o", "x.png", "--bits", "16", "--srgb", says="choose one")
        self.fail_with(2, "bake", "two.gltf", "-o", "x.png", "--mesh", "d", "--per-mesh", says="choose one")
        self.fail_with(2, "bake", "floor.obj", "-o", "x.exr", "--stats", "x.exr", *LAMP, says="same file")
        self.fail_with(1, "bake", "floor.obj", "-o", "nowhere/x.png", *LAMP, says="cannot be written")

    def test_progress(self):
        result = self.bake("floor.obj", "-o", "x.png", "--progress")
        self.assertIn("baking floor.obj 100 %", result.stderr)


if __name__ == "__main__":
    main()
