# SPDX-License-Identifier: MIT
"""ten_million.py BUILD [COUNT [ROUNDS]]: ten million surface points of the bust ask about one ball light, through C++ and
through Python, in turns; prints the medians and their ratio, and fails where an answer differs.

BUILD is a build folder with the targets `ten_million` and `penumbra_python`. Points come in a coherent order and
shuffled."""
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np


def vectors(path):
    return np.fromfile(path, dtype=np.float32).reshape(-1, 3)


def main():
    build = pathlib.Path(sys.argv[1])
    count, rounds = ([int(word) for word in sys.argv[2:]] + [10_000_000, 5][len(sys.argv) - 2:])[:2]
    sys.path.insert(0, str(build / "python"))
    import penumbra
    program = build / "bench" / "ten_million"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([program, "make", folder, str(count)], check=True)
        occluders = penumbra.Occluders()
        occluders.add_triangles(vectors(folder / "vertices"),
                                np.fromfile(folder / "triangles", dtype=np.uint32).reshape(-1, 3))
        occluders.commit()
        lo, hi = occluders.bounds
        extent = (hi - lo).max()
        light = penumbra.Ball(lo * np.float32(0.5) + hi * np.float32(0.5) + extent,
                              np.float32(0.1) * extent)
        for order in ("coherent", "shuffled"):
            positions, normals = (vectors(folder / f"{order}.{part}") for part in ("positions", "normals"))
            seconds = {"C++": [], "Python": []}
            for _ in range(rounds):
                told = subprocess.run([program, "ask", folder, order], check=True, capture_output=True, text=True)
                seconds["C++"].append(float(told.stdout))
                start = time.perf_counter()
                fractions = occluders.visible_fraction(positions, light, normals=normals)
                seconds["Python"].append(time.perf_counter() - start)
            expected = np.fromfile(folder / f"{order}.fractions", dtype=np.float32)
            if not np.array_equal(fractions, expected):
                sys.exit(f"{order}: {np.count_nonzero(fractions != expected)} answers differ")
            medians = {way: statistics.median(times) for way, times in seconds.items()}
            print(f"{order}: {count} points, C++ {medians['C++']:.2f} s, Python {medians['Python']:.2f} s, "
                  f"ratio {medians['Python'] / medians['C++']:.3f} (medians of {rounds}); "
                  f"lit {np.mean(fractions == 1):.3f}, dark {np.mean(fractions == 0):.3f}", flush=True)


if __name__ == "__main__":
    main()
