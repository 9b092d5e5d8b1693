"""Controllers as files: JSON of everything that decides a command, with the hash that identifies it."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from upright.atomic import write_json
from upright.control.controller import Controller, controller_hash
from upright.control.design import gain_of
from upright.control.estimators import Complementary, Estimated, Estimator, Kalman
from upright.control.feedback import StateFeedback
from upright.control.identity import asked_of, designed_from
from upright.control.linear_controller import LinearController
from upright.control.mpc import PredictiveController
from upright.control.pid_angle import AnglePid
from upright.control.sliding import SlidingMode
from upright.errors import InvalidController
from upright.reading import check_types, read_json, understood

VERSION = 1


def write_controller(controller: Controller, path: str | Path) -> Path:
    """Write `controller` as JSON and return the path; `InvalidController` for a kind that no file can bring back."""
    form = _form(controller)
    data = {"file": "upright controller", "version": VERSION, "form": form, "hash": controller_hash(controller)}
    data |= {"asked": asked_of(controller)}
    gain = gain_of(controller)
    if gain is not None:  # for readers: K of u = −K x decides nothing here
        data["gain"] = gain.tolist()
    return write_json(path, data | {"controller": controller.to_json()})


def read_controller(path: str | Path) -> Controller:
    """The controller of a file by `write_controller`, commanding alike to rounding.

    Raises `InvalidController` for a file that is none, is broken, or was changed: its hash then does not fit. One of
    form "pid-angle" may be written by hand, without a hash.
    """
    data = _read(Path(path))
    form = data.get("form")
    if not isinstance(form, str) or form not in FORMS:
        raise InvalidController(f"{path} holds a controller of form {form!r}", expected="one of " + ", ".join(FORMS))
    with understood(str(path), InvalidController, "JSON by upright design -o"):
        controller = FORMS[form](data["controller"])
        check_types(controller)
    by_hand = form == AnglePid.form and "hash" not in data
    if not by_hand and controller_hash(controller) != data.get("hash"):
        raise InvalidController(
            f"{path} was changed after it was written: its hash does not fit", likely="an edit by hand",
            hint="take hash and asked out of it" if form == AnglePid.form else "design the controller anew",
        )  # fmt: skip
    return designed_from(controller, str(data.get("asked", "")))


def _read(path: Path) -> dict[str, Any]:
    data = read_json(path, InvalidController, "a controller file, JSON by upright design -o")
    if not isinstance(data, dict) or data.get("file") != "upright controller":
        raise InvalidController(f"{path} is no controller file", expected="JSON by upright design -o")
    if data.get("version") != VERSION:
        raise InvalidController(f"{path} is of version {data.get('version')}", expected=f"version {VERSION}")
    return data


def _form(controller: Controller) -> str:
    form = getattr(controller, "form", "")
    if form in FORMS:
        return form
    raise InvalidController(f"a {controller.spec.kind} cannot be written", expected="one of " + ", ".join(FORMS))


def _feedback(data: dict[str, Any]) -> StateFeedback:
    return StateFeedback(np.array(data["gain"]), data["period"], data["command_unit"], data["kind"])


def _estimated(data: dict[str, Any]) -> Estimated:
    return Estimated(_feedback(data["controller"]), _estimator(dict(data["estimator"])))


def _estimator(data: dict[str, Any]) -> Estimator:
    kind = data.pop("kind")
    reads = tuple(data.pop("reads"))
    if kind == "complementary filter":
        return Complementary(**data)
    matrices = {name: np.array(data[name], dtype=np.float64) for name in "ABCL"}
    return Kalman(**matrices, reads=reads)


FORMS: dict[str, Callable[[dict[str, Any]], Controller]] = {
    "state feedback": _feedback,
    "estimated state feedback": _estimated,
    "linear": LinearController.from_json,
    "sliding": SlidingMode.from_json,
    "mpc": PredictiveController.from_json,
    AnglePid.form: AnglePid.from_json,
}
"""What a file can hold, and how it comes back; a new form is one line."""
