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
