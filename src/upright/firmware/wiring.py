"""The constants at the head of a program in C or NXC, and how an NXT is wired by them."""

from __future__ import annotations

import re

from upright.errors import InvalidController
from upright.links.brick import Wiring

MOTORS = {"OUT_A": 0, "OUT_B": 1, "OUT_C": 2}
SENSORS = {"S1": 0, "S2": 1, "S3": 2, "S4": 3}
CHOICES = {"LEFT": MOTORS, "RIGHT": MOTORS, "GYRO": SENSORS, "COMPASS": SENSORS, "GYRO_SIGN": {"1": 1, "-1": -1}}


def defined(text: str, name: str) -> str:
    """The word that `#define name` gives; empty where the text has no such line."""
    constant = re.search(rf"^#define {name}\s+(\S+)", text, re.MULTILINE)
    return constant[1] if constant else ""


def nxt_wiring(text: str) -> Wiring:
    """The wiring that a program in NXC is written for; `InvalidController` for constants that leave it open."""
    numbers: dict[str, int] = {}
    for name, choices in CHOICES.items():
        word = defined(text, name)
        if word and word not in choices:
            raise InvalidController(f"{name} is {word}", expected=" or ".join(choices))
        numbers |= {name.lower(): choices[word]} if word else {}
    wiring = Wiring(**numbers)
    if wiring.left == wiring.right:
        raise InvalidController("LEFT and RIGHT are the same port", expected="two motors")
    return wiring
