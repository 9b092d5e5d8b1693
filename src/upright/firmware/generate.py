"""From a controller to the text of a program: `generate` makes it, `Firmware.write` keeps it, `head` reads it."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from upright.atomic import write_text
from upright.compiled.fixed import fractions, quantum
from upright.compiled.print_c import CPrinter
from upright.compiled.print_fixed import FixedPrinter
from upright.compiled.print_nxc import NxcPrinter
from upright.compiled.print_python import PythonPrinter
from upright.compiled.program import Kind, Program
from upright.control.controller import Controller
from upright.control.identity import identity
from upright.errors import InvalidController, UnknownName
from upright.firmware.balance import trace
from upright.firmware.setup import FLAT_BATTERY, SENSOR_FAILED, STATUS, TIME_IS_OVER
from upright.firmware.sketch_wiring import sketch_steps, sketch_wiring, wiring_table
from upright.firmware.targets import ENCODERS, PITCH, check_time, find_target
from upright.robots import Kit, Robot

LONGEST_HEAD = 40  # lines in which the head of a program is searched
NXT_ROWS = 6000  # most periods in an NXT's log: 96 kB of the 130 kB that its firmware leaves
NXT_HEAD = 200  # bytes of its first line, where names are of ASCII
NXT_LOG = "balance.log"
"""Its name on every brick, whatever the robot is called: a brick keeps 15.3 characters of ASCII."""
SECONDS = 60  # [s] of the longest run: three times a usual flight, and an NXT's log holds all of it
WATCHDOG = (60, 120, 250, 500, 1000, 2000, 4000, 8000)  # [ms] after which an AVR's watchdog acts
LONGEST = 3600  # [s] of the longest run, at most

GYROS = {
    "prime": "GYRO_SIGN * hub.imu.angular_velocity(AXIS)",
    "technic": "GYRO_SIGN * hub.imu.angular_velocity(AXIS)",
    "ev3": "GYRO_SIGN * gyro_sensor.speed()",
    "nxt": "GYRO_SIGN * (gyro_sensor.voltage() / 4.888 - 600)",  # HiTechnic's, 10 bits of 5 V, about 600 at rest
}
"""What the pybricks target runs on → its gyro's rate [°/s]; the NXT is experimental there, as in Pybricks itself."""


@dataclass(frozen=True, eq=False)
class Firmware:
    """The `program` printed in `number` arithmetic: `files` by ending, the first of them the program itself.

    `quantum` bounds the error of a command by fixed point, in its unit; None for floats.
    """

    program: Program
    number: str
    files: Mapping[str, str]
    quantum: float | None = None

    @property
    def text(self) -> str:
        """The program itself."""
        return next(iter(self.files.values()))

    @property
    def wiring(self) -> str:
        """The table of a sketch's pins; empty for other programs."""
        return wiring_table(self.text) if self.program.target == "arduino" else ""

    def to_json(self) -> dict[str, Any]:
        p = self.program
        facts: dict[str, Any] = {
            "target": p.target,
            "number": self.number,
            "robot": p.robot,
            "kit": p.kit,
            "controller": p.kind,
        }
        facts |= {"hash": p.hash, "period": p.period, "operations": p.operations(), "quantum": self.quantum}
        return facts | {"wiring": self.wiring}

    def __str__(self) -> str:
        p = self.program
        bound = ""
        if self.quantum is not None:
            bound = f", proven within {self.quantum:.3g} {p.command_unit} of the design"
        return (
            f"{p.kind} {p.hash[:12]} for {p.robot} on {p.kit}, every {p.period * 1e3:g} ms: "
            f"{p.operations()} products a period in {self.number}{bound}"
        )

    def write(self, path: str | Path) -> list[Path]:
        """Write `path` and whatever stands beside it, each whole or not at all."""
        first = Path(os.path.expanduser(path))
        target = find_target(self.program.target)
        if first.suffix != target.suffix:
            raise UnknownName(f"ending of a program for {target.name}", first.suffix or first.name, [target.suffix])
        return [write_text(first.with_suffix(ending), text) for ending, text in self.texts(first).items()]

    def texts(self, path: Path) -> dict[str, str]:
        """The files by ending, as they are written at `path`."""
        return {ending: text.replace("@HEADER@", f"{path.stem}.h") for ending, text in self.files.items()}


def generate(
    controller: Controller,
    robot: Robot,
    kit: Kit,
    target: str = "c",
    *,
    number: str = "",
    hub: str = "prime",
    reference: bool = False,
    seconds: int | None = None,
) -> Firmware:
    """The program of `controller` for `robot` on `kit` as text for `target`.

    `number` is float, double or fixed where the target has a choice (C: float; `fixed` proves its ranges); `hub` says
    what pybricks runs on; `reference` adds the reference state as inputs of a C program. After `seconds` [s]
    (`SECONDS`; 0: never) a program stops its motors; C has no loop that could. Raises like `trace`,
    `InvalidController`, and `UnknownName` for what a target does not offer.
    """
    place = find_target(target)
    arithmetic = number or place.numbers[0]
    if arithmetic not in place.numbers:
        raise UnknownName(f"arithmetic of {target}", arithmetic, place.numbers)
    if hub not in GYROS:
        raise UnknownName("hub", hub, GYROS)
    if reference and not place.numeric:
        raise InvalidController(f"a program for {target} has no reference", expected="target c for that")
    longest = _longest(seconds, target)
    program = trace(controller, robot, kit, target, reference=reference)
    _check_period(program, place.suffix)
    check_time(program, target)
    finest = quantum(program) if arithmetic == "fixed" else None
    facts: dict[str, Any] = {**_facts(program, arithmetic, finest), "hub": hub, "seconds": longest}
    who = identity(controller)
    more = [f"asked: {who.asked}"] if who.asked else []
    more += [f"response: {' '.join(f'{x:.9g}' for x in who.response)}"]
    more += ([f"hub: {hub}"] if target == "pybricks" else []) + (["reference: yes"] if reference else [])
    facts["head"] = [*facts["head"], *more]
    if target == "arduino":
        facts["wiring"] = sketch_wiring(kit, encoders=ENCODERS[0] in program.channels.values())
        facts["steps"] = sketch_steps(robot, kit) if robot.drive == "speed" else None
        facts["fused"] = _fused(program, kit, arithmetic)
    return Firmware(program, arithmetic, TEXTS[target](program, facts), finest)


def _fused(program: Program, kit: Kit, number: str) -> dict[str, float] | None:
    """What a sketch needs to fuse the angle itself; None where the controller does not read it."""
    if PITCH not in program.channels.values():
        return None
    time = kit.sensors[PITCH].time_constant
    if not time:
        raise InvalidController(
            f"the angle of kit '{kit.name}' comes from its chip, and no sketch is written for that",
            expected="an angle that the sketch fuses of gyro and accelerometer",
            hint="the time of its filter as [sensors.pitch.time_constant] in the kit's file, such as 0.5 s",
        )
    bits = fractions(program)["gyro_offset"] if number == "fixed" else 0
    return {
        "time": time,
        "keep": time / (time + program.period),
        "offset": 2.0**-bits,
        "rate": program.scales["raw_gyro"],
        "angle": 1 / program.scales["raw_pitch"],
    }


def _longest(seconds: int | None, target: str) -> int:
    if seconds and target == "c":
        raise InvalidController("a program in C has no loop of its own", expected=f"no longest run of {seconds} s")
    if seconds is not None and not 0 <= seconds <= LONGEST:
        raise InvalidController(f"a longest run of {seconds} s", expected=f"0 (no end) to {LONGEST}")
    return SECONDS if seconds is None else seconds


def _check_period(program: Program, suffix: str) -> None:
    if suffix != ".c" and not (program.period * 1000).is_integer() and abs(program.period * 1000 % 1) > 1e-9:
        raise InvalidController(
            f"the period is {program.period * 1e3:g} ms", expected=f"whole milliseconds, as {program.target} counts",
            hint="design the controller for another period",
        )  # fmt: skip


def _facts(program: Program, number: str, finest: float | None) -> dict[str, Any]:
    head = [*map(plain, program.head()), f"number: {number}"]
    head += [] if finest is None else [f"quantum: {finest:.3g} {program.command_unit}"]
    return {
        "head": head,
        "program": program,
        "robot": plain(program.robot),
        "kit": plain(program.kit),
        "hash": program.hash,
        "full": program.full,
        "fused": None,
        "number": number,
        "period_ms": f"{program.period * 1e3:g}",
        "period_us": round(program.period * 1e6),
        "time_is_over": TIME_IS_OVER,
        "sensor_failed": SENSOR_FAILED,
        "refusals": {status: STATUS[status] for status in (FLAT_BATTERY, SENSOR_FAILED)},
        "statuses": ", ".join(f"{i} {text}" for i, text in enumerate(STATUS) if i != TIME_IS_OVER),
    }


def plain(text: str) -> str:
    """The text as it may stand in a comment and between quotes in any language: what could end one is a blank."""
    return re.sub(r"[^\w .:,()@+/-]", " ", text)


def _c(program: Program, facts: Mapping[str, Any]) -> dict[str, str]:
    parts = {**facts, **_c_parts(program, facts["number"])}
    head = "".join(f"   {line}\n" for line in facts["head"])
    source = f'/* Generated by upright: do not edit.\n{head}*/\n#include "@HEADER@"\n\n' + render("balance.c", parts)
    return {".c": source, ".h": render("balance.h", parts)}


def _arduino(program: Program, facts: Mapping[str, Any]) -> dict[str, str]:
    patience = next((ms for ms in WATCHDOG if ms >= 4 * program.period * 1000), WATCHDOG[-1])
    name = f"WDTO_{patience}MS" if patience < 1000 else f"WDTO_{patience // 1000}S"
    parts = {**facts, **_c_parts(program, facts["number"]), "watchdog": name}
    return {".ino": render("arduino.ino", parts)}


def _c_parts(program: Program, number: str) -> dict[str, Any]:
    printer = FixedPrinter(program) if number == "fixed" else CPrinter(program, number)
    return {
        "type": printer.type,
        "helpers": printer.helpers().rstrip("\n"),
        "inputs": printer.fields(Kind.INPUT),
        "outputs": printer.fields(Kind.OUTPUT),
        "states": printer.fields(Kind.STATE),
        "starts": printer.starts(),
        "blocks": [{"name": block.name, "lines": printer.lines(block)} for block in program.blocks],
    }


def _python(program: Program, facts: Mapping[str, Any]) -> dict[str, str]:
    parts = {**facts, "printer": PythonPrinter(program), "gyro": GYROS[facts["hub"]]}
    return {".py": render(f"{program.target}.py", parts)}


def _nxc(program: Program, facts: Mapping[str, Any]) -> dict[str, str]:
    run = round(facts["seconds"] / program.period) or NXT_ROWS
    wide = "".join([facts["robot"], facts["kit"]])
    parts = {**facts, "rows": min(run, NXT_ROWS), "printer": NxcPrinter(program), "log": NXT_LOG}
    parts["head_bytes"] = NXT_HEAD + len(wide.encode()) - len(wide)
    parts["compass"] = "raw_compass" in program.variables
    return {".nxc": render("balance.nxc", parts)}


TEXTS: dict[str, Callable[[Program, Mapping[str, Any]], dict[str, str]]] = {
    "c": _c,
    "arduino": _arduino,
    "pybricks": _python,
    "ev3dev": _python,
    "nxc": _nxc,
}


def render(name: str, facts: Mapping[str, Any]) -> str:
    """The template of that name, filled."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    loader = PackageLoader("upright.firmware")
    environment = Environment(
        loader=loader, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True
    )
    return environment.get_template(f"{name}.j2").render(**facts)


def head(text: str) -> dict[str, str]:
    """The facts in the first lines of a generated program; `InvalidController` for any other text."""
    lines = text.splitlines()[:LONGEST_HEAD]
    pattern = r"\W*(target|robot|kit|controller|hash|period|version|number|quantum|hub|reference|asked|response): (.+)"
    facts = {m[1]: m[2].strip() for m in (re.fullmatch(pattern, line) for line in lines) if m}
    if missing := [name for name in ("target", "robot", "kit", "hash", "number") if name not in facts]:
        raise InvalidController(
            f"not a program by upright, whose first lines name its {missing[0]}",
            hint="generate it with upright firmware",
        )
    return facts


def longest_run(text: str) -> int:
    """Time [s] after which a program stops by itself, from its first constants; 0 for never."""
    constant = re.search(r"^(?:#define )?SECONDS\b[ =]+(\d+)", text, re.MULTILINE)
    return int(constant[1]) if constant else 0
