"""Makes python/merev/_native for use without a wheel:

    python develop.py LIBRARY HEADER

LIBRARY is a libmerev built in single precision; HEADER is header.h in cargo's target folder, which building the crate
merev-python writes. What maturin does for a wheel is done here for a library that is there already.
"""

import sys
from pathlib import Path

import cffi


def main(library, header):
    library = Path(library).resolve()
    folder = Path(__file__).resolve().parent / "python/merev/_native"
    folder.mkdir(exist_ok=True)
    ffi = cffi.FFI()
    ffi.cdef(Path(header).read_text())
    ffi.set_source("ffi", None)
    ffi.emit_python_code(str(folder / "ffi.py"))
    (folder / "__init__.py").write_text(
        f'"""Made by develop.py."""\nfrom .ffi import ffi\n\nlib = ffi.dlopen({str(library)!r})\n'
    )


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
