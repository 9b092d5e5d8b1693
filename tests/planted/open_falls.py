"""Falls by faults that MuJoCo itself makes, listed in the post-mortem or not, and by two faults at once."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from planted import falls as known
from planted.falls import DESIGNS, NO_FALL, ROBOTS, Fault, FaultyBody, FaultyController, NoFall
from upright.bodies.body import REST, Sample
from upright.bodies.mjcf import mjcf
from upright.bodies.twin import Twin, mujoco
from upright.errors import InvalidRobot, UprightError
from upright.experiment import Drive, run
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Kit, Robot
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import Log

LISTED: dict[str, tuple[tuple[str, ...], float, float]] = {
    "sensor mis-scaled": (("gyro", "encoder_left", "encoder_right", "encoders"), 1.3, 4.0),
    "motor dead": (("left", "right", "both", "left braked", "right braked"), 1.0, 1.0),
    "wheel jammed": (("left", "right"), 1.0, 1.0),
    "wall": (("wall", "kerb"), 0.15, 0.8),
    "ramp": (("slope",), 0.06, 0.6),
    "load changed": (("added", "dropped"), 0.1, 2.0),
}
"""Ways, and sizes from mild to bad: a factor (or one over it), –, –, speed [m/s], slope [rad], mass over the body's."""

UNLISTED: dict[str, tuple[tuple[str, ...], float, float]] = {
    "tyre lost": (("left", "right", "both"), 0.85, 0.5),  # what is left of the radius
    "cable": (("side", "back"), 0.05, 2.0),  # [1] force over the weight, at the top, growing within a second
    "stiction": (("both", "left", "right"), 0.1, 3.0),  # dry friction over the motor's largest torque
    "stall": (("loop",), 0.05, 0.5),  # [s] that the loop stands still, three times a second
    "ripple": (("both",), 0.1, 3.0),  # torque over the largest, at 12 times a turn
    "half bridge": (("left", "right", "both"), 1.0, 1.0),  # no current backwards
    "counts lost": (("left", "right", "both"), 0.9, 0.1),  # of the steps in one direction that are counted
    "loose plug": (("left", "right", "both"), 0.4, 0.95),  # part of the time without a motor, in bits of 0.05 to 0.25 s
    "frozen program": (("command",), 0.1, 2.0),  # [s] that one command is held, while rows go on
    "spikes": (("gyro",), 0.05, 0.6),  # of the readings, that are any number up to 3 rad/s
    "clipped": (("gyro",), 1.0, 0.1),  # [rad/s] beyond which it shows no more
}
FRESH: dict[str, tuple[tuple[str, ...], float, float]] = {
    "clutch": (("left", "right", "both"), 0.6, 0.03),  # of the motor's largest torque, beyond which a gear slips
    "wrong sign": (("gyro", "encoder_left", "encoder_right", "left", "right"), 1.0, 1.0),  # of a sensor or a motor
    "hand": (("top",), 0.2, 2.0),  # [s] that a spring holds the body where it was
    "packets": (("sensors",), 2.0, 16.0),  # periods, up to which each reading may be late
    "magnet": (("left", "right", "both"), 0.1, 2.0),  # [rad] of an angle's error, once a turn
    "brown-out": (("reset",), 0.1, 1.0),  # [s] without commands and rows, after which the program begins anew
}
"""Faults that were planted for the last judgement, and that nobody had looked at while the rules were made."""
UNLISTED |= FRESH

PAIRS = (
    ("gyro bias", "push too large"), ("weak battery", "push too large"), ("delay grown", "push too large"),
    ("gyro bias", "weak battery"), ("ramp", "weak battery"), ("sensor mis-scaled", "push too large"),
    ("load changed", "push too large"), ("ramp", "gyro bias"),
)  # fmt: skip
SAME_AS = {
    "stall": ("dropped samples",), "half bridge": ("motor dead",), "counts lost": ("sensor mis-scaled",),
    "stiction": ("wheel jammed",), "cable": ("ramp",), "tyre lost": ("tyre lost",), "ripple": (),
    "loose plug": ("motor dead",), "frozen program": ("dropped samples",), "spikes": (),
    "clipped": ("sensor mis-scaled",),
    "clutch": (), "wrong sign": ("motor or sensor reversed",), "hand": ("push too large", "wall"), "magnet": (),
    "packets": ("delay grown", "dropped samples"), "brown-out": ("dropped samples",),
}  # fmt: skip
"""Answers that say the same as what happened, besides "none of these"."""
NONE = "none of these"
SEED, TRIES, AFTER = 2000, 120, 5.0
APART = 0.4  # [s] at most between the onsets of a pair
WALL_FRICTION = 0.5
BODY, LEFT, RIGHT = 1, 6, 7  # MuJoCo's number of the body, and of both wheels' degrees of freedom


class BrokenBody(FaultyBody):
    """A twin that MuJoCo itself breaks at the fault's onset; `inner` may be another faulty body."""

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        model = self.twin._model
        if not hasattr(self, "usual"):
            names = ("actuator_gainprm", "actuator_biasprm", "dof_frictionloss", "body_mass", "body_ipos",
                     "body_inertia", "geom_size", "actuator_ctrllimited", "actuator_ctrlrange",
                     "actuator_forcelimited", "actuator_forcerange")  # fmt: skip
            self.usual = {name: getattr(model, name).copy() for name in names}
        for name, value in self.usual.items():
            getattr(model, name)[:] = value
        first = super().reset(start, seed)
        self.broken, self.touched, self.lost = False, math.nan, np.zeros(2)
        self.raw, self.chance = first.values, np.random.default_rng([self.seed, 7])
        self.until, self.past, self.shown, self.places = 0.0, list[Any](), 0, ()
        return first

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        t, cause = self.count * self.spec.period, self.fault.cause
        on = t >= self.fault.onset - 1e-9
        if on and not self.broken:
            self.broken, self.start = True, self.raw.copy()
            getattr(self, "_" + cause.replace(" ", "_").replace("-", "_"), lambda: None)()
        since = max(0.0, t - self.fault.onset)
        if on and cause == "ramp":
            disturbance = disturbance._replace(slope=self.fault.sign * self.fault.size * min(1.0, since / 0.2))
        if on and cause == "cable":
            self._pull(min(1.0, since))
        if on and cause == "ripple":
            self._ripple()
        if on and cause == "loose plug" and t >= self.until:
            self._plug(t, off=bool(self.chance.random() < self.fault.size))
        if on and cause == "hand":
            self._hold(free=since > self.fault.size)
        if cause == "wall" and math.isnan(self.touched) and self._touches():
            self.touched = t
        return super().step(command, disturbance)

    def _seen(self, values: Any, on: bool, t: float) -> Any:
        before, self.raw = self.raw, values
        if self.fault.cause == "packets":
            values = self._late(values, on)
        if on and self.fault.cause in ("spikes", "clipped"):
            values, i = values.copy(), self.names.index("sensor/gyro")
            if self.fault.cause == "clipped":
                values[i] = min(max(values[i], -self.fault.size), self.fault.size)
            elif self.chance.random() < self.fault.size:
                values[i] = self.chance.uniform(-3.0, 3.0)
        if on and self.fault.cause == "magnet":
            values = values.copy()
            for i in [self.names.index(name) for name in self._misread()]:
                values[i] += self.fault.size * (math.sin(values[i]) - math.sin(self.start[i]))
        if on and self.fault.cause == "wrong sign" and ("gyro" in self.fault.way or "encoder" in self.fault.way):
            values, i = values.copy(), self.names.index(f"sensor/{self.fault.way}")
            values[i] = (0.0 if "gyro" in self.fault.way else 2 * self.start[i]) - values[i]
        if on and self.fault.cause in ("sensor mis-scaled", "counts lost"):
            values = values.copy()
            for name in self._misread():
                i = self.names.index(name)
                if name == "sensor/gyro":
                    values[i] *= self.fault.size
                elif self.fault.cause == "sensor mis-scaled":
                    values[i] = self.start[i] + self.fault.size * (values[i] - self.start[i])
                else:
                    place = int(name.endswith("right"))
                    self.lost[place] += (1 - self.fault.size) * max(0.0, self.fault.sign * (self.raw[i] - before[i]))
                    values[i] -= self.fault.sign * self.lost[place]
        return super()._seen(values, on, t)

    def _friction(self, grip: float) -> None:
        super()._friction(grip)
        wall = mujoco.mj_name2id(self.twin._model, mujoco.mjtObj.mjOBJ_GEOM, "wall")
        if wall >= 0:
            self.twin._model.geom_friction[wall, 0] = WALL_FRICTION

    def _misread(self) -> list[str]:
        way = self.fault.way
        names = ["encoder_left", "encoder_right"] if way in ("both", "encoders") else [way]
        return [f"sensor/{'encoder_' + n if n in ('left', 'right') else n}" for n in names]

    def _sides(self) -> list[int]:
        return [i for i, side in enumerate(("left", "right")) if side in self.fault.way or "both" in self.fault.way]

    def _motor_dead(self) -> None:
        model = self.twin._model
        for i in self._sides():
            model.actuator_gainprm[i, 0] = 0.0
            if "braked" not in self.fault.way:
                model.actuator_biasprm[i] = 0.0

    def _half_bridge(self) -> None:
        model = self.twin._model
        model.actuator_ctrllimited[self._sides()] = 1
        model.actuator_ctrlrange[self._sides()] = (0.0, 1e6) if self.fault.sign > 0 else (-1e6, 0.0)

    def _wheel_jammed(self) -> None:
        self.twin._model.dof_frictionloss[[LEFT + i for i in self._sides()]] = 1e3

    def _stiction(self) -> None:
        most = self.most * float(self.usual["actuator_gainprm"][0, 0])
        self.twin._model.dof_frictionloss[[LEFT + i for i in self._sides()]] = self.fault.size * most

    def _load_changed(self) -> None:
        """A mass at some height, a little in front or behind, comes or goes."""
        model, robot = self.twin._model, self.twin.spec.robot
        added = self.fault.way == "added"
        mass = self.fault.size * robot.body_mass if added else -min(0.8, self.fault.size) * robot.body_mass
        place = np.array([self.fault.sign * 0.1 * robot.com_height, 0.0, (1.5 if added else 0.8) * robot.com_height])
        old, old_place = robot.body_mass, self.usual["body_ipos"][BODY]
        total = old + mass
        middle = (old * old_place + mass * place) / total
        spread = sum(
            m * ((p - middle) @ (p - middle) - (p - middle) ** 2) for m, p in ((old, old_place), (mass, place))
        )
        model.body_mass[BODY], model.body_ipos[BODY] = total, middle
        model.body_inertia[BODY] = np.maximum(
            self.usual["body_inertia"][BODY] + spread, 1e-7 + 0.1 * self.usual["body_inertia"][BODY]
        )

    def _tyre_lost(self) -> None:
        model = self.twin._model
        for side in [("left", "right")[i] for i in self._sides()]:
            geom = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, side)
            model.geom_size[geom, [0, 2]] *= self.fault.size

    def _pull(self, grown: float) -> None:
        robot, data = self.twin.spec.robot, self.twin._data
        force = self.fault.sign * self.fault.size * robot.body_mass * robot.gravity * grown
        yaw = 2 * math.atan2(data.qpos[6], data.qpos[3])
        way = yaw + (math.pi / 2 if self.fault.way == "side" else 0.0)
        data.xfrc_applied[BODY, :3] = force * math.cos(way), force * math.sin(way), 0.0

    def _plug(self, t: float, *, off: bool) -> None:
        model = self.twin._model
        self.until = t + float(self.chance.uniform(0.05, 0.25))
        for i in self._sides():
            model.actuator_gainprm[i, 0] = 0.0 if off else self.usual["actuator_gainprm"][i, 0]
            model.actuator_biasprm[i] = 0.0 if off else self.usual["actuator_biasprm"][i]

    def _hold(self, *, free: bool) -> None:
        """A spring, as stiff as the weight over a centimetre and well damped, between the body and where it was."""
        robot, data = self.twin.spec.robot, self.twin._data
        place = data.xipos[BODY, :2].copy()
        first, before = self.places or (place, place)
        self.places = (first, place)
        stiff = robot.body_mass * robot.gravity / 0.01
        damping = 2 * math.sqrt(stiff * robot.body_mass)
        force = -stiff * (place - first) - damping * (place - before) / self.spec.period
        data.xfrc_applied[BODY, :2] = 0.0 if free else force

    def _late(self, values: Any, on: bool) -> Any:
        """The newest reading that has arrived; none overtakes an earlier one."""
        self.past.append(values)
        now = len(self.past) - 1
        if self.count % self.stride == 0:
            late = int(self.chance.integers(0, round(self.fault.size) + 1)) * self.stride if on else 0
            self.shown = max(self.shown, now - late)
        return self.past[self.shown if on else now]

    def _clutch(self) -> None:
        model = self.twin._model
        most = self.fault.size * self.most * float(self.usual["actuator_gainprm"][0, 0])
        model.actuator_forcelimited[self._sides()] = 1
        model.actuator_forcerange[self._sides()] = (-most, most)

    def _wrong_sign(self) -> None:
        if self.fault.way in ("left", "right"):
            self.twin._model.actuator_gainprm[self._sides(), 0] *= -1

    def _ripple(self) -> None:
        most = self.most * float(self.usual["actuator_gainprm"][0, 0])
        data, model = self.twin._data, self.twin._model
        model.actuator_biasprm[:, 0] = self.fault.size * most * np.sin(12 * data.qpos[7:9])

    def _touches(self) -> bool:
        model, data = self.twin._model, self.twin._data
        wall = mujoco.mj_name2id(model, mujoco.mjtObj.mjOBJ_GEOM, "wall")
        return any(wall in (c.geom1, c.geom2) for c in data.contact[: data.ncon])


def walled(twin: Twin, robot: Robot, place: float, height: float) -> None:
    """A box across the way at `place` [m], `height` [m] high."""
    text = mjcf(robot, timestep=0.00025, contact_time=0.0005, grip=10.0)
    box = (
        f'<geom name="wall" type="box" pos="{place + 0.05} 0 {height / 2}" size="0.05 1 {height / 2}" contype="1" '
        f'conaffinity="0" condim="3" priority="2" friction="{WALL_FRICTION} 0 0"/>'
    )
    twin._holds(text.replace('<body name="body"', box + '<body name="body"', 1))
    twin.reset()


@dataclass(frozen=True, eq=False)
class Broken:
    """One fall: the `causes` that were planted, how, on which robot, and what a real robot would have logged."""

    causes: tuple[str, ...]
    faults: tuple[Fault, ...]
    robot: str
    design: str
    fell_at: float
    log: Log


def fault_of(cause: str, rng: np.random.Generator, tried: float) -> Fault:
    """A fault of either list, or of the nine of `postmortem.py`."""
    every = LISTED | UNLISTED
    if cause not in every:
        return known._fault(cause, rng, tried)
    ways, mild, bad = every[cause]
    onset, sign = float(rng.uniform(2.5, 4.5)), float(rng.choice([-1.0, 1.0]))
    level = min(1.0, float(rng.uniform(0.0, 0.5)) + tried)
    way, size = str(rng.choice(ways)), mild * (bad / mild) ** level
    if cause == "sensor mis-scaled" and sign < 0:
        size = 1 / size
    return Fault(cause, way, onset, size, sign)


def broken(causes: tuple[str, ...], seed: int) -> Broken:
    """A robot that fell for these causes, and that does not fall without any one of them."""
    kind = [ord(c) for c in "+".join(causes)]
    for tried in range(TRIES):
        robot = str(np.random.default_rng([seed, tried // 10, *kind]).choice(ROBOTS))
        rng = np.random.default_rng([seed, tried, *kind])
        nominal = Robot.preset(robot)
        design = str(rng.choice(DESIGNS))
        true = draw(nominal, 1, int(rng.integers(2**31)), Uncertainty.normal(nominal, known._sizes(nominal)))[0]
        level = 0.1 * (tried % 10) - (0.3 if len(causes) > 1 else 0.0)
        faults = [fault_of(cause, rng, level) for cause in causes]
        if len(faults) > 1:
            faults[1] = replace(faults[1], onset=faults[0].onset + float(rng.uniform(0.0, APART)))
        programmes = [known._programme(fault, nominal, Kit.preset(nominal.kit), rng) for fault in faults]
        pushes = programmes[0][0] + [p for one in programmes[1:] for p in one[0] if p.start >= faults[1].onset]
        references = list(programmes[0][1])
        if causes == ("wall",):
            references, faults = [Drive(speed=faults[0].size, start=1.0)], [faults[0]]
        world = (true, robot, design, rng.integers(2**31))
        try:
            got = _run(world, faults, pushes, references)
        except (ValueError, InvalidRobot):  # a drawn robot that no rigid body is
            continue
        if got is None:
            continue
        log, end, onset, skipped = got
        if not end["fell"] or end["seconds"] < max(onset, *(f.onset for f in faults if f.cause != "wall"), 0.0) + 0.1:
            continue
        lesser = [[f for f in faults if f is not one] for one in faults]
        if any(_fell_too(world, some, faults, pushes, references, end["seconds"]) for some in lesser):
            continue
        faults[0] = replace(faults[0], onset=onset)
        real = known._as_real(log, skipped, np.random.default_rng([seed, tried]))
        return Broken(causes, tuple(faults), robot, design, end["seconds"], real)
    raise NoFall(f"none of {TRIES} runs falls by {' and '.join(causes)} alone")


def _fell_too(world: Any, some: list[Fault], faults: list[Fault], pushes: Any, references: Any, end: float) -> bool:
    left_out = [f for f in faults if f not in some and f.cause == "push too large"]
    kept = [p for p in pushes if not any(p.start == f.onset for f in left_out)]
    got = _run(world, some, kept, references, until=end + 1.0)
    return got is None or got[1]["fell"]


def _run(
    world: Any, faults: list[Fault], pushes: list[Any], references: list[Any], until: float = 0.0
) -> tuple[Log, dict[str, Any], float, list[int]] | None:
    true, robot, design, seed = world
    kit, twin = Kit.preset(true.kit), Twin(true)
    calm = Fault(NO_FALL, "none", 99.0, 1.0)
    wall = next((f for f in faults if f.cause == "wall"), None)
    if wall:
        high = 3.0 if wall.way == "wall" else 0.7
        walled(twin, true, wall.size * (wall.onset - 1.2) + true.wheel_radius, high * true.wheel_radius)
    body: Any = None
    for fault in faults or [calm]:
        outer = BrokenBody(twin, kit, fault, int(seed))
        if body is not None:
            outer.inner = body
        body = outer
    usual, idle = known._controller(robot, design), next((f for f in faults if f.cause in IDLE), None)
    law = IDLE[idle.cause](usual, idle) if idle else FaultyController(usual, calm, body)
    seconds = until or max((f.onset for f in faults), default=3.0) + AFTER
    try:
        log = run(body, law, pushes, reference=references, seconds=seconds, seed=int(seed) % 10_000)
    except UprightError:
        return None
    onset = body.touched if wall else faults[0].onset if faults else 0.0
    if wall and math.isnan(onset):
        return None
    return log, log.origin["outcome"], onset, law.skipped


class Stalling(FaultyController):
    """A loop that stands still for a while, three times a second; its rows are missing."""

    def __init__(self, inner: Any, fault: Fault) -> None:
        self.inner, self.fault, self.spec = inner, fault, inner.spec
        self.reset()

    def _stalls(self) -> bool:
        t = self.now * self.spec.period - self.fault.onset
        return t >= 0 and t % (1 / 3) < min(self.fault.size, 0.32)

    def step(self, measurement: Any, reference: Any) -> tuple[float, float]:
        if self._stalls():
            self.skipped.append(self.now)
        else:
            left, right = self.inner.step(measurement, reference)
            self.last = (left, right)
        self.now += 1
        return self.last

    def applied(self, command: Sequence[float]) -> None:
        if not self._stalls():
            self.inner.applied(command)


class Freezing(Stalling):
    """A loop that gives one and the same command for a while, while its rows go on."""

    def _stalls(self) -> bool:
        return 0 <= self.now * self.spec.period - self.fault.onset < self.fault.size

    def step(self, measurement: Any, reference: Any) -> tuple[float, float]:
        command = super().step(measurement, reference)
        self.skipped = []
        return command


class Rebooting(Freezing):
    """A loop that stops, without commands and rows, and begins anew."""

    def step(self, measurement: Any, reference: Any) -> tuple[float, float]:
        if not self._stalls():
            return FaultyController.step(self, measurement, reference)
        self.inner.reset()
        self.skipped.append(self.now)
        self.now, self.last = self.now + 1, (0.0, 0.0)
        return self.last


IDLE = {"stall": Stalling, "frozen program": Freezing, "brown-out": Rebooting}


def right(causes: Sequence[str], verdict: str) -> bool:
    """Whether the answer is the planted cause, both of them, or says that none is known."""
    if len(causes) > 1:
        return all(cause in verdict for cause in causes)
    if causes[0] in UNLISTED:
        return verdict.startswith(NONE) or verdict in SAME_AS[causes[0]]
    return verdict == causes[0]
