"""A campaign as a TOML file: robots × controllers × scenarios × grid, each with `n` robots."""

from __future__ import annotations

import itertools
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any, cast

from upright import control
from upright.control import Controller
from upright.errors import InvalidController, InvalidScenario, UnknownName
from upright.experiment import Drive, Hold, Impulse, Push, Slope, Turn
from upright.experiment.notation import first_state, is_number, programme
from upright.fleets.campaign import CHUNK, Campaign, Case
from upright.fleets.ensemble import Ensemble
from upright.fleets.vary import varied, with_number
from upright.reading import read_toml, understood
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.uncertainty import Family, at_medians

Table = Mapping[str, Any]

IDEAL = "ideal"
"""The kit without electronics, with which controllers may read the true state."""

PUSHES: dict[str, type] = {"hold": Hold, "force": Push, "impulse": Impulse, "slope": Slope}
REFERENCES: dict[str, type] = {"drive": Drive, "turn": Turn}

_KEYS = {
    "robots": list, "controllers": list, "kit": str, "n": int, "seed": int, "seconds": float, "chunk": int,
    "model": str, "vary": list, "posterior": str, "keep": list, "grid": dict, "scenario": list,
}  # fmt: skip
_TEXTS = ("robots", "controllers", "vary", "keep")
_WORDS = {list: "a list", str: "text in quotes", int: "a whole number", float: "a number", dict: "a table"}
_SCENARIO = {"name": str, "push": list, "reference": list, "start": dict, "seconds": float}


def read_campaign(path: str | Path) -> Campaign:
    """The campaign of a TOML file (see docs/fleet.md); files it names stand beside it.

    Raises `InvalidScenario`, `InvalidRobot`, `InvalidController` or `UnknownName` for what is wrong with it.
    """
    source = Path(path)
    table = read_toml(source, InvalidScenario, "a campaign in TOML (see docs/fleet.md)")
    with understood(str(path), InvalidScenario, "a campaign (see docs/fleet.md)"):
        return campaign_of(table, Path(os.path.expanduser(source)).parent, str(path))


def campaign_of(table: Table, folder: Path = Path(), where: str = "the campaign") -> Campaign:
    """The campaign that a table describes."""
    _check(table, _KEYS, where)
    scenarios: list[Table] = table.get("scenario", [{}])
    grid: dict[str, list[float]] = table.get("grid", {})
    for name, values in grid.items():
        if not (isinstance(cast(Any, values), list) and values and all(is_number(v) for v in values)):
            raise InvalidScenario(f"{where}: grid.{name} is {values!r}", expected="a list of numbers")
    robots, controllers = table.get("robots", ["nxtway-gs"]), table.get("controllers", ["lqg"])
    points = [dict(zip(grid, values, strict=True)) for values in itertools.product(*grid.values())]
    cases = [
        _case(table, folder, where, *choice) for choice in itertools.product(robots, controllers, scenarios, points)
    ]
    return Campaign(tuple(cases), int(table.get("chunk", CHUNK)), tuple(table.get("keep", ())))


def _case(
    table: Table,
    folder: Path,
    where: str,
    robot_name: str,
    controller_name: str,
    scenario: Table,
    point: dict[str, float],
) -> Case:
    _check(scenario, _SCENARIO, f"{where}: scenario")
    posterior = folder / table["posterior"] if "posterior" in table else None
    robot, unknown = at_medians(find_robot(_beside(robot_name, folder)), posterior)
    kit = electronics(table.get("kit", robot.kit), folder)
    controller = find_controller(_beside(controller_name, folder), robot, kit)
    for name, value in point.items():  # after the design: the controller does not know the grid
        if unknown and name in unknown.names:
            raise InvalidScenario(f"{where}: the posterior draws {name}", expected="another number in the grid")
        robot, kit = with_number(name, float(value), robot, kit)
    ensemble = Ensemble(
        family=Family(robot, kit, varied(table.get("vary", ()), robot, kit, unknown)),
        controller=controller,
        pushes=tuple(_programme(p, PUSHES, where) for p in scenario.get("push", [])),
        references=tuple(_programme(r, REFERENCES, where) for r in scenario.get("reference", [])),
        start=first_state(scenario.get("start", {}), f"{where}: start"),
        seconds=float(scenario.get("seconds", table.get("seconds", 10.0))),
        seed=int(table.get("seed", 0)),
        model=str(table.get("model", "complete")),
    )
    labels = {"robot": robot.name, "controller": Path(controller_name).stem, "scenario": scenario.get("name", "")}
    return Case({k: v for k, v in labels.items() if v} | point, ensemble, int(table.get("n", 1000)))


def electronics(kit: Kit | str, folder: Path = Path()) -> Kit | None:
    """The kit, or the one of that name or TOML file; None for the ideal one."""
    kit = kit if isinstance(kit, Kit) else find_kit(_beside(str(kit), folder))
    return None if kit.name == IDEAL else kit


def find_controller(name: str, robot: Robot, kit: Kit | None) -> Controller:
    """The controller of a `.json` file, or the registered one of that name designed for `robot` under `kit`.

    On the ideal kit `lqr` is the regulator of the true state. Raises `InvalidController` where units do not fit.
    """
    parts = kit or Kit.preset(IDEAL)
    controller = control.find_controller(
        "lqr-state" if name == "lqr" and kit is None else name, robot, parts, parts.period
    )
    if controller.spec.command_unit != robot.command_unit:
        raise InvalidController(
            f"the controller commands {controller.spec.command_unit}",
            expected=f"{robot.command_unit}, as '{robot.name}'",
        )
    return controller


def _beside(name: str, folder: Path) -> str:
    return str(folder / name) if name.endswith((".toml", ".json")) else name


def _programme(table: Any, kinds: Mapping[str, type], where: str) -> Any:
    entry = dict(cast(dict[str, Any], table)) if isinstance(table, dict) else {}
    name = str(entry.pop("kind", ""))
    if name not in kinds:
        raise UnknownName(f"kind of push or reference in {where}", name, kinds)
    return programme(kinds[name], entry, f"{where}: {name}")


def _check(table: Any, kinds: Mapping[str, type], where: str) -> None:
    if not isinstance(table, dict):
        raise InvalidScenario(f"{where} is {table!r}", expected="a table")
    for key, value in cast(dict[str, Any], table).items():
        if key not in kinds:
            raise UnknownName(f"entry of {where}", key, kinds)
        kind = kinds[key]
        good = is_number(value) if kind in (int, float) else isinstance(value, kind)
        if not good or (kind is int and int(value) != value):
            raise InvalidScenario(f"{where}: {key} is {value!r}", expected=_WORDS[kind])
        if key in _TEXTS and not all(isinstance(entry, str) for entry in value):
            raise InvalidScenario(f"{where}: {key} is {value!r}", expected="a list of texts in quotes")
