"""Every command of the tutorial works as it stands there, one after the other, on the virtual robot."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from upright.cli.main import main

TUTORIAL = Path(__file__).parents[1] / "docs" / "first-robot.md"


WORDS = 700
"""Of the page at most, with its commands: as many as a beginner reads before the first of them runs."""


def commands() -> dict[str, list[str]]:
    """The commands in their order, the last one of a block with the lines that the page shows of its output."""
    shown: dict[str, list[str]] = {}
    blocks = re.findall(
        r"```sh\n(.*?)```(?:\s*[^`]{0,80}\s*```text\n(.*?)```)?", TUTORIAL.read_text("utf-8"), re.DOTALL
    )
    for typed, seen in blocks:
        shown |= {line: [] for line in typed.splitlines()}
        shown[typed.splitlines()[-1]] = seen.splitlines()
    return shown


def without_numbers(text: str) -> str:
    """Numbers hang on the processor's rounding; tables stand in columns as wide as they are."""
    return " ".join(re.sub(r"\d[\d.]*", "0", text).split())


def test_the_tutorial_is_short() -> None:
    assert len(TUTORIAL.read_text("utf-8").split()) <= WORDS


@pytest.mark.evidence
@pytest.mark.needs("nbc", "module:nxt", "module:micropython_unix", "module:pybricksdev")
def test_every_command_of_the_tutorial_works(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    assert len(commands()) >= 18
    assert sum(map(bool, commands().values())) >= 4
    for command, seen in commands().items():
        capsys.readouterr()
        words = shlex.split(command)[1:]
        code = main(words)
        printed = capsys.readouterr()
        assert code == 0, f"{command}: {printed.err}"
        for line in seen:
            assert without_numbers(line) in without_numbers(printed.out), command
    for made in ("certificate.html", "mine.html", "report.html", "mine.toml", "first.parquet", "spike.parquet"):
        assert Path(made).exists()
