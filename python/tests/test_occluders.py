# SPDX-License-Identifier: MIT
"""Questions, and that their answers are the judge's."""
import unittest

import numpy as np

import penumbra
from scenes_of_tests import floor_points, square

LIGHT = penumbra.Ball((0, 0, 4), 0.5)


class Questions(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.occluders = penumbra.Occluders()
        cls.occluders.add_triangles(*square())
        cls.occluders.add_spheres([[2, 2, 1]], 0.5)
        cls.occluders.commit()
        cls.points, cls.normals = floor_points(2000)

    def ask(self, question, **options):
        return getattr(self.occluders, question)(self.points, LIGHT, normals=self.normals, **options)

    def test_fractions_are_those_of_tracing_every_sample(self):
        for samples in (1, 32, 100):
            np.testing.assert_array_equal(
                self.ask("visible_fraction", shadow_samples=samples),
                self.ask("visible_fraction", shadow_samples=samples, method="stochastic"))

    def test_classes_are_proofs(self):
        classes, fractions = self.ask("classify"), self.ask("visible_fraction")
        self.assertEqual(set(classes), {penumbra.LIT, penumbra.PENUMBRA, penumbra.UMBRA})
        self.assertTrue(np.all(fractions[classes == penumbra.LIT] == 1))
        self.assertTrue(np.all(fractions[classes == penumbra.UMBRA] == 0))

    def test_all_questions_agree(self):
        fractions = self.ask("visible_fraction", shadow_samples=40)
        bits = self.ask("visible_samples", shadow_samples=40)
        count = np.unpackbits(bits.view(np.uint8), axis=1).sum(axis=1)
        np.testing.assert_array_equal(count.astype(np.float32) / np.float32(40), fractions)
        seen = self.ask("visibility", shadow_samples=40)
        np.testing.assert_array_equal(seen["fraction"], fractions)
        self.assertTrue(np.all((seen["cosine_weighted"] >= 0) & (seen["cosine_weighted"] <= 1)))
        self.assertTrue(np.all(seen["rays"][seen["shadow_class"] == penumbra.LIT] == 0))

    def test_answers_hang_on_keys_and_on_no_number_of_threads(self):
        answers = self.ask("visible_fraction")
        np.testing.assert_array_equal(self.ask("visible_fraction", threads=1), answers)
        keys = np.arange(len(self.points), dtype=np.uint64)
        np.testing.assert_array_equal(self.ask("visible_fraction", keys=keys), answers)
        self.assertFalse(np.array_equal(self.ask("visible_fraction", first_key=10**6), answers))
        self.assertFalse(np.array_equal(self.ask("visible_fraction", light_index=1), answers))

    def test_counters_add_up(self):
        counters = penumbra.Counters()
        self.ask("visible_fraction", counters=counters)
        once = counters.lit + counters.penumbra + counters.umbra
        self.assertEqual(once, len(self.points))
        self.ask("visible_fraction", counters=counters)
        self.assertEqual(counters.lit + counters.penumbra + counters.umbra, 2 * once)

    def test_blockers_name_what_stands_between(self):
        below = self.occluders.blockers((0.5, -0.5, 0), LIGHT, normal=(0, 0, 1))
        self.assertEqual(below.shadow_class, penumbra.UMBRA)
        self.assertIn((0, 0, penumbra.NO_INSTANCE), {tuple(row) for row in below.primitives})
        beside = self.occluders.blockers((30, 0, 0), LIGHT)
        self.assertEqual(beside.shadow_class, penumbra.LIT)
        self.assertEqual(beside.primitives.shape, (0, 3))

    def test_a_shaft_holds_the_blockers_of_all_its_points(self):
        lo, hi = (-1, -1, 0), (1, 1, 0.1)
        of_box = {tuple(row) for row in self.occluders.shaft(lo, hi, LIGHT).primitives}
        random = np.random.default_rng(2)
        for point in random.uniform(lo, hi, (50, 3)):
            of_point = self.occluders.blockers(point, LIGHT).primitives
            self.assertLessEqual({tuple(row) for row in of_point}, of_box)

    def test_bounds_and_memory_are_told(self):
        np.testing.assert_allclose(self.occluders.bounds, [[-1, -1, 0.5], [2.5, 2.5, 1.5]],
                                   atol=1e-5)
        self.assertGreater(self.occluders.memory_bytes, 0)


class Instances(unittest.TestCase):
    def test_a_group_stands_where_instances_place_it(self):
        shapes = penumbra.Occluders()
        part = shapes.add_triangles(*square())
        occluders = penumbra.Occluders()
        group = occluders.add_group(shapes)
        placement = np.eye(4)
        instance = occluders.add_instance(group, placement)
        self.assertEqual(occluders.commit().primitives, 2)
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 0)
        blockers = occluders.blockers((0, 0, 0), LIGHT)
        self.assertEqual(blockers.primitives[0, 2], instance.index)

        placement[0, 3] = 100
        occluders.update(instance, placement[:3])
        occluders.commit()
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 1)

        positions, _ = square()
        positions[:, 0] -= 100
        occluders.update(group, positions, part)
        occluders.commit()
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 0)

        with self.assertRaises(penumbra.Error):
            occluders.remove(group)
        occluders.remove(instance)
        occluders.remove(group)
        self.assertEqual(occluders.commit().primitives, 0)

    def test_placements_are_checked(self):
        occluders = penumbra.Occluders()
        shapes = penumbra.Occluders()
        shapes.add_triangles(*square())
        group = occluders.add_group(shapes)
        for matrix in (np.eye(3), np.zeros((3, 5)), "abc", np.full((4, 4), 2.0)):
            with self.assertRaisesRegex(ValueError, "placement"):
                occluders.add_instance(group, matrix)
        with self.assertRaises(penumbra.Error):
            occluders.add_instance(group, np.zeros((3, 4)))
            occluders.commit()


class OccludersOfScenes(unittest.TestCase):
    def test_a_files_scene_answers_as_its_pictures_do(self):
        scene = penumbra.read("cylinders")
        occluders = scene.occluders()
        points, normals = floor_points(500, extent=10)
        for light in scene.lights:
            np.testing.assert_array_equal(
                occluders.visible_fraction(points, light, normals=normals),
                occluders.visible_fraction(points, light, normals=normals, method="stochastic"))
        np.testing.assert_array_equal(occluders.bounds, scene.bounds)


if __name__ == "__main__":
    unittest.main()
