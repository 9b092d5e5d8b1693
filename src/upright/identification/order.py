"""The order of a model: singular values of the past's prediction, and the Bayesian information criterion (BIC)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.errors import InvalidModel
from upright.identification.arx import longer, past_window
from upright.identification.coordinates import PHYSICAL
from upright.identification.samples import Part
from upright.identification.subspace import LARGEST, InnovationModel, predicted_states


@dataclass(frozen=True, eq=False)
class OrderChoice:
    """The `chosen` order of a half; `bic` (Schwarz 1978) of each order tried, inf where it predicts nothing.

    `past` is the number of rows behind the prediction (more than those behind the BIC), `singular` its values, largest
    first.
    """

    part: str
    chosen: int
    past: int
    bic: Mapping[int, float]
    singular: Array
    model: InnovationModel

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; a BIC that is not finite is null."""
        bic = {str(n): finite(value) for n, value in self.bic.items()}
        return {"chosen": self.chosen, "past": self.past, "bic": bic, "singular": self.singular.tolist()}


def choose_order(part: Part, order: int | None = None, past: int | None = None) -> OrderChoice:
    """The order under which N ln det S + d ln N is least: S is the covariance of the one-step errors of the predictor
    run along the log, d the number of parameters. `order` asks for one, at least that of the physical states.

    Raises `InvalidModel` where no order predicts the log.
    """
    least = len(PHYSICAL[part.name])
    if order is not None and not least <= order <= least + 2 * LARGEST:
        raise InvalidModel(
            f"order {order} of {part.name}", expected=f"{least} to {least + 2 * LARGEST}: its physical states and more"
        )
    short = past or past_window(part.y, part.u)
    states = predicted_states(part, short)
    if part.states:  # they are given, and without noise no criterion means anything
        return OrderChoice(part.name, least, short, {least: 0.0}, states.singular[: least + 1], states.of_order(least))
    tried = [order] if order is not None else list(range(least, least + LARGEST + 1))
    scores = {n: _bic(part, states.of_order(n)) for n in tried}
    best = min(scores, key=lambda n: scores[n])
    lags = past or longer(short, part.y)
    final = predicted_states(part, lags)
    model = final.of_order(best)
    if not (np.isfinite(scores[best]) and model.predicts):
        raise InvalidModel(
            f"no model of {tried[0]} to {tried[-1]} states predicts the {part.name} of this log",
            likely="too little excitation, or a robot that is held or lies on the floor", hint="see `upright doctor`",
        )  # fmt: skip
    return OrderChoice(part.name, best, lags, scores, final.singular[: least + LARGEST + 4], model)


def _bic(part: Part, model: InnovationModel) -> float:
    if not model.predicts:
        return np.inf
    e = model.one_step(part.y, part.u)[len(part.y) // 10 :]
    size = len(e)
    m = part.y.shape[1]
    if not np.isfinite(e).all() or np.abs(e).max() > 1e6:
        return np.inf
    count = len(model.plant.A) * (2 * m + 1)
    return float(size * np.linalg.slogdet(e.T @ e / size + 1e-30 * np.eye(m))[1] + count * np.log(size))
