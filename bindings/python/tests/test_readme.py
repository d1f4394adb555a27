"""What the README shows, runs; what is generated, is fresh."""

import re
import runpy
import subprocess
import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent.parent
BLOCKS = re.findall(r"```python\n(.*?)```", (HERE / "README.md").read_text(), re.S)


@pytest.mark.parametrize("block", BLOCKS, ids=range(len(BLOCKS)))
def test_each_block_runs_on_its_own(block, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    script = tmp_path / "block.py"
    script.write_text(block)
    runpy.run_path(str(script))
    said = capsys.readouterr().out
    for comment in re.findall(r"print\(error\)\s+# (.*)", block):
        assert comment in said


def test_there_are_blocks():
    assert len(BLOCKS) >= 5


def test_the_generated_file_is_fresh():
    subprocess.run([sys.executable, str(HERE / "generate.py"), "--check"], check=True)
