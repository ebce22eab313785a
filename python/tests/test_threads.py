# SPDX-License-Identifier: MIT
"""Long calls: progress, Ctrl-C, other threads."""
import os
import signal
import threading
import time
import unittest

import numpy as np

import penumbra
from scenes_of_tests import floor_points, square

LIGHT = penumbra.Ball((0, 0, 4), 0.5)


def shaded():
    occluders = penumbra.Occluders()
    occluders.add_triangles(*square())
    occluders.commit()
    return occluders


def long_picture(**options):
    """Takes minutes, unless it is ended."""
    return penumbra.render("balls:3", size=(2048, 2048), shadow_samples=1024, method="stochastic",
                           samples_per_pixel=4, **options)


def long_question(**options):
    """Takes minutes too."""
    points = np.tile(floor_points(1000)[0], (400, 1))
    return shaded().visible_fraction(points, LIGHT, method="stochastic", shadow_samples=4096,
                                     **options)


class ProgressOfLongCalls(unittest.TestCase):
    def test_it_rises_to_one(self):
        told = []
        penumbra.render("cylinders", size=(64, 64), progress=told.append)
        self.assertEqual(told, sorted(told))
        self.assertEqual(told[-1], 1)

    def test_false_ends_the_call(self):
        for call in (long_picture, long_question):
            for no in (False, np.bool_(False), 0):
                with self.assertRaises(penumbra.Cancelled):
                    call(progress=lambda share, no=no: no)

    def test_none_and_what_is_true_go_on(self):
        for yes in (None, True, np.bool_(True), "on"):
            penumbra.render("cylinders", size=(8, 8), progress=lambda share, yes=yes: yes)

    def test_what_is_neither_true_nor_false_comes_out(self):
        with self.assertRaisesRegex(ValueError, "truth value"):
            long_question(progress=lambda share: np.zeros(2))

    def test_what_it_raises_comes_out(self):
        def refuse(share):
            raise LookupError(f"at {share}")
        for call in (long_picture, long_question):
            with self.assertRaisesRegex(LookupError, r"at \d"):
                call(progress=refuse)

    def test_what_cannot_be_called_is_a_type_error(self):
        with self.assertRaisesRegex(TypeError, "progress"):
            penumbra.render("cylinders", progress=3)


class Interrupts(unittest.TestCase):
    def test_control_c_ends_long_calls_soon(self):
        for call in (long_picture, long_question):
            sender = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
            sender.start()
            start = time.monotonic()
            with self.assertRaises(KeyboardInterrupt):
                call()
            self.assertLess(time.monotonic() - start, 20)
            sender.join()


class ThreadsOfPython(unittest.TestCase):
    def test_others_run_while_a_call_does(self):
        turns = 0
        done = threading.Event()

        def work():
            try:
                long_picture(progress=lambda share: turns < 3)
            except penumbra.Cancelled:
                done.set()
        worker = threading.Thread(target=work)
        worker.start()
        while not done.wait(0.01):
            turns += 1
        worker.join()
        self.assertGreaterEqual(turns, 3)

    def test_commits_changes_and_questions_may_run_side_by_side(self):
        occluders = shaded()
        points, normals = floor_points(500)
        failures = []

        def run(body):
            try:
                for _ in range(20):
                    body()
            except Exception as error:  # pylint: disable=broad-except
                failures.append(error)

        def change():
            geometry = occluders.add_triangles(*square(height=2))
            occluders.update(geometry, square(height=3)[0])
            occluders.remove(geometry)

        def ask():
            seen = occluders.visible_fraction(points, LIGHT, normals=normals)
            assert seen.min() >= 0 and seen.max() <= 1

        bodies = [change, change, ask, ask, occluders.commit]
        threads = [threading.Thread(target=run, args=(body,)) for body in bodies]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(failures, [])
        self.assertEqual(occluders.commit().primitives, 2)


if __name__ == "__main__":
    unittest.main()
