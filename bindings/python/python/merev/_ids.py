"""Ids: small structures in C, one number each here."""

from __future__ import annotations

from typing import Any

from ._library import ffi


def copy(kind: str, id: Any) -> Any:
    """A copy that owns its memory: ids in arrays of the library do not stay."""
    return ffi.new(f"{kind}*", id)[0]


def pack(id: Any) -> int:
    """An id as one number: its eight bytes as they lie in memory."""
    return int(ffi.cast("uint64_t*", ffi.addressof(id))[0])


def unpack(kind: str, packed: int) -> Any:
    """An id from its number."""
    id = ffi.new(f"{kind}*")
    ffi.memmove(id, ffi.new("uint64_t*", packed), 8)
    return id[0]
