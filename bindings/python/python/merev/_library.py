"""The C library: loading it, calling it, and what its failures become."""

from __future__ import annotations

from typing import Any, Callable

from . import _native

ffi: Any = _native.ffi
lib: Any = _native.lib


class MerevError(RuntimeError):
    """A call failed; nothing was changed. The text is the library's sentence, :attr:`code` its number."""

    code: int

    def __init__(self, sentence: str, code: int = 0) -> None:
        super().__init__(sentence)
        self.code = code


class InvalidObjectError(MerevError):
    """The world, body, shape or joint was destroyed, or belongs to another world."""


class InvalidValueError(MerevError, ValueError):
    """A number is not finite or outside its range, or geometry has no volume."""


class LockedError(MerevError):
    """A callback tried to change the world it is called from."""


class BusyError(MerevError):
    """Another thread is using the world."""


class UnsupportedError(MerevError):
    """A choice that exists but is not built into this version."""


_ERRORS = {
    1: InvalidObjectError,
    2: InvalidObjectError,
    3: InvalidObjectError,
    4: InvalidValueError,
    5: InvalidValueError,
    6: InvalidValueError,
    7: InvalidValueError,
    8: LockedError,
    9: BusyError,
    11: UnsupportedError,
}


def call(function: Callable[..., Any], *arguments: Any) -> Any:
    """Calls a C function; raises what went wrong. The GIL is released meanwhile."""
    result = function(*arguments)
    code = lib.mvGetLastError()
    if code:
        raise _ERRORS.get(code, MerevError)(ffi.string(lib.mvGetLastErrorMessage()).decode(), code)
    return result


def check_library(library: Any) -> None:
    """Refuses a library that is not the one this package was made for."""
    if library.mvIsDoublePrecision():
        raise ImportError("The merev library that was loaded computes in double precision; this package needs single.")
    found, wanted = library.mvGetAbiRevision(), library.MV_ABI_REVISION
    if found != wanted:
        raise ImportError(
            f"The merev library that was loaded has ABI revision {found}; this package was made for revision {wanted}. "
            "Install the package again."
        )


check_library(lib)


def version() -> str:
    """The version of the library, such as "0.1.0"."""
    v = lib.mvGetVersion()
    return f"{v.major}.{v.minor}.{v.revision}"
