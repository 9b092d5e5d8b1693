"""What to run after a certificate: the program, what would mend its first reason, or what to measure."""

from __future__ import annotations

from upright.certification.measured import Measurements
from upright.certification.narrowing import by_run
from upright.certification.verdict import GREEN
from upright.control.tunable import TUNABLE
from upright.likelihood.support import MASS
from upright.pages import Next, Say

PROGRAMS = {
    "nxt": ("nxc", "balance.nxc"), "spike": ("pybricks", "balance.py"), "ev3": ("ev3dev", "balance.py"),
}  # fmt: skip
"""Kit → the language of its brick, and a file for the program."""

PROGRAM = ".py:"
"""In the name of a class in a program, whose equations nobody knows."""


def next_step(c: Measurements) -> Next:
    """What to run: the program, what would mend the first reason, or what to measure."""
    asked = c.given or c.controller
    if c.light == GREEN and not c.linear and PROGRAM in c.given:
        return Next(
            "push_map", controller=c.given, robot=c.robot, why=Say("It shows where a push is hardest to survive.")
        )
    if c.light == GREEN:
        target, output = PROGRAMS.get(c.kit, ("c", "balance.c"))
        return Next("firmware", asked, robot=c.robot, target=target, output=output,
                    why=Say("It writes the program for the robot."))  # fmt: skip
    logged = by_run(c.to_measure(), str(c.subject["robot"]["drive"]))
    if logged:
        return Next("excite", robot=c.robot, focus=",".join(logged), output="plan.json",
                    why=Say("It plans a run; calibrate on its log tells these numbers."))  # fmt: skip
    if c.to_measure():
        return Next("certify", asked, robot="MEASURED.toml",
                    why=Say("First write what you measured into the robot's file."))  # fmt: skip
    return _mending(c, asked)


def _mending(c: Measurements, asked: str) -> Next:
    """What would mend the first reason of a light that is not green."""
    kind = c.reasons[0].kind
    kinds = [reason.kind for reason in c.reasons]
    if "log" in kinds:  # no weight mends what a log shows
        if any(s.name == MASS for s in (*c.support, *c.taken) if s.left_open or s.excess > 0):
            return Next("certify", asked, robot=c.robot, weighed="KG", why=Say("A scale tells the mass."))
        return Next("certify", asked, robot=c.robot, log="LOG",
                    why=Say("First mend what the log shows, then take a new log."))  # fmt: skip
    if kind == "weak":
        return Next("certify", asked, robot="CHANGED.toml",
                    why=Say("First give the robot a higher gear ratio or battery."))  # fmt: skip
    if "free" in kinds and not any("encoder" in name for name in c.subject["kit"]):
        return Next("certify", asked, robot=c.robot, kit="CHANGED.toml",
                    why=Say("Without encoders no weights resist a steady push: add encoders first."))  # fmt: skip
    if c.controller in TUNABLE:
        return Next("tune", c.controller, robot=c.robot, output="tuned.json", why=WEIGHTS[kind])
    return Next("bench_controllers", robot=c.robot, why=Say("It compares the methods on this robot."))


WEIGHTS = {
    "loop": Say("It searches weights with which the robot stands."),
    "alone": Say("It searches weights with which the robot stands."),
    "spread": Say("It searches weights with which fewer robots fall."),
    "free": Say("A weight on the wheels' angle holds the place."),
    "gain": Say("A smaller weight on pitch leaves a larger gain margin."),
    "delay": Say("A smaller weight on pitch rate bears more delay."),
    "saturated": Say("A larger weight on the command saves the motors."),
    "travel": Say("A larger weight on the wheels' angle rolls less."),
    "sway": Say("A smaller weight on pitch rate sways less."),
}
"""Kind of a reason → what to change in a design."""
