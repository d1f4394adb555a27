"""Shapes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Optional

from . import _generated as g
from ._ids import copy, pack
from ._library import call, ffi, lib

if TYPE_CHECKING:
    from .body import Body
    from .world import World


class Shape(g.ShapeFunctions):
    """A shape attached to a body."""

    def __init__(self, world: World, id: Any) -> None:
        self.world = world
        self._id = copy("mvShapeId", id)

    @property
    def id(self) -> int:
        """The id as one number."""
        return pack(self._id)

    @property
    def is_valid(self) -> bool:
        """Whether the shape still exists."""
        return bool(lib.mvShape_IsValid(self._id))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Shape) and self.id == other.id

    def __hash__(self) -> int:
        return hash(("shape", self.id))

    def __repr__(self) -> str:
        return f"<merev.Shape, {self.type.name.lower()}>" if self.is_valid else "<merev.Shape, destroyed>"

    @property
    def body(self) -> Body:
        """The body it is attached to."""
        from .body import Body

        return Body(self.world, call(lib.mvShape_GetBody, self._id))

    def destroy(self, update_body_mass: bool = True) -> None:
        """Removes the shape."""
        call(lib.mvDestroyShape, self._id, update_body_mass)

    @property
    def name(self) -> str:
        """A name for people."""
        return ffi.string(call(lib.mvShape_GetName, self._id)).decode()

    @name.setter
    def name(self, value: Optional[str]) -> None:
        call(lib.mvShape_SetName, self._id, ffi.NULL if value is None else value.encode())
