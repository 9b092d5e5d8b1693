"""A Pybricks program calls what Pybricks has: its names and arguments against the official API package."""

from __future__ import annotations

import ast
import inspect
from functools import reduce
from typing import Any

import pytest

from firmware_cases import EV3, ROBOT, SPIKE, frozen
from upright.firmware import generate

pytestmark = pytest.mark.needs("module:pybricks", "module:usys")

HUBS = {"prime": SPIKE, "technic": SPIKE, "ev3": EV3}  # the package does not have the NXT, which is an experiment
MADE = {"hub": "Hub", "left": "Motor", "right": "Motor", "watch": "StopWatch"}
"""Variable of the program → what it is made of."""


def chain(node: ast.expr) -> list[str]:
    """The names of a.b.c, or nothing for any other expression."""
    names: list[str] = []
    while isinstance(node, ast.Attribute):
        names.insert(0, node.attr)
        node = node.value
    return [node.id, *names] if isinstance(node, ast.Name) else []


@pytest.mark.parametrize("name", HUBS)
def test_every_call_of_a_program_is_one_of_the_official_api(name: str) -> None:
    tree = ast.parse(generate(frozen(), ROBOT, HUBS[name], "pybricks", hub=name).text)
    api: dict[str, Any] = {}
    imports: list[ast.stmt] = [node for node in tree.body if isinstance(node, ast.Import | ast.ImportFrom)]
    exec(compile(ast.Module(imports, []), name, "exec"), api)  # every name that it imports exists
    sensor = "GyroSensor" if "GyroSensor" in api else "Hub"
    known = {variable: api[kind] for variable, kind in (MADE | {"gyro_sensor": sensor}).items()}
    checked = 0
    for call in (node for node in ast.walk(tree) if isinstance(node, ast.Call)):
        owner, *attributes = chain(call.func) or [""]
        if owner in known and attributes:
            function = reduce(getattr, attributes, known[owner])
            bound = len(attributes) > 1  # a part of the hub is an object, the others are classes here
            inspect.signature(function).bind(*([] if bound else [None]), *call.args)
            checked += 1
    used = {tuple(chain(node)) for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    for owner, attribute in (
        (c[0], c[1]) for c in used if len(c) == 2 and c[0] in ("Axis", "Color", "Direction", "Port")
    ):
        assert hasattr(api[owner], attribute), f"{owner}.{attribute}"
    assert checked >= 12
