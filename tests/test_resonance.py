"""A gyro that swings or is filtered: its two states are those of SciPy, and a calibration finds it where it is."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.signal import lsim

from test_predictor import LONGEST, ROBOT, SIZE, SMALL, START, C, R, process, uneven_log
from upright.bodies import Electronics
from upright.bodies.body import REST, Sample
from upright.bodies.models import NonlinearBody
from upright.calibration.calibrate import calibrate, prepared
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import PRIOR, VISIBLE, Estimate
from upright.calibration.fitting import objective
from upright.calibration.motion import block_of, move, njit
from upright.calibration.own_run import of_this_run
from upright.calibration.predictor import WIDE, Noise, RobotLanes, innovations, kalman_path
from upright.calibration.resonance import DAMPING, FREQUENCY, TYPICAL, in_words, resonates
from upright.calibration.resonant import _starts
from upright.calibration.ringing import moved, rung
from upright.calibration.sought import values_of
from upright.calibration.summary import COMBINATIONS
from upright.compiled.generated import PITCH_RATE, ROW, constants
from upright.control import make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import InvalidRobot
from upright.experiment import run
from upright.physics.dynamics import CALM, Disturbance
from upright.physics.linear import linearise
from upright.robots import Kit, Robot, Sensor, find_kit
from upright.signals import Log

SWING = ("ev3way", 11.0, 0.05)  # [Hz, 1]
FILTER = ("nxtway-gs", 25.0, 0.7)
SEED = 4  # every twentieth leaves a true number out of its interval of 95 %
DITHER = {"ev3way": 2.5, "nxtway-gs": 1.5}  # [V]
SPAN = 0.01  # [s]


@njit
def after(g: Any, p: Any, first: Any, last: Any, mean: Any, phase: Any, damping: Any) -> Any:
    """`rung`, which is put into its callers, as a function of its own."""
    return rung(g, p, first, last, mean, phase, damping)


@pytest.mark.parametrize("damping", [0.03, 0.7, 1.0, 1.6])
@pytest.mark.parametrize("phase", [-0.3, 0.01, 0.5, 3.0, 30.0])
def test_under_a_parabola_the_two_states_are_exact(phase: float, damping: float) -> None:
    """Against SciPy's adaptive integration: the power series ends at a part in 10¹⁰, and that of SciPy is asked for as
    much; a log's spans have phases below 3, one of −0.3 is that of a delay's nudge."""
    first, last, mean = 0.3, -0.5, 0.4
    bend = 6 * mean - 3 * (first + last)

    def slope(s: float, v: np.ndarray) -> list[float]:
        rate = first + (last - first + bend) * s - bend * s**2
        return [phase * v[1], phase * (rate - v[0] - 2 * damping * v[1])]

    right = solve_ivp(slope, (0, 1), [0.2, -0.1], rtol=1e-11, atol=1e-12, method="DOP853").y[:, -1]
    assert after(0.2, -0.1, first, last, mean, phase, damping) == pytest.approx(right, abs=1e-8)


@pytest.mark.parametrize(("frequency", "damping"), [(11.0, 0.05), (25.0, 0.7)])
def test_along_a_motion_they_are_those_of_the_transfer_function(frequency: float, damping: float) -> None:
    """Uneven spans of 2 to 8 ms, against `scipy.signal.lsim` in steps of 10 µs: the parabola is wrong by (2π f h)³/200
    of what moves at f, 1e-3 at 7 Hz and 8 ms, and SciPy's straight lines by 1e-6."""
    fine = 1e-5 * np.arange(60_001)
    pitch = 0.1 * np.sin(2 * np.pi * 2 * fine) / (4 * np.pi) + 0.05 * np.sin(2 * np.pi * 7 * fine + 1) / (14 * np.pi)
    rate = 0.1 * np.cos(2 * np.pi * 2 * fine) + 0.05 * np.cos(2 * np.pi * 7 * fine + 1)
    omega = 2 * np.pi * frequency
    read = lsim(([omega**2], [1, 2 * damping * omega, omega**2]), rate, fine)[1]
    rows = np.cumsum(np.random.default_rng(1).integers(200, 800, 300))
    at = np.concatenate([[0], rows[rows < len(fine)]])
    state, states = (0.0, 0.0), [0.0]
    for i, j in pairwise(at):
        h = fine[j] - fine[i]
        state = after(*state, rate[i], rate[j], (pitch[j] - pitch[i]) / h, omega * h, damping)
        states.append(state[0])
    assert np.abs(np.array(states) - read[at]).max() < 1e-3 * np.abs(read).max()


def test_on_small_motions_the_filter_is_a_textbook_one_of_nine_states() -> None:
    """As in `test_predictor`, with both states of the resonance in the linear model: Φ is its exponential. In steps of
    0.2 ms the parabola is off by a part in 10⁹ of what a pole of 15/s does; what both routes differ by adds up."""
    robot = Robot.preset("ev3way-large-wheels").replace(coulomb_friction=0.0)
    half = robot.track / (2 * robot.wheel_radius)
    omega, damping, size = 2 * np.pi * 11.0, 0.05, SIZE + 2
    model = linearise(robot)
    A = np.zeros((size, size))
    A[:6, :6], A[7, 8] = model.A, omega
    A[8, [1, 7, 8]] = omega, -omega, -2 * damping * omega
    B = np.vstack([model.B, np.zeros((size - 6, 2))])
    reads, Q, start = np.zeros((3, size)), np.zeros((size, size)), np.zeros((size, size))
    reads[:, :SIZE], Q[:SIZE, :SIZE], start[:SIZE, :SIZE] = C, process(), START
    reads[:2, 4], reads[2, [1, 7]] = (-half, half), (0, 1)
    start[7, 7] = start[8, 8] = 1e-2
    delays, events = np.array([0.0, 0.0, 0.0035]), uneven_log()
    then = events.when - np.append(delays, 0.0)[events.kind]
    events = events._replace(order=np.lexsort((events.kind, then)))
    numbers = np.array([*constants(list(robot.numbers().values()), 1.0), 1.0, 1.0, 0.0, 0.0, 0.0])
    lanes = RobotLanes(
        *(np.repeat(a[..., None], WIDE, axis=-1) for a in (reads, delays, numbers, np.array([omega, damping])))
    )
    noise = Noise(start, np.array([Q] * 2), 0.0, R, np.inf)
    e, s, gains, _ = kalman_path(events, lanes, np.zeros(size), noise, LONGEST, False)
    again = innovations(events, lanes, np.zeros((size, WIDE)), gains, LONGEST)
    read = events.kind >= 0
    largest = np.abs(e[read]).max()
    assert again[read] == pytest.approx(np.repeat(e[read, None], WIDE, axis=1), abs=1e-12 * SMALL)
    x, cov, u, now = np.zeros(size), start.copy(), events.commands[0], None
    for event in events.order:
        h = 0.0 if now is None else then[event] - now
        now, row = then[event], events.kind[event]
        flow = expm(h * np.block([[A, B], [np.zeros((2, size + 2))]]))
        x, cov = (
            flow[:size, :size] @ x + flow[:size, size:] @ u,
            flow[:size, :size] @ cov @ flow[:size, :size].T + Q * h,
        )
        if row < 0:
            u = events.commands[int(events.value[event])]
            continue
        S = reads[row] @ cov @ reads[row] + R[row]
        innovation, K = events.value[event] - reads[row] @ x, cov @ reads[row] / S
        x, cov = x + K * innovation, cov - S * np.outer(K, K)
        assert s[event] == pytest.approx(S, rel=1e-4)
        assert e[event] == pytest.approx(innovation, abs=1e-4 * largest)


def test_without_a_resonance_nothing_but_the_robot_moves() -> None:
    robot = np.array([*constants(list(ROBOT.numbers().values()), 1.0), 1.0, 1.0, 0.0, 0.0, 0.0])[:, None]
    one, other, u, offsets = block_of(robot), block_of(robot), np.array([1.0, 2.0]), np.ones((1, 1))
    move(one, 1, u, np.zeros(1), np.full(1, SPAN), LONGEST)
    moved(other, u, np.zeros(1), np.full(1, SPAN), LONGEST, np.zeros((0, 1)), offsets)
    assert (one == other).all()
    assert one[PITCH_RATE * ROW] < 0  # a positive command pushes the body back
    assert offsets[0, 0] == 1.0


class _Watched:
    """A body whose pitch rate is noted at every step."""

    def __init__(self, body: NonlinearBody) -> None:
        self._body, self.spec = body, body.spec

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        first = self._body.reset(start, seed)
        self.rates = [first.numbers[1]]
        return first

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        after = self._body.step(command, disturbance)
        self.rates.append(after.numbers[1])
        return after

    def close(self) -> None:
        self._body.close()


def prior(name: str) -> Robot:
    """The robot with a centre of mass a tenth too high."""
    robot = Robot.preset(name)
    return robot.replace(com_height=1.1 * robot.com_height)


@cache
def logged(name: str, frequency: float, damping: float, seed: int = 3, seconds: float = 8.0) -> Log:
    """A run of the preset whose gyro is read through SciPy's filter; as if from another program, without its origin."""
    robot = Robot.preset(name)
    kit = find_kit(robot.kit)
    body = _Watched(NonlinearBody.dividing(robot, kit.period))
    dither = random_binary(round(seconds / kit.period), DITHER[name], seed, 4)
    controller = Excited(make_controller("lqg", prior(name), kit, kit.period), dither)
    log = run(Electronics(body, kit), controller, seconds=seconds, seed=seed)
    assert not log.origin["outcome"]["fell"]
    channels = dict(log.channels)
    if frequency:
        gyro, rng, omega = kit.sensors["sensor/gyro"], np.random.default_rng(seed), 2 * np.pi * frequency
        fine = body.spec.period * np.arange(len(body.rates))
        read = lsim(([omega**2], [1, 2 * damping * omega, omega**2]), body.rates, fine)[1]
        read = np.interp(log.t - gyro.delay, fine, read) + gyro.noise * rng.standard_normal(len(log))
        channels["sensor/gyro"] = gyro.quantum * np.round(read / gyro.quantum)
    return Log(log.t, channels, log.units, {})


@cache
def calibration(name: str, frequency: float, damping: float) -> Calibration:
    return calibrate(logged(name, frequency, damping, SEED, seconds=12.0), prior(name))


def test_the_search_begins_where_the_gyro_swings() -> None:
    """Of a known robot whose gyro swings at 11 Hz: the best start is the nearest one, 10 Hz, half an octave from the
    next, and far likelier than no resonance."""
    problem, _ = prepared([logged(*SWING, seconds=4.0)], Robot.preset("ev3way"), Kit.preset("ev3"), (), 0.0)
    z = np.zeros(len(problem.parameters))
    starts = {objective(*one)[0]: tuple(values_of(*one, TYPICAL).values()) for one in _starts(problem, z)}
    assert starts[min(starts)] == pytest.approx((10.0, 0.1))
    assert min(starts) < objective(problem, z)[0] - 100  # nats; a fit is asked for far fewer


@pytest.mark.evidence
@pytest.mark.parametrize(("name", "frequency", "damping"), [SWING, FILTER])
def test_a_gyro_that_swings_or_is_filtered_is_found_with_the_robot(name: str, frequency: float, damping: float) -> None:
    found, true = calibration(name, frequency, damping), Robot.preset(name)
    assert found[FREQUENCY].low <= frequency <= found[FREQUENCY].high
    assert found[DAMPING].low <= damping <= found[DAMPING].high
    assert found[FREQUENCY].verdict == found[DAMPING].verdict == "visible"
    assert found["com_height"].low <= true.com_height <= found["com_height"].high
    assert found["a11"].low <= COMBINATIONS["a11"][1](true) <= found["a11"].high
    said = next(note for note in map(str, found.notes) if "Hz" in note)
    assert ("swings" in said) == (damping < 0.5)
    assert ("filter" in said) == (damping >= 0.5)
    assert found.to_json()["likelier"][FREQUENCY] > 0
    assert found.to_json()["electronics"][-1]["name"] == DAMPING
    kit = found.known_robot().kit
    assert isinstance(kit, Kit)
    assert kit.sensors["sensor/gyro"].resonance == pytest.approx(found[FREQUENCY].value, rel=1e-6)


@pytest.mark.evidence
def test_a_gyro_that_does_neither_gets_no_resonance() -> None:
    """As `test_drop` claims of another robot."""
    found = calibration("ev3way", 0.0, 0.0)
    assert FREQUENCY not in [e.name for e in found.electronics]
    assert in_words(found.electronics) == []
    assert found.kit
    assert found.kit.sensors["sensor/gyro"].resonance == 0


def test_nothing_is_said_of_a_resonance_that_the_log_leaves_open() -> None:
    """A gyro that stands still fitted a "low-pass at 34.5 Hz, damping 11", anywhere from 10 to 116 Hz."""
    two = [
        Estimate(name=name, unit="", value=value, low=value / 3, high=3 * value, prior=value, prior_spread=value,
                 verdict=PRIOR, shift=0.0, shrink=0.7)
        for name, value in ((FREQUENCY, 34.5), (DAMPING, 10.6))
    ]  # fmt: skip
    assert in_words(two) == []
    assert in_words([replace(two[0], verdict=VISIBLE), two[1]])


def test_the_resonance_of_a_kit_judges_a_log() -> None:
    """Of half seconds the gyro's swing is nine tenths of what a sensor without it leaves."""
    name, frequency, damping = SWING
    stiff = Kit.preset("ev3")
    gyro = replace(stiff.sensors["sensor/gyro"], resonance=frequency, damping=damping)
    kit = replace(stiff, sensors=stiff.sensors | {"sensor/gyro": gyro})
    left: list[float] = []
    for one in (kit, stiff):
        problem, limits = prepared([logged(*SWING)], Robot.preset(name), one, (), 0.0)
        assert resonates(problem.asked) == (one is kit)
        fitted = of_this_run(problem, limits)
        assert fitted
        left.append(1 - fitted[0].r_squared("sensor/gyro"))
    assert left[0] < left[1] / 10


def test_a_kit_with_a_resonance_is_written_and_read(tmp_path: Path) -> None:
    kit = Kit.preset("ev3")
    gyro = replace(kit.sensors["sensor/gyro"], resonance=14.0, damping=0.1)
    swings = replace(kit, sensors=kit.sensors | {"sensor/gyro": gyro})
    (tmp_path / "kit.toml").write_text(swings.to_toml())
    assert Kit.load(tmp_path / "kit.toml") == swings
    with pytest.raises(InvalidRobot, match="sensor damping is 0; expected more than zero"):
        Sensor(resonance=14.0, damping=0.0)
