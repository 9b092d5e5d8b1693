"""How many states a log shows: the singular values of what its past foretells, and a criterion that counts the cost."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.errors import InvalidModel
from upright.identify.arx import longer, past_window
from upright.identify.coordinates import PHYSICAL
from upright.identify.samples import Part
from upright.identify.subspace import LARGEST, Innovation, predicted_states

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Order:
    """The `chosen` order of a half; `criterion` (Schwarz 1978) of each order tried, inf where it foretells nothing.

    `past` is the number of rows behind the prediction (longer than the one behind the criterion), `singular` its
    values, largest first.
    """

    part: str
    chosen: int
    past: int
    criterion: Mapping[int, float]
    singular: Array
    model: Innovation

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; a criterion that is not finite is null."""
        said = {str(n): value if np.isfinite(value) else None for n, value in self.criterion.items()}
        return {"chosen": self.chosen, "past": self.past, "criterion": said, "singular": self.singular.tolist()}


def choose_order(part: Part, order: int | None = None, past: int | None = None) -> Order:
    """The order under which N ln det S + d ln N is least: S is the covariance of the one-step errors of the predictor
    run along the log, d the number of parameters. `order` asks for one, at least that of the physical states.

    Raises `InvalidModel` where no order foretells the log.
    """
    least = len(PHYSICAL[part.name])
    if order is not None and not least <= order <= least + 2 * LARGEST:
        raise InvalidModel(
            f"order {order} of {part.name}", expected=f"{least} to {least + 2 * LARGEST}: its physical states and more"
        )
    short = past or past_window(part.y, part.u)
    if part.states:  # they are what they are, and without noise no criterion means anything
        states = predicted_states(part, short)
        return Order(part.name, least, short, {least: 0.0}, states.singular[: least + 1], states.of_order(least))
    states = predicted_states(part, short)
    tried = [order] if order is not None else list(range(least, least + LARGEST + 1))
    scores = {n: _schwarz(part, states.of_order(n)) for n in tried}
    best = min(scores, key=lambda n: scores[n])
    lags = past or longer(short, part.y)
    final = predicted_states(part, lags)
    model = final.of_order(best)
    if not (np.isfinite(scores[best]) and model.foretells):
        raise InvalidModel(
            f"no model of {tried[0]} to {tried[-1]} states foretells the {part.name} of this log",
            likely="too little excitation, or a robot that is held or lies", hint="see `upright doctor`",
        )  # fmt: skip
    return Order(part.name, best, lags, scores, final.singular[: least + LARGEST + 4], model)


def _schwarz(part: Part, model: Innovation) -> float:
    if not model.foretells:
        return np.inf
    e = model.one_step(part.y, part.u)[len(part.y) // 10 :]
    size, m = len(e), part.y.shape[1]
    if not np.isfinite(e).all() or np.abs(e).max() > 1e6:
        return np.inf
    count = len(model.A) * (2 * m + 1)
    return float(size * np.linalg.slogdet(e.T @ e / size + 1e-30 * np.eye(m))[1] + count * np.log(size))
