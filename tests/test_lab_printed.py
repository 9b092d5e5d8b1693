"""What an exported lab prints for a page moves as Python does, by node; and what is written, and refused."""

from __future__ import annotations

import json
import shlex
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

from conftest import PATIENCE
from interpreter import Interpreter
from test_sensor_dynamics import also
from upright.bodies import Electronics, NonlinearBody, make_body
from upright.calibration.calibrate import prepared
from upright.calibration.informativity import too_quiet
from upright.cli.main import main
from upright.compiled.print_javascript import JavaScriptPrinter, functions
from upright.control import CONTROLLERS, Controller, gain_of
from upright.control.delay import RAW
from upright.control.feedback import StateFeedback
from upright.control.law import as_law, program
from upright.control.observed import observed
from upright.experiment import Push, run
from upright.lab.by_hand import gains_program
from upright.lab.export import export
from upright.lab.printed import linear_plant, printed_law, printed_robot, reading
from upright.lab.pushing import Score
from upright.lab.tasks import analysed
from upright.loops.analysis import analyse
from upright.robots import Kit, Robot, Sensor, find_kit, preset_names
from upright.signals import STATE_NAMES, Log

WEB = Path(__file__).resolve().parents[1] / "src" / "upright" / "lab" / "web"
SIMULATOR = WEB / "src" / "simulator.js"
START = (0.03, 0.0, 0.0, 0.0, 0.0, 0.1)
LASTS = 0.1  # [s] of the push
SEED = 2**31 - 5  # of noise, bias, walk and jitter: the page draws what a body draws

HARNESS = """
const motion = {motion};
const law = {law};
const {{ facts, control, pushes, start, periods }} = {numbers};
const loop = new Loop({{ motion, ...facts }}, {{ law, ...control }}, start, {seed});
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
        f"import {{ Loop, combined, linearMotion, normal, philox }} from {json.dumps(str(SIMULATOR))};\n"
        f"{functions()}{code}",
        "utf-8",
    )
    done = subprocess.run(["node", str(script)], capture_output=True, text=True, check=False, timeout=PATIENCE)
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
    return "{" + HARNESS.format(motion=motion, law=text, numbers=json.dumps(numbers), seed=SEED) + "}\n"


def states(robot: Robot, kit: Kit, controller: Controller, push: Push, seconds: float) -> np.ndarray:
    log = run(Electronics(NonlinearBody(robot), kit), controller, push, seconds=seconds, start=START, seed=SEED)
    return np.column_stack([log[f"truth/{name}"] for name in STATE_NAMES])


def smooth(kit: Kit) -> Kit:
    """The kit without steps of any size, its noise as it is."""
    sensors = {name: replace(sensor, quantum=0.0) for name, sensor in kit.sensors.items()}
    return replace(kit, motor=replace(kit.motor, quantum=0.0, dead_zone=0.0), sensors=sensors)


class AsProgram:
    """The controller as its program, statement by statement: sums in the order in which a page has them too."""

    def __init__(self, controller: Controller) -> None:
        self.designed, self.spec = controller, controller.spec
        self.program = program(as_law(controller))
        self.machine = Interpreter(self.program)

    def reset(self) -> None:
        self.machine.reset()

    def step(self, measurement: np.ndarray, reference: np.ndarray) -> tuple[float, float]:
        names = [*self.program.channels, *(f"reference_{name}" for name in STATE_NAMES)]
        given = [*measurement.tolist(), *reference.tolist()]
        values = self.machine.command(dict(zip(names, given, strict=True)))
        return values["command_left"], values["command_right"]

    def applied(self, command: Any) -> None:
        self.machine.values |= {"applied_left": float(command[0]), "applied_right": float(command[1])}
        self.machine.update()

    def estimate(self) -> tuple[float, ...]:
        return tuple(self.designed.estimate())

    def to_json(self) -> dict[str, Any]:
        return self.designed.to_json()


@pytest.mark.needs("node")
@pytest.mark.parametrize(
    "name", [pytest.param("herrera2015", marks=pytest.mark.evidence), "nxtway-gs", "twipr", "stepper"]
)
def test_a_page_moves_a_robot_as_python_does(tmp_path, name):
    """Without quanta, a balanced robot forgets that a matrix product sums in another order than the page. With quanta
    it does not: what is smaller than a quantum is not fed back. So there Python, too, computes the controller's
    program, and both are equal to the last bit until libm rounds a sine otherwise, as it does with one in a thousand.
    On TWIPR those 1e-17 rad/s pass the gyro, which has no steps, and grow by e^13t in a controller that is itself
    unstable: to 2e-9 at 2 s. (Python with another processor's products is 1e-9 away from itself after 0.4 s.)"""
    robot = Robot.preset(name)
    kit = Kit.preset(robot.kit_name)
    push = Push(force=0.03 * robot.body_mass * robot.gravity / LASTS / 10, start=1.0, duration=LASTS)
    cases = [
        (smooth(kit) if exact else kit, CONTROLLERS[family](robot, kit, kit.period), seconds)
        for family in ("lqg", "sliding", "lqi" if name == "twipr" else "mpc")
        for exact, seconds in ((True, 2.5), (False, 1.5))
    ]
    parts = [part(robot, some, printed_law(c, some), push, seconds) for some, c, seconds in cases]
    pages = pages_of(tmp_path, *parts)
    for (some, controller, seconds), page in zip(cases, pages, strict=True):
        python = states(robot, some, controller if seconds > 2 else AsProgram(controller), push, seconds)
        assert len(python) == round(seconds / kit.period)  # it did not fall, which would end the comparison
        assert np.abs(python).max() > 0.03  # it moved by more than it began with
        assert np.abs(python - np.array(page)).max() < (1e-9 if seconds > 2 or name != "twipr" else 1e-8)


@pytest.mark.needs("node")
def test_sines_of_the_page_are_rounded_correctly(tmp_path):
    """But for one in a thousand, against 60 digits; those of the browser's engine err in one of fifty."""
    draw = np.random.default_rng(4)
    angles = np.concatenate([draw.uniform(-1.4, 1.4, 1500), draw.uniform(-300, 300, 500), [0.0, 1e-9, 1e5, 3e7]])
    page = node(tmp_path, f"console.log(JSON.stringify({angles.tolist()}.map((x) => [sin(x), cos(x)])));")
    with mpmath.workdps(60):
        true = [(float(mpmath.sin(x)), float(mpmath.cos(x))) for x in angles.tolist()]
    assert np.count_nonzero(np.array(page) != np.array(true)) <= 4


@pytest.mark.needs("node")
def test_every_fault_of_a_kit_is_in_the_page(tmp_path):
    """Delays, sample and hold, backlash, range, unequal motors, a limit, a drop, a sagging battery, and all that is
    random, at once."""
    robot, usual = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    sensor = Sensor(delay=0.003, period=0.004, range=0.9, noise=0.01, bias=0.02, bias_walk=0.05, gain=1.1)
    motor = replace(usual.motor, backlash=0.02, left=0.9, right=0.95, limit=5.0, drop=0.4)
    battery = replace(usual.battery, sag=0.2)
    sensors = dict.fromkeys(usual.sensors, sensor)
    kit = replace(usual, sensors=sensors, motor=motor, battery=battery, jitter=0.004)
    controller = CONTROLLERS["lqg"](robot, usual, usual.period)
    push = Push(force=1.0, start=0.1, duration=LASTS)
    page = pages_of(tmp_path, part(robot, kit, printed_law(controller, kit), push, 0.5))[0]
    python = states(robot, kit, controller, push, 0.5)
    assert np.abs(python - np.array(page)[: len(python)]).max() < 1e-9


@pytest.mark.needs("node")
def test_a_gyro_that_swings_and_a_fused_angle_are_in_the_page(tmp_path):
    """On a tilted gyro with a scale error, and a filter with its own rate, both late and noisy."""
    robot, usual = Robot.preset("ev3way"), Kit.preset("ev3")
    faults = {"noise": 0.002, "offset": 0.01, "delay": 0.003}
    gyro = Sensor(resonance=11.0, damping=0.1, misalignment=-0.2, gain=1.05, **faults)
    angle = Sensor(time_constant=0.3, period=0.004, bias=0.01, **faults)
    forward = Sensor(noise=0.05, bias=0.1, bias_walk=0.02, period=0.002, delay=0.005)
    own = {"sensor/gyro": gyro, "sensor/accel_forward": forward, "sensor/pitch": angle}
    kit = replace(usual, sensors=usual.sensors | own)
    linear = CONTROLLERS["lqg"](robot, usual, usual.period)
    controller = also(linear, {"sensor/pitch": 2.0})
    push = Push(force=0.5, start=0.1, duration=LASTS)
    page = pages_of(tmp_path, part(robot, kit, printed_law(controller, kit), push, 1.0))[0]
    python = states(robot, kit, controller, push, 1.0)
    assert np.abs(python).max() > 0.03
    assert np.abs(python - np.array(page)[: len(python)]).max() < 1e-9


@pytest.mark.needs("node")
def test_the_ghost_is_the_linear_body(tmp_path):
    """Of a robot with dry friction, which is TWIPR, too."""
    for name, family, rows in (("nxtway-gs", "lqg", 100), ("twipr", "lqi", 50), ("stepper", "lqg", 100)):
        robot = Robot.preset(name)
        usual = Kit.preset(robot.kit_name)
        kit, controller = smooth(usual), CONTROLLERS[family](robot, usual, usual.period)
        push = Push(force=0.2, start=0.2, duration=LASTS)
        linear = json.dumps(printed_robot(robot, kit)[1]["linear"])
        code = part(robot, kit, printed_law(controller, kit), push, rows * kit.period)
        before, after = code.index("const motion"), code.index("const law")
        page = pages_of(tmp_path, f"{code[:before]}const motion = linearMotion({linear});{code[after:]}")[0]
        body = Electronics(make_body("linear", robot), kit)
        log = run(body, controller, push, seconds=rows * kit.period, start=START, seed=SEED)
        python = np.column_stack([log[f"truth/{state}"] for state in STATE_NAMES])
        assert np.abs(python - np.array(page)).max() < 1e-9


@pytest.mark.needs("node")
@pytest.mark.parametrize("name", ["nxtway-gs", "twipr", "stepper"])
def test_the_present_gains_by_hand_are_the_design(tmp_path, name):
    """An LQR's own six gains, given as inputs of the program, balance as the LQR does."""
    robot = Robot.preset(name)
    kit = smooth(Kit.preset(robot.kit_name))
    controller = CONTROLLERS["lqr"](robot, kit, kit.period)
    gain = gain_of(controller)
    assert gain is not None
    law = JavaScriptPrinter(gains_program(robot, kit)).text()
    control = {**reading(RAW, kit.period, kit), "gains": gain[0, :6].tolist()}
    push = Push(force=0.2, start=0.5, duration=LASTS)
    page = pages_of(tmp_path, part(robot, kit, (law, control), push, 1.0))[0]
    assert np.abs(states(robot, kit, controller, push, 1.0) - np.array(page)).max() < 1e-9


@pytest.mark.needs("node")
def test_margins_of_gains_by_hand_are_python_s(tmp_path):
    """Of the LQR's gains, of others that balance, and of ones that do not; delays of half a period and of five."""
    cases = [("nxtway-gs", (0.7, 1.2, 0.8, 1.1, 1.4, 0.6)), ("nxtway-gs", (0.1, 1, 1, 1, 1, 1)),
             ("twipr", (1, 1, 1, 1, 1, 1))]  # fmt: skip
    code, python = f"import {{ analysed }} from {json.dumps(str(WEB / 'src' / 'margins.js'))};const all = [];", []
    for name, factors in cases:
        robot = Robot.preset(name)
        kit = Kit.preset(robot.kit_name)
        usual = gain_of(CONTROLLERS["lqr"](robot, kit, kit.period))
        assert usual is not None
        gains = tuple((usual[0, :6] * factors).tolist())
        symmetric = StateFeedback.symmetric(gains, kit.period, command_unit=robot.command_unit)
        design = observed(symmetric, robot, kit)
        python.append((analysed(design, robot, kit), analyse(design, robot, kit, robots=())))
        law = JavaScriptPrinter(gains_program(robot, kit)).text()
        code += f"all.push(analysed({json.dumps(linear_plant(robot, kit))}, {law}, {list(gains)}));"
    page = node(tmp_path, code + "console.log(JSON.stringify(all));")
    assert [a.stable for a, _ in python] == [True, False, True]
    for (mine, theory), its in zip(python, page, strict=True):
        assert mine.stable == its["stable"]
        assert len(mine.poles) == len(its["poles"])
        assert max(map(abs, np.array(its["poles"])[:, 0])) < 2
        assert np.hypot(*its["poles"][0]) == pytest.approx(
            np.hypot(*mine.poles[0]), abs=1e-5
        )  # Python's are rounded so
        seen, drawn = np.array(its["L"]), np.array(mine.L)[:, ::2]
        assert np.abs(seen - drawn).max() < 1e-3 * np.abs(drawn).max()  # Python's have four digits
        for margin in ("gain_low", "gain_high", "phase", "delay") if mine.stable else ():
            assert its[margin] == pytest.approx(getattr(theory.both(), margin), abs=1e-6)


@pytest.mark.needs("node")
def test_the_page_scores_as_the_live_lab(tmp_path):
    """Whatever is done, at random: pushes, falls, leans and changes. Every kind of end is among the results."""
    draw = np.random.default_rng(11)
    rows: list[tuple[str, float, float, float, bool]] = []
    for _ in range(200):
        what = str(draw.choice(["push", "push", "push", "exchanged", "anew"]))
        force, lasts, swings = float(draw.uniform(0.1, 5)), int(draw.choice([2, 40, 80])), int(draw.integers(0, 60))
        after = int(draw.choice([20, 200]))  # periods until the next: too few to recover, or enough
        falls = draw.random() < 0.1
        rows.append((what, 0.1 if draw.random() < 0.5 else 0.0, 0.0, 0.0, False))
        rows += [("", force if what == "push" else 0.0, 0.1, 0.0, False)] * lasts
        rows += [("", 0.0, 0.2, 1.0, False)] * swings + [("", 0.0, 0.01, 0.1, falls)] * after
    score, python = Score(), []
    for what, value, pitch, rate, fell in rows:
        if what:
            score = score.anew(value) if what == "anew" else (getattr(score, what)(), score)[1]
        elif done := score.watch(0.01, value, [pitch, rate], (0.5, -0.25), fell):
            python.append([done.impulse, done.effort, done.best, done.fell, done.single, score.run])
    code = f"""import {{ Score }} from {json.dumps(str(WEB / "src" / "score.js"))};
        let score = new Score(); const all = [];
        for (const [what, value, pitch, rate, fell] of {json.dumps(rows)}) {{
          if (what === "anew") score = score.anew(value);
          else if (what) score[what]();
          else {{
            const done = score.watch(0.01, value, pitch, rate, [0.5, -0.25], fell);
            if (done) all.push([done.impulse, done.effort, done.best, done.fell, done.single, score.run]);
          }}
        }} console.log(JSON.stringify(all));"""
    assert {(fell, single) for *_, fell, single, _ in python} == {(a, b) for a in (True, False) for b in (True, False)}
    assert node(tmp_path, code) == python


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
    count = "for (let i = 0; i < 10000; i += 1) for (const kind of [4, 5, 6, 7]) all.push(normal(i, 2, kind, 7));"
    numbers = np.array(node(tmp_path, f"const all = []; {count} console.log(JSON.stringify(all));"))
    n = len(numbers)
    assert abs(numbers.mean()) < 5 / np.sqrt(n)
    assert abs(numbers.var() - 1) < 5 * np.sqrt(2 / n)
    kinds = np.corrcoef(numbers.reshape(-1, 4).T) - np.eye(4)
    assert np.abs(kinds).max() < 5 / np.sqrt(n / 4)  # sensors of one counter are independent


# The page itself

EXCITED = "upright example excited -o run.csv"
DRIVEN = (
    "upright simulate -r twipr -b twin -c lqg --start pitch=0.1 --drive 0.5,start=1,until=4 --turn 1,start=2,until=5 "
    "-s 6 -o run.csv"  # 0.5 m/s: 8 rad/s of wheels of 63 mm
)


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=() if name == "twipr" else pytest.mark.evidence)
        for name in preset_names()
        if name not in ("nxtway-gs", "stepper")  # a log of a speed drive is not calibrated yet
    ],
)
def test_the_log_of_the_recipe_is_one_to_calibrate_from(tmp_path, name):
    """Its robot stands all the time, and moves by more than the steps of its gyro."""
    speed = f"{8 * Robot.preset(name).wheel_radius:.2g}"
    command = DRIVEN.replace("twipr", name).replace("0.5,", f"{speed},").replace("run.csv", str(tmp_path / "run.csv"))
    assert main(shlex.split(command)[1:]) == 0
    log = Log.load(tmp_path / "run.csv")
    assert log.t[-1] > 5.9
    robot = Robot.preset(name)
    problem, _ = prepared([log], robot, find_kit(robot.kit), (), 0.25)
    assert too_quiet(problem) is None


def refusal(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert main(["lab", *arguments]) == 2
    (line,) = capsys.readouterr().err.strip().splitlines()
    return line


def test_another_page_is_never_written_over(tmp_path, capsys):
    (tmp_path / "index.html").write_text("<h1>mine</h1>", "utf-8")
    (tmp_path / "notes.txt").write_text("mine", "utf-8")
    assert "is another page" in refusal(capsys, "--export", str(tmp_path))
    assert (tmp_path / "index.html").read_text("utf-8") == "<h1>mine</h1>"


def test_other_files_of_the_folder_stay(tmp_path):
    (tmp_path / "notes.txt").write_text("mine", "utf-8")
    said, done = list[str](), list[float]()
    export(tmp_path, ["nxtway-gs", "ev3way"], ["lqr"], say=said.append, progress=done.append)
    assert [line.partition(":")[0] for line in said] == ["nxtway-gs", "ev3way"]  # while it takes its time
    assert done == [0, 0.5]  # before the method of each of two robots
    export(tmp_path, ["nxtway-gs"], ["lqr"], say=said.append)  # an exported lab may be written again
    assert sorted(path.name for path in tmp_path.iterdir()) == ["index.html", "notes.txt"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--export", "{}/page.html"), "names a page"),
        (("--export", "{}/file"), "is no folder"),
        (("--export", "{}/site", "--robots", "nobody"), "nobody"),
        (("--export", "{}/site", "--controllers", "nothing"), "nothing"),
        (("--export", "{}/site", "--robots", "twipr,twipr"), "two robots are called twipr"),
        (("--export", "{}/site", "--robots", "twipr", "--controllers", "lqr-complementary"), "no controller"),
        (("--export", "{}/site", "--class"), "--export with --class"),
        (("--robots", "twipr"), "--robots without --export"),
    ],
)
def test_what_cannot_be_exported_is_refused_in_a_line(tmp_path, capsys, arguments, words):
    (tmp_path / "file").write_text("", "utf-8")
    assert main(["lab", *(a.format(tmp_path) for a in arguments)]) == 2
    assert words in capsys.readouterr().err.strip().splitlines()[-1]
    assert not (tmp_path / "site").exists()
