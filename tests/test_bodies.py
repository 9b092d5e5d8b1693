"""One conformance suite over every registered body, bare and behind every kit's electronics."""

import math
from pathlib import Path

import numpy as np
import pytest

from upright.bodies import BODIES, Body, Electronics, LinearBody, NonlinearBody, make_body
from upright.bodies.electronics import advanced, drive
from upright.control import make_controller
from upright.errors import InvalidRobot, SpecMismatch, UnknownName
from upright.experiment import run
from upright.physics.dynamics import CALM, MODELS, Disturbance, accelerations, derivative
from upright.physics.integrate import rk4_step
from upright.physics.linear import linearise
from upright.physics.sensing import readings
from upright.robots import Battery, Kit, Motor, Robot, Sensor, find_kit, kit_names, preset_names

NXT = Robot.preset("nxtway-gs")
LEAN = (0.05, 0.0, 0.1, 0.0, 0.2, 0.0)
KITS = ("bare", *kit_names())
DRIVEN = {"": NXT.name, "voltage": NXT.name, "torque": "twipr", "speed": "stepper"}
GENTLE = {"V": 0.3, "N m": 0.03, "rad/s": 0.3}  # enough to overcome stiction
SIMULATED = [name for name in BODIES if not make_body(name, NXT).spec.real]  # hardware: test_hardware_bodies.py


@pytest.fixture(params=[(name, kit) for name in SIMULATED for kit in KITS], ids="-".join)
def body(request):
    name, kit = request.param
    parts = None if kit == "bare" else Kit.preset(kit)
    robot = Robot.preset(DRIVEN[parts.drive]) if parts else NXT
    made = make_body(name, robot) if parts is None else Electronics(make_body(name, robot), parts)
    yield made
    made.close()
    made.close()  # closing twice is allowed


def play(body, seed, steps=60):
    """A noisy open-loop run, gentle enough that nothing falls."""
    rng = np.random.default_rng(5)
    samples = [body.reset(LEAN, seed)]
    size = GENTLE[body.spec.command_unit]
    samples += [body.step(rng.normal(size=2) * size, Disturbance(0.2, 0.05)) for _ in range(steps)]
    return samples


def test_it_keeps_the_contract(body):
    assert isinstance(body, Body)
    samples = play(body, 1)
    names = [signal.name for signal in body.spec.channels]
    assert len(set(names)) == len(names)
    assert all(sample.values.shape == (len(names),) for sample in samples)
    assert np.allclose([s.t for s in samples], np.arange(len(samples)) * body.spec.period, rtol=0, atol=1e-12)
    assert not any(s.fallen for s in samples)
    assert {type(number) for s in samples for number in (s.t, *s.numbers, *s.applied)} == {float}


def test_same_seed_same_run_and_a_reset_forgets(body):
    first, second = play(body, 7), play(body, 7)
    assert all(
        np.array_equal(a.values, b.values) and a.applied == b.applied for a, b in zip(first, second, strict=True)
    )


def test_steps_whose_samples_nobody_reads_leave_the_same_body(body):
    # periods of ten steps under one command, pushed in the middle of one: each step by itself, and all at once
    def pushed(t):
        return Disturbance(0.2, 0.05) if 0.013 < t < 0.017 else CALM

    commands = np.random.default_rng(5).normal(size=(6, 2)) * GENTLE[body.spec.command_unit]
    now, single = body.reset(LEAN, 3), []
    for command in commands:
        for _ in range(10):
            now = body.step(command, pushed(now.t))
        single.append(now)
    now = body.reset(LEAN, 3)
    together = [now := advanced(body, now.t, command, pushed, 10) for command in commands]
    assert together == single


def test_samples_are_read_only_and_share_no_memory(body):
    samples = play(body, 1, steps=3)
    with pytest.raises(ValueError, match="read-only"):
        samples[0].values[0] = 1
    assert not np.shares_memory(samples[1].values, samples[2].values)


def test_no_channel_of_motion_is_stuck(body):
    table = np.array([s.values for s in play(body, 3, steps=300)])
    names = [signal.name for signal in body.spec.channels]
    stuck = {name for name, column in zip(names, table.T, strict=True) if np.ptp(column) == 0}
    assert stuck <= {"sensor/battery"}  # a battery may stay full


def test_starts_where_it_is_put(body):
    first = body.reset(LEAN, 1)
    truth = dict(zip((s.name for s in body.spec.channels), first.values, strict=True))
    # MuJoCo keeps attitude as a quaternion: rounding, not more
    assert np.allclose([truth["truth/pitch"], truth["truth/yaw"]], [0.05, 0.2], atol=1e-9)


def test_nan_and_wrong_size_are_refused(body):
    body.reset()
    with pytest.raises(SpecMismatch, match="diverged"):
        body.step((np.nan, 0.0))
    with pytest.raises(SpecMismatch, match="2 finite numbers"):
        body.step((0.0,))
    with pytest.raises(SpecMismatch, match="start"):
        body.reset((0.0, 1.0))


def test_unknown_body_is_named_with_the_known_ones():
    with pytest.raises(UnknownName, match="did you mean 'twin'"):
        make_body("twinn", NXT)


def test_linear_and_nonlinear_model_agree_for_small_motion():
    # the first neglected term is pitch³/6: at 1 mrad, a relative 2e-7, grown by the unstable pole over 0.2 s
    runs = []
    for body in (NonlinearBody(NXT), LinearBody(linearise(NXT), NXT)):
        body.reset((1e-3, 0, 0, 0, 0, 0))
        for _ in range(200):
            last = body.step((1e-3, -1e-3), Disturbance(1e-4, 0.05))
        runs.append(last.values[:6])
    assert np.allclose(runs[0], runs[1], rtol=1e-4, atol=1e-8)


def test_a_discrete_model_steps_at_its_own_period():
    assert LinearBody(linearise(NXT).c2d(0.01), NXT).spec.period == 0.01


def test_a_stiff_robot_is_integrated_in_smaller_steps():
    # a winding of 0.5 Ω puts the fast pole far beyond what one RK4 step of 10 ms bears (stability ends at 2.78/|λ|)
    robot = NXT.replace(motor_resistance=0.5)
    body = NonlinearBody(robot, period=0.01)
    assert max(abs(linearise(robot).poles())) * 0.01 > 2.78
    body.reset()
    assert abs(body.step((1.0, 1.0)).values).max() < 100


@pytest.mark.parametrize("name", preset_names())
@pytest.mark.parametrize("model", MODELS)
@pytest.mark.parametrize("period", [0.001, 0.005])
def test_a_step_is_that_of_the_dynamics_to_the_last_bit(name, model, period):
    """Also on a slope, pushed, and far from upright: the function that is written rounds as the dynamics do."""
    rng, robot = np.random.default_rng(1), Robot.preset(name)
    body = NonlinearBody(robot, model, period)
    for _ in range(5):
        x = rng.normal(0, [0.4, 1, 3, 5, 1, 1]).tolist()
        body.reset(x)
        for _ in range(10):
            u, w = rng.normal(0, 0.5, 2).tolist(), Disturbance(*rng.normal(0, 0.1, 3).tolist())
            for _ in range(body.substeps):
                x = rk4_step(lambda at: derivative(at, u, robot, w, math, model), x, period / body.substeps)  # noqa: B023
            wheel_acc = accelerations(x, u, robot, w, math, model)[1]
            assert body.step(u, w).values.tolist() == [*x, *readings(x, wheel_acc, robot, w.slope)]


def test_a_stiff_robot_takes_no_more_memory():
    """The step is written once, however often it is taken in a period."""
    stiff = NonlinearBody(NXT.replace(torque_constant=250.0))
    assert stiff.substeps > 300
    assert len(stiff._next.__code__.co_code) < 50_000


IDEAL = {"sensor/encoder_left": Sensor(), "sensor/encoder_right": Sensor(), "sensor/gyro": Sensor()}


def test_a_duty_gets_the_voltage_of_the_battery_it_loads() -> None:
    """As a command: at the volts that two duties come to, the electronics find the same voltage of the battery."""
    battery = Battery(voltage=8.0, sag=0.05)
    duties = (0.5, -1.0)
    volts = battery.volts(duties)
    # V = 8 − 0.05 V (0.5 + 1), so V = 8 / 1.075
    assert volts == pytest.approx([d * 8.0 / 1.075 for d in duties], rel=1e-15)
    applied, voltage = drive(volts, Kit(name="k", battery=battery))
    assert applied == volts
    assert voltage == pytest.approx(8.0 / 1.075, rel=1e-15)


def test_drive_order_dead_zone_sag_saturation_quantum():
    kit = Kit(name="k", motor=Motor(dead_zone=0.5, quantum=0.1), battery=Battery(voltage=8.0, sag=0.05))
    assert drive((0.4, 2.04), kit)[0] == (0.0, pytest.approx(2.0))  # dead zone; quantum towards zero
    # both motors at full: the battery sags by 0.05·(8 + 8) = 0.8 V
    applied, voltage = drive((100.0, -100.0), kit)
    assert (applied[0], applied[1], voltage) == (pytest.approx(7.2), pytest.approx(-7.2), pytest.approx(7.2))


def test_a_driver_keeps_its_drop_of_what_saturation_and_quantum_leave():
    """sign(u) max(0, |u| − 1.5 V), last of all: after the dead zone, a sag of 0.05·(|u1| + |u2|), steps of 0.1 V."""
    battery = Battery(voltage=8.0, sag=0.05)
    kit = Kit(name="k", motor=Motor(dead_zone=2.0, quantum=0.1, drop=1.5), battery=battery)
    assert drive((1.9, -2.04), kit)[0] == (0.0, pytest.approx(-0.5))  # in the dead zone; 2.0 V after the quantum
    assert drive((100.0, -100.0), kit)[0] == (pytest.approx(5.7), pytest.approx(-5.7))  # both at 8 − 0.8 V
    bare = Kit(name="k", motor=Motor(drop=1.5))
    for u, left in ((1.4, 0.0), (-1.5, 0.0), (1.75, 0.25), (-4.0, -2.5)):
        assert drive((u, 0.0), bare)[0] == (left, 0.0)  # all exact in binary


def test_a_file_whose_driver_keeps_all_that_the_motors_get_is_refused(tmp_path: Path):
    """A drop of 1.5 V in millivolts: a calibration took it, and blamed the wheels."""
    path = tmp_path / "k.toml"
    head = 'name = "k"\n[battery.voltage]\nvalue = 12.0\nunit = "V"\n'
    path.write_text(head + '[motor.drop]\nvalue = 1500\nunit = "V"\n')
    with pytest.raises(InvalidRobot, match=r"drop is 1500 V; expected less than the 12 V .*millivolts"):
        find_kit(path)
    path.write_text(head + '[motor.drop]\nvalue = 1.5\nunit = "V"\n')
    assert find_kit(path).motor.drop == 1.5


def test_a_torque_drive_has_no_drop():
    with pytest.raises(InvalidRobot, match=r"drop is 1\.5 V with a torque drive"):
        Kit(name="k", drive="torque", motor=Motor(drop=1.5))
    kit = Kit(name="k", sensors=IDEAL, motor=Motor(drop=1.5))
    torque = Robot.preset("twipr")
    with pytest.raises(SpecMismatch, match=r"drop of 1\.5 V"):
        Electronics(NonlinearBody(torque), kit)
    with pytest.raises(SpecMismatch, match=r"drop of 1\.5 V"):
        torque.replace(kit=kit)


def test_sensor_delay_and_hold_are_counted_in_steps():
    kit = Kit(name="k", sensors=IDEAL | {"sensor/gyro": Sensor(delay=0.003, period=0.002)})
    body = Electronics(NonlinearBody(NXT), kit)
    body.reset((0.05, 0, 0, 0, 0, 0))
    rows = [body.step((0.5, 0.5)) for _ in range(40)]
    truth, gyro = np.array([[r.values[1], r.values[-1]] for r in rows]).T
    for k in range(10, 40):
        fresh = k - (k + 1) % 2  # read at even counts; row k is count k + 1
        assert gyro[k] == truth[fresh - 3]


def test_command_delay_and_dead_time():
    body = Electronics(NonlinearBody(NXT), Kit(name="k", sensors=IDEAL, delay=0.004))
    body.reset()
    applied = [body.step((1.0, 1.0)).applied[0] for _ in range(8)]
    assert applied == [0, 0, 0, 0, 1, 1, 1, 1]


def test_encoder_quantum_bias_and_range():
    quantum = np.deg2rad(1.0)
    kit = Kit(name="k", sensors=IDEAL | {"sensor/encoder_left": Sensor(quantum=quantum, range=0.1)})
    body = Electronics(NonlinearBody(NXT), kit)
    body.reset()
    left = np.array([body.step((3.0, 3.0)).values[-3] for _ in range(100)])
    counts = left[np.abs(left) < 0.1] / quantum
    assert np.allclose(counts, np.round(counts), atol=1e-9)
    assert left.max() == 0.1


def test_noise_has_the_stated_size():
    kit = Kit(name="k", sensors=IDEAL | {"sensor/gyro": Sensor(noise=0.02)})
    body = Electronics(NonlinearBody(NXT), kit)
    body.reset()
    rows = np.array([body.step((0.0, 0.0)).values for _ in range(2000)])
    spread = np.std(rows[:, -1] - rows[:, 1])
    # the standard error of a standard deviation from n samples is σ/√(2n): 1.6 %; five of them
    assert abs(spread / 0.02 - 1) < 0.08


def test_backlash_hides_small_motion():
    kit = Kit(name="k", sensors=IDEAL, motor=Motor(backlash=0.02))
    body = Electronics(NonlinearBody(NXT), kit)
    body.reset()
    first = body.reset().values[-3]
    small = body.step((0.01, 0.01))
    assert small.values[-3] == first


def test_a_kit_with_a_sensor_the_body_lacks_is_refused():
    with pytest.raises(SpecMismatch, match="lidar"):
        Electronics(NonlinearBody(NXT), Kit(name="k", sensors={"sensor/lidar": Sensor()}))


def test_the_linear_body_of_a_robot_with_dry_friction_is_the_robot_in_motion():
    """At rest a smoothed dry friction has its steepest slope: as a tangent there it would be a brake that no moving
    robot has (twipr's falling pole 3.6 for 9.2 1/s), and what a controller was designed for would fall in 3 s."""
    robot, kit = Robot.preset("twipr"), Kit.preset("twipr")
    assert robot.coulomb_friction > 0
    log = run(Electronics(make_body("linear", robot), kit), make_controller("lqg", robot, kit, 0.01), seconds=4.0)
    assert np.abs(log["truth/pitch"]).max() < 0.1  # noise of the gyro alone moves it
