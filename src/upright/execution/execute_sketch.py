"""A sketch on a simulated Arduino Uno: compiled with Arduino's own core, among parts that can fail."""

from __future__ import annotations

import math
import re
import struct
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from upright.atomic import TemporaryFolder, write_text
from upright.compiled.program import Program
from upright.control.estimators import ACCELEROMETER
from upright.errors import InvalidController, MissingTool
from upright.execution.execute_avr import CHIP, Chip, spent
from upright.execution.executor import Values
from upright.firmware.tools import run_tool, tool
from upright.firmware.wiring import defined
from upright.pages import Say
from upright.signals import SIDES

CORE = Path("/usr/share/arduino/hardware/arduino/avr")
SOURCES = (
    "wiring", "wiring_analog", "wiring_digital", "hooks", "WInterrupts", "HardwareSerial", "HardwareSerial0", "Print",
    "main", "abi", "new",
)  # fmt: skip
"""What a sketch needs of the core in `cores/arduino`."""

GYRO, BATTERY, LEFT, RIGHT, BUTTON, CONDITION, IDENTITY, POWER, PINS = range(9)
FORWARD, UP = 13, 14
STEPS_OF_G, STANDARD_GRAVITY = 16_384, 9.80665  # [steps] of an accelerometer of ±2 g, [m/s²]
"""Inputs of the board (`shims/board.h`)."""

STEP_INTERRUPT = 0x6F  # TIMSK1
INPUT_PINS = ("LEFT_ENCODER_A", "LEFT_ENCODER_B", "RIGHT_ENCODER_A", "RIGHT_ENCODER_B", "BUTTON")
"""Inputs of the board from `PINS` on; a sketch without encoders has the last alone."""
MOTOR_PINS = ("LEFT_PWM", "RIGHT_PWM", "LEFT_FORWARD", "RIGHT_FORWARD", "ENABLE")
"""Those that a sketch has for its kind of driver."""


@cache
def _core() -> tuple[TemporaryFolder, list[str]]:
    """Arduino's core and its Wire, compiled once: their folder and object files."""
    if not CORE.exists():
        raise MissingTool("Arduino's core is not installed", hint="apt install arduino-core-avr")
    kept = TemporaryFolder()
    wire = CORE / "libraries" / "Wire" / "src"
    paths = [path for name in SOURCES for path in (CORE / "cores" / "arduino").glob(f"{name}.c*")]
    paths += [wire / "Wire.cpp", wire / "utility" / "twi.c"]
    for compiler, suffix, language in (("avr-gcc", ".c", "gnu11"), ("avr-g++", ".cpp", "gnu++11")):
        chosen = [str(path) for path in paths if path.suffix == suffix]
        run_tool([tool(compiler), f"-std={language}", "-w", *FLAGS, *chosen], "Arduino's core", cwd=Path(kept.name))
    return kept, [str(path) for path in Path(kept.name).glob("*.o")]


HEADERS = ("cores/arduino", "variants/standard", "libraries/Wire/src", "libraries/Wire/src/utility")
INCLUDES = tuple(f"-I{CORE / part}" for part in HEADERS)
FLAGS = ("-c", *CHIP, "-ffunction-sections", "-fdata-sections", "-DARDUINO=10819", "-DARDUINO_ARCH_AVR", *INCLUDES)


class SketchExecutor(Chip):
    """A sketch on an Uno with an MPU-6050, wired as its first constants say. With `real` no time is leapt over."""

    where = Say("a simulated Arduino Uno")

    def __init__(self, source: Path, program: Program, number: str, real: bool = False) -> None:
        self.real = real
        text = source.read_text("utf-8")
        self.constants = constants(text)
        self._steps = bool(defined(text, "LEFT_STEP"))
        self._angle = program.scales.get("raw_pitch", 0.0)
        super().__init__(source, program, number)

    def build(self, source: Path, folder: Path) -> None:
        sketch, made = folder / "balance.cpp", folder / "balance.o"
        write_text(sketch, "#include <Arduino.h>\n" + source.read_text("utf-8"))
        strict = ["-std=gnu++11", "-Wall", "-Wextra", "-Werror"]
        run_tool([tool("avr-g++"), *strict, *FLAGS, "-o", str(made), str(sketch)], source.name)
        link = [tool("avr-g++"), *CHIP, "-Wl,--gc-sections", "-o", str(self._binary), str(made), *_core()[1]]
        run_tool(link, source.name)

    def start(self) -> None:
        super().start()
        self.request("A", self.symbols["due"], self.symbols["loop"], self.symbols["timer0_overflow_count"])
        for place, name in enumerate(INPUT_PINS):
            if name in self.constants:
                self.set_input(PINS + place, self.constants[name])
        self.period()  # its setup

    def step(self, raw: Values) -> Values:
        sign = self.constants["GYRO_SIGN"]
        inputs = {GYRO: sign * raw["raw_gyro"], BATTERY: raw.get("raw_battery", 0.0)}
        decoding = self.constants["DECODING"]
        if decoding:
            edges = 4 / decoding
            inputs |= {LEFT: edges * raw["raw_encoder_left"], RIGHT: edges * raw["raw_encoder_right"]}
        if self._angle:
            inputs |= self._accelerometer(raw)
        for what, value in inputs.items():
            self.set_input(what, round(value))
        if self._steps:
            self.request("W", STEP_INTERRUPT, 1, data=b"\0")  # it counts the steps of the robot that it is given
            for side in SIDES:
                self.write(f"encoder_{side}", struct.pack("<i", round(raw[f"raw_encoder_{side}"])))
        cycles = self.period()[1]
        if not self._ready:
            self._ready = bool(self.results()["ready"])
            return {}
        self.worst = max(self.worst, cycles)
        return self.results() | self._own_angle()

    def _accelerometer(self, raw: Values) -> dict[int, float]:
        """What it shows, or without such a sensor what it would at rest at that angle."""
        angle = raw["raw_pitch"] * self._angle
        rest = (-STANDARD_GRAVITY * math.sin(angle), STANDARD_GRAVITY * math.cos(angle))
        shown = [raw.get(channel, at_rest) for channel, at_rest in zip(ACCELEROMETER, rest, strict=True)]
        return {what: STEPS_OF_G / STANDARD_GRAVITY * value for what, value in zip((FORWARD, UP), shown, strict=True)}

    def _own_angle(self) -> dict[str, float]:
        """The angle that the sketch has fused, in the place of the one it was given."""
        if not self._angle:
            return {}
        words = self.read(self.symbols["readings"], f"{len(self._words.inputs)}{self._words.code}")
        return {"raw_pitch": float(words[self._words.inputs.index("raw_pitch")])}

    def set_input(self, what: int, value: int) -> None:
        self.request("I", what, value)

    def period(self) -> tuple[int, int]:
        """Run a period: when it began, and how long its work took [cycles]."""
        began, took = struct.unpack("<8s8s", self.request("P", not self.real, answer=16))
        return spent(began), spent(took)


def constants(text: str) -> Mapping[str, int]:
    """The pins of a sketch, its gyro's sign and its decoding; `InvalidController` for what is not a number of an Uno's
    pin."""
    steps = bool(defined(text, "LEFT_STEP"))
    numbers = {"DECODING": 0} if steps else dict[str, int]()
    motors = [name for name in MOTOR_PINS if defined(text, name)]
    encoders = INPUT_PINS[:4] if defined(text, "LEFT_ENCODER_A") else ()
    driven = () if steps else (*encoders, *motors, "LEFT_BACK", "RIGHT_BACK", "DECODING")
    for name in (*driven, "BUTTON", "GYRO_SIGN"):
        word = defined(text, name)
        if not re.fullmatch(r"-1|\d|1[0-9]", word):
            raise InvalidController(f"{name} is {word or 'missing'}", expected="the number of an Uno's pin, or a sign")
        numbers[name] = int(word)
    return numbers
