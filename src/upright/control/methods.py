"""The registry of methods of design: what each takes, what it costs, and how to find one by name, file or package."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from os import PathLike
from typing import Any

from upright.arrays import Array
from upright.control.controller import Controller
from upright.control.estimators import Estimated, complementary
from upright.control.files import read_controller
from upright.control.hinf import hinf
from upright.control.identity import designed_from, request_hash
from upright.control.lqg import lqg
from upright.control.lqi import LARGEST_INTEGRAL, lqi
from upright.control.lqr import Lqr, lqr, lqr_state
from upright.control.mpc import mpc
from upright.control.observed import by_gain
from upright.control.pid import pid
from upright.control.pid_angle_design import OWN, pid_angle
from upright.control.riccati import LARGEST_COMMAND, LARGEST_STATE
from upright.control.robust import robust
from upright.control.sliding import sliding
from upright.control.tunable import TUNABLE, Tunable, by_sizes, sized
from upright.errors import InvalidController, UnknownName, lacking
from upright.plugins import Registry, made
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES


@dataclass(frozen=True, kw_only=True)
class Method:
    """A method of design in the registry: `make(robot, kit, dt)` gives a controller.

    A `weighted` method has two more keywords (Bryson's rule): `largest`, the largest accepted deviation of each state
    (6,) [rad, rad/s, …], and `command`, the largest usual command of a motor. A `slow` one takes more than a second to
    design. One with `reads_truth` needs the true state. `benched` ones are in the table of all controllers. `own` are
    the numbers and words that `make` takes by name. `tunable` says how its weights are tuned. One that `needs` a module
    of an extra is left out where many are made.
    """

    make: Callable[..., Controller]
    name: str = ""
    weighted: bool = False
    slow: bool = False
    reads_truth: bool = False
    benched: bool = True
    own: tuple[str, ...] = ()
    tunable: Tunable | None = None
    needs: str = ""

    @property
    def lacks(self) -> str:
        """What to install before it can be designed, in one line; "" where nothing is missing."""
        return lacking(f"design {self.name}", self.needs) if self.needs else ""

    def tuned(self, robot: Robot, kit: Kit, dt: float, weights: Mapping[str, float]) -> Controller:
        """The controller under these weights by name, those of `tunable`."""
        if self.tunable is None:
            raise InvalidController(f"{self.name or 'this method'} has no weights to tune")
        known = self.tunable.defaults(robot, kit, dt)
        if unknown := set(weights) - set(known):
            raise UnknownName(f"weight of {self.name}", min(unknown), known)
        asked = request_hash(self.name, robot, kit, dt, weights=dict(weights))
        return designed_from(self.tunable.make(robot, kit, dt, weights), asked)

    def defaults(self, robot: Robot, kit: Kit, dt: float) -> dict[str, float]:
        """The weights that the method has by default: those in the robot's file, of its own kit, before its own."""
        assert self.tunable is not None
        own = robot.weights.get(self.name)
        given = own.numbers if own and kit.name == robot.kit_name else {}
        return {**self.tunable.defaults(robot, kit, dt), **given}

    def __call__(
        self,
        robot: Robot,
        kit: Kit,
        dt: float,
        *,
        largest: Sequence[float] | None = None,
        command: float | None = None,
        own: Mapping[str, float | str] | None = None,
    ) -> Controller:
        """The controller for `robot` under `kit` every `dt` [s]. Without `largest` and `command` its weights are
        those in the robot's file, where that has some for its own kit, else those of Bryson's rule on `LARGEST_STATE`.

        `own` are numbers and words of the method's own. Raises `InvalidController` for other than six deviations, or
        for weights or own numbers where the method takes none.
        """
        if own:
            if not self.own:
                raise InvalidController(
                    f"{self.name} takes no numbers of its own", expected="a method such as pid-angle"
                )
            return designed_from(self.make(robot, kit, dt, **own), request_hash(self.name, robot, kit, dt, **own))
        if largest is None and command is None and self.name in robot.weights and kit.name == robot.kit_name:
            return self.tuned(robot, kit, dt, self.defaults(robot, kit, dt))
        largest = LARGEST_STATE if largest is None else largest
        if len(largest) != len(STATE_NAMES):
            raise InvalidController(f"{len(largest)} largest deviations", expected="six, one for each state")
        size = LARGEST_COMMAND[robot.command_unit] if command is None else command
        asked = request_hash(self.name, robot, kit, dt, largest=list(largest), command=size)
        if self.weighted:
            return designed_from(self.make(robot, kit, dt, largest=tuple(largest), command=size), asked)
        if command is not None or tuple(largest) != LARGEST_STATE:
            raise InvalidController(f"{self.name or 'this method'} takes no weights", expected="its defaults")
        return designed_from(self.make(robot, kit, dt), asked)


def _lqr_state(robot: Robot, _kit: Kit, dt: float, Q: Array, R: Array) -> Lqr:
    return lqr_state(robot, dt, Q, R)


def _complementary(robot: Robot, kit: Kit, dt: float, Q: Array, R: Array) -> Controller:
    return Estimated(lqr_state(robot, dt, Q, R), complementary(robot, kit, dt))


OURS = (
    # the baseline of all others
    Method(name="lqr", make=partial(by_sizes, lqr), weighted=True, tunable=TUNABLE["lqr"]),
    Method(name="lqr-complementary", make=partial(by_sizes, _complementary), weighted=True, benched=False),
    Method(name="lqi", make=partial(by_sizes, lqi, integral=LARGEST_INTEGRAL), weighted=True, tunable=TUNABLE["lqi"]),
    Method(name="lqg", make=partial(by_sizes, lqg), weighted=True, tunable=TUNABLE["lqg"]),
    Method(name="pid", make=pid, slow=True, tunable=TUNABLE["pid"]),
    # what most have built: a program of one's own, no table's rival
    Method(name="pid-angle", make=pid_angle, own=OWN, benched=False, tunable=TUNABLE["pid-angle"]),
    Method(name="hinf", make=hinf, slow=True, tunable=TUNABLE["hinf"]),
    Method(name="mpc", make=partial(by_sizes, mpc), weighted=True, tunable=TUNABLE["mpc"]),
    Method(name="sliding", make=partial(by_sizes, sliding), weighted=True, tunable=TUNABLE["sliding"]),
    Method(name="robust", make=robust, weighted=True, slow=True, needs="cvxpy"),
    Method(name="lqr-state", make=partial(by_sizes, _lqr_state), weighted=True, reads_truth=True, benched=False),
)


def _plugin(name: str, thing: Any) -> Method:
    """A method from outside: a `Method`, or whatever makes a controller of (robot, kit, dt)."""
    given = thing if isinstance(thing, Method) else Method(make=thing)
    make = given.make

    def checked(robot: Robot, kit: Kit, dt: float, **weights: Any) -> Controller:
        return made(f"controller {name}", Controller, lambda: make(robot, kit, dt, **weights))

    tunable = sized(checked) if given.weighted and not given.slow else None
    return replace(given, name=name, make=checked, tunable=given.tunable or tunable)


CONTROLLERS: Registry[Method] = Registry("controller", "upright.controllers", {m.name: m for m in OURS}, _plugin)
"""Every method of design: ours, those of installed packages, and `CONTROLLERS["my.py:Rod"]`."""


def make_controller(
    name: str, robot: Robot, kit: Kit, dt: float, own: Mapping[str, float | str] | None = None
) -> Controller:
    """The controller by the method of that name, designed for `robot` under `kit` every `dt` [s], from its `own`
    numbers where it takes some."""
    return CONTROLLERS[name](robot, kit, dt, own=own)


def find_controller(
    controller: Controller | str | PathLike[str], robot: Robot, kit: Kit, dt: float, gain: str | None = None
) -> Controller:
    """The controller itself, the one in a `.json` file, or by the method of that name or of `file.py:Name`; in place of
    these the one `by_gain`, where a `gain` is given.

    Raises `UnknownName`, or `InvalidPlugin` for a file or a package whose controller cannot be made.
    """
    if gain is not None:
        return by_gain(gain, robot, kit, dt)
    if not isinstance(controller, str | PathLike):
        return controller
    name = str(controller)
    return read_controller(name) if name.endswith(".json") else make_controller(name, robot, kit, dt)
