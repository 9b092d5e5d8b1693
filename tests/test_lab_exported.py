"""The lab without Python: what is printed for a page moves as Python does, by node; the page itself, in Chromium."""

from __future__ import annotations

import json
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.compiled.print_javascript import JavaScriptPrinter
from upright.control import CONTROLLERS, Controller, gain_of
from upright.control.delay import RAW
from upright.experiment import Push, run
from upright.lab.by_hand import gains_program
from upright.lab.printed import printed_law, printed_robot, reading
from upright.robots import Kit, Robot, Sensor
from upright.signals import STATE_NAMES

WEB = Path(__file__).resolve().parents[1] / "src" / "upright" / "lab" / "web"
SIMULATOR = WEB / "src" / "simulator.js"
START = (0.03, 0.0, 0.0, 0.0, 0.0, 0.1)
LASTS = 0.1  # [s] of the push

HARNESS = """
const {{ sin, cos, sqrt }} = Math;
const motion = {motion};
const law = {law};
const {{ facts, control, pushes, start, periods }} = {numbers};
const loop = new Loop({{ motion, ...facts }}, {{ law, ...control }}, start, 0);
const [rows, reference] = [[], new Float64Array(6)];
for (let k = 0; k < periods; k += 1) {{
  rows.push(Array.from(loop.x));
  loop.step(reference, (t, w) => combined(pushes, t, 0, w));
}}
all.push(rows);
"""


def node(folder: Path, code: str) -> Any:
    """What the code prints, as JSON."""
    script = folder / "test.mjs"
    script.write_text(
        f"import {{ Loop, combined, normals, philox }} from {json.dumps(str(SIMULATOR))};\n{code}", "utf-8"
    )
    done = subprocess.run(["node", str(script)], capture_output=True, text=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def pages_of(folder: Path, *parts: str) -> list[Any]:
    """The rows of states that each part gives."""
    return node(folder, f"const all = [];{''.join(parts)}console.log(JSON.stringify(all));")


def part(robot: Robot, kit: Kit, law: tuple[str, dict[str, Any]], push: Push, seconds: float) -> str:
    motion, facts = printed_robot(robot, kit)
    text, control = law
    pushes = [{"force": push.force, "start": push.start, "duration": LASTS, "height": robot.com_height}]
    periods = round(seconds / kit.period)
    numbers = {"facts": facts, "control": control, "pushes": pushes, "start": START, "periods": periods}
    return "{" + HARNESS.format(motion=motion, law=text, numbers=json.dumps(numbers)) + "}\n"


def states(robot: Robot, kit: Kit, controller: Controller, push: Push, seconds: float) -> np.ndarray:
    log = run(Electronics(NonlinearBody(robot), kit), controller, push, seconds=seconds, start=START)
    return np.column_stack([log[f"truth/{name}"] for name in STATE_NAMES])


def quiet(kit: Kit, exact: bool) -> Kit:
    """The kit without what is random, whose generator is another one in the page; an `exact` one without steps, too."""
    faults = dict.fromkeys(("noise", "bias", "bias_walk", *(("quantum",) if exact else ())), 0.0)
    motor = replace(kit.motor, quantum=0.0, dead_zone=0.0) if exact else kit.motor
    sensors = {name: replace(sensor, **faults) for name, sensor in kit.sensors.items()}
    return replace(kit, jitter=0.0, motor=motor, sensors=sensors)


@pytest.mark.needs("node")
@pytest.mark.slow
@pytest.mark.parametrize("name", ["herrera2015", "nxtway-gs", "twipr"])
def test_a_page_moves_a_robot_as_python_does(tmp_path, name):
    """Both compute alike but for the last bit of sines and the order of some sums; a balanced robot forgets that. With
    quanta it does not: what is smaller than a quantum is not fed back. On TWIPR it passes the gyro alone, which has no
    steps, and grows by about e^9t in the memory of a controller that is itself unstable: there 0.7 s instead of 2."""
    robot = Robot.preset(name)
    kit = Kit.preset(robot.kit_name)
    push = Push(force=0.03 * robot.body_mass * robot.gravity / LASTS / 10, start=1.0, duration=LASTS)
    cases = [
        (quiet(kit, exact), CONTROLLERS[family](robot, kit, kit.period), seconds)
        for family in ("lqg", "sliding", "lqi" if name == "twipr" else "mpc")
        for exact, seconds in ((True, 10.0), (False, 0.7 if name == "twipr" else 2.0))
    ]
    parts = [part(robot, some, printed_law(c, some), push, seconds) for some, c, seconds in cases]
    pages = pages_of(tmp_path, *parts)
    for (some, controller, seconds), page in zip(cases, pages, strict=True):
        python = states(robot, some, controller, push, seconds)
        assert len(python) == round(seconds / kit.period)  # it did not fall, which would end the comparison
        assert np.abs(python).max() > 0.03  # it moved by more than it began with
        assert np.abs(python - np.array(page)).max() < 1e-9


@pytest.mark.needs("node")
def test_every_fault_of_a_kit_is_in_the_page(tmp_path):
    """Delays, sample and hold, backlash, range, unequal motors, a limit and a sagging battery, all at once."""
    robot, usual = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    sensor = Sensor(delay=0.003, period=0.004, range=0.9)
    motor = replace(usual.motor, backlash=0.02, left=0.9, right=0.95, limit=5.0)
    battery = replace(usual.battery, sag=0.2)
    kit = replace(quiet(usual, False), sensors=dict.fromkeys(usual.sensors, sensor), motor=motor, battery=battery)
    controller = CONTROLLERS["lqg"](robot, usual, usual.period)
    push = Push(force=1.0, start=0.1, duration=LASTS)
    page = pages_of(tmp_path, part(robot, kit, printed_law(controller, kit), push, 0.5))[0]
    python = states(robot, kit, controller, push, 0.5)
    assert np.abs(python - np.array(page)[: len(python)]).max() < 1e-9


@pytest.mark.needs("node")
@pytest.mark.parametrize("name", ["nxtway-gs", "twipr"])
def test_the_present_gains_by_hand_are_the_design(tmp_path, name):
    """An LQR's own six gains, given as inputs of the program, balance as the LQR does."""
    robot = Robot.preset(name)
    kit = quiet(Kit.preset(robot.kit_name), exact=True)
    controller = CONTROLLERS["lqr"](robot, kit, kit.period)
    gain = gain_of(controller)
    assert gain is not None
    law = JavaScriptPrinter(gains_program(robot, kit)).text()
    control = {**reading(RAW, kit.period, kit), "gains": gain[0, :6].tolist()}
    push = Push(force=0.2, start=0.5, duration=LASTS)
    page = pages_of(tmp_path, part(robot, kit, (law, control), push, 2.0))[0]
    assert np.abs(states(robot, kit, controller, push, 2.0) - np.array(page)).max() < 1e-9


@pytest.mark.needs("node")
def test_random_words_are_those_of_the_published_generator(tmp_path):
    """The known answers of Salmon et al. (2011) for Philox 4×32-10: zeros, ones, and digits of π."""
    most, pi = 0xFFFFFFFF, [0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344, 0xA4093822, 0x299F31D0]
    given = [[0] * 6, [most] * 6, pi]
    code = f"console.log(JSON.stringify({given}.map((c) => philox(c.slice(0, 4), c.slice(4)))));"
    assert node(tmp_path, code) == [
        [0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8],
        [0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD],
        [0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1],
    ]


@pytest.mark.needs("node")
def test_noise_is_normal(tmp_path):
    """Of 40 000 numbers, mean and variance within five of their standard deviations, 1/√n and √(2/n)."""
    count = "for (let i = 0; i < 20000; i += 1) all.push(...normals(i, 3, 7));"
    numbers = np.array(node(tmp_path, f"const all = []; {count} console.log(JSON.stringify(all));"))
    n = len(numbers)
    assert abs(numbers.mean()) < 5 / np.sqrt(n)
    assert abs(numbers.var() - 1) < 5 * np.sqrt(2 / n)
    pairs = numbers.reshape(-1, 2)
    assert abs(np.mean(pairs[:, 0] * pairs[:, 1])) < 5 / np.sqrt(n / 2)  # both of a pair are independent
