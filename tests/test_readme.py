"""Ten tasks from the README and the walk that it leads to: commands as they are printed, in an empty folder."""

from __future__ import annotations

import json
import os
import re
import shlex
import time
from pathlib import Path
from typing import Any

import pytest

from conftest import PATIENCE
from upright.cli.main import main
from upright.experiment import notation
from upright.signals import Log

ROOT = Path(__file__).resolve().parents[1]
TASKS = {
    "push a robot": "simulate --robot nxtway-gs", "compare two logs": "compare", "own robot": "robots show",
    "a run of it": "simulate --robot mine", "a log": "example excited", "its faults": "doctor",
    "parameters": "calibrate", "design": "design", "certify": "certify", "program for a target": "firmware",
    "hand-ins of three": "example handed-in", "grade": "grade", "film": "film", "notebook": "example notebook",
}  # fmt: skip
"""Task → how its command begins; the README or the walk has it whole."""

LONGEST = 120.0
"""[s] The bar of a task, of the processor: the longest takes a tenth of it, on a busy machine too."""


def printed() -> list[str]:
    """Every line of the README's shell examples, then of the walk in docs/how-to.md, that calls this program: once, and
    without its comment."""
    readme, how_to = ((ROOT / name).read_text("utf-8") for name in ("README.md", "docs/how-to.md"))
    walk = how_to.partition("\n## From a log to a controller\n")[2].partition("\n## ")[0]
    blocks = re.findall(r"^```sh\n(.*?)^```", readme + walk, re.MULTILINE | re.DOTALL)
    lines = [line for block in blocks for line in block.splitlines() if line.startswith("upright ")]
    return list(dict.fromkeys(shlex.join(shlex.split(line, comments=True)) for line in lines))


def lines_of(beginning: str) -> list[str]:
    return [line for line in printed() if line.startswith(f"upright {beginning}")]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder after every command of `TASKS` was given, in the order of the pages. Each ended well, in time, and
    wrote what it names."""
    place = tmp_path_factory.mktemp("empty")
    before = Path.cwd()
    os.chdir(place)
    try:
        for line in printed():
            words = shlex.split(line)[1:]
            if not any(" ".join(words).startswith(beginning) for beginning in TASKS.values()):
                continue
            began = time.process_time()
            assert main(words) == 0, line
            assert time.process_time() - began < LONGEST, line
            if "-o" in words:
                assert Path(words[words.index("-o") + 1]).stat().st_size > 0, line
    finally:
        os.chdir(before)
    return place


@pytest.mark.parametrize("task", TASKS)
def test_there_is_a_command_for_every_task(task: str) -> None:
    assert lines_of(TASKS[task])


@pytest.mark.evidence
def test_what_the_tasks_write_is_what_they_say(folder: Path) -> None:
    assert len(Log.load(folder / "mine.parquet")) == len(Log.load(folder / "twin.parquet"))
    assert json.loads((folder / "lqg.json").read_text())["controller"]["kind"] == "lqg"
    assert (folder / "run.gif").read_bytes().startswith(b"GIF8")
    assert re.findall(r",(ok|not reached|differs),", (folder / "grades.csv").read_text()) == [
        "ok", "differs", "not reached",
    ]  # fmt: skip


def test_a_fleet_is_pushed_and_a_log_has_all_its_pushes() -> None:
    """Without a push a fleet tests nothing; the example `pushed` has two."""
    from upright.experiment.examples import EXAMPLES

    assert all("--push" in line for line in lines_of("fleet"))
    (own,) = lines_of("reproduce --log pushed.csv")
    given = [notation.push(text) for text in re.findall(r"--push[ =](\S+)", own)]
    assert given == list(EXAMPLES["pushed"].pushes)


def test_the_site_is_the_exported_lab(exported_lab: Path) -> None:
    """Made once for all tests of it."""
    assert lines_of("lab --export")
    assert "uprightExport" in exported_lab.read_text("utf-8")


@pytest.mark.evidence
@pytest.mark.needs("module:nbclient", "module:ipykernel")
def test_the_notebook_runs_and_shows_the_lab(folder: Path) -> None:
    import nbformat
    from nbclient import NotebookClient

    notebook: Any = nbformat.read(folder / "notebook.ipynb", as_version=4)
    nbformat.validate(notebook)
    NotebookClient(notebook, timeout=PATIENCE, resources={"metadata": {"path": folder}}).execute()
    shown = [
        out["data"].get("text/html", "") for cell in notebook.cells for out in cell.get("outputs", ()) if "data" in out
    ]
    assert any('<iframe src="lab/index.html#robot=nxtway-gs' in text for text in shown)
    assert len(nbformat.writes(notebook)) < 500_000  # with its figures: the page itself is a file beside it
    assert "uprightExport" in (folder / "lab" / "index.html").read_text("utf-8")
