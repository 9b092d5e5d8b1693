"""`fly`: a program onto a brick, a hub or its virtual stand-in, into balance, and its log home."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from upright.control.controller import Controller
from upright.errors import UprightError
from upright.experiment.permit import Permit, permitted
from upright.experiment.pushes import PushProgramme
from upright.firmware.generate import head
from upright.firmware.program_file import ProgramFile, read_program, read_text
from upright.firmware.tools import tool
from upright.firmware.wiring import nxt_wiring
from upright.flight.flight import Flight
from upright.flight.fly_hub import fetch_hub, fly_hub
from upright.flight.fly_nxt import fetch_nxt, fly_nxt
from upright.flight.follow import VIRTUAL
from upright.links.hub import AIR
from upright.progress import Progress
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.motor import refuse_energy

MOST_SECONDS = 600.0  # [s] of a flight
HUB = "pybricks"  # the target of programs for hubs
PORTS = {"nxc": "usb, a device such as /dev/rfcomm0, or virtual", HUB: "ble, ble:NAME or virtual"}
BRICKS = {"nxc": "nxt", "prime": "spike", "technic": "technic", "ev3": "ev3", "nxt": "nxt"}
"""Target or hub of a program → the name of its brick."""
TWINS = {"nxc": "a virtual NXT brick with the twin round it", HUB: "a virtual hub with the twin round it"}


@dataclass(frozen=True, eq=False)
class FlightPlan:
    """A checked program, the `port` it goes to, and the `permit` of its controller in words."""

    file: ProgramFile
    port: str
    permit: str = ""

    @property
    def hub(self) -> bool:
        return self.file.program.target == HUB

    @property
    def where(self) -> str:
        """The brick, real or virtual."""
        return TWINS[self.file.program.target] if self.port == VIRTUAL else self.port

    def __str__(self) -> str:
        program = self.file.program
        at = "" if self.port == VIRTUAL else "at "
        return (
            f"robot       {program.robot} on {program.kit}, {at}{self.where}\n"
            f"controller  {program.kind} {program.hash[:12]}, every {program.period * 1e3:g} ms\n"
            f"certificate {self.permit}"
        )


def fly(
    program: str | Path,
    controller: Controller | str | Path,
    *,
    robot: Robot | str | Path | None = None,
    kit: Kit | str | Path | None = None,
    port: str = VIRTUAL,
    certificate: Permit | str | Path | None = None,
    anyway: bool = False,
    seconds: float = 20.0,
    pushes: Sequence[PushProgramme] = (),
    seed: int = 0,
    confirm: Callable[[FlightPlan], None] | None = None,
    progress: Progress | None = None,
) -> Flight:
    """Upload a program to an NXT brick or a Pybricks hub, run it for `seconds` [s], and fetch its log.

    `robot` is a robot or a brick's name that the program must be made for, `kit` its kit. `port` is usb or a device for
    a brick, ble or ble:NAME for a hub, or virtual: a simulated one, which `pushes` and the noise of `seed` disturb.
    `confirm` is called with the plan before anything is started, and prevents the flight by raising.

    Raises `UprightError` for what cannot be flown, `NotPermitted` for a certificate that refuses the controller without
    `anyway`, and like `fly_nxt` or `fly_hub`.
    """
    if not (math.isfinite(seconds) and 0 < seconds <= MOST_SECONDS):
        raise UprightError(f"a flight of {seconds:g} s", expected=f"more than 0 and at most {MOST_SECONDS:g} s")
    if pushes and port != VIRTUAL:
        raise UprightError("a real robot cannot be pushed by a number", expected=f"pushes at port {VIRTUAL} only")
    file = _checked(program, controller, robot, kit, port)
    if file.longest and seconds > file.longest:
        raise UprightError(
            f"a flight of {seconds:g} s: {program} stops by itself after {file.longest} s",
            expected=f"at most {file.longest}", hint=f"upright firmware --seconds {math.ceil(seconds)}",
        )  # fmt: skip
    permit = permitted(file.controller, _certificate(certificate), file.robot, file.kit, anyway=anyway)
    plan = FlightPlan(file, port, permit)
    if not plan.hub:
        tool("nbc")
    if confirm:
        confirm(plan)
    if port == VIRTUAL:
        flight = _fly_virtual(plan, seconds, pushes, seed, progress)
    else:
        flight = (fly_hub if plan.hub else fly_nxt)(file.path, file.program, port, seconds, progress=progress)
    return _labelled(flight, plan)


def fetch(
    program: str | Path,
    controller: Controller | str | Path,
    *,
    port: str,
    robot: Robot | str | Path | None = None,
    kit: Kit | str | Path | None = None,
) -> Flight:
    """Stop the program on the brick or hub at `port`, and fetch its log; nothing is started. Raises like `fly`."""
    if port == VIRTUAL:
        raise UprightError("a virtual brick keeps no log", expected="a real port to fetch from")
    plan = FlightPlan(_checked(program, controller, robot, kit, port), port)
    file = plan.file
    return _labelled(fetch_hub(file.program, port) if plan.hub else fetch_nxt(file.path, file.program, port), plan)


def _checked(
    program: str | Path,
    controller: Controller | str | Path,
    robot: Robot | str | Path | None,
    kit: Kit | str | Path | None,
    port: str,
) -> ProgramFile:
    """Read a program; refuse one that is not flown from here, or made for another robot, kit, brick or port."""
    facts = head(read_text(program))
    target = facts["target"]
    if target not in PORTS:
        raise UprightError(f"a program for {target} is not flown from here", expected=" or ".join(PORTS))
    if port != VIRTUAL and (port.partition(":")[0] == AIR) != (target == HUB):
        raise UprightError(f"port {port} for a {target} program", expected=PORTS[target])
    brick = BRICKS[facts.get("hub", target)]
    named = robot in BRICKS.values()
    chosen = refuse_energy(find_robot(facts["robot"] if robot is None or named else robot))
    if chosen.name != facts["robot"] or (named and robot != brick):
        raise UprightError(
            f"{program} was made for {facts['robot']} on the brick {brick}", expected=f"a program for {robot}",
            hint="upright firmware makes one",
        )  # fmt: skip
    parts = find_kit(facts["kit"] if kit is None else kit)
    if parts.name != facts["kit"]:
        raise UprightError(f"{program} was made for the kit {facts['kit']}", expected=f"a program for {parts.name}",
                           hint="upright firmware makes one")  # fmt: skip
    return read_program(program, controller, chosen, parts)


def _certificate(certificate: Permit | str | Path | None) -> Permit | None:
    from upright.certification import read_certificate

    return read_certificate(certificate) if isinstance(certificate, str | Path) else certificate


def _labelled(flight: Flight, plan: FlightPlan) -> Flight:
    program = plan.file.program
    flight.robot = program.robot
    flight.hash = program.hash
    flight.port = plan.port
    flight.where = plan.where
    return flight


def _fly_virtual(
    plan: FlightPlan, seconds: float, pushes: Sequence[PushProgramme], seed: int, progress: Progress | None
) -> Flight:
    """The flight of a virtual brick or hub, whose time runs as fast as it can and not beyond the end."""
    from upright.bricks.virtual_robot import virtual_flight, virtual_hub

    file, where = plan.file, plan.where
    if plan.hub:
        with virtual_hub(file.robot, file.kit, pushes, seed=seed) as hub:
            hub.until = seconds
            flight = fly_hub(
                file.path, file.program, hub, seconds, progress=progress, clock=lambda: hub.seconds, where=where
            )
            flight.fell = hub.world.fallen
            return flight
    with virtual_flight(file.robot, file.kit, pushes, seed=seed, wiring=nxt_wiring(file.text)) as virtual:
        virtual.line.until = seconds
        flight = fly_nxt(
            file.path, file.program, virtual.path, seconds, progress=progress, clock=virtual.clock, where=where
        )
        flight.fell = virtual.robot.world.fallen
    return flight
