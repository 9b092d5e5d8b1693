"""How widely the numbers of robots vary, and where results come from, in words for their pages."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from upright.fleets.results import origin_of
from upright.fleets.tally import END
from upright.plotting import number
from upright.reports.page import Cell, Table
from upright.tables import joined, spoken

if TYPE_CHECKING:
    from xarray import Dataset

    from upright.fleets.tally import Cases, CaseSummary


def width(spread: Mapping[str, Any]) -> float:
    """A spread relative to its middle [1]."""
    if spread["kind"] == "lognormal":
        return math.exp(spread["high"]) - 1
    return abs(spread["high"] / spread["low"]) if spread["low"] else math.inf


def size_of(spread: Mapping[str, Any], unit: str) -> str:
    """How wide a distribution is: "0 to 0.01 s", "±5 %" of a normal one, "by a factor of 2" of a log-normal one."""
    low, high = spread["low"], spread["high"]
    if spread["kind"] == "lognormal":
        return f"by a factor of {number(math.exp(high), 2)}"
    if spread["kind"] == "normal":
        return f"±{number(100 * width(spread), 2)} %" if low else f"±{number(high, 2)} {unit}"
    return f"from {number(low, 3)} to {number(high, 3)} {unit}".strip()


def spread_table(spreads: Sequence[Mapping[str, Any]], units: Mapping[str, str]) -> Table:
    """Each number that varies, with its middle and its spread."""
    rows: list[list[Cell]] = []
    for spread in spreads:
        unit = units.get(spread["name"], "")
        middle = (spread["low"] + spread["high"]) / 2 if spread["kind"] == "uniform" else spread["low"]
        rows.append([f"{spoken(spread['name'])} [{unit or '1'}]", middle, size_of(spread, unit)])
    return Table(["number", "middle", "varies"], rows, "± and factors are one standard deviation")


def provenance(data: Dataset) -> dict[str, str]:
    """Robot, controller, seed and versions for a page's foot."""
    origin = origin_of(data)
    controller, versions = origin.get("controller", {}), origin.get("versions", {})
    facts = {
        "robot": str(origin.get("robot", {}).get("name", "")),
        "kit": str((origin.get("kit") or {}).get("name", "ideal")),
        "controller": f"{controller.get('kind', '')} {str(controller.get('hash', ''))[:12]}".strip(),
        "seed": str(origin.get("seed", "")),
        "versions": ", ".join(f"{name} {number}" for name, number in sorted(versions.items())),
    }
    return {name: text for name, text in facts.items() if text}


MATTER = 8  # drawn numbers in the table


def matter_table(cases: Cases, drawn: Mapping[str, tuple[CaseSummary, float, float]]) -> Table:
    """The drawn numbers over which falls change most."""
    names = cases.names()
    rows: list[list[Cell]] = [
        [spoken(name), _varies(cases, case, name), 100 * least, 100 * most, names[cases.index(case)]]
        for name, (case, least, most) in list(drawn.items())[:MATTER]
    ]
    part = f"{100 * END:g} %"
    caption = f"Robots that fall: of the {part} with the smallest value, and of the {part} with the largest"
    header = ["parameter", "varies", f"smallest {part}: fell [%]", f"largest {part}: fell [%]", "where it matters most"]
    return Table(header, rows, caption, 3, even=True)


def directions(drawn: Mapping[str, tuple[CaseSummary, float, float]]) -> list[str]:
    """Which way each drawn number keeps robots from falling."""
    ways = {"smaller": list[str](), "larger": list[str]()}
    for name, (_, least, most) in list(drawn.items())[:MATTER]:
        ways["smaller" if least < most else "larger"].append(spoken(name))
    texts = [f"a {way} {joined(names)}" for way, names in ways.items() if names]
    return [f"Fewer robots fall with {', and with '.join(texts)}. ±, × and ÷ are one standard deviation."]


def _varies(cases: Cases, case: CaseSummary, name: str) -> str:
    """How a number varies in a case: its middle, its unit and its spread; empty where nobody wrote it."""
    origin = cases.origins[cases.index(case)] if len(cases.origins) == len(cases) else {}
    spreads = (origin.get("vary") or {}).get("spreads", ())
    spread = next((s for s in spreads if s["name"] == name), None)
    if spread is None:
        return ""
    unit = cases.units.get(name, "")
    size = size_of(spread, unit).replace("by a factor of", "× or ÷")
    return size if spread["kind"] == "uniform" else f"{number(spread['low'], 3)} {unit}, {size}"


def product(cases: Cases) -> str:
    """What the cases combine, where they are all combinations: "24 cases = 2 robots × 3 controllers × 4 dead zones"."""
    varied = cases.varied()
    if len(varied) < 2 or math.prod(map(len, varied.values())) != len(cases):
        return f"{len(cases)} cases"
    parts = [f"{len(values)} {_several(spoken(name))}" for name, values in varied.items()]
    return f"{len(cases)} cases = {' × '.join(parts)}"


def _several(word: str) -> str:
    """The plural: "controllers", "inertias", "masses", "frequencies"."""
    if word.endswith("y") and not word.endswith(("ay", "ey", "oy")):
        return f"{word[:-1]}ies"
    return f"{word}{'es' if word.endswith(('s', 'x')) else 's'}"
