"""The scene that every binding computes comes out as in C, bit for bit."""

import re
import runpy
import shutil
import subprocess
from pathlib import Path

import pytest

from merev._library import lib

BINDINGS = Path(__file__).resolve().parent.parent.parent
SCENE = BINDINGS / "same_hash/same_hash.c"


@pytest.mark.skipif(shutil.which("cc") is None, reason="needs a C compiler")
def test_the_hash_is_that_of_the_c_program(tmp_path):
    # The very library that this package has loaded: cffi names it.
    library = Path(re.search(r"'(.+)'", repr(lib))[1])
    program = tmp_path / "same_hash"
    subprocess.run(
        ["cc", "-std=c99", "-I", BINDINGS.parent / "include", SCENE, "-o", program, library, "-lm"]
        + [f"-Wl,-rpath,{library.parent}"],
        check=True,
    )
    in_c = subprocess.run([program], check=True, capture_output=True, text=True).stdout.strip()
    in_python = runpy.run_path(str(BINDINGS / "same_hash/same_hash.py"))["same_hash"]()
    assert re.fullmatch("[0-9a-f]{16}", in_c)
    assert f"{in_python:016x}" == in_c
