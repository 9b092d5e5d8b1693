"""Robots of other people, without upright: a pendulum on two wheels by its own few equations, logs as they print, and
the robot files that their owners would write.

Everything lies in one plane. The motor is a DC motor behind a gear, with dry friction in it and under the wheels; a
hand may hold the body to a course; the controller is a state feedback of a complementary filter, at the program's
period.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from planted.foreign.case import Case
from upright.calibration.calibration import Calibration
from upright.logs.readers import RawTable
from upright.robots import Robot
from upright.robots.robot import Provenance

Array = NDArray[np.float64]
DEGREE = math.pi / 180
STEP = 2.5e-4  # [s] of Runge and Kutta's method
SHARP = 0.02  # [rad/s] over which dry friction changes its sign
GRAVITY = 9.81


@dataclass(frozen=True)
class Bot:
    """Numbers [SI] of both wheels and rotors together; the motor's gain and damping and the frictions are of one."""

    body: float = 1.08
    wheels: float = 0.09
    radius: float = 0.0325
    com: float = 0.062
    inertia: float = 1.99e-3
    wheel_inertia: float = 5.7e-5
    rotor: float = 2.16e-4  # behind the gear
    gain: float = 0.0535  # [N m/V] at the wheel
    damping: float = 0.0154  # [N m s/rad] at the wheel, back-EMF included
    dry: float = 0.018  # [N m] in the motor
    rolling: float = 0.002  # [N m] under the wheel
    ticks: float = 1320.0  # a turn
    offset: float = -1.7 * DEGREE  # [rad/s] of the gyro
    noise: float = 0.15 * DEGREE
    late: float = 0.005  # [s] the gyro's readings
    battery: float = 11.7
    gains: tuple[float, float, float, float] = (0.7, 30.0, 0.7, 2.4)  # wheel, pitch, wheel rate, pitch rate
    period: float = 0.005
    dead_zone: float = 0.0  # [V] what is not above it moves no motor

    @property
    def masses(self) -> tuple[float, float, float]:
        """a11, a12 (upright), a22 of the equations of motion."""
        a11 = (self.body + self.wheels) * self.radius**2 + self.wheel_inertia + self.rotor
        a12 = self.body * self.com * self.radius - self.rotor
        return a11, a12, self.body * self.com**2 + self.inertia + self.rotor

    @property
    def pole(self) -> float:
        """The unstable pole [1/s] without dry friction."""
        a11, a12, a22 = self.masses
        mass, d = np.array([[a11, a12], [a12, a22]]), 2 * self.damping
        A = np.zeros((3, 3))  # pitch, wheel rate, pitch rate
        A[0, 2] = 1.0
        A[1:, 0] = np.linalg.solve(mass, [0.0, self.body * GRAVITY * self.com])
        A[1:, 1:] = np.linalg.solve(mass, [[-d, d], [d, -d]])
        return float(max(np.linalg.eigvals(A).real))


SMALL = Bot(
    body=0.17, wheels=0.022, radius=0.021, com=0.035, inertia=9.2e-5, wheel_inertia=5.8e-6, rotor=1.1e-5, gain=0.01444,
    damping=2.29e-3, dry=0.002, rolling=2e-4, ticks=600.0, offset=0.6 * DEGREE, noise=0.12 * DEGREE, late=0.004,
    battery=7.6, gains=(0.32, 14.7, 0.41, 0.91), period=0.01,
)  # fmt: skip
"""0.2 kg, wheels of 42 mm: a motor turns its body by 5 rad/s within a row."""


@dataclass(frozen=True)
class Course:
    """What happens: how long it lies [s] and at which lean, is raised, and is held before it is let go and balances for
    `free`; pushes (from, until, newtons) and excitation [V] then; how it ends."""

    free: float = 8.0
    lying: float = 0.0
    lean: float = 1.25
    raised: float = 1.0
    held: float = 0.0
    pushes: Sequence[tuple[float, float, float]] = ()
    excitation: float = 0.0
    falls: bool = False
    jump: float = math.inf  # [s] when the wheel's reference jumps by 2 rad
    scale: tuple[float, float] = (math.inf, 1.0)  # [s, –] from when on the gyro shows so many times the motion
    stiff: tuple[float, float] = (math.inf, 0.0)  # [s, N m] from when on each motor has so much more dry friction


State = tuple[float, float, float, float]
"""Pitch, pitch rate, wheel, wheel rate [rad, rad/s]."""


def _flight(bot: Bot) -> Callable[[State, float, float, float | None, bool], State]:
    """One step of Runge and Kutta of a robot's state under a voltage and a push, the body led by a hand to a goal, or
    on the floor. It is called for each quarter of a millisecond: what does not change is computed once."""
    sin, cos, tanh = math.sin, math.cos, math.tanh
    a11, _, a22 = bot.masses
    lever, weight, arm = bot.body * bot.com * bot.radius, bot.body * GRAVITY * bot.com, bot.com
    gain, damping, dry, radius, rotor, twice = bot.gain, bot.damping, bot.dry, bot.radius, bot.rotor, 2 * bot.rolling

    def rates(
        psi: float, rate: float, turn: float, volts: float, force: float, goal: float | None, floor: bool
    ) -> State:
        slip, tilted = turn - rate, cos(psi)
        a12 = lever * tilted - rotor
        torque = 2 * (gain * volts - damping * slip - dry * tanh(slip / SHARP))
        held = torque - twice * tanh(turn / SHARP) + force * radius
        g1 = held + lever * rate**2 * sin(psi)
        if floor:
            return 0.0, -rate / STEP, turn, g1 / a11
        if goal is not None:
            bent = 400 * (goal - psi) - 40 * rate
            return rate, bent, turn, (g1 - a12 * bent) / a11
        g2 = -torque + weight * sin(psi) + force * arm * tilted
        det = a11 * a22 - a12 * a12
        return rate, (a11 * g2 - a12 * g1) / det, turn, (a22 * g1 - a12 * g2) / det

    def stepped(x: State, volts: float, force: float, goal: float | None, floor: bool) -> State:
        p, q, w, r = x
        u, half = (volts, force, goal, floor), STEP / 2
        a0, a1, a2, a3 = rates(p, q, r, *u)
        b0, b1, b2, b3 = rates(p + half * a0, q + half * a1, r + half * a3, *u)
        c0, c1, c2, c3 = rates(p + half * b0, q + half * b1, r + half * b3, *u)
        d0, d1, d2, d3 = rates(p + STEP * c0, q + STEP * c1, r + STEP * c3, *u)
        return (
            p + STEP * ((a0 + 2 * b0 + 2 * c0 + d0) / 6), q + STEP * ((a1 + 2 * b1 + 2 * c1 + d1) / 6),
            w + STEP * ((a2 + 2 * b2 + 2 * c2 + d2) / 6), r + STEP * ((a3 + 2 * b3 + 2 * c3 + d3) / 6),
        )  # fmt: skip

    return stepped


def _held(course: Course, t: float) -> float:
    """The lean to which a hand, or the floor, brings the body [rad]."""
    since = t - course.lying
    if course.lying and since < course.raised:
        return course.lean * (0.5 + 0.5 * math.cos(math.pi * max(since, 0.0) / course.raised))
    return 0.01 * math.sin(7 * t)


def logged(bot: Bot, course: Course, seed: int = 0) -> dict[str, Array]:
    """Columns in SI units, and ticks of both wheels: `t`, `left`, `right`, `gyro`, `tilt`, `duty` (−1 to 1)."""
    return flown(bot, course, seed)[0]


def flown(bot: Bot, course: Course, seed: int = 0) -> tuple[dict[str, Array], float]:
    """The columns of `logged`, and when it leaned by 0.7 rad after it was let go [s] (infinite: it stands)."""
    rng = np.random.default_rng(seed)
    state = (course.lean if course.lying else 0.0, 0.0, 0.0, 0.0)
    tilt, last, speed, excited, on_floor = state[0], 0.0, 0.0, 0.0, False
    start = course.lying + (course.raised if course.lying else 0.0) + course.held
    past, rows, fell_at = [0.0], list[tuple[float, ...]](), math.inf
    per_row, late, stepped = round(bot.period / STEP), round(bot.late / STEP), _flight(bot)
    for k in range(round((start + course.free + (2.0 if course.falls else 0.0)) / bot.period)):
        t = k * bot.period
        free = t - start
        if free >= course.stiff[0]:
            bot, course = replace(bot, dry=bot.dry + course.stiff[1]), replace(course, stiff=Course.stiff)
            stepped = _flight(bot)
        shown = course.scale[1] if free >= course.scale[0] else 1.0
        gyro = shown * past[max(-len(past), -1 - late)] + bot.offset + rng.normal(0, bot.noise)
        psi, _, wheel, _ = state
        ticks = (wheel - psi) / math.tau * bot.ticks
        tilt = 0.99 * (tilt + (gyro - bot.offset) * bot.period) + 0.01 * (psi + rng.normal(0, 0.02))
        speed, last = 0.7 * speed + 0.3 * (wheel - psi - last) / bot.period, wheel - psi
        volts = 0.0
        if 0 <= free < course.free:
            if k % 6 == 0:
                excited = course.excitation * rng.choice([-1.0, 1.0])
            aim = 2.0 if free > course.jump else 0.0
            errors = (float(np.clip(wheel - aim, -1, 1)), tilt, speed + gyro - bot.offset, gyro - bot.offset)
            volts = sum(g * e for g, e in zip(bot.gains, errors, strict=True)) + excited
        duty = float(np.clip(round(255 * volts / bot.battery), -255, 255)) / 255
        rows.append((t, math.floor(ticks), math.floor(ticks + 0.4), gyro, tilt, duty))
        force = sum(f for a, b, f in course.pushes if a <= free < b)
        hand = free < 0
        goal = _held(course, t) if hand else 0.0
        volts = duty * bot.battery
        volts = volts if abs(volts) > bot.dead_zone else 0.0
        for _ in range(per_row):
            state = stepped(state, volts, force, goal if hand else None, on_floor)
            on_floor |= not hand and abs(state[0]) > 1.3
            past.append(state[1])
        fell_at = min(fell_at, t if not hand and abs(state[0]) > 0.7 else math.inf)
    names = ("t", "left", "right", "gyro", "tilt", "duty")
    return dict(zip(names, np.array(rows).T, strict=True)), fell_at


def arduino(columns: dict[str, Array], bot: Bot) -> dict[str, Array]:
    """As a serial monitor shows it: milliseconds, degrees a second, ticks, 0 to 255 of PWM."""
    pwm = np.rint(255 * columns["duty"])
    return {
        "ms": np.rint(1e3 * columns["t"]), "gyro": np.round(columns["gyro"] / DEGREE, 2), "encL": columns["left"],
        "encR": columns["right"], "pwmL": pwm, "pwmR": pwm + (np.arange(len(pwm)) % 7 == 0),
        "vbat": np.full(len(pwm), bot.battery),
    }  # fmt: skip


def metric(columns: dict[str, Array], bot: Bot) -> RawTable:
    """Seconds, radians and volts, with names that say so."""
    volts = columns["duty"] * bot.battery
    angles = [columns[side] * math.tau / bot.ticks for side in ("left", "right")]
    names = ("time_s", "gyro_radps", "enc_l_rad", "enc_r_rad", "u_l_V", "u_r_V", "vbat")
    values = (columns["t"], columns["gyro"], *angles, volts, volts, np.full(len(volts), bot.battery))
    return RawTable(dict(zip(names, values, strict=True)), source="run.csv")


def known(bot: Bot) -> Robot:
    """The robot's file as its owner would write it: weighed and measured, the rest roughly, nothing of rolling."""
    rough = {
        "wheel_mass": (bot.wheels / 2, 0.03), "wheel_radius": (bot.radius, 0.01), "track": (5 * bot.radius, 0.01),
        "wheel_inertia": (bot.wheel_inertia / 2, 0.2), "body_mass": (bot.body, 0.01), "com_height": (bot.com, 0.12),
        "pitch_inertia": (bot.inertia, 0.25), "yaw_inertia": (bot.inertia, 0.3), "roll_inertia": (bot.inertia, 0.3),
        "rotor_inertia": (bot.rotor / 2, None), "motor_resistance": (4.0, 0.1), "torque_constant": (4 * bot.gain, 0.1),
        "back_emf": (bot.damping / bot.gain, 0.07), "motor_friction": (bot.damping / 30, None),
        "coulomb_friction": (1.4 * bot.dry, None), "gear_ratio": (1.0, 0.0), "wheel_friction": (0.0, None),
    }  # fmt: skip
    sources = {n: Provenance("mine", None if part is None else part * value) for n, (value, part) in rough.items()}
    numbers = {name: value for name, (value, _) in rough.items()}
    return replace(Robot.preset("nxtway-gs"), name="mine", **numbers, provenance=sources)


def truth_of(bot: Bot) -> dict[str, float]:
    """The numbers of a robot, by the names of a calibration; its dry friction is all in the motor."""
    a11, a12, a22 = bot.masses
    weight = bot.body * GRAVITY * bot.com
    return {
        "body_mass": bot.body, "wheel_radius": bot.radius, "com_height": bot.com, "pitch_inertia": bot.inertia,
        "rolling_friction": bot.rolling, "a11": a11, "a12": a12, "a22": a22, "a22/a11": a22 / a11,
        "weight_moment": weight, "weight_moment/a22": weight / a22, "motor_gain": bot.gain,
        "motor_damping": bot.damping, "coulomb_friction": bot.dry, "wheel_friction": 0.0, "unstable_pole": bot.pole,
        "delay/gyro−encoder": bot.late, "rotor_inertia": bot.rotor / 2,
    }  # fmt: skip


def missed(found: Calibration, bot: Bot) -> tuple[int, list[str]]:
    """How many numbers with a known truth are visible, and those whose interval misses it."""
    every = (*found.parameters, *found.combinations, *found.delays)
    seen = {e.name: e for e in every if e.verdict == "visible"}
    names = {name: value for name, value in truth_of(bot).items() if name in seen}
    return len(names), [name for name, value in names.items() if not seen[name].low <= value <= seen[name].high]


MIDDLE = Bot(
    body=0.62, wheels=0.06, radius=0.034, com=0.07, inertia=1.6e-3, wheel_inertia=4e-5, rotor=9e-5, gain=0.045,
    damping=0.012, dry=0.01, rolling=1.2e-3, ticks=1440.0, late=0.003, battery=8.0, gains=(0.6, 26.0, 0.6, 2.0),
    period=0.008,
)  # fmt: skip
ROBOTS = {"small": (SMALL, 9.0, 1.0), "arduino": (Bot(), 12.0, 1.2), "middle": (MIDDLE, 12.0, 1.2)}
"""And seconds of balance, amplitude of the excitation [V]."""
FAULTS = {"push": (0.4, 3.0), "gyro-scale": (0.6, 0.08), "friction": (0.1, 1.5)}
"""Sizes from mild to bad: [m/s] of the body; of the motion; over the motors' largest torque."""
LASTS, LOGS_ON, TRIES = 0.1, 1.3, 20  # [s] a push, [s] after a fall


def stand(name: str, seed: int, dead_zone: float = 0.0) -> Case:
    """A robot that is held for half a second and then balances, excited."""
    bot, free, excitation = ROBOTS[name]
    bot = replace(bot, dead_zone=dead_zone)
    table = metric(logged(bot, Course(free=free, held=0.5, excitation=excitation), seed), bot)
    return Case(table, known(bot), truth_of(bot))


def fall(name: str, cause: str, seed: int) -> Case | None:
    """A robot that falls by this cause, and stands without it; None where no size does that."""
    bot, (mild, bad) = ROBOTS[name][0], FAULTS[cause]
    for tried in range(TRIES):
        rng = np.random.default_rng([seed, tried, *map(ord, name + cause)])
        onset, size = float(rng.uniform(3.0, 5.0)), mild * (bad / mild) ** min(1.0, rng.uniform(0, 0.5) + 0.05 * tried)
        shove = (onset, onset + LASTS, float(rng.choice([-1, 1])) * size * bot.body / LASTS)
        change = {
            "push": {"pushes": (shove,)},
            "gyro-scale": {"scale": (onset, size)},
            "friction": {"stiff": (onset, size * bot.gain * bot.battery)},
        }[cause]
        course = Course(free=onset + 4.0, held=0.5, excitation=0.3)
        columns, fell_at = flown(bot, replace(course, **change), seed)
        start = course.held
        if not start + onset + 0.1 < fell_at < math.inf or math.isfinite(flown(bot, course, seed)[1]):
            continue
        there = columns["t"] < fell_at + LOGS_ON
        table = metric({n: v[there] for n, v in columns.items()}, bot)
        return Case(table, known(bot), truth_of(bot), cause, size, start + onset, fell_at)
    return None
