"""What comes from outside the package is the equal of ours: files, entry points, and what is registered at run time."""

import importlib.metadata
import re
from pathlib import Path

import pytest

from upright.bodies import BODIES, Electronics, make_body
from upright.cli.main import main
from upright.comparison.bench import BenchRow, bench_controllers
from upright.control import CONTROLLERS, Controller, Method, find_controller, make_controller
from upright.control.law import as_law
from upright.errors import InvalidController, InvalidPlugin, UnknownName
from upright.experiment import run
from upright.plugins import Registry
from upright.robots import Kit, Robot

NXT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")

ROD = '''
"""A controller and a body of somebody else's."""
from upright.bodies import NonlinearBody
from upright.control import Method, lqg

class Rod:
    """LQG by another name, with the whole contract."""
    def __init__(self, robot, kit, dt):
        self._inner = lqg(robot, kit, dt)
        self.spec = self._inner.spec
    def reset(self): self._inner.reset()
    def step(self, measurement, reference): return self._inner.step(measurement, reference)
    def estimate(self): return self._inner.estimate()
    def applied(self, command): self._inner.applied(command)
    def to_json(self): return {"kind": "rod"}

class Half:
    def __init__(self, robot, kit, dt):
        self.spec = None
    def reset(self): ...

def broken(robot, kit, dt):
    return 1 / 0

def weighed(robot, kit, dt, *, largest, command):
    return lqg(robot, kit, dt)

weighted = Method(make=weighed, weighted=True, benched=False)

class Cart(NonlinearBody):
    """The package's own model under another name."""
'''


@pytest.fixture
def rod(tmp_path):
    path = tmp_path / "rod.py"
    path.write_text(ROD, encoding="utf-8")
    return path


@pytest.fixture
def installed(rod, monkeypatch):
    """As if a package with these entry points were installed."""
    groups = {
        "upright.controllers": {"rod": "rod:Rod", "gone": "rod_of_nobody:Rod", "lqr": "rod:broken"},
        "upright.bodies": {"cart": "rod:Cart"},
    }
    points = {
        group: [importlib.metadata.EntryPoint(name, value, group) for name, value in names.items()]
        for group, names in groups.items()
    }
    monkeypatch.syspath_prepend(str(rod.parent))
    monkeypatch.setattr("upright.plugins.metadata.entry_points", lambda group: points[group])


def test_a_class_in_a_file_is_a_controller_and_a_body(rod):
    controller, body = find_controller(f"{rod}:Rod", NXT, KIT, 0.01), make_body(f"{rod}:Cart", NXT)
    assert isinstance(controller, Controller)
    log = run(Electronics(body, KIT), controller, seconds=1.0, start=(0.02, 0, 0, 0, 0, 0))
    assert not log.origin["outcome"]["fell"]
    assert log.origin["controller"]["kind"] == "rod"


def test_the_documented_controller_is_found_and_balances(tmp_path):
    page = Path(__file__).parents[1] / "docs" / "extend.md"
    block = re.findall(r"```python\n(.*?)```", page.read_text(encoding="utf-8"), re.DOTALL)[0]
    (tmp_path / "my.py").write_text(block, encoding="utf-8")
    for name in ("Quiet", "quiet"):
        controller = find_controller(f"{tmp_path}/my.py:{name}", NXT, KIT, 0.01)
        log = run(Electronics(make_body("nonlinear", NXT), KIT), controller, seconds=3.0, start=(0.05, 0, 0, 0, 0, 0))
        assert not log.origin["outcome"]["fell"]
        assert controller.spec.kind == "quiet"  # and not the lqg inside
        with pytest.raises(InvalidController, match=r"a Quiet is no fixed sum.*try: upright simulate, certify"):
            as_law(controller)  # which fleets are compiled from


def test_an_installed_package_is_found_by_name_and_listed(installed):
    assert {"rod", "gone", "lqg"} <= set(CONTROLLERS)
    assert "rod" in CONTROLLERS
    assert len(CONTROLLERS) == len(list(CONTROLLERS))
    assert make_controller("rod", NXT, KIT, 0.01).to_json() == {"kind": "rod"}
    assert list(BODIES)[-1] == "cart"
    assert make_body("cart", NXT).spec.kind == "complete nonlinear model"
    assert CONTROLLERS["lqr"].weighted  # ours counts where a package takes a name of ours
    with pytest.raises(UnknownName, match="rod"):
        make_controller("rood", NXT, KIT, 0.01)


def test_the_bench_takes_what_is_registered(monkeypatch):
    # a registry of one plug-in and one of ours: rows for both, none for what asks not to be benched
    own = {name: CONTROLLERS[name] for name in ("lqg", "lqr-state")}
    registry = Registry("controller", "upright.none", own, lambda name, make: Method(name=name, make=make))
    registry.register("mine", lambda robot, kit, dt: make_controller("lqg", robot, kit, dt))
    monkeypatch.setattr("upright.comparison.bench.CONTROLLERS", registry)
    benched = []

    def noted(method, side, *_, **__):
        benched.append(method)
        return BenchRow(controller=method, push=side, outcome="yes"), True

    monkeypatch.setattr("upright.comparison.bench.bench_one", noted)
    bench_controllers(NXT, KIT, "nonlinear", knocks=False)
    assert benched == ["lqg", "lqg", "mine", "mine"]


@pytest.mark.parametrize("methods", [["pid"], ["none.py:Half"], ["none.py:Half", "pid"]])
def test_a_bench_where_nothing_has_a_design_says_why_in_a_line(methods, tmp_path, monkeypatch, capsys):
    """A PID commands no speed, and half a plug-in nothing: a table without a run has no figure to show."""
    (tmp_path / "none.py").write_text(ROD, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    assert main(["bench-controllers", "-r", "stepper", *methods]) == 2
    error = capsys.readouterr().err
    assert error.startswith("upright: nothing to compare for stepper: ")
    assert all(f"{name}: no design: " in error for name in methods)


def test_the_bench_compares_a_file_and_refuses_a_name_that_there_is_not(rod):
    bench = bench_controllers(NXT, KIT, "nonlinear", methods=[f"{rod}:Rod"], knocks=False)
    assert [(row.controller, row.holds) for row in bench.rows] == [(f"{rod}:Rod", True)] * 2
    with pytest.raises(UnknownName, match="lgq"):
        bench_controllers(NXT, KIT, "nonlinear", methods=["lgq"])
    with pytest.raises(InvalidPlugin, match="no Nobody"):
        bench_controllers(NXT, KIT, "nonlinear", methods=[f"{rod}:Nobody"])


def test_registering_a_name_twice_is_refused():
    with pytest.raises(InvalidPlugin, match="'lqg' already"):
        CONTROLLERS.register("lqg", lambda robot, kit, dt: None)


def test_weights_go_to_the_methods_that_take_them(rod):
    mild = CONTROLLERS["lqg"](NXT, KIT, 0.01, largest=(0.3, 1.5, 4.0, 15.0, 0.5, 3.0), command=2.0)
    assert mild.to_json() != make_controller("lqg", NXT, KIT, 0.01).to_json()
    assert CONTROLLERS[f"{rod}:weighted"](NXT, KIT, 0.01, command=2.0).spec.kind == "lqg"
    for name in ("pid", f"{rod}:Rod"):
        with pytest.raises(InvalidController, match="takes no weights"):
            CONTROLLERS[name](NXT, KIT, 0.01, command=2.0)
    with pytest.raises(InvalidController, match="expected six"):
        CONTROLLERS["lqg"](NXT, KIT, 0.01, largest=(1.0,))


@pytest.mark.parametrize(
    ("place", "why"),
    [
        ("{rod}:Stick", r"has no Stick; expected .*one of Rod, Half, broken, weighed, Cart"),
        ("{rod}", "without a name"),
        ("{rod}x.py:Rod", "there is no file"),
        ("{rod}:broken", r"rod.py line 23: ZeroDivisionError"),
        ("{rod}:Half", r"Half without applied, estimate, step, to_json; expected an object like Controller"),
        ("{syntax}:Rod", "SyntaxError"),
        ("gone", r"'gone' \(rod_of_nobody:Rod\) gives an error: .*ModuleNotFoundError"),
    ],
)
def test_what_is_wrong_with_a_plugin_is_reported_in_one_line(place, why, rod, installed):
    syntax = Path(rod.parent / "syntax.py")
    syntax.write_text("class Rod(:\n", encoding="utf-8")
    with pytest.raises(InvalidPlugin, match=why) as caught:
        find_controller(place.format(rod=rod, syntax=syntax), NXT, KIT, 0.01)
    assert "\n" not in str(caught.value)


def test_a_body_that_is_none_is_refused(rod):
    with pytest.raises(InvalidPlugin, match="gives an error: TypeError"):
        make_body(f"{rod}:Rod", NXT)
    empty = rod.with_name("empty.py")
    empty.write_text("class Nothing:\n    def __init__(self, robot): ...\n", encoding="utf-8")
    with pytest.raises(InvalidPlugin, match=r"Nothing without close, reset, spec, step; expected an object like Body"):
        make_body(f"{empty}:Nothing", NXT)
