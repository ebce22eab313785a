# SPDX-License-Identifier: MIT
"""Misuse gets a defined error, and leaves the object as it was."""
import os
import pathlib
import tempfile
import unittest

import numpy as np

import penumbra
from scenes_of_tests import square

LIGHT = penumbra.Ball((0, 0, 4), 0.5)


class Errors(unittest.TestCase):
    def test_a_bad_file_is_an_error_with_its_parts(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "bad.nff"
            path.write_text("s 0 0 0 1\ns 1 2 x 1\n")
            with self.assertRaises(penumbra.Error) as caught:
                penumbra.read(path)
        error = caught.exception
        self.assertIsInstance(error, ValueError)
        self.assertEqual((error.file, error.line, error.byte), (str(path), 2, None))
        self.assertEqual(str(error), f"{path}:2: {error.problem}")
        with self.assertRaises(penumbra.Error) as caught:
            penumbra.Ball((0, 0, 0), -1)
        self.assertEqual(str(caught.exception),
                         f"{caught.exception.problem}; {caught.exception.hint}")
        self.assertIsNone(caught.exception.file)

    def test_names_of_files_need_not_be_utf_8(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, os.fsdecode(b"bad\xff.nff"))
            pathlib.Path(path).write_text("s 1 2\n")
            with self.assertRaises(penumbra.Error) as caught:
                penumbra.read(path)
        self.assertEqual(caught.exception.file, path)
        self.assertIn("bad\ufffd.nff:", str(caught.exception))

    def test_no_scene_is_an_error_that_names_those_there_are(self):
        with self.assertRaisesRegex(penumbra.Error, "no such file.*cylinders"):
            penumbra.read("not/there.obj")

    def test_questions_before_a_commit_are_errors(self):
        occluders = penumbra.Occluders()
        occluders.add_triangles(*square())
        for ask in (occluders.classify, occluders.visible_fraction, occluders.visible_samples,
                    occluders.visibility):
            with self.assertRaisesRegex(penumbra.Error, "commit"):
                ask([[0, 0, 0]], LIGHT)

    def test_a_commit_that_fails_leaves_what_was_committed(self):
        positions, triangles = square()
        occluders = penumbra.Occluders()
        occluders.add_triangles(positions, triangles)
        occluders.commit()
        positions[0, 0] = np.nan
        with self.assertRaises(penumbra.Error):
            occluders.commit()
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 0)

    def test_vertex_numbers_out_of_range_are_errors(self):
        positions, triangles = square()
        triangles[0, 0] = 4
        occluders = penumbra.Occluders()
        with self.assertRaises(penumbra.Error):
            occluders.add_triangles(positions, triangles)
            occluders.commit()

    def test_handles_used_twice_or_elsewhere_are_errors(self):
        occluders, others = penumbra.Occluders(), penumbra.Occluders()
        positions, triangles = square()
        geometry = occluders.add_triangles(positions, triangles)
        with self.assertRaisesRegex(ValueError, "other occluders"):
            others.remove(geometry)
        occluders.remove(geometry)
        with self.assertRaises(penumbra.Error):
            occluders.remove(geometry)
        with self.assertRaises(penumbra.Error):
            occluders.update(geometry, positions)

    def test_what_is_no_light_is_a_type_error(self):
        occluders = penumbra.Occluders()
        occluders.commit()
        for light in (None, 3, [1, 2, 3], penumbra.Ball):
            with self.assertRaisesRegex(TypeError, r"a light is wanted"):
                occluders.classify([[0, 0, 0]], light)

    def test_options_out_of_range_are_errors(self):
        occluders = penumbra.Occluders()
        occluders.commit()
        for wrong in ({"shadow_samples": 0}, {"shadow_samples": 65537}, {"method": "guess"},
                      {"method": "hard"}):
            with self.assertRaises(ValueError, msg=wrong):
                occluders.visible_fraction([[0, 0, 0]], LIGHT, **wrong)
        for wrong in ({"size": (0, 4)}, {"size": (70000, 4)}, {"shadow_samples": 0},
                      {"layers": ["colour"]}, {"method": "guess"}, {"depth": 0}):
            with self.assertRaises(ValueError, msg=wrong):
                penumbra.render("cylinders", **wrong)

    def test_arguments_of_the_wrong_kind_are_named_with_what_is_wanted(self):
        occluders = penumbra.Occluders()
        occluders.commit()
        scene = penumbra.read("cylinders")
        for ask in (occluders.visible_fraction, occluders.visible_samples, occluders.visibility):
            for name, value in [("offset", "auto"), ("shadow_samples", 1.5),
                                ("shadow_samples", "x"), ("shadow_samples", None),
                                ("threads", None), ("threads", np.zeros(2, int)),
                                ("first_key", 0.5), ("light_index", "x"), ("method", None),
                                ("counters", 3)]:
                with self.assertRaisesRegex(TypeError, f"^{name} is of type .*; give "):
                    ask([[0, 0, 0]], LIGHT, **{name: value})
        for name, value in [("size", (320.0, 240.0)), ("size", 320), ("size", "4,3"),
                            ("shadow_samples", 1.5), ("shadow_samples", np.float32(1.5)),
                            ("depth", None), ("seed", "x"), ("method", None), ("layers", [3])]:
            with self.assertRaisesRegex(TypeError, f"^{name} is of type .*; give "):
                scene.render(**{name: value})
        for name, value in [("ground", (1,)), ("light_radius", [1]), ("fov_deg", "x"),
                            ("clear_glass", "x"), ("waters", "x"), ("style", None)]:
            with self.assertRaisesRegex(TypeError, f"^{name} is of type .*; give "):
                penumbra.read("cylinders", **{name: value})
        for name in ("key", "shadow_samples", "light_index"):
            with self.assertRaisesRegex(TypeError, f"^{name} is of type .*; give "):
                penumbra.light_samples(LIGHT, (0, 0, 0), **{name: 1.5})

    def test_numbers_out_of_range_are_named_with_the_range(self):
        occluders = penumbra.Occluders()
        occluders.commit()
        for ask in (occluders.visible_fraction, occluders.visible_samples):
            for name in ("shadow_samples", "threads", "first_key", "light_index"):
                for value in (-1, 2**64):
                    found = f"^{name} is out of range; give a whole number from 0 to"
                    with self.assertRaisesRegex(ValueError, found):
                        ask([[0, 0, 0]], LIGHT, **{name: value})
        with self.assertRaisesRegex(ValueError, "^threads is out of range"):
            occluders.classify([[0, 0, 0]], LIGHT, threads=-1)
        with self.assertRaisesRegex(ValueError, "^offset is out of range; give a number"):
            occluders.visible_fraction([[0, 0, 0]], LIGHT, offset=10**400)
        for wrong in ({"seed": -1}, {"threads": -1}, {"depth": -1}, {"size": (-1, 5)},
                      {"size": (4, 3, 2)}, {"size": ()}):
            with self.assertRaisesRegex(ValueError, f"^{list(wrong)[0]} is .*; give "):
                penumbra.render("cylinders", **wrong)
        for radius in ("x", "x%", "", "%", -1, "nan"):
            with self.assertRaisesRegex(ValueError, "^light_radius must be above 0"):
                penumbra.read("cylinders", light_radius=radius)

    def test_numbers_of_numpy_are_numbers(self):
        occluders = penumbra.Occluders()
        occluders.commit()
        seen = occluders.visible_fraction([[0, 0, 0]], LIGHT, shadow_samples=np.uint8(8),
                                          threads=np.int64(1), offset=np.float32(0.5),
                                          first_key=np.uint64(2**64 - 1), light_index=np.int32(3))
        self.assertEqual(seen[0], 1)
        picture = penumbra.render("cylinders", size=np.array([4, 3]), shadow_samples=np.int16(1),
                                  clear_glass=np.bool_(True), fov_deg=np.float32(30), ground=0)
        self.assertEqual(picture.shape, (3, 4, 3))

    def test_words_that_are_no_unicode_are_a_type_error(self):
        with self.assertRaisesRegex(TypeError, "^light is "):
            penumbra.Light("sphere 0 0 4 0.5 \udcff")

    def test_points_that_are_not_finite_are_no_crash(self):
        occluders = penumbra.Occluders()
        occluders.add_triangles(*square())
        occluders.commit()
        try:
            seen = occluders.visible_fraction([[np.nan, 0, 0], [np.inf, 0, 0]], LIGHT)
            self.assertEqual(seen.shape, (2,))
        except penumbra.Error as error:
            self.assertIn("finite", str(error))


if __name__ == "__main__":
    unittest.main()
