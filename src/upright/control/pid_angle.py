"""PID on the angle: the program that most builders have, in their own numbers and units.

    e = ψ − sign · set point + k_position x + k_speed ẋ,    i⁺ = i + ki e dt within ±`integral_limit`,
    w = sign · (kp e + i⁺ + kd d),    output = w ± `dead_band` (with w's sign) within ±`limit`

ψ is the fused angle `sensor/pitch` and d its rate: the gyro, or the difference of two angles, low-passed over
`filter_time`. The position x of the wheels and its rate ẋ, which lead the set point (a cascade), need encoders.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from upright.arrays import Array
from upright.compiled.tracer import Form, Tracer
from upright.control.controller import ControllerSpec, Lawful
from upright.control.delay import RAW
from upright.control.design import Design
from upright.control.linear_controller import Law, LinearController, Nonlinear
from upright.errors import InvalidController, UnknownName
from upright.physics.sensing import GYRO, PITCH

PER_RADIAN = {"deg": math.degrees(1.0), "rad": 1.0}
FULL = {"pwm": 255.0, "percent": 100.0, "duty": 1.0}
"""Output of a program → its number for the whole supply; any other output is the command itself, in its unit."""
CHOICES = {
    "unit": tuple(PER_RADIAN),
    "per": ("s", "step"),
    "rate": ("gyro", "difference"),
    "dead_band_form": ("added", "scaled"),
}


@dataclass(frozen=True)
class AngleShape:
    """What of the program is not linear, all in command units: i = s + `drift` within ±`integral`, then
    u = w ± `dead_band` within ±`limit`, w = linear command + `trim` + i. The last two come from the set point."""

    trim: float
    drift: float
    integral: float
    dead_band: float
    limit: float

    @property
    def most(self) -> tuple[float, ...]:
        """That of the integral."""
        return (self.integral,)

    @property
    def slope(self) -> Array:
        """Without the dead band: the integral is part of both commands, and of the memory."""
        return np.ones((3, 1))

    def forms(self, t: Tracer, linear: Sequence[Form], s: Sequence[Form], /) -> tuple[list[Form], list[Form]]:
        """The same command for both motors, and the integral."""
        i = self._within(t, "integral", s[0] + self.drift, self.integral)
        w = t.let("angle_command", linear[0] + i + self.trim, "1")
        if self.dead_band:
            negative = t.let("angle_opposite", -w, "1")
            ahead = t.choose(negative, 0.0, self.dead_band, 0.0, "angle_ahead")
            w = w + t.choose(w, 0.0, -self.dead_band, ahead, "angle_push")
        u = self._within(t, "angle_limited", w, self.limit)
        return [u, u], [i]

    @staticmethod
    def _within(t: Tracer, name: str, form: Form, most: float) -> Form:
        free = t.let(f"{name}_free", form, "1")
        return t.limit(free, -most, most, name) if math.isfinite(most) else free

    def output(self, linear: float, s: float) -> tuple[float, float]:
        """The command, and the integral."""
        i = min(max(s + self.drift, -self.integral), self.integral)
        w = linear + self.trim + i
        w += math.copysign(self.dead_band, w) if w else 0.0
        return min(max(w, -self.limit), self.limit), i


@dataclass(eq=False, repr=False, kw_only=True)
class AnglePid(Lawful):
    """The program as a controller of both motors alike, every `period` [s].

    kp, ki and kd are output for one `unit` of angle ("deg", "rad"), one unit second, and one unit in a second; with
    `per` "step" the program knows no time: ki sums angles, and kd takes the difference of two. `set_point` is an angle
    in `unit`; `sign` is -1 for an angle that is positive backwards. `output` is "pwm" (255), "percent", "duty", or the
    `command_unit` itself; the first three are parts of the `supply` [V] that the motors have in fact. `dead_band` is
    added to every output but zero ("added"), or the rest is scaled so that the output still ends at `limit` ("scaled").
    `limit` is the full output where it is not given, and `integral_limit`, of ki Σ e dt, is `limit`. k_position
    [unit/m] and k_speed [unit s/m] need `wheel_radius` [m].

    Raises `InvalidController` for numbers that no program has.
    """

    form: ClassVar[str] = "pid-angle"
    kp: float
    ki: float = 0.0
    kd: float = 0.0
    unit: str = "deg"
    output: str = "pwm"
    per: str = "s"
    sign: float = 1.0
    set_point: float = 0.0
    dead_band: float = 0.0
    dead_band_form: str = "added"
    limit: float = math.inf
    integral_limit: float = math.inf
    filter_time: float = 0.0
    rate: str = "gyro"
    k_position: float = 0.0
    k_speed: float = 0.0
    wheel_radius: float = 0.0
    supply: float = math.inf
    period: float
    command_unit: str = "V"
    design: Design | None = field(default=None, init=False)
    spec: ControllerSpec = field(init=False)

    def __post_init__(self) -> None:
        for name, choices in (CHOICES | {"output": (*FULL, self.command_unit)}).items():
            if getattr(self, name) not in choices:
                raise UnknownName(f"{name} of a {self.form}", str(getattr(self, name)), choices)
        for one in (one for one in dataclasses.fields(self) if one.type == "float"):
            value = getattr(self, one.name)
            if isinstance(value, bool) or not isinstance(value, int | float):
                raise InvalidController(f"{one.name} of a {self.form} is {str(value)[:40]!r}", expected="a number")
            setattr(self, one.name, float(value))  # a file by hand has 50 where a design has 50.0
        numbers = (self.kp, self.ki, self.kd, self.set_point, self.k_position, self.k_speed)
        sizes = (self.dead_band, self.filter_time, self.wheel_radius)
        if not all(map(math.isfinite, numbers)) or not all(0 <= size < math.inf for size in sizes):
            raise InvalidController("a number of the program is none, or a size is negative", expected=_USUAL)
        if not 0 < self.period <= 1:
            raise InvalidController(f"a period of {self.period:g} s", expected="above 0 s, at most 1 s")
        for name in ("limit", "integral_limit", "supply"):
            if not getattr(self, name) > 0:
                raise InvalidController(f"{name} of a {self.form} is {getattr(self, name):g}", expected="above zero")
        if abs(self.sign) != 1:
            raise InvalidController(f"sign of a {self.form} is {self.sign:g}", expected="1 or -1")
        if self.output in FULL and not (self.command_unit == "V" and math.isfinite(self.supply)):
            raise InvalidController(
                f"an output in {self.output}",
                expected="a voltage drive and the supply [V]",
                hint="[battery.voltage] in the kit's file",
            )
        if self.cascade and not self.wheel_radius:
            raise InvalidController("k_position or k_speed without wheel_radius", expected="that of the robot [m]")
        if self.dead_band >= self.highest:
            raise InvalidController(f"a dead band of {self.dead_band:g}", expected=f"less than {self.highest:g}")
        reads = (PITCH, *([GYRO] if self.rate == "gyro" else []), *(RAW[:2] if self.cascade else ()))
        self.spec = ControllerSpec(self.form, reads, self.period, self.command_unit)
        law = self.law()
        one, two = law.linear, law.nonlinear
        assert two is not None
        rows = [[two.C, two.Dy, two.Dr], [one.C[:1], one.Dy[:1], one.Dr[:1]], [one.A, one.By, one.Br]]
        self._rows = np.block(rows)
        self._shape = self.shape
        self.reset()

    @property
    def cascade(self) -> bool:
        """Whether the wheels lead the set point."""
        return bool(self.k_position or self.k_speed)

    @property
    def highest(self) -> float:
        """The largest output, in its own unit."""
        return min(self.limit, FULL.get(self.output, self.supply))

    @property
    def volts(self) -> float:
        """Command for one of output, with the sign; a scaled dead band takes its part."""
        scale = 1 - self.dead_band / self.highest if self.dead_band_form == "scaled" else 1.0
        return self.sign * scale * self._unscaled

    @property
    def per_radian(self) -> float:
        """Command for a radian, with the sign, where kp is one."""
        return self.volts * PER_RADIAN[self.unit]

    @property
    def ki_time(self) -> float:
        """ki over ki per second: the period [s] of a program that knows no time, else 1."""
        return self.period if self.per == "step" else 1.0

    @property
    def _travel(self) -> float:
        """Radians of the error for a radian of the wheel, where k_position is one."""
        return self.wheel_radius / PER_RADIAN[self.unit]

    @property
    def _unscaled(self) -> float:
        return self.supply / FULL[self.output] if self.output in FULL else 1.0

    @property
    def shape(self) -> AngleShape:
        """What is not linear."""
        unscaled = self._unscaled
        integral = min(self.integral_limit, self.highest) * abs(self.volts)
        kp, ki, _ = self._si()
        trim = -self.sign * self.set_point / PER_RADIAN[self.unit]
        return AngleShape(
            kp * trim, ki * self.period * trim, integral, self.dead_band * unscaled, self.highest * unscaled
        )

    def _si(self) -> tuple[float, float, float]:
        """kp, ki and kd for radians and seconds, in command units."""
        kd = self.kd * self.ki_time if self.rate == "difference" else self.kd
        return self.per_radian * self.kp, self.per_radian * (self.ki / self.ki_time), self.per_radian * kd

    @property
    def gain(self) -> Array:
        """K (2, 6) of the part without memory."""
        kp, _, kd = self._si()
        lead = kp * self._travel
        return -np.tile([kp, kd, lead * self.k_position, lead * self.k_speed, 0.0, 0.0], (2, 1))

    def law(self) -> Law:
        """The memory holds the integral and, where they count, the filter of d and the wheels' position before."""
        dt = self.period
        kp, ki, kd = self._si()
        n = 3
        m = len(self.spec.reads)
        A = np.zeros((n, n))
        By = np.zeros((n, m))
        e_y = np.eye(m)[0]  # the error by the readings, and by the memory
        e_z = np.zeros(n)
        d_y = np.zeros(m)
        d_z = np.eye(n)[1]
        keep = self.filter_time / (self.filter_time + dt)
        A[1, 1] = keep
        if self.rate == "gyro":
            d_y[1], By[1, 1] = 1 - keep, keep * (1 - keep)
        else:  # (z − 1)/(z − keep): the memory is −(1 − keep) times the filtered angle
            d_y[0] = (1 - keep) / dt
            By[1, 0] = -((1 - keep) ** 2) / dt
        e_r = np.array([-1.0, 0.0, 0.0, 0.0, 0.0, 0.0])
        if self.cascade:
            position, speed = np.array([self.k_position, self.k_speed]) * self._travel
            By[2, 0], By[2, -2:] = 1.0, 0.5  # encoders count from the body
            e_y += (position + speed / dt) * By[2]
            e_z[2] = -speed / dt
            e_r[2:4] = -position, -speed
        used = [0, *(i for i in (1, 2) if By[i].any())]
        n, e_z, d_z = len(used), e_z[used], d_z[used]
        C, Dy, Dr = (np.tile(row, (2, 1)) for row in (kp * e_z + kd * d_z, kp * e_y + kd * d_y, kp * e_r))
        linear = LinearController.like(
            self.spec, A[np.ix_(used, used)], By[used], np.zeros((n, 6)), np.zeros((n, 2)), C, Dy, Dr
        )
        integral = np.eye(1, n) + ki * dt * e_z, ki * dt * e_y[None], ki * dt * e_r[None]
        remembered = np.outer(np.eye(n)[0], [0.0, 0.0, 1.0])
        return Law(linear, Nonlinear(*integral, remembered, self.shape))

    def reset(self) -> None:
        self._z = np.zeros(self._rows.shape[0] - 2)

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        s, linear, *z = (self._rows @ np.concatenate([self._z, measurement, reference])).tolist()
        u, z[0] = self._shape.output(linear, s)
        self._z = np.array(z)
        return u, u

    def estimate(self) -> Sequence[float]:
        """Empty: it estimates no state."""
        return ()

    def applied(self, command: Sequence[float]) -> None:
        """Such a program does not know what its motors did."""

    def to_json(self) -> dict[str, Any]:
        """The program's own numbers, without those that are usual."""
        own = {f.name: getattr(self, f.name) for f in dataclasses.fields(self) if f.init and _unusual(self, f)}
        return {"kind": self.form, **own}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> AnglePid:
        """The inverse of `to_json`; `UnknownName` for a number that no such program has."""
        names = [f.name for f in dataclasses.fields(cls) if f.init]
        own = {name: value for name, value in data.items() if name != "kind"}
        for name in own:
            if name not in names:
                raise UnknownName(f"number of a {cls.form}", name, names)
        for name in ("kp", "period"):
            if name not in own:
                raise InvalidController(f"a {cls.form} without {name}", expected="kp and period [s] at least")
        return cls(**own)


_USUAL = "kp, ki, kd, set_point, k_position and k_speed as numbers, dead_band and filter_time of zero or more"


def _unusual(pid: AnglePid, one: dataclasses.Field[Any]) -> bool:
    return one.name in ("unit", "output", "kp", "ki", "kd", "rate") or getattr(pid, one.name) != one.default
