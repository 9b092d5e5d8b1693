"""What answers a command: models and the twin, and the electronics round any of them.

`BODIES` names every body there is: a new one is one file and one line here, `my.py:Cart`, or an entry point of the
group `upright.bodies`, as the real bricks of `links` and those of other packages are.
"""

from collections.abc import Callable

from upright.bodies.body import Body as Body
from upright.bodies.body import BodySpec as BodySpec
from upright.bodies.body import Sample as Sample
from upright.bodies.electronics import Electronics as Electronics
from upright.bodies.electronics import without_missing
from upright.bodies.models import LinearBody as LinearBody
from upright.bodies.models import NonlinearBody as NonlinearBody
from upright.physics.linear import linearise_rolling
from upright.plugins import Registry, made
from upright.robots import Kit, Robot


def _twin(robot: Robot) -> Body:
    from upright.bodies.twin import Twin  # MuJoCo is slow to load

    return Twin(robot)


BODIES: Registry[Callable[[Robot], Body]] = Registry(
    "body",
    "upright.bodies",
    {
        "twin": _twin,
        "nonlinear": NonlinearBody,
        "published": lambda robot: NonlinearBody(robot, "published"),
        "linear": lambda robot: LinearBody(linearise_rolling(robot), robot),
    },
    lambda name, plugin: lambda robot: made(f"body {name}", Body, plugin, robot),
)


def make_body(name: str, robot: Robot) -> Body:
    """The body of that name round `robot`: registered, installed, or `file.py:Class`.

    Raises `UnknownName`, which lists them, or `InvalidPlugin` for one from outside that cannot be made.
    """
    return BODIES[name](robot)


def equipped(name: str, robot: Robot, kit: Kit) -> Electronics:
    """The body of that name behind the electronics of `kit`; the ideal kit has whatever the body offers."""
    body = make_body(name, robot)
    return Electronics(body, without_missing(kit, body) if kit.name == "ideal" else kit)
