"""Worlds: making, stepping, looking, asking."""

from __future__ import annotations

import math
import os
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Sequence, Tuple, Union

import numpy as np

from . import _generated as g
from . import joint as joints
from ._definitions import fill
from ._library import MerevError, call, ffi, lib
from ._values import Vector, VectorLike, _c_vector, _transform, _vector
from ._ids import copy, unpack
from .body import Body
from .drawing import Drawing, draw
from .events import BodyMove, ContactEvents, ContactHit, ContactTouch, JointLoad
from .shape import Shape
from .state import AwakeState

ALL = 0xFFFF_FFFF_FFFF_FFFF
"""Category or mask bits that match everything."""


class RayHit(NamedTuple):
    """Where a ray or a moving solid hits a shape."""

    shape: Shape
    """The shape that was hit."""
    point: Vector
    """The point on its surface [m]."""
    normal: Vector
    """The outward normal there; zero where a moving solid overlaps the shape from the start."""
    fraction: float
    """The fraction of the translation travelled."""


class World(g.WorldFunctions):
    """A world of rigid bodies. Destroyed by :meth:`destroy`, at the end of a ``with``, or when nothing refers to it.

    >>> with merev.World() as world:
    ...     ball = world.create_body(type="dynamic", position=(0, 4, 0))
    ...     ball.add_sphere(0.5)
    ...     world.step(1 / 60)
    """

    def __init__(self, gravity: VectorLike = (0.0, -10.0, 0.0), **options: Any) -> None:
        """Creates a world. Options are those of mvWorldDef in snake case, e.g. ``enable_sleep=False``,
        ``solver="lemke"``, ``restitution_threshold=0.5``."""
        definition = lib.mvDefaultWorldDef()
        fill(definition, {"gravity": gravity, **options}, "A world")
        self._user: Dict[Tuple[str, int], Any] = {}
        self._id = call(lib.mvCreateWorld, ffi.new("mvWorldDef*", definition))

    def destroy(self) -> None:
        """Ends the world; whatever still refers to its bodies fails from then on."""
        call(lib.mvDestroyWorld, self._id)

    def __enter__(self) -> World:
        return self

    def __exit__(self, *_: object) -> None:
        if self.is_valid:
            self.destroy()

    def __del__(self) -> None:
        if lib is not None and hasattr(self, "_id") and lib.mvWorld_IsValid(self._id):
            lib.mvDestroyWorld(self._id)
            # This may run between a failing call and the question why, so the code is cleared only if it is ours.
            if lib.mvWorld_IsValid(self._id):
                lib.mvGetLastError()

    def __repr__(self) -> str:
        if not self.is_valid:
            return "<merev.World, destroyed>"
        counters = self.counters
        return f"<merev.World of {counters.body_count} bodies>"

    @property
    def is_valid(self) -> bool:
        """Whether the world still exists."""
        return bool(lib.mvWorld_IsValid(self._id))

    # ---- stepping -------------------------------------------------------------------------------------------------

    def step(self, dt: float, sub_steps: int = 4, steps: int = 1) -> None:
        """Moves the world on by ``steps`` steps of ``dt`` seconds, each divided into ``sub_steps``."""
        for _ in range(steps):
            call(lib.mvWorld_Step, self._id, dt, sub_steps)

    # ---- making things --------------------------------------------------------------------------------------------

    def create_body(self, type: Union[g.BodyType, str] = "static", name: Optional[str] = None, **options: Any) -> Body:
        """Creates a body: "static", "kinematic" or "dynamic". Options are those of mvBodyDef in snake case, e.g.
        ``position=(0, 1, 0)``, ``rotation=(0, 0, 0, 1)``, ``linear_velocity``, ``angular_velocity``, ``gravity_scale``,
        ``linear_damping``, ``enable_sleep``. It has no mass before it has a shape."""
        definition = lib.mvDefaultBodyDef()
        fill(definition, {"type": type, **options}, "A body")
        text = ffi.NULL if name is None else ffi.new("char[]", name.encode())
        definition.name = text
        return Body(self, call(lib.mvCreateBody, self._id, ffi.new("mvBodyDef*", definition)))

    def create_ground(self, normal: VectorLike = (0.0, 1.0, 0.0), offset: float = 0.0, **options: Any) -> Body:
        """Creates a static body whose shape is everything below a plane. Options as of :meth:`Body.add_plane`."""
        body = self.create_body()
        body.add_plane(normal, offset, **options)
        return body

    def _joint(self, kind: str, body_a: Body, body_b: Body, options: Dict[str, Any]) -> Any:
        return joints.create(self, kind, body_a, body_b, options)

    def create_distance_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.DistanceJoint:
        """A rod, rope or spring between two points: ``length``, ``enable_spring``, ``hertz``, ``damping_ratio``,
        ``enable_limit``, ``min_length``, ``max_length``, motor. ``anchor_a`` and ``anchor_b`` are points of the world.
        """
        return self._joint("Distance", body_a, body_b, options)

    def create_revolute_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.RevoluteJoint:
        """A hinge about z of its frames. ``anchor`` and ``axis`` place it in the world; ``enable_limit``,
        ``lower_angle``, ``upper_angle``, ``enable_motor``, ``motor_speed``, ``max_motor_torque``, spring, friction."""
        return self._joint("Revolute", body_a, body_b, options)

    def create_prismatic_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.PrismaticJoint:
        """A slide along x of frame A, or along ``axis``: ``enable_limit``, ``lower_translation``,
        ``upper_translation``, motor, spring, friction."""
        return self._joint("Prismatic", body_a, body_b, options)

    def create_spherical_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.SphericalJoint:
        """A ball and socket at ``anchor``: cone and twist limits about ``axis`` (z), spring, motor, friction."""
        return self._joint("Spherical", body_a, body_b, options)

    def create_weld_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.WeldJoint:
        """Holds two bodies as one, rigidly or, with ``linear_hertz`` and ``angular_hertz``, by springs."""
        return self._joint("Weld", body_a, body_b, options)

    def create_wheel_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.WheelJoint:
        """A wheel (body B) on its suspension along x of frame A, spinning about z of frame B; it may steer."""
        return self._joint("Wheel", body_a, body_b, options)

    def create_motor_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.MotorJoint:
        """Drives body B to, or against, body A: ``linear_velocity``, ``max_velocity_force``, ``linear_hertz`` …"""
        return self._joint("Motor", body_a, body_b, options)

    def create_parallel_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.ParallelJoint:
        """Keeps the z axes of the frames along each other by a spring: ``hertz``, ``damping_ratio``, ``max_torque``."""
        return self._joint("Parallel", body_a, body_b, options)

    def create_filter_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.FilterJoint:
        """Lets two bodies pass through each other, and does nothing else."""
        return self._joint("Filter", body_a, body_b, options)

    def create_universal_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.UniversalJoint:
        """Cardan's joint: turns about x of frame A and about y of frame B, each with limits, motor, spring."""
        return self._joint("Universal", body_a, body_b, options)

    def create_six_dof_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.SixDofJoint:
        """Six axes, each free, locked or limited: set them with :meth:`SixDofJoint.set_axis`."""
        return self._joint("SixDof", body_a, body_b, options)

    def create_gear_joint(self, joint_a: joints.Joint, joint_b: joints.Joint, **options: Any) -> joints.GearJoint:
        """Ties the coordinates of two joints (hinges, slides) together by ``ratio``."""
        return joints.create_gear(self, "Gear", joint_a, joint_b, options)

    def create_rack_pinion_joint(self, joint_a: joints.Joint, joint_b: joints.Joint, **options: Any) -> joints.RackPinionJoint:
        """Ties a hinge and a slide together by ``ratio``."""
        return joints.create_gear(self, "RackPinion", joint_a, joint_b, options)

    def create_pulley_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.PulleyJoint:
        """A rope over ``ground_anchor_a`` and ``ground_anchor_b``, two points of the world; ``anchor_a`` and
        ``anchor_b`` are where it holds the bodies."""
        return self._joint("Pulley", body_a, body_b, options)

    def create_screw_joint(self, body_a: Body, body_b: Body, **options: Any) -> joints.ScrewJoint:
        """A turn about x of the frames, or about ``axis``, in step with a slide: ``pitch`` is the way of a turn [m]."""
        return self._joint("Screw", body_a, body_b, options)

    # ---- state ----------------------------------------------------------------------------------------------------

    @property
    def state_hash(self) -> int:
        """A number that changes with any bit of any body's pose, momenta, impulses or sleep. Two runs of the same
        scene have the same."""
        return int(call(lib.mvWorld_GetStateHash, self._id))

    @property
    def step_report(self) -> g.StepReport:
        """Energy, momentum, worst overlap and so on, as of the last step."""
        return g.StepReport._from_c(call(lib.mvWorld_GetStepReport, self._id))

    def read_awake(self, state: AwakeState) -> AwakeState:
        """Reads placement and velocities of all bodies that the next step moves into arrays that you keep."""
        return state._read(self)

    def awake_bodies(self) -> List[Body]:
        """The bodies that the next step moves, in no particular order."""
        state = AwakeState()._read(self)
        return [Body(self, unpack("mvBodyId", int(i))) for i in state.ids]

    def set_transforms(self, bodies: Union[Sequence[Body], np.ndarray], transforms: np.ndarray) -> None:
        """Moves many bodies at once, or none if anything is wrong. ``bodies`` are bodies, or their ids as in
        :attr:`AwakeState.ids`; a row of ``transforms`` is (x, y, z, qx, qy, qz, qw)."""
        if isinstance(bodies, np.ndarray):
            ids = np.ascontiguousarray(bodies, dtype=np.uint64)
        else:
            ids = np.array([b.id for b in bodies], dtype=np.uint64)
        rows = np.ascontiguousarray(transforms, dtype=np.float32)
        if rows.shape != (len(ids), 7):
            raise ValueError(f"The transforms have shape {rows.shape}; it must be ({len(ids)}, 7).")
        call(
            lib.mvBody_SetTransforms,
            ffi.cast("mvBodyId*", ids.ctypes.data),
            ffi.cast("mvWorldTransform*", rows.ctypes.data),
            len(ids),
        )

    # ---- events ---------------------------------------------------------------------------------------------------

    @property
    def contact_events(self) -> ContactEvents:
        """Contacts that began and ended in the last step, and hits."""
        c = call(lib.mvWorld_GetContactEvents, self._id)
        touch = lambda e: ContactTouch(Shape(self, e.shapeIdA), Shape(self, e.shapeIdB))  # noqa: E731
        return ContactEvents(
            [touch(c.beginEvents[k]) for k in range(c.beginCount)],
            [touch(c.endEvents[k]) for k in range(c.endCount)],
            [
                ContactHit(Shape(self, e.shapeIdA), Shape(self, e.shapeIdB), _vector(e.point), _vector(e.normal), e.approachSpeed)
                for e in (c.hitEvents[k] for k in range(c.hitCount))
            ],
        )

    @property
    def body_events(self) -> List[BodyMove]:
        """The bodies that the last step moved or put to sleep."""
        c = call(lib.mvWorld_GetBodyEvents, self._id)
        events = (c.moveEvents[k] for k in range(c.moveCount))
        return [BodyMove(Body(self, e.bodyId), _transform(e.transform), e.fellAsleep) for e in events]

    @property
    def joint_events(self) -> List[JointLoad]:
        """The joints that carried more than a threshold in the last step."""
        c = call(lib.mvWorld_GetJointEvents, self._id)
        events = (c.jointEvents[k] for k in range(c.count))
        return [JointLoad(joints.wrap(self, e.jointId), e.force, e.torque, e.broke) for e in events]

    # ---- queries --------------------------------------------------------------------------------------------------

    def cast_ray(
        self, origin: VectorLike, translation: VectorLike, category_bits: int = ALL, mask_bits: int = ALL
    ) -> Optional[RayHit]:
        """The nearest shape that a ray hits; shapes in which it starts are not hit."""
        hit = call(
            lib.mvWorld_CastRayClosest, self._id, _c_vector(origin), _c_vector(translation), (category_bits, mask_bits)
        )
        return self._hit(hit) if hit.hit else None

    def cast_ray_all(
        self, origin: VectorLike, translation: VectorLike, category_bits: int = ALL, mask_bits: int = ALL
    ) -> List[RayHit]:
        """All shapes that a ray hits, nearest first."""
        ray = (_c_vector(origin), _c_vector(translation), (category_bits, mask_bits))
        hits = self._all("mvRayResult", lambda array, n: call(lib.mvWorld_CastRayAll, self._id, *ray, array, n))
        return [self._hit(h) for h in hits]

    def cast_shape(
        self,
        points: Union[VectorLike, Sequence[VectorLike]],
        radius: float,
        translation: VectorLike,
        origin: VectorLike = (0.0, 0.0, 0.0),
        category_bits: int = ALL,
        mask_bits: int = ALL,
    ) -> Optional[RayHit]:
        """The nearest shape that a solid hits which moves without turning: all points within ``radius`` of the hull of
        ``points`` (one point for a ball), which count from ``origin``."""
        proxy, _keep = _proxy(points, radius)
        filter = (category_bits, mask_bits)
        hit = call(
            lib.mvWorld_CastShapeClosest, self._id, _c_vector(origin), proxy, _c_vector(translation), filter
        )
        return self._hit(hit) if hit.hit else None

    def overlap_box(
        self, lower: VectorLike, upper: VectorLike, category_bits: int = ALL, mask_bits: int = ALL
    ) -> List[Shape]:
        """The shapes whose boxes overlap a box along the axes."""
        box = ((_c_vector(lower), _c_vector(upper)), (category_bits, mask_bits))
        found = self._all("mvShapeId", lambda array, n: call(lib.mvWorld_OverlapAABBAll, self._id, *box, array, n))
        return [Shape(self, i) for i in found]

    def overlap_shape(
        self,
        points: Union[VectorLike, Sequence[VectorLike]],
        radius: float,
        origin: VectorLike = (0.0, 0.0, 0.0),
        category_bits: int = ALL,
        mask_bits: int = ALL,
    ) -> List[Shape]:
        """The shapes that touch or overlap a solid, see :meth:`cast_shape`."""
        proxy, _keep = _proxy(points, radius)
        arguments = (_c_vector(origin), proxy, (category_bits, mask_bits))
        found = self._all("mvShapeId", lambda array, n: call(lib.mvWorld_OverlapShapeAll, self._id, *arguments, array, n))
        return [Shape(self, i) for i in found]

    def _hit(self, c: Any) -> RayHit:
        return RayHit(Shape(self, c.shapeId), _vector(c.point), _vector(c.normal), c.fraction)

    @staticmethod
    def _all(kind: str, ask: Any) -> List[Any]:
        capacity = 64
        while True:
            array = ffi.new(f"{kind}[]", capacity)
            total = ask(array, capacity)
            if total <= capacity:
                # Copies: elements of an array do not keep it alive.
                return [copy(kind, array[k]) for k in range(total)]
            capacity = total

    # ---- pictures -------------------------------------------------------------------------------------------------

    def draw(self, **options: Any) -> Drawing:
        """What the world looks like, as arrays of lines, triangles, instances and points. Options are those of
        mvDebugDraw in snake case, e.g. ``draw_contacts=True``, ``draw_edges=True``, ``tessellate=True``."""
        return draw(self, options)


def _proxy(points: Any, radius: float) -> Tuple[Any, Any]:
    rows = np.ascontiguousarray(points, dtype=np.float32).reshape(-1, 3)
    proxy = ffi.new("mvShapeProxy*")
    proxy.points = ffi.cast("mvVec3*", rows.ctypes.data)
    proxy.count = len(rows)
    proxy.radius = radius
    return proxy, rows


_pool: Optional[ThreadPoolExecutor] = None


def _workers() -> int:
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:
        return os.cpu_count() or 1


def step_worlds(
    worlds: Iterable[World], dt: float, sub_steps: int = 4, steps: int = 1, threads: Optional[int] = None
) -> None:
    """Steps many worlds, on all cores. Each comes out as if it had been stepped alone.

    Every world takes ``steps`` steps of ``dt`` seconds; ``threads`` (default: as many as there are cores) share the
    worlds. The interpreter is free for other threads meanwhile. If a world fails, the others are still stepped, and the
    first failure is raised.
    """
    global _pool
    worlds = list(worlds)
    if len({w._id.index1 for w in worlds}) < len(worlds):
        raise ValueError("A world is there twice.")
    count = min(len(worlds), _workers() if threads is None else threads)
    if count <= 1:
        shares = [worlds]
    else:
        # Small shares, so that worlds of unequal size do not leave cores idle.
        size = math.ceil(len(worlds) / (4 * count))
        shares = [worlds[k : k + size] for k in range(0, len(worlds), size)]

    def run(share: List[World]) -> Optional[Exception]:
        failed: Optional[Exception] = None
        for world in share:
            try:
                world.step(dt, sub_steps, steps)
            except MerevError as error:
                failed = failed or error
        return failed

    if count <= 1:
        results = [run(s) for s in shares]
    elif threads is None:
        if _pool is None:
            _pool = ThreadPoolExecutor(_workers(), thread_name_prefix="merev")
        results = list(_pool.map(run, shares))
    else:
        with ThreadPoolExecutor(count) as pool:
            results = list(pool.map(run, shares))
    for error in results:
        if error is not None:
            raise error
