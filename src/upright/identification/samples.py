"""A log as the linear methods take it: both halves of a symmetric robot on an even clock, in the robot's own time.

A robot that is the same on both sides has two decoupled halves: the mean command moves pitch and wheels, the difference
of the commands turns it. Each half is one set of outputs, of which the last is an angle that drives nothing on a level
floor. The delay of a reading, in whole periods, is taken out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.checkup.doctor import contradictions
from upright.checkup.wheels import on_its_wheels
from upright.errors import InvalidLog, UnknownName, check_within
from upright.identification.arx import FirstResponse, arx, first_response
from upright.logs.recording import MOST_HELD_OUT, check_clock, check_complete, check_unit, one_encoder
from upright.pages import Say
from upright.robots import Kit, Robot, Sensor, find_kit
from upright.signals import Log

SOURCES = ("sensors", "states")
FEWEST = 300  # samples for a dynamic model: a past of some 15 periods alone has 50 parameters for each output
SURE = 5.0
"""t-value of the largest response to an unpredicted command below which a log counts as not excited; one in a hundred
thousand logs of noise has one as large among forty."""
QUIET = 4.0  # steps of the gyro (rms) below which its errors are as large as the motion, for `calibrate` as well
UNEVEN = 0.25  # of a period, by which an uneven step differs from it
MOST_UNEVEN = 0.05  # fraction of uneven steps from which the models' clock does not hold
LONGEST = 20  # periods of the longest dead time
READ = 0.5  # a pitch estimate is an output where it leaves less than this of the commands' unpredicted variance
ROUNDING = 0.1  # periods by which a lag may be short of a whole one: a reading must not answer a future command
TRUSTED = 0.1  # least variance that a filter takes for a reading, over what its past leaves unexplained
STATES = {"pitch": ("pitch", "pitch_rate", "wheel_rate", "wheel"), "yaw": ("yaw_rate", "yaw")}


@dataclass(frozen=True, eq=False, kw_only=True)
class Part:
    """One half: `outputs` y (n, outputs) respond to the command u (n,), with `delays` in periods (taken out of y).

    Outputs are "gyro", "pitch" (an estimate), "wheel" (relative to the body), "turn"; or states, where those are known.
    `noise` is the variance of each output by the kit, `trusted` the one that a filter takes.
    """

    name: str
    outputs: tuple[str, ...]
    y: Array
    u: Array
    dt: float
    delays: tuple[int, ...]
    noise: tuple[float, ...]
    states: bool = False
    trusted: tuple[float, ...] = ()

    def cut(self, first: int, last: int) -> Part:
        """The rows from `first` up to `last`."""
        return replace(self, y=self.y[first:last], u=self.u[first:last])


@dataclass(frozen=True, eq=False, kw_only=True)
class Samples:
    """The halves of `robot` that the log moves; the first `fitted` rows are fitted, the rest are held out.

    `sent` counts the periods from a command to the applied one, which is the models' input.
    """

    parts: tuple[Part, ...]
    robot: Robot
    kit: Kit
    dt: float
    fitted: int
    sent: int
    source: str
    log: Log
    notes: tuple[Say, ...] = ()
    held_out: float = 0.25

    def training(self) -> tuple[Part, ...]:
        """The fitted rows of every half."""
        return tuple(part.cut(0, self.fitted) for part in self.parts)


def samples(
    log: Log, robot: Robot, kit: Kit | None = None, *, source: str = "sensors", delay: float | None = None,
    held_out: float = 0.25,
) -> Samples:  # fmt: skip
    """`log` of `robot` under `kit` (default: the robot's own), from "sensors" or from the true "states" of a twin.

    `delay` [s] is the dead time from a command to every sensor, by default that of the responses to unpredicted
    commands. Raises `InvalidLog` for a log that is too short, not even in time, not excited, or of another robot.
    """
    if source not in SOURCES:
        raise UnknownName("source", source, SOURCES)
    check_within("of a log held out", held_out, 0, MOST_HELD_OUT)
    parts_of_robot = kit or find_kit(robot.kit)
    if source == "sensors":
        check_complete(log, robot)
    log, left = on_its_wheels(log, falling=False) if source == "sensors" else (log, None)
    prefix, commands = _commands(log, robot)
    notes = [
        *([left] if left else []),
        *(_contradictions(log, robot) if source == "sensors" else []),
        *_clock(log),
    ]
    halves = _from_states(log, commands) if source == "states" else _from_sensors(log, robot, parts_of_robot, commands)
    notes += _faster(log)
    ready = _ready(halves, log, parts_of_robot, None if delay is None else round(delay / log.period), notes)
    rows = min(len(part.y) for part in ready)
    ready = [part.cut(0, rows) for part in ready]
    sent = _sent(log) if prefix == "applied" else 0
    fitted = round(rows * (1 - held_out))
    return Samples(
        parts=tuple(ready), robot=robot, kit=parts_of_robot, dt=log.period, fitted=fitted, sent=sent, source=source,
        log=log, notes=tuple(notes), held_out=held_out,
    )  # fmt: skip


def _contradictions(log: Log, robot: Robot) -> list[Say]:
    return [
        Say("{fault} The model keeps this fault (`upright doctor --fix`).", fault=fault)
        for fault in contradictions(log, robot)
    ]


def _ready(halves: Sequence[Part], log: Log, kit: Kit, known: int | None, notes: list[Say]) -> list[Part]:
    """The halves in the robot's time; a yaw that no command drives is left out, with a line in `notes`."""
    ready: list[Part] = []
    for half in halves:
        if half.states:
            ready.append(_undelayed(half, half.delays))
            continue
        responses = first_response(half.y, half.u, LONGEST)
        sure = max(response.strength for response in responses) >= SURE
        if half.name == "yaw" and not sure:
            notes.append(Say("The commands of this log do not turn the robot: the model has no yaw."))
        elif known is not None:
            ready.append(_undelayed(half, (known,) * len(responses)))
        elif half.name == "yaw":  # read from the same encoders as the wheels
            ready.append(_undelayed(half, ready[0].delays[-1:]))
        elif sure:
            ready.append(_undelayed(half, _delays(responses, log)))
        else:
            notes += [
                Say(
                    "No output responds to unpredicted commands: dead times are those of the kit '{kit}'.", kit=kit.name
                ),
                Say("The results of regressions are uncertain."),
            ]
            ready.append(_undelayed(half, _kit_delays(half, kit)))
    return ready


def _commands(log: Log, robot: Robot) -> tuple[str, Array]:
    prefix = next((p for p in ("applied", "command") if f"{p}/left" in log and f"{p}/right" in log), "")
    if not prefix:
        raise InvalidLog(
            "the log has no commands", expected="channels applied/left and applied/right",
            hint="name their columns in a mapping; see `upright doctor`",
        )  # fmt: skip
    if len(log) < FEWEST:
        raise InvalidLog(f"the log has {len(log)} samples", expected=f"at least {FEWEST} for a model of its motion")
    check_unit(log, prefix, robot)
    commands = np.column_stack([_whole(log, f"{prefix}/{side}") for side in ("left", "right")])
    if np.ptp(commands, axis=0).max() == 0:
        raise InvalidLog("the commands never change", expected="motors at work", likely="a log of a robot switched off")
    return prefix, commands


def _clock(log: Log) -> list[Say]:
    check_clock(log)
    off = np.abs(np.diff(log.t) / log.period - 1) > UNEVEN
    if off.mean() > MOST_UNEVEN:
        raise InvalidLog(
            f"{off.mean():.0%} of the steps differ from the period of {log.period * 1e3:.3g} ms by a quarter",
            expected="even steps", likely="lost or repeated rows", hint="`upright calibrate` takes any clock",
        )  # fmt: skip
    if off.any():
        count = int(off.sum())
        return [Say("Steps taken as even, though more than a quarter off the period: {n}.", n=count)]
    return []


def _from_sensors(log: Log, robot: Robot, kit: Kit, commands: Array) -> list[Part]:
    left, right = (_wheel(log, side) for side in ("left", "right"))
    body = next((name for name in ("sensor/gyro", "estimate/pitch") if name in log), "")
    if not body:
        raise InvalidLog("the log has no gyro", expected="a channel sensor/gyro (or at least estimate/pitch)")
    encoder = _variance(kit, "sensor/encoder_left", left)
    tilt = _whole(log, body)
    _check_moves(tilt, kit, body)
    first = "gyro" if body == "sensor/gyro" else "pitch"
    u = _half_commands(commands)
    pitch = Part(
        name="pitch", outputs=(first, "wheel"), y=np.column_stack([tilt, (left + right) / 2]), u=u["pitch"],
        dt=log.period, delays=(0, 0), noise=(_variance(kit, body, tilt), encoder / 2),
    )  # fmt: skip
    if first == "gyro" and "estimate/pitch" in log:
        pitch = _with_estimate(pitch, log["estimate/pitch"])
    if "sensor/encoder_left" in log and one_encoder(log):
        return [pitch]
    turn = robot.wheel_radius / robot.track
    yaw = Part(
        name="yaw", outputs=("turn",), y=((right - left) * turn)[:, None], u=u["yaw"], dt=log.period, delays=(0,),
        noise=(2 * turn**2 * encoder,),
    )  # fmt: skip
    return [pitch, yaw]


def _half_commands(commands: Array) -> dict[str, Array]:
    """The command of each half (n,)."""
    return {"pitch": commands.mean(axis=1), "yaw": (commands[:, 1] - commands[:, 0]) / 2}


def _with_estimate(part: Part, estimate: Array) -> Part:
    """`part` with a pitch estimate as an output, if feedback reads it: otherwise the commands would carry information
    that no output has."""
    if not np.isfinite(estimate).all() or np.ptp(estimate) == 0:
        return part
    more = replace(
        part, outputs=(part.outputs[0], "pitch", *part.outputs[1:]), delays=(*part.delays, 0),
        y=np.column_stack([part.y[:, 0], estimate, part.y[:, 1:]]), noise=(part.noise[0], 1e-6, *part.noise[1:]),
    )  # fmt: skip
    return more if _unpredicted(more) < READ * _unpredicted(part) else part


def _unpredicted(part: Part, memory: int = 20) -> float:
    """The variance of the commands that a regression on present and past outputs leaves."""
    rows = np.arange(memory, len(part.u))
    columns = [part.y[rows - i] for i in range(memory + 1)] + [part.u[rows - i, None] for i in range(1, memory + 1)]
    X = np.column_stack([*columns, np.ones(len(rows))])
    return float(np.var(part.u[rows] - X @ np.linalg.lstsq(X, part.u[rows], rcond=None)[0]))


def _from_states(log: Log, commands: Array) -> list[Part]:
    missing = [name for names in STATES.values() for name in names if f"truth/{name}" not in log]
    if missing:
        raise InvalidLog(
            f"the log has no true {missing[0].replace('_', ' ')}", expected="channels truth/…, as in a twin's log",
            hint="identify from its sensors",
        )  # fmt: skip
    parts: list[Part] = []
    for name, u in _half_commands(commands).items():
        states = STATES[name]
        y = np.column_stack([log[f"truth/{state}"] for state in states])
        if np.ptp(u) > 0:
            zeros, noise = (0,) * len(states), (1e-12,) * len(states)
            parts.append(
                Part(name=name, outputs=states, y=y, u=u, dt=log.period, delays=zeros, noise=noise, states=True)
            )
    return parts


def _wheel(log: Log, side: str) -> Array:
    """The wheel's angle relative to the body [rad], summed where only its rate was logged."""
    if f"sensor/encoder_{side}" in log:
        return _whole(log, f"sensor/encoder_{side}")
    if f"sensor/encoder_rate_{side}" in log:
        return np.cumsum(_whole(log, f"sensor/encoder_rate_{side}")) * log.period
    raise InvalidLog(
        f"the log has no {side} encoder", expected="sensor/encoder_left and sensor/encoder_right, or their rates",
        hint="name their columns in a mapping; see `upright doctor`",
    )  # fmt: skip


def _whole(log: Log, name: str) -> Array:
    values = log[name]
    if not np.isfinite(values).all():
        raise InvalidLog(
            f"{name} has {int((~np.isfinite(values)).sum())} gaps (NaN)", hint="`upright doctor LOG --fix NEW.csv`"
        )
    if name.startswith(("sensor/", "estimate/")) and np.ptp(values) == 0:
        raise InvalidLog(f"{name} never changes", expected="a sensor that moves", likely="a sensor that is not plugged")
    return values


def _check_moves(tilt: Array, kit: Kit, name: str) -> None:
    steps = np.abs(np.diff(tilt))
    grain = max(float(steps[steps > 1e-9].min()), kit.sensors.get(name, Sensor()).quantum)
    moved = float(np.std(tilt)) / grain
    if name == "sensor/gyro" and moved < QUIET:
        raise InvalidLog(
            f"the gyro moves by {moved:.1f} of its steps (rms)", expected=f"at least {QUIET:g}: an excited robot",
            likely="a robot that only stands", hint="add an excitation and log again (`upright excite`)",
        )  # fmt: skip


def _variance(kit: Kit, name: str, reading: Array) -> float:
    """Of one reading, as the kit has it, or at least its own grain's."""
    known = kit.sensors.get(name, Sensor())
    steps = np.abs(np.diff(reading))
    grain = float(steps[steps > 1e-9].min()) if (steps > 1e-9).any() else 0.0
    return max(known.noise**2 + known.quantum**2 / 12, min(grain, 1e-3) ** 2 / 12, 1e-12)


def _delays(responses: Sequence[FirstResponse], log: Log) -> tuple[int, ...]:
    """Whole periods after which each output responds to a command: the surest by its response, the others by the
    pendulum's law, or by their own."""
    surest = max(range(len(responses)), key=lambda i: responses[i].strength)
    lag = _pitch_lag(log)
    if lag is None:
        return tuple((r if r.strength >= SURE else responses[surest]).row - 1 for r in responses)
    first = responses[surest].row - 1
    last = len(responses) - 1
    if surest == last:
        return (*(_whole_periods(first + lag / log.period) for _ in range(last)), first)
    return (*(first for _ in range(last)), _whole_periods(first - lag / log.period))


def _kit_delays(part: Part, kit: Kit) -> tuple[int, ...]:
    channels = {"gyro": "sensor/gyro", "pitch": "sensor/gyro", "wheel": "sensor/encoder_left"}
    delays = [kit.delay + kit.sensors.get(channels[name], Sensor()).delay for name in part.outputs]
    return tuple(_whole_periods(seconds / part.dt) for seconds in delays)


def _whole_periods(periods: float) -> int:
    return max(0, math.floor(periods + ROUNDING))


def _faster(log: Log) -> list[Say]:
    """The doctor's finding of a controller that is faster than the log."""
    from upright.checkup.finding import Record
    from upright.checkup.rates import faster_controller

    findings = faster_controller(Record(log.t, _measured(log), dict(log.units)))
    return [Say("{one} {other}", one=f.evidence, other=f.repair) for f in findings]


def _measured(log: Log) -> dict[str, Array]:
    """The channels that a built robot would log, with wheel angles."""
    channels = {name: values for name, values in log.channels.items() if not name.startswith("truth/")}
    if "sensor/encoder_left" not in channels and "sensor/encoder_rate_left" in channels:
        channels |= {f"sensor/encoder_{side}": _wheel(log, side) for side in ("left", "right")}
    return channels


def _pitch_lag(log: Log) -> float | None:
    """The delay [s] of the pitch behind the encoders, by the pendulum's law; None where that is unclear."""
    from upright.checkup.delays import CLEAR
    from upright.checkup.finding import Record
    from upright.checkup.physics import motion

    moved = motion(Record(log.t, _measured(log), dict(log.units)))
    if moved is None or moved.gyro is None:
        return None
    fit = moved.law
    return fit.lag if fit.r2 > CLEAR and fit.values and fit.values[0] > 0 else None


def _undelayed(part: Part, delays: tuple[int, ...]) -> Part:
    """`part` in the robot's time, with the variances that a filter takes (see `TRUSTED`)."""
    rows = len(part.y) - max(delays)
    y = np.column_stack([part.y[shift : shift + rows, i] for i, shift in enumerate(delays)])
    y[:, -1] -= y[0, -1]
    trusted = part.noise
    if not part.states:
        left = arx(y, part.u[:rows], 10).e.var(axis=0)
        trusted = tuple(max(known, TRUSTED * float(v)) for known, v in zip(part.noise, left, strict=True))
    return replace(part, y=y, u=part.u[:rows], delays=delays, trusted=trusted)


def _sent(log: Log) -> int:
    """Periods from a command to the applied one, where the log has both: the shift of their least difference."""
    if "command/left" not in log:
        return 0
    asked, done = log["command/left"], log["applied/left"]
    apart = [float(np.mean((done[m:] - asked[: len(asked) - m]) ** 2)) for m in range(min(LONGEST, len(log) // 4))]
    return int(np.argmin(apart))
