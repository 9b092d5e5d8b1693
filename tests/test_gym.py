"""Environments of Gymnasium: one robot is `run` by hand, many are the kernel, and both keep Gymnasium's contract."""

from __future__ import annotations

import copy
import math
import subprocess
import sys
import warnings
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from conftest import PATIENCE
from upright.bodies import Electronics, NonlinearBody
from upright.control import Controller, lqg
from upright.experiment import run
from upright.kernel.batch import FleetBatch, idle, parameters_of
from upright.kernel.simulate import simulate
from upright.kernel.stepped import Stepped
from upright.robots import Kit, Robot, Sensor, find_kit
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals.signal import TRUE_STATE

gymnasium: Any = pytest.importorskip("gymnasium")

ID = "upright/Balance-v0"
NXT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
START = (0.05, 0.0, 0.1, 0.0, 0.2, 0.0)
EQUAL = 1e-12  # the same functions in the same order
ROUNDED = 1e-9  # the kernel adds in another order: rounding alone gives 1e-12


@pytest.fixture(autouse=True)
def _registered() -> None:
    import upright.gym  # noqa: F401 (which registers)


def still(kit: Kit) -> Kit:
    """The kit without what is random; quanta, dead zone and delays stay."""
    sensors = {name: replace(s, noise=0.0, bias=0.0, bias_walk=0.0) for name, s in kit.sensors.items()}
    return replace(kit, sensors=sensors, jitter=0.0)


class ByHand:
    """A controller at the side of an environment: what it reads is picked from an observation by its name."""

    def __init__(self, controller: Controller, channels: tuple[str, ...]) -> None:
        self._inner = copy.deepcopy(controller)
        self._reads = [channels.index(name) for name in controller.spec.reads]
        self._inner.reset()

    def action(self, observation: np.ndarray) -> np.ndarray:
        return np.array(self._inner.step(observation[self._reads], np.zeros(6)))

    def applied(self, command: np.ndarray) -> None:
        self._inner.applied(command.tolist())


@pytest.mark.parametrize("choices", [{}, {"robot": "twipr"}, {"kit": "ideal"}, {"vary": ("spread", "delay=0..0.01")}])
def test_gymnasium_finds_no_fault(choices: dict[str, Any]) -> None:
    from gymnasium.utils.env_checker import check_env

    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        check_env(gymnasium.make(ID, **choices).unwrapped)
    # wheels turn without end, and commands have a unit
    assert all("infinity" in str(w.message) or "normalized" in str(w.message) for w in heard), list(map(str, heard))


@pytest.mark.parametrize("name", ["nxtway-gs", "ev3way", "twipr"])
def test_a_controller_called_by_hand_is_the_one_that_is_run(name: str) -> None:
    robot = Robot.preset(name)
    kit = find_kit(robot.kit)
    controller = lqg(robot, kit)
    log = run(Electronics(NonlinearBody(robot), kit), controller, seconds=3.0, seed=7, start=START)
    env = gymnasium.make(ID, robot=robot, kit=kit)
    channels = env.unwrapped.channels
    hand = ByHand(controller, channels)
    observation, info = env.reset(seed=7, options={"start": START})
    for k in range(len(log.t)):
        assert observation == pytest.approx([log[name][k] for name in channels], abs=EQUAL)
        assert info["truth"] == pytest.approx([log[name][k] for name in TRUE_STATE], abs=EQUAL)
        observation, _, fell, _, info = env.step(hand.action(observation))
        hand.applied(info["applied"])
        assert info["applied"] == pytest.approx([log[f"applied/{side}"][k] for side in ("left", "right")], abs=EQUAL)
    assert fell == log.origin["outcome"]["fell"]


def test_many_robots_equal_one_and_begin_anew_after_a_fall() -> None:
    """The first holds itself up; the second gets no command, falls, and its next episode is one by itself."""
    kit = still(KIT)
    many = gymnasium.make_vec(ID, num_envs=2, robot=NXT, kit=kit)
    one = gymnasium.make(ID, robot=NXT, kit=kit)
    controller = ByHand(lqg(NXT, kit), one.unwrapped.channels)
    assert many.metadata["autoreset_mode"] is gymnasium.vector.AutoresetMode.NEXT_STEP
    readings, _ = many.reset(seed=3, options={"start": [START, (0.1, 0, 0, 0, 0, 0)]})
    reading, _ = one.reset(seed=3, options={"start": START})
    begun, over, falls = 0, False, 0
    other = gymnasium.make(ID, robot=NXT, kit=kit)
    expected, _ = other.reset(options={"start": (0.1, 0, 0, 0, 0, 0)})
    for k in range(200):
        assert readings[0] == pytest.approx(reading, abs=ROUNDED)
        if not over:  # at a fall the kernel stops within the period
            assert readings[1] == pytest.approx(expected, abs=ROUNDED)
        action = controller.action(reading)
        readings, rewards, fell, late, info = many.step(np.array([action, (0.0, 0.0)]))
        reading, reward, _, _, alone = one.step(action)
        controller.applied(alone["applied"])
        assert rewards[0] == pytest.approx(reward, abs=ROUNDED)
        assert not fell[0]
        assert not late.any()
        if over:
            begun, over = k, False
            assert rewards[1] == 0
            assert info["truth"][1, 1:].tolist() == [0] * 5  # at rest, leaning at most so far
            assert abs(info["truth"][1, 0]) <= 0.05
            expected, _ = other.reset(options={"start": info["truth"][1]})
        else:
            expected, _, over, _, _ = other.step(np.zeros(2))
        assert fell[1] == over
        falls += int(over)
    assert falls > 1
    assert begun > 0


def test_the_kernel_in_single_periods_is_the_kernel_to_the_last_bit() -> None:
    """With everything random, a sensor slower than the loop, and more robots than one block holds."""
    slow = {**KIT.sensors, "sensor/gyro": replace(KIT.sensors["sensor/gyro"], period=0.025, bias=0.1, bias_walk=0.1)}
    kit = replace(KIT, sensors=slow)
    controller = lqg(NXT, kit)
    robots = draw(NXT, 70, 5, Uncertainty.normal(NXT, {"com_height": 0.002}))
    start = np.zeros((70, 6))
    start[:, 0] = np.linspace(-0.05, 0.05, 70)
    given: dict[str, Any] = {
        "parameters": parameters_of(robots),
        "controller": idle(controller.spec),
        "kit": kit,
        "seed": 5,
    }
    channels = (*TRUE_STATE, *controller.spec.reads, "applied/left", "applied/right")
    whole = simulate(FleetBatch(**given, start=start, called=controller), 1.0, record=1, channels=channels).trace
    stepped = Stepped(FleetBatch(**given), 70)
    places = np.arange(70)
    stepped.begin(places, places, places, start)
    hands = [ByHand(controller, controller.spec.reads) for _ in places]
    for k in range(100):
        before = np.hstack([stepped.state, stepped.readings])
        stepped.step(np.array([hand.action(row) for hand, row in zip(hands, stepped.readings, strict=True)]))
        for hand, applied in zip(hands, stepped.applied, strict=True):
            hand.applied(applied)
        stood = np.isfinite(whole[:, k]).all(axis=1)
        assert np.array_equal(np.hstack([before, stepped.applied])[stood], whole[stood, k])
    assert stood.sum() > 60


@pytest.mark.parametrize("source", ["spread", "posterior"])
def test_each_episode_has_another_robot(source: str) -> None:
    """Robots that lean without a command show their own numbers: they are those that `draw` draws."""
    posterior = Uncertainty.joint(["com_height", "body_mass"], [0.09, 0.7], np.diag([1e-5, 1e-4]))
    choices = {"vary": ("com_height=±10%", "battery.voltage=6..8")} if source == "spread" else {"posterior": posterior}
    kit = still(KIT)
    many = gymnasium.make_vec(ID, num_envs=3, robot=NXT, kit=kit, **choices)
    one = gymnasium.make(ID, robot=NXT, kit=kit, **choices)
    for env in (many, one):
        env.reset(seed=11, options={"start": START})
    for _ in range(15):
        full = many.step(np.full((3, 2), 9.0))[4]  # more than any battery gives
        alone = one.step(np.full(2, 9.0))[4]
    pitch = full["truth"][:, 0]
    assert np.ptp(pitch) > 1e-3
    assert alone["truth"] == pytest.approx(full["truth"][0], abs=ROUNDED)
    if source == "posterior":
        middle = NXT.replace(com_height=0.09, body_mass=0.7)
        for robot, state in zip(draw(middle, 3, 11, posterior), full["truth"], strict=True):
            body = Electronics(NonlinearBody(robot), kit)
            body.reset(START)
            for _ in range(150):
                sample = body.step((9.0, 9.0))
            assert state == pytest.approx(sample.numbers[:6], abs=ROUNDED)
    else:
        assert np.ptp(full["applied"][:, 0]) > 0.1
        assert ((full["applied"] > 5) & (full["applied"] <= 8)).all()


def test_spaces_have_the_bounds_of_the_kit() -> None:
    env = gymnasium.make(ID, robot=NXT, kit=KIT)
    assert env.action_space.high.tolist() == [8.0, 8.0]  # six cells
    gyro = env.unwrapped.channels.index("sensor/gyro")
    assert env.observation_space.high[gyro] == KIT.sensors["sensor/gyro"].range < math.inf
    assert "sensor/battery" not in env.unwrapped.channels
    fast = replace(KIT, sensors={"sensor/gyro": Sensor(range=0.3)})
    many = gymnasium.make_vec(ID, num_envs=4, robot=NXT, kit=fast)
    many.reset(seed=0)
    many.action_space.seed(0)
    for _ in range(100):
        readings = many.step(many.action_space.sample())[0]
        assert readings in many.observation_space
    assert np.abs(readings).max() <= 0.3


def test_an_episode_ends_at_a_fall_or_after_its_periods() -> None:
    many = gymnasium.make_vec(ID, num_envs=2, max_episode_steps=20, kit="ideal", lean=0.0)
    one = gymnasium.make(ID, max_episode_steps=20, kit="ideal", lean=0.0)
    many.reset()
    one.reset()
    for k in range(1, 60):
        _, rewards, fell, late, _ = many.step(np.zeros((2, 2)))
        assert rewards.tolist() == [0.0 if k % 21 == 0 else 1.0] * 2  # exactly upright, in its place
        assert late.tolist() == [k % 21 == 20] * 2
        assert not fell.any()
        if k <= 20:
            assert one.step(np.zeros(2))[1:4] == (1.0, False, k == 20)


def test_the_reward_is_that_of_the_documents() -> None:
    from upright.gym.task import reward

    lean, far = (0.4, 0, 0, 0, 0, 0), (0, 0, 25.0, 0, 0, 0)  # half of 0.8 rad; half a metre on wheels of 2 cm
    states = np.array([(0,) * 6, lean, far, (0.9, 0, 0, 0, 0, 0)], dtype=float)
    assert reward(states, 0.02) == pytest.approx([1, 0.75, 0.5, 0])


def test_gymnasium_imports_the_room_that_an_id_names() -> None:
    code = "import gymnasium; print(gymnasium.make('upright.gym:upright/Balance-v0').unwrapped.channels)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=PATIENCE)
    assert "sensor/gyro" in said.stdout
