# SPDX-License-Identifier: MIT
"""examples_test.py EXAMPLE PENUMBRA [PROGRAM]: the examples run, and what they show is so."""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


class ExampleTest(unittest.TestCase):
    penumbra = program = ""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="penumbra-")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def run_there(self, *command):
        result = subprocess.run([str(word) for word in command], cwd=self.folder, capture_output=True, text=True,
                                timeout=300, check=False)
        self.assertEqual(result.returncode, 0, f"{command}\n{result.stdout}\n{result.stderr}")
        return result

    def test_examples_are_short(self):
        sources = [path for path in EXAMPLES.glob("**/*") if path.suffix in {".c", ".cpp", ".h", ".py"}]
        self.assertGreaterEqual(len(sources), 5)
        for path in sources:
            self.assertLess(len(path.read_text().splitlines()), 120, path)


class c_api(ExampleTest):  # pylint: disable=invalid-name
    def test_it_draws_a_dark_spot_with_soft_edges_twice_and_shows_an_error(self):
        result = self.run_there(self.program)
        first, second, _ = result.stdout.split(" sampled\n\n")
        for picture in (first, second):
            self.assertTrue({" ", ".", ":", "-", "=", "+", "*", "%", "@"} <= set(picture), picture)
        self.assertNotEqual(first, second)
        self.assertRegex(result.stderr, r"^penumbra's error 1: penumbra_classify: .*diameter.*; ")


class embree_renderer(ExampleTest):  # pylint: disable=invalid-name
    def pixels(self, name):
        head, data = (self.folder / name).read_bytes().split(b"\n", 1)
        self.assertEqual(head, b"P5 160 160 255")
        self.assertEqual(len(data), 160 * 160)
        return data

    def test_both_ways_draw_the_same_shadows(self):
        self.run_there(self.penumbra, "generate", "bust", "-o", "bust.ply")
        printed = self.run_there(self.program, "bust.ply", "160").stdout
        print(printed)  # with the times, for the log
        told = re.search(r"(\d+) points: .* times as fast; fractions differ by ([\d.]+)", printed)
        points, difference = told.groups()
        self.assertGreater(int(points), 5000)
        self.assertLess(float(difference), 0.005)
        before, after = self.pixels("embree.pgm"), self.pixels("penumbra.pgm")
        self.assertGreater(max(after) - min(after), 100)
        self.assertLess(sum(abs(a - b) for a, b in zip(before, after)) / len(before), 0.5)
        self.assertTrue(any(a != b for a, b in zip(before, after)), "other samples were drawn")

    def test_what_is_no_mesh_is_refused(self):
        result = subprocess.run([self.program, "none.ply"], capture_output=True, text=True, check=False)
        self.assertEqual((result.returncode, result.stderr), (1, "none.ply: not such a PLY file\n"))


class bake_gltf(ExampleTest):  # pylint: disable=invalid-name
    def test_the_shadows_are_in_the_file(self):
        self.run_there(sys.executable, EXAMPLES / "bake_gltf.py", self.penumbra, ".")
        data = (self.folder / "baked.glb").read_bytes()
        self.assertEqual(struct.unpack_from("<4sII", data), (b"glTF", 2, len(data)))
        self.assertIn((self.folder / "shadow.png").read_bytes(), data)
        # Without the texture the picture is another one.
        look = ["--ground", "none", "--ambient", "1,1,1", "--light", *"point 0 9 0 0 0 0".split(), "--from", "5,6,9",
                "--size", "64x48"]
        for name in ("model", "baked"):
            self.run_there(self.penumbra, "render", f"{name}.glb", "-o", f"{name}.exr", *look)
        result = subprocess.run([self.penumbra, "compare", "model.exr", "baked.exr"], cwd=self.folder,
                                capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 1, result.stderr)


class sun_study(ExampleTest):  # pylint: disable=invalid-name
    def test_it_plots_and_prints(self):
        printed = self.run_there(sys.executable, EXAMPLES / "sun_study.py", "sun.png").stdout
        self.assertEqual(len(re.findall(r"\d to +\d+\.\d+ hours", printed)), 3, printed)
        self.assertGreater((self.folder / "sun.png").stat().st_size, 10000)

    def test_where_nothing_stands_the_hours_are_those_of_the_almanac(self):
        sys.path.insert(0, str(EXAMPLES))
        import sun_study as study  # pylint: disable=import-outside-toplevel,import-self
        house = study.BLOCK[:1]
        points = study.front(house, 6)
        # At the equinox the sun stands south of east and west all day; at 52.5 degrees the shortest day has 7.6 hours
        # (7 h 37 min of geometric sunshine), on which it rises and sets in the south.
        for day, hours in ((80, 12.0), (355, 7.6)):
            found = study.hours_of_sun(house, points, (0, -1, 0), day)
            self.assertLess(abs(found - hours).max(), 0.1, day)
        # And a wall before it takes all of it.
        wall = house + [(-500, 500, -2, -1, 500)]
        self.assertEqual(study.hours_of_sun(wall, points, (0, -1, 0), 80).max(), 0)


if __name__ == "__main__":
    chosen = globals()[sys.argv.pop(1)]
    ExampleTest.penumbra = sys.argv.pop(1)
    ExampleTest.program = sys.argv.pop(1) if len(sys.argv) > 1 else ""
    unittest.main(defaultTest=chosen.__name__)
