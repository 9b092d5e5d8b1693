"""Play of a gear: model and twin slacken the encoders alone; two bodies with play between them sway far more."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import odeint

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.certification.certificate import certify
from upright.control import make_controller
from upright.experiment import run
from upright.robots import Kit, Robot
from upright.robots.kit import Motor

ROBOT, NXT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
PLAY = 0.05  # [rad] 3°, as LEGO gears have it
SECONDS, LEAN = 4.0, 0.02
STIFF = 100.0  # [N m/rad] of the teeth: 30 to 1600 give the same sway within 5 %


def ideal(play: float) -> Kit:
    """No noise, quantum, dead zone or delay: what is left to sway is the play."""
    sensors = {name: type(sensor)() for name, sensor in NXT.sensors.items()}
    return Kit(name="play", sensors=sensors, motor=Motor(backlash=play), battery=NXT.battery, period=NXT.period)


def two_bodies(play: float) -> np.ndarray:
    """Pitch [rad] of a robot whose rotors turn free between the flanks of the teeth; both sides alike.

    With δ the rotor's angle at the wheel, less ψ: 2 J δ̈ = 2 (τ − t), where the teeth bear t at ±play/2, and t
    takes the place of the motor's torque in the equations of wheels and body.
    """
    p = ROBOT
    rotor = p.gear_ratio**2 * p.rotor_inertia
    gain = p.gear_ratio * p.torque_constant / p.motor_resistance
    loss = gain * p.back_emf + p.motor_friction  # the back-EMF is of the wheel's rate, as in the robot's file
    reduced = rotor * p.wheel_inertia / (rotor + p.wheel_inertia)
    damping = math.sqrt(STIFF * reduced)  # half of the critical one
    a11 = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia
    a22 = p.body_mass * p.com_height**2 + p.pitch_inertia
    moment = p.body_mass * p.com_height

    def slopes(x: np.ndarray, _: float, volts: float) -> tuple[float, ...]:
        wheel, pitch, turned, wheel_rate, pitch_rate, turn_rate = x.tolist()
        past = turned + pitch - wheel
        rate = turn_rate + pitch_rate - wheel_rate
        teeth = 0.0
        if past > play / 2:
            teeth = max(0.0, STIFF * (past - play / 2) + damping * rate)
        elif past < -play / 2:
            teeth = min(0.0, STIFF * (past + play / 2) + damping * rate)
        a12 = moment * p.wheel_radius * math.cos(pitch)
        right = 2 * teeth + moment * p.wheel_radius * pitch_rate**2 * math.sin(pitch)
        below = moment * p.gravity * math.sin(pitch) - 2 * teeth
        size = a11 * a22 - a12**2
        wheel_up, pitch_up = (a22 * right - a12 * below) / size, (a11 * below - a12 * right) / size
        return wheel_rate, pitch_rate, turn_rate, wheel_up, pitch_up, (gain * volts - loss * turn_rate - teeth) / rotor

    kit = ideal(play)
    controller = make_controller("lqg", ROBOT, NXT, NXT.period)
    controller.reset()
    x = np.array([0.0, LEAN, -LEAN, 0.0, 0.0, 0.0])
    trace = list[float]()
    for _ in range(round(SECONDS / kit.period)):
        read = {"sensor/gyro": x[4], "sensor/encoder_left": x[2], "sensor/encoder_right": x[2]}
        measured = np.array([read.get(name, 0.0) for name in controller.spec.reads])
        volts = float(np.clip(controller.step(measured, np.zeros(6))[0], -kit.battery.voltage, kit.battery.voltage))
        controller.applied((volts, volts))
        trace.append(x[1])
        x = odeint(slopes, x, [0.0, kit.period], args=(volts,), rtol=1e-7, atol=1e-9)[-1]
    return np.array(trace)


def simulated(body: NonlinearBody | Twin, play: float) -> np.ndarray:
    controller = make_controller("lqg", ROBOT, NXT, NXT.period)
    log = run(Electronics(body, ideal(play)), controller, seconds=SECONDS, start=[LEAN, 0.0, 0.0, 0.0, 0.0, 0.0])
    return np.asarray(log["truth/pitch"])


def sway(pitch: np.ndarray) -> float:
    """RMS [°] in the second half."""
    rest = pitch[len(pitch) // 2 :]
    return math.degrees(float(np.std(rest)))


def test_two_bodies_without_play_are_the_model() -> None:
    """Teeth that give by some hundredths of a degree under the motor's torque are all that differs."""
    model = simulated(NonlinearBody(ROBOT), 0.0)[: round(SECONDS / NXT.period)]
    assert np.abs(two_bodies(0.0) - model).max() < 0.02 * LEAN


def test_neither_model_nor_twin_sways_as_two_bodies_with_play_do() -> None:
    """Both slacken what the encoders say, by one formula: at rest the wheels need not cross the play. A motor that
    carries nothing in the gap has to, again and again."""
    model, twin = (sway(simulated(body, PLAY)) for body in (NonlinearBody(ROBOT), Twin(ROBOT)))
    true = sway(two_bodies(PLAY))
    assert true > 0.5  # 0.8° for any stiffness of the teeth
    assert max(model, twin) < true / 3  # 0.13°, what is left of the lean; later 0.002°


@pytest.mark.parametrize("play", [0.0, PLAY])
def test_a_certificate_says_what_it_lacks_where_a_kit_has_play(play: float) -> None:
    kit = replace(NXT, motor=replace(NXT.motor, backlash=play))
    shown = str(certify("pid", ROBOT, kit, samples=100, sweeps=False))
    assert ("2.9° of play" in shown) == bool(play)
