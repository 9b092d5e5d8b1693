"""The numbers that a design was found by: what each state may be, what is expected, or gains."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from upright.arrays import Array
from upright.control import Controller, design_of
from upright.control.hinf import Hinf
from upright.control.lqg import Lqg
from upright.control.lqr import Lqr
from upright.control.pid import Pid
from upright.control.sliding import Sliding
from upright.signals.signal import STATE

UNITS = {signal.name: signal.unit for signal in STATE} | {"gyro_bias": "rad/s", "push": "N", "integral": "rad s"}
"""Units of the states of a regulator or of a filter."""


@dataclass(frozen=True)
class Weight:
    """A state, gain or disturbance by `name` with its `size` in `unit`, None where it costs nothing; and the `gain` of
    both motors on it, in units of the command over `unit`."""

    name: str
    unit: str
    size: float | None
    gain: tuple[float, ...] = ()


def weights_of(controller: Controller) -> tuple[Weight, ...]:
    """The weights of a controller's design; none where its method has none of these, or they are not known."""
    unit = controller.spec.command_unit
    record: Any = design_of(controller) or getattr(controller, "controller", controller)
    match getattr(record, "feedback", record):  # of the measured state, behind a filter
        case Lqr() as design:
            return _regulator(design.model.states, design.Q, design.gain, unit)
        case Lqg() as design:
            return _regulator(design.plant.states, design.Q, design.gain, unit)
        case Sliding() as design:
            return _regulator(design.base.plant.states, design.base.Q, design.S, unit)
        case Pid() as design:
            return _cascade(design, unit)
        case Hinf() as design:
            return _expected(design, unit)
        case _:
            return ()


def _regulator(states: Sequence[str], Q: Array, gain: Array, unit: str) -> tuple[Weight, ...]:
    """By Bryson's rule a weight is 1/size²."""
    return tuple(
        Weight(name, UNITS.get(name, unit), weight**-0.5 if weight > 0 else None, tuple(column))
        for name, weight, column in zip(states, Q.diagonal().tolist(), gain.T.tolist(), strict=True)
    )


def _cascade(design: Pid, unit: str) -> tuple[Weight, ...]:
    g = design.gains
    return (
        Weight("p", f"{unit}/rad", g.p), Weight("i", f"{unit}/(rad s)", g.i), Weight("d", f"{unit} s/rad", g.d),
        Weight("filter_time", "s", g.filter_time), Weight("motor", f"{unit} s/rad", g.motor),
        Weight("p_wheel", "1", g.wheel), Weight("d_wheel", "s", g.wheel_rate),
        Weight("p_yaw", f"{unit}/rad", g.yaw), Weight("d_yaw", f"{unit} s/rad", g.yaw_rate),
    )  # fmt: skip


def _expected(design: Hinf, unit: str) -> tuple[Weight, ...]:
    wants = design.expected
    return (
        *(Weight(s.name, s.unit, size) for s, size in zip(STATE, wants.state, strict=True)),
        Weight("command", unit, design.command),
        Weight("disturbance", unit, design.command * wants.disturbance),
        Weight("encoder", "rad", wants.errors[0]),
        Weight("gyro", "rad/s", wants.errors[1]),
    )
