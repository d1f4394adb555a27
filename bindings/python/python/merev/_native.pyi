"""The C functions as cffi loads them: made when the wheel is built."""

from typing import Any

ffi: Any
lib: Any
