"""Definitions of C filled from keyword arguments: linear_damping=0.1 sets linearDamping."""

from __future__ import annotations

import enum
import re
from typing import Any, Dict, List, Type

from . import _generated as g
from ._library import ffi
from ._values import _c_bounds, _c_quaternion, _c_transform, _c_vector, _choice

_VECTORS = {"mvVec3", "mvPos"}
_TRANSFORMS = {"mvTransform", "mvWorldTransform"}
_ENUMS: Dict[str, Type[enum.IntEnum]] = {
    "solver": g.SolverKind,
    "integrator": g.IntegratorKind,
    "broadPhase": g.BroadPhaseKind,
    "narrowPhase": g.NarrowPhaseKind,
    "gjk": g.GjkKind,
    "manifold": g.ManifoldKind,
    "type": g.BodyType,
}
_HIDDEN = {"internalValue", "userData", "name", "base", "context"}


def camel(name: str) -> str:
    head, *rest = name.split("_")
    return head + "".join(part[:1].upper() + part[1:] for part in rest)


def snake(name: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).lower()


def names(definition: Any) -> List[str]:
    """What keywords a definition has."""
    fields = dict(ffi.typeof(definition).fields)
    return [snake(f) for f, t in fields.items() if f not in _HIDDEN and t.type.kind != "pointer" and t.type.kind != "function"]


def fill(definition: Any, values: Dict[str, Any], what: str) -> None:
    """Sets fields of a definition."""
    fields = dict(ffi.typeof(definition).fields)
    for name, value in values.items():
        field = camel(name)
        if field not in fields or field in _HIDDEN or fields[field].type.kind in ("pointer", "function"):
            known = ", ".join(sorted(names(definition)))
            raise TypeError(f"{what} has no {name!r}; there are {known}.")
        setattr(definition, field, value_for(field, fields[field].type, value))


def value_for(field: str, kind: Any, value: Any) -> Any:
    """A value as C wants it."""
    c = kind.cname.replace("struct ", "")
    if c in _VECTORS:
        return _c_vector(value)
    if c == "mvQuat":
        return _c_quaternion(value)
    if c in _TRANSFORMS:
        return _c_transform(value)
    if c == "mvAABB":
        return _c_bounds(value)
    if field in _ENUMS and kind.kind == "primitive":
        return _choice(_ENUMS[field], value)
    if hasattr(value, "_to_c"):
        return value._to_c()
    if kind.kind == "array":
        return [value_for(field, kind.item, v) for v in value]
    if c in ("float", "double"):
        return float(value)
    if c in ("_Bool", "bool"):
        return bool(value)
    return value
