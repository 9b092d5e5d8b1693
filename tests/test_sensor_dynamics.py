"""Sensors with states of their own: a gyro that swings or is filtered, and the angle that a filter makes of gyro and
accelerometer; and a gyro that is tilted."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest
from scipy.signal import lsim

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.body import REST, Sample
from upright.calibration.calibrate import prepared
from upright.calibration.own_run import of_this_run
from upright.control import Controller, LinearController, as_linear, make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import SpecMismatch
from upright.experiment import Push, run
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.logs.recording import reading_matrix
from upright.physics.dynamics import CALM, Disturbance, turn_ratio
from upright.physics.sensing import accelerometer
from upright.robots import Kit, Robot, Sensor
from upright.signals import STATE_NAMES

ROBOT, NXT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
ANGLE, GYRO = "sensor/pitch", "sensor/gyro"


def also(controller: Controller, gains: dict[str, float]) -> LinearController:
    """A linear controller that reads more sensors, each with a gain [V/unit] of its own."""
    c = as_linear(controller)
    By = np.hstack([c.By, np.zeros((len(c.A), len(gains)))])
    opinion = {"Sy": np.hstack([c.Sy, np.zeros((len(c.Sy), len(gains)))])} if c.Sy.size else {}
    Dy = np.hstack([c.Dy, np.tile([*gains.values()], (2, 1))])
    return replace(c, **opinion, By=By, Dy=Dy, reads=(*c.spec.reads, *gains))


def fitted(**sensors: Sensor) -> Kit:
    """The kit with these sensors instead of its own, or besides."""
    return replace(NXT, sensors=NXT.sensors | {f"sensor/{name}": sensor for name, sensor in sensors.items()})


ALL = {
    "swings, samples out of step with the loop": (
        replace(NXT.sensors[GYRO], resonance=25.0, damping=0.5, misalignment=-0.2, offset=0.01, gain=1.05),
        Sensor(time_constant=0.3, period=0.003, delay=0.004, noise=0.002, offset=0.01, bias=0.005, bias_walk=0.001),
    ),
    "tilted, filtered at every step": (
        replace(NXT.sensors[GYRO], misalignment=0.3),
        Sensor(time_constant=2.0, noise=0.001, quantum=0.0005, range=0.2),
    ),
    "filtered, slower than the loop": (
        replace(NXT.sensors[GYRO], resonance=60.0, damping=1.6),
        Sensor(time_constant=0.1, period=0.02, delay=0.002, noise=0.001),
    ),
    "no filter": (NXT.sensors[GYRO], Sensor(period=0.004, delay=0.003, offset=-0.01, noise=0.001)),
}


@pytest.mark.parametrize("case", ALL)
def test_the_kernel_reads_what_the_obvious_loop_reads(case: str) -> None:
    gyro, angle = ALL[case]
    late = Sensor(noise=0.1, offset=0.05, bias=0.1, bias_walk=0.02, period=0.002, delay=0.005)
    kit = fitted(gyro=gyro, pitch=angle, accel_forward=late)
    lqg = make_controller("lqg", ROBOT, NXT, NXT.period)
    controller = also(lqg, {ANGLE: 2.0, "sensor/accel_forward": 0.01})
    start, seed = (0.02, 0.1, 0.0, 0.0, 0.1, 0.3), 3
    log = run(Electronics(NonlinearBody(ROBOT), kit), controller, Push(force=0.5, start=0.3), seconds=2.0, seed=seed,
              start=start)  # fmt: skip
    assert not log.origin["outcome"]["fell"]
    assert np.ptp(log["truth/pitch"]) > 0.02  # it moves, so that there is something to read
    batch = FleetBatch(parameters=parameters_of(ROBOT), controller=controller, start=start, kit=kit, seed=seed,
                       pushes=[[0.5, math.nan, 0.3, 0.1]])  # fmt: skip
    result = simulate(batch, 2.0, record=1, channels=("truth/pitch", "applied/left", *controller.reads))
    for k, name in enumerate(result.channels):
        assert np.abs(log[name] - result.trace[0, : len(log), k]).max() < 1e-9  # the kernel's bar


def test_a_fleet_with_tilted_gyros_of_each_size_is_each_of_them() -> None:
    lqg = make_controller("lqg", ROBOT, NXT, NXT.period)
    given = {"parameters": parameters_of(ROBOT), "controller": lqg, "start": (0.02, 0, 0, 0, 0.1, 1.0)}
    changes = {"sensors.gyro.misalignment": [0.0, 0.3]}
    same_noise = np.zeros(2, np.uint64)
    both = simulate(FleetBatch(**given, kit=NXT, kit_changes=changes, index=same_noise), 1.0)
    for tilt, final in zip((0.0, 0.3), both.final, strict=True):
        gyro = replace(NXT.sensors[GYRO], misalignment=tilt)
        assert np.array_equal(simulate(FleetBatch(**given, kit=fitted(gyro=gyro)), 1.0).final[0], final)


def readings(kit: Kit, steps: int = 600) -> dict[str, np.ndarray]:
    """All channels of a robot that is driven to and fro while it turns."""
    body = Electronics(NonlinearBody(ROBOT), kit)
    rows = [body.reset((0.02, 0.3, 0.0, 0.0, 0.0, 0.5)).values]
    for k in range(steps):
        swing = 4.0 * math.sin(0.02 * k)
        rows.append(body.step((swing + 1.0, swing - 1.0)).values)
    return dict(zip((s.name for s in body.spec.channels), np.array(rows).T, strict=True))


@pytest.mark.parametrize(("frequency", "damping"), [(11.0, 0.05), (25.0, 0.7), (40.0, 1.0), (2.0, 3.0), (450.0, 0.1)])
def test_a_gyro_that_swings_is_scipy_s_transfer_function(frequency: float, damping: float) -> None:
    """`lsim` is exact where the rate is straight between the body's steps, as the gyro takes it; it begins settled."""
    read = readings(fitted(gyro=Sensor(resonance=frequency, damping=damping)))
    rate, omega = read["truth/pitch_rate"], 2 * math.pi * frequency
    t = 0.001 * np.arange(len(rate))
    swung = lsim(([omega**2], [1, 2 * damping * omega, omega**2]), rate - rate[0], t)[1] + rate[0]
    assert read[GYRO] == pytest.approx(swung, abs=1e-9)
    assert np.abs(read[GYRO] - rate).max() > 1e-3  # it is not the rate itself


def test_a_tilted_gyro_reads_as_a_calibration_finds_it() -> None:
    """Its part of the yaw rate is beside the gain, and beside the resonance."""
    gyro = Sensor(misalignment=-0.2, gain=1.1, offset=0.03)
    read = readings(fitted(gyro=gyro))
    level = {GYRO: replace(gyro, misalignment=0.0)}
    C = reading_matrix((GYRO,), 8, np.array([turn_ratio(ROBOT)]), level, -0.2)
    state = np.array([read[f"truth/{name}"] for name in STATE_NAMES])
    assert read[GYRO] == pytest.approx(C[0, :6, 0] @ state + 0.03, abs=1e-12)
    swings = readings(fitted(gyro=replace(gyro, resonance=20.0)))
    straight = readings(fitted(gyro=replace(gyro, resonance=20.0, misalignment=0.0)))
    assert swings[GYRO] == pytest.approx(straight[GYRO] - 0.2 * swings["truth/yaw_rate"], abs=1e-12)


class Carried:
    """A body that is carried at one pitch and one acceleration, whatever is commanded."""

    def __init__(self, pitch: float, acceleration: float, lacks: str = "") -> None:
        spec = NonlinearBody(ROBOT).spec
        self.spec = replace(spec, channels=tuple(s for s in spec.channels if s.name != lacks))
        x = (pitch, *REST[1:])
        forward, up = accelerometer(x, acceleration / ROBOT.wheel_radius, ROBOT)
        known = {"truth/pitch": pitch, "sensor/accel_forward": forward, "sensor/accel_up": up}
        self._numbers = tuple(known.get(signal.name, 0.0) for signal in self.spec.channels)
        self._steps = 0

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        return Sample(0.0, self._numbers, (0.0, 0.0))

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        self._steps += 1
        return Sample(self._steps * self.spec.period, self._numbers, (0.0, 0.0))

    def close(self) -> None: ...


def angles(body: Carried, sensor: Sensor, seconds: float) -> np.ndarray:
    carried = Electronics(body, fitted(pitch=sensor, gyro=Sensor()))
    place = [signal.name for signal in carried.spec.channels].index(ANGLE)
    rows = [carried.reset(), *(carried.step((0.0, 0.0)) for _ in range(round(seconds / 0.001)))]
    return np.array([row.numbers[place] for row in rows])


@pytest.mark.parametrize("period", [0.0, 0.005])
def test_a_fused_angle_leans_while_the_robot_accelerates(period: float) -> None:
    """The accelerometer points atan(a/g) behind the vertical, and the filter goes there in its time constant: within
    h/τ, its steps being those of Euler, and the square of that angle over 6, sin z being no z."""
    tau, a, g, pitch = 0.5, 1.0, ROBOT.gravity, 0.1
    lean = math.atan(a / g)
    read = angles(Carried(pitch, a), Sensor(time_constant=tau, period=period), 20 * tau)
    assert read[0] == pitch
    assert read[500] == pytest.approx(pitch - lean * (1 - math.exp(-1)), abs=lean * (0.01 + lean**2 / 6))
    assert read[-1] == pytest.approx(pitch - lean, abs=1e-8)  # e⁻²⁰ of it is left
    assert lean == pytest.approx(a / g, rel=0.01)


def test_at_rest_and_without_a_time_constant_it_is_the_pitch_and_the_offset() -> None:
    for acceleration, tau in ((0.0, 0.5), (1.0, 0.0)):
        read = angles(Carried(0.1, acceleration), Sensor(time_constant=tau, offset=-0.03), 0.5)
        assert read == pytest.approx(np.full(501, 0.07), abs=1e-12)


def test_it_follows_a_pitch_that_the_gyro_feels() -> None:
    """Of a robot that moves far faster than its time constant: the gyro's integral, without the accelerations that a
    hundredth of a time constant leaves no time for."""
    read = readings(fitted(pitch=Sensor(time_constant=50.0), gyro=Sensor()), steps=300)
    moved = np.ptp(read["truth/pitch"])
    assert moved > 0.1
    # rates summed at the end of each millisecond, and accelerations of a few m/s² for 0.3 s of 50 s
    assert read[ANGLE] == pytest.approx(read["truth/pitch"], abs=0.02 * moved)


def test_it_is_made_of_what_gyro_and_accelerometer_read() -> None:
    """Summed again over the readings beside it, with all their faults; and with an offset b of the gyro alone, that
    of a robot at rest ends b τ off, where the accelerometer draws it back as fast as the gyro leads it away."""
    tau, h = 0.3, 0.001
    faults = {"noise": 0.02, "offset": 0.03, "bias": 0.05, "bias_walk": 0.01, "quantum": 0.004, "delay": 0.003}
    gyro = Sensor(**faults, gain=1.05, resonance=25.0, damping=0.3, misalignment=0.1)
    forward, up = Sensor(**faults, period=0.004), Sensor(**faults, gain=0.97)
    read = readings(fitted(gyro=gyro, accel_forward=forward, accel_up=up, pitch=Sensor(time_constant=tau)))
    angle = [read["truth/pitch"][0]]
    sources = zip(read[GYRO], read["sensor/accel_forward"], read["sensor/accel_up"], strict=True)
    for rate, along, above in list(sources)[1:]:
        drawn = (along * math.cos(angle[-1]) + above * math.sin(angle[-1])) / (ROBOT.gravity * tau)
        angle.append(angle[-1] + h * (rate - drawn))
    assert read[ANGLE] == pytest.approx(np.array(angle), abs=1e-9)
    offset = 0.02
    carried = Electronics(Carried(0.0, 0.0), fitted(pitch=Sensor(time_constant=tau), gyro=Sensor(offset=offset)))
    place = [signal.name for signal in carried.spec.channels].index(ANGLE)
    carried.reset()
    last = [carried.step((0.0, 0.0)).numbers[place] for _ in range(round(20 * tau / h))][-1]
    assert math.sin(last) == pytest.approx(offset * tau, rel=1e-6)  # of the filter's own law; e⁻²⁰ is left


def test_a_body_that_lacks_what_it_is_made_of_is_refused_by_name() -> None:
    with pytest.raises(SpecMismatch, match="needs sensor/accel_up"):
        Electronics(Carried(0.0, 0.0, "sensor/accel_up"), fitted(pitch=Sensor(time_constant=0.5)))
    Electronics(Carried(0.0, 0.0, "sensor/accel_up"), fitted(pitch=Sensor()))  # the angle itself needs none


def test_the_predictor_of_a_calibration_explains_what_is_simulated() -> None:
    """It moves the two states of a resonance by other formulas, under parabolas of the rate. A kit without leaves the
    gyro's swing, here a hundredth of its motion."""
    own = replace(NXT.sensors[GYRO], resonance=25.0, misalignment=-0.2, gain=1.1)
    kit, dither = fitted(gyro=own), random_binary(400, 1.5, 3, 4)
    controller = Excited(make_controller("lqg", ROBOT, NXT, NXT.period), dither)
    log = run(Electronics(NonlinearBody(ROBOT), kit), controller, seconds=4.0, seed=3)
    left: list[float] = []
    for known in (kit, fitted(gyro=replace(own, resonance=0.0, misalignment=0.0))):
        fit = of_this_run(*prepared([log], ROBOT, known, (), 0.0))
        assert fit
        left.append(1 - fit[0].r_squared(GYRO))
    assert left[0] < left[1] / 20
