"""The robot with an excitation added to its controller's command, run by the fleet's kernel."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np

from upright.arrays import Array
from upright.control import Controller, as_linear
from upright.control.identity import Identity, identity
from upright.control.linear_controller import LinearController
from upright.errors import InvalidController, InvalidScenario, SpecMismatch
from upright.kernel.batch import NAMES, FleetBatch, FleetResult, parameters_of
from upright.kernel.simulate import simulate
from upright.logs.recording import SENSOR
from upright.robots import Kit, Robot
from upright.signals import Log

FINEST = 0.02  # [s] a row is held at least: 25 Hz is beyond what a robot's sensors tell of its motion
MOST_ROWS = 1500  # of an excitation: each is two numbers of every robot in the kernel's memory
DRY = 0.005  # [rad/s] over which friction is smoothed in a run to learn from, whose predictor does not smooth it at all
APPLIED = ("applied/left", "applied/right")


@dataclass(frozen=True, eq=False)
class ExcitedLoop:
    """`controller` on `robot` with `kit` for `seconds`; every row of an excitation is held for `hold` periods.

    Raises `SpecMismatch` for a controller that is not linear or does not fit, `InvalidScenario` for the time.
    """

    robot: Robot
    kit: Kit
    controller: Controller
    seconds: float
    seed: int = 0
    gains: LinearController = field(init=False)

    def __post_init__(self) -> None:
        if not any(SENSOR.get(name) == "encoder" for name in self.kit.sensors):
            raise SpecMismatch(
                f"kit '{self.kit.name}' has no encoders", expected="one at least, from which `calibrate` learns"
            )
        gains = _gains(self.controller, self.robot)
        if not 100 * gains.period <= self.seconds <= 600:
            least = f"{100 * gains.period:g} s, a hundred periods"
            raise InvalidScenario(f"an excitation of {self.seconds:g} s", expected=f"from {least}, to 600 s")
        object.__setattr__(self, "gains", _reading_all(gains, self.kit))

    @property
    def periods(self) -> int:
        return round(self.seconds / self.gains.period)

    @property
    def hold(self) -> int:
        """For how many periods each row of an excitation is held."""
        return max(1, round(FINEST / self.gains.period), -(-self.periods // MOST_ROWS))

    @property
    def rows(self) -> int:
        return -(-self.periods // self.hold)

    @cached_property
    def nominal(self) -> Array:
        """Parameters (1, 25) of `robot`."""
        return parameters_of(self.robot)

    @property
    def identity(self) -> Identity:
        return identity(self.controller)

    def run(
        self, excitations: Array, parameters: Array | None = None, *, kit: Kit | None = None, record: bool = False,
        hold: int | None = None,
    ) -> FleetResult:  # fmt: skip
        """Robots with `parameters` (n, 25) under `excitations` (n, rows, 2), either of which may be one for all."""
        table = self.nominal if parameters is None else parameters
        batch = FleetBatch(
            parameters=self._dry(table) if record else table,
            controller=self.gains,
            excitation=excitations,
            excitation_hold=hold or self.hold,
            kit=kit or self.kit,
            seed=self.seed,
        )
        channels = (*self.gains.reads, *APPLIED) if record else ()
        return simulate(batch, self.seconds, record=int(record), channels=channels)

    def _dry(self, parameters: Array) -> Array:
        table = np.array(parameters)
        column = NAMES.index("stiction_rate")
        table[:, column] = np.minimum(table[:, column], DRY)
        return table

    def energies(self, excitations: Array, hold: int | None = None) -> Array:
        """∫ u_l² + u_r² dt (n,) of what the motors of the nominal robot get from `excitations` (n, rows, 2), the loop's
        answer included; inf where it falls.

        Sensors and drivers are perfect here, so that without an excitation the motors would get nothing.
        """
        result = self.run(excitations, kit=perfect(self.kit), hold=hold)
        return np.where(result.fell, np.inf, result.effort)

    def scaled(self, excitations: Array, energy: float, hold: int | None = None) -> Array:
        """`excitations` (n, rows, 2), each with the size at which it has that `energy`."""
        sizes = np.ones(len(excitations))
        for _ in range(5):
            now = self.energies(sizes[:, None, None] * excitations, hold)
            sizes = np.where(np.isfinite(now), sizes * np.sqrt(energy / np.maximum(now, 1e-30)), 0.3 * sizes)
        return sizes[:, None, None] * excitations

    def logs(self, result: FleetResult) -> list[Log]:
        """What a recorded run leaves of each robot that stood: raw sensors and applied commands."""
        origin = {"body": {"kind": "fleet kernel"}, "robot": {"name": self.robot.name}}
        return [
            Log(result.t, dict(zip(result.channels, trace.T, strict=True)), origin=origin)
            for trace in result.trace[~result.fell]
        ]


def perfect(kit: Kit) -> Kit:
    """The kit with its dead times and limits, but without noise, steps, dead zone, drop or sag."""
    sensors = {
        name: dataclasses.replace(s, quantum=0.0, noise=0.0, bias=0.0, bias_walk=0.0) for name, s in kit.sensors.items()
    }
    motor = dataclasses.replace(kit.motor, dead_zone=0.0, quantum=0.0, drop=0.0, backlash=0.0)
    battery = dataclasses.replace(kit.battery, sag=0.0)
    return dataclasses.replace(kit, sensors=sensors, motor=motor, battery=battery, jitter=0.0)


def _gains(controller: Controller, robot: Robot) -> LinearController:
    try:
        gains = as_linear(controller)
    except InvalidController:
        raise SpecMismatch(
            f"a {controller.spec.kind} cannot be excited here", expected="a linear controller, as the kernel runs",
            hint="take an lqg, lqi, hinf or pid",
        ) from None  # fmt: skip
    if gains.command_unit != robot.command_unit:
        raise SpecMismatch(f"the controller commands {gains.command_unit}", expected=f"{robot.command_unit}")
    if controller.spec.reads_truth:
        raise SpecMismatch(
            f"a {controller.spec.kind} that reads the true state", expected="a controller of raw sensors",
            hint="put a filter before it",
        )  # fmt: skip
    return gains


def _reading_all(gains: LinearController, kit: Kit) -> LinearController:
    """The same commands from a controller that also reads every sensor of a calibration, so that it is recorded."""
    more = [name for name in kit.sensors if name in SENSOR and name not in gains.reads]

    def wider(matrix: Array) -> Array:
        return np.hstack([matrix, np.zeros((len(matrix), len(more)))])

    return dataclasses.replace(
        gains, By=wider(gains.By), Dy=wider(gains.Dy), Sy=wider(gains.Sy) if len(gains.Sy) else gains.Sy,
        reads=(*gains.reads, *more),
    )  # fmt: skip


def stacked(excitations: Sequence[Array]) -> Array:
    """Several (rows, 2) as (n, rows, 2)."""
    return np.stack(list(excitations))
