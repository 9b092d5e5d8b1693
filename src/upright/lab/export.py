"""The lab as one page without Python: robots, electronics and designed controllers printed into it."""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from pathlib import Path
from typing import Any

from upright.atomic import make_folder, place_of, write_text
from upright.compiled.print_javascript import JavaScriptPrinter, functions
from upright.control import CONTROLLERS, gain_of
from upright.control.delay import RAW
from upright.errors import InvalidRobot, UnknownName, UprightError, check_within
from upright.lab.by_hand import gains_program
from upright.lab.codec import plain
from upright.lab.messages import VERSION, Setup, Welcome
from upright.lab.plant import BY_HAND, EXPORTED, LOAD, OFF, Plant, behind, body_of, families, is_bare, loaded
from upright.lab.printed import linear_plant, printed_law, printed_robot, reading
from upright.lab.recording import MARK, inlined, page_text
from upright.lab.tasks import analysed
from upright.lab.views import catalogue, equations, look_of, robot_info, titles_of
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_kit, find_robot, kit_names, preset_names

PAGE = "index.html"
NAME = "uprightExport"
"""What the page's data is called in it; a page that has it is an exported lab."""

NOT_USUAL = ("robust", "lqr-complementary")
"""Made only where they are asked for: a design of a minute or more for each robot, and one that is no `Law`."""

KEPT = 2
"""Of the broken loop's frequencies, which the page knows, one in so many is kept: the page stays small."""

MOST_ROBOTS = 12
"""About 150 kB each: a page should stay below 2 MB."""


def export(
    folder: str | Path,
    robots: Sequence[Robot | str] = (),
    controllers: Sequence[str] = (),
    *,
    say: Callable[[str], None] = print,
    progress: Progress = unwatched,
) -> Path:
    """Write the lab's page into `folder` and return its path: these `robots` (none: every preset), each behind its own
    kit with every one of these `controllers` (none: all but `NOT_USUAL`) that it can have. `say` receives each
    robot's name when it is begun and what was left out, `progress` the fraction done.

    Raises `UprightError` for a folder that holds another page, `UnknownName`, and whatever a robot is refused for.
    """
    path = _place(Path(folder))
    chosen = [find_robot(robot) for robot in robots or preset_names()]
    check_within("robots in a page", len(chosen), 1, MOST_ROBOTS)
    names = [robot.name for robot in chosen]
    for name in set(names):
        if names.count(name) > 1:
            raise InvalidRobot(f"two robots are called {name}", expected="a name for each", hint="rename one")
    for name in controllers:
        if name not in CONTROLLERS:
            raise UnknownName("controller", name, CONTROLLERS)
    make_folder(path.parent)
    place_of(path)  # refused now, and not after all designs
    methods = list(controllers) or [f.name for f in families() if f.name not in (BY_HAND, OFF, *NOT_USUAL)]
    page = inlined(page_text())
    ready = list[PrintedRobot]()
    for k, robot in enumerate(chosen):

        def show(fraction: float, k: int = k) -> None:
            progress((k + fraction) / len(chosen))

        number = k + 1
        say(f"{robot.name}: robot {number} of {len(chosen)}, with {len(methods)} methods of design")
        ready.append(printed(robot, methods, say=say, load=LOAD, progress=show))
    return write_text(path, page.replace(MARK, f"<script>{exported_script(ready)}</script>"))


def _place(folder: Path) -> Path:
    """Where the page goes: never over somebody else's."""
    if folder.suffix in (".html", ".htm"):
        raise UprightError(f"{folder.name} names a page", expected="a folder", hint=f"--export {folder.stem}")
    if folder.exists() and not folder.is_dir():
        raise UprightError(f"{folder} is no folder", expected="a folder, or nothing there yet")
    path = folder / PAGE
    if path.is_file() and NAME not in path.read_text("utf-8", "replace"):
        hint = "choose another folder"
        raise UprightError(f"{path} is another page", expected="a folder without one, or an exported lab", hint=hint)
    return path


@dataclass(frozen=True)
class PrintedRobot:
    """A robot's `motion`, that under a payload (or nothing) and its controllers' `laws` as JavaScript, and the other
    `facts` as JSON has them."""

    robot: Robot
    motion: str
    laden: str
    laws: Mapping[str, str]
    facts: Mapping[str, Any]


def printed(
    robot: Robot, methods: Sequence[str], *, say: Callable[[str], None], load: tuple[float, float] | None = None,
    progress: Progress = unwatched,
) -> PrintedRobot:  # fmt: skip
    """The robot behind its own kit, with the controllers of these `methods`, and with a `load` [kg, m] that can be put
    on it; `progress` receives the fraction done. Raises `InvalidRobot` if none of the controllers fits."""
    kit = find_kit(robot.kit)
    motion, numbers = printed_robot(robot, kit)
    laden = printed_robot(loaded(robot, *load), kit)[0] if load else ""
    numbers["laden"] = _shown(robot, kit, load) if load else None
    laws: dict[str, str] = {}
    controllers: dict[str, Any] = {}
    for k, name in enumerate(methods):
        progress(k / len(methods))
        try:
            laws[name], controllers[name] = _designed(robot, kit, name)
        except UprightError as error:
            say(f"{robot.name} goes without {name}: {str(error).partition(';')[0]}")
    if not laws:
        raise InvalidRobot(f"no controller that was asked for fits {robot.name}", hint="leave out --controller")
    if not is_bare(kit) and set(RAW) <= set(kit.sensors):
        gains = next((c["gains"] for name in ("lqr", *laws) if (c := controllers.get(name)) and c["gains"]), [0.0] * 6)
        laws[BY_HAND] = JavaScriptPrinter(gains_program(robot, kit)).text()
        own = {"kind": "gains by hand", "gains": gains, "plant": linear_plant(robot, kit)}
        controllers[BY_HAND] = {**reading(RAW, kit.period, kit), **own}
    facts = {
        "title": titles_of(robot), "kit_name": kit.name, "setup": _setup_part(robot, kit), "every": kit.period,
        "delay_own": kit.delay, **numbers, **_shown(robot, kit), "controllers": controllers,
    }  # fmt: skip
    return PrintedRobot(robot, motion, laden, laws, facts)


def _designed(robot: Robot, kit: Kit, name: str) -> tuple[str, dict[str, Any]]:
    controller = CONTROLLERS[name](robot, kit, kit.period)
    text, facts = printed_law(controller, kit)
    analysis = analysed(controller, robot, kit)
    analysis = replace(analysis, L=tuple(row[::KEPT] for row in analysis.L[1:]))
    gain = gain_of(controller)
    own: dict[str, Any] = {"gains": [] if gain is None else gain[0, :6].tolist()}
    return text, {**facts, **own, "analysed": plain(analysis)}


def _shown(robot: Robot, kit: Kit, load: tuple[float, float] = (0.0, 0.0)) -> dict[str, Any]:
    """What the page draws and says of the robot, and what a pull at a wheel [N] turns into as a command."""
    laden = loaded(robot, *load)
    setup = Setup(robot=robot.name, payload=load[0], payload_height=load[1])
    body = body_of("nonlinear", Plant(robot, laden, kit), setup, EXPORTED)
    body.pull(1.0)
    look = look_of(laden, setup, behind(body, kit).spec.limit)
    return {"pull": body.twist, "look": plain(look), "equations": plain(equations(laden))}


def _setup_part(robot: Robot, kit: Kit) -> dict[str, Any] | None:
    """What makes this robot in the live lab, where a hand-in is run again; None where its kit is a file."""
    if kit.name not in kit_names() or kit != Kit.preset(kit.name):
        return None
    usual = robot.name in preset_names() and robot == Robot.preset(robot.name)
    return {"kit": kit.name, "numbers": {} if usual else robot.numbers(), "drive": "" if usual else robot.drive}


def exported_script(robots: Sequence[PrintedRobot]) -> str:
    """The data of the page, as a script."""
    known = [f for f in families() if f.name == OFF or any(f.name in p.laws for p in robots)]
    choice = replace(
        catalogue(), robots=tuple(robot_info(p.robot) for p in robots), kits=(),
        families=tuple(known),
    )  # fmt: skip
    facts = {
        "version": version("upright"), "catalogue": choice, "welcome": Welcome(VERSION, "", "alone", ""),
        "robots": {p.robot.name: p.facts for p in robots},
    }  # fmt: skip
    text = json.dumps(plain(facts), separators=(",", ":"), ensure_ascii=False, allow_nan=False)
    motions = _dense(_object({p.robot.name: p.motion for p in robots}))
    laden = _dense(_object({p.robot.name: p.laden for p in robots if p.laden}))
    laws = _dense(_object({p.robot.name: _object(p.laws) for p in robots}))
    data = _object({"facts": text.replace("<", "\\u003c"), "motions": motions, "laden": laden, "laws": laws})
    return f'"use strict";\n{functions()}globalThis.{NAME} = {data};\n'


def _dense(code: str) -> str:
    """Printed code without what only a reader needs: spaces, where they do not keep two signs apart, and a `const` or
    `let` in each line of many. A fifth of the page."""
    code = re.sub(r" ([*/+=-]) (?![-+])", r"\1", code)
    return re.sub(r"(?m)^(const|let) .*;(?:\n\1 .*;)+", lambda m: m[0].replace(f";\n{m[1]} ", ",\n"), code)


def _object(members: Mapping[str, str]) -> str:
    return "{\n" + ",\n".join(f"{json.dumps(name)}: {text}" for name, text in members.items()) + "}"
