"""`import upright as up`: the verbs and nouns that users meet, whatever was imported before."""

from __future__ import annotations

import ast
import inspect
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

import upright as up
from conftest import PATIENCE

VERBS = ("doctor", "calibrate", "identify", "excite", "certify", "post_mortem", "design", "fleet", "push_map", "parity",
         "reproduce", "report", "simulate")  # fmt: skip


def executed(code: str) -> str:
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False, timeout=PATIENCE)
    assert done.returncode == 0, done.stderr
    return done.stdout.strip()


def test_every_name_is_there_and_listed() -> None:
    assert {"Robot", "Log", "run", "lqr", *VERBS} <= set(up.__all__)
    assert all(getattr(up, name) is not None for name in up.__all__)
    assert set(up.__all__) <= set(dir(up))
    with pytest.raises(AttributeError, match="nothing_of_this_name"):
        _ = up.nothing_of_this_name


def test_the_stub_re_exports_every_name_as_type_checkers_ask() -> None:
    tree = ast.parse(Path(up.__file__).with_suffix(".pyi").read_text("utf-8"))
    names = [alias for node in tree.body if isinstance(node, ast.ImportFrom) for alias in node.names]
    assert all(alias.asname == alias.name for alias in names)
    assert sorted(alias.name for alias in names) == sorted(up.__all__)


@pytest.mark.parametrize("verb", VERBS)
def test_a_verb_is_a_documented_function(verb: str) -> None:
    function = getattr(up, verb)
    assert inspect.isfunction(function)
    assert function.__name__ == verb
    assert inspect.getdoc(function)


def test_no_verb_is_also_a_room() -> None:
    """`up.doctor` would be a function or a module after the order of imports."""
    rooms = {path.stem for path in Path(up.__file__).parent.iterdir() if path.suffix in ("", ".py")}
    assert len(rooms) > 30  # they were found
    assert rooms & set(up.__all__) == set()


def test_a_notebook_asks_with_names_and_reads_a_short_answer() -> None:
    designed = up.design("lqr", "nxtway-gs")
    assert designed.controller.spec.period == up.Kit.preset("nxt").period
    assert "stable" in str(designed) or "gain" in str(designed)
    assert repr(designed).startswith("<Designed: stable")
    fleet = up.fleet("nxtway-gs", 8, controller="lqr", kit="ideal", seconds=0.5, vary=["com_height=±10%"])
    assert fleet.data.sizes["robot"] == 8
    assert fleet.summary.fell == 0  # the regulator of the true state holds a robot that nobody pushes
    assert "0 of 8 runs" in fleet._repr_html_()


def test_robot_and_model_are_short_at_a_prompt_and_tables_in_a_notebook() -> None:
    robot = up.Robot.preset("nxtway-gs")
    # Yamamoto (2008): 0.6 kg and two wheels of 0.03 kg, the centre of mass at 0.072 m
    assert repr(robot) == "Robot('nxtway-gs': 0.66 kg, centre of mass 0.072 m above the axle)"
    assert '<td>wheel_radius</td><td class="number">0.04</td><td>m</td>' in robot._repr_html_()
    model = up.linearise(robot)
    assert repr(model) == "LinearModel(6 states, 2 inputs, 6 outputs, continuous)"
    assert f"{model.poles()[0].real:.3g}\u00a01/s" in str(model.page().numbers[0].value)


def test_the_citation_names_the_version_that_is_built() -> None:
    root = Path(__file__).parents[1]
    built = tomllib.loads((root / "pyproject.toml").read_text("utf-8"))["project"]
    cited = dict(re.findall(r"^(\w[\w-]*): (.+)$", (root / "CITATION.cff").read_text("utf-8"), re.MULTILINE))
    assert (cited["version"], cited["license"]) == (built["version"], built["license"])
