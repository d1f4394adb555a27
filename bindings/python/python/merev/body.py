"""Bodies."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, List, Optional, Sequence, Tuple

import numpy as np

from . import _generated as g
from ._definitions import fill
from ._ids import copy, pack
from ._library import call, ffi, lib
from ._values import QuaternionLike, TransformLike, VectorLike, _c_quaternion, _c_transform, _c_vector
from .shape import Shape

if TYPE_CHECKING:
    from .joint import Joint
    from .world import World

_MATERIAL = ("friction", "static_friction", "restitution", "rolling_resistance", "tangent_velocity", "user_material_id")


class Body(g.BodyFunctions):
    """A body. Bodies compare equal when they are the same body; they may be keys of dictionaries."""

    def __init__(self, world: World, id: Any) -> None:
        self.world = world
        self._id = copy("mvBodyId", id)

    @property
    def id(self) -> int:
        """The id as one number, as in :attr:`AwakeState.ids`."""
        return pack(self._id)

    @property
    def is_valid(self) -> bool:
        """Whether the body, and its world, still exist."""
        return bool(lib.mvBody_IsValid(self._id))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Body) and self.id == other.id

    def __hash__(self) -> int:
        return hash(("body", self.id))

    def __repr__(self) -> str:
        if not self.is_valid:
            return "<merev.Body, destroyed>"
        x, y, z = self.position
        return f"<merev.Body {self.name!r} {self.type.name.lower()} at ({x:.4g}, {y:.4g}, {z:.4g})>"

    def destroy(self) -> None:
        """Removes the body with its shapes and joints."""
        call(lib.mvDestroyBody, self._id)
        self.world._user.pop(("body", self.id), None)

    @property
    def name(self) -> str:
        """A name for people."""
        return ffi.string(call(lib.mvBody_GetName, self._id)).decode()

    @name.setter
    def name(self, value: Optional[str]) -> None:
        call(lib.mvBody_SetName, self._id, ffi.NULL if value is None else value.encode())

    @property
    def user_data(self) -> Any:
        """Anything you want to find here again; None at first."""
        return self.world._user.get(("body", self.id))

    @user_data.setter
    def user_data(self, value: Any) -> None:
        if not self.is_valid:
            call(lib.mvBody_GetType, self._id)
        self.world._user[("body", self.id)] = value

    def set_transform(self, position: VectorLike, rotation: QuaternionLike = (0.0, 0.0, 0.0, 1.0)) -> None:
        """Puts the body's origin there; velocities stay."""
        call(lib.mvBody_SetTransform, self._id, _c_vector(position), _c_quaternion(rotation))

    def set_target_transform(self, target: TransformLike, dt: float, wake: bool = True) -> None:
        """Gives the body the velocities with which it will be there after ``dt`` seconds."""
        call(lib.mvBody_SetTargetTransform, self._id, _c_transform(target), dt, wake)

    @property
    def shapes(self) -> List[Shape]:
        """Its shapes, in order of attachment."""
        count = call(lib.mvBody_GetShapeCount, self._id)
        array = ffi.new("mvShapeId[]", max(count, 1))
        count = call(lib.mvBody_GetShapes, self._id, array, count)
        return [Shape(self.world, array[k]) for k in range(count)]

    @property
    def joints(self) -> List[Joint]:
        """Its joints."""
        from .joint import wrap

        count = call(lib.mvBody_GetJointCount, self._id)
        array = ffi.new("mvJointId[]", max(count, 1))
        count = call(lib.mvBody_GetJoints, self._id, array, count)
        return [wrap(self.world, array[k]) for k in range(count)]

    # ---- shapes ---------------------------------------------------------------------------------------------------

    def _definition(self, options: Any) -> Tuple[Any, Any]:
        definition = lib.mvDefaultShapeDef()
        options = dict(options)
        name, color = options.pop("name", None), options.pop("color", None)
        for key in _MATERIAL:
            if key in options:
                fill(definition.baseMaterial, {key: options.pop(key)}, "A material")
        if color is not None:
            definition.baseMaterial.customColor = int(color)
        fill(definition, options, "A shape")
        text = ffi.NULL if name is None else ffi.new("char[]", name.encode())
        definition.name = text
        return ffi.new("mvShapeDef*", definition), text

    def _add(self, function: Any, options: Any, *arguments: Any) -> Shape:
        definition, _keep = self._definition(options)
        return Shape(self.world, call(function, self._id, definition, *arguments))

    def add_sphere(self, radius: float, center: VectorLike = (0.0, 0.0, 0.0), **options: Any) -> Shape:
        """A ball. Options of all shapes: ``density`` [kg/m³, default 1000], ``friction`` (0.6), ``static_friction``,
        ``restitution`` (0), ``rolling_resistance``, ``tangent_velocity``, ``color`` (0xRRGGBB), ``name``, ``filter``,
        ``enable_contact_events``, ``enable_hit_events``, ``update_body_mass``."""
        sphere = ffi.new("mvSphere*", (_c_vector(center), float(radius)))
        return self._add(lib.mvCreateSphereShape, options, sphere)

    def add_box(self, hx: float, hy: float, hz: float, **options: Any) -> Shape:
        """A box with these half extents [m] about the body's origin."""
        return self._add(lib.mvCreateBoxShape, options, float(hx), float(hy), float(hz))

    def add_capsule(self, center1: VectorLike, center2: VectorLike, radius: float, **options: Any) -> Shape:
        """All points within a radius of a segment."""
        capsule = ffi.new("mvCapsule*", (_c_vector(center1), _c_vector(center2), float(radius)))
        return self._add(lib.mvCreateCapsuleShape, options, capsule)

    def add_hull(self, points: Sequence[VectorLike], max_vertices: int = 255, **options: Any) -> Shape:
        """The convex hull of some points [m]."""
        rows = np.ascontiguousarray(points, dtype=np.float32).reshape(-1, 3)
        hull = call(lib.mvCreateHull, ffi.cast("mvVec3*", rows.ctypes.data), len(rows), max_vertices)
        try:
            return self._add(lib.mvCreateHullShape, options, hull)
        finally:
            lib.mvDestroyHull(hull)

    def add_cylinder(self, height: float, radius: float, sides: int = 16, y_offset: float = 0.0, **options: Any) -> Shape:
        """A prism along y that stands for a cylinder; its bottom is at ``y_offset``."""
        hull = call(lib.mvCreateCylinder, float(height), float(radius), float(y_offset), sides)
        try:
            return self._add(lib.mvCreateHullShape, options, hull)
        finally:
            lib.mvDestroyHull(hull)

    def add_plane(self, normal: VectorLike = (0.0, 1.0, 0.0), offset: float = 0.0, **options: Any) -> Shape:
        """Everything below a plane; for static bodies."""
        plane = ffi.new("mvPlane*", (_c_vector(normal), float(offset)))
        return self._add(lib.mvCreatePlaneShape, options, plane)

