"""`upright robots new`: a robot of one's own as two files, from what its owner knows of it."""

from __future__ import annotations

import inspect
import math
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import typer

from upright.cli.guide import EndOfAnswers, Question, answered
from upright.errors import InvalidRobot, UnknownName, UprightError

NONE = "none"
A_GUESS = ", a guess"
G = 9.81  # [m/s²], in which accelerometers state their range
DRIVERS = {"L298N": ("two-pin", 1.8), "TB6612": ("two-pin", 0.0), "BTS7960": ("pwm-enable", 0.0), "other": ("", 0.0)}
"""How a sketch drives each chip (`robots.wiring`), and the volts that it keeps: the data sheet's, at part load."""


@dataclass(frozen=True)
class OwnerQuestion:
    """A question in the owner's terms, and its `usual` answer, which is a guess.

    `choices` are all that may be answered. A number is above zero, but for one whose usual answer is zero. The answer
    may be none where the robot `may_lack` the part; then the question that `needs` the other's part is not asked.
    """

    text: str
    usual: str
    choices: tuple[str, ...] = ()
    may_lack: bool = False
    needs: str = ""

    def check(self, answer: str) -> None:
        """Raise an `UprightError` for an answer that cannot be."""
        answer = answer.removesuffix(A_GUESS)
        if self.choices and answer not in self.choices:
            raise UnknownName("choice", answer, self.choices)
        if self.choices or (self.may_lack and answer == NONE):
            return
        try:
            number = float(answer)
        except ValueError:
            number = math.nan
        least = -math.inf if self.usual == "0" else 0.0
        if not (math.isfinite(number) and number > least):
            expected = f"a number{' above zero' * (least == 0)}{', or none' * self.may_lack}"
            raise InvalidRobot(f"{self.text}: '{answer[:40]}'", expected=expected)


QUESTIONS = {
    "wheel": OwnerQuestion("Wheel with its tyre, across [mm]", "65"),
    "wheel_mass": OwnerQuestion("One wheel on the scales [g]", "35"),
    "body_mass": OwnerQuestion("All but the wheels, with battery, on the scales [g]", "700"),
    "track": OwnerQuestion("From the middle of one tyre to that of the other [mm]", "150"),
    "com": OwnerQuestion("Centre of mass above the axle: wheels off, balance the body on an edge [mm]", "50"),
    "height": OwnerQuestion("Height of the body [mm]", "140"),
    "depth": OwnerQuestion("Depth of the body, from front to back [mm]", "60"),
    "gear": OwnerQuestion("Gear: turns of the motor in one of the wheel", "30"),
    "motor_voltage": OwnerQuestion("Voltage at which the next three numbers of the motor hold [V]", "7.4"),
    "no_load": OwnerQuestion("Turns of the lifted wheel a minute", "350"),
    "stall_current": OwnerQuestion("Current of the motor, held [A]", "0.75"),
    "stall_torque": OwnerQuestion("Torque of the wheel, held [kg cm]", "0.85"),
    "battery": OwnerQuestion("Battery in use [V]", "7.4"),
    "full_duty": OwnerQuestion("What the program writes for full duty (analogWrite: 255)", "255"),
    "driver": OwnerQuestion(f"Chip that drives the motors ({', '.join(DRIVERS)})", "TB6612", tuple(DRIVERS)),
    "encoder": OwnerQuestion(
        "Pulses of one encoder channel in a turn of the wheel, the motor's times the gear; or none",
        "330",
        may_lack=True,
    ),
    "decoding": OwnerQuestion(
        "Edges of a pulse that count: 1, 2 (one channel, CHANGE) or 4 (both)", "2", ("1", "2", "4"), needs="encoder"
    ),
    "gyro": OwnerQuestion("Range of the gyro [degree/s]", "250"),
    "accelerometer": OwnerQuestion("Range of the accelerometer [g], or none", "2", may_lack=True),
    "fused": OwnerQuestion(
        "Time of the filter that makes an angle of both [s], of a complementary one αT/(1 − α); or none",
        NONE,
        may_lack=True,
    ),
    "mounting": OwnerQuestion("What that angle reads where the robot is balanced [degree]", "0", needs="fused"),
    "divider": OwnerQuestion("Battery's voltage over that at the pin that measures it, or none", NONE, may_lack=True),
    "period": OwnerQuestion("Period of the control loop [ms]", "10"),
}
"""What is asked, in this order, by the name of its option."""


class Answers:
    """The answers as numbers, or as the word for a chip, and the names of those that were `read`."""

    def __init__(self, answers: Mapping[str, str]) -> None:
        self.read: dict[str, str] = {}
        self._answers = answers

    def __getattr__(self, name: str) -> Any:
        self.read[name] = self._answers[name]
        plain = _plain(self._answers[name])
        return plain if plain in DRIVERS else math.nan if plain == NONE else float(plain)


@dataclass(frozen=True)
class FileNumber:
    """A number of a file as a `formula` of the answers, or a guess of ours.

    `error` is the relative spread that usual tools leave, and `why` says what the formula is. A robot without the part
    of a question has no number that is from its answer, or that `needs` it.
    """

    formula: Callable[[Answers], float | str] | float
    error: float = 0.05
    why: str = ""
    needs: str = ""


_COUNT = FileNumber(lambda a: math.tau / (a.encoder * a.decoding), 0.0, "a turn over its counts")
_ACCEL_RANGE = FileNumber(lambda a: a.accelerometer * G, 0.0)
_ACCEL_STEP = FileNumber(lambda a: a.accelerometer * G / 2**15, 0.0, "16 bits with sign")
_ACCEL_NOISE = FileNumber(0.04, why="of an MPU-6050", needs="accelerometer")

NUMBERS = {
    "wheel_radius": FileNumber(lambda a: a.wheel / 2000, 0.01, "half of it"),
    "wheel_mass": FileNumber(lambda a: a.wheel_mass / 1000, 0.03),
    "wheel_inertia": FileNumber(lambda a: a.wheel_mass * a.wheel**2 / 8e9, 0.2, "a disc; a ring has twice it"),
    "body_mass": FileNumber(lambda a: a.body_mass / 1000, 0.01),
    "track": FileNumber(lambda a: a.track / 1000, 0.01),
    "com_height": FileNumber(lambda a: a.com / 1000),
    "pitch_inertia": FileNumber(
        lambda a: a.body_mass * (a.height**2 + a.depth**2) / 12e9,
        0.25,
        "a box; swinging it by its axle tells it to 3 %",
    ),
    "yaw_inertia": FileNumber(lambda a: a.body_mass * (a.depth**2 + a.track**2) / 12e9, 0.25, "a box"),
    "roll_inertia": FileNumber(lambda a: a.body_mass * (a.height**2 + a.track**2) / 12e9, 0.25, "a box"),
    "body_height": FileNumber(lambda a: a.height / 1000),
    "body_depth": FileNumber(lambda a: a.depth / 1000),
    "gear_ratio": FileNumber(lambda a: a.gear, 0.0),
    "rotor_inertia": FileNumber(5e-7, why="a rotor of 20 g and 7 mm, before the gear"),
    "back_emf": FileNumber(lambda a: a.motor_voltage / (a.no_load * math.tau / 60), 0.1, "voltage over speed"),
    "motor_resistance": FileNumber(lambda a: a.motor_voltage / a.stall_current, 0.1, "voltage over current"),
    "torque_constant": FileNumber(
        lambda a: a.stall_torque * G / 100 / (a.stall_current * a.gear), 0.1, "torque over current, before the gear"
    ),
    "period": FileNumber(lambda a: a.period / 1000, 0.0),
    "delay": FileNumber(0.002, why="from reading the sensors to the new duty"),
    "battery.voltage": FileNumber(lambda a: a.battery),
    "motor.quantum": FileNumber(lambda a: a.battery / a.full_duty, why="one step of the duty"),
    "motor.drop": FileNumber(lambda a: DRIVERS[a.driver][1], 0.2, "volts that the chip keeps, as its data sheet says"),
    "sensors.encoder_left.quantum": _COUNT,
    "sensors.encoder_right.quantum": _COUNT,
    "sensors.gyro.range": FileNumber(lambda a: math.radians(a.gyro), 0.0),
    "sensors.gyro.quantum": FileNumber(lambda a: math.radians(a.gyro) / 2**15, 0.0, "16 bits with sign"),
    "sensors.gyro.noise": FileNumber(
        0.002, why="of an MPU-6050; measured: the standard deviation of ten still seconds"
    ),
    "sensors.gyro.bias": FileNumber(0.0035, why="0.2 degree/s, what the mean of a still second leaves"),
    "sensors.accel_forward.range": _ACCEL_RANGE,
    "sensors.accel_forward.quantum": _ACCEL_STEP,
    "sensors.accel_forward.noise": _ACCEL_NOISE,
    "sensors.accel_up.range": _ACCEL_RANGE,
    "sensors.accel_up.quantum": _ACCEL_STEP,
    "sensors.accel_up.noise": _ACCEL_NOISE,
    "sensors.pitch.time_constant": FileNumber(lambda a: a.fused, 0.0),
    "sensors.pitch.offset": FileNumber(lambda a: math.radians(a.mounting)),
    "sensors.battery.quantum": FileNumber(lambda a: a.divider * 5 / 1023, 0.02, "a step of 5 V in 10 bits"),
    "wiring.driver": FileNumber(lambda a: DRIVERS[a.driver][0]),
    "wiring.pulses_per_turn": FileNumber(lambda a: a.encoder, 0.0),
    "wiring.decoding": FileNumber(lambda a: a.decoding, 0.0),
    "wiring.battery_divider": FileNumber(lambda a: a.divider, 0.02),
}
"""Where the answers go: the numbers of the robot's file, then those of its kit's."""


def new(name: Annotated[str, typer.Argument(help="Name of the robot, and of its file.")], **given: str | None) -> None:
    """Write a robot of one's own, with its electronics.

    NAME.toml and NAME-kit.toml say of each number what it is. At a terminal it asks for what no option says. What
    nobody answers is a guess, and the files say so.
    """
    from upright.atomic import write_text
    from upright.physics.linear import unstable_pole
    from upright.reading import parse_toml
    from upright.robots import PARAMETERS, toml
    from upright.robots.kit import kit_of
    from upright.robots.robot import robot_of

    path = Path(name.removesuffix(".toml") + ".toml")
    kit_path = path.with_name(f"{path.stem}-kit.toml")
    for target in (path, kit_path):
        if target.exists():
            raise UprightError(f"{target} exists already", hint="another name, or move the file away")
    answers: dict[str, str] = {}
    for key, question in QUESTIONS.items():
        answers[key] = _answer(key, given[key], lacks=_plain(answers.get(question.needs, "")) == NONE)
    head = {"name": path.stem, "title": "As its owner says.", "drive": "voltage", "kit": kit_path.name}
    robot = toml.rows("", head)
    kit = toml.rows("", {"name": path.stem})
    for number in NUMBERS:
        entry = _entry(number, answers)
        if number in PARAMETERS:
            robot += entry
        else:
            kit += entry
    kit_of(parse_toml(kit, str(kit_path), InvalidRobot, "a kit"), str(kit_path))
    made = robot_of(parse_toml(robot, str(path), InvalidRobot, "a robot"), str(path))
    write_text(kit_path, kit)
    write_text(path, robot)
    guesses = (robot + kit).count('spread = "guess"')
    typer.echo(f"wrote {path} and {kit_path}: {guesses} numbers are guesses, marked so; each says what it is")
    typer.echo(f"{path.stem} falls at {unstable_pole(made):.3g} 1/s; try: upright simulate --robot {path}")


def _option(name: str) -> inspect.Parameter:
    question = QUESTIONS[name]
    text = f"{question.text} (default: {question.usual}{A_GUESS})."
    option = typer.Option(f"--{name.replace('_', '-')}", help=text, metavar="ANSWER")
    return inspect.Parameter(
        name, inspect.Parameter.KEYWORD_ONLY, default=None, annotation=Annotated[str | None, option]
    )


# typer makes one option of each parameter, so each question is one
_NAME = inspect.signature(new, eval_str=True).parameters["name"]
new.__signature__ = inspect.Signature([_NAME, *map(_option, QUESTIONS)])  # type: ignore[attr-defined]


def _plain(answer: str) -> str:
    return answer.removesuffix(A_GUESS)


def _answer(name: str, given: str | None, *, lacks: bool) -> str:
    """What an option or the terminal says; the usual answer, marked as a guess, where neither does; none where the
    robot lacks what the question is about."""
    question = QUESTIONS[name]
    guess = question.usual + A_GUESS
    if lacks:
        if given is not None:
            raise UprightError(f"--{name} without {question.needs}", hint=f"--{question.needs} as well")
        return NONE
    if given is not None:
        question.check(given)
        return given
    if not sys.stdin.isatty():
        return guess
    try:
        return answered(Question(name, question.text, guess, question.check))
    except EndOfAnswers:
        raise UprightError("no more answers", hint="options, such as --gear 30") from None


def _entry(number: str, answers: Mapping[str, str]) -> str:
    """The number as its file has it, under the questions that it is from; nothing where the robot lacks the part."""
    from upright.robots import PARAMETERS, toml
    from upright.robots.kit import quantity_of

    row = NUMBERS[number]
    used = Answers(answers)
    value = row.formula(used) if callable(row.formula) else row.formula
    if NONE in map(_plain, (*used.read.values(), answers.get(row.needs, ""))):
        return ""
    comments = [f"{QUESTIONS[key].text}: {answer}" for key, answer in used.read.items()] or [f"A guess: {row.why}"]
    if isinstance(value, str):
        table, _, key = number.rpartition(".")
        return f"\n# {comments[0]}" + toml.rows(f"[{table}]", {key: value}) if value else ""
    if number in PARAMETERS:
        unit = PARAMETERS[number][0]
    else:
        (unit, *_), meaning = quantity_of(number)
        comments.insert(0, f"{number}: {meaning}")
    guessed = not used.read or any(answer.endswith(A_GUESS) for answer in used.read.values())
    source = ": ".join(filter(None, ("a guess" if guessed else "as its owner says", row.why)))
    spread = None if guessed else float(f"{row.error * abs(value):.2g}")
    entry = toml.number_text(number, float(f"{value:.6g}"), unit, toml.Provenance(source, spread))
    return "".join(f"\n# {comment}" for comment in comments) + entry
