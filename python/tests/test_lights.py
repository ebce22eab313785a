# SPDX-License-Identifier: MIT
"""Lights: made, refused, printed, and asked for their samples."""
import copy
import pickle
import unittest

import numpy as np

import penumbra

LIGHTS = [
    penumbra.Point((0, 0, 4)),
    penumbra.Ball((0, 0, 4), 0.5),
    penumbra.Disk((0, 0, 4), (0, 0, 2), 0.5),
    penumbra.Sun((0, 0, 2)),
    penumbra.Line((-1, 0, 4), (1, 0, 4)),
    penumbra.Parallelogram((0, 0, 4), (1, 0, 0), (0, 1, 0)),
    penumbra.Polygon([(-1, -1, 4), (1, -1, 4), (0, 1, 4)]),
    penumbra.Hull([(-1, -1, 4), (1, -1, 4), (0, 1, 4), (0, 0, 5)]),
]


class Lights(unittest.TestCase):
    def test_each_kind_can_be_asked_about(self):
        occluders = penumbra.Occluders()
        occluders.add_spheres([[50, 0, 0]], 1)
        occluders.commit()
        for light in LIGHTS:
            seen = occluders.visible_fraction([[0, 0, 0]], light, normals=[0, 0, 1])
            self.assertEqual(seen[0], 1, light)

    def test_each_kind_is_printed_as_it_is_made(self):
        for light in LIGHTS:
            again = eval(repr(light), vars(penumbra))  # pylint: disable=eval-used
            self.assertEqual(repr(again), repr(light))
        self.assertEqual(repr(LIGHTS[1]), "Ball(center=(0.0, 0.0, 4.0), radius=0.5)")

    def test_equal_lights_are_those_of_equal_parts(self):
        for i, light in enumerate(LIGHTS):
            again = eval(repr(light), vars(penumbra))  # pylint: disable=eval-used
            self.assertEqual(again, light)
            self.assertEqual(hash(again), hash(light))
            for other in LIGHTS[:i] + LIGHTS[i + 1:] + [None, repr(light), penumbra.Light(light)]:
                self.assertNotEqual(light, other)
        self.assertNotEqual(penumbra.Ball((0, 0, 4), 0.5), penumbra.Ball((0, 0, 4), 0.25))
        lamp = penumbra.Light(LIGHTS[1], (1, 2, 3), "inverse_square")
        self.assertEqual(lamp, penumbra.Light(LIGHTS[1], (1, 2, 3), "inverse_square"))
        self.assertEqual(len({lamp, copy.copy(lamp), *LIGHTS, *copy.deepcopy(LIGHTS)}), 9)
        for other in (penumbra.Light(LIGHTS[1], (1, 2, 3)), penumbra.Light(LIGHTS[1]),
                      penumbra.Light(LIGHTS[0], (1, 2, 3), "inverse_square")):
            self.assertNotEqual(lamp, other)

    def test_copies_and_pickles_are_equal_to_the_last_bit(self):
        odd = [penumbra.Sun((1, 2, 3), 0.1), penumbra.Disk((1, 2, 3), (3, 2, 1), 0.1),
               penumbra.Line((0.1, 0.2, 0.3), (1e6, 7, 0.7))]
        for light in LIGHTS + odd + [penumbra.Light(light, (1, 2, 3)) for light in LIGHTS]:
            sent = pickle.loads(pickle.dumps(light))
            for again in (copy.copy(light), copy.deepcopy(light), sent):
                self.assertEqual(again, light)
                self.assertEqual(repr(again), repr(light))
                shape, same = getattr(light, "shape", light), getattr(again, "shape", again)
                np.testing.assert_array_equal(penumbra.light_samples(same, (0, 0, -1)),
                                              penumbra.light_samples(shape, (0, 0, -1)))

    def test_beams_are_copied_too(self):
        spot = penumbra.Light("sphere 0 0 4 0.5 1 2 3 beam 0 0 -1 10 20")
        self.assertEqual(pickle.loads(pickle.dumps(spot)), spot)
        self.assertEqual(copy.copy(spot).words, spot.words)
        self.assertNotEqual(spot, penumbra.Light(spot.shape, spot.intensity, spot.falloff))

    def test_directions_become_unit(self):
        self.assertEqual(LIGHTS[2].normal, (0, 0, 1))
        self.assertEqual(LIGHTS[3].towards, (0, 0, 1))
        self.assertAlmostEqual(LIGHTS[3].diameter_deg, 0.533, places=5)

    def test_what_is_no_light_is_an_error(self):
        for make in (lambda: penumbra.Ball((0, 0, 0), 0), lambda: penumbra.Ball((0, 0, 0), np.nan),
                     lambda: penumbra.Ball((np.inf, 0, 0), 1), lambda: penumbra.Sun((0, 0, 0)),
                     lambda: penumbra.Sun((0, 0, 1), 180),
                     lambda: penumbra.Line((1, 1, 1), (1, 1, 1)),
                     lambda: penumbra.Polygon([(0, 0, 0), (1, 0, 0)]),
                     lambda: penumbra.Hull([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0)])):
            with self.assertRaises(penumbra.Error):
                make()
        with self.assertRaisesRegex(ValueError, "center is of shape"):
            penumbra.Ball((0, 0), 1)

    def test_words_are_lights_too(self):
        light = penumbra.Light("sphere 0 0 4 0.5 1 2 3")
        self.assertEqual(repr(light.shape), repr(LIGHTS[1]))
        self.assertEqual(light.intensity, (1, 2, 3))
        self.assertEqual(light.words, "sphere 0 0 4 0.5 1 2 3")
        self.assertEqual(penumbra.Light(LIGHTS[1]).intensity, (1, 1, 1))
        with self.assertRaises(penumbra.Error):
            penumbra.Light("sphere 0 0")

    def test_samples_lie_on_the_light_and_repeat(self):
        ways = penumbra.light_samples(LIGHTS[1], (0, 0, 0), key=7, shadow_samples=64)
        self.assertEqual((ways.shape, ways.dtype), ((64, 3), np.float32))
        distance = np.linalg.norm(ways - np.array([0, 0, 4]), axis=1)
        self.assertTrue(np.all(distance <= 0.5 + 1e-5))
        again = penumbra.light_samples(LIGHTS[1], (0, 0, 0), key=7, shadow_samples=64)
        np.testing.assert_array_equal(ways, again)
        other = penumbra.light_samples(LIGHTS[1], (0, 0, 0), key=8, shadow_samples=64)
        self.assertFalse(np.array_equal(ways, other))
        final = penumbra.light_samples(LIGHTS[1], (0, 0, 0), key=7, light_index=None)
        self.assertFalse(np.array_equal(final, ways[:32]))
        directions = penumbra.light_samples(LIGHTS[3], (0, 0, 0))
        np.testing.assert_allclose(np.linalg.norm(directions, axis=1), 1, atol=1e-6)

    def test_samples_of_final_keys_are_those_that_are_asked_with_them(self):
        """Computed here: the ways that pass a disk by."""
        occluders = penumbra.Occluders()
        occluders.add_disks([[0.2, 0, 2]], [[0, 0, 1]], 0.2)
        occluders.commit()
        for index in (None, 0, 5):
            bits = occluders.visible_samples([[0, 0, 0]], LIGHTS[1], keys=[7], light_index=index)
            ways = penumbra.light_samples(LIGHTS[1], (0, 0, 0), key=7, light_index=index)
            at_disk = ways[:, :2] * (2 / ways[:, 2:])
            is_free = np.linalg.norm(at_disk - [0.2, 0], axis=1) > 0.2
            self.assertTrue(0 < np.sum(is_free) < 32)
            self.assertEqual([bool(bits[0, 0] >> i & 1) for i in range(32)], is_free.tolist())


if __name__ == "__main__":
    unittest.main()
