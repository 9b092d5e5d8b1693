"""PID on the fused angle: the builder's own numbers, what flies, its file, its loop and its program."""

from __future__ import annotations

import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from interpreter import Interpreter
from test_docs import blocks, commands
from upright.bodies import Electronics, NonlinearBody
from upright.certification.design import design
from upright.cli.main import main
from upright.control import CONTROLLERS, AnglePid, controller_hash, pid_angle, read_controller, write_controller
from upright.control.delay import sampled
from upright.control.design import Design
from upright.control.law import as_law, near_rest, program
from upright.control.pid_angle_design import drift, least_integral
from upright.control.state_space import controller_of, plant_of
from upright.errors import DesignFailed, InvalidController, SpecMismatch, UnknownName
from upright.execution.execute_sketch import CORE, SketchExecutor
from upright.experiment import Push, run
from upright.firmware import generate
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.loops.analysis import analyse
from upright.loops.loop import Loop
from upright.robots import Battery, Kit, Robot, Sensor
from upright.signals import STATE_NAMES

# An acrylic robot with 65 mm wheels, geared motors and two lithium cells, as many are built; its numbers are guesses.
M, m, R, L, J, JW, JM = 0.65, 0.035, 0.0325, 0.07, 0.0018, 2.5e-5, 5e-4
KT, KB, RM, FM, G = 0.20, 0.30, 5.0, 5e-4, 9.81
VOLTS = 7.4
ROBOT = Robot.preset("nxtway-gs").replace(
    body_mass=M, wheel_mass=m, wheel_radius=R, com_height=L, pitch_inertia=J, wheel_inertia=JW, rotor_inertia=JM,
    torque_constant=KT, back_emf=KB, motor_resistance=RM, motor_friction=FM, gear_ratio=1.0, track=0.15,
    coulomb_friction=0.0, rolling_friction=0.0, wheel_friction=0.0, yaw_inertia=0.0012, roll_inertia=0.002,
)  # fmt: skip
SENSORS = {"sensor/gyro": Sensor(noise=0.002), "sensor/pitch": Sensor(noise=0.002)}
KIT = Kit(name="uno", sensors=SENSORS, battery=Battery(voltage=VOLTS), period=0.01)
ENCODED = replace(KIT, sensors=SENSORS | dict.fromkeys(("sensor/encoder_left", "sensor/encoder_right"), Sensor()))
CLASSIC: dict[str, Any] = {"kp": 50.0, "ki": 60.0, "kd": 1.4}  # PWM of 255 for a degree


def plane() -> tuple[np.ndarray, np.ndarray]:
    """ẋ = A x + b v of pitch, its rate and the wheels' rate, both motors at v [V]: Lagrange's equations, linear."""
    mixed = M * L * R - 2 * JM
    E = np.array([[(2 * m + M) * R * R + 2 * JW + 2 * JM, mixed], [mixed, M * L * L + J + 2 * JM]])
    alpha, beta = KT / RM, KT * KB / RM + FM
    # rows θ̈, ψ̈; columns ψ, ψ̇, θ̇, v
    F = np.array([[0, 2 * beta, -2 * beta, 2 * alpha], [M * G * L, -2 * beta, 2 * beta, -2 * alpha]])
    wheel, pitch = np.linalg.solve(E, F)
    A = np.array([[0, 1, 0], pitch[:3], wheel[:3]])
    return A, np.array([0, pitch[3], wheel[3]])


def growth(kp: float, ki: float, kd: float) -> float:
    """The fastest mode [1/s] of that plane in continuous time under kp, ki and kd [V, rad, s]."""
    A, b = plane()
    closed = np.zeros((4, 4))
    closed[:3, :3] = A + np.outer(b, [kp, kd, 0.0])
    closed[:3, 3], closed[3, 0] = b * ki, 1.0
    return float(np.linalg.eigvals(closed).real.max())


@pytest.mark.parametrize("scale", [0.55, 1.0])
@pytest.mark.parametrize("ki", [0.0, 20.0, 60.0, 120.0])
def test_the_loop_grows_as_its_poles_by_hand_do(scale, ki):
    """At .5 ms a loop differs from one in continuous time by about that time's part of its poles, 1 %."""
    volts = scale * VOLTS / 255 * math.degrees(1)
    expected = growth(50 * volts, ki * volts, 1.4 * volts)
    found = pid_angle(ROBOT, KIT, 5e-4, kp=50 * scale, ki=ki * scale, kd=1.4 * scale).design.growth
    assert found == pytest.approx(max(expected, 0.0), rel=0.03, abs=1e-3)
    if ki == 60:
        assert (found > 0.1) == (scale == 0.55)  # half of the voltage: +.15 1/s; all of it: none


def test_no_kp_and_kd_stand_without_ki_and_the_least_ki_is_that_of_the_constant_term():
    least, by_kp = least_integral(sampled(ROBOT, KIT, 5e-4, ("sensor/pitch",)))
    assert abs(by_kp) < 1e-6 * least
    for kp, kd in ((30.0, 1.0), (80.0, 3.0), (300.0, 9.0)):
        assert growth(kp, 0.0, kd) > 0.05
        assert growth(kp, 0.98 * least, kd) > 1e-4
        assert growth(kp, 1.02 * least, kd) < 1e-9
    found = pid_angle(ROBOT, KIT, **CLASSIC | {"ki": 0.0}).design
    assert found.least_ki * VOLTS / 255 * math.degrees(1) == pytest.approx(least, rel=1e-3)
    assert "always leave a growing mode" in said(found)


def said(record: Design) -> str:
    """What a method says of its design."""
    return " ".join(map(str, record.words())).replace("\u00a0", " ")


def simulated(pid: AnglePid, y: np.ndarray) -> list[float]:
    pid.reset()
    return [pid.step(row, np.zeros(6))[0] for row in y]


def builders(y: np.ndarray, dead_band: float = 0.0, limit: float = 255.0) -> list[float]:
    """The program as it stands in a hundred forums, PWM out, its set point 1.5° and D from the angle."""
    out, total, last = [], 0.0, 0.0
    for pitch in y[:, 0]:
        angle = math.degrees(pitch)
        error = angle - 1.5
        total = min(max(total + 60 * error * 0.01, -limit), limit)
        pwm = 50 * error + total + 1.4 * (angle - last) / 0.01
        last = angle
        if pwm > 0:
            pwm += dead_band
        elif pwm < 0:
            pwm -= dead_band
        out.append(min(max(pwm, -limit), limit) / 255 * VOLTS)
    return out


WAVE = np.outer(0.2 * np.sin(np.arange(300) / 20) + 0.05, [1.0, 0.0])


@pytest.mark.parametrize(("dead_band", "limit"), [(0.0, 255.0), (20.0, 255.0), (20.0, 120.0)])
def test_it_commands_what_the_builders_program_does(dead_band, limit):
    own = {"rate": "difference", "set_point": 1.5, "dead_band": dead_band, "limit": limit}
    pid = pid_angle(ROBOT, KIT, **CLASSIC, **own)
    assert pid.spec.reads == ("sensor/pitch",)
    assert simulated(pid, WAVE[:, :1]) == pytest.approx(builders(WAVE, dead_band, limit), abs=1e-9)
    backwards = pid_angle(ROBOT, KIT, **CLASSIC, **own | {"set_point": -1.5}, sign=-1.0)
    assert simulated(backwards, WAVE[:, :1]) == pytest.approx([-u for u in simulated(pid, WAVE[:, :1])], abs=1e-9)


def test_units_and_steps_say_the_same_in_other_words():
    volts = VOLTS / 255
    same = [
        {"kp": 50 * volts, "ki": 60 * volts, "kd": 1.4 * volts, "output": "V"},
        {"kp": 50 / 2.55, "ki": 60 / 2.55, "kd": 1.4 / 2.55, "output": "percent"},
        {"kp": 50 / 255, "ki": 60 / 255, "kd": 1.4 / 255, "output": "duty"},
        {"kp": math.degrees(50), "ki": math.degrees(60), "kd": math.degrees(1.4), "unit": "rad"},
        {"kp": 50, "ki": 0.6, "kd": 140, "per": "step"},  # of 10 ms
    ]
    plain = simulated(pid_angle(ROBOT, KIT, **CLASSIC, rate="difference"), WAVE[:, :1])
    for own in same:
        assert simulated(pid_angle(ROBOT, KIT, **own, rate="difference"), WAVE[:, :1]) == pytest.approx(plain), own


def test_a_scaled_dead_band_ends_at_full_output():
    pid = pid_angle(ROBOT, KIT, kp=50.0, dead_band=20.0, dead_band_form="scaled", rate="difference")
    for angle, pwm in ((1e-9, 20.0), (1.0, 20 + 50 * 235 / 255), (5.1, 255.0), (40.0, 255.0), (0.0, 0.0)):
        assert simulated(pid, np.radians([[angle]]))[0] == pytest.approx(pwm / 255 * VOLTS, abs=1e-6)


CASES = [
    CLASSIC,
    CLASSIC | {"rate": "difference", "filter_time": 0.02, "set_point": 1.0, "dead_band": 15.0, "integral_limit": 40.0},
    CLASSIC | {"filter_time": 0.03, "dead_band": 15.0, "dead_band_form": "scaled", "limit": 200.0},
    CLASSIC | {"k_position": 3.0, "k_speed": 4.0, "set_point": -0.5},
]


@pytest.mark.parametrize("own", CASES)
def test_its_law_commands_what_it_does(own):
    pid = pid_angle(ROBOT, ENCODED, **own)
    text = program(as_law(pid))
    machine, rng = Interpreter(text), np.random.default_rng(3)
    pid.reset()
    for _ in range(60):
        y, r = rng.normal(0, 0.05, len(pid.spec.reads)), rng.normal(0, 0.02, 6)
        given = dict(zip((name.replace("/", "_") for name in pid.spec.reads), y.tolist(), strict=True))
        given |= {f"reference_{name}": value for name, value in zip(STATE_NAMES, r.tolist(), strict=True)}
        out = dict(machine.command(given | {"applied_left": 0.0, "applied_right": 0.0}))
        machine.update()
        assert pid.step(y, r) == pytest.approx((out["command_left"], out["command_right"]), abs=1e-9)


def test_near_rest_it_is_linear_without_its_dead_band():
    own = CASES[1] | {"set_point": 0.0, "dead_band": 0.0}
    pid = pid_angle(ROBOT, KIT, **own)
    linear, rng = near_rest(pid), np.random.default_rng(5)
    assert near_rest(pid_angle(ROBOT, KIT, **CASES[1])).Dy == pytest.approx(linear.Dy)
    pid.reset()
    for _ in range(40):
        y = rng.normal(0, 1e-4, 1)
        assert linear.step(y, np.zeros(6)) == pytest.approx(pid.step(y, np.zeros(6)), abs=1e-12)


@pytest.mark.parametrize("own", CASES)
def test_a_file_brings_it_back(own, tmp_path):
    pid = pid_angle(ROBOT, ENCODED, **own)
    again = read_controller(write_controller(pid, tmp_path / "pid.json"))
    assert isinstance(again, AnglePid)
    assert controller_hash(again) == controller_hash(pid)
    assert again.spec == pid.spec


def test_a_file_may_be_written_by_hand(tmp_path):
    path = tmp_path / "mine.json"
    own = {"kp": 50, "ki": 60, "kd": 1.4, "supply": 7.4, "period": 0.01}
    data = {"file": "upright controller", "version": 1, "form": "pid-angle", "controller": own}
    path.write_text(json.dumps(data))
    assert controller_hash(read_controller(path)) == controller_hash(pid_angle(ROBOT, KIT, **CLASSIC))
    for wrong, error in (({"kq": 1}, UnknownName), ({"kp": "much"}, InvalidController), ({"unit": "turn"}, UnknownName),
                         ({"supply": -1}, InvalidController), ({"dead_band": 300}, InvalidController)):  # fmt: skip
        path.write_text(json.dumps(data | {"controller": own | wrong}))
        with pytest.raises(error) as caught:
            read_controller(path)
        assert "\n" not in str(caught.value)
    path.write_text(json.dumps(data | {"hash": "0"}))
    with pytest.raises(InvalidController, match="take hash"):
        read_controller(path)
    path.write_text('{"file": "upright controller", "version": 1, "form": "pid-angle", "controller": {"kp": 50}}')
    with pytest.raises(InvalidController, match="without period"):
        read_controller(path)


def test_without_numbers_it_finds_gains_that_stand_and_says_what_they_cannot():
    found = pid_angle(ROBOT, KIT)
    volts = found.volts * math.degrees(1)
    assert growth(found.kp * volts, found.ki * volts, found.kd * volts) < 1e-6
    words = said(found.design)
    assert "Nothing holds its position" in words
    assert "With the set point 1° off upright" in words
    assert found.ki > found.design.least_ki
    assert design("pid-angle", ROBOT, KIT).controller.to_json() == found.to_json()


def test_an_error_of_the_set_point_uses_up_the_motors():
    """e' = ψ is constant in the end: the robot leans, its speed and its voltage grow as ramps until all volts are used
    up, and it falls (own simulation, to the lean at which programs stop)."""
    pid = pid_angle(ROBOT, KIT, **CLASSIC)
    time, speed, travel, fell = drift(ROBOT, pid, math.radians(1.0))
    A, b = plane()
    volts = VOLTS / 255 * math.degrees(1)
    x, i, h, passed, way = np.zeros(3), 0.0, 1e-4, 0.0, 0.0
    while abs(x[0]) < 0.8:
        e = x[0] - math.radians(1.0)
        u = np.clip(volts * (50 * e + 60 * i + 1.4 * x[1]), -VOLTS, VOLTS)
        i = float(np.clip(i + h * e, -VOLTS / (volts * 60), VOLTS / (volts * 60)))
        x = x + h * (A @ x + b * u)
        passed, way = passed + h, way + h * R * x[2]
    assert fell
    assert (time, speed, travel) == pytest.approx((passed, R * x[2], way), rel=0.03)


def test_a_cascade_holds_the_position_by_further_linear_rows():
    """Against the same loop in continuous time, of four states, the integral and the filter-free rates."""
    own = CLASSIC | {"k_position": 6.0, "k_speed": 5.0}
    pid = pid_angle(ROBOT, ENCODED, 5e-4, **own)
    volts = VOLTS / 255 * math.degrees(1)
    A3, b3 = plane()
    A, b = np.zeros((4, 4)), np.append(b3, 0.0)
    A[:3, :3], A[3, 2] = A3, 1.0
    error = np.array([1.0, 0.0, math.radians(5.0) * R, math.radians(6.0) * R])
    closed = np.zeros((5, 5))
    closed[:4, :4] = A + np.outer(b, volts * (50 * error + np.array([0, 1.4, 0, 0])))
    closed[:4, 4], closed[4, :4] = b * volts * 60, error
    expected = float(np.linalg.eigvals(closed).real.max())
    found = pid.design
    assert (found.growth > 0) == (expected > 0)
    assert found.growth == pytest.approx(max(expected, 0.0), rel=0.05, abs=1e-3)
    assert "Nothing holds" not in said(found)


def test_what_does_not_fit_is_refused_in_one_line():
    with pytest.raises(SpecMismatch, match=r"no sensor/pitch.*sensors.pitch"):
        pid_angle("nxtway-gs", "nxt")
    with pytest.raises(UnknownName, match="kq"):
        pid_angle(ROBOT, KIT, kq=1.0)
    with pytest.raises(InvalidController, match="takes no numbers"):
        CONTROLLERS["lqg"](ROBOT, ENCODED, 0.01, own={"kp": 1.0})
    with pytest.raises(InvalidController, match="ki without kp"):  # it would be searched, and the answer silent
        pid_angle(ROBOT, KIT, ki=60.0)
    for name, value in {"integral_limit": -3.0, "limit": 0.0, "sign": 2.0}.items():  # named alone, as it came
        with pytest.raises(InvalidController, match=f"^{name} of a pid-angle is {value:g};"):
            pid_angle(ROBOT, KIT, **CLASSIC, **{name: value})
    with pytest.raises(UnknownName, match="did you mean 'pwm'"):
        pid_angle(ROBOT, KIT, **CLASSIC, output="PWM")
    slow = replace(KIT, delay=0.25)
    with pytest.raises(DesignFailed, match=r"no PID on the angle.*ki against"):
        pid_angle(ROBOT, slow)


@pytest.mark.needs("avr-gcc", "simavr", "module:elftools", str(CORE))
@pytest.mark.parametrize("number", ["float", "fixed"])
def test_a_sketch_fuses_the_angle_and_commands_what_the_design_does(number, tmp_path):
    """On a simulated Uno without encoders: ψ⁺ = a (ψ + gyro dt) + (1 − a) tilt, a = τ/(τ + dt), to a raw step."""
    kit = replace(KIT, sensors=SENSORS | {"sensor/pitch": Sensor(time_constant=0.5)})
    pid = pid_angle(ROBOT, kit, **CLASSIC, dead_band=10.0)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("upright.firmware.readings.CALIBRATION_TIME", 0.1)
        made = generate(pid, ROBOT, kit, "arduino", number=number)
    assert "ENCODER" not in made.text
    path = made.write(tmp_path / "balance.ino")[0]
    executor = SketchExecutor(path, made.program, number)
    scales, offset, angle = made.program.scales, 30, 0.0
    battery = round(VOLTS / scales["raw_battery"])
    for _ in range(10):
        executor.step({"raw_gyro": offset, "raw_pitch": 0, "raw_battery": battery})
    for k in range(25):
        tilt, rate = round(300 * math.sin(k / 5)), round(200 * math.cos(k / 5))
        out = executor.step({"raw_gyro": rate + offset, "raw_pitch": tilt, "raw_battery": battery})
        angle = 0.5 / 0.51 * (angle + 0.01 * rate * scales["raw_gyro"]) + 0.01 / 0.51 * tilt * 1e-4
        assert out["raw_pitch"] == pytest.approx(angle * 1e4, abs=2.0)  # a step of either, and of the accelerometer
        y = np.array([out["raw_pitch"] * 1e-4, rate * scales["raw_gyro"]])
        assert out["command_left"] == pytest.approx(pid.step(y, np.zeros(6))[0], abs=1e-3)
        assert out["status"] == 0
    executor.close()


def test_a_sketch_is_refused_without_the_filters_time():
    with pytest.raises(InvalidController, match=r"comes from its chip.*fuses.*sensors.pitch.time_constant"):
        generate(pid_angle(ROBOT, KIT, **CLASSIC), ROBOT, KIT, "arduino")


def test_its_sketch_is_the_same_text_with_its_file(tmp_path: Path) -> None:
    kit = replace(KIT, sensors=SENSORS | {"sensor/pitch": Sensor(time_constant=0.5)})
    pid = pid_angle(ROBOT, kit, **CLASSIC)
    again = read_controller(write_controller(pid, tmp_path / "pid.json"))
    assert generate(again, ROBOT, kit, "arduino").text == generate(pid, ROBOT, kit, "arduino").text


def fused(kp: float, ki: float, kd: float, time: float) -> float:
    """`growth` on an angle fused with that time constant [s]: ẋ_f = ψ̇ + (ψ − R θ̈/g − x_f)/τ; kd acts on the gyro."""
    A, b = plane()
    closed = np.zeros((5, 5))
    closed[:3, :3] = A
    closed += np.outer(np.append(b, [0.0, 0.0]), [0.0, kd, 0.0, ki, kp])
    closed[3, 4] = 1.0
    closed[4] = (np.eye(5)[0] - R / G * closed[2] - np.eye(5)[4]) / time + np.eye(5)[1]
    return float(np.linalg.eigvals(closed).real.max())


@pytest.mark.parametrize("time", [0.1, 0.5, 2.0])
def test_a_fused_angle_grows_where_the_true_one_does_not(time):
    kit = replace(KIT, sensors=SENSORS | {"sensor/pitch": Sensor(time_constant=time)})
    volts = VOLTS / 255 * math.degrees(1)
    pid = pid_angle(ROBOT, kit, 1e-3, **CLASSIC)
    expected = fused(50 * volts, 60 * volts, 1.4 * volts, time)
    assert expected > 0.1
    assert pid.design.growth == pytest.approx(expected, rel=0.01)
    assert "On the true angle it would stand" in said(pid.design)
    least, _ = least_integral(sampled(ROBOT, kit, 1e-3, pid.spec.reads))
    assert fused(300.0, 0.97 * least, 9.0, time) > 1e-4
    assert fused(300.0, 1.03 * least, 9.0, time) < 1e-4


PAGE = Path(__file__).parents[1] / "docs" / "arduino.md"


def test_the_page_for_an_arduino_stays_short_and_its_commands_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert len(PAGE.read_text("utf-8").split()) <= 700
    ran = []
    for words in commands(PAGE):
        if words[1] in ("certify", "tune"):
            continue  # minutes: a test of evidence runs them
        assert main(words[1:]) == 0, (words, capsys.readouterr().err)
        ran.append(words[1])
    assert ran == ["robots", "design", "simulate", "firmware"]
    printed = capsys.readouterr().out
    assert "kp = 50 pwm/deg, ki = 60 pwm/(deg s), kd = 1.4 pwm s/deg" in printed
    seen, by_hand = blocks(PAGE, "text")
    assert seen in printed
    Path("hand.json").write_text(by_hand, "utf-8")
    assert controller_hash(read_controller("hand.json")) == controller_hash(read_controller("mine.json"))


@pytest.mark.evidence
def test_the_slow_commands_of_the_page_run(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for words in commands(PAGE):
        budget = ["--budget", "12", "-n", "100"] if words[1] == "tune" else []
        # a red light has an exit code of its own
        assert main([*words[1:], *budget]) in (0, 3), (words, capsys.readouterr().err)


@pytest.mark.parametrize("own", [{"dead_band": 30.0}, {"rate": "difference", "filter_time": 0.02, "set_point": 0.2}])
def test_the_kernel_does_what_run_does(own):
    """On the equations with the fused angle's own filter, a dead band and the integral's limit: to rounding for 2 s."""
    kit = replace(KIT, sensors={"sensor/gyro": Sensor(), "sensor/pitch": Sensor(time_constant=0.5)})
    pid = pid_angle(ROBOT, kit, kp=50.0, ki=260.0, kd=1.4, integral_limit=60.0, **own)
    start, push = (0.03, 0.0, 0.0, 0.0, 0.0, 0.0), Push(force=0.3, start=0.5)
    log = run(Electronics(NonlinearBody(ROBOT), kit), pid, push, start=start, seconds=2.0)
    batch = FleetBatch(
        parameters=parameters_of(ROBOT), controller=pid, start=start, kit=kit, pushes=[[0.3, math.nan, 0.5, 0.1]]
    )
    result = simulate(batch, 2.0, record=1, channels=("truth/pitch", "truth/wheel", "command/left"))
    assert not result.fell[0]
    for k, channel in enumerate(result.channels):
        assert np.abs(log[channel] - result.trace[0, : len(log), k]).max() < 1e-9, channel


def test_it_says_which_gain_is_wrong():
    """Wheels and body feel the motors' torque τ: E₁₁ θ̈ = τ, E₁₂ θ̈ = M g L ψ − τ where ψ̈ = 0; τ = 2 K_t/R_m kp ψ."""
    moved = (M * L * R - 2 * JM) / ((2 * m + M) * R * R + 2 * JW + 2 * JM)
    hold = M * G * L / (1 + moved) / (2 * KT / RM) / (VOLTS / 255 * math.degrees(1))
    cases = {
        f"kp is too small: gravity alone asks for {hold:.3g}": {"kp": 0.9 * hold, "ki": 1.0},
        "kd has the other sign": {"kp": 50.0, "ki": 60.0, "kd": -1.4},
        "sign = -1": {"kp": -50.0, "ki": -60.0, "kd": -1.4},
    }
    for told, own in cases.items():
        assert told in said(pid_angle(ROBOT, KIT, **own).design), told
    backwards = said(pid_angle(ROBOT, KIT, kp=-50.0, ki=60.0, kd=1.4).design)
    assert "kd" not in backwards.split("falls")[1]  # it is kp that helps the fall
    assert "ki must" not in backwards
    assert "sign = 1." in said(pid_angle(ROBOT, KIT, **CLASSIC, sign=-1.0).design)
    right = pid_angle(ROBOT, KIT, kp=-50.0, ki=-60.0, kd=-1.4, sign=-1.0).design
    assert right.growth == 0.0


def test_it_says_where_its_output_ends_and_what_its_set_point_does():
    tilted = replace(KIT, sensors=SENSORS | {"sensor/pitch": Sensor(offset=math.radians(3.0))})
    own = CLASSIC | {"set_point": 3.0, "limit": 500.0}
    words = said(pid_angle(ROBOT, KIT, **own).design)
    assert "At 5.1° of lean its output is at its limit of 255 pwm" in words  # 255 over 50 for a degree
    assert "A limit of 500 is more than there is" in words
    assert "With the set point 3° off upright" in words
    assert "the set point 3° off" not in said(pid_angle(ROBOT, tilted, **own).design)


def test_gains_that_are_all_too_small_are_told_the_factor():
    """By the poles of the plane in continuous time: at .5 ms they differ by 1 %."""
    small = {name: gain / 30 for name, gain in CLASSIC.items()}
    words = said(pid_angle(ROBOT, KIT, 5e-4, **small).design)
    factor = float(words.split("kp, ki and kd ")[1].split(" times")[0])
    volts = VOLTS / 255 * math.degrees(1)
    kp, ki, kd = (factor * volts * small[name] for name in ("kp", "ki", "kd"))
    assert growth(kp, ki, kd) < 1e-3
    assert growth(kp / 1.5, ki / 1.5, kd / 1.5) > 1e-3


def test_a_cascade_that_reads_both_encoders_alike_has_margins_without_its_heading():
    """Both motors get the same command, so that no loop holds the heading: the whole loop's other poles are those of
    the analysis, and a swing fades with the delay that it is said to bear, and grows with more."""
    pid = pid_angle(ROBOT, ENCODED, **CLASSIC, k_position=6.0, k_speed=5.0)
    found = analyse(pid, ROBOT, ENCODED, robots=[])
    assert found.loop.hidden == ("yaw",)
    model = sampled(ROBOT, ENCODED, 0.01, pid.spec.reads)
    whole = Loop(plant_of(model), controller_of(near_rest(pid), model.delay)).poles()
    np.testing.assert_allclose(np.sort(np.abs(whole)), np.sort(np.abs([*found.poles, 1.0])), atol=1e-6)
    assert found.stable
    assert found.coprime > 1e-3  # with the heading it was 0 to rounding
    assert found.page().verdict.text.template == "stable, but may turn away"
    for share, stands in ((0.9, True), (1.1, False)):
        quiet = dict.fromkeys(ENCODED.sensors, Sensor())
        late = replace(ENCODED, delay=share * found.delay, sensors=quiet)
        body = Electronics(NonlinearBody(ROBOT, period=1e-3), late)
        log = run(body, pid, seconds=8.0, start=[1e-3, 0.0, 0.0, 0.0, 0.0, 0.0])
        swing = np.abs(log["truth/pitch"])
        assert (swing[-100:].max() < swing[:100].max()) == stands  # it fades, or grows to where the motors end


def test_an_unstable_loop_shows_no_margins_but_what_to_do_next():
    result = design("pid-angle", ROBOT, KIT, own=CLASSIC | {"ki": 0.0})
    page = result.page()
    assert page.verdict.level == "bad"
    assert not page.numbers
    assert page.title.template.startswith("Unstable: a small deviation doubles")
    assert page.next[0].command.startswith("upright design pid-angle")


def test_its_margins_are_those_of_what_the_commands_reach():
    """The integral keeps up any constant speed, a mode at z = 1 that no command moves: the rest has margins. The
    lowest gain is that at which ki is what the constant term asks for; the delay that of the loop with it."""
    pid = pid_angle(ROBOT, KIT, **CLASSIC)
    analysis = analyse(pid, ROBOT, KIT)
    both, pitch = analysis.both(), analysis.outputs[0]
    for one in (both, pitch):  # the gyro shows nothing of what is slow
        assert one.gain_low == pytest.approx(pid.design.least_ki / 60, rel=1e-3)
    assert both.delay > 0.005
    for more, stands in ((0.98, True), (1.02, False)):
        late = replace(KIT, delay=more * both.delay)
        assert (pid_angle(ROBOT, late, **CLASSIC).design.growth == 0.0) == stands


@pytest.mark.parametrize("kp", [20.0, 55.0, 100.0])
def test_the_least_ki_of_a_robot_with_friction_in_its_wheels_depends_on_kp(kp):
    """A speed then needs a torque, so that the pitch answers a lasting voltage a little: by the loop's own poles."""
    robot = Robot.preset("tumbller")
    least = pid_angle(robot, "tumbller", kp=kp, kd=0.75).design.least_ki
    assert pid_angle(robot, "tumbller", kp=kp, kd=0.75, ki=0.95 * least).design.growth > 1e-3
    assert pid_angle(robot, "tumbller", kp=kp, kd=0.75, ki=1.05 * least).design.growth == 0.0


def test_a_set_point_of_one_degree_is_told_once():
    """Rounded as it is printed, a set point of 1° is the one degree that is tried of every program."""
    for set_point, times in ((0.0, 1), (1.0, 1), (-1.0, 1), (2.0, 2)):
        words = said(pid_angle(ROBOT, KIT, **CLASSIC, set_point=set_point).design)
        assert words.count("With the set point") == times, set_point


def test_of_dry_friction_it_says_what_the_loop_would_be_without():
    """The mode by hand has none. A linear loop counts it as drag: with .01 N m the mode is more than three times as
    fast."""
    robot = ROBOT.replace(coulomb_friction=0.01)
    volts = 0.55 * VOLTS / 255 * math.degrees(1)
    gains = {name: 0.55 * value for name, value in CLASSIC.items()}
    doubled = math.log(2) / growth(50 * volts, 60 * volts, 1.4 * volts)
    assert f"without it a deviation doubles every {doubled:.2g} s" in said(pid_angle(robot, KIT, **gains).design)
    full = volts / 0.55
    assert growth(50 * full, 42 * full, 1.4 * full) < 1e-9
    assert "without it the loop would stand" in said(pid_angle(robot, KIT, **CLASSIC | {"ki": 42.0}).design)
    assert "dry friction" not in said(pid_angle(ROBOT, KIT, **gains).design)


def test_the_ki_of_a_fused_angle_stands_beside_that_of_the_true_one():
    kit = replace(KIT, sensors=SENSORS | {"sensor/pitch": Sensor(time_constant=0.5)})
    true = pid_angle(ROBOT, KIT, **CLASSIC).design.least_ki
    assert f"on this fused angle, above {true:.3g} on the true one" in said(pid_angle(ROBOT, kit, **CLASSIC).design)


def test_a_fall_that_the_linear_loop_does_not_explain_names_what_decides_it():
    """A gyro's offset b leans the fused angle by b τ: here by 1.4 degrees, which fell this robot, as one degree of the
    set point does (README of shared/cases, no-encoder-pid)."""
    offset = {"sensor/gyro": Sensor(offset=0.05), "sensor/pitch": Sensor(time_constant=0.49)}
    gains = {"kp": 50.0, "ki": 260.0, "kd": 1.4}
    found = design("pid-angle", ROBOT, replace(KIT, sensors=offset), own=gains)
    assert found.release.fell_at is not None
    assert list(map(str, found.reasons)) == ["Without the offsets of its sensors it stands."]
    exact = replace(KIT, sensors=offset | {"sensor/gyro": Sensor()})
    assert not design("pid-angle", ROBOT, exact, own=gains).reasons
