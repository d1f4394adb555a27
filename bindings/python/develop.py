"""Makes python/merev/_native for use without a wheel:

    python develop.py LIBRARY

LIBRARY is a libmerev built in single precision. What maturin does for a wheel is done here for a library that is there
already.
"""

import sys
from pathlib import Path

import cffi


HERE = Path(__file__).resolve().parent


def main(library):
    library = Path(library).resolve()
    folder = HERE / "python/merev/_native"
    folder.mkdir(exist_ok=True)
    ffi = cffi.FFI()
    ffi.cdef((HERE / "merev_cffi.h").read_text())
    ffi.set_source("ffi", None)
    ffi.emit_python_code(str(folder / "ffi.py"))
    (folder / "__init__.py").write_text(
        f'"""Made by develop.py."""\nfrom .ffi import ffi\n\nlib = ffi.dlopen({str(library)!r})\n'
    )


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(*sys.argv[1:])
