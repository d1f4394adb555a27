"""Vectors, rotations, placements and boxes: numpy arrays here, structures in C."""

from __future__ import annotations

import enum
import re
from typing import Any, NamedTuple, Sequence, Tuple, Type, TypeVar, Union

import numpy as np

from ._library import InvalidValueError

Vector = np.ndarray
"""Three numbers: x, y, z."""
Quaternion = np.ndarray
"""A rotation as four numbers: x, y, z, w."""
Matrix = np.ndarray
"""Three rows of three numbers."""
VectorLike = Union[np.ndarray, Sequence[float]]
QuaternionLike = Union[np.ndarray, Sequence[float]]


class Transform(NamedTuple):
    """A placement: rotate by q, then shift by p."""

    p: Vector
    """The shift [m]."""
    q: Quaternion
    """The rotation, (x, y, z, w)."""


class Bounds(NamedTuple):
    """A box along the axes."""

    lower: Vector
    """The least corner [m]."""
    upper: Vector
    """The greatest corner [m]."""


TransformLike = Union[Transform, Tuple[VectorLike, QuaternionLike]]
BoundsLike = Union[Bounds, Tuple[VectorLike, VectorLike]]


def _vector(c: Any) -> Vector:
    return np.array((c.x, c.y, c.z))


def _quaternion(c: Any) -> Quaternion:
    v = c.v
    return np.array((v.x, v.y, v.z, c.s))


def _transform(c: Any) -> Transform:
    return Transform(_vector(c.p), _quaternion(c.q))


def _bounds(c: Any) -> Bounds:
    return Bounds(_vector(c.lowerBound), _vector(c.upperBound))


def _matrix(c: Any) -> Matrix:
    return np.array([_vector(c.cx), _vector(c.cy), _vector(c.cz)]).T


def _c_vector(value: VectorLike) -> Tuple[float, float, float]:
    try:
        x, y, z = value
        return float(x), float(y), float(z)
    except (TypeError, ValueError):
        raise InvalidValueError(f"{value!r} is no vector; it must be three numbers.") from None


def _c_quaternion(value: QuaternionLike) -> Tuple[Tuple[float, float, float], float]:
    try:
        x, y, z, w = value
        return (float(x), float(y), float(z)), float(w)
    except (TypeError, ValueError):
        raise InvalidValueError(f"{value!r} is no rotation; it must be four numbers, (x, y, z, w).") from None


def _c_transform(value: TransformLike) -> Any:
    p, q = value
    return _c_vector(p), _c_quaternion(q)


def _c_bounds(value: BoundsLike) -> Any:
    lower, upper = value
    return _c_vector(lower), _c_vector(upper)


E = TypeVar("E", bound=enum.IntEnum)


def _choice(kind: Type[E], value: Union[E, int, str]) -> int:
    """One of an enumeration's values, which may be given by name: "dynamic", "soft_step", "softStep"."""
    if isinstance(value, str):
        name = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", value).upper()
        if name not in kind.__members__:
            names = ", ".join(n.lower() for n in kind.__members__)
            raise InvalidValueError(f"{value!r} is no {kind.__name__}; there are {names}.")
        return int(kind[name])
    return int(value)


def quaternion_about(axis: VectorLike, angle: float) -> Quaternion:
    """The rotation by an angle [rad] about an axis of any length."""
    u = np.asarray(axis, dtype=float)
    length = float(np.linalg.norm(u))
    if not length > 0:
        raise InvalidValueError("The axis has no length.")
    return np.append(u / length * np.sin(angle / 2), np.cos(angle / 2))


def rotate(q: QuaternionLike, v: VectorLike) -> Vector:
    """A vector turned by a rotation."""
    q, v = np.asarray(q, dtype=float), np.asarray(v, dtype=float)
    t = 2 * np.cross(q[:3], v)
    return v + q[3] * t + np.cross(q[:3], t)


def multiply(p: QuaternionLike, q: QuaternionLike) -> Quaternion:
    """The rotation that turns by q, then by p."""
    p, q = np.asarray(p, dtype=float), np.asarray(q, dtype=float)
    return np.append(p[3] * q[:3] + q[3] * p[:3] + np.cross(p[:3], q[:3]), p[3] * q[3] - p[:3] @ q[:3])


def conjugate(q: QuaternionLike) -> Quaternion:
    """The rotation back."""
    return np.asarray(q, dtype=float) * (-1, -1, -1, 1)


def rotation_between(a: VectorLike, b: VectorLike) -> Quaternion:
    """The shortest rotation from one direction to another."""
    a, b = np.asarray(a, dtype=float), np.asarray(b, dtype=float)
    scale = float(np.linalg.norm(a) * np.linalg.norm(b))
    if not scale > 0:
        raise InvalidValueError("A direction has no length.")
    q = np.append(np.cross(a, b), scale + a @ b)
    if np.linalg.norm(q) < 1e-6 * scale:
        side = np.cross(a, np.eye(3)[np.argmin(np.abs(a))])
        return np.append(side / np.linalg.norm(side), 0.0)
    return q / np.linalg.norm(q)
