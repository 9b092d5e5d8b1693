"""The kernel equals the obvious loop, and a robot's result does not depend on its company."""

import math
from dataclasses import replace
from types import SimpleNamespace

import numba
import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.compiled import counter, lane_math, random
from upright.control import Estimated, kalman, lqr_state, make_controller
from upright.control.linear_controller import LinearController
from upright.errors import InvalidScenario, SpecMismatch, UnknownName
from upright.experiment import Drive, Push, Slope, Turn, run
from upright.kernel import rows, store
from upright.kernel.batch import FleetBatch, idle, parameters_of
from upright.kernel.simulate import simulate, steps_of
from upright.robots import Battery, Kit, Motor, Robot, Sensor, find_kit, preset_names
from upright.robots.uncertainty import draw
from upright.signals import STATE_NAMES

NXT = Robot.preset("nxtway-gs")
STATE = tuple(f"truth/{name}" for name in STATE_NAMES)
BOTH = (*STATE, "command/left", "command/right", "applied/left", "applied/right")
START = (0.05, 0.0, 0.1, 0.0, 0.2, 0.0)
STIFF = NXT.replace(motor_resistance=NXT.motor_resistance / 4)  # a pole near 1000 1/s: two steps in a millisecond
NOISY = Kit.preset("nxt")
FILTERED = Estimated(lqr_state(NXT, 0.01), kalman(NXT, NOISY))
EQUAL = 1e-9  # the bar of the issue; rounding alone gives 1e-12


def still(kit, **changes):
    """The kit without what is random."""
    sensors = {name: replace(s, noise=0.0, bias=0.0, bias_walk=0.0) for name, s in kit.sensors.items()}
    return replace(kit, **{"sensors": sensors, "jitter": 0.0, **changes})


def smooth(kit, **changes):
    """The kit without noise and without steps of a quantum either."""
    sensors = {name: replace(s, quantum=0.0) for name, s in still(kit).sensors.items()}
    return still(replace(kit, sensors=sensors, motor=Motor()), **changes)


def difference(robot, controller, kit=None, seconds=10.0, *, model="complete", push=(), reference=(), seed=0, **batch):
    """Largest difference of any channel between the kernel and `experiment.run`, over all rows before a fall."""
    body = NonlinearBody(robot, model)
    body = Electronics(body, kit) if kit else body
    log = run(body, controller, push, reference=reference, start=START, seconds=seconds, seed=seed)
    sensors = tuple(name for name in controller.spec.reads if name.startswith("sensor/"))
    arrays = {{"ramps": "reference"}.get(name, name): value for name, value in batch.items()}
    fleet = FleetBatch(
        parameters=parameters_of(robot), controller=controller, start=START, kit=kit, model=model, seed=seed, **arrays
    )
    result = simulate(fleet, seconds, record=1, channels=(*BOTH, *sensors))
    assert result.fell[0] == log.origin["outcome"]["fell"]
    stood = int((log.t < log.origin["outcome"]["seconds"] - 1e-9).sum())  # the log goes on until the body lies
    assert np.isfinite(result.trace[0, :, 0]).sum() == stood
    return max(np.abs(log[name][:stood] - result.trace[0, :stood, k]).max() for k, name in enumerate(result.channels))


def test_models_pushes_and_references_equal_the_obvious_loop():
    assert difference(NXT, lqr_state(NXT, 0.01), model="published") < EQUAL
    shove = [Push(force=1.0, height=0.1), Push(force=-0.5, start=2.0, duration=0.3)]
    assert difference(NXT, lqr_state(NXT, 0.01), push=shove, pushes=[[1, 0.1, 1, 0.1], [-0.5, np.nan, 2, 0.3]]) < EQUAL
    arc = [Drive(speed=0.2, start=1.0, until=4.0), Turn(rate=1.0, start=2.0)]
    assert difference(NXT, lqr_state(NXT, 0.01), reference=arc, ramps=[[0.2, 0, 1, 4], [0, 1, 2, math.inf]]) < EQUAL


@pytest.mark.parametrize("friction", [{}, {"coulomb_friction": 0.005}, {"rolling_friction": 0.005}])
@pytest.mark.parametrize("angle", [0.0, 0.03])
def test_friction_and_slope_equal_the_obvious_loop(friction, angle):
    robot = NXT.replace(**friction)
    push = [Slope(angle=angle, start=1.0)] if angle else []
    turn = Turn(rate=1.0, start=2.0)  # a heading that changes meets the slope from all sides
    ramps = [[0, 1, 2, math.inf]]
    assert difference(robot, lqr_state(NXT, 0.01), push=push, slope=[angle, 1.0], reference=turn, ramps=ramps) < EQUAL


@pytest.mark.parametrize("name", ["herrera2015", "ev3way", "nxtway-gs-measured"])
def test_other_robots_equal_the_obvious_loop(name):
    robot = Robot.preset(name)
    assert difference(robot, lqr_state(robot, 0.01), seconds=3.0) < EQUAL


def test_delay_saturation_and_sensors_equal_the_obvious_loop():
    push, rows = Push(force=1.5), [[1.5, np.nan, 1.0, 0.1]]
    late = smooth(NOISY, delay=0.013, battery=Battery(voltage=8.0, sag=0.02))
    assert difference(NXT, FILTERED, late, push=push, pushes=rows) < EQUAL
    # saturates, and falls
    assert difference(NXT, FILTERED, replace(late, motor=Motor(limit=2.0)), push=push, pushes=rows) < EQUAL
    sensors = late.sensors | {
        "sensor/gyro": Sensor(delay=0.007),
        "sensor/encoder_left": Sensor(delay=0.004, period=0.003),  # refreshed out of step with the loop
        "sensor/encoder_right": Sensor(delay=0.005, period=0.02),  # held over two periods
    }
    assert difference(NXT, FILTERED, replace(late, sensors=sensors)) < EQUAL


@pytest.mark.parametrize("delay", [0.0, 0.013])
def test_unequal_motors_equal_the_obvious_loop(delay):
    motor = Motor(dead_zone=0.05, left=0.8, right=1.1, limit=3.0)
    kit = smooth(NOISY, motor=motor, delay=delay)
    assert difference(NXT, FILTERED, kit, push=Push(force=1.5, start=0.5), pushes=[[1.5, math.nan, 0.5, 0.1]]) < EQUAL


@pytest.mark.parametrize("drop", [0.2, 1.5])
def test_a_drop_equals_the_obvious_loop(drop):
    kit = smooth(
        NOISY, motor=Motor(drop=drop, left=0.9, limit=6.0), delay=0.013, battery=Battery(voltage=8.0, sag=0.02)
    )
    assert difference(NXT, FILTERED, kit, push=Push(force=1.5, start=0.5), pushes=[[1.5, math.nan, 0.5, 0.1]]) < EQUAL


def test_a_drop_of_each_robot_is_that_of_its_own_kit():
    given = {"parameters": parameters_of(NXT), "controller": FILTERED, "start": (0.05, 0, 0, 0, 0, 0)}
    channels = ("truth/pitch", "applied/left")
    drops = [0.0, 0.3]
    both = simulate(
        FleetBatch(**given, kit=smooth(NOISY), kit_changes={"motor.drop": drops}), 2.0, record=1, channels=channels
    )
    for i, drop in enumerate(drops):
        kit = smooth(NOISY)
        alone = FleetBatch(**given, kit=replace(kit, motor=replace(kit.motor, drop=drop)))
        assert np.array_equal(both.trace[i], simulate(alone, 2.0, record=1, channels=channels).trace[0])
    assert not np.array_equal(both.trace[0], both.trace[1])


def test_a_weak_motor_turns_the_robot_and_is_reported_as_what_was_applied():
    # each motor's own strength as a change, among robots whose motors are alike: the same bits as alone
    kit, changes = smooth(NOISY), {"motor.left": [1.0, 0.9, 1.0], "motor.right": [1.0, 1.0, 0.9]}
    channels = ("truth/yaw", "applied/left", "applied/right")
    given = {"parameters": parameters_of(NXT), "controller": FILTERED, "start": (0.05, 0, 0, 0, 0, 0), "kit": kit}
    together = simulate(FleetBatch(**given, kit_changes=changes), 2.0, record=1, channels=channels)
    alike = simulate(FleetBatch(**given), 2.0, record=1, channels=channels)
    assert np.array_equal(together.trace[0], alike.trace[0])
    yaw = together.trace[:, :, 0]
    assert np.abs(yaw[0]).max() < 1e-9  # both motors alike: straight on
    assert np.abs(yaw[1]).max() > 0.01
    assert yaw[1] == pytest.approx(-yaw[2], abs=1e-9)  # the mirrored robot
    given |= {"controller": idle(FILTERED.spec), "called": FILTERED}
    called = simulate(FleetBatch(**given, kit_changes=changes), 2.0, record=1, channels=channels)
    assert np.abs(called.trace - together.trace).max() < EQUAL
    assert together.effort == pytest.approx((together.trace[:, :, 1:] ** 2).sum(axis=(1, 2)) * 0.01)


def test_an_accelerometer_equals_the_obvious_loop():
    twipr = Robot.preset("twipr")  # torque drive and Coulomb friction; a bare body reads an ideal accelerometer
    pitch = np.zeros((2, 3))
    pitch[:, 0], pitch[:, 2] = 0.02, -0.01  # any gains will do: what is read must be the same
    none, blank = np.zeros((0, 0)), np.zeros((2, 6))
    reads = ("sensor/accel_forward", "sensor/accel_up", "sensor/gyro")
    controller = LinearController(
        none, np.zeros((0, 3)), np.zeros((0, 6)), np.zeros((0, 2)), np.zeros((2, 0)), pitch, blank,
        reads=reads, period=0.01, command_unit="N m",
    )  # fmt: skip
    assert difference(twipr, controller, push=Slope(angle=0.1, start=0.05), slope=[0.1, 0.05], seconds=0.5) < EQUAL


QUANTISED = 2.0
"""[s] Two roundings of a quantised loop drift apart as in an open loop, since equal readings feed nothing of the drift
back: from 1e-17 by e^(7.5/s · t), the unstable pole of this robot, to a few 1e-10 until then."""


@pytest.mark.parametrize("backlash", [0.0, 0.02])
def test_quantised_loops_equal_the_obvious_loop_until_rounding_has_grown(backlash):
    kit = still(NOISY)
    kit = replace(kit, motor=replace(kit.motor, backlash=backlash))
    push = {"push": Push(force=1.5, start=0.5), "pushes": [[1.5, np.nan, 0.5, 0.1]]}
    assert difference(NXT, FILTERED, kit, QUANTISED, **push) < EQUAL


def test_what_is_quantised_is_the_same_bits_for_longer():
    kit, names = still(NOISY), ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "applied/left")
    log = run(Electronics(NonlinearBody(NXT), kit), FILTERED, start=START, seconds=3.0)
    batch = FleetBatch(parameters=parameters_of(NXT), controller=FILTERED, start=START, kit=kit)
    result = simulate(batch, 3.0, record=1, channels=names)
    # by 3 s the drift is 1e-7 at most, 1e-5 of a quantum: that one of 1200 numbers rounds differently is unlikely
    for k, name in enumerate(names):
        assert np.array_equal(log[name], result.trace[0, : len(log), k])


def fleet(n=200, **changes):
    """n different robots with everything random on, some of which fall."""
    rng = np.random.default_rng(3)
    around = {"com_height": 0.072 * rng.uniform(0.8, 1.2, n), "body_mass": 0.6 * rng.uniform(0.8, 1.2, n)}
    push = np.zeros((n, 1, 4))
    push[:, 0] = np.column_stack([rng.uniform(-8, 8, n), np.full(n, np.nan), np.full(n, 0.2), np.full(n, 0.1)])
    given = {
        "parameters": parameters_of(NXT, around),
        "controller": FILTERED,
        "kit": NOISY,
        "pushes": push,
    }
    return {**given, "start": START, "seed": 5, **changes}


def part(batch, rows):
    """The robots in `rows` of a batch, under the numbers they have in the whole."""
    cut = {name: batch[name][rows] for name in ("parameters", "pushes")}
    return FleetBatch(**{**batch, **cut, "index": np.asarray(rows, dtype=np.uint64)})


def test_a_robot_is_the_same_bits_in_any_batch_order_and_number_of_threads():
    batch = fleet()
    whole = simulate(FleetBatch(**batch), 2.0, threads=1)
    assert 0.1 < whole.fell.mean() < 0.9  # or the test would be about one sort of robot only
    threaded = simulate(FleetBatch(**batch), 2.0, threads=2)
    order = np.random.default_rng(0).permutation(200)
    shuffled, alone = simulate(part(batch, order), 2.0), simulate(part(batch, [137]), 2.0)
    for name in ("final", "lived", "peak", "effort", "saturated"):
        assert np.array_equal(getattr(whole, name), getattr(threaded, name))
        assert np.array_equal(getattr(whole, name)[order], getattr(shuffled, name))
        assert np.array_equal(getattr(whole, name)[[137]], getattr(alone, name))


def test_a_robot_does_not_get_what_only_its_company_needs():
    dry, rolling = NXT.replace(coulomb_friction=0.005), NXT.replace(rolling_friction=0.005)
    robots = [NXT, dry, rolling, NXT, dry, rolling, STIFF]
    slope = np.array([[0.0, 0.0]] * 3 + [[0.03, 0.5]] * 3 + [[0.0, 0.0]])
    given = {"controller": lqr_state(NXT, 0.01), "start": START}
    together = simulate(FleetBatch(parameters=parameters_of(robots), slope=slope, **given), 1.0, record=10)
    for i, robot in enumerate(robots):
        alone = simulate(FleetBatch(parameters=parameters_of(robot), slope=slope[i], **given), 1.0, record=10)
        assert np.array_equal(together.final[i], alone.final[0])
        assert np.array_equal(together.trace[i], alone.trace[0])


def test_each_robot_is_moved_in_as_many_steps_as_the_obvious_loop_takes():
    for robot in (NXT, Robot.preset("herrera2015"), STIFF):
        family = draw(robot, 40, 1)
        batch = FleetBatch(parameters=parameters_of(family), controller=lqr_state(NXT, 0.01))
        assert steps_of(batch).tolist() == [NonlinearBody(robot).substeps for robot in family]
        assert robot == NXT or steps_of(batch).max() > 1  # or there would be nothing to tell apart


def test_a_batch_cut_into_pieces_is_the_same_bits(monkeypatch):
    whole = simulate(FleetBatch(**fleet()), 0.5, record=10, threads=1)
    monkeypatch.setattr("upright.kernel.simulate.PIECE", 80)  # 200 robots in pieces of one block
    pieces = simulate(FleetBatch(**fleet()), 0.5, record=10, threads=2)
    for name in ("final", "lived", "peak", "effort", "trace"):
        assert np.array_equal(getattr(whole, name), getattr(pieces, name), equal_nan=True)


def test_every_kth_period_is_recorded_as_it_is_among_all():
    batch = FleetBatch(**fleet(20))
    names = (*BOTH, "sensor/gyro")
    every, fifth = (simulate(batch, 0.5, record=k, channels=names) for k in (1, 5))
    assert np.array_equal(every.trace[:, ::5], fifth.trace, equal_nan=True)
    assert np.allclose(every.t[::5], fifth.t, rtol=1e-15)  # one product is rounded twice
    assert simulate(batch, 0.5).trace.size == 0


def test_another_seed_is_another_noise():
    one, other, last = (simulate(FleetBatch(**fleet(seed=seed)), 0.5).final for seed in (1, 2, 2**64 - 1))
    assert not np.isclose(one, other, rtol=1e-6).any(axis=0)[:2].all()
    assert not np.isclose(one, last, rtol=1e-6).any(axis=0)[:2].all()


@pytest.mark.parametrize("name", [n for n in preset_names() if n != "twipr"])
def test_a_preset_draws_the_noise_of_the_obvious_loop(name):
    robot = Robot.preset(name)
    kit = find_kit(robot.kit)
    controller = make_controller("lqg", robot, kit, kit.period)
    # tumbller falls faster (8.7 1/s) and its wheels stick: a rounding grows tenfold further in these 2 s
    most = 10 * EQUAL if name == "tumbller" else EQUAL
    assert difference(robot, controller, kit, QUANTISED, seed=2**63 + 7) < most


def test_all_that_is_random_equals_the_obvious_loop():
    """Samples out of step with the loop and with each other, walks in steps of a kit's period that is not the loop's,
    and a jitter as long as it may be."""
    sensors = {
        "sensor/gyro": Sensor(noise=0.01, bias=0.01, bias_walk=0.02, delay=0.004, period=0.003),
        "sensor/encoder_left": Sensor(noise=0.002, bias=0.01, bias_walk=0.01, delay=0.002),
        "sensor/encoder_right": Sensor(noise=0.001, bias=0.01, bias_walk=0.01, period=0.02),
    }
    for period in (0.004, 0.015):
        kit = replace(smooth(NOISY), sensors=sensors, jitter=0.01, delay=0.003, period=period)
        assert difference(NXT, FILTERED, kit, 4.0, seed=3) < EQUAL


@pytest.mark.parametrize("runs", [8, pytest.param(200, marks=pytest.mark.evidence)])
def test_twipr_whose_sticking_wheels_part_runs_falls_where_the_obvious_loop_does(runs):
    """Its torque drive, dead zone of friction and late gyro let a rounding grow to 1e-4 in 2 s. Pushes from those that
    none falls under to those that all do."""
    robot = Robot.preset("twipr")
    kit = find_kit(robot.kit)
    controller = make_controller("lqi", robot, kit, kit.period)
    fell = list[tuple[bool, bool]]()
    for seed, force in enumerate(np.linspace(4.0, 11.0, runs)):
        push, rows = Push(force=float(force), start=0.5), [[force, math.nan, 0.5, 0.1]]
        log = run(Electronics(NonlinearBody(robot), kit), controller, push, seconds=2.0, seed=seed)
        batch = FleetBatch(parameters=parameters_of(robot), controller=controller, kit=kit, pushes=rows, seed=seed)
        fell.append((log.origin["outcome"]["fell"], bool(simulate(batch, 2.0).fell[0])))
    assert {one for one, _ in fell} == {True, False}
    assert [one for one, other in fell if one != other] == []


def test_statistics_equal_those_of_the_recorded_rows():
    batch = FleetBatch(
        parameters=parameters_of(NXT), controller=lqr_state(NXT, 0.01), start=START, kit=smooth(NOISY, delay=0.0)
    )
    result = simulate(batch, 5.0, record=1, channels=BOTH, bands=(0.01, math.inf, math.inf))
    pitch, wheel = result.trace[0, :, 0], result.trace[0, :, 2]
    assert result.peak[0, :2].tolist() == [np.abs(pitch).max(), np.abs(wheel).max()]
    assert result.rms_pitch[0] == pytest.approx(math.sqrt(np.mean(pitch**2)), rel=1e-12)
    assert result.effort[0] == pytest.approx((result.trace[0, :, 8:] ** 2).sum() * 0.01, rel=1e-12)
    assert result.settled[0] == pytest.approx(result.t[np.abs(pitch) > 0.01].max() + 0.01)
    assert not result.fell[0]
    assert result.lived[0] == pytest.approx(5.0)


def test_a_robot_that_falls_stops_where_it_fell():
    batch = FleetBatch(
        parameters=parameters_of(NXT),
        controller=lqr_state(NXT, 0.01),
        start=START,
        pushes=[[20.0, np.nan, 0.5, 0.2]],
    )
    result = simulate(batch, 3.0, record=1)
    assert result.fell[0]
    assert 0.5 < result.lived[0] < 1.0
    assert 0.8 < abs(result.final[0, 0]) < 1.0  # where programs stop (docs/firmware.md), and what one step adds
    assert np.isnan(result.trace[0, -1]).all()
    assert np.isnan(result.settled[0])


def test_each_robot_may_have_its_own_numbers_of_the_kit():
    robots = [Robot.preset("nxtway-gs"), Robot.preset("nxtway-gs-measured")]
    controller = lqr_state(robots[0], 0.01)
    delays = np.array([0.0, 0.004])
    both = FleetBatch(
        parameters=parameters_of(robots), controller=controller, start=START, kit=Kit(name="late"),
        kit_changes={"delay": delays},
    )  # fmt: skip
    result = simulate(both, 2.0)
    for i in range(2):
        log = run(
            Electronics(NonlinearBody(robots[i]), Kit(name="late", delay=float(delays[i]))),
            controller,
            start=START,
            seconds=2.01,
        )
        assert np.abs(log.state()[-1] - result.final[i]).max() < EQUAL


@numba.njit
def words(c, key):
    return random.philox(c[0], c[1], c[2], c[3], key[0], key[1])


def test_the_counter_gives_the_published_words():
    def said(*given):
        numbers = [np.array(part, np.uint64) for part in given]
        compiled = [int(w) for w in words(*numbers)]
        assert compiled == [int(w) for w in counter.philox(*numbers[0], *numbers[1])]
        return compiled

    # Random123 1.14, examples/kat_vectors, "philox4x32 10"
    assert said([0] * 4, [0] * 2) == [0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8]
    assert said([0xFFFFFFFF] * 4, [0xFFFFFFFF] * 2) == [0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD]
    pi = [0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344], [0xA4093822, 0x299F31D0]
    assert said(*pi) == [0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1]


@numba.njit
def sines(x, wide):
    out = np.empty((2, len(x)), x.dtype)
    for i in range(len(x)):
        out[0, i], out[1, i] = lane_math.sincos_any(x[i]) if wide else lane_math.sincos(x[i])
    return out


def test_sine_and_cosine_keep_to_their_stated_error():
    near = np.linspace(-lane_math.REACH, lane_math.REACH, 50_001)
    far = np.linspace(-200.0, 200.0, 50_001)
    for x, wide in ((near, False), (far, True)):
        exact = x.astype(np.longdouble)
        assert np.abs(sines(x, wide) - np.stack([np.sin(exact), np.cos(exact)])).max() <= 1.3e-15  # as lane_math states


@numba.njit
def normals(count):
    out = np.empty(4 * count)
    for i in range(count):
        w = random.philox(np.uint64(i), np.uint64(0), np.uint64(0), np.uint64(0), np.uint64(9), np.uint64(0))
        out[4 * i], out[4 * i + 1] = random.normal_pair(w[0], w[1])
        out[4 * i + 2], out[4 * i + 3] = random.normal_pair(w[2], w[3])
    return out


def test_normal_numbers_are_normal_and_independent():
    from scipy.stats import kstest

    drawn = normals(100_000)
    assert kstest(drawn, "norm").pvalue > 1e-4  # one seed, fixed: a fault would give zero
    four = np.corrcoef(drawn.reshape(-1, 4).T) - np.eye(4)
    assert np.abs(four).max() < 5 / math.sqrt(100_000)  # five standard errors


def test_machine_code_is_kept_and_found_again(tmp_path, monkeypatch):
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    arguments = ("*float64", "int64", "float64", "float64")
    store._address_of.cache_clear()
    store.address_of("compiled.generated_motion", "advance_smooth", arguments)
    (kept,) = tmp_path.iterdir()
    monkeypatch.setattr(store, "_compiled", None)  # a second compilation would fail
    store._address_of.cache_clear()
    assert store.address_of("compiled.generated_motion", "advance_smooth", arguments)
    assert list(tmp_path.iterdir()) == [kept]


@pytest.mark.parametrize("damage", ["empty", "truncated", "flipped", "shortened to its checksum"])
def test_a_damaged_file_of_machine_code_is_made_anew(damage, tmp_path, monkeypatch):
    monkeypatch.setenv("UPRIGHT_CACHE", str(tmp_path))
    monkeypatch.setattr(store, "_compiled", lambda *_: b"machine code")
    monkeypatch.setattr(store, "_engine", lambda code: SimpleNamespace(get_function_address=lambda _: code))
    store._address_of.cache_clear()
    assert store._address_of("kernel.run", "entry", ()) == b"machine code"
    (path,) = tmp_path.iterdir()
    whole = path.read_bytes()
    flipped = bytearray(whole)
    flipped[-3] ^= 1
    entries = {"empty": b"", "truncated": whole[:-1], "flipped": bytes(flipped)}
    path.write_bytes(entries.get(damage, whole[: len(whole) - len(b"machine code")]))
    store._address_of.cache_clear()
    assert store._address_of("kernel.run", "entry", ()) == b"machine code"  # what is loaded is never the damaged code
    assert path.read_bytes() == whole
    monkeypatch.setattr(store, "_compiled", None)  # it stands on disk again: a further compilation would fail
    store._address_of.cache_clear()
    assert store._address_of("kernel.run", "entry", ()) == b"machine code"
    store._address_of.cache_clear()


def test_what_does_not_fit_is_refused():
    one = {"parameters": parameters_of(NXT), "controller": lqr_state(NXT, 0.01)}
    with pytest.raises(InvalidScenario, match="start has shape"):
        FleetBatch(**one, start=np.zeros((3, 5)))
    with pytest.raises(InvalidScenario, match="rows in a batch of 3"):
        FleetBatch(**one, start=np.zeros((3, 6)), slope=np.zeros((2, 2)))
    with pytest.raises(SpecMismatch, match="multiple"):
        simulate(FleetBatch(**one, period=0.003))
    with pytest.raises(SpecMismatch, match="no channel"):
        simulate(FleetBatch(**one), 0.1, record=1, channels=("truth/pich",))
    with pytest.raises(SpecMismatch, match="has no sensor/encoder_left"):
        simulate(FleetBatch(**{**one, "controller": FILTERED}, kit=Kit(name="blind")), 0.1)
    with pytest.raises(UnknownName, match=r"motor\.limt"):
        simulate(FleetBatch(**one, kit_changes={"motor.limt": [1.0]}), 0.1)
    with pytest.raises(InvalidScenario, match="a run of"):
        simulate(FleetBatch(**one), math.nan)


def test_the_places_of_a_plan_are_those_of_its_fields():
    for names in ((*rows.Rows._fields, *rows.Plan._fields, *rows.Sizes._fields), rows.Times._fields):
        assert [getattr(rows, name.upper()) for name in names] == list(range(len(names)))
