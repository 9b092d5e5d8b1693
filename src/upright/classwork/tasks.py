"""The tasks of the worksheet: what is given, and what counts as done."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import KW_ONLY, dataclass, fields

from upright.lab.handin import HandIn, RunResult
from upright.lab.messages import Setup, Strike
from upright.lab.plant import LOAD
from upright.pages import Quantity, Say

HELD = 3.0
"""[s] that a named hold lasts."""

KNOCK = 0.2
"""[N s] to come back from, as the text of the task says."""

Goal = Callable[[HandIn, RunResult], Say | None]
"""None where the run reaches the goal, else why not."""


@dataclass(frozen=True)
class Task:
    """A task `name`, which the seed of its `setup` identifies. The fields in `given` may not be changed; `goal` judges
    the run that was replayed. `texts`: title, what to do, what to ask oneself, by language."""

    name: str
    setup: Setup
    given: tuple[str, ...]
    goal: Goal
    _: KW_ONLY
    texts: dict[str, tuple[str, str, str]]

    def differs(self, setup: Setup) -> Say | None:
        """Which given field the set-up changes; None for none."""
        changed = [name for name in self.given if getattr(setup, name) != getattr(self.setup, name)]
        return Say("not as the task gives it: `{field}`", field=changed[0]) if changed else None


def task_of(done: HandIn) -> Task | None:
    """The task that a hand-in is for, by its seed; None for a run of one's own."""
    return next((task for task in TASKS if task.setup.seed == done.setup.seed), None)


def _stood(result: RunResult, seconds: float) -> Say | None:
    if result.fell:
        return Say("it fell at {time}", time=Quantity(result.seconds, "s"))
    if result.seconds < seconds - 0.1:
        return Say("it lasts {time}, not {goal}", time=Quantity(result.seconds, "s"), goal=Quantity(seconds, "s"))
    return None


def _held(done: HandIn, result: RunResult) -> Say | None:
    """Held in front at 0.1 rad or more, released, and still up five seconds after the release."""
    times = [t for t, a in done.actions if isinstance(a, Strike) and a.what == "front" and a.size >= 0.1]
    return _stood(result, times[0] + HELD + 5.0) if times else Say("it was not held from the front")


def _knocked(done: HandIn, result: RunResult) -> Say | None:  # noqa: ARG001
    if result.best >= KNOCK:
        return _stood(result, 0.0)
    best = Quantity(result.best, "N s")
    return _stood(result, 0.0) or Say(
        "it survived a knock of {best}, not {goal}", best=best, goal=Quantity(KNOCK, "N s")
    )


_ROBOT = tuple(f.name for f in fields(Setup) if f.name not in ("controller", "largest", "gains", "bodies"))
"""Everything but the controller and which bodies are shown."""

_BODIES = ("nonlinear", "linear")

TASKS = (
    Task("push", Setup(bodies=_BODIES, seed=1901), _ROBOT, _knocked, texts={
        "es": ("El mayor golpe", "Golpee el robot y deje que se recupere. Llegue al menos a 0,2 N s.",
               "¿Por qué hay un golpe del que ningún controlador lo salva? Mire *Ver → Tensión*."),
        "en": ("The largest knock", "Knock the robot and let it recover. Reach 0.2 N s at least.",
               "Why is there a knock from which no controller saves it? Look at *See → Voltage*."),
    }),
    Task("gains", Setup(bodies=_BODIES, seed=1902, controller="gains", gains=(-15.0, -1.0, 0.0, -0.5, 0.0, 0.0)),
         (*_ROBOT, "controller"), _held, texts={
        "es": ("A mano", "Ajuste las ganancias hasta que el robot soporte *Sostener por delante* y siga de pie 5 s "
               "después de soltarlo.",
               "¿Qué ganancia evita que se aleje rodando? ¿Cuál amortigua el balanceo?"),
        "en": ("By hand", "Move the gains until the robot survives *Hold from the front* and still stands 5 s after "
               "its release.",
               "Which gain keeps it from rolling away? Which one damps it?"),
    }),
    Task("payload", Setup(bodies=_BODIES, seed=1903, payload=LOAD[0], payload_height=LOAD[1]), _ROBOT, _held, texts={
        "es": ("Una carga desconocida", "El robot lleva 300 g a 30 cm sobre el eje. Elija un controlador con el que "
               "el robot soporte *Sostener por delante* y siga de pie 5 s después de soltarlo.",
               "El controlador no conoce la carga. ¿Qué margen lo salva?"),
        "en": ("An unknown payload", "The robot carries 300 g, 30 cm above the axle. Choose a controller that survives "
               "*Hold from the front* and still stands 5 s after its release.",
               "The controller does not know the payload. Which margin saves it?"),
    }),
)  # fmt: skip
