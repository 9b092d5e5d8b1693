"""Every command of the tutorial works as it stands there, one after the other, on the virtual robot."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from upright.cli.main import main

TUTORIAL = Path(__file__).parents[1] / "docs" / "first-robot.md"


def commands() -> list[str]:
    blocks = re.findall(r"```sh\n(.*?)```", TUTORIAL.read_text(encoding="utf-8"), re.DOTALL)
    return [line for block in blocks for line in block.splitlines() if line.startswith("upright ")]


@pytest.mark.evidence
@pytest.mark.needs("nbc", "module:nxt", "module:micropython_unix", "module:pybricksdev")
def test_every_command_of_the_tutorial_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert len(commands()) >= 18
    for command in commands():
        code = main(shlex.split(command)[1:])
        assert code == 0, f"{command}: {capsys.readouterr().err}"
    for made in ("certificate.html", "mine.html", "report.html", "mine.toml", "first.parquet", "spike.parquet"):
        assert Path(made).exists()
