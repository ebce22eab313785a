# SPDX-License-Identifier: MIT
"""Small arrays that several tests ask about."""
import numpy as np


def square(size=1.0, height=1.0):
    """A square of two triangles in the plane z = height."""
    positions = np.array([[-size, -size, height], [size, -size, height], [size, size, height],
                          [-size, size, height]], dtype=np.float32)
    return positions, np.array([[0, 1, 2], [0, 2, 3]], dtype=np.uint32)


def floor_points(count=64, extent=4.0, seed=1):
    """Points of the plane z = 0 around the origin, and their normals."""
    random = np.random.default_rng(seed)
    points = np.zeros((count, 3), dtype=np.float32)
    points[:, :2] = random.uniform(-extent, extent, (count, 2))
    normals = np.zeros((count, 3), dtype=np.float32)
    normals[:, 2] = 1
    return points, normals
