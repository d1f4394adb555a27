"""What happened in the last step."""

from __future__ import annotations

from typing import TYPE_CHECKING, List, NamedTuple

from ._values import Transform, Vector
from .body import Body
from .shape import Shape

if TYPE_CHECKING:
    from .joint import Joint


class ContactTouch(NamedTuple):
    """Two shapes began or ceased to touch. At an end either may have been destroyed."""

    shape_a: Shape
    shape_b: Shape


class ContactHit(NamedTuple):
    """Two shapes hit each other faster than the world's threshold."""

    shape_a: Shape
    shape_b: Shape
    point: Vector
    """Where [m]."""
    normal: Vector
    """From A to B."""
    approach_speed: float
    """[m/s]"""


class ContactEvents(NamedTuple):
    """Contacts of the last step."""

    begin: List[ContactTouch]
    end: List[ContactTouch]
    hit: List[ContactHit]


class BodyMove(NamedTuple):
    """A body moved, or fell asleep."""

    body: Body
    transform: Transform
    fell_asleep: bool


class JointLoad(NamedTuple):
    """A joint carried more than a threshold, and may have broken."""

    joint: "Joint"
    force: float
    """[N]"""
    torque: float
    """[N m]"""
    broke: bool
