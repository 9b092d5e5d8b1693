"""Every command of the tutorial works as it stands there, one after the other, on the virtual robot."""

from __future__ import annotations

import re
import shlex
from dataclasses import asdict
from pathlib import Path
from typing import Any

import pytest

from heads import begins_as
from upright.cli.main import main
from upright.reports import finished

TUTORIAL = Path(__file__).parents[1] / "docs" / "first-robot.md"


def commands() -> list[str]:
    blocks = re.findall(r"```sh\n(.*?)```", TUTORIAL.read_text(encoding="utf-8"), re.DOTALL)
    return [line for block in blocks for line in block.splitlines() if line.startswith("upright ")]


@pytest.mark.evidence
@pytest.mark.needs("nbc", "module:nxt", "module:micropython_unix", "module:pybricksdev")
def test_every_command_of_the_tutorial_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], paged: list[Any]
) -> None:
    """And begins as the page of its result does, where it has one."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    assert len(commands()) >= 18
    compared = set[str]()
    for command in commands():
        paged.clear()
        capsys.readouterr()
        words = shlex.split(command)[1:]
        code = main(words)
        printed = capsys.readouterr()
        assert code == 0, f"{command}: {printed.err}"
        if words[0] in HEADS and words[0] not in compared:
            page = finished(paged[-1], command=command)
            begins_as(printed.out, asdict(page.head), page.html())
            compared.add(words[0])
    assert compared == HEADS
    for made in ("certificate.html", "mine.html", "report.html", "mine.toml", "first.parquet", "spike.parquet"):
        assert Path(made).exists()


HEADS = {"design", "certify", "calibrate", "validate", "excite", "parity"}
"""Commands of the tutorial whose heads are compared here; `test_head.py` has the others."""
