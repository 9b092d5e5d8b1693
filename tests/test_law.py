"""What the kernel runs of a controller is what the printed C computes, and what `run` does with the controller."""

from __future__ import annotations

import ctypes
import math
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from firmware_cases import designed
from upright.arrays import Array
from upright.bodies import Electronics, NonlinearBody
from upright.compiled.generated import LANES, LEFT, RIGHT, ROW
from upright.compiled.print_c import CPrinter
from upright.compiled.program import Kind, Program
from upright.control import Estimated, StateFeedback, kalman, lqr_state
from upright.control.law import as_law, near_rest, program
from upright.control.linear_controller import Law, LinearController
from upright.errors import InvalidController
from upright.experiment import Drive, Push, run
from upright.kernel import functions as kernel_functions
from upright.kernel import store
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.rows import COMMAND, FIXED, REFERENCE
from upright.kernel.simulate import simulate
from upright.robots import Kit, Motor, Robot
from upright.signals import STATE_NAMES

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
START = (0.05, 0.0, 0.1, 0.0, 0.2, 0.0)
NAMES = ("lqr", "lqi", "lqg", "pid", "hinf", "sliding", "mpc")
EQUAL = 1e-9  # as in test_fleet_kernel

PERIODS = 40


def quiet(quantised: bool) -> Kit:
    """The kit without what is random, and unless `quantised` without steps of a quantum."""
    still = {n: replace(s, noise=0.0, bias=0.0, bias_walk=0.0) for n, s in KIT.sensors.items()}
    smooth = {n: replace(s, quantum=0.0) for n, s in still.items()}
    return replace(KIT, sensors=still if quantised else smooth, jitter=0.0, motor=KIT.motor if quantised else Motor())


def c_of(number: int, text: Program) -> str:
    """A function in C: states and inputs in, outputs out, the printed statements between."""
    c = CPrinter(text, "double")
    held = {"in": Kind.INPUT, "s": Kind.STATE, "out": Kind.OUTPUT}
    lines = [f"struct {n}{number} {{ {' '.join(c.fields(kind))} char none; }};" for n, kind in held.items()]
    for block in (text.command, text.update):
        given = f"struct s{number} *s, const struct in{number} *in, struct out{number} *out"
        lines += [f"void {block.name}{number}({given})", "{", *c.lines(block), "}"]
    return "\n".join(lines)


@pytest.mark.needs("gcc")
def test_every_law_in_the_kernel_is_the_printed_c_to_the_bit(tmp_path: Path) -> None:
    texts = [program(as_law(designed(name))) for name in NAMES]
    parts = [c_of(i, text) for i, text in enumerate(texts)]
    source = tmp_path / "laws.c"
    source.write_text("\n".join([CPrinter(texts[0], "double").helpers(), *parts]), "utf-8")
    # a product and a sum contracted into one would be rounded once
    command = ["gcc", "-O1", "-ffp-contract=off", "-shared", "-fPIC", str(source), "-o", str(tmp_path / "laws.so")]
    subprocess.run(command, check=True)
    library = ctypes.CDLL(str(tmp_path / "laws.so"))
    for i, (name, text) in enumerate(zip(NAMES, texts, strict=True)):
        assert np.array_equal(by_c(library, i, text), by_kernel(name)), name


def readings(k: int, size: int) -> np.ndarray:
    return np.random.default_rng(k).normal(0, 0.3, size)


def by_c(library: Any, number: int, text: Program) -> np.ndarray:
    """The commands (PERIODS, 2) to random inputs."""
    inputs, outputs = text.of(Kind.INPUT), [v.name for v in text.of(Kind.OUTPUT)]
    out, sides = (ctypes.c_double * len(outputs))(), [outputs.index(f"command_{side}") for side in ("left", "right")]
    state = (ctypes.c_double * (len(text.of(Kind.STATE)) + len(text.carried()) + 1))()
    commands = []
    for k in range(PERIODS):
        given = (ctypes.c_double * len(inputs))(*readings(k, len(inputs)))
        for function in (library[f"command{number}"], library[f"update{number}"]):
            function(state, given, out)
        commands.append([out[i] for i in sides])
    return np.array(commands)


def by_kernel(name: str) -> np.ndarray:
    law = as_law(designed(name))
    compiled, m = kernel_functions.compiled(law, 6), len(law.linear.reads)
    raw = np.zeros((FIXED + compiled.rows) * ROW + 8)
    w = raw[(-raw.ctypes.data % 64) // 8 :][: (FIXED + compiled.rows) * ROW].reshape(-1, ROW)
    places = [*range(FIXED, FIXED + m), *range(REFERENCE, REFERENCE + 6), LEFT, RIGHT]
    table, commands = np.array(compiled.constants), []
    for k in range(PERIODS):
        w[places, :LANES] = readings(k, len(places))[:, None]
        arguments = [w.ctypes.data, LANES, FIXED, table.ctypes.data]
        store.call(compiled.command, arguments)
        if compiled.update:
            store.call(compiled.update, arguments)
        assert (w[COMMAND : COMMAND + 2, :LANES] == w[COMMAND : COMMAND + 2, :1]).all()
        commands.append(w[COMMAND : COMMAND + 2, 5].tolist())
    return np.array(commands)


@pytest.mark.parametrize("name", ["lqg", "sliding", "mpc"])
@pytest.mark.parametrize(("quantised", "seconds"), [(False, 10.0), (True, 2.0)])
def test_the_kernel_does_what_run_does(name: str, quantised: bool, seconds: float) -> None:
    controller, kit = designed(name), quiet(quantised)
    push, arc = Push(force=1.5, start=0.5), Drive(speed=0.1, start=1.0)
    log = run(Electronics(NonlinearBody(ROBOT), kit), controller, push, reference=arc, start=START, seconds=seconds)
    names = ("truth/pitch", "truth/wheel", "command/left", "applied/right")
    batch = FleetBatch(
        parameters=parameters_of(ROBOT), controller=controller, start=START, kit=kit,
        pushes=[[1.5, math.nan, 0.5, 0.1]], reference=[[0.1, 0.0, 1.0, math.inf]],
    )  # fmt: skip
    result = simulate(batch, seconds, record=1, channels=names)
    assert not result.fell[0]
    for k, channel in enumerate(result.channels):
        assert np.abs(log[channel] - result.trace[0, : len(log), k]).max() < EQUAL, channel


def test_a_sliding_mode_is_the_same_bits_in_any_company() -> None:
    parameters = parameters_of(ROBOT, {"com_height": np.linspace(0.06, 0.08, 150)})
    batch = FleetBatch(parameters=parameters, controller=designed("sliding"), start=START, kit=KIT, seed=3)
    whole = simulate(batch, 0.5, threads=2)
    some = simulate(batch.part(np.array([140, 7, 99])), 0.5, threads=1)
    assert np.array_equal(whole.final[[140, 7, 99]], some.final)


def test_alike_laws_have_one_text_on_disk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    store._functions_of.cache_clear()
    kernel_functions.compiled.cache_clear()
    one, two = (as_law(lqr_state(ROBOT, 0.01, R=[r, r])) for r in (1.0, 2.0))
    first = kernel_functions.compiled(one, 0)
    (path,) = tmp_path.iterdir()
    whole = path.read_bytes()
    second = kernel_functions.compiled(two, 0)
    assert (first.command, first.update) == (second.command, second.update)
    assert not np.array_equal(first.constants, second.constants)
    damaged = bytearray(whole)
    damaged[len(whole) // 2] ^= 1
    path.write_bytes(damaged)
    store._functions_of.cache_clear()
    kernel_functions.compiled.cache_clear()
    kernel_functions.compiled(one, 0)
    assert path.read_bytes() == whole  # made anew


def test_what_no_law_describes_is_called() -> None:
    own = designed("lqr-complementary")
    assert FleetBatch(parameters=parameters_of(ROBOT), controller=own).called is own


class Careful(StateFeedback):
    """Somebody's own, which commands nothing while little is asked for: no longer the law of its parent."""

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        left, right = super().step(measurement, reference)
        return (left, right) if abs(left) > 1 else (0.0, 0.0)


def test_a_step_of_its_own_takes_the_law_from_a_child() -> None:
    own = Careful(lqr_state(ROBOT, 0.01).gain, 0.01)
    assert FleetBatch(parameters=parameters_of(ROBOT), controller=own).called is own
    for says in (as_law, near_rest):
        with pytest.raises(InvalidController):
            says(own)
        with pytest.raises(InvalidController):
            says(Estimated(own, kalman(ROBOT, KIT, 0.01)))


def test_a_static_law_remembers_nothing() -> None:
    assert kernel_functions.compiled(as_law(lqr_state(ROBOT, 0.01)), 0).update == 0


def test_a_law_that_grows_without_its_robot_is_run() -> None:
    n = len(STATE_NAMES)
    runaway = LinearController(
        np.array([[2.0]]), np.ones((1, n)), np.zeros((1, 6)), np.zeros((1, 2)), np.zeros((2, 1)),
        -lqr_state(ROBOT, 0.01).gain, np.zeros((2, 6)), reads=tuple(f"truth/{s}" for s in STATE_NAMES), period=0.01,
    )  # fmt: skip
    result = simulate(FleetBatch(parameters=parameters_of(ROBOT), controller=runaway, start=START), 2.0)
    assert not result.fell[0]


class Own:
    """A controller of somebody else's that says what it computes."""

    def __init__(self) -> None:
        self.inner = designed("sliding")
        self.spec = self.inner.spec

    def law(self) -> Law:
        return as_law(self.inner)

    def linearised(self) -> LinearController:
        return self.law().linearised()


def test_who_says_its_law_is_taken_like_one_of_ours() -> None:
    own: Any = Own()
    assert as_law(own) == as_law(own.inner)
    assert pytest.approx(near_rest(own.inner).A) == near_rest(own).A
    own.law = "no method"
    with pytest.raises(InvalidController, match="no fixed sum"):
        as_law(own)
