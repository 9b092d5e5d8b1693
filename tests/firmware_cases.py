"""What the tests of generated programs share: one frozen design, and programs of it in a folder."""

from __future__ import annotations

from functools import cache
from pathlib import Path

from upright.control import LinearController, make_controller, read_controller
from upright.control.controller import Controller
from upright.firmware import Firmware, generate
from upright.robots import Kit, Robot

GOLDEN = Path(__file__).parent / "golden" / "firmware"

ROBOT, NXT, SPIKE, EV3 = Robot.preset("nxtway-gs"), Kit.preset("nxt"), Kit.preset("spike"), Kit.preset("ev3")


def frozen() -> LinearController:
    """The LQG of `controller.json`, which no change of a design method changes."""
    controller = read_controller(GOLDEN / "controller.json")
    assert isinstance(controller, LinearController)
    return controller


@cache
def designed(name: str) -> Controller:
    """A registered controller of NXTway-GS on the NXT."""
    return make_controller(name, ROBOT, NXT, 0.01)


def written(
    folder: Path, target: str, kit: Kit = NXT, controller: Controller | None = None, **options: object
) -> tuple[Path, Firmware]:
    """A program on disk, and what it was made from."""
    made = generate(controller or frozen(), ROBOT, kit, target, **options)  # type: ignore[arg-type]
    suffix = next(iter(made.files))
    return made.write(folder / f"balance{suffix}")[0], made
