# SPDX-License-Identifier: MIT
"""What blocks light, and questions about it: the classes and functions of `penumbra`."""
from __future__ import annotations

import enum
from typing import Callable, NamedTuple, Optional, Union

import numpy as np
import numpy.typing as npt

from . import _penumbra
from ._penumbra import CommitReport, Counters, Geometry, Group, Instance, Light

Progress = Callable[[float], object]
LightLike = Union[_penumbra.Point, _penumbra.Ball, _penumbra.Disk, _penumbra.Sun, _penumbra.Line,
                  _penumbra.Parallelogram, _penumbra.Polygon, _penumbra.Hull, Light, str]


class ShadowClass(enum.IntEnum):
    """What is known of a point and a light. LIT and UMBRA are proofs."""

    LIT = 0
    PENUMBRA = 1
    UMBRA = 2


LIT, PENUMBRA, UMBRA = ShadowClass
NO_INSTANCE = 0xFFFFFFFF


class Blockers(NamedTuple):
    """What may stand between points and a light.

    Attributes
    ----------
    shadow_class : ShadowClass
        LIT: nothing can block a sample that is above the horizon. UMBRA: all are blocked for sure.
    primitives : uint32 array (k, 3)
        Geometry, primitive, instance (`NO_INSTANCE` for what no instance places) of all that may.
    """

    shadow_class: ShadowClass
    primitives: npt.NDArray[np.uint32]


class Occluders:
    """What blocks light.

    Arrays that are handed over are kept, not copied, where they are float32 (..., 3) with packed
    triples (uint32 or int32 for triangles); anything else is converted once. They are read in place
    by every `commit`, and must not change while one runs; between commits they may.

    Nothing that is added is asked before `commit`. Any method may be called from any thread.
    Wrong arguments raise ValueError (`Error` is one), or TypeError where they are of the wrong
    kind, and leave the object as it was. Among them are masked arrays that mask something.

    Notes
    -----
    Questions take the same keywords:

    normals : array like positions, or one vector, optional
        Geometric normals, on the side that looks at the light: of samples below the plane nothing
        is seen. Without, points float and look around, as does one with the normal (0, 0, 0).
    shadow_samples : int
        Samples d of the light, 1 to 65536.
    method : str
        'shaft', or 'stochastic' (traces every sample: the judge).
    offset : float, optional
        How far points are moved along their normals first, off the surface that they lie on. By
        default 64 ulp of the largest coordinate of point and occluders.
    keys : array of whole numbers, optional
        What the random numbers of each point are drawn by; by default first_key + its index.
    light_index : int or None
        Which light of several this is: another gets other samples. None: the keys are final.
    threads : int
        0: all cores. Answers are the same for any number.
    progress : callable, optional
        Gets the finished share, 0 to 1, now and then, from any thread. What it raises ends the
        call; returning what is false, but not None, ends it with `Cancelled`.
    out : array, optional
        Where answers go: writable, C contiguous, of the type and shape of what is returned.
    counters : Counters, optional
        Gets added what the answers took.
    """

    def __init__(self) -> None:
        self._core = _penumbra.Occluders()

    def add_triangles(self, positions: npt.ArrayLike, triangles: npt.ArrayLike) -> Geometry:
        """Add a mesh, open or dirty; it blocks from both sides.

        Parameters
        ----------
        positions : float32 (n, 3)
            In scene units.
        triangles : uint32 or int32 (m, 3)
            Vertex numbers from 0.
        """
        return self._core.add_triangles(positions, triangles)

    def add_spheres(self, centers: npt.ArrayLike, radii: npt.ArrayLike) -> Geometry:
        """Add spheres: centers (n, 3), radii (n,) or one for all, above 0."""
        return self._core.add_spheres(centers, radii)

    def add_cones(self, bases: npt.ArrayLike, apexes: npt.ArrayLike, base_radii: npt.ArrayLike,
                  apex_radii: npt.ArrayLike, *, capped: bool = True) -> Geometry:
        """Add truncated cones from base to apex; equal radii make cylinders.

        Radii are (n,) or one for all, at least 0 and not both 0. `capped` ones are solids.
        """
        return self._core.add_cones(bases, apexes, base_radii, apex_radii, capped)

    def add_disks(self, centers: npt.ArrayLike, normals: npt.ArrayLike, radii: npt.ArrayLike,
                  inner_radii: Optional[npt.ArrayLike] = None) -> Geometry:
        """Add flat disks, or rings where inner radii are given.

        Centers and normals are (n, 3), radii (n,) or one for all.
        """
        return self._core.add_disks(centers, normals, radii, inner_radii)

    def add_group(self, shapes: Occluders) -> Group:
        """Take the geometry of another, as it is now, for instances to place.

        It is stored once however often it stands in the scene, and must have no instances itself.
        """
        return self._core.add_group(shapes._core)

    def add_instance(self, group: Group, placement: npt.ArrayLike) -> Instance:
        """Place a group by a matrix (3, 4) or (4, 4) that maps columns (x, y, z, 1).

        Triangles stand any affine map that does not flatten them, other shapes similarities alone.
        """
        return self._core.add_instance(group, placement)

    def update(self, what: Union[Geometry, Instance, Group], change: npt.ArrayLike,
               part: Optional[Geometry] = None) -> None:
        """Give a geometry other positions, or an instance another placement, from the next commit.

        Where the arrays that were handed over hold other numbers, nothing is to be said: the next
        commit reads them. (Those that were converted when they were added must be given anew.)

        Parameters
        ----------
        what : Geometry, Instance or Group
        change : array
            Positions (centers, bases), as many as before; of an instance, its matrix.
        part : Geometry, optional
            Of a group: the geometry of it that gets other positions.
        """
        if isinstance(what, Geometry) and part is None:
            self._core.update_geometry(what, change)
        elif isinstance(what, Instance) and part is None:
            self._core.update_instance(what, change)
        elif isinstance(what, Group) and isinstance(part, Geometry):
            self._core.update_group(what, part, change)
        else:
            raise TypeError("update takes a Geometry, an Instance, or a Group and a part of it")

    def remove(self, what: Union[Geometry, Instance, Group]) -> None:
        """Take out what was added. A group must not be placed any more."""
        self._core.remove(what)

    def commit(self, *, may_refit: bool = True) -> CommitReport:
        """Make what was added and updated until now what questions are asked of.

        Where positions alone have moved, the hierarchy is fitted to them, in O(n), unless
        `may_refit` is false; else it is built in O(n log n). Answers are the same either way.

        Raises
        ------
        Error
            For coordinates that are not finite or beyond 1e15, and vertex numbers out of range;
            what was committed before stays.
        """
        return self._core.commit(may_refit)

    def classify(self, positions: npt.ArrayLike, light: LightLike, *,
                 normals: Optional[npt.ArrayLike] = None, method: str = "shaft",
                 offset: Optional[float] = None, threads: int = 0,
                 progress: Optional[Progress] = None, out: Optional[npt.NDArray[np.uint8]] = None,
                 counters: Optional[Counters] = None) -> npt.NDArray[np.uint8]:
        """Class of each point, for the light as a whole.

        LIT (nothing blocks what of it is above the point's horizon) and UMBRA (all of it is
        blocked, or below) are proofs, PENUMBRA means that neither was found. No sample is taken,
        but by 'stochastic', whose classes are those of 32 samples. Cost: 5 to 500 ns a point, less
        where neighbours follow one another. See the class's notes for the keywords.

        Parameters
        ----------
        positions : float32 (..., 3)
        light : a light, its words, or a `Light`

        Returns
        -------
        uint8 (...)
        """
        return self._core.classify(positions, light, normals, offset, None, 0, 32, method, 0,
                                   threads, progress, out, counters)

    def visible_fraction(self, positions: npt.ArrayLike, light: LightLike, *,
                         normals: Optional[npt.ArrayLike] = None, shadow_samples: int = 32,
                         method: str = "shaft", offset: Optional[float] = None,
                         keys: Optional[npt.ArrayLike] = None, first_key: int = 0,
                         light_index: Optional[int] = 0, threads: int = 0,
                         progress: Optional[Progress] = None,
                         out: Optional[npt.NDArray[np.float32]] = None,
                         counters: Optional[Counters] = None) -> npt.NDArray[np.float32]:
        """Share of the light's samples that each point sees, in [0, 1].

        See the class's notes for the keywords.

        Parameters
        ----------
        positions : float32 (..., 3)
        light : a light, its words, or a `Light`

        Returns
        -------
        float32 (...)
        """
        return self._core.visible_fraction(positions, light, normals, offset, keys, first_key,
                                           shadow_samples, method, light_index, threads, progress,
                                           out, counters)

    def visible_samples(self, positions: npt.ArrayLike, light: LightLike, *,
                        normals: Optional[npt.ArrayLike] = None, shadow_samples: int = 32,
                        method: str = "shaft", offset: Optional[float] = None,
                        keys: Optional[npt.ArrayLike] = None, first_key: int = 0,
                        light_index: Optional[int] = 0, threads: int = 0,
                        progress: Optional[Progress] = None,
                        out: Optional[npt.NDArray[np.uint32]] = None,
                        counters: Optional[Counters] = None) -> npt.NDArray[np.uint32]:
        """Which samples each point sees: bit i % 32 of word i // 32 for sample i.

        `light_samples` says where they lie. See the class's notes for the keywords.

        Returns
        -------
        uint32 (..., ceil(shadow_samples / 32))
        """
        return self._core.visible_samples(positions, light, normals, offset, keys, first_key,
                                          shadow_samples, method, light_index, threads, progress,
                                          out, counters)

    def visibility(self, positions: npt.ArrayLike, light: LightLike, *,
                   normals: Optional[npt.ArrayLike] = None, shadow_samples: int = 32,
                   method: str = "shaft", offset: Optional[float] = None,
                   keys: Optional[npt.ArrayLike] = None, first_key: int = 0,
                   light_index: Optional[int] = 0, threads: int = 0,
                   progress: Optional[Progress] = None,
                   out: Optional[npt.NDArray[np.void]] = None,
                   counters: Optional[Counters] = None) -> npt.NDArray[np.void]:
        """All of it. See the class's notes for the keywords.

        Returns
        -------
        structured array (...)
            Fields `cosine_weighted` and `fraction` (float32), `shadow_class` (uint8), `rays`
            (uint32, that were traced for the point).
        """
        return self._core.visibility(positions, light, normals, offset, keys, first_key,
                                     shadow_samples, method, light_index, threads, progress, out,
                                     counters)

    def blockers(self, position: npt.ArrayLike, light: LightLike, *,
                 normal: Optional[npt.ArrayLike] = None) -> Blockers:
        """Everything that may block the light as seen from one point."""
        shadow_class, primitives = self._core.blockers(position, light, normal)
        return Blockers(ShadowClass(shadow_class), primitives)

    def shaft(self, lo: npt.ArrayLike, hi: npt.ArrayLike, light: LightLike) -> Blockers:
        """Everything that may block the light as seen from any point of the box from lo to hi."""
        shadow_class, primitives = self._core.shaft(lo, hi, light)
        return Blockers(ShadowClass(shadow_class), primitives)

    @property
    def bounds(self) -> npt.NDArray[np.float32]:
        """Least and largest corner (2, 3) of what was committed last."""
        return np.array(self._core.bounds(), dtype=np.float32)

    @property
    def memory_bytes(self) -> int:
        """Memory of what was committed last, beside the arrays that were handed over."""
        return self._core.memory_bytes()


def light_samples(light: LightLike, position: npt.ArrayLike, *, key: int = 0,
                  shadow_samples: int = 32,
                  light_index: Optional[int] = 0) -> npt.NDArray[np.float32]:
    """Ways from a point to the light's samples, in the order of `Occluders.visible_samples`.

    Parameters
    ----------
    light : a light, its words, or a `Light`
    position : three numbers
        Where shadow rays begin.
    key : int
        The point's: without keys of one's own, first_key + its index.
    shadow_samples : int
        Samples of the light, 1 to 65536.
    light_index : int or None
        As it was, or will be, asked about. None: the key is final.

    Returns
    -------
    float32 (shadow_samples, 3)
        Not unit; for suns, unit directions.
    """
    return _penumbra.light_samples(light, position, key, shadow_samples, light_index)
