"""The text of programs: it is the committed one, holds every constant exactly, and refuses what it cannot do."""

from __future__ import annotations

import ast
import json
import re
import struct
import subprocess
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from firmware_cases import EV3, GOLDEN, NXT, ROBOT, SPIKE, designed, frozen, written
from interpreter import Interpreter
from upright.atomic import write_json
from upright.certification.certificate import Certificate
from upright.certification.checks import PushTrial
from upright.certification.standing import Standing
from upright.certification.verdict import Examined, LinearMargins, judge
from upright.cli.main import USER_ERROR, main
from upright.compiled.fixed import fractions, scaled
from upright.compiled.print_c import CPrinter
from upright.compiled.print_nxc import NxcPrinter
from upright.compiled.program import Kind, Program, Sum
from upright.control import LinearController, controller_hash, write_controller
from upright.errors import InvalidController, SpecMismatch, UnknownName
from upright.firmware import TARGETS, generate, head, trace
from upright.firmware.generate import TEXTS, _facts
from upright.firmware.setup import FALLEN, TOO_FAR
from upright.firmware.sketch_wiring import sketch_wiring
from upright.fleets.binomial import upper_bound
from upright.robots import Kit, Robot
from upright.robots.facts import kit_facts, robot_facts

PROGRAMS = {
    "float": ("c", NXT, {"number": "float"}),
    "fixed": ("c", NXT, {"number": "fixed"}),
    "sketch": ("arduino", NXT, {}),
    "spike": ("pybricks", SPIKE, {"hub": "prime"}),
    "ev3": ("ev3dev", NXT, {}),
    "nxt": ("nxc", NXT, {}),
}
"""Golden file → target, kit and options of its program of `controller.json`."""


def golden_files() -> dict[str, str]:
    """Name → text of every golden program. `python tests/test_firmware_text.py` writes them again."""
    texts: dict[str, str] = {}
    for name, (target, kit, options) in PROGRAMS.items():
        made = generate(frozen(), ROBOT, kit, target, **options)  # type: ignore[arg-type]
        texts |= {name + ending: text.replace("@HEADER@", f"{name}.h") for ending, text in made.files.items()}
    texts["listing.txt"] = str(trace(frozen(), ROBOT, NXT, "nxc")) + "\n"
    return {name: re.sub(r"version: upright .+", "version: upright", text) for name, text in texts.items()}


def test_every_program_is_the_committed_one():
    stale = [name for name, text in golden_files().items() if (GOLDEN / name).read_text("utf-8") != text]
    assert not stale, "look at the change, then run: python tests/test_firmware_text.py"


def test_every_head_says_what_the_program_is():
    for name, (target, kit, _) in PROGRAMS.items():
        suffix = TARGETS[target].suffix
        facts = head((GOLDEN / f"{name}{suffix}").read_text("utf-8"))
        assert facts["hash"] == controller_hash(frozen())
        assert (facts["target"], facts["robot"], facts["kit"], facts["period"]) == (
            target,
            ROBOT.name,
            kit.name,
            "0.01 s",
        )
    with pytest.raises(InvalidController, match="not a program by upright"):
        head("print('hello')\n")


HOSTILE = [
    '"; PWN(); "',
    "*/ PWN(); /*",
    "a\nPWN()",
    "a\rPWN()",
    '""" + PWN() + """',
    "a\\",
    "%d {{ PWN() }}",
    "a\u2028PWN()",
]


@pytest.mark.parametrize("target", PROGRAMS)
def test_no_name_gets_out_of_a_comment_or_a_text(target: str, tmp_path: Path):
    """Robot, kit and controller by that name, past the checks of names: nothing of it becomes code."""
    place, kit, options = PROGRAMS[target]
    traced = trace(frozen(), ROBOT, kit, place)
    for name in HOSTILE:
        files = written_as(replace(traced, robot=name, kit=name, kind=name), options)
        for ending, text in reversed(files.items()):  # a header before the file that includes it
            source = tmp_path / f"{target}{ending}"
            source.write_text(text.replace("@HEADER@", f"{target}.h"), encoding="utf-8", newline="")
            if ending == ".py":
                nodes = ast.walk(ast.parse(source.read_text("utf-8")))
                assert "PWN" not in {node.id for node in nodes if isinstance(node, ast.Name)}
            else:
                assert "PWN" not in re.sub(r'"(?:[^"\\\n]|\\.)*"', "", without_comments(source))
            if ending == ".c":
                subprocess.run(["gcc", "-fsyntax-only", "-Werror", str(source)], check=True)


def without_comments(source: Path) -> str:
    """The C-like text as gcc's own preprocessor reads it."""
    command = ["gcc", "-x", "c", "-fpreprocessed", "-dD", "-E", "-P", str(source)]
    return subprocess.run(command, capture_output=True, check=True, text=True).stdout


def written_as(program: Program, options: Mapping[str, Any]) -> dict[str, str]:
    """The files of a program that `generate` would make of `program`."""
    facts = _facts(program, options.get("number", TARGETS[program.target].numbers[0]), None)
    more = {"hub": options.get("hub", "prime"), "seconds": 60, "wiring": sketch_wiring(NXT)}
    return TEXTS[program.target](program, {**facts, **more})


@pytest.mark.parametrize("name", ["lqr", "lqi", "lqg", "pid", "hinf", "sliding"])
def test_the_representation_commands_what_the_controller_does(name):
    controller, program = designed(name), trace(designed(name), ROBOT, NXT, "c")
    machine, rng = Interpreter(program), np.random.default_rng(1)
    controller.reset()
    for _ in range(50):
        raw = dict(zip(program.channels, [*rng.normal(0, 0.02, 3), 8.0], strict=True))
        out = dict(machine.command(raw))
        machine.update()
        expected = controller.step(np.array(list(raw.values())[:3]), np.zeros(6))
        controller.applied((out["applied_left"], out["applied_right"]))
        # double precision on commands of a few volts; 1e-9 leaves a million roundings
        assert (out["command_left"], out["command_right"]) == pytest.approx(expected, abs=1e-9)


def test_a_late_motor_is_reported_late_to_the_memory():
    late = replace(NXT, delay=0.025)
    program, controller = trace(frozen(), ROBOT, late, "c"), frozen()
    machine, rng, sent = Interpreter(program), np.random.default_rng(1), [(0.0, 0.0), (0.0, 0.0)]
    assert program.lag == len(sent)  # 25 ms are two whole periods of 10 ms and a half
    for _ in range(50):
        raw = dict(zip(program.channels, [*rng.normal(0, 0.02, 3), 8.0], strict=True))
        out = dict(machine.command(raw))
        machine.update()
        expected = controller.step(np.array(list(raw.values())[:3]), np.zeros(6))
        sent.append((out["applied_left"], out["applied_right"]))
        controller.applied(sent.pop(0))
        assert (out["command_left"], out["command_right"]) == pytest.approx(np.clip(expected, -24, 24), abs=1e-9)


def test_zero_coefficients_vanish():
    program = trace(frozen(), ROBOT, NXT, "c")
    sums = [s for block in program.blocks for s in block.statements if isinstance(s, Sum)]
    assert all(c != 0 for s in sums for c, _ in s.terms)
    # pitch and yaw do not touch each other on a symmetric robot: no row of the memory reads all of it
    rows = [s for s in sums if s.target.startswith("next_w")]
    assert max(len(s.terms) for s in rows) < len(rows) + 3


def test_c_holds_every_constant_exactly():
    program = trace(frozen(), ROBOT, NXT, "c")
    numbers = [c for block in program.blocks for s in block.statements if isinstance(s, Sum) for c, _ in s.terms]
    double, single = CPrinter(program, "double"), CPrinter(program, "float")
    for number in numbers:
        assert float.fromhex(double.number(number)) == number
        nearest = struct.unpack("f", struct.pack("f", number))[0]
        assert float.fromhex(single.number(number).rstrip("f")) == nearest


def test_nxc_reaches_every_float_by_whole_numbers():
    printer = NxcPrinter(trace(frozen(), ROBOT, NXT, "nxc"))
    cells: dict[str, np.float32] = {}
    for line in printer.constants():
        operation, target, *operands = re.split(r",? ", line)
        if operation == "mov":
            assert float(operands[0]).is_integer()
            cells[target] = np.float32(int(operands[0]))
        else:
            cells[target] = cells[operands[0]] / cells[operands[1]]
    said = dict(re.findall(r"float (k\d+);  // (.+)", "\n".join(printer.declarations())))
    assert {name: float(cells[name]) for name in said} == {name: float(value) for name, value in said.items()}


def test_no_sum_in_fixed_point_can_overflow():
    for name in ("lqg", "pid", "hinf", "sliding"):
        program = trace(designed(name), ROBOT, NXT, "c")
        bits = fractions(program)
        assert all(v.most * 2.0 ** bits[v.name] < 2**31 for v in program.variables.values())
        for block in program.blocks:
            for s in (s for s in block.statements if isinstance(s, Sum)):
                form = scaled(s, program, bits)
                reach = sum(abs(f) * (program.variables[n].most * 2.0 ** bits[n] + 1) for f, n in form.terms)
                # 63 bits of magnitude hold the sum, its constant and the half that rounding adds
                assert reach + abs(form.constant) + 2.0 ** max(form.shift - 1, 0) < 2**63


def test_ranges_hold_under_the_worst_readings():
    program = trace(frozen(), ROBOT, NXT, "nxc")
    machine, rng = Interpreter(program), np.random.default_rng(3)
    for k in range(400):
        # readings beyond every range, at both ends in turn: the proof asks nothing of them
        raw = {n: (1 if rng.random() < 0.5 else -1) * 3 * program.variables[n].high * (k > 0) for n in program.channels}
        machine.command(raw)
        values = machine.update()
        for variable in program.variables.values():
            if variable.kind is not Kind.INPUT and variable.name in values:
                spare = 1e-9 * max(1.0, variable.most)  # rounding
                assert variable.low - spare <= values[variable.name] <= variable.high + spare, variable.name


def test_start_waits_for_stillness_and_takes_the_mean():
    program = trace(frozen(), ROBOT, NXT, "nxc")
    machine = Interpreter(program)
    still = {"raw_encoder_left": 0.0, "raw_encoder_right": 0.0, "raw_gyro": 7.0, "raw_battery": 8000.0}
    for _ in range(60):
        machine.calibrate(still)
    assert not machine.calibrate(still | {"raw_gyro": 60.0})["ready"]  # somebody touched it: counted from nothing again
    count = 1
    while not machine.calibrate(still | {"raw_gyro": 7.0 + count % 2})["ready"]:
        count += 1
    assert count == 100  # a second of 10 ms, none of them before the touch
    # 7 and 8 in turn: one of the hundred is the first still reading after the touch
    assert machine.values["gyro_offset"] == pytest.approx(7.5, abs=0.02)
    low = machine.calibrate(still | {"raw_battery": 4000.0})
    assert low["start_status"] == 4


def test_a_fall_and_a_runaway_stop_the_program():
    program = trace(frozen(), ROBOT, NXT, "c")
    machine = Interpreter(program)
    raw = {"raw_encoder_left": 0.0, "raw_encoder_right": 0.0, "raw_gyro": 6.0, "raw_battery": 8.0}
    statuses = [machine.command(raw) and machine.update()["status"] for _ in range(100)]
    assert FALLEN in statuses  # 6 rad/s for a second is more than lying down
    machine.reset()
    machine.command(raw | {"raw_gyro": 0.0, "raw_encoder_left": 1001.0})
    assert machine.update()["status"] == TOO_FAR


@pytest.mark.parametrize(
    ("name", "why"),
    [("lqr-complementary", "not a fixed sum of products"), ("lqr-state", "true state")],
)
def test_what_cannot_be_traced_says_why(name, why):
    with pytest.raises(InvalidController, match=why):
        trace(designed(name), ROBOT, NXT, "c")


def test_what_does_not_fit_is_refused():
    with pytest.raises(UnknownName, match="pybricks"):
        generate(frozen(), ROBOT, NXT, "pybrick")
    with pytest.raises(UnknownName, match="double, fixed, float"):
        generate(frozen(), ROBOT, NXT, "c", number="q15")
    with pytest.raises(SpecMismatch, match="commands V"):
        trace(frozen(), Robot.preset("twipr"), Kit.preset("twipr"), "c")
    with pytest.raises(SpecMismatch, match="does not limit"):
        trace(frozen(), ROBOT, Kit.preset("ideal"), "c")
    with pytest.raises(SpecMismatch, match="no battery"):
        trace(frozen(), ROBOT, Kit.preset("ideal"), "nxc")
    odd = replace(frozen(), period=0.0125)
    with pytest.raises(InvalidController, match="whole milliseconds"):
        generate(odd, ROBOT, NXT, "pybricks")


def test_a_memory_that_grows_alone_has_no_fixed_point():
    grows = LinearController(
        np.array([[1.2]]), np.ones((1, 3)), np.zeros((1, 6)), np.ones((1, 2)), np.ones((2, 1)), np.ones((2, 3)),
        np.zeros((2, 6)), reads=frozen().reads, period=0.01,
    )  # fmt: skip
    assert not trace(grows, ROBOT, NXT, "c").proven
    with pytest.raises(InvalidController, match="nothing is proven"):
        generate(grows, ROBOT, NXT, "c", number="fixed")


def test_the_command_writes_what_it_says(tmp_path: Path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_controller(frozen(), "controller.json")
    assert main(["firmware", "controller.json", "-t", "c", "--number", "fixed", "-o", "balance.c", "--json"]) == 0
    said = json.loads(capsys.readouterr().out)
    assert said["files"] == ["balance.c", "balance.h"]
    assert 0 < said["quantum"] < 0.08  # [V] less than one step of the NXT's duty, 8 V / 100
    assert head(Path("balance.h").read_text("utf-8"))["number"] == "fixed"
    assert '#include "balance.h"' in Path("balance.c").read_text("utf-8")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        ("firmware controller.json -t lego", "no target is called 'lego'"),
        ("firmware controller.json -t nxc -o balance.c", "ending"),
        ("firmware mpc -t nxc", "ms a period on nxc"),
        ("firmware controller.json -t c -o there/balance.c", "no folder"),
        ("firmware controller.json -t c --certificate controller.json", "JSON without a schema; expected"),
        ("firmware controller.json -t c --seconds 9", "no loop of its own"),
        ("firmware controller.json -t nxc --seconds 3601", "0 (no end) to 3600"),
        ("firmware controller.json -t nxc --seconds -1", "0 (no end) to 3600"),
        ("parity short.py controller.json", "stops by itself after 20 s"),
        ("parity controller.json controller.json", "not a program by upright"),
        ("parity balance.py other.json", "another controller"),
        ("parity balance.py controller.json --chip avr", "no chip for ev3dev"),
    ],
)
def test_every_mistake_is_one_line(tmp_path: Path, capsys, monkeypatch, arguments, said):
    monkeypatch.chdir(tmp_path)
    write_controller(frozen(), "controller.json")
    write_controller(replace(frozen(), kind="lqg by another name"), "other.json")
    written(tmp_path, "ev3dev", EV3, seconds=20)[0].rename("short.py")
    written(tmp_path, "ev3dev", EV3)
    before = sorted(path.name for path in tmp_path.iterdir())
    assert main(arguments.split()) == USER_ERROR
    error = capsys.readouterr().err
    assert said in error
    assert error.count("\n") == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == before


def red_certificate() -> Certificate:
    """Of the frozen design: a hundred robots, all of them fallen."""
    trials = (PushTrial("front", "full", 100, 100, saturated=0.0, travel=0.0, peak=0.0, cycle=0.0),)
    linear = LinearMargins(0.9, 0.5, 2.0, 0.01)
    light, _ = judge(Examined(100, 100, linear, trials, 0.01))
    return Certificate(
        light=light, bound=upper_bound(100, 100), robot=ROBOT.name, kit=NXT.name, controller="lqg",
        hash=controller_hash(frozen()), period=0.01, seed=0, samples=100, fell=100, linear=linear, trials=trials,
        beyond=0, standing=Standing(None, 0.1, 100, 0), subject={"robot": robot_facts(ROBOT), "kit": kit_facts(NXT)},
    )  # fmt: skip


def test_a_red_certificate_is_refused_unless_somebody_insists(tmp_path: Path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_controller(frozen(), "controller.json")
    write_json("red.json", red_certificate().to_json())
    call = ["firmware", "controller.json", "-t", "ev3dev", "-o", "balance.py", "--certificate", "red.json"]
    assert main(call) == USER_ERROR
    assert "may not drive this robot: red" in capsys.readouterr().err
    assert not Path("balance.py").exists()
    assert main([*call, "--anyway"]) == 0
    assert "overridden: red" in capsys.readouterr().out
    assert Path("balance.py").exists()


if __name__ == "__main__":
    for name, text in golden_files().items():
        (GOLDEN / name).write_text(text, encoding="utf-8")
