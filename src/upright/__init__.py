"""upright: the workbench for two-wheeled balancing robots.

Names are loaded when they are first used, so that `import upright` is quick.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from upright.bodies import Electronics, LinearBody, NonlinearBody
    from upright.bodies.twin import Twin
    from upright.comparison import compare
    from upright.control import (
        Estimated,
        StateFeedback,
        complementary,
        hinf,
        kalman,
        lqg,
        lqi,
        lqr,
        mpc,
        pid,
        robust,
        sliding,
    )
    from upright.errors import UprightError
    from upright.experiment import Drive, Hold, Impulse, Push, Slope, Turn, run
    from upright.physics.linear import LinearModel, linearise
    from upright.robots import Kit, Robot
    from upright.signals import Log, Signal

_HOME = {
    "upright.bodies": ("Electronics", "LinearBody", "NonlinearBody"),
    "upright.bodies.twin": ("Twin",),
    "upright.comparison": ("compare",),
    "upright.control": (
        "Estimated", "StateFeedback", "complementary", "hinf", "kalman", "lqg", "lqi", "lqr", "mpc", "pid",
        "robust", "sliding",
    ),
    "upright.errors": ("UprightError",),
    "upright.experiment": ("Drive", "Hold", "Impulse", "Push", "Slope", "Turn", "run"),
    "upright.physics.linear": ("LinearModel", "linearise"),
    "upright.robots": ("Kit", "Robot"),
    "upright.signals": ("Log", "Signal"),
}  # fmt: skip
_MODULE = {name: module for module, names in _HOME.items() for name in names}

__all__ = [  # noqa: RUF022 (grouped by room, from the ground up)
    "UprightError", "Log", "Signal", "Kit", "Robot", "LinearModel", "linearise",
    "Electronics", "LinearBody", "NonlinearBody", "Twin",
    "Estimated", "StateFeedback", "complementary", "hinf", "kalman", "lqg", "lqi", "lqr", "mpc", "pid", "robust",
    "sliding", "Drive", "Hold", "Impulse", "Push", "Slope", "Turn", "run", "compare",
]  # fmt: skip


def __getattr__(name: str) -> Any:
    if name not in _MODULE:
        raise AttributeError(f"module 'upright' has no attribute '{name}'")
    return getattr(import_module(_MODULE[name]), name)


def __dir__() -> list[str]:
    return sorted(__all__)
