"""merev: a rigid-body physics engine.

>>> import merev
>>> world = merev.World()
>>> ground = world.create_ground()
>>> ball = world.create_body(type="dynamic", position=(0, 4, 0))
>>> ball.add_sphere(0.5, restitution=0.8)
<merev.Shape, sphere>
>>> world.step(1 / 60, steps=60)
>>> ball.position  # doctest: +SKIP
array([0., 1.07, 0.])

Units are SI, angles radians, vectors anything of three numbers, rotations quaternions (x, y, z, w). No axis is up; gravity
is (0, −10, 0) unless said otherwise. What goes wrong is a :class:`MerevError` with the library's sentence, and changes
nothing. Different worlds may be used on different threads, and one world on one thread at a time.
"""

from ._generated import (
    AxisMode,
    BodyType,
    BroadPhaseKind,
    Capsule,
    ContactTuning,
    Counters,
    Filter,
    GjkKind,
    IntegratorKind,
    JointType,
    ManifoldKind,
    MassData,
    MotionLocks,
    NarrowPhaseKind,
    Plane,
    Profile,
    ShapeType,
    SixDofAxis,
    SolverKind,
    Sphere,
    StepReport,
    SurfaceMaterial,
)
from ._library import (
    BusyError,
    InvalidObjectError,
    InvalidValueError,
    LockedError,
    MerevError,
    UnsupportedError,
    version,
)
from ._values import Bounds, Transform, quaternion_about, rotate
from .body import Body
from .drawing import Drawing
from .events import BodyMove, ContactEvents, ContactHit, ContactTouch, JointLoad
from .joint import (
    DistanceJoint,
    FilterJoint,
    GearJoint,
    Joint,
    MotorJoint,
    ParallelJoint,
    PrismaticJoint,
    PulleyJoint,
    RackPinionJoint,
    RevoluteJoint,
    ScrewJoint,
    SixDofJoint,
    SphericalJoint,
    UniversalJoint,
    WeldJoint,
    WheelJoint,
)
from .shape import Shape
from .state import AwakeState
from .world import RayHit, World, step_worlds

__version__ = version()

__all__ = [
    "AwakeState",
    "AxisMode",
    "Body",
    "BodyMove",
    "BodyType",
    "Bounds",
    "BroadPhaseKind",
    "BusyError",
    "Capsule",
    "ContactEvents",
    "ContactHit",
    "ContactTouch",
    "ContactTuning",
    "Counters",
    "DistanceJoint",
    "Drawing",
    "Filter",
    "FilterJoint",
    "GearJoint",
    "GjkKind",
    "IntegratorKind",
    "InvalidObjectError",
    "InvalidValueError",
    "Joint",
    "JointLoad",
    "JointType",
    "LockedError",
    "ManifoldKind",
    "MassData",
    "MerevError",
    "MotionLocks",
    "MotorJoint",
    "NarrowPhaseKind",
    "ParallelJoint",
    "Plane",
    "PrismaticJoint",
    "Profile",
    "PulleyJoint",
    "RackPinionJoint",
    "RayHit",
    "RevoluteJoint",
    "ScrewJoint",
    "Shape",
    "ShapeType",
    "SixDofAxis",
    "SixDofJoint",
    "SolverKind",
    "Sphere",
    "SphericalJoint",
    "StepReport",
    "SurfaceMaterial",
    "Transform",
    "UniversalJoint",
    "UnsupportedError",
    "WeldJoint",
    "WheelJoint",
    "World",
    "quaternion_about",
    "rotate",
    "step_worlds",
    "version",
]
