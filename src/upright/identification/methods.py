"""The methods that give a linear model from a log. A new one is one file and one line here."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from upright.errors import UnknownName
from upright.identification.grey_box import calibrated
from upright.identification.instrumental import instrumental
from upright.identification.rebuilt import least_squares_part, total_least_squares
from upright.identification.samples import Part
from upright.identification.study import MethodFit, PartFit, Study, by_part
from upright.identification.subspace import subspace
from upright.pages import Say
from upright.physics.linear import LinearModel

Identifier = Callable[[Study], MethodFit]


def _per_part(fit: PartFit) -> Identifier:
    return partial(by_part, fit)


def _least_squares(part: Part, _study: Study) -> LinearModel:
    return least_squares_part(part)


def _total(part: Part, _study: Study) -> LinearModel:
    return total_least_squares(part)


def _instrumental(part: Part, study: Study) -> LinearModel:
    return instrumental(part, study.orders[part.name].model)


def _subspace(part: Part, study: Study) -> LinearModel:
    order = study.orders[part.name]
    return subspace(part, order.chosen, order.past)


IDENTIFIERS: dict[str, Identifier] = {
    "least-squares": _per_part(_least_squares),
    "total-least-squares": _per_part(_total),
    "instrumental": _per_part(_instrumental),
    "subspace": _per_part(_subspace),
    "calibrate": calibrated,
}

TITLES = {
    "least-squares": Say("regression on rebuilt states (Herrera et al. 2015)"),
    "total-least-squares": Say("regression with errors in all rebuilt states"),
    "instrumental": Say("regression that noise in the loop does not bias"),
    "subspace": Say("a state-space model from the log alone"),
    "calibrate": Say("the robot's file, corrected by the log"),
}


def find_identifier(name: str) -> Identifier:
    """The registered method of that name; `UnknownName` lists them."""
    if name not in IDENTIFIERS:
        raise UnknownName("method", name, [*IDENTIFIERS, "all"])
    return IDENTIFIERS[name]
