"""The scripts in `examples/` run as a reader finds them, in a folder of their own, and print their result."""

from __future__ import annotations

import re
import runpy
from pathlib import Path

import matplotlib as mpl
import pytest

FOLDER = Path(__file__).parents[1] / "examples"
SCRIPTS = sorted(FOLDER.glob("*.py"))

SAYS = {
    "calibrate": r"9\d ms +until a lean has doubled(.|\n)*gyro +0\.9\d+ +yes",
    "certify": r"Green: at most(.|\n)*The controller lqg may drive nxtway-gs",
    "compare": r"\nIn pitch, all runs follow “twin”\n(.|\n)*twin +no .*\nnonlinear +no .*\nlinear +no ",
    "firmware": r"duty_left = whole.* in \[-100, 100\](.|\n)*left.duty_cycle_sp = duty_left",
    "identify": r"least-squares.*bias -[1-9](.|\n)*subspace: 7\.\d+ to 7\.\d+ 1/s",
    "own_controller": r"\nIn pitch, (.|\n)*\nlqr \(twin\) +no .*\nhand-made \(twin\) +no ",
    "own_robot": r"nxtway-gs: a fall grows e-fold in 134 ms",
    "push_limits": r"lqg: 0\.[123]\d N s",
    "python_control": r"7\.437",
    "read_log": r"wrong sign +gyro(.|\n)*another unit +encoders",
    "simulate": r"largest lean 0\.0\d+ rad",
    "tune": r"for nxtway-gs(.|\n)*\d+ mm of travel instead of \d+ mm",
    "sweep": r"fell in \d+ of 10000 runs",
}
"""What each one must print. The pole of nxtway-gs, 7.437 1/s, and e-fold in 1/7.437 s are its linear model's
(docs/model.md), so a lean doubles in ln 2/7.437 s, 93 ms; an identified pole lies between 7 and 8; least squares in
closed loop misses it by more than 1 1/s (docs/identify.md)."""


def test_the_table_lists_every_script() -> None:
    listed = re.findall(r"\[(\w+)\.py\]\(\1\.py\)", (FOLDER / "README.md").read_text("utf-8"))
    assert sorted(listed) == [path.stem for path in SCRIPTS] == sorted(SAYS)


@pytest.mark.parametrize("path", SCRIPTS, ids=lambda path: path.stem)
def test_a_script_is_short_enough_to_be_read_at_once(path: Path) -> None:
    assert 15 <= len(path.read_text("utf-8").splitlines()) <= 45


LONG = {"tune", "certify", "push_limits", "sweep", "calibrate"}
"""What tries hundreds of robots, pushes a robot again and again, or fits all its parameters."""


@pytest.mark.parametrize(
    "path",
    [pytest.param(path, marks=pytest.mark.evidence if path.stem in LONG else ()) for path in SCRIPTS],
    ids=lambda path: path.stem,
)
def test_a_script_runs_and_says_its_result(
    path: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    with mpl.rc_context({"backend": "agg"}):
        runpy.run_path(str(path), run_name="__main__")
    assert re.search(SAYS[path.stem], capsys.readouterr().out)
