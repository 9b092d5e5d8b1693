"""Robots of other people that turn: a simulator of its own equations, which shares nothing with upright.

Two wheels and a body in the plane, which turn about the vertical as well, by Runge and Kutta's method in steps of
50 µs; dry friction in both gears and under both wheels; a state feedback of a complementary filter. F has 1.2 kg and
50 Hz, G 16 kg, 1.1 m and 100 Hz, H 0.6 kg and 200 Hz. They differ by 15 % from fall to fall, and each file has numbers
that are 1 to 4 % off. A fall counts where the robot stands without the fault. Half of the programs stop at the fall.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import numba
import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm, solve_discrete_are

from planted.foreign import plane
from planted.foreign.case import Case
from upright.robots import Battery, Kit, Robot, Sensor
from upright.robots.robot import Provenance
from upright.signals import Log

Array = NDArray[np.float64]
GRAVITY, STEP, SHARP, FLOOR = 9.81, 5e-5, 0.01, 1.4  # [m/s²], [s], [rad/s] of dry friction, [rad] where it lies
NOISE, TICKS, TILT_NOISE = 0.003, 1000.0, 0.02  # [rad/s] of the gyro, a turn, [rad] of the accelerometer's angle
LOGS_ON, SECONDS, TRIES = 1.3, 9.0, 40


@dataclass(frozen=True)
class Machine:
    """Numbers [SI]; those of wheels, motors and friction are of one side. `gain` is a torque for a volt, or 1."""

    body: float
    wheel: float
    radius: float
    com: float
    inertia: float
    wheel_inertia: float
    rotor: float
    gain: float
    damping: float
    dry: float
    rolling: float
    track: float
    most: float  # [V] of its battery, or N m
    period: float
    drive: str = "voltage"


MACHINES = {
    "F": Machine(1.2, 0.06, 0.04, 0.09, 4e-3, 5e-5, 1e-4, 0.025, 0.0075, 0.008, 0.001, 0.2, 11.7, 0.02),
    "G": Machine(16.0, 1.0, 0.1, 1.1, 3.0, 5e-3, 2e-3, 1.0, 0.02, 0.08, 0.02, 0.5, 7.0, 0.01, "torque"),
    "H": Machine(0.6, 0.03, 0.03, 0.06, 1e-3, 1.5e-5, 4e-5, 0.014, 0.0037, 0.004, 5e-4, 0.14, 7.6, 0.005),
}
FAULTS = {
    "push": (0.6, 3.0), "battery": (0.7, 0.05), "delay": (0.3, 3.0), "gyro-offset": (0.15, 1.5), "gyro-stuck": (1, 1),
    "gyro-scale": (0.6, 0.08), "encoders": (1.5, 4.0), "motor": (1, 1), "slope": (0.08, 0.5), "load": (0.2, 2.0),
    "friction": (0.1, 1.5), "gain": (0.6, 0.1), "half-gyro": (0.5, 0.5),
    "repeats": (0.3, 1.5), "slow-loop": (0.3, 2.0), "let-go": (0.5, 0.05),
}  # fmt: skip
"""Sizes from mild to bad: over the lean that a push makes and the motors bring back; of the voltage; over the time of
falling e-fold; rad/s; –; of the motion; of the motion; –; rad; over the body's mass; over the largest torque; –; of the
motion; how long readings repeat and a period lasts, over the time of falling e-fold; of the gain from the first
row on, of a robot that is let go at a small lean."""
RIGHT = {
    "push": "push too large", "battery": "weak battery", "delay": "delay grown", "gyro-offset": "gyro bias",
    "gyro-stuck": "sensor stuck", "gyro-scale": "sensor mis-scaled", "encoders": "sensor mis-scaled",
    "motor": "motor dead", "slope": "ramp", "load": "load changed", "friction": "wheel jammed", "gain": "gain too low",
    "half-gyro": "sensor mis-scaled", "repeats": "dropped samples",
    "slow-loop": "dropped samples", "let-go": "gain too low",
}  # fmt: skip


@numba.njit(cache=True)
def rates(x: Array, u: Array, m: Array) -> Array:
    """The time derivative of pitch, pitch rate, wheel, wheel rate, yaw, yaw rate under two commands; `m` are numbers of
    the machine, of each side's motor, and of what acts on it."""
    body, wheel, radius, com, inertia, turning, rotor, dry, rolling, track = m[:10]
    gains, dampings, stiff, slope, force, height = m[10:12], m[12:14], m[14:16], m[16], m[17], m[18]
    sin, cos = math.sin(x[0]), math.cos(x[0])
    a11 = (body + 2 * wheel) * radius**2 + 2 * turning + 2 * rotor
    a12 = body * com * radius * cos - 2 * rotor
    a22 = body * com**2 + inertia + 2 * rotor
    half = track / (2 * radius) * x[5]
    torques, floors = np.zeros(2), np.zeros(2)
    for i in range(2):
        turn = x[3] + (2 * i - 1) * half
        slip = turn - x[1]
        torques[i] = gains[i] * u[i] - dampings[i] * slip - (dry + stiff[i]) * math.tanh(slip / SHARP)
        floors[i] = torques[i] - rolling * math.tanh(turn / SHARP)
    g1 = floors.sum() + body * com * radius * x[1] ** 2 * sin + force * radius
    g1 -= (body + 2 * wheel) * GRAVITY * radius * math.sin(slope)
    g2 = -torques.sum() + body * GRAVITY * com * math.sin(x[0] - slope) + force * height * cos
    g2 += body * com**2 * x[5] ** 2 * sin * cos
    det = a11 * a22 - a12 * a12
    about = inertia + wheel * track**2 / 2 + track**2 / (2 * radius**2) * (turning + rotor) + body * com**2 * sin**2
    out = np.zeros(6)
    out[0], out[2], out[4] = x[1], x[3], x[5]
    out[3], out[1] = (a22 * g1 - a12 * g2) / det, (a11 * g2 - a12 * g1) / det
    out[5] = track / (2 * radius) * (floors[1] - floors[0]) / about
    return out


@numba.njit(cache=True)
def moved(x: Array, u: Array, m: Array, steps: int) -> Array:
    """The state some steps later; a robot that lies rolls on."""
    for _ in range(steps):
        if abs(x[0]) > FLOOR:
            x[0], x[1], x[5] = math.copysign(FLOOR + 1e-9, x[0]), 0.0, 0.0
            x[2], x[3] = x[2] + STEP * x[3], x[3] * (1 - 5 * STEP)
            continue
        a = rates(x, u, m)
        b = rates(x + STEP / 2 * a, u, m)
        c = rates(x + STEP / 2 * b, u, m)
        d = rates(x + STEP * c, u, m)
        x = x + STEP / 6 * (a + 2 * b + 2 * c + d)
    return x


def numbers(bot: Machine) -> Array:
    """A machine as `rates` takes it, without fault, slope and push."""
    plain = (bot.body, bot.wheel, bot.radius, bot.com, bot.inertia, bot.wheel_inertia, bot.rotor, bot.dry, bot.rolling)
    return np.array([*plain, bot.track, bot.gain, bot.gain, bot.damping, bot.damping, 0, 0, 0, 0, bot.com], dtype=float)


def linear(bot: Machine) -> tuple[Array, Array]:
    """A and b of pitch, pitch rate, wheel and wheel rate for one command to both motors, without dry friction."""
    m, places, h = numbers(replace(bot, dry=0.0, rolling=0.0)), [0, 1, 2, 3], 1e-6
    A = np.column_stack([rates(h * np.eye(6)[i], np.zeros(2), m)[places] / h for i in places])
    return A, rates(np.zeros(6), np.full(2, h), m)[places] / h


def law(bot: Machine) -> tuple[Array, float]:
    """A gain for pitch, pitch rate, wheel and wheel rate, and the time in which the robot falls e-fold [s]."""
    A, b = linear(bot)
    whole = np.zeros((5, 5))
    whole[:4, :4], whole[:4, 4] = A, b
    discrete = expm(whole * bot.period)
    Ad, bd = discrete[:4, :4], discrete[:4, 4:]
    pole = float(np.linalg.eigvals(A).real.max())
    Q = np.diag([1 / 0.1**2, 1 / (0.2 * pole) ** 2, (bot.radius / 0.3) ** 2, (bot.radius / 0.4) ** 2])
    R = np.array([[1 / (0.4 * bot.most) ** 2]])
    P = solve_discrete_are(Ad, bd, Q, R)
    return np.linalg.solve(R + bd.T @ P @ bd, bd.T @ P @ Ad)[0], 1 / pole


@dataclass(frozen=True)
class Fault:
    """What happens from its onset on; of one `side` (0 left, 1 right, 2 both) where it is of a motor."""

    cause: str
    onset: float
    size: float
    sign: float
    side: int


def in_steps(angles: Array) -> Array:
    """What an encoder shows of angles [rad]."""
    return np.floor(angles * TICKS / math.tau) * math.tau / TICKS


def flown(bot: Machine, fault: Fault | None, seed: int) -> tuple[dict[str, Array], float]:
    """What the program logs, and when the robot leaned by 0.7 rad [s] (infinite: it stands)."""
    rng = np.random.default_rng([seed, 1])
    K, efold = law(bot)
    usual, x, past, tilt, last, speed = numbers(bot), np.zeros(6), [np.zeros(2)], 0.0, 0.0, 0.0
    x[0], stuck, rows, fell_at, t = 0.01, 0.0, list[tuple[float, ...]](), math.inf, 0.0
    offset, knocks, knock = rng.normal(0, 0.005), rng.uniform(0.8, 6.0, 2), rng.normal(0, 0.15, 2)
    stops, first, width, impulse = bool(rng.random() < 0.5), np.zeros(2), 0.1, lean_of(bot)
    amplitude, slow = rng.uniform(0.1, 0.3) / bot.radius, rng.uniform(0.15, 0.4)
    if fault is not None and fault.cause == "let-go":
        x[0], knocks = fault.sign * rng.uniform(0.02, 0.08), knocks + SECONDS
    read, latest = 0.0, (np.zeros(2), 0.0)
    while t < SECONDS:
        on = fault is not None and t >= fault.onset
        cause, size, sign = (fault.cause, fault.size, fault.sign) if fault is not None and on else ("", 0.0, 1.0)
        m = changed(bot, usual, fault if on else None)
        psi, rate, wheel, _, yaw, _ = x
        half = bot.track / (2 * bot.radius) * yaw
        seen = in_steps(np.array([wheel - half - psi, wheel + half - psi]))
        if cause == "encoders":
            first = seen if not first.any() else first
            seen = first + in_steps(size * (seen - first))
        part = size if cause in ("gyro-scale", "half-gyro") else 1.0
        shown = part * rate + (sign * size if cause == "gyro-offset" else 0.0)
        gyro = stuck = stuck if cause == "gyro-stuck" else shown + offset + rng.normal(0, NOISE)
        held = cause == "repeats" and t < read + size * efold - 1e-9
        seen, gyro = latest if held else (seen, gyro)
        read, latest = read if held else t, (seen, gyro)
        period = max(bot.period, round(size * efold / STEP) * STEP) if cause == "slow-loop" else bot.period
        tilt = 0.995 * (tilt + (gyro - offset) * period) + 0.005 * (psi + rng.normal(0, TILT_NOISE))
        mean = float(seen.mean()) + tilt
        speed, last = 0.6 * speed + 0.4 * (mean - last) / period, mean
        goal, asked = amplitude * math.sin(slow * t), amplitude * slow * math.cos(slow * t)
        u = -float(K @ [tilt, gyro - offset, np.clip(mean - goal, -2, 2), speed - asked])
        u *= size if cause in ("gain", "let-go") else 1.0
        turn = 0.05 * bot.most * float(seen[1] - seen[0])
        command = np.clip(np.array([u + turn, u - turn]), -bot.most, bot.most) * (not (stops and t > fell_at))
        rows.append((t + rng.uniform(-1e-4, 1e-4), *seen, gyro, *command))
        past.append(command)
        late = size * efold / bot.period if cause == "delay" else 0.0
        driven = past[max(0, len(past) - 1 - round(late))] * (size if cause == "battery" else 1.0)
        m[17] += impulse / width * float(knock @ ((knocks <= t) & (t < knocks + width)))
        if fault is not None and cause == "push" and t < fault.onset + width:
            m[17] += sign * size * impulse / width
        x = moved(x, driven, m, round(period / STEP))
        t += period
        if abs(x[0]) > 0.7 and not math.isfinite(fell_at):
            fell_at = t
        if t > fell_at + LOGS_ON:
            break
    names = ("t", "sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "command/left", "command/right")
    return dict(zip(names, np.array(rows).T, strict=True)), fell_at


def changed(bot: Machine, usual: Array, fault: Fault | None) -> Array:
    """The numbers of a machine with a fault."""
    m = usual.copy()
    if fault is None:
        return m
    sides = [0, 1] if fault.side == 2 else [fault.side]
    for i in sides:
        if fault.cause == "motor":
            m[10 + i], m[12 + i] = 0.0, 0.05 * m[12 + i]
        if fault.cause == "friction":
            m[14 + i] = fault.size * bot.gain * bot.most
    if fault.cause == "slope":
        m[16] = fault.sign * fault.size
    if fault.cause == "load":
        more = fault.size * bot.body if fault.sign > 0 else -min(0.8, fault.size) * bot.body
        high = (1.6 if fault.sign > 0 else 1.1) * bot.com
        m[0] += more
        m[3] = (bot.body * bot.com + more * high) / m[0]
        m[4] = max(0.2 * bot.inertia, bot.inertia + bot.body * (bot.com - m[3]) ** 2 + more * (high - m[3]) ** 2)
        m[17], m[18] = 0.0, m[3]
    return m


def lean_of(bot: Machine) -> float:
    """The push [N s] at the centre of mass that the motors just bring back, of the falling mode."""
    A, b = linear(bot)
    values, left = np.linalg.eig(A.T)
    i = int(np.argmax(values.real))
    w = left[:, i].real
    h = 1e-6
    m = numbers(replace(bot, dry=0.0, rolling=0.0))
    m[17] = h
    per_force = rates(np.zeros(6), np.zeros(2), m)[[0, 1, 2, 3]] / h
    return abs(float(w @ b)) * bot.most / float(values.real[i]) / abs(float(w @ per_force))


def owned(bot: Machine, rng: np.random.Generator) -> Robot:
    """The file that its owner would write, with its kit, of numbers that are 1 to 4 % off."""
    true = {
        "wheel_mass": bot.wheel, "wheel_radius": bot.radius, "wheel_inertia": bot.wheel_inertia, "body_mass": bot.body,
        "track": bot.track, "com_height": bot.com, "pitch_inertia": bot.inertia, "yaw_inertia": bot.inertia,
        "roll_inertia": bot.inertia, "rotor_inertia": bot.rotor, "coulomb_friction": bot.dry,
        "rolling_friction": bot.rolling,
    }  # fmt: skip
    if bot.drive == "voltage":
        true |= {"motor_resistance": 4.0, "torque_constant": 4 * bot.gain, "back_emf": 0.9 * bot.damping / bot.gain}
        true |= {"motor_friction": 0.1 * bot.damping}
    else:
        true |= {"motor_friction": bot.damping}
    off = {"wheel_radius": 0.01, "track": 0.01, "body_mass": 0.01, "wheel_mass": 0.01}
    parts = {name: off.get(name, float(rng.uniform(0.02, 0.04))) for name in true}
    values = {name: value * math.exp(rng.normal(0, parts[name])) for name, value in true.items()}
    sources = {name: Provenance("mine", 2 * parts[name] * values[name]) for name in true}
    base = Robot.preset("nxtway-gs" if bot.drive == "voltage" else "twipr")
    quantum = math.tau / TICKS
    sensors = {f"encoder_{side}": Sensor(quantum=quantum) for side in ("left", "right")}
    sensors = {f"sensor/{n}": s for n, s in (sensors | {"gyro": Sensor(noise=NOISE, bias=0.005)}).items()}
    battery = Battery(voltage=bot.most) if bot.drive == "voltage" else Battery()
    kit = replace(Kit.preset("ideal"), name="own", sensors=sensors, period=bot.period, battery=battery)
    if bot.drive == "torque":
        kit = replace(kit, motor=replace(kit.motor, limit=bot.most))
    extra = {"gear_ratio": 1.0, "wheel_friction": 0.0, "stiction_rate": 0.02}
    return replace(base, name="own", drive=bot.drive, kit=kit, **values, **extra, provenance=sources)


def near(name: str, rng: np.random.Generator) -> Machine:
    """A machine of that kind: its numbers differ by 15 %."""
    parts = ("body", "com", "inertia", "gain", "damping", "dry", "rotor", "rolling")
    usual = MACHINES[name]
    bot = replace(usual, **{part: getattr(usual, part) * math.exp(rng.normal(0, 0.15)) for part in parts})
    return replace(bot, gain=1.0) if bot.drive == "torque" else bot


def truth_of(bot: Machine) -> dict[str, float]:
    """Its numbers by the names of a calibration: those of a robot in the plane with both of its wheels in one."""
    flat = plane.Bot(
        bot.body, 2 * bot.wheel, bot.radius, bot.com, bot.inertia, 2 * bot.wheel_inertia, 2 * bot.rotor, bot.gain,
        bot.damping, bot.dry, bot.rolling, late=0.0,
    )  # fmt: skip
    return plane.truth_of(flat)


def case_of(bot: Machine, columns: dict[str, Array], rng: np.random.Generator, **fault: Any) -> Case:
    """The log with what its owner has."""
    channels = {n: v for n, v in columns.items() if n != "t"}
    return Case(Log(np.maximum.accumulate(columns["t"]), channels), owned(bot, rng), truth_of(bot), **fault)


def stand(name: str, seed: int) -> Case:
    """A robot that is driven to and fro, and knocked twice."""
    rng = np.random.default_rng([seed, ord(name)])
    bot = near(name, rng)
    return case_of(bot, flown(bot, None, seed)[0], rng)


def fall(name: str, cause: str, seed: int) -> Case | None:
    """A robot that falls by this cause, and stands without it; None where no size does that."""
    mild, bad = FAULTS[cause]
    for tried in range(TRIES):
        rng = np.random.default_rng([seed, tried, ord(name), *map(ord, cause)])
        bot = near(name, rng)
        level = min(1.0, float(rng.uniform(0, 0.5)) + 0.05 * tried)
        fault = Fault(
            cause, float(rng.uniform(4.0, 6.0)), mild * (bad / mild) ** level, float(rng.choice([-1.0, 1.0])),
            int(rng.integers(3)),
        )  # fmt: skip
        fault = replace(fault, onset=0.0) if cause == "let-go" else fault
        run = int(rng.integers(2**31))
        columns, fell_at = flown(bot, fault, run)
        sound = replace(fault, size=1.0) if cause == "let-go" else None
        if fault.onset + 0.1 < fell_at < SECONDS - 0.5 and math.isinf(flown(bot, sound, run)[1]):
            told = {"cause": cause, "size": fault.size, "onset": fault.onset, "fell_at": fell_at, "side": fault.side}
            return case_of(bot, columns, rng, **told)
    return None
