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
PRESENT, ABSENT, HUNG = range(3)
"""Inputs of the board, and conditions of its sensor (`shims/board.h`)."""

TIMERS = {3: (0xB0, 5, 0xB4), 5: (0x44, 5, 0x48), 6: (0x44, 7, 0x47), 9: (0x80, 7, 0x88), 10: (0x80, 5, 0x8A),
          11: (0xB0, 7, 0xB3)}  # fmt: skip
"""Pin with a timer → its control register, the bit that connects the pin, and the register of its duty."""

PORTS = ((8, 0x2B), (14, 0x25), (20, 0x28))
"""First pin of the next port, and the register with this one's levels."""

LED = 13
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

    where = "a simulated Arduino Uno"

    def __init__(self, source: Path, program: Program, number: str, real: bool = False) -> None:
        self.real = real
        text = source.read_text("utf-8")
        self._constants = constants(text)
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
            if name in self._constants:
                self.set_input(PINS + place, self._constants[name])
        self.period()  # its setup

    def step(self, raw: Values) -> Values:
        sign = self._constants["GYRO_SIGN"]
        inputs = {GYRO: sign * raw["raw_gyro"], BATTERY: raw.get("raw_battery", 0.0)}
        decoding = self._constants["DECODING"]
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

    def run(self, seconds: float) -> None:
        """Let that time [s] pass."""
        for _ in range(round(seconds * 1000)):
            self.request("T", 16_000, answer=8)

    def pwm(self) -> list[float]:
        """What the driver gives both motors now, of 255, by the levels of its own inputs."""
        return [self._driven(side) for side in ("LEFT", "RIGHT")]

    def _driven(self, side: str) -> float:
        pins = self._constants
        own = f"{side}_PWM"
        strength = self._duty(pins[own if own in pins else "ENABLE"])
        back = self._duty(pins[f"{side}_BACK"])
        forward = self._duty(pins[f"{side}_FORWARD"]) if f"{side}_FORWARD" in pins else 255 - back
        return strength * (forward - back) / 255

    def level(self, pin: int) -> bool:
        """Whether an output is high."""
        first, register = next((end - (8 if end < 14 else 6), port) for end, port in PORTS if pin < end)
        return bool(self.read(register, "B")[0] >> (pin - first) & 1)

    def output(self) -> list[str]:
        """The lines that came over the serial port."""
        (count,) = struct.unpack("<I", self.request("S", answer=4))
        return self.receive(count).decode("ascii", "replace").splitlines()

    def _duty(self, pin: int) -> float:
        if pin in TIMERS:
            control, bit, duty = TIMERS[pin]
            if self.read(control, "B")[0] >> bit & 1:
                return float(self.read(duty, "B")[0])
        return 255.0 * self.level(pin)


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
