"""Pictures with matplotlib: a scene in three dimensions, and energy over time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional

import numpy as np

if TYPE_CHECKING:
    from .world import World

# Which coordinates of the world go to matplotlib's x, y and z (which it draws upwards), keeping right hands right.
_UP = {"x": [1, 2, 0], "y": [2, 0, 1], "z": [0, 1, 2]}


def _rgb(colors: np.ndarray) -> np.ndarray:
    return np.stack([colors >> 16 & 255, colors >> 8 & 255, colors & 255], axis=-1) / 255.0

_SUN = np.array([0.35, 0.25, 0.9]) / np.linalg.norm([0.35, 0.25, 0.9])
EDGE = 0x20242C
"""The colour of edges of shapes."""


def _toward_viewer(elevation: float, azimuth: float) -> np.ndarray:
    e, a = np.radians(elevation), np.radians(azimuth)
    return np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])


def scene(
    world: World,
    ax: Optional[Any] = None,
    up: str = "y",
    elevation: float = 20.0,
    azimuth: float = 35.0,
    **options: Any,
) -> Any:
    """Draws what a world looks like now; returns the axes.

    ``up`` is the axis of the world that points upwards; ``elevation`` and ``azimuth`` [degrees] are where one stands.
    Options are those of :meth:`World.draw`, e.g. ``draw_contacts=True``, ``draw_joint_extras=True``.
    """
    from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.figure(figsize=(7, 6)).add_subplot(projection="3d")
    order = _UP[up]
    options = {"tessellate": True, "draw_edges": True, **options}
    drawing = world.draw(**options)

    triangles = drawing.triangles["points"][:, :, order]
    lines, strokes = drawing.lines["points"][:, :, order], _rgb(drawing.lines["color"])
    is_edge = drawing.lines["color"] == EDGE
    toward = _toward_viewer(elevation, azimuth)
    large = np.zeros(len(triangles), bool)
    if len(triangles):
        normals = drawing.triangles["normal"][:, order]
        light = 0.6 + 0.4 * np.clip(normals @ _SUN, 0, 1)
        faces = _rgb(drawing.triangles["color"]) * light[:, None]
        extent = np.ptp(triangles, axis=1).max(axis=1)
        # A floor far larger than the rest lies behind everything: matplotlib sorts by middles.
        large = extent > 8 * np.median(extent)
        seen = normals @ toward > 0
        if (large & seen).any():
            floor = Poly3DCollection(
                triangles[large & seen], facecolors=faces[large & seen], edgecolors=faces[large & seen], linewidths=0.8
            )
            floor.set_zorder(0)
            ax.add_collection3d(floor)
        # Edges go with the faces, a little nearer, so that those behind are hidden.
        near = lines[is_edge] + 0.01 * np.median(extent) * toward
        small = ~large & seen
        pieces = np.concatenate([triangles[small], near[:, [0, 1, 1]]])
        if len(pieces):
            fills = np.concatenate([faces[small], strokes[is_edge]])
            patches = Poly3DCollection(pieces, facecolors=fills, edgecolors=fills, linewidths=0.5)
            patches.set_zorder(2)
            ax.add_collection3d(patches)
    others = ~is_edge if len(triangles) else np.ones(len(lines), bool)
    if others.any():
        rods = Line3DCollection(lines[others], colors=strokes[others], linewidths=1.2)
        rods.set_zorder(3)
        ax.add_collection3d(rods)
    points = drawing.points
    if len(points):
        at = points["position"][:, order]
        ax.scatter(*at.T, c=_rgb(points["color"]), s=points["size"] ** 2 / 4, depthshade=False, zorder=4)
    for where, text in drawing.texts:
        ax.text(*where[order], text, fontsize=7, zorder=5)

    bounded = points["position"][:, order]
    if len(triangles):
        bounded = triangles[~large].reshape(-1, 3) if (~large).any() else triangles.reshape(-1, 3)
    elif len(lines):
        bounded = lines.reshape(-1, 3)
    if len(bounded):
        lower, upper = bounded.min(axis=0), bounded.max(axis=0)
        middle, half = (lower + upper) / 2, max(float((upper - lower).max()) / 2, 0.5) * 1.05
        for k, name in enumerate("xyz"):
            getattr(ax, f"set_{name}lim")(middle[k] - half, middle[k] + half)
    ax.computed_zorder = False
    ax.set_box_aspect((1, 1, 1))
    ax.set_proj_type("ortho")
    ax.view_init(elev=elevation, azim=azimuth)
    for name, k in zip("xyz", order):
        getattr(ax, f"set_{name}label")(f"{'xyz'[k]} [m]")
    return ax


class EnergyTrace:
    """Energy of a world over time: call :meth:`step` instead of the world's."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.time: List[float] = [0.0]
        """[s]"""
        report = world.step_report
        self.kinetic: List[float] = [report.kinetic_energy]
        """Of translation and rotation [J]."""
        self.potential: List[float] = [report.potential_energy]
        """In the field of gravity [J]."""

    def step(self, dt: float, sub_steps: int = 4, steps: int = 1) -> None:
        """Steps the world, and notes its energy after each step."""
        for _ in range(steps):
            self.world.step(dt, sub_steps)
            report = self.world.step_report
            self.time.append(self.time[-1] + dt)
            self.kinetic.append(report.kinetic_energy)
            self.potential.append(report.potential_energy)

    @property
    def total(self) -> np.ndarray:
        """The sum of both [J]."""
        return np.add(self.kinetic, self.potential)


def energy(trace: EnergyTrace, ax: Optional[Any] = None) -> Any:
    """Draws energy over time; returns the axes. Potential energy counts from its least value."""
    if ax is None:
        import matplotlib.pyplot as plt

        ax = plt.figure(figsize=(7, 4)).add_subplot()
    potential = np.asarray(trace.potential) - np.min(trace.potential)
    kinetic = np.asarray(trace.kinetic)
    ax.plot(trace.time, kinetic, label="kinetic", color="#5b8def")
    ax.plot(trace.time, potential, label="potential", color="#e8b84a")
    ax.plot(trace.time, kinetic + potential, label="total", color="#20242c")
    ax.set_xlabel("time [s]")
    ax.set_ylabel("energy [J]")
    ax.set_ylim(bottom=0)
    ax.legend()
    ax.grid(alpha=0.3)
    return ax
