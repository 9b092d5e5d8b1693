"""A log as input of the predictor: events (commands and raw readings) and the prior of the first state."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from upright.arrays import Array, Mask, Whole
from upright.errors import InvalidLog
from upright.logs.outliers import left_out
from upright.pages import Say
from upright.physics.dynamics import turn_ratio
from upright.physics.sensing import sensor_matrix
from upright.robots import Kit, Robot, Sensor
from upright.robots.drives import COMMAND_UNITS
from upright.signals import SIDES, STATE_NAMES, Log

ROWS = (
    "sensor/encoder_left", "sensor/encoder_right", "sensor/encoder_rate_left", "sensor/encoder_rate_right",
    "sensor/gyro", "sensor/compass",
)  # fmt: skip
SENSOR = {name: next(kind for kind in ("encoder", "gyro", "compass") if kind in name) for name in ROWS}
"""The sensor of each reading: one dead time and one noise for each sensor."""

LONGEST_PAUSE = 10.0
"""[s] A longer step of a log's time is a clock that jumped, or another recording: nobody knows the motion in it."""

STATES = ("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate", "gyro_bias", "compass_offset")
MOST_HELD_OUT = 0.9
"""Of a log: the rest has to tell the robot."""

FEWEST = 100
"""Fewest samples for a calibration."""

FIRST_SPREAD = (0.2, 0.5, 1e-2, 5.0, 1e-2, 2.0, 0.05, 0.5)
"""Standard deviations of the first state before any reading [rad, rad/s]; those of wheel and yaw are relative to the
encoders, whose zero is arbitrary."""
FIRST_READINGS = 7
"""Of a sensor, through which a line gives its first value and slope."""


@dataclass(frozen=True, eq=False, kw_only=True)
class Recording:
    """Events in the order of the log: `kind` (−1: a command, else the row of `rows`), `when` [s], `value` (a reading,
    or the row of `commands` (n, 2)), `fitted` (True for the fitted part, False for the held-out part). `parts` are the
    kit's sensors, by channel. Where the gyro `swings`, it reads the first of two more states instead of the pitch rate.
    """

    rows: tuple[str, ...]
    kind: Whole
    when: Array
    value: Array
    commands: Array
    fitted: Mask
    first: Array
    P0: Array
    period: float
    parts: Mapping[str, Sensor]
    swings: bool = False

    @property
    def sensors(self) -> tuple[str, ...]:
        """The sensors of the log, among encoder, gyro and compass."""
        return tuple(dict.fromkeys(SENSOR[row] for row in self.rows))

    @cached_property
    def judged(self) -> Mask:
        """Which events are readings that are fitted."""
        return self.fitted & (self.kind >= 0)

    def order(self, delays: Mapping[str, float]) -> Whole:
        """Indices of the events in the order of the commands' time, with the delays of the sensors removed; of those at
        one time commands come first, then the rows as they stand."""
        delay = np.array([delays[SENSOR[row]] for row in self.rows] + [0.0])
        by_kind = self._by_kind
        return by_kind[np.argsort((self.when - delay[self.kind])[by_kind], kind="stable")]

    @cached_property
    def _by_kind(self) -> Whole:
        return np.argsort(self.kind, kind="stable").astype(np.int64)

    @cached_property
    def _reads(self) -> tuple[Array, Array, Array]:
        """The sensor matrix is affine: its constant part, and its slopes by W/(2R) and by what is misaligned."""
        at = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
        C = reading_matrix(self.rows, len(self.first), at[0], self.parts, at[1], swings=self.swings)
        return C[..., :1], C[..., 1:2] - C[..., :1], C[..., 2:] - C[..., :1]

    def swinging(self) -> Recording:
        """The same with a gyro that swings: at first as fast as the body, give or take what a rate may be."""
        size = len(self.first)
        spread = FIRST_SPREAD[1] ** 2
        P0 = np.zeros((size + 2, size + 2))
        P0[:size, :size] = self.P0
        P0[size, size], P0[size + 1, size + 1] = self.P0[1, 1] + spread, spread
        P0[1, size] = P0[size, 1] = self.P0[1, 1]
        return replace(self, first=np.append(self.first, [self.first[1], 0.0]), P0=P0, swings=True)

    def reads(self, turn: Array, misaligned: Array) -> Array:
        """The sensor matrix C (rows, states, lanes) for W/(2R) = `turn` (lanes,) and a gyro that reads the part
        `misaligned` (lanes,) of the yaw rate."""
        constant, by_turn, by_misaligned = self._reads
        return constant + by_turn * turn + by_misaligned * misaligned


def jumps(t: Array) -> Whole:
    """The rows before which a clock `t` (n,) [s] jumps; a log of slow rows has a long period, and no jump."""
    steps = np.diff(t)
    usual = float(np.median(steps)) if len(steps) else 0.0
    return np.flatnonzero(steps > max(LONGEST_PAUSE, 100 * usual)) + 1


def check_clock(log: Log) -> None:
    """Raise `InvalidLog` for a log whose clock jumps: no model follows a robot through it."""
    rows = jumps(log.t)
    if len(rows):
        row = int(rows[np.argmax(log.t[rows] - log.t[rows - 1])])
        by = log.t[row] - log.t[row - 1]
        when = log.t[row - 1]
        raise InvalidLog(
            f"the clock jumps by {by:.3g} s after t = {when:.4g} s, at row {row}",
            expected=f"one run without a pause over {LONGEST_PAUSE:g} s",
            likely="two recordings, or a clock that was set",
            hint="upright doctor LOG --fix NEW.csv keeps the longest part",
        )  # fmt: skip


def check_examined(robot: Robot) -> None:
    """Raise `InvalidLog` for a robot of whose logs nothing is learnt yet."""
    if robot.drive == "speed":
        raise InvalidLog(
            f"a log of '{robot.name}', which is driven by wheel speed, is not examined yet",
            expected="a robot that is driven by voltage or torque",
        )


def check_unit(log: Log, prefix: str, robot: Robot) -> None:
    """Raise `InvalidLog` for commands in volts to a robot that gets torques, or torques to one that gets volts, and for
    every log of a speed drive, which no method here examines yet."""
    check_examined(robot)
    unit = log.unit(f"{prefix}/left")
    if unit == "1" and any(log[f"{prefix}/{side}"].any() for side in SIDES):
        raise InvalidLog(
            "the log's commands are a duty, and of what voltage is not known", expected=robot.command_unit,
            hint="upright doctor LOG --robot ROBOT, which repairs it or asks for what a mapping has to state",
        )  # fmt: skip
    if unit in COMMAND_UNITS.values() and unit != robot.command_unit:
        raise InvalidLog(
            Say("the log's commands are in {unit}", unit=unit),
            expected=Say("{unit}, as those of '{robot}'", unit=robot.command_unit, robot=robot.name),
            likely=Say("another robot"), hint=Say("choose the robot of the log (`--robot`)"),
        )  # fmt: skip


def check_complete(log: Log, robot: Robot) -> None:
    """Raise `InvalidLog` for a log that has no encoders, no gyro or no commands, with all that it lacks at once: of a
    duty also the voltage."""
    prefix = commanded(log)
    there = {SENSOR[name] for name in ROWS if name in log}
    lacking = [words for kind, words in (("encoder", "encoders"), ("gyro", "gyro")) if kind not in there]
    lacking += [] if prefix else ["commands"]
    if not lacking:
        return
    duty = prefix and log.unit(f"{prefix}/left") == "1" and robot.command_unit == "V"
    lacking += ["battery voltage (its commands are a duty)"] if duty else []
    *most, last = lacking
    raise InvalidLog(
        f"the log has no {', '.join(most)}{' and no ' if most else ''}{last}",
        expected=f"encoders, a gyro or a tilt, and commands in {robot.command_unit}",
        hint="upright doctor LOG --write-mapping m.toml, and name their columns"
        + (', and under [constants] "sensor/battery" = VOLTS' if duty else ""),
    )


def check_drive(log: Log, robot: Robot) -> None:
    """`check_unit` of a log from a file, which states its unit; one that was made in Python often states none."""
    prefix = commanded(log)
    if prefix and ("file" in log.origin or robot.drive == "speed"):
        check_unit(log, prefix, robot)


def record(log: Log, robot: Robot, kit: Kit, *, skip: float = 0.0, held_out: float = 0.25) -> Recording:
    """The events of `log`. The last fraction `held_out` of its length is not fitted. Readings of the first `skip` [s]
    are omitted, since they respond to commands from before the log; so are the `outliers`.

    Raises `InvalidLog` where there are no commands, fewer than two sensors, or too few samples.
    """
    check_complete(log, robot)
    if len(log) < FEWEST:
        raise InvalidLog(f"the log has {len(log)} samples", expected=f"at least {FEWEST} to calibrate from")
    check_clock(log)
    commands = _commands(log)
    check_drive(log, robot)
    rows = _rows(log)
    last = log.t[0] + (log.t[-1] - log.t[0]) * (1 - held_out)
    kinds = [np.full(len(log), -1)]
    whens = [log.t]
    values = [np.arange(len(log), dtype=np.float64)]
    for row, name in enumerate(rows):
        there = np.isfinite(log[name]) & (log.t >= log.t[0] + skip) & ~left_out(log, name)
        reading = log[name][there]
        kinds.append(np.full(len(reading), row))
        whens.append(log.t[there])
        values.append(np.unwrap(reading) if name == "sensor/compass" else reading)
    when = np.concatenate(whens)
    lines = {name: first_line(t, y) for name, t, y in zip(rows, whens[1:], values[1:], strict=True)}
    first, P0 = _start(log, robot, rows, lines)
    return Recording(
        rows=rows, kind=np.concatenate(kinds).astype(np.int64), when=when, value=np.concatenate(values),
        commands=commands, fitted=when <= last, first=first, P0=P0, period=log.period,
        parts=kit.sensors,
    )  # fmt: skip


def head(recording: Recording, seconds: float) -> Recording:
    """The events of the first `seconds`."""
    keep = recording.when <= recording.when.min() + seconds
    parts = {name: getattr(recording, name)[keep] for name in ("kind", "when", "value", "fitted")}
    return replace(recording, **parts)


def commanded(log: Log) -> str:
    """The prefix of a log's commands: "applied" where logged, else "command", or "" without any."""
    return next((p for p in ("applied", "command") if f"{p}/left" in log and f"{p}/right" in log), "")


def _commands(log: Log) -> Array:
    prefix = commanded(log)
    if not prefix:
        raise InvalidLog(
            "the log has no commands", expected="channels applied/left and applied/right",
            hint="name their columns in a mapping; see `upright doctor`",
        )  # fmt: skip
    commands = np.column_stack([log[f"{prefix}/left"], log[f"{prefix}/right"]])
    if not np.isfinite(commands).all():
        raise InvalidLog(
            f"{prefix}: a command is missing (NaN)", expected="a command in every row", hint="cut the log there"
        )
    return np.ascontiguousarray(commands)


def _rows(log: Log) -> tuple[str, ...]:
    """The raw sensors that vary; two encoders that always agree are one encoder logged twice."""
    rows = [
        name
        for name in ROWS
        if name in log
        and np.ptp(log[name][np.isfinite(log[name])] if np.isfinite(log[name]).any() else np.zeros(1)) > 0
    ]
    if "sensor/encoder_left" in rows and "sensor/encoder_right" in rows and one_encoder(log):
        rows.remove("sensor/encoder_right")
    if not {"encoder", "gyro"} <= {SENSOR[row] for row in rows}:
        still = ", ".join(name for name in ROWS if name in log and name not in rows)
        raise InvalidLog(
            f"raw sensors that move: {', '.join(rows) or 'none'}", expected="both encoders and a gyro",
            likely=f"a plug that is out, since {still} never changes" if still else "",
            hint="name their columns in a mapping; see `upright doctor`",
        )  # fmt: skip
    return tuple(rows)


def one_encoder(log: Log) -> bool:
    """Whether both encoder channels are identical, as in logs of their mean."""
    return np.array_equal(log["sensor/encoder_left"], log["sensor/encoder_right"], equal_nan=True)


def reading_matrix(
    rows: Sequence[str],
    size: int,
    turn: Array,
    sensors: Mapping[str, Sensor],
    misaligned: Array | float = 0.0,
    *,
    swings: bool = False,
) -> Array:
    """The sensor matrix C (rows, states, lanes) of these sensors, for W/(2R) = `turn` (lanes,). One encoder alone reads
    the mean of both wheels, a gyro also the part `misaligned` (lanes,) of the yaw rate, and one that `swings` the last
    state but one instead of the pitch rate."""
    C = np.zeros((len(rows), size, len(turn)))
    C[:, :6] = sensor_matrix(rows, turn, sensors)
    if (alone := [i for i, name in enumerate(rows) if SENSOR[name] == "encoder"]) and len(alone) == 1:
        C[alone[0], STATE_NAMES.index("yaw")] = 0.0
    for i, name in enumerate(rows):
        if SENSOR[name] == "gyro":
            C[i, STATE_NAMES.index("yaw_rate")] = misaligned
        if SENSOR[name] != "encoder":
            C[i, 6 if SENSOR[name] == "gyro" else 7] = 1.0  # its bias
        if swings and SENSOR[name] == "gyro":
            rate = STATE_NAMES.index("pitch_rate")
            C[i, size - 2], C[i, rate] = C[i, rate].copy(), 0.0
    return C


def first_line(t: Array, y: Array) -> tuple[float, float] | None:
    """First value and slope of readings y (n,) at the times t (n,) [s], by a line through the first of them."""
    if len(t) < 3:
        return None
    t = t[:FIRST_READINGS] - t[0]
    y = y[:FIRST_READINGS]
    slope = float(((t - t.mean()) * (y - y.mean())).sum() / max(float(((t - t.mean()) ** 2).sum()), 1e-12))
    return float(y.mean()) - slope * float(t.mean()), slope


def first_wheel_rates(lines: Mapping[str, tuple[float, float] | None]) -> tuple[float, float] | None:
    """First rate of the left and the right wheel relative to the body [rad/s], by the `first_line` of each reading."""
    rates: list[float] = []
    for side in SIDES:
        angle, rate = (lines.get(f"sensor/encoder{kind}_{side}") for kind in ("", "_rate"))
        rates += [rate[0]] if rate else [angle[1]] if angle else []
    return (rates[0], rates[-1]) if rates else None


def _start(
    log: Log, robot: Robot, rows: tuple[str, ...], lines: Mapping[str, tuple[float, float] | None]
) -> tuple[Array, Array]:
    """The first state, which moves as the first readings do, and its covariance. A filter that began at rest would take
    dry friction for holding the wheels of a robot that rolls, and lose it."""
    size = 8 if "sensor/compass" in rows else 7
    left = right = 0.0
    if "sensor/encoder_left" in rows:
        left = _first(log["sensor/encoder_left"])
        right = _first(log["sensor/encoder_right" if "sensor/encoder_right" in rows else "sensor/encoder_left"])
    turn = turn_ratio(robot)
    first = np.zeros(size)
    first[2], first[4] = (left + right) / 2, (right - left) / (2 * turn)
    first[6] = np.nanmean(log["sensor/gyro"])
    if gyro := lines.get("sensor/gyro"):
        first[1] = gyro[0] - first[6]
    if wheels := first_wheel_rates(lines):
        first[3], first[5] = first[1] + sum(wheels) / 2, (wheels[1] - wheels[0]) / (2 * turn)
    if size == 8:
        compass = log["sensor/compass"]
        first[7] = compass[np.isfinite(compass)][0] - first[4]
    P0 = np.diag(np.array(FIRST_SPREAD[:size]) ** 2)
    P0[2, 2] += P0[0, 0]
    P0[0, 2] = P0[2, 0] = P0[0, 0]
    return first, P0


def _first(reading: Array) -> float:
    return float(reading[np.isfinite(reading)][0])


def foreign(logs: Sequence[Log]) -> bool:
    """Whether a log is of no body of ours."""
    return not all("body" in log.origin for log in logs)


def first_noise(recording: Recording) -> dict[str, float]:
    """Variance of each sensor, by its kit and the resolution of its readings."""
    variances: dict[str, float] = {}
    for row, name in enumerate(recording.rows):
        known = recording.parts.get(name, Sensor())
        grain = _grain(recording.value[recording.kind == row])
        variances[SENSOR[name]] = max(known.noise**2 + known.quantum**2 / 12, grain**2 / 12, 1e-10)
    return variances


def _grain(reading: Array) -> float:
    steps = np.abs(np.diff(reading))
    steps = steps[steps > 1e-9]
    return float(steps.min()) if len(steps) else 0.0
