"""Joints. Each sits between a frame fixed in body A and one fixed in body B."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from . import _generated as g
from ._definitions import fill
from ._ids import copy, pack
from ._library import call, ffi, lib
from ._values import (
    QuaternionLike,
    VectorLike,
    _c_transform,
    conjugate,
    multiply,
    rotate,
    rotation_between,
)

if TYPE_CHECKING:
    from .body import Body
    from .world import World

# The axis of the frames that `axis` gives a direction to: z of a hinge, x of a slide.
_AXES = {
    "Revolute": (0.0, 0.0, 1.0),
    "Spherical": (0.0, 0.0, 1.0),
    "Parallel": (0.0, 0.0, 1.0),
    "Prismatic": (1.0, 0.0, 0.0),
    "Screw": (1.0, 0.0, 0.0),
}


class Joint(g.JointFunctions):
    """What all joints have."""

    def __init__(self, world: World, id: Any) -> None:
        self.world = world
        self._id = copy("mvJointId", id)

    @property
    def id(self) -> int:
        """The id as one number."""
        return pack(self._id)

    @property
    def is_valid(self) -> bool:
        """Whether the joint still exists."""
        return bool(lib.mvJoint_IsValid(self._id))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Joint) and self.id == other.id

    def __hash__(self) -> int:
        return hash(("joint", self.id))

    def __repr__(self) -> str:
        return f"<merev.{type(self).__name__}{'' if self.is_valid else ', destroyed'}>"

    @property
    def body_a(self) -> Body:
        """The first body."""
        from .body import Body

        return Body(self.world, call(lib.mvJoint_GetBodyA, self._id))

    @property
    def body_b(self) -> Body:
        """The second body."""
        from .body import Body

        return Body(self.world, call(lib.mvJoint_GetBodyB, self._id))

    def destroy(self, wake: bool = True) -> None:
        """Removes the joint."""
        call(lib.mvDestroyJoint, self._id, wake)

    @property
    def constraint_tuning(self) -> Tuple[float, float]:
        """Stiffness [Hz], 0 for rigid, and damping ratio of what the joint holds."""
        values = ffi.new("mvFloat[2]")
        call(lib.mvJoint_GetConstraintTuning, self._id, values, values + 1)
        return values[0], values[1]

    @constraint_tuning.setter
    def constraint_tuning(self, value: Tuple[float, float]) -> None:
        call(lib.mvJoint_SetConstraintTuning, self._id, *value)


class DistanceJoint(g.DistanceJointFunctions, Joint):
    """A rod, rope or spring between two points."""

    @property
    def spring_force_range(self) -> Tuple[float, float]:
        """The bounds of the force of the spring [N], positive where it pushes."""
        values = ffi.new("mvFloat[2]")
        call(lib.mvDistanceJoint_GetSpringForceRange, self._id, values, values + 1)
        return values[0], values[1]


class FilterJoint(g.FilterJointFunctions, Joint):
    """Two bodies that do not collide."""


class GearJoint(g.GearJointFunctions, Joint):
    """Two joints in step."""


class MotorJoint(g.MotorJointFunctions, Joint):
    """Drives one body against another."""


class ParallelJoint(g.ParallelJointFunctions, Joint):
    """A spring that keeps two axes along each other."""


class PrismaticJoint(g.PrismaticJointFunctions, Joint):
    """A slide along x."""


class PulleyJoint(g.PulleyJointFunctions, Joint):
    """A rope over two fixed points."""


class RackPinionJoint(g.RackPinionJointFunctions, Joint):
    """A turn in step with a slide."""


class RevoluteJoint(g.RevoluteJointFunctions, Joint):
    """A hinge about z."""


class ScrewJoint(g.ScrewJointFunctions, Joint):
    """A slide in step with a turn about the same axis, x."""


class SixDofJoint(g.SixDofJointFunctions, Joint):
    """Six axes, each free, locked or limited."""


class SphericalJoint(g.SphericalJointFunctions, Joint):
    """Ball and socket."""


class UniversalJoint(g.UniversalJointFunctions, Joint):
    """Cardan's joint: x of frame A across y of frame B."""


class WeldJoint(g.WeldJointFunctions, Joint):
    """Two bodies as one."""


class WheelJoint(g.WheelJointFunctions, Joint):
    """A wheel on its suspension."""


_CLASSES = {
    g.JointType.PARALLEL: ParallelJoint,
    g.JointType.DISTANCE: DistanceJoint,
    g.JointType.FILTER: FilterJoint,
    g.JointType.MOTOR: MotorJoint,
    g.JointType.PRISMATIC: PrismaticJoint,
    g.JointType.REVOLUTE: RevoluteJoint,
    g.JointType.SPHERICAL: SphericalJoint,
    g.JointType.WELD: WeldJoint,
    g.JointType.WHEEL: WheelJoint,
    g.JointType.UNIVERSAL: UniversalJoint,
    g.JointType.SIX_DOF: SixDofJoint,
    g.JointType.GEAR: GearJoint,
    g.JointType.RACK_PINION: RackPinionJoint,
    g.JointType.PULLEY: PulleyJoint,
    g.JointType.SCREW: ScrewJoint,
}


def wrap(world: World, id: Any) -> Joint:
    """The joint with this id, as an object of its class; one that is gone is just a joint."""
    if not lib.mvJoint_IsValid(id):
        return Joint(world, id)
    return _CLASSES[g.JointType(call(lib.mvJoint_GetType, id))](world, id)


_BASE = {
    "force_threshold",
    "torque_threshold",
    "constraint_hertz",
    "constraint_damping_ratio",
    "draw_scale",
    "collide_connected",
    "breakable",
}


def local_frame(body: Body, point: VectorLike, rotation: QuaternionLike) -> Tuple[np.ndarray, np.ndarray]:
    """A frame of the world as seen from a body."""
    p, q = body.transform
    return rotate(conjugate(q), np.asarray(point, dtype=float) - p), multiply(conjugate(q), rotation)


def _place(kind: str, definition: Any, body_a: Body, body_b: Body, options: Dict[str, Any]) -> None:
    """Frames: given in the bodies (local_frame_a, local_frame_b), or in the world (anchor or anchor_a and anchor_b,
    axis)."""
    axis: Optional[VectorLike] = options.pop("axis", None)
    anchor = options.pop("anchor", None)
    anchors = (options.pop("anchor_a", anchor), options.pop("anchor_b", anchor))
    frames = (options.pop("local_frame_a", None), options.pop("local_frame_b", None))
    in_world = axis is not None or any(a is not None for a in anchors)
    if in_world and any(f is not None for f in frames):
        raise TypeError("Give anchor and axis, or local_frame_a and local_frame_b, not both.")
    rotation = np.array((0.0, 0.0, 0.0, 1.0))
    if axis is not None:
        if kind == "Wheel":
            # x of frame A is the way of the suspension, z of frame B what the wheel spins about.
            raise TypeError("A wheel has two axes: give local_frame_a and local_frame_b.")
        if kind not in _AXES:
            raise TypeError(f"A {kind.lower()} joint has no axis.")
        rotation = rotation_between(_AXES[kind], axis)
    for side, body, point, frame in zip("AB", (body_a, body_b), anchors, frames):
        if frame is None and in_world:
            frame = local_frame(body, body.position if point is None else point, rotation)
        if frame is not None:
            setattr(definition.base, f"localFrame{side}", _c_transform(frame))


def create(world: World, kind: str, body_a: Body, body_b: Body, options: Dict[str, Any]) -> Any:
    """See the methods of :class:`World`."""
    options = dict(options)
    definition = getattr(lib, f"mvDefault{kind}JointDef")()
    definition.base.bodyIdA = body_a._id
    definition.base.bodyIdB = body_b._id
    _place(kind, definition, body_a, body_b, options)
    return _finish(world, kind, definition, options)


def create_gear(world: World, kind: str, joint_a: Joint, joint_b: Joint, options: Dict[str, Any]) -> Any:
    """See the methods of :class:`World`."""
    definition = getattr(lib, f"mvDefault{kind}JointDef")()
    definition.jointIdA, definition.jointIdB = joint_a._id, joint_b._id
    return _finish(world, kind, definition, dict(options))


def _finish(world: World, kind: str, definition: Any, options: Dict[str, Any]) -> Any:
    base = {name: options.pop(name) for name in list(options) if name in _BASE}
    fill(definition.base, base, "A joint")
    fill(definition, options, f"A {kind} joint")
    pointer = ffi.new(f"mv{kind}JointDef*", definition)
    return wrap(world, call(getattr(lib, f"mvCreate{kind}Joint"), world._id, pointer))

