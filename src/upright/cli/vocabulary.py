"""The words of the command line: what each option and argument means, once, whatever command takes it.

A command writes a parameter like one of the library, `held_out: float = 0.25`, and its flag, help and completion come
from here. Where a command has more to say, it annotates the whole help, which begins with the same words.
"""

from __future__ import annotations

import glob
import inspect
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

MOST_ROBOTS = 10_000_000

Names = Callable[[], Iterable[str]]


def completed(names: Names, suffix: str = "") -> Callable[[str], list[str]]:
    """Completion in the shell: registered names, and files of that suffix."""

    def complete(incomplete: str) -> list[str]:
        files = glob.glob(f"{glob.escape(incomplete)}*{suffix}") if suffix else []
        return [name for name in (*names(), *files) if name.startswith(incomplete)]

    return complete


def registered(module: str, name: str) -> Names:
    """The names in the registry `name` of a module, or by its function of that name; it is imported when they are asked
    for."""

    def names() -> Iterable[str]:
        entries: Any = getattr(import_module(module), name)
        return entries() if inspect.isfunction(entries) else entries

    return names


def _tunable() -> Iterable[str]:
    from upright.control import CONTROLLERS

    return [name for name, method in CONTROLLERS.items() if method.tunable]


def _identifiers() -> Iterable[str]:
    from upright.identification.methods import IDENTIFIERS

    return (*IDENTIFIERS, "all")


controllers = registered("upright.control", "CONTROLLERS")
complete_robot = completed(registered("upright.robots", "preset_names"), ".toml")
complete_kit = completed(registered("upright.robots", "kit_names"), ".toml")
complete_controller = completed(controllers, ".json")
complete_tunable = completed(_tunable)
complete_identifier = completed(_identifiers)


@dataclass(frozen=True)
class Word:
    """What an option or argument means: its help, a `short` flag, completion, and the numbers that it takes."""

    help: str
    short: str = ""
    complete: Callable[[str], list[str]] | None = None
    metavar: str | None = None
    least: float | None = None
    most: float | None = None


WORDS = {
    "across": Word("First state.", metavar="STATE=LOW..HIGH"),
    "again": Word("Forget all answers and begin anew."),
    "anyway": Word("Go on although the certificate refuses it."),
    "at": Word("Operating point, such as wheel_rate=4,left=1,right=1; the others are zero."),
    "between_knocks": Word("Leave out the times at which somebody pushed the robot."),
    "body": Word(
        "Body by name or my.py:Name, such as nonlinear or twin (MuJoCo).",
        "-b",
        completed(registered("upright.bodies", "BODIES")),
    ),
    "browser": Word("Open the page in a browser.", "--no-browser"),
    "budget": Word("Number of candidates tried."),
    "calibrated": Word("The same robot as another log calibrated it (default: from this log).", "", complete_robot),
    "certificate": Word("Certificate by `upright certify`; refused if red or of another controller."),
    "chip": Word("For c: host, arm7 or avr; for pybricks: micropython or mpy (default: the first)."),
    "class_": Word("Serve up to 30 students, each with a robot, at the address of --host."),
    "cluster": Word("Dask scheduler, such as tcp://host:8786.", metavar="ADDRESS"),
    "controller": Word("Controller by name, controller.json or my.py:Name.", "-c", complete_controller),
    "controllers": Word("Methods of design (default: all quick ones).", "", completed(controllers), "NAME,..."),
    "delay": Word("Delay from command to sensors [s] (default: estimated)."),
    "direction": Word("Direction: forward, backward or both.", "", completed(lambda: ("forward", "backward", "both"))),
    "drive": Word("Drive at this speed.", metavar="M/S[,start=S,until=S]"),
    "durations": Word("Duration of the push [s].", metavar="LOW..HIGH"),
    "enough": Word("Factor on the narrowest intervals, in exchange for less energy; 1: the narrowest."),
    "excite": Word("Plan by `upright excite`, added to the commands."),
    "export": Word("Write the page alone into this folder: it runs anywhere, without Python."),
    "falls": Word("Largest probability of a fall, with 95 % confidence."),
    "feedback": Word("State feedback u = −Kx: six gains 'k1,…,k6', or a JSON file with a 2×6 'gain'."),
    "fetch": Word("Start nothing; stop the running program and fetch its log."),
    "fix": Word("Write the repaired log: .parquet, .csv or .mcap."),
    "focus": Word("Parameters to identify, such as com_height (default: all).", metavar="NAME,..."),
    "folder": Word("Folder of the study, made if there is none."),
    "force": Word("Write the robot also where the fit is refused, or the log cannot tell it."),
    "frames": Word("Pictures a second."),
    "from_": Word("Leave out the log before this time [s]."),
    "gains": Word("Of pid-angle, the program's own: kp=50,ki=60,kd=1.4,unit=deg,output=pwm.", metavar="NAME=VALUE,..."),
    "heights": Word("Height above the axle [m] (default: up to the body's).", metavar="LOW..HIGH"),
    "held_out": Word("Last fraction of each log, kept for validation."),
    "host": Word("Address of this machine, with --class (default: its own in the network)."),
    "hub": Word(
        "Hub of pybricks: prime, technic, ev3 or nxt.", "", completed(registered("upright.firmware.generate", "GYROS"))
    ),
    "json": Word("Print JSON."),
    "kit": Word("Electronics by name or TOML file (default: the robot's).", "", complete_kit),
    "known": Word(
        "Parameter taken as exact, such as body_mass; repeatable.",
        "",
        completed(registered("upright.robots", "PARAMETERS")),
        "NAME",
    ),
    "lab": Word("Address of the class's lab, for the links of the worksheet.", metavar="ADDRESS"),
    "link": Word(
        "NXT: usb or a device such as /dev/rfcomm0. Hub: ble or ble:NAME. virtual: a simulated one.",
        "",
        completed(lambda: ("virtual", "usb", "ble")),
    ),
    "listing": Word("Print the statements, in no language."),
    "log": Word("Log: .csv, .txt, .json, .mat, .parquet or .mcap."),
    "logs": Word("Logs of one robot: .csv, .txt, .json, .mat, .parquet, .mcap.", metavar="LOG"),
    "lying": Word("Start lying at this pitch, and stand up.", metavar="RAD"),
    "mapping": Word(
        "Mapping of columns by name or TOML file (default: the one that fits).",
        "",
        completed(registered("upright.logs.mapping", "mappings"), ".toml"),
    ),
    "method": Word(
        "Method: lqr, lqi, lqg, pid, pid-angle, hinf, mpc, sliding, robust or my.py:Name.", "", completed(controllers)
    ),
    "methods": Word("Controllers by name or my.py:Name (default: all).", "", completed(controllers), "METHOD"),
    "model": Word(
        "Equations: complete (rolling without slip) or published.",
        "",
        completed(registered("upright.physics.dynamics", "MODELS")),
    ),
    "number": Word("Arithmetic of c (float, double, fixed) and arduino (float, fixed)."),
    "order": Word("States of pitch and wheels (default: chosen).", least=4, most=50),
    "output": Word("Write the result.", "-o"),
    "period": Word("Period of the controller [s] (default: the kit's)."),
    "points": Word("Values along each axis.", least=2, most=3000),
    "port": Word("Port of the server; 0: any free one.", least=0, most=65535),
    "posterior": Word("Posterior by `upright calibrate --save` (default: the robot's spreads)."),
    "program": Word("Program by `upright firmware`: .py, .c, .ino or .nxc."),
    "push": Word(
        "Push, repeatable; pushes add up. hold:RAD,until=S holds a pitch and releases it; force:N,start=S,duration=S; "
        "impulse:NS,start=S. Each takes height=M above the axle (default: the centre of mass).",
        "-p",
        metavar="KIND:NUMBER,...",
    ),
    "reference": Word("Label of the reference log (default: the first)."),
    "reference_inputs": Word("For c: the reference state as inputs."),
    "regulator": Word("Write a regulator of the model as JSON."),
    "release": Word("End of the push [s] (default: from each log)."),
    "repeats": Word("Simulated logs for intervals and bias.", least=0, most=10_000),
    "report": Word("Write a page, .html, or its first picture, .svg .pdf .png."),
    "resume": Word("Go on with the search that -o was stopped in."),
    "robot": Word("Robot by name (see `upright robots`) or TOML file.", "-r", complete_robot),
    "robots": Word("Robots of the page, names and TOML files (default: every preset).", "", complete_robot, "NAME,..."),
    "samples": Word("Robots drawn.", "-n", least=0, most=MOST_ROBOTS),
    "saturated": Word("Largest fraction of periods with a saturated motor."),
    "save": Word("Write all that the result says as JSON."),
    "seconds": Word("Length of the run [s].", "-s"),
    "seed": Word("Seed of all random draws and noise.", least=0, most=2**63 - 1),
    "slope": Word("Slope of the floor.", metavar="RAD[,start=S]"),
    "source": Word("Hub: ble or ble:NAME. A file, a serial device, or - for stdin. virtual: a simulated hub."),
    "spec": Word("Campaign in TOML (see docs/fleet.md)."),
    "speed": Word("Speed of the film; 0.5 is half of the true one."),
    "start": Word("Initial state, such as pitch=0.05; the others are zero."),
    "states": Word("Use the true states of a twin's log."),
    "target": Word(
        "Language: pybricks, nxc, c, arduino or ev3dev.",
        "-t",
        completed(registered("upright.firmware.targets", "TARGETS")),
    ),
    "threads": Word("Threads (default: all processors).", least=1, most=1024),
    "time_limit": Word("Stop the search after this time [s].", least=0),
    "tolerance": Word("Relative accuracy of each impulse."),
    "travel": Word("Largest distance from the start [m]."),
    "turn": Word("Turn at this rate, anticlockwise.", metavar="RAD/S[,start=S,until=S]"),
    "until": Word("Leave out the log from this time on [s]."),
    "up": Word("Second state.", metavar="STATE=LOW..HIGH"),
    "vary": Word(
        "Varied number, repeatable: com_height=±10%, com_height=0.06..0.08, com_height=normal:5%, com_height=normal "
        "(the spread of the robot's file); also delay, motor.limit, sensors.gyro.noise; 'spread': all parameters; "
        "'conditions': the battery.",
        metavar="NAME=...",
    ),
    "watch": Word("Time to stand [s], to count as recovered."),
    "weighed": Word("What the robot weighs on a scale [kg]: no log is asked the mass then."),
    "width": Word("Width [pixels]; the height is 9/16 of it.", least=160, most=3840),
    "wide": Word("Print tables with all their columns."),
    "workers": Word("Processes (default: one for each processor); 0: none beside this one.", least=0, most=1024),
    "worksheet": Word(
        "Write the worksheet instead: es or en.",
        "",
        completed(registered("upright.classwork.worksheet", "LANGUAGES")),
        "LANGUAGE",
    ),
    "write_mapping": Word("Write the mapping as TOML, or a draft of one, for editing."),
    "yes": Word("Start without asking.", "-y"),
}
"""Parameter of a command, as Python writes it → what it means."""
