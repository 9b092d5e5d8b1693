"""What a plain installation lacks is asked for in one line, and nothing else needs it."""

from __future__ import annotations

import importlib
import re
import sys
import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import upright as up
from upright.cli.main import main
from upright.control import CONTROLLERS
from upright.errors import EXTRAS, MissingTool
from upright.physics.linear import LinearModel
from upright.signals import Log
from upright.signals.signal import SIDES, TRUE_STATE

CHECKOUT = Path(__file__).parents[1]


@pytest.fixture
def hidden(monkeypatch: pytest.MonkeyPatch) -> Callable[[str], None]:
    """Hides an installed module: Python then says that there is none of that name."""
    return lambda module: monkeypatch.setitem(sys.modules, module, None)  # type: ignore[arg-type]


COMMANDS = {
    "cvxpy": ("design robust", "design robust needs cvxpy: pip install 'upright[robust]'"),
    "cma": ("tune lqr --robot nxtway-gs", "upright tune needs cma: pip install 'upright[tune]'"),
    "mcap": ("simulate -o run.mcap", "a log as .mcap needs mcap: pip install 'upright[mcap]'"),
    "zarr": ("fleet -n 5 -o fleet.zarr", "a result as .zarr needs zarr: pip install 'upright[zarr]'"),
    "distributed": (
        "sweep campaign.toml --cluster tcp://127.0.0.1:1",
        "--cluster needs distributed: pip install 'upright[cluster]'",
    ),
    "imageio_ffmpeg": ("film run.csv -o run.mp4", "a film as .mp4 needs imageio_ffmpeg: pip install 'upright[film]'"),
}


@pytest.mark.parametrize("module", COMMANDS)
def test_a_command_without_its_extra_is_one_line(
    module: str,
    hidden: Callable[[str], None],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    command, says = COMMANDS[module]
    Path("campaign.toml").write_text("n = 20\nseconds = 1.0\n")
    if "run.csv" in command:
        assert main(["simulate", "--robot", "herrera2015", "--seconds", "0.2", "-o", "run.csv"]) == 0
        capsys.readouterr()
    before = sorted(tmp_path.iterdir())
    hidden(module)
    assert main(command.split()) == 2
    out, err = capsys.readouterr()
    assert (out, err.splitlines()) == ("", [f"upright: {says}"])
    assert sorted(tmp_path.iterdir()) == before


def test_a_log_of_mcap_that_cannot_be_read_is_one_line(
    hidden: Callable[[str], None], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "run.mcap").write_bytes(b"any")
    hidden("mcap")
    assert main(["doctor", str(tmp_path / "run.mcap")]) == 2
    assert capsys.readouterr().err == "upright: a log as .mcap needs mcap: pip install 'upright[mcap]'\n"


def test_hardware_and_converters_without_their_extra_say_what_to_install(hidden: Callable[[str], None]) -> None:
    from upright.links.brick import Connection
    from upright.links.hub import _hub_at

    asking = {
        "nxt": (lambda: Connection("usb"), "an NXT needs nxt: pip install 'upright[nxt]'"),
        "pybricksdev": (lambda: _hub_at("ble").send(None), "a Pybricks hub needs pybricksdev: pip install "),
        "control": (
            lambda: LinearModel.from_control(None),
            "from_control needs control: pip install 'upright[control]'",
        ),
    }
    for module, (ask, says) in asking.items():
        hidden(module)
        with pytest.raises(MissingTool, match=re.escape(says)):
            ask()
    with pytest.raises(MissingTool, match="to_control needs control"):
        up.linearise("nxtway-gs").to_control()


def test_the_environment_without_gymnasium_says_what_to_install(
    hidden: Callable[[str], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    hidden("gymnasium")
    monkeypatch.delitem(sys.modules, "upright.gym", raising=False)
    with pytest.raises(MissingTool, match=re.escape("upright.gym needs gymnasium: pip install 'upright[gym]'")):
        importlib.import_module("upright.gym")


def test_the_bench_and_the_lab_leave_out_what_needs_an_extra(
    hidden: Callable[[str], None], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    from upright.comparison import bench
    from upright.lab.plant import families

    hidden("cvxpy")
    assert "robust" not in [family.name for family in families()]

    t = np.arange(0.0, 5.0, 0.01)
    channels = [*TRUE_STATE, *(f"{kind}/{side}" for kind in ("command", "applied") for side in SIDES)]
    log = Log(t, dict.fromkeys(channels, 0.1 * np.exp(-t)))

    def not_tried(method: str, side: str, *_: object, **__: object) -> tuple[object, object]:
        return bench.BenchRow(controller=method, push=side, outcome="yes"), log

    monkeypatch.setattr(bench, "bench_one", not_tried)
    made = bench.bench_controllers("nxtway-gs")
    assert {row.controller for row in made.rows} == {n for n, m in CONTROLLERS.items() if m.benched} - {"robust"}
    assert made.to_json()["left_out"] == COMMANDS["cvxpy"][1]
    capsys.readouterr()
    assert main(["bench-controllers"]) == 0
    words = " ".join(capsys.readouterr().out.split())
    assert f"Left out: {COMMANDS['cvxpy'][1]}" in words
    assert {row.controller for row in bench.bench_controllers("nxtway-gs", methods=["robust"]).rows} == {"robust"}


def test_every_module_that_may_be_missing_is_in_the_extra_of_its_name() -> None:
    """And a plain installation brings none of them."""
    packages = {"imageio_ffmpeg": "imageio-ffmpeg", "nxt": "nxt-python"}
    project = tomllib.loads((CHECKOUT / "pyproject.toml").read_text("utf-8"))["project"]

    def names(lines: list[str]) -> set[str]:
        return {re.split("[>=<]", line)[0] for line in lines}

    for module, extra in EXTRAS.items():
        package = packages.get(module, module)
        assert package in names(project["optional-dependencies"][extra])
        assert package not in names(project["dependencies"])
    (everything,) = project["optional-dependencies"]["all"]
    assert set(re.findall(r"[a-z]+", everything)) == {"upright", *EXTRAS.values()}
    assert "upright[all,docs]" in project["optional-dependencies"]["test"]


def test_what_a_plain_installation_brings_designs_and_flies_without_any_extra(
    hidden: Callable[[str], None], tmp_path: Path
) -> None:
    for module in EXTRAS:
        hidden(module)
    run = ["simulate", "--robot", "nxtway-gs", "--controller", "lqg", "--seconds", "0.5"]
    assert main([*run, "-o", str(tmp_path / "run.parquet")]) == 0
