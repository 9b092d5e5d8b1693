"""The contract of everything that commands: state feedback, estimators in front of it, and all other methods."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol, runtime_checkable

from upright.arrays import Array
from upright.pages import Say


@dataclass(frozen=True)
class ControllerSpec:
    """What a controller reads (channel names, in the order `step` gets them) and every how many seconds.

    `estimates` says that `estimate()` gives an opinion on the six states after each step, `stands_up`
    that it lifts a robot that lies, so that no lean stops it.
    """

    kind: str
    reads: tuple[str, ...]
    period: float
    command_unit: str = "V"
    estimates: bool = False
    stands_up: bool = False

    @property
    def reads_truth(self) -> bool:
        """Whether a real robot could not run this controller."""
        return any(name.startswith("truth/") for name in self.reads)


@runtime_checkable
class Controller(Protocol):
    """`reset()` forgets everything; `step(measurement, reference)` gives the command (left, right).

    `measurement` holds the channels of `spec.reads`, shape (len(reads),); `reference` is the wanted state,
    shape (6,), zero for standing still. `applied(command)` tells what the motors really did, as it stood at the end
    of the period (saturated, perhaps late); most controllers ignore it. `to_json()` says everything that decides its
    commands, so that its hash identifies it.
    """

    @property
    def spec(self) -> ControllerSpec: ...

    def reset(self) -> None: ...

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]: ...

    def estimate(self) -> Sequence[float]: ...

    def applied(self, command: Sequence[float]) -> None: ...

    def to_json(self) -> dict[str, Any]: ...


class Lawful:
    """A controller that says what it computes: `law()` is a `Law`, of which `linearised()` is the part near rest.

    It is shown by its kind, readings and period; printed, it adds what its design says. Its matrices are attributes.
    """

    spec: Any  # a `ControllerSpec`: a field in some controllers, a property in others

    def law(self) -> Any:
        """All that decides its commands, as a `Law`; raises `InvalidController` where that is no fixed sum."""
        raise NotImplementedError

    def linearised(self) -> Any:
        """The `LinearController` that it is while nothing about it is at a limit."""
        return self.law().linearised()

    def words(self) -> Sequence[Say | str]:
        """Sentences on how it was found: those of its record of design, where it has one."""
        record = getattr(self, "design", None)
        return record.words() if record else []

    def __str__(self) -> str:
        return "\n".join([repr(self), *map(str, self.words())])

    def __repr__(self) -> str:
        spec: ControllerSpec = self.spec
        return f"{type(self).__name__}({spec.kind!r}: reads {', '.join(spec.reads)}; every {spec.period:g} s)"


def controller_hash(controller: Controller) -> str:
    """SHA-256 of the controller's JSON, the same for the same numbers on every machine."""
    text = json.dumps(controller.to_json(), sort_keys=True, separators=(",", ":"))
    return hashlib.sha256(text.encode()).hexdigest()
