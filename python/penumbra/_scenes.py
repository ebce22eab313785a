# SPDX-License-Identifier: MIT
"""Scenes of files, and pictures of them: the classes and functions of `penumbra`."""
from __future__ import annotations

import os
from typing import Dict, Iterable, List, Mapping, NamedTuple, Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

from . import _penumbra
from ._occluders import LightLike, Occluders, Progress
from ._penumbra import Light

Vector = Tuple[float, float, float]
Path = Union[str, "os.PathLike[str]"]


class Camera(NamedTuple):
    """Where a scene is seen from; `fov_deg` is the full vertical one, None for parallel rays."""

    position: Vector
    at: Vector
    up: Vector
    fov_deg: Optional[float]
    size: Tuple[int, int]


class Scene:
    """A file's scene, with what was wished for and with defaults for what the file leaves out.

    Made by `read`. It prepares itself for the first picture and keeps that for the next one by the
    same method.
    """

    def __init__(self, core: _penumbra.Scene) -> None:
        self._core = core

    @property
    def name(self) -> str:
        """The file's own name for it, or that of the file."""
        return self._core.name()

    @property
    def warnings(self) -> List[str]:
        """What was odd about the file, one line a kind, as `file:line: what`."""
        return self._core.warnings()

    @property
    def lights(self) -> List[Light]:
        """Its lights; each can be asked about (`Occluders`)."""
        return self._core.lights()

    @property
    def up(self) -> Vector:
        """Which way is up."""
        return self._core.up()

    @property
    def camera(self) -> Camera:
        """Where it is seen from."""
        facts = self._core.camera()
        return Camera(facts["from"], facts["at"], facts["up"], facts["fov_deg"], facts["size"])

    @property
    def bounds(self) -> npt.NDArray[np.float32]:
        """Least and largest corner (2, 3) of all there is."""
        return np.array(self._core.bounds(), dtype=np.float32)

    @property
    def object_bounds(self) -> npt.NDArray[np.float32]:
        """The same without floors and backdrops."""
        return np.array(self._core.object_bounds(), dtype=np.float32)

    @property
    def primitives(self) -> int:
        """Number of primitives, with all that instances place."""
        return self._core.primitives()

    def occluders(self) -> Occluders:
        """What casts shadows in it, committed: to ask about points of one's own."""
        occluders = Occluders.__new__(Occluders)
        occluders._core = self._core.occluders()
        return occluders

    def render(self, *, size: Optional[Tuple[int, int]] = None, shadow_samples: int = 32,
               method: str = "shaft", samples_per_pixel: int = 1, depth: int = 5, seed: int = 0,
               threads: int = 0, layers: Optional[Iterable[str]] = None,
               progress: Optional[Progress] = None
               ) -> Union[npt.NDArray[np.float32], Dict[str, np.ndarray]]:
        """Draw it.

        Parameters
        ----------
        size : (width, height), optional
            In pixels; by default that of the scene's camera.
        shadow_samples : int
            Samples of each light, 1 to 65536.
        method : str
            'shaft', 'stochastic', 'offset', 'reduced' and 'umbra' draw the same picture, bit for
            bit; 'hard' draws one with hard shadows.
        samples_per_pixel, depth : int
            For smooth edges; longest path of mirrors and glass.
        seed, threads : int
            The picture is the same for any number of threads; 0 takes all cores.
        layers : iterable of str, optional
            Any of 'class', 'visibility', 'depth', 'normal', 'samples'.
        progress : callable, optional
            Gets the finished share, 0 to 1, now and then, from any thread. What it raises ends the
            call; returning what is false, but not None, ends it with `Cancelled`.

        Returns
        -------
        float32 (height, width, 3), or dict
            Linear R, G, B, rows from top to bottom. With `layers` (also empty ones) a dict:
            'color', and of each layer (height, width) for depth and samples, (height, width, 3) for
            normals, (height, width, lights) for class (uint8) and visibility.
        """
        options = dict(size=size, shadow_samples=shadow_samples, method=method,
                       samples_per_pixel=samples_per_pixel, depth=depth, seed=seed, threads=threads,
                       layers=[] if layers is None else list(layers), progress=progress)
        drawn = self._core.render(options)
        if layers is None:
            return drawn["color"]
        if "class" in drawn:
            drawn["class"] = drawn["class"].astype(np.uint8)
        for flat in ("depth", "samples"):
            if flat in drawn:
                drawn[flat] = drawn[flat][..., 0]
        return drawn


def read(path: Path, *, camera_from: Optional[npt.ArrayLike] = None,
         camera_at: Optional[npt.ArrayLike] = None, camera_up: Optional[npt.ArrayLike] = None,
         fov_deg: Optional[float] = None, lights: Iterable[LightLike] = (),
         light_radius: Union[float, str, None] = None, ground: Union[float, str, None] = "auto",
         background: Optional[npt.ArrayLike] = None, ambient: Optional[npt.ArrayLike] = None,
         clear_glass: bool = False, style: str = "ball-and-stick", waters: bool = False) -> Scene:
    """Read a scene from a file of any known format, or take a built-in one by its name.

    Parameters
    ----------
    path : str or path
        A file, else 'cylinders', 'balls:N', 'rings', 'molecule' or 'bust'.
    camera_from, camera_at, camera_up, fov_deg : optional
        Replace those of the file's camera, or of one that frames the objects.
    lights : iterable of lights
        If any, they replace the file's: shapes such as `Ball`, `Light`, or words such as
        'sun 0 1 1 0.53'.
    light_radius : float or str, optional
        Makes point and ball lights balls of this radius; '10%' is of the objects' extent.
    ground : 'auto', None or float
        A floor under bare models, none, or one at this height.
    background, ambient : r, g, b, optional
        Colour where nothing is hit; light from everywhere, without shadows.
    clear_glass : bool
        Transparent things cast no shadow.
    style, waters :
        Of molecules: 'ball-and-stick' or 'space-filling'; keep the waters.

    Raises
    ------
    Error
        With file, line, what is wrong and what to do.
    """
    return Scene(_penumbra.read(os.fspath(path), dict(
        camera_from=camera_from, camera_at=camera_at, camera_up=camera_up, fov_deg=fov_deg,
        lights=_as_list(lights), light_radius=light_radius, ground=ground, background=background,
        ambient=ambient, clear_glass=clear_glass, style=style, waters=waters)))


def render(source: Union[Path, Scene], *, size: Optional[Tuple[int, int]] = None,
           shadow_samples: int = 32, method: str = "shaft", samples_per_pixel: int = 1,
           depth: int = 5, seed: int = 0, threads: int = 0,
           layers: Optional[Iterable[str]] = None, progress: Optional[Progress] = None,
           **wishes: object) -> Union[npt.NDArray[np.float32], Dict[str, np.ndarray]]:
    """Draw a file, a built-in scene, or a `Scene`: see `Scene.render`.

    `wishes` are the keywords of `read`, such as `lights` and `ground`.
    """
    if isinstance(source, Scene):
        if wishes:
            raise TypeError(f"a scene that is read keeps its {', '.join(wishes)}; give them to read")
        scene = source
    else:
        scene = read(source, **wishes)  # type: ignore[arg-type]
    return scene.render(size=size, shadow_samples=shadow_samples, method=method,
                        samples_per_pixel=samples_per_pixel, depth=depth, seed=seed,
                        threads=threads, layers=layers, progress=progress)


def to_srgb(image: npt.ArrayLike, *, exposure: float = 0) -> npt.NDArray[np.uint8]:
    """Codes of linear values times 2**exposure, as viewers take them (IEC 61966-2-1).

    Returns
    -------
    uint8, of the shape of `image`
    """
    return _penumbra.to_srgb(image, exposure)


def write_image(path: Path, image: npt.ArrayLike, *, exposure: float = 0,
                layers: Optional[Mapping[str, npt.ArrayLike]] = None) -> None:
    """Write linear R, G, B (height, width, 3) to a file that is there whole or not at all.

    Parameters
    ----------
    path : str or path
        `.png` (8-bit sRGB, with `exposure` in stops) or `.exr` (float32, `layers` too).
    layers : dict, optional
        As `Scene.render` gives them; 'color' among them is `image`, and not written twice.
    """
    more = {name: layer for name, layer in (layers or {}).items() if name != "color"}
    _penumbra.write_image(os.fspath(path), image, exposure, more)


def _as_list(lights: Union[LightLike, Iterable[LightLike]]) -> List[LightLike]:
    """One light is a list of one; its words are no list of letters."""
    if isinstance(lights, str) or not hasattr(lights, "__iter__"):
        return [lights]  # type: ignore[list-item]
    return list(lights)
