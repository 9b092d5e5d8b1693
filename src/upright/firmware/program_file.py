"""A generated program on disk, with the robot, kit and controller that it was made from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from upright import reading
from upright.compiled.program import Program
from upright.control import find_controller
from upright.control.controller import Controller
from upright.control.identity import Identity, identity
from upright.errors import InvalidController
from upright.firmware.generate import Firmware, generate, head, longest_run
from upright.robots import Kit, Robot, find_kit, find_robot


@dataclass(frozen=True, eq=False, kw_only=True)
class ProgramFile:
    """The `text` at `path` and its `head`; `firmware` is what is generated from the same controller now."""

    path: Path
    text: str
    head: dict[str, str]
    robot: Robot
    kit: Kit
    controller: Controller
    firmware: Firmware

    @property
    def program(self) -> Program:
        """With the hash in its head, which is what its logs say: that of another processor differs."""
        return replace(self.firmware.program, hash=self.head["hash"])

    @property
    def longest(self) -> int:
        """Time [s] after which the program stops by itself; 0 for never."""
        return longest_run(self.text)

    @property
    def as_generated(self) -> bool:
        """Whether the text is the generated one: not edited, and not of another version."""
        return self.text in self.firmware.texts(self.path).values()


def read_program(
    path: str | Path,
    controller: Controller | str | Path,
    robot: Robot | str | Path | None = None,
    kit: Kit | str | Path | None = None,
) -> ProgramFile:
    """A program by `upright firmware`, made from that controller; robot and kit are those of its head by default.

    Raises `InvalidController` for a text without a head, and for a program of another controller.
    """
    source, text = Path(path), read_text(path)
    facts = head(text)
    chosen = find_robot(robot or facts["robot"])
    parts = find_kit(kit or _kit_of(chosen, facts["kit"]))
    design = find_controller(controller, chosen, parts, parts.period)
    if other := identity(design).differs(_identity(facts)):
        raise InvalidController(
            f"{source} holds another controller than this: {other}",
            hint="generate the program again, or name the controller it was made from",
        )  # fmt: skip
    made = generate(
        design, chosen, parts, facts["target"], number=facts["number"], hub=facts.get("hub", "prime"),
        reference="reference" in facts, seconds=longest_run(text),
    )  # fmt: skip
    return ProgramFile(path=source, text=text, head=facts, robot=chosen, kit=parts, controller=design, firmware=made)


def _kit_of(robot: Robot, name: str) -> Kit | str:
    """The robot's own electronics where they have that name, else the name."""
    return robot.kit if robot.kit_name == name else name


def _identity(facts: Mapping[str, str]) -> Identity:
    """The controller in a program's head; a response that is no list of numbers is none."""
    try:
        response = tuple(map(float, facts.get("response", "").split()))
    except ValueError:
        response = ()
    return Identity(facts["hash"], facts.get("asked", ""), response)


def read_text(path: str | Path) -> str:
    """The text of a program; `InvalidController` for a file that cannot be read or is not text."""
    return reading.read_text(path, InvalidController, "a program by upright firmware")
