# SPDX-License-Identifier: MIT
"""Arrays in and out: what is read in place, what is converted, what is refused."""
import sys
import unittest
import weakref

import numpy as np

import penumbra
from scenes_of_tests import floor_points, square

LIGHT = penumbra.Ball((0, 0, 4), 0.5)


def shaded():
    occluders = penumbra.Occluders()
    occluders.add_triangles(*square())
    occluders.commit()
    return occluders


class ArraysThatGoIn(unittest.TestCase):
    def test_what_is_float32_is_read_in_place_by_the_next_commit(self):
        positions, triangles = square()
        occluders = penumbra.Occluders()
        occluders.add_triangles(positions, triangles)
        occluders.commit()
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 0)
        positions[:, 0] += 100
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 0)
        report = occluders.commit()
        self.assertTrue(report.is_refitted)
        self.assertIn("is_refitted=True", repr(report))
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 1)

    def test_arrays_live_as_long_as_the_occluders_read_them(self):
        positions, triangles = square()
        watched = weakref.ref(positions)
        occluders = penumbra.Occluders()
        geometry = occluders.add_triangles(positions, triangles)
        del positions
        self.assertIsNotNone(watched())
        occluders.commit()
        occluders.remove(geometry)
        self.assertIsNone(watched())

    def test_other_positions_replace_those_that_were_kept(self):
        positions, triangles = square()
        occluders = penumbra.Occluders()
        geometry = occluders.add_triangles(positions, triangles)
        occluders.commit()
        watched = weakref.ref(positions)
        occluders.update(geometry, positions + np.float32(100))
        del positions
        self.assertIsNone(watched())
        occluders.commit()
        self.assertEqual(occluders.visible_fraction([[0, 0, 0]], LIGHT)[0], 1)

    def test_strides_lists_and_doubles_give_the_same_answers(self):
        points, normals = floor_points()
        occluders = shaded()
        expected = occluders.visible_fraction(points, LIGHT, normals=normals)
        self.assertTrue(0 < np.mean(expected) < 1)
        records = np.zeros(len(points), dtype=[("p", "f4", 3), ("n", "f4", 3), ("other", "u1")])
        records["p"], records["n"] = points, normals
        backwards = np.ascontiguousarray(points[::-1])[::-1]
        for given, by in [(points.tolist(), normals.tolist()), (points.astype(float), normals),
                          (np.asfortranarray(points), np.asfortranarray(normals)),
                          (points.astype(">f4"), normals), (records["p"], records["n"]),
                          (backwards, normals), (points, [0, 0, 1])]:
            answers = occluders.visible_fraction(given, LIGHT, normals=by)
            np.testing.assert_array_equal(answers, expected)

    def test_vertex_numbers_may_be_of_any_whole_type(self):
        positions, triangles = square()
        for kind in (np.uint32, np.int32, np.int64, np.uint8):
            occluders = penumbra.Occluders()
            occluders.add_triangles(positions, triangles.astype(kind))
            self.assertEqual(occluders.commit().primitives, 2)

    def test_nothing_is_an_empty_list_or_an_empty_array(self):
        occluders = shaded()
        occluders.add_triangles([], [])
        occluders.add_triangles(np.zeros((0, 3), np.float32), np.zeros((0, 3), np.uint32))
        occluders.add_spheres([], [])
        self.assertEqual(occluders.commit().primitives, 2)
        self.assertEqual(occluders.classify([], LIGHT).shape, (0,))
        self.assertEqual(occluders.visible_fraction([], LIGHT, normals=[], keys=[]).shape, (0,))
        with self.assertRaises(penumbra.Error):
            penumbra.Polygon([])

    def test_keys_may_be_of_any_whole_type(self):
        points, normals = floor_points(8)
        occluders = shaded()
        expected = occluders.visible_fraction(points, LIGHT, normals=normals, first_key=3)
        for keys in (range(3, 11), np.arange(3, 11, dtype=np.uint64),
                     np.arange(3, 11, dtype=np.int32), np.arange(3, 11, dtype=">u2")):
            answers = occluders.visible_fraction(points, LIGHT, normals=normals, keys=keys)
            np.testing.assert_array_equal(answers, expected)

    def test_masked_arrays_are_arrays_where_they_mask_nothing(self):
        points, normals = floor_points()
        occluders = shaded()
        for mask in (False, np.zeros(points.shape, bool)):
            np.testing.assert_array_equal(
                occluders.visible_fraction(np.ma.array(points, mask=mask), LIGHT, normals=normals),
                occluders.visible_fraction(points, LIGHT, normals=normals))

    def test_one_radius_may_stand_for_all(self):
        occluders = penumbra.Occluders()
        occluders.add_spheres([[0, 0, 1], [9, 0, 1]], 0.5)
        occluders.add_cones([[0, 5, 1]], [[0, 5, 2]], 0.2, [0])
        occluders.add_disks([[0, -5, 1]], [0, 0, 1], 1, inner_radii=0.5)
        self.assertEqual(occluders.commit().primitives, 4)


class ArraysThatComeOut(unittest.TestCase):
    def test_answers_have_the_shape_of_the_points(self):
        occluders = shaded()
        points = np.zeros((3, 4, 3), dtype=np.float32)
        self.assertEqual(occluders.classify(points, LIGHT).shape, (3, 4))
        self.assertEqual(occluders.classify(points, LIGHT).dtype, np.uint8)
        fractions = occluders.visible_fraction(points, LIGHT)
        self.assertEqual((fractions.shape, fractions.dtype), ((3, 4), np.float32))
        bits = occluders.visible_samples(points, LIGHT, shadow_samples=33)
        self.assertEqual((bits.shape, bits.dtype), ((3, 4, 2), np.uint32))
        self.assertEqual(occluders.visible_fraction([0, 0, 0], LIGHT).shape, ())
        self.assertEqual(occluders.classify(np.zeros((0, 3)), LIGHT).shape, (0,))

    def test_out_is_filled_and_returned(self):
        points, normals = floor_points()
        occluders = shaded()
        out = np.full(len(points), np.nan, dtype=np.float32)
        returned = occluders.visible_fraction(points, LIGHT, normals=normals, out=out)
        self.assertIs(returned, out)
        np.testing.assert_array_equal(out,
                                      occluders.visible_fraction(points, LIGHT, normals=normals))

    def test_out_of_another_kind_is_refused(self):
        occluders = shaded()
        points = np.zeros((4, 3), dtype=np.float32)
        locked = np.zeros(4, dtype=np.float32)
        locked.flags.writeable = False
        for out in ([0] * 4, np.zeros(4), np.zeros(5, np.float32), np.zeros((4, 1), np.float32),
                    np.zeros(8, np.float32)[::2], locked):
            with self.assertRaisesRegex(ValueError, r"out is .*; give a writable"):
                occluders.visible_fraction(points, LIGHT, out=out)


class ArraysOfTheWrongKind(unittest.TestCase):
    def test_shapes_are_refused_with_what_is_wanted(self):
        occluders = shaded()
        for points in ([1, 2], np.zeros((3, 2)), np.zeros((3, 4)), 1.0):
            with self.assertRaisesRegex(ValueError, r"positions is of shape .*\(n, 3\)"):
                occluders.visible_fraction(points, LIGHT)
        with self.assertRaisesRegex(ValueError, "positions"):
            occluders.visible_fraction(["a", "b", "c"], LIGHT)
        with self.assertRaisesRegex(ValueError, "normals"):
            occluders.visible_fraction(np.zeros((3, 3)), LIGHT, normals=np.zeros((2, 3)))
        with self.assertRaisesRegex(ValueError, "radii is 3 numbers; give 2"):
            occluders.add_spheres(np.zeros((2, 3)), [1, 2, 3])
        with self.assertRaisesRegex(ValueError, "keys is 1 numbers; give 2 keys"):
            occluders.visible_fraction(np.zeros((2, 3)), LIGHT, keys=[1])

    def test_vertex_numbers_that_are_none_are_refused(self):
        positions, _ = square()
        occluders = penumbra.Occluders()
        for triangles in ([[0.5, 1, 2]], [[-1, 1, 2]], [[0, 1, 2**32]], [0, 1, 2], [[0, 1]]):
            with self.assertRaisesRegex(ValueError, "triangles"):
                occluders.add_triangles(positions, triangles)

    def test_keys_that_are_not_whole_are_refused(self):
        for keys in ([0.5, 1], [0.0, 1], np.array([True, False]), [1 + 1j, 2], ["1", "2"], [-1, 0]):
            with self.assertRaisesRegex(ValueError, "^keys is .*; give an array of uint64"):
                shaded().visible_fraction(np.zeros((2, 3)), LIGHT, keys=keys)

    def test_masks_are_refused_since_they_would_be_passed_over(self):
        def masked(array):
            array = np.asarray(array)
            return np.ma.array(array, mask=np.arange(array.size).reshape(array.shape) == 0)

        positions, triangles = square()
        occluders = shaded()
        for name, call in [
                ("positions", lambda: occluders.add_triangles(masked(positions), triangles)),
                ("triangles", lambda: occluders.add_triangles(positions, masked(triangles))),
                ("radii", lambda: occluders.add_spheres(positions, masked(np.ones(4)))),
                ("placement", lambda: occluders.add_instance(
                    occluders.add_group(penumbra.Occluders()), masked(np.eye(4)))),
                ("normals", lambda: occluders.classify(positions, LIGHT,
                                                       normals=masked(positions))),
                ("keys", lambda: occluders.visible_fraction(positions, LIGHT,
                                                            keys=masked(range(4)))),
                ("center", lambda: penumbra.Point(masked([0, 0, 1.0]))),
                ("image", lambda: penumbra.to_srgb(masked(positions)))]:
            with self.assertRaisesRegex(ValueError, f"^{name} is masked in part; give"):
                call()

    def test_nothing_is_kept_of_what_was_refused(self):
        positions, _ = square()
        count = sys.getrefcount(positions)
        occluders = penumbra.Occluders()
        with self.assertRaises(ValueError):
            occluders.add_triangles(positions, [[0.5, 1, 2]])
        self.assertEqual(sys.getrefcount(positions), count)


if __name__ == "__main__":
    unittest.main()
