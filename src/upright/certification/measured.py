"""What a certificate measured, as data: what its page shows, and its file keeps."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from upright.certification.narrowing import MOST_NAMES
from upright.certification.standing import Endured, Strength, Swept
from upright.certification.verdict import UNKNOWN, Examined, Reason, judge
from upright.robots.facts import Facts


@dataclass(frozen=True, kw_only=True)
class Measurements(Examined):
    """The measurements of the controller with this `hash`, every `period` [s], and the `light` that follows from them.

    It belongs to that controller, by its `hash`, or by the request of its design, `asked`, and its `response` (see
    `control.identity`). Its `subject` is every number of robot and kit, by name; `robot` and `kit` are their names.
    `bound` is the upper bound of the probability of a fall, with 95 % confidence; what motors that are too weak would
    need is `strength`. What the file's robot endures is `endured`. `delayed` and `slower` count robots that fall, left
    alone, with additional dead time and with other periods. The robot `weighed` so much [kg] on a scale (None: not
    weighed). `given` is the file or the name by which the controller was asked for ("": an object).
    """

    light: str
    bound: float
    robot: str
    kit: str
    controller: str
    hash: str
    seed: int
    endured: tuple[Endured, ...] = ()
    strength: Strength | None = None
    delayed: tuple[Swept, ...] = ()
    slower: tuple[Swept, ...] = ()
    subject: Mapping[str, Facts]
    asked: str = ""
    response: tuple[float, ...] = ()
    weighed: float | None = None
    given: str = ""

    @property
    def reasons(self) -> tuple[Reason, ...]:
        """Why the light is what it is: one or two, the gravest first."""
        _, reasons = judge(self)
        return reasons

    def to_measure(self) -> list[str]:
        """The parameters that would have to be known better where robots fall, the one that decides most first."""
        if self.reasons[0].kind not in ("spread", "measure"):
            return []
        needed = [spread.name for spread in self.narrowing.spreads] if self.narrowing else []
        guesses = self.guessed.names[:MOST_NAMES] if self.light == UNKNOWN and self.guessed else ()
        return needed or [*guesses]
