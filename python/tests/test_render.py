# SPDX-License-Identifier: MIT
"""Pictures as arrays, and back to files."""
import pathlib
import tempfile
import unittest

import numpy as np

import penumbra


class Pictures(unittest.TestCase):
    def test_a_picture_is_linear_and_the_same_by_every_method(self):
        picture = penumbra.render("cylinders", size=(48, 32), shadow_samples=16)
        self.assertEqual((picture.shape, picture.dtype), ((32, 48, 3), np.float32))
        self.assertGreater(picture.max(), 0.1)
        judge = penumbra.render("cylinders", size=(48, 32), shadow_samples=16, method="stochastic")
        np.testing.assert_array_equal(picture, judge)
        hard = penumbra.render("cylinders", size=(48, 32), method="hard")
        self.assertFalse(np.array_equal(picture, hard))

    def test_threads_change_nothing(self):
        one, two = (penumbra.render("balls:2", size=(40, 40), threads=n) for n in (1, 2))
        np.testing.assert_array_equal(one, two)

    def test_layers_come_as_a_dict(self):
        scene = penumbra.read("cylinders")
        layers = scene.render(size=(24, 16),
                              layers=["class", "visibility", "depth", "normal", "samples"])
        count = len(scene.lights)
        self.assertEqual({name: layer.shape for name, layer in layers.items()},
                         {"color": (16, 24, 3), "class": (16, 24, count),
                          "visibility": (16, 24, count), "depth": (16, 24),
                          "normal": (16, 24, 3), "samples": (16, 24)})
        self.assertEqual(layers["class"].dtype, np.uint8)
        lit = layers["class"] == penumbra.LIT
        self.assertTrue(np.all(layers["visibility"][lit] == 1))
        self.assertEqual(list(scene.render(size=(4, 4), layers=[])), ["color"])

    def test_wishes_reach_the_scene(self):
        sun = penumbra.Sun((0, 0.2, 1), 5)
        scene = penumbra.read("cylinders", lights=[sun, "point 0 0 90"], ground=None,
                              camera_from=(0, -9, 5), camera_at=(0, 0, 0), fov_deg=30,
                              background=(0.25, 0.5, 1))
        self.assertEqual([type(light.shape).__name__ for light in scene.lights], ["Sun", "Point"])
        self.assertEqual(scene.camera.position, (0, -9, 5))
        self.assertEqual(scene.camera.fov_deg, 30)
        balls = penumbra.read("cylinders", lights="point 0 0 90", light_radius=2)
        self.assertEqual(repr(balls.lights[0].shape), "Ball(center=(0.0, 0.0, 90.0), radius=2.0)")
        for wrong in ({"ground": "soft"}, {"light_radius": -1}, {"light_radius": "x%"},
                      {"style": "sticks"}, {"camera_from": (1, 2)}, {"fov_deg": 0}):
            with self.assertRaises(ValueError, msg=wrong):
                penumbra.read("cylinders", **wrong)

    def test_a_scene_that_is_read_takes_no_more_wishes(self):
        with self.assertRaisesRegex(TypeError, "ground"):
            penumbra.render(penumbra.read("cylinders"), ground=None)

    def test_scenes_tell_what_they_are(self):
        scene = penumbra.read("balls:1")
        self.assertEqual(scene.primitives, 10 + scene.primitives - 10)
        self.assertEqual(scene.bounds.shape, (2, 3))
        self.assertTrue(np.all(scene.object_bounds[0] >= scene.bounds[0]))
        self.assertEqual(scene.warnings, [])
        self.assertEqual(len(scene.up), 3)

    def test_pictures_are_written_whole_or_not_at_all(self):
        picture = penumbra.render("cylinders", size=(24, 16), layers=["depth", "normal"])
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            penumbra.write_image(folder / "a.png", picture["color"], exposure=1)
            penumbra.write_image(folder / "a.exr", picture["color"], layers=picture)
            self.assertEqual(sorted(p.name for p in folder.iterdir()), ["a.exr", "a.png"])
            for path, image in [(folder / "b.gif", picture["color"]),
                                (folder / "no" / "b.png", picture["color"]),
                                (folder / "b.png", picture["depth"]),
                                (folder / "b.png", np.zeros((0, 0, 3)))]:
                with self.assertRaises(ValueError):
                    penumbra.write_image(path, image)
            self.assertEqual(sorted(p.name for p in folder.iterdir()), ["a.exr", "a.png"])

    def test_srgb_codes_are_those_of_the_standard(self):
        codes = penumbra.to_srgb([0, 0.0031308, 0.5, 1, 2, -1, np.nan])
        np.testing.assert_array_equal(codes, [0, 10, 188, 255, 255, 0, 0])
        np.testing.assert_array_equal(penumbra.to_srgb([[0.25]], exposure=1), [[188]])


if __name__ == "__main__":
    unittest.main()
