# SPDX-License-Identifier: MIT
"""Soft shadows: which lights do points see, and how much of them?

Pictures of files, as arrays::

    import penumbra
    picture = penumbra.render("bust.ply", size=(512, 512), shadow_samples=64)
    penumbra.write_image("bust.png", picture)

Questions about points, asked of arrays of one's own or of a file's scene::

    occluders = penumbra.Occluders()
    occluders.add_triangles(positions, triangles)    # float32 (n, 3) and uint32 (m, 3): no copies
    occluders.commit()
    light = penumbra.Ball(center=(0, 9, 0), radius=1)
    fractions = occluders.visible_fraction(points, light, normals=normals)

Answers are those of the renderer: classes are proven, and fractions are, bit for bit, those of
tracing every sample. Long calls let other threads of Python run, take all cores, and end with
Ctrl-C.
"""

from ._occluders import (LIT, NO_INSTANCE, PENUMBRA, UMBRA, Blockers, Occluders, ShadowClass,
                         light_samples)
from ._penumbra import (Ball, Cancelled, CommitReport, Counters, Disk, Error, Geometry, Group, Hull,
                        Instance, Light, Line, Parallelogram, Point, Polygon, Sun)
from ._penumbra import version as __version__
from ._scenes import Camera, Scene, read, render, to_srgb, write_image

__all__ = [
    "LIT", "NO_INSTANCE", "PENUMBRA", "UMBRA", "Ball", "Blockers", "Camera", "Cancelled",
    "CommitReport", "Counters", "Disk", "Error", "Geometry", "Group", "Hull", "Instance", "Light",
    "Line", "Occluders", "Parallelogram", "Point", "Polygon", "Scene", "ShadowClass", "Sun",
    "__version__", "light_samples", "read", "render", "to_srgb", "write_image",
]
