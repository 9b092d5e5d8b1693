"""Logs with planted faults, and clean ones: a fault, the code that names it, and what is a false alarm."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.bodies.twin import Twin
from upright.checkup.doctor import Diagnosis
from upright.control import Estimated, bryson, complementary, kalman, lqr_state
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.experiment import Drive, Push, Turn, run
from upright.logs.readers import RawTable
from upright.robots import Kit, Robot
from upright.signals import Log

LEFT, RIGHT, GYRO = "sensor/encoder_left", "sensor/encoder_right", "sensor/gyro"
FORWARD, UP, PITCH = "sensor/accel_forward", "sensor/accel_up", "estimate/pitch"

LARGEST = (0.3, 3.0, 20.0, 30.0, 2.0, 10.0)
"""Deviations that cost as much as a full command: soft enough for a gyro that is 22 ms late."""


@dataclass(frozen=True)
class Setting:
    """A robot, its kit, the price of commands against Bryson's rule, and the size of the excitation."""

    robot: Robot
    kit: Kit
    price: float
    excitation: float


def settings() -> dict[str, Setting]:
    """Three kits and five robots that their controllers hold."""
    taller = {"com_height": 0.05, "pitch_inertia": 0.01, "yaw_inertia": 0.003, "roll_inertia": 0.01}
    bilbo = Robot.preset("twipr").replace(coulomb_friction=0.003, **taller)
    late = dataclasses.replace(Kit.preset("twipr"), delay=0.02)
    return {
        "nxt": Setting(Robot.preset("nxtway-gs"), Kit.preset("nxt"), 4.0, 0.6),
        "nxt, tall": Setting(Robot.preset("herrera2015"), Kit.preset("nxt"), 1.0, 0.6),
        "ev3": Setting(Robot.preset("ev3way"), Kit.preset("ev3"), 4.0, 0.6),
        "ev3, light": Setting(Robot.preset("nxtway-gs-measured"), Kit.preset("ev3"), 4.0, 0.6),
        "torque": Setting(bilbo, late, 1.0, 0.03),
    }


def record(
    name: str, seed: int, *, seconds: float = 12.0, excited: bool = True, pushed: bool = False, driven: bool = True,
    twin: bool = False, dt: float = 0.01, filtered: bool = False, body: Any = None, logged: float = 0.01,
    gain: float = 1.0,
) -> Log:  # fmt: skip
    """A run of that setting, every `dt` [s], logged every `logged` [s]."""
    s = settings()[name]
    rng = np.random.Generator(np.random.Philox(seed + 1000))
    inner = body or (Twin(s.robot) if twin else NonlinearBody(s.robot))
    torque = s.robot.drive == "torque"
    estimator = complementary(s.robot, s.kit, dt, time=1.0) if filtered or torque else kalman(s.robot, s.kit, dt)
    price = np.full(2, s.price / (0.15 if torque else 4.0) ** 2)
    controller: Any = Estimated(lqr_state(s.robot, dt, Q=bryson(LARGEST), R=price), estimator)
    if excited:
        hold = round(0.06 / dt)
        controller = Excited(controller, random_binary(round(seconds / dt), gain * s.excitation, seed, hold))
    weight = s.robot.body_mass * s.robot.gravity
    pushes = [Push(force=0.08 * weight * float(rng.choice([-1, 1])), start=6.0, duration=0.1)] if pushed else []
    speed = float(rng.uniform(0.08, 0.15) * rng.choice([-1, 1]))
    references = [Drive(speed=speed, start=2.0, until=5.0), Turn(rate=0.6, start=7.0, until=9.0)] if driven else []
    log = run(Electronics(inner, s.kit), controller, pushes, reference=references, seconds=seconds, seed=seed)
    if log.origin["outcome"]["fell"]:
        raise UprightError(f"'{name}' fell under seed {seed}", hint="choose another")
    return stripped(log, round(logged / dt))


def stripped(log: Log, every: int = 1) -> Log:
    """Without truth, references, pushes and origin; every so many rows."""
    keep = {
        n: x[::every]
        for n, x in log.channels.items()
        if n.split("/")[0] in ("sensor", "applied", "command", "estimate")
    }
    units = {name: log.unit(name) for name in keep}
    return Log(log.t[::every], keep, units)


def clean(seed: int) -> tuple[str, Log]:
    """The `seed`-th clean log: all settings, with and without excitation, pushes and drives, model and twin."""
    names = list(settings())
    name = names[seed % len(names)]
    excited, pushed = seed % 2 == 0, seed % 3 == 0
    driven = not excited or seed % 4 == 0
    return name, record(
        name,
        seed,
        excited=excited,
        pushed=pushed,
        driven=driven,
        twin=seed % 5 < 2,
        filtered=seed % 7 == 6 and name != "nxt, tall",
    )


def standing(seed: int) -> tuple[str, Log]:
    """The clean log of that seed, or of the next one that does not end in a true fall."""
    for again in range(20):
        try:
            return clean(seed + 1000 * again)
        except UprightError:
            continue
    raise UprightError(f"no clean log near seed {seed}")


def false_alarms(name: str, log: Log, diagnosis: Diagnosis) -> list[str]:
    """Errors and warnings that are not so."""
    kit = settings()[name].kit
    late = {n: kit.sensors[n].delay for n in (GYRO, LEFT)}
    wrong: list[str] = []
    for finding in diagnosis.findings:
        true = finding.severity == "note"
        if finding.code == "delay/sensor":
            true |= abs(finding.fixes[0].numbers[0] - late[finding.channel]) < 0.006
        true |= finding.code == "delay/command" and kit.delay > 0.015
        true |= finding.code == "saturation" and bool(
            (np.abs(log["command/left"]) > np.abs(log["applied/left"]) + 0.3).mean() > 0.002
        )
        wrong += [] if true else [f"{finding.code} {finding.channel}: {finding.evidence}"]
    return wrong


Plant = Callable[[Log, np.random.Generator], Log | RawTable]


def changed(log: Log, changes: dict[str, Any], t: Any = None) -> Log | RawTable:
    """The log with some channels, and perhaps the time, replaced; a table where the time no longer increases."""
    columns = {"t": log.t if t is None else np.asarray(t), **log.channels, **changes}
    return RawTable(columns, dict(log.units))


def rows(log: Log, keep: Any, t: Any = None) -> RawTable:
    """These rows, at their own times or at `t`."""
    return RawTable(
        {"t": log.t[keep] if t is None else t, **{n: x[keep] for n, x in log.channels.items()}}, dict(log.units)
    )


def scaled(factor: float, *names: str) -> Plant:
    return lambda log, _: changed(log, {name: log[name] * factor for name in names if name in log})


def _commands(factor: float, side: str = "") -> Plant:
    names = [f"{p}/{s}" for p in ("applied", "command") for s in ("left", "right") if side in ("", s)]
    return scaled(factor, *names)


def _late(seconds: float, *names: str) -> Plant:
    return lambda log, _: changed(log, {name: np.interp(log.t - seconds, log.t, log[name]) for name in names})


def _percent(log: Log, _: np.random.Generator) -> Log | RawTable:
    names = [f"{p}/{s}" for p in ("applied", "command") for s in ("left", "right")]
    return changed(log, {name: log[name] / log["sensor/battery"] * 100 for name in names})


def _percent_alone(log: Log, rng: np.random.Generator) -> Log | RawTable:
    table = _percent(log, rng)
    assert isinstance(table, RawTable)
    return RawTable({n: x for n, x in table.columns.items() if n != "sensor/battery"}, table.units)


def _integrated(log: Log, _: np.random.Generator) -> Log | RawTable:
    return changed(log, {GYRO: np.cumsum(log[GYRO]) * log.period})


def _rates(log: Log, _: np.random.Generator) -> Log | RawTable:
    return changed(log, {name: np.gradient(log[name], log.t) for name in (LEFT, RIGHT)})


def _swapped(log: Log, _: np.random.Generator) -> Log | RawTable:
    return changed(log, {LEFT: log[RIGHT], RIGHT: log[LEFT]})


def _jitter(log: Log, rng: np.random.Generator) -> Log | RawTable:
    stamps = log.t + rng.uniform(-0.3, 0.3, len(log)) * log.period
    return changed(log, {}, stamps - stamps[0])


def _gap(log: Log, _: np.random.Generator) -> RawTable:
    return rows(log, np.concatenate([np.arange(400), np.arange(480, len(log))]))


def _dropped(log: Log, rng: np.random.Generator) -> RawTable:
    return rows(log, np.sort(rng.choice(len(log), size=int(0.97 * len(log)), replace=False)))


def _held_samples(log: Log, rng: np.random.Generator) -> Log | RawTable:
    gyro = log[GYRO].copy()
    for k in rng.choice(np.arange(1, len(log)), size=len(log) // 12, replace=False):
        gyro[k] = gyro[k - 1]
    return changed(log, {GYRO: gyro})


def _backwards(log: Log, _: np.random.Generator) -> RawTable:
    t = log.t.copy()
    t[700:] -= 6.5
    return rows(log, np.arange(len(log)), t)


def _disordered(log: Log, rng: np.random.Generator) -> RawTable:
    order = np.arange(len(log))
    for k in rng.choice(np.arange(10, len(log) - 10), size=8, replace=False):
        order[[k, k + 1]] = order[[k + 1, k]]
    return rows(log, order)


def _twice(log: Log, rng: np.random.Generator) -> RawTable:
    return rows(log, np.sort(np.concatenate([np.arange(len(log)), rng.choice(len(log), 10, replace=False)])))


def _milliseconds(log: Log, _: np.random.Generator) -> Log | RawTable:
    return changed(log, {}, log.t * 1000)


def _clipped(log: Log, _: np.random.Generator) -> Log | RawTable:
    names = [f"{p}/{s}" for p in ("applied", "command") for s in ("left", "right")]
    level = float(np.quantile(np.abs(log["applied/left"]), 0.85))
    return changed(log, {name: np.clip(log[name], -level, level) for name in names})


def _gyro_clipped(log: Log, _: np.random.Generator) -> Log | RawTable:
    level = float(np.quantile(np.abs(log[GYRO]), 0.93))
    return changed(log, {GYRO: np.clip(log[GYRO], -level, level)})


def _biased(log: Log, _: np.random.Generator) -> Log | RawTable:
    return changed(log, {GYRO: log[GYRO] + 0.12})


def _coarse(log: Log, _: np.random.Generator) -> Log | RawTable:
    step = np.radians(7.5)
    return changed(log, {name: np.round(log[name] / step) * step for name in (LEFT, RIGHT)})


def _leaning(log: Log, _: np.random.Generator) -> Log | RawTable:
    """A complementary filter with a time constant of 0.2 s on the accelerometer's pitch."""
    lean = np.arctan2(-log["sensor/accel_forward"], log["sensor/accel_up"])
    angle = np.zeros(len(log))
    for k in range(1, len(log)):
        angle[k] = 0.95 * (angle[k - 1] + log.period * log[GYRO][k]) + 0.05 * lean[k]
    return changed(log, {"estimate/pitch": angle})


def _held(log: Log, rng: np.random.Generator) -> Log | RawTable:
    """Held by hand from 4 to 5.5 s: nothing moves, the gyro makes its noise."""
    held = (log.t >= 4) & (log.t < 5.5)
    after = log.t >= 5.5
    noise = np.round(rng.normal(0, 0.3, len(log))) * np.radians(1)
    changes = {GYRO: np.where(held, noise, log[GYRO])}
    for name in (LEFT, RIGHT):
        x = log[name]
        stop, go = x[int(np.argmax(held))], x[int(np.argmax(after))]
        changes[name] = np.where(held, stop, np.where(after, x - go + stop, x))
    return changed(log, changes)


@dataclass(frozen=True)
class Case:
    """A fault: how to plant it, on which setting, and the code (and channel) that names it rightly."""

    name: str
    setting: str
    plant: Plant
    code: str
    channel: str = ""
    options: tuple[tuple[str, Any], ...] = ()


class Icy:
    """A twin whose floor is ice between `start` and `stop` [s]: friction of its contacts drops to `grip`."""

    def __init__(self, robot: Robot, start: float, stop: float, grip: float) -> None:
        self._twin = Twin(robot)
        self.spec = self._twin.spec
        self._start, self._stop, self._grip = start, stop, grip
        self._usual = self._twin._model.geom_friction.copy()

    def reset(self, *args: Any, **options: Any) -> Any:
        return self._twin.reset(*args, **options)

    def step(self, *args: Any) -> Any:
        icy = self._start <= self._twin._data.time < self._stop
        self._twin._model.geom_friction[:, 0] = self._grip if icy else self._usual[:, 0]
        return self._twin.step(*args)

    def close(self) -> None:
        self._twin.close()


def _same(log: Log, _: np.random.Generator) -> Log:
    return log


def fallen(seed: int) -> Log:
    """A robot that a push too strong for it throws over, lying for two seconds after."""
    s = settings()["nxt"]
    controller = Estimated(lqr_state(s.robot, 0.01), kalman(s.robot, s.kit, 0.01))
    weight = s.robot.body_mass * s.robot.gravity
    exciting = Excited(controller, random_binary(700, 0.6, seed, 6))
    log = run(
        Electronics(Twin(s.robot), s.kit),
        exciting,
        [Push(force=0.9 * weight, start=6.0, duration=0.25)],
        seconds=8,
        seed=seed,
    )
    return stripped(log)


_FAST = (("dt", 0.002), ("excited", False), ("filtered", True))


def _stuck(channel: str, first: int, last: int | None = None) -> Plant:
    """A sensor that holds the reading of one row up to another."""

    def plant(log: Log, _: np.random.Generator) -> Log | RawTable:
        x = log[channel].copy()
        x[first:last] = x[first]
        return changed(log, {channel: x})

    return plant


def _one_turn(log: Log, _: np.random.Generator) -> Log | RawTable:
    """Encoders that count one turn only, as absolute ones do."""
    return changed(log, {name: log[name] % (2 * np.pi) for name in (LEFT, RIGHT)})


def _eight_bits(log: Log, _: np.random.Generator) -> Log | RawTable:
    """A counter of eight bits, of 1000 counts a turn."""
    step = 2 * np.pi / 1000
    return changed(log, {LEFT: np.round(log[LEFT] / step) % 256 * step})


def _odd_readings(channel: str, value: float) -> Plant:
    """One reading in a hundred is `value`: a bad cable, a lost message."""

    def plant(log: Log, rng: np.random.Generator) -> Log | RawTable:
        x = log[channel].copy()
        x[rng.choice(len(x), len(x) // 100, replace=False)] = value
        return changed(log, {channel: x})

    return plant


def _coarse_clock(log: Log, _: np.random.Generator) -> Log | RawTable:
    """A clock that counts tenths of a second."""
    return RawTable({"t": np.round(log.t, 1), **log.channels}, dict(log.units))


CASES: Sequence[Case] = (
    Case("gyro in degrees", "nxt", scaled(180 / np.pi, GYRO), "units/scale", GYRO),
    Case("gyro in degrees, torque drive", "torque", scaled(180 / np.pi, GYRO), "units/scale", GYRO),
    Case("gyro × 10", "ev3", scaled(10.0, GYRO), "units/scale", GYRO),
    Case("encoders in degrees", "ev3", scaled(180 / np.pi, LEFT, RIGHT), "units/scale", LEFT),
    Case("pitch estimate in degrees", "nxt, tall", scaled(180 / np.pi, PITCH), "units/scale", PITCH),
    Case("per cent for volts", "nxt", _percent, "units/command"),
    Case("per cent, battery not logged", "ev3, light", _percent_alone, "units/command"),
    Case("accelerometer in g", "torque", scaled(1 / 9.81, FORWARD, UP), "units/scale", FORWARD),
    Case("milliseconds for seconds", "ev3", _milliseconds, "time/unit"),
    Case("gyro turned", "nxt", scaled(-1.0, GYRO), "motion/flipped", GYRO),
    Case("both encoders turned", "ev3", scaled(-1.0, LEFT, RIGHT), "motion/flipped", LEFT),
    Case("left encoder turned", "nxt, tall", scaled(-1.0, LEFT), "motion/flipped", LEFT),
    Case("commands turned", "ev3, light", _commands(-1.0), "motion/flipped", "applied/left"),
    Case("right command turned", "nxt", _commands(-1.0, "right"), "motion/flipped", "applied/right"),
    Case("encoders swapped", "nxt", _swapped, "motion/swapped"),
    Case("gyro integrated", "nxt", _integrated, "motion/integrated", GYRO),
    Case("encoder rates for angles", "nxt, tall", _rates, "motion/differentiated", LEFT),
    Case("clock jitter", "nxt", _jitter, "time/jitter"),
    Case("gap of 0.8 s", "ev3", _gap, "time/gap"),
    Case("3 % of the rows dropped", "nxt", _dropped, "time/dropped"),
    Case("8 % of gyro readings repeat", "ev3, light", _held_samples, "samples/repeated", GYRO),
    Case("gyro stuck from the middle on", "nxt", _stuck(GYRO, 600), "channel/stuck", GYRO),
    Case("gyro stuck for 1 s", "ev3", _stuck(GYRO, 400, 500), "channel/stuck", GYRO),
    Case("left encoder stuck for 1 s", "nxt", _stuck(LEFT, 800, 900), "channel/stuck", LEFT),
    Case("encoders count one turn", "nxt", _one_turn, "encoder/wrapped"),
    Case("left counter of 8 bits", "ev3", _eight_bits, "encoder/wrapped", LEFT),
    Case("1 % of gyro readings are 9 rad/s", "nxt", _odd_readings(GYRO, 9.0), "channel/outliers", GYRO),
    Case("1 % of left readings are 20 rad", "ev3", _odd_readings(LEFT, 20.0), "channel/outliers", LEFT),
    Case("clock of tenths of a second", "nxt", _coarse_clock, "time/coarse"),
    Case("rows twice", "ev3", _twice, "time/repeated"),
    Case("time jumps back", "nxt", _backwards, "time/backwards"),
    Case("rows in disorder", "ev3", _disordered, "time/backwards"),
    Case("gyro 40 ms late", "nxt", _late(0.04, GYRO), "delay/sensor", GYRO),
    Case("encoders 50 ms late", "nxt, tall", _late(0.05, LEFT, RIGHT), "delay/sensor", LEFT),
    Case("all sensors 50 ms late", "nxt", _late(0.05, LEFT, RIGHT, GYRO), "delay/command"),
    Case("commands clipped", "nxt", _clipped, "saturation", "applied/left"),
    Case("gyro clipped", "nxt", _gyro_clipped, "saturation", GYRO),
    Case("gyro bias 0.12 rad/s", "ev3", _biased, "gyro/bias", GYRO),
    Case("encoders of 48 steps a turn", "nxt", _coarse, "encoder/grain"),
    Case("accelerometer in the pitch", "torque", _leaning, "estimate/accelerometer", PITCH, (("gain", 3.0),)),
    Case("controller at 2 ms", "nxt", _same, "samples/controller", "", _FAST),
    Case("controller at 2 ms, excited", "ev3", _same, "samples/controller", "", (("dt", 0.002),)),
    Case("held for 1.5 s", "ev3", _held, "segment/still"),
    Case("wheels slip on ice", "nxt", _same, "segment/slip", "", (("ice", True),)),
    Case("falls", "nxt", _same, "segment/fall", "", (("fall", True),)),
)  # fmt: skip


def planted(case: Case, seed: int) -> Log | RawTable:
    """The log of a case with its fault in it."""
    options = dict(case.options)
    if options.pop("fall", False):
        return fallen(seed)
    if options.pop("ice", False):
        options["body"] = Icy(settings()[case.setting].robot, 5.5, 5.7, 0.03)
    log = record(case.setting, seed, **options)
    return case.plant(log, np.random.Generator(np.random.Philox(seed)))


def named(case: Case, diagnosis: Diagnosis) -> bool:
    """Whether the right code is there, on the right channel, and no other error beside it."""
    hits = [f for f in diagnosis.findings if f.code == case.code and case.channel in ("", f.channel)]
    kind = case.code.split("/")[0]
    others = [f for f in diagnosis.findings if f.severity == "error" and f not in hits]
    return bool(hits) and (kind == "time" or not others)
