"""The pushes that every robot of a certificate gets: two holds and a knock, in the measure of what can be survived."""

from __future__ import annotations

from typing import NamedTuple

from upright.certification.recovery import KNOCK_DURATION, largest_hold, largest_knock
from upright.experiment.pushes import Hold, Impulse
from upright.robots import Kit, Robot

KINDS = ("front", "back", "knock")
"""A hold to the front, one to the back, and a knock."""
RELEASE = 3.0  # [s] a hold of this length lets every preset come to rest against it
HELD, KNOCKED = 0.4, 0.6
"""Sizes of the standard pushes over the largest that any controller could survive on the nominal robot with that
battery and slope.

A controller does not know when a hold ends. Feedback that moves the falling pole from λ to −(g − 1) λ survives 1 − 1/g
of the largest hold: half with the least effort (g = 2), which default controllers exceed by little. Of the largest
knock it survives nearly all. So less is asked of holds."""
MOST_HOLD, MOST_KNOCK = 0.4, 0.5
"""[rad], and [m/s] of the body's speed: no standard push is larger, however strong the motors. They bound what is asked
of kits without limits, and of twipr: from 0.6 of its largest knock a fifth of its spreads falls under any controller.
"""


class StandardPush(NamedTuple):
    """A `push` of a `size` [rad or N s], and the largest size that any controller could survive, its `bound`."""

    push: Hold | Impulse
    size: float
    bound: float


def standard_pushes(
    robot: Robot, kit: Kit, battery: float | None = None, slope: float = 0.0
) -> dict[str, StandardPush]:
    """A hold to the front and one to the back, each until its release, and an impulse at the centre of mass, by name.

    A hold has `HELD` and the knock `KNOCKED` of the size that any controller could survive with this `battery` [V]
    (None: the kit's) on this `slope` [rad], at most `MOST_HOLD` and `MOST_KNOCK`. All are zero where no controller
    could stand there.
    """
    front, back = (largest_hold(robot, kit, side, battery=battery, slope=slope) for side in (1, -1))
    knock = largest_knock(robot, kit, battery=battery, slope=slope)
    most = MOST_KNOCK * robot.body_mass
    ahead, behind = (_size(HELD * bound, MOST_HOLD) for bound in (front, back))
    knocked = _size(KNOCKED * knock, most)
    return {
        f"hold at {ahead:+.2f} rad": StandardPush(Hold(pitch=ahead, until=RELEASE), ahead, front),
        f"hold at {-behind:+.2f} rad": StandardPush(Hold(pitch=-behind, until=RELEASE), behind, back),
        f"knock of {knocked:.3g} N s": StandardPush(
            Impulse(impulse=knocked, start=1.0, duration=KNOCK_DURATION), knocked, knock
        ),
    }


def _size(size: float, most: float) -> float:
    """At most that, and three digits of it, so that the last bits of a search do not matter."""
    return float(f"{min(size, most):.3g}")
