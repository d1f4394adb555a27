"""What a world looks like, in arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List, Tuple

import numpy as np

from ._definitions import fill
from ._library import call, ffi, lib

if TYPE_CHECKING:
    from .world import World

SPHERE, CAPSULE, BOX = 0, 1, 2
"""Kinds of instances: a ball of radius size[0]; a capsule along y, of radius size[0] and half length size[1]; a box with
half extents size."""

_INSTANCES = np.dtype(
    [("transform", "f4", 7), ("size", "f4", 3), ("kind", "i4"), ("color", "u4"), ("shape", "u8")], align=False
)
_LINES = np.dtype([("points", "f4", (2, 3)), ("color", "u4")])
_TRIANGLES = np.dtype([("points", "f4", (3, 3)), ("normal", "f4", 3), ("color", "u4"), ("shape", "V8")])
_POINTS = np.dtype([("position", "f4", 3), ("size", "f4"), ("color", "u4")])


@dataclass
class Drawing:
    """Structured arrays, one row for each thing drawn. Colours are 0xRRGGBB."""

    lines: np.ndarray
    """"points" (2 × 3) [m], "color"."""
    triangles: np.ndarray
    """"points" (3 × 3, counter-clockwise seen from outside) [m], "normal", "color", "shape"."""
    instances: np.ndarray
    """"transform" (x, y, z, qx, qy, qz, qw), "size" [m], "kind" (SPHERE, CAPSULE, BOX), "color", "shape"."""
    points: np.ndarray
    """"position" [m], "size" [pixels], "color"."""
    texts: List[Tuple[np.ndarray, str]]
    """Where [m], and what."""


def _copy(pointer: Any, count: int, kind: str, dtype: np.dtype) -> np.ndarray:
    if count == 0:
        return np.zeros(0, dtype)
    if ffi.sizeof(kind) != dtype.itemsize:
        raise RuntimeError(f"{kind} has {ffi.sizeof(kind)} bytes, not {dtype.itemsize}.")
    return np.frombuffer(ffi.buffer(pointer, count * dtype.itemsize), dtype).copy()


def draw(world: World, options: Dict[str, Any]) -> Drawing:
    """See :meth:`World.draw`."""
    options = dict(options)
    mask_bits = options.pop("mask_bits", 0xFFFF_FFFF_FFFF_FFFF)
    definition = lib.mvDefaultDebugDraw()
    fill(definition, options, "A drawing")
    b = call(lib.mvWorld_DrawBuffers, world._id, ffi.new("mvDebugDraw*", definition), mask_bits)
    texts = (b.strings[k] for k in range(b.stringCount))
    return Drawing(
        _copy(b.lines, b.lineCount, "mvDrawLine", _LINES),
        _copy(b.triangles, b.triangleCount, "mvDrawTriangle", _TRIANGLES),
        _copy(b.instances, b.instanceCount, "mvDrawInstance", _INSTANCES),
        _copy(b.points, b.pointCount, "mvDrawPoint", _POINTS),
        [(np.array((t.position.x, t.position.y, t.position.z)), ffi.string(t.text).decode()) for t in texts],
    )
