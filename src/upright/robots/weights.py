"""Weights of methods that were tuned for a robot, as its file states them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

from upright.errors import InvalidRobot
from upright.robots import toml


@dataclass(frozen=True)
class TunedWeights:
    """Positive weights of one method by name (`upright tune`, units in docs/fleet.md), and the run they are from."""

    numbers: Mapping[str, float]
    source: str

    def to_toml(self, method: str) -> str:
        """The table that `weights_of` reads back."""
        rows = [f"{name} = {value!r}\n" for name, value in self.numbers.items()]
        return f"\n[weights.{method}]\n{''.join(rows)}source = {toml.quoted(self.source)}\n"


def weights_of(table: toml.Table, where: str) -> dict[str, TunedWeights]:
    """What `[weights.lqg] pitch = 0.2, …, source = "…"` says, by method; raises `InvalidRobot`."""
    inner = toml.subtable(table, "weights", where)
    result: dict[str, TunedWeights] = {}
    for method in inner:
        rows = toml.subtable(inner, method, where)
        if "source" not in rows:
            raise InvalidRobot(f"{where}: weights.{method} lacks source", expected="the run that the weights are from")
        numbers = {name: value for name, value in rows.items() if name != "source"}
        for name, value in numbers.items():
            if not toml.is_number(value) or not 0 < value < math.inf:
                raise InvalidRobot(f"{where}: weights.{method}.{name} is {value!r}", expected="a positive number")
        result[method] = TunedWeights({n: float(v) for n, v in numbers.items()}, toml.word(rows, "source", where))
    return result
