"""The state of many bodies in arrays that the caller keeps."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from ._library import call, ffi, lib

if TYPE_CHECKING:
    from .world import World


class AwakeState:
    """Placement and velocities of all awake bodies, filled by :meth:`World.read_awake` in one call.

    The arrays stay where they are from read to read, and grow only when there are more bodies than ever before. The
    properties are views of the first :attr:`count` rows.
    """

    def __init__(self, capacity: int = 64) -> None:
        self.count = 0
        """How many bodies were awake at the last read."""
        self._make(max(int(capacity), 1))

    def _make(self, capacity: int) -> None:
        self._ids = np.zeros(capacity, dtype=np.uint64)
        self._transforms = np.zeros((capacity, 7), dtype=np.float32)
        self._linear = np.zeros((capacity, 3), dtype=np.float32)
        self._angular = np.zeros((capacity, 3), dtype=np.float32)
        self._pointers = (
            ffi.cast("mvBodyId*", self._ids.ctypes.data),
            ffi.cast("mvWorldTransform*", self._transforms.ctypes.data),
            ffi.cast("mvVec3*", self._linear.ctypes.data),
            ffi.cast("mvVec3*", self._angular.ctypes.data),
        )

    @property
    def capacity(self) -> int:
        """How many bodies there is room for."""
        return len(self._ids)

    def _read(self, world: World) -> AwakeState:
        while True:
            total = call(lib.mvWorld_GetAwakeBodies, world._id, *self._pointers, self.capacity)
            if total <= self.capacity:
                self.count = total
                return self
            self._make(max(total, 2 * self.capacity))

    @property
    def ids(self) -> np.ndarray:
        """The bodies, as :attr:`Body.id`: in no particular order, which may change from step to step."""
        return self._ids[: self.count]

    @property
    def transforms(self) -> np.ndarray:
        """(x, y, z, qx, qy, qz, qw) of each body's origin."""
        return self._transforms[: self.count]

    @property
    def positions(self) -> np.ndarray:
        """Where the origins are [m]."""
        return self._transforms[: self.count, :3]

    @property
    def rotations(self) -> np.ndarray:
        """(x, y, z, w) of each body."""
        return self._transforms[: self.count, 3:]

    @property
    def linear_velocities(self) -> np.ndarray:
        """Velocities of the centres of mass [m/s]."""
        return self._linear[: self.count]

    @property
    def angular_velocities(self) -> np.ndarray:
        """Angular velocities, world axes [rad/s]."""
        return self._angular[: self.count]
