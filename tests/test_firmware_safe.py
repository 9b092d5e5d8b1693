"""Programs fail safe on every target: no reading gives a duty that no motor takes, and one that is not a number stops
both motors before their duty is computed."""

from __future__ import annotations

import math
import re
import struct
import subprocess
from contextlib import suppress
from itertools import pairwise
from pathlib import Path

import pytest

from firmware_cases import NXT, ROBOT, SPIKE, STILL, brief, frozen, steering, written
from interpreter import Interpreter
from upright.compiled.program import Program
from upright.errors import InvalidController
from upright.execution.execute import PythonExecutor, execute
from upright.execution.execute_nxc import NxcExecutor
from upright.execution.executed import Readings
from upright.firmware import trace
from upright.firmware.setup import SENSOR_FAILED, TOO_FAR
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.firmware.wiring import nxt_wiring

NAN, INF = math.nan, math.inf
HOSTILE = {"float": (NAN, INF, -INF, 3.4e38, -3.4e38), "double": (NAN, INF, -INF, 1.7e308, -1.7e308)}
WORDS = (2.0**31 - 1, -(2.0**31), 3000.0 * 65536, -3000.0 * 65536)  # the ends of a word, and an encoder at 3000 rad
UNDEFINED = ("-fsanitize=undefined,float-cast-overflow", "-fno-sanitize-recover=all", "-std=c99")

HARNESS = """
#include <stdio.h>
#include "balance.h"
static const upright_input table[] = { %s };
int main(void)
{
    upright_state state;
    upright_output out;
    upright_reset(&state);
    for (unsigned i = 0; i < sizeof table / sizeof *table; i++) {
        if (i < %d)
            upright_calibrate(&state, &table[i], &out);
        else {
            upright_command(&state, &table[i], &out);
            upright_update(&state, &table[i], &out);
        }
        printf("%%.9g %%.9g ", (double)out.start_status, (double)out.duty_left);
        printf("%%.9g %%.9g\\n", (double)out.duty_right, (double)out.status);
    }
    return 0;
}
"""


def c_text(value: float) -> str:
    if math.isnan(value):
        return "0.0/0.0"
    return f"{'-' if value < 0 else ''}1.0/0.0" if math.isinf(value) else repr(value)


def run_c(folder: Path, rows: list[list[float]], still: int, number: str) -> list[list[float]]:
    """[start status, left duty, right duty, status] after each row of readings, from a program that ends at the first
    operation that C leaves undefined; the first `still` rows calibrate it."""
    source, _ = written(folder, "c", number=number)
    table = ", ".join("{" + ", ".join(map(c_text, row)) + "}" for row in rows)
    (folder / "main.c").write_text(HARNESS % (table, still))
    flags = [*UNDEFINED, "-O1", f"-I{folder}", "-o", str(folder / "try")]
    run_tool([tool("gcc"), *flags, str(folder / "main.c"), str(source)], "main.c")
    done = subprocess.run([str(folder / "try")], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return [[float(word) for word in line.split()] for line in done.stdout.splitlines()]


def hostile_rows(resting: list[float], values: tuple[float, ...]) -> list[list[float]]:
    """Each reading alone at each value, all of them at once, and a resting robot after each."""
    rows: list[list[float]] = []
    for value in values:
        for i in range(len(resting)):
            rows += [[value if k == i else r for k, r in enumerate(resting)], resting]
        rows += [[value] * len(resting), resting]
    return rows


@pytest.mark.needs("gcc")
@pytest.mark.parametrize("number", ["float", "double"])
def test_a_reading_that_is_no_number_stops_c_before_the_duty_is_computed(tmp_path: Path, number: str) -> None:
    resting = [0.0, 0.0, 0.0, 8.0]
    rows = [[*resting] for _ in range(100)] + hostile_rows(resting, HOSTILE[number])
    for row, (_, left, right, status) in list(zip(rows, run_c(tmp_path, rows, 100, number), strict=True))[100:]:
        assert max(abs(left), abs(right)) <= 100
        assert left == int(left)
        if any(map(math.isnan, row)):
            assert (left, right, status) == (0, 0, SENSOR_FAILED), row


@pytest.mark.needs("gcc")
def test_fixed_point_is_defined_for_every_word(tmp_path: Path) -> None:
    resting = [0.0, 0.0, 0.0, 8.0 * 65536]
    rows = [[*resting] for _ in range(100)] + hostile_rows(resting, WORDS)
    for row, (_, left, right, status) in list(zip(rows, run_c(tmp_path, rows, 100, "fixed"), strict=True))[100:]:
        assert max(abs(left), abs(right)) <= 100
        if max(abs(row[0]), abs(row[1])) > 1000 * 65536:  # [rad] an encoder beyond its range has rolled too far
            assert (left, right, status) == (0, 0, TOO_FAR)


@pytest.mark.needs("gcc")
@pytest.mark.parametrize("number", ["float", "double"])
@pytest.mark.parametrize("which", [2, 3])
def test_a_start_without_numbers_is_refused(tmp_path: Path, number: str, which: int) -> None:
    """The gyro or the battery once in the second of the start: the loop goes no further."""
    rows = [[0.0, 0.0, 0.0, 8.0] for _ in range(100)]
    rows[50][which] = NAN
    starts = [start for start, *_ in run_c(tmp_path, rows, 100, number)]
    assert starts[50] == SENSOR_FAILED
    assert set(starts[:50]) == {0}


@pytest.mark.needs("gcc")
def test_words_of_any_number_are_defined(tmp_path: Path) -> None:
    """The header's own conversion to a word: at its ends where the number is beyond them, and for no number at all."""
    written(tmp_path, "c", number="fixed")
    values = [0.5, -0.5, 1e9, -1e9, INF, -INF, NAN]
    body = "".join(f'v = {c_text(v)}; printf("%d\\n", (int)UPRIGHT_Q16(v)); ' for v in values)
    (tmp_path / "main.c").write_text(
        f'#include <stdio.h>\n#include "balance.h"\nint main(void) {{ volatile double v; {body} return 0; }}\n'
    )
    run_tool([tool("gcc"), *UNDEFINED, "-o", str(tmp_path / "try"), str(tmp_path / "main.c")], "main.c")
    done = subprocess.run([str(tmp_path / "try")], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    half, minus, *ends, none = map(int, done.stdout.split())
    assert (half, minus) == (32768, -32768)
    assert ends[0] == ends[2] >= 2**31 - 2**17
    assert ends[1] == ends[3] <= -(2**31) + 2**17
    assert abs(none - ends[1]) <= 1  # the low end


def hostile_program(target: str) -> Program:
    kit = SPIKE if target == "pybricks" else NXT
    return trace(steering() if target == "nxc" else frozen(), ROBOT, kit, target)


@pytest.mark.parametrize("target", ["c", "arduino", "pybricks", "ev3dev", "nxc"])
def test_the_representation_stops_for_any_reading_that_is_no_number(target: str) -> None:
    program = hostile_program(target)
    kit = SPIKE if target == "pybricks" else NXT
    resting = Readings(program, kit).raw({})
    for name in program.channels:
        machine = Interpreter(program)
        machine.command(resting)
        machine.update()
        out = dict(machine.command(resting | {name: NAN}))
        assert (out["duty_left"], out["duty_right"], machine.update()["status"]) == (0, 0, SENSOR_FAILED), name
        refused = Interpreter(program).calibrate(resting | {name: NAN})["start_status"]
        assert refused == (0 if "encoder" in name else SENSOR_FAILED), name  # the start looks at no encoder


@pytest.mark.needs("module:micropython_unix")
@pytest.mark.parametrize("value", [NAN, INF, -INF, 1e30, -1e30])
def test_a_hub_s_gyro_may_say_anything(tmp_path: Path, value: float) -> None:
    """The hub's gyro gives fractions, so that it could give what is no number; the program ends by itself."""
    source, made = brief(tmp_path, "pybricks", SPIKE)
    executor, readings = execute(source, made.program, made.number), Readings(made.program, SPIKE)
    executor.start()
    for raw in readings.still(STILL):
        executor.step(raw)
    out = executor.step(readings.raw({}) | {"raw_gyro": value})
    if math.isnan(value):
        assert out["status"] == SENSOR_FAILED
        assert (out["duty_left"], out["duty_right"]) == (0, 0)
    assert max(abs(out["duty_left"]), abs(out["duty_right"])) <= 100
    executor.close()


@pytest.mark.needs("nbc")
def test_an_nxt_s_sensors_may_say_anything(tmp_path: Path) -> None:
    """What the brick's own integers can hold: the machine stops a program that goes beyond them."""
    source, made = brief(tmp_path, "nxc", controller=steering())
    readings = Readings(made.program, NXT)
    resting = readings.raw({})
    ends = {"raw_encoder_left": (2**31 - 1, -(2**31)), "raw_encoder_right": (2**31 - 1, -(2**31))}
    ends |= {"raw_gyro": (-600, 423), "raw_compass": (0, 32767), "raw_battery": (0, 65535)}
    executor = execute(source, made.program, made.number)
    for name, values in ends.items():
        for value in values:
            executor.start()
            for raw in readings.still(STILL):
                executor.step(raw)
            executor.step(resting)  # its counts begin here
            out = executor.step(resting | {name: float(value)})
            assert max(abs(out["duty_left"]), abs(out["duty_right"])) <= 100
            if "encoder" in name:
                assert (out["duty_left"], out["duty_right"], out["status"]) == (0, 0, TOO_FAR)
    executor.close()


@pytest.mark.parametrize("raw_battery", [-5.0, 0.0, 70.0e3])
def test_an_ev3_s_battery_may_say_anything(tmp_path: Path, raw_battery: float) -> None:
    source, made = brief(tmp_path, "ev3dev")
    executor, readings = execute(source, made.program, made.number), Readings(made.program, NXT)
    executor.start()
    for raw in readings.still(STILL):
        executor.step(raw)
    out = executor.step(readings.raw({}) | {"raw_battery": raw_battery})
    assert max(abs(out["duty_left"]), abs(out["duty_right"])) <= 100
    executor.step(readings.raw({}))  # it still runs
    executor.close()


WIRED = {
    "nxc": {
        "#define LEFT OUT_C": "#define LEFT OUT_A",
        "#define RIGHT OUT_B": "#define RIGHT  OUT_C",
        "#define GYRO S1": "#define GYRO S4",
        "#define GYRO_SIGN 1": "#define GYRO_SIGN -1",
        "#define COMPASS S2": "#define COMPASS S3",
    },
    "pybricks": {
        "LEFT = (Port.A, Direction.COUNTERCLOCKWISE)": "LEFT = (Port.F, Direction.CLOCKWISE)",
        "AXIS = Axis.Y ": "AXIS = -Axis.X ",
        "GYRO_SIGN = 1": "GYRO_SIGN = -1",
    },
    "ev3dev": {
        "import OUTPUT_A, OUTPUT_D, LargeMotor": "import OUTPUT_B, OUTPUT_C, LargeMotor",
        "LEFT, RIGHT = OUTPUT_D, OUTPUT_A": "LEFT, RIGHT = OUTPUT_B, OUTPUT_C",
        "GYRO_SIGN = 1": "GYRO_SIGN = -1",
    },
}
"""Target → what a robot with other ports and a gyro the other way round has in its program's first constants."""


def rewired(source: Path, edits: dict[str, str]) -> Path:
    text = source.read_text("utf-8")
    for old, new in edits.items():
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    other = source.with_name(f"rewired{source.suffix}")
    other.write_text(text, "utf-8")
    return other


WIRINGS = [
    pytest.param("nxc", marks=pytest.mark.needs("nbc")),
    pytest.param("pybricks", marks=pytest.mark.needs("module:micropython_unix")),
    "ev3dev",
]


@pytest.mark.parametrize("target", WIRINGS)
def test_a_robot_with_other_ports_is_executed_with_them(tmp_path: Path, target: str) -> None:
    """The stand-ins are wired as the program's first constants say, so that edited ones compute the same."""
    kit = SPIKE if target == "pybricks" else NXT
    source, made = brief(tmp_path, target, kit, **({"controller": steering()} if target == "nxc" else {}))
    readings = Readings(made.program, kit)
    outputs: list[list[dict[str, float]]] = []
    for path in (source, rewired(source, WIRED[target])):
        executor = execute(path, made.program, made.number)
        executor.start()
        for raw in readings.still(STILL):
            executor.step(raw)
        rolled = [readings.raw({"sensor/encoder_left": 0.02 * k, "sensor/gyro": 0.1}, 3) for k in range(30)]
        outputs.append([dict(executor.step(raw)) for raw in rolled])
        executor.close()
    assert outputs[0] == outputs[1]
    assert any(out["duty_left"] for out in outputs[0])


@pytest.mark.needs("nbc")
@pytest.mark.parametrize("edits", [{}, WIRED["nxc"]])
def test_an_nxt_switches_off_the_motors_that_it_drives(tmp_path: Path, edits: dict[str, str]) -> None:
    """After a fall, while its display still says so: in the second before the firmware would do it."""
    source, made = brief(tmp_path, "nxc", controller=steering())
    executor, readings = execute(rewired(source, edits), made.program, made.number), Readings(made.program, NXT)
    assert isinstance(executor, NxcExecutor)
    executor.start()
    for raw in readings.still(STILL):
        executor.step(raw)
    falling, driven = readings.raw({"sensor/gyro": 4.0}), False
    while not executor.step(falling)["status"]:
        driven = driven or any(motor.duty for motor in executor.hardware.motors)
    assert driven
    with suppress(ExecutionFailed):  # it does not rest for longer than a period
        executor.step(falling)
    assert [motor.duty for motor in executor.hardware.motors] == [0, 0, 0]


@pytest.mark.parametrize("line", ["#define LEFT MOTOR", "#define LEFT OUT_B", "#define GYRO S5", "#define GYRO_SIGN 2"])
def test_wiring_that_parity_cannot_follow_is_one_line(tmp_path: Path, line: str) -> None:
    source, _ = written(tmp_path, "nxc")
    name = line.split()[1]
    text = re.sub(rf"#define {name} .+", line, source.read_text("utf-8"))
    with pytest.raises(InvalidController, match=name) as caught:
        nxt_wiring(text)
    assert "\n" not in str(caught.value)


CLOCKS = {
    "pybricks": ("raw_encoder_left = left.angle()\n", "print('at', watch.time())", "wait(26)"),
    "ev3dev": ("raw_encoder_left = left.position\n", "print('at', time.monotonic() * 1000)", "time.sleep(0.026)"),
}
"""Target → the first line of a period, what shows its time [ms], and what stalls it for two periods and a half."""


@pytest.mark.parametrize("target", WIRINGS[1:])
def test_after_a_stall_no_period_is_short(tmp_path: Path, target: str) -> None:
    kit = SPIKE if target == "pybricks" else NXT
    source, made = brief(tmp_path, target, kit)
    first, shown, stall = CLOCKS[target]
    edits = {first: f"{shown}\n            if count == 8:\n                {stall}\n            {first}"}
    executor, readings = execute(rewired(source, edits), made.program, made.number), Readings(made.program, kit)
    assert isinstance(executor, PythonExecutor)
    executor.start()
    for raw in [*readings.still(STILL), *[readings.raw({}, readings.offset)] * 20]:
        executor.step(raw)
    begun = [float(line.split()[1]) for line in executor.script.lines if line.startswith("at")]
    periods = [b - a for a, b in pairwise(begun)]
    assert max(periods) > 25  # [ms] the stall
    assert min(periods) > 9.9
    assert periods[-1] == pytest.approx(10)
    executor.close()


@pytest.mark.needs("nbc")
def test_after_a_stall_no_period_of_an_nxt_is_short(tmp_path: Path) -> None:
    """By the times of its log's rows."""
    source, made = brief(tmp_path, "nxc")
    clocked = rewired(source, {"  row.battery = level;\n": "  row.battery = level;\n  if (rows == 8) Wait(26);\n"})
    executor, readings = execute(clocked, made.program, made.number), Readings(made.program, NXT)
    assert isinstance(executor, NxcExecutor)
    executor.start()
    for raw in [*readings.still(STILL), *[readings.raw({}, readings.offset)] * 20]:
        executor.step(raw)
    _, _, rows = bytes(next(iter(executor.hardware.flash.files.values()))).partition(b"\r\n")
    begun = [row[-1] for row in struct.iter_unpack("<7hH", rows)]
    periods = [b - a for a, b in pairwise(begun)]
    assert max(periods) > 25  # [ms] the stall
    assert min(periods) >= 9  # its clock counts whole milliseconds
    assert periods[-1] in (9, 10, 11)
    executor.close()
