"""Distributions of parameters from text (`--vary`), and numbers of a robot or a kit by name."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence

from upright.errors import InvalidScenario, UnknownName
from upright.experiment.notation import number
from upright.robots import PARAMETERS, Kit, Robot
from upright.robots.uncertainty import Spread, Uncertainty

Vary = Mapping[str, str] | Sequence[str] | str
"""{"com_height": "±10%", "delay": "0..0.01"}; the same as texts, "com_height=±10%"; or "spread"."""


def varied(vary: Vary, robot: Robot, kit: Kit | None = None, posterior: Uncertainty | None = None) -> Uncertainty:
    """All distributions of `vary`, together with a posterior and independent of it."""
    texts = (vary,) if isinstance(vary, str) else vary
    if isinstance(texts, Mapping):
        texts = [f"{name}={text}" for name, text in texts.items()]
    return sum((variation(text, robot, kit) for text in texts), posterior or Uncertainty())


def variation(text: str, robot: Robot, kit: Kit | None = None) -> Uncertainty:
    """The distribution of one `--vary`: `name=±10%`, `name=±0.005`, `name=0.06..0.08`, `name=normal:5%`,
    `name=normal:0.002`, `name=normal` (spread of the robot's sources); `spread`: all parameters so; or
    `conditions`: the battery as the robot's file expects it.

    A name is a robot's parameter or a kit's number such as `delay` or `sensors.gyro.noise`. Raises `InvalidScenario`,
    `UnknownName`.
    """
    if text.strip() == "spread":
        return Uncertainty.of(robot)
    if text.strip() == "conditions":
        return _conditions(robot)
    name, equals, range_ = (part.strip() for part in text.partition("="))
    value = nominal(name, robot, kit)
    range_ = range_.replace("+-", "±").replace("+/-", "±").replace(" ", "")
    if not equals or not range_:
        raise InvalidScenario(f"--vary '{text}'", expected="NAME=±10%, NAME=LOW..HIGH or NAME=normal:5%")
    if range_ == "normal":
        own = tuple(s for s in Uncertainty.of(robot).spreads if s.name == name)
        if not own:
            raise InvalidScenario(f"--vary '{text}', but {name} has no spread", hint=f"{name}=normal:5%")
        return Uncertainty(own)
    if range_.startswith("normal:"):
        return Uncertainty((Spread(name, "normal", value, _size(range_[7:].lstrip("±"), value, text)),))
    if ".." in range_:
        low, high = (number(part, f"--vary '{text}'") for part in range_.split("..", 1))
        if not low < high:
            raise InvalidScenario(f"--vary '{text}'", expected="a low end below the high one")
        return Uncertainty((Spread(name, "uniform", low, high),))
    if not range_.startswith("±"):
        raise InvalidScenario(f"--vary '{text}'", expected="±10%, LOW..HIGH or normal:5%", hint=f"{name}=±10%")
    half = _size(range_[1:], value, text)
    return Uncertainty((Spread(name, "uniform", value - half, value + half),))


def _conditions(robot: Robot) -> Uncertainty:
    """The battery's voltage, uniform over what the robot's file expects."""
    if robot.conditions.battery is None:
        raise InvalidScenario(
            f"--vary conditions, and '{robot.name}' states no battery", expected="[conditions.battery] in its file",
            hint="--vary battery.voltage=6.8..9",
        )  # fmt: skip
    return Uncertainty((Spread("battery.voltage", "uniform", *robot.conditions.battery),))


def nominal(name: str, robot: Robot, kit: Kit | None = None) -> float:
    """The number of that name, of the robot or of the kit; raises `UnknownName`."""
    numbers = robot.numbers() | (kit_numbers(kit) if kit else {})
    if name not in numbers:
        raise UnknownName("number of this robot and kit", name, numbers)
    return numbers[name]


def kit_numbers(kit: Kit) -> dict[str, float]:
    """A kit's numbers by dotted name: `delay`, `jitter`, `motor.limit`, `sensors.gyro.noise`."""
    numbers = {"delay": kit.delay, "jitter": kit.jitter}
    numbers |= {f"motor.{name}": value for name, value in vars(kit.motor).items()}
    numbers |= {f"battery.{name}": value for name, value in vars(kit.battery).items()}
    fixed = ("delay", "period")  # whole numbers of steps, shared by a batch
    for channel, sensor in kit.sensors.items():
        name = f"sensors.{channel.removeprefix('sensor/')}"
        numbers |= {f"{name}.{part}": value for part, value in vars(sensor).items() if part not in fixed}
    return numbers


def with_number(name: str, value: float, robot: Robot, kit: Kit | None) -> tuple[Robot, Kit | None]:
    """Robot and kit with one number replaced, checked again; raises `UnknownName`, `InvalidRobot`."""
    nominal(name, robot, kit)
    if name in PARAMETERS:
        return robot.replace(**{name: value}), kit
    assert kit is not None
    owner, _, field = name.rpartition(".")
    if not owner:
        return robot, dataclasses.replace(kit, **{field: value})
    if owner in ("motor", "battery"):
        return robot, dataclasses.replace(kit, **{owner: dataclasses.replace(getattr(kit, owner), **{field: value})})
    channel = f"sensor/{owner.removeprefix('sensors.')}"
    sensor = dataclasses.replace(kit.sensors[channel], **{field: value})
    return robot, dataclasses.replace(kit, sensors=kit.sensors | {channel: sensor})


def _size(text: str, value: float, option: str) -> float:
    relative = text.endswith("%")
    size = number(text.removesuffix("%"), f"--vary '{option}'") * (abs(value) / 100 if relative else 1)
    if not (size > 0 and math.isfinite(size)):
        zero = "a percentage of zero or of infinity" if relative else ""
        raise InvalidScenario(f"--vary '{option}' of {value:g}", expected="a size above zero", likely=zero)
    return size
