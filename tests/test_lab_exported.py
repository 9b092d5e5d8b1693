"""The lab without Python: what is printed for a page moves as Python does, by node; the page itself, in Chromium."""

from __future__ import annotations

import json
import shlex
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

from conftest import PATIENCE
from upright.bodies import Electronics, NonlinearBody, make_body
from upright.calibrate.calibrate import prepared
from upright.calibrate.informativity import too_quiet
from upright.classwork.grading import grade_file
from upright.classwork.tasks import TASKS
from upright.classwork.worksheet import fragment
from upright.cli.main import group, main
from upright.compiled.interpret import Interpreter
from upright.compiled.print_javascript import JavaScriptPrinter, functions
from upright.control import CONTROLLERS, Controller, gain_of
from upright.control.delay import RAW
from upright.control.feedback import StateFeedback
from upright.control.law import as_law, program
from upright.control.observed import observed
from upright.experiment import Impulse, Push, run
from upright.lab.by_hand import gains_program
from upright.lab.codec import plain
from upright.lab.export import export
from upright.lab.handin import read_hand_in
from upright.lab.printed import linear_plant, printed_law, printed_robot, reading
from upright.lab.pushing import Score
from upright.lab.rerun import rerun
from upright.lab.tasks import analysed
from upright.robots import Kit, Robot, Sensor, find_kit, preset_names
from upright.signals import STATE_NAMES, Log

WEB = Path(__file__).resolve().parents[1] / "src" / "upright" / "lab" / "web"
SIMULATOR = WEB / "src" / "simulator.js"
START = (0.03, 0.0, 0.0, 0.0, 0.0, 0.1)
LASTS = 0.1  # [s] of the push

HARNESS = """
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
        f"import {{ Loop, combined, linearMotion, normals, philox }} from {json.dumps(str(SIMULATOR))};\n"
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
@pytest.mark.slow
@pytest.mark.parametrize("name", ["herrera2015", "nxtway-gs", "twipr"])
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
        (quiet(kit, exact), CONTROLLERS[family](robot, kit, kit.period), seconds)
        for family in ("lqg", "sliding", "lqi" if name == "twipr" else "mpc")
        for exact, seconds in ((True, 10.0), (False, 2.0))
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
    """Delays, sample and hold, backlash, range, unequal motors, a limit, a drop and a sagging battery, all at once."""
    robot, usual = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    sensor = Sensor(delay=0.003, period=0.004, range=0.9)
    motor = replace(usual.motor, backlash=0.02, left=0.9, right=0.95, limit=5.0, drop=0.4)
    battery = replace(usual.battery, sag=0.2)
    kit = replace(quiet(usual, False), sensors=dict.fromkeys(usual.sensors, sensor), motor=motor, battery=battery)
    controller = CONTROLLERS["lqg"](robot, usual, usual.period)
    push = Push(force=1.0, start=0.1, duration=LASTS)
    page = pages_of(tmp_path, part(robot, kit, printed_law(controller, kit), push, 0.5))[0]
    python = states(robot, kit, controller, push, 0.5)
    assert np.abs(python - np.array(page)[: len(python)]).max() < 1e-9


@pytest.mark.needs("node")
def test_the_ghost_is_the_linear_body(tmp_path):
    """Of a robot with dry friction, which is TWIPR, too."""
    for name, family, rows in (("nxtway-gs", "lqg", 100), ("twipr", "lqi", 50)):
        robot = Robot.preset(name)
        usual = Kit.preset(robot.kit_name)
        kit, controller = quiet(usual, exact=True), CONTROLLERS[family](robot, usual, usual.period)
        push = Push(force=0.2, start=0.2, duration=LASTS)
        linear = json.dumps(printed_robot(robot, kit)[1]["linear"])
        code = part(robot, kit, printed_law(controller, kit), push, rows * kit.period)
        before, after = code.index("const motion"), code.index("const law")
        page = pages_of(tmp_path, f"{code[:before]}const motion = linearMotion({linear});{code[after:]}")[0]
        body = Electronics(make_body("linear", robot), kit)
        log = run(body, controller, push, seconds=rows * kit.period, start=START)
        python = np.column_stack([log[f"truth/{state}"] for state in STATE_NAMES])
        assert np.abs(python - np.array(page)).max() < 1e-9


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
@pytest.mark.slow
def test_margins_of_gains_by_hand_are_python_s(tmp_path):
    """Of the LQR's gains, of others that balance, and of ones that do not; delays of half a period and of five."""
    cases = [("ev3way", (1.5, 0.8, 1.3, 0.9, 1, 1)), ("nxtway-gs", (0.7, 1.2, 0.8, 1.1, 1.4, 0.6)),
             ("nxtway-gs", (0.1, 1, 1, 1, 1, 1)), ("twipr", (1, 1, 1, 1, 1, 1))]  # fmt: skip
    code, python = f"import {{ analysed }} from {json.dumps(str(WEB / 'src' / 'margins.js'))};const all = [];", []
    for name, factors in cases:
        robot = Robot.preset(name)
        kit = Kit.preset(robot.kit_name)
        usual = gain_of(CONTROLLERS["lqr"](robot, kit, kit.period))
        assert usual is not None
        gains = tuple((usual[0, :6] * factors).tolist())
        symmetric = StateFeedback.symmetric(gains, kit.period, command_unit=robot.command_unit)
        python.append(analysed(observed(symmetric, robot, kit), robot, kit))
        law = JavaScriptPrinter(gains_program(robot, kit)).text()
        code += f"all.push(analysed({json.dumps(linear_plant(robot, kit))}, {law}, {list(gains)}));"
    page = node(tmp_path, code + "console.log(JSON.stringify(all));")
    assert [a.stable for a in python] == [True, True, False, True]
    for mine, its in zip(python, page, strict=True):
        assert (mine.stable, mine.words) == (its["stable"], its["words"])
        assert len(mine.poles) == len(its["poles"])
        assert max(map(abs, np.array(its["poles"])[:, 0])) < 2
        assert np.hypot(*its["poles"][0]) == pytest.approx(
            np.hypot(*mine.poles[0]), abs=1e-5
        )  # Python's are rounded so
        seen, drawn = np.array(its["L"]), np.array(mine.L)[:, ::2]
        assert np.abs(seen - drawn).max() < 1e-3 * np.abs(drawn).max()  # Python's have four digits
        for margin in ("gain_low", "gain_high", "phase", "delay") if mine.stable else ():
            assert its[margin] == pytest.approx(getattr(mine, margin), abs=1e-6)


@pytest.mark.needs("node")
def test_the_page_scores_as_the_live_lab(tmp_path):
    """Whatever is done, at random: pushes, falls, leans and changes. Every kind of end is among the results."""
    draw = np.random.default_rng(11)
    rows: list[tuple[str, float, float, float, bool]] = []
    for _ in range(600):
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
    count = "for (let i = 0; i < 20000; i += 1) all.push(...normals(i, 3, 7));"
    numbers = np.array(node(tmp_path, f"const all = []; {count} console.log(JSON.stringify(all));"))
    n = len(numbers)
    assert abs(numbers.mean()) < 5 / np.sqrt(n)
    assert abs(numbers.var() - 1) < 5 * np.sqrt(2 / n)
    pairs = numbers.reshape(-1, 2)
    assert abs(np.mean(pairs[:, 0] * pairs[:, 1])) < 5 / np.sqrt(n / 2)  # both of a pair are independent


# The page itself

BROWSER = [pytest.mark.needs("chromium", "module:playwright"), pytest.mark.slow]
ROBOTS = ("nxtway-gs", "twipr")
LINKED = "#robot=twipr&controller=sliding&noise=0&bodies=nonlinear&push=impulse:0.2"


def marked(test: Any) -> Any:
    """A test of the page in a browser."""
    for mark in BROWSER:
        test = mark(test)
    return test


@pytest.fixture(scope="module")
def site(exported_lab: Path) -> Path:
    """The page of every preset with every usual controller."""
    return exported_lab


LEANT = "upright.store.traces.t.some((t, k) => t > {} && upright.store.traces.x[0][0][k] < -0.01)"
"""Whether it has leant back since that time: a moment of it that a busy machine may not see passing."""


@pytest.fixture
def page(browser: Any, site: Path) -> Iterator[Any]:
    """The page, opened from its folder by a browser without network; it asks for nothing but itself."""
    context = browser.new_context(viewport={"width": 1366, "height": 768}, offline=True)
    made = context.new_page()
    asked: list[str] = []
    wrong: list[str] = []
    made.on("request", lambda request: asked.append(request.url))
    made.on("pageerror", lambda error: wrong.append(str(error)))
    made.goto(site.as_uri())
    made.wait_for_function("window.upright?.page.drawnFirst")
    made.evaluate("upright.page.open('Controller')")  # a newcomer's page begins with the tour
    yield made
    context.close()
    assert [url for url in asked if not url.startswith((site.as_uri(), "data:"))] == []
    assert wrong == []


def send(page: Any, **message: Any) -> None:
    page.evaluate("(message) => upright.store.send(message)", message)


@marked
def test_the_page_is_small(site):
    assert len(site.read_bytes()) < 1.5e6  # bar 1.5 MB, with every preset


@marked
def test_the_page_s_session_is_python_s_run(page):
    """Without quanta and noise, at rest under a knock: what the page shows after 3 s is what `run` computes."""
    robot = Robot.preset("nxtway-gs")
    kit = quiet(Kit.preset("nxt"), exact=True)
    kit = replace(kit, motor=Kit.preset("nxt").motor)  # the page's slider scales the sensors alone
    send(page, kind="Play", paused=True, speed=1)
    page.evaluate("upright.exported.facts.robots['nxtway-gs'].kit.sensors.forEach((s) => { s.bias_walk = 0; })")
    page.evaluate("upright.store.change({ noise: 0, controller: 'lqg' })")
    send(page, kind="StandUp", pitch=0)
    send(page, kind="Strike", what="impulse", size=0.05)
    send(page, kind="Step", periods=300)
    shown = page.evaluate("upright.store.snapshot.x[0].slice(0, 6)")
    controller = CONTROLLERS["lqg"](robot, Kit.preset("nxt"), kit.period)
    log = run(Electronics(NonlinearBody(robot), kit), controller, Impulse(impulse=0.05, start=0.0, duration=0.02),
              seconds=3.01)  # fmt: skip
    python = [log[f"truth/{name}"][-1] for name in STATE_NAMES]
    assert log.t[-1] == pytest.approx(3.0)
    assert np.abs(np.array(shown) - python).max() < 1e-6  # the driver's quantum is on: differences are not forgotten


@marked
def test_a_link_carries_robot_controller_and_push(page, site):
    page.goto("about:blank")
    page.goto(site.as_uri() + LINKED)
    page.wait_for_function("window.upright?.page.drawnFirst")
    setup = page.evaluate("upright.store.setup")
    assert (setup["robot"], setup["controller"], setup["noise"]) == ("twipr", "sliding", 0)
    page.wait_for_function(LEANT.format(0))  # a second later it is pushed
    assert page.evaluate("upright.page.address()") == site.as_uri() + LINKED


@marked
def test_links_of_the_worksheet_set_the_page_up_too(page, site):
    """The first opens the page; the others come one after the other into the open one: nothing of the task before
    stays."""
    page.goto("about:blank")
    page.goto(site.as_uri() + fragment(TASKS[2]))
    page.wait_for_function("window.upright?.page.drawnFirst")
    for number, task in enumerate((TASKS[2], TASKS[1], TASKS[2], TASKS[0])):
        if number:
            page.evaluate(f"location.hash = {fragment(task)!r}")
        page.wait_for_function(f"upright.store.setup.seed === {task.setup.seed}")
        setup = page.evaluate("upright.store.setup")
        assert {name: setup[name] for name in task.given} == {name: plain(task.setup)[name] for name in task.given}
        assert task.name != "gains" or tuple(setup["gains"]) == task.setup.gains
    page.evaluate("location.hash = '#payload=0.12&payload_height=0.3'")  # which this page does not have
    page.wait_for_function("upright.store.setup.seed === 0")
    assert page.evaluate("upright.store.setup.payload") == 0


@marked
def test_margins_say_what_another_dead_time_takes_of_them(page):
    """The controller stays as it was designed: both motors bear 64 ms more, as the page says itself."""
    page.evaluate("upright.store.change({ robot: 'nxtway-gs', controller: 'lqg' })")
    page.wait_for_function("document.querySelector('.verdict.good')")
    bears = 1e3 * page.evaluate("upright.store.analysed.delay")
    page.evaluate("upright.store.change({ delay: 0.04 })")
    verdict = page.locator(".numbers .verdict")
    page.wait_for_function("document.querySelector('.numbers .verdict.open')")
    assert "at the kit's own dead time" in verdict.inner_text()
    assert f"The slider uses 38\u00a0ms of the {bears:.0f}\u00a0ms" in verdict.inner_text()
    page.evaluate(f"upright.store.change({{ delay: {bears / 1e3 + 0.004} }})")
    page.wait_for_function("document.querySelector('.numbers .verdict.bad')")
    assert "more than the" in verdict.locator("b").inner_text()
    page.evaluate("upright.store.change({ delay: -1 })")
    page.wait_for_function("document.querySelector('.numbers .verdict.good')")
    page.evaluate("upright.store.change({ controller: 'gains' })")
    assert "computes one for gains by hand" in page.locator(".column.full.note, .note.column.full").inner_text()


@marked
def test_a_payload_is_put_on_and_taken_off(page):
    page.click("#tab-Robot")
    weight = page.evaluate("upright.store.changed.look.weight")
    page.click("[data-key=load]")
    assert "300 g" in page.inner_text("label[for=load]")
    # 300 g more, at 9.81 m/s² or what the preset has: a part in a hundred
    assert page.evaluate("upright.store.changed.look.weight") - weight == pytest.approx(0.3 * 9.81, rel=0.01)
    page.click("[data-key=load]")
    assert page.evaluate("upright.store.changed.look.weight") == weight
    page.select_option("[data-key=robot]", "twipr")
    page.click("[data-key=load]")  # every robot of the page can carry it
    assert page.evaluate("upright.store.changed.look.payload") == 0.3


@marked
def test_a_slope_is_drawn_as_steep_as_it_is(page):
    """Positive climbs forward, to the right of the side view; the robot's pitch counts from the floor's normal."""
    page.evaluate("upright.store.change({slope: 0.1, controller: 'off'})")
    page.evaluate("upright.store.send({kind: 'Step', periods: 1})")
    page.wait_for_function("document.querySelector('.ground').getCTM().b")
    steep = "(part => Math.atan2(-part.getCTM().b, part.getCTM().a))(document.querySelector('%s'))"
    assert page.evaluate(steep % ".ground") == pytest.approx(0.1, abs=1e-4)
    lean = page.evaluate("upright.store.snapshot.x[0][0]")
    assert page.evaluate(steep % ".shell") == pytest.approx(0.1 - lean, abs=1e-3)  # forward is clockwise
    assert "5.7°" in page.inner_text(".force")


@marked
def test_traces_are_broken_where_the_robot_does_not_go_on(page):
    """By another controller, and by standing up; not by a knock, however fast it makes the wheels."""
    send(page, kind="Step", periods=20)
    send(page, kind="Strike", what="impulse", size=0.2)
    send(page, kind="Step", periods=100)
    assert page.evaluate("upright.store.traces.breaks.length") == 0
    page.evaluate("upright.store.change({controller: 'pid'})")
    send(page, kind="Step", periods=20)
    send(page, kind="StandUp", pitch=0.0)
    send(page, kind="Step", periods=1)
    (_, first), (_, second) = page.evaluate("upright.store.traces.breaks")
    # 20 periods of 10 ms, less the one or two until the new controller is drawn; standing up is drawn at once
    assert second - first == pytest.approx(0.185, abs=0.006)
    send(page, kind="StandUp", pitch=0.1)
    send(page, kind="Step", periods=1)
    t, pitch = page.evaluate("[upright.store.traces.t, upright.store.traces.x[0][0]]")
    _, (_, third) = page.evaluate("upright.store.traces.breaks.slice(-2)")
    assert pitch[t.index(third)] == 0.1  # the lean that was asked for, before the robot moves


@pytest.mark.parametrize(
    "part", ["robot=nobody", "controller=__proto__", "gains=1,2", "slope=9", "push=impulse:1e9", "%"]
)
@marked
def test_a_link_that_makes_no_sense_is_the_usual_page(page, site, part):
    page.goto("about:blank")
    page.goto(f"{site.as_uri()}#{part}")
    page.wait_for_function("window.upright?.page.drawnFirst")
    assert page.evaluate("[upright.store.setup.robot, upright.store.setup.controller]") == ["nxtway-gs", "lqg"]
    name, _, value = part.partition("=")
    if name in ("robot", "controller"):  # a mistyped name is said, with what there is
        said = page.inner_text(".toast span")
        assert f"{name} '{value}'" in said
        assert ("twipr" if name == "robot" else "lqi") in said
    elif name in ("gains", "slope", "push"):
        assert part in page.inner_text(".toast span")


@marked
def test_gains_by_hand_begin_with_the_present_ones_and_act_at_once(page):
    page.select_option("[data-key=controller]", "lqr")
    present = page.evaluate("upright.store.analysed.gain[0]")
    page.select_option("[data-key=controller]", "gains")
    assert page.evaluate("upright.store.setup.gains") == present[:6]
    typed = page.locator("[data-key=gain-0-typed]")
    page.select_option("[data-key=language]", "es")  # as people type there
    for text, gain in (("-30,5", -30.5), ("-30,5,1", -30.5), (str(present[0]), present[0])):
        typed.fill(text)
        typed.press("Enter")
        page.wait_for_function(f"upright.store.setup.gains[0] === {gain!r}")
        assert (typed.get_attribute("aria-invalid") == "true") == (text == "-30,5,1")
    page.wait_for_function("upright.store.analysed?.delay > 0.02")  # the page's own margins: as those of the LQR
    assert page.locator(".margins tr").count() == 3
    assert not page.evaluate("upright.store.snapshot.x[0][8]")
    send(page, kind="StandUp", pitch=0.05)
    page.evaluate("upright.store.change({ gains: [0, 0, 0, 0, 0, 0] })")
    page.wait_for_function("upright.store.snapshot.x[0][8] === 1")  # nothing holds it: it falls
    page.wait_for_function("upright.store.analysed?.stable === false")


@marked
def test_a_link_without_a_controller_drops_the_robot(page, site):
    """From a small lean: upright, without noise at its wheels, it would stand for seconds."""
    page.goto("about:blank")
    page.goto(site.as_uri() + "#controller=off")
    page.wait_for_function("upright.store.snapshot?.x[0][8] === 1")
    assert page.evaluate("upright.store.setup.controller") == "off"
    assert not page.locator(".hint").is_visible()  # what balances by itself does not lie there


@marked
def test_the_tour_has_the_steps_that_need_no_python(page):
    page.keyboard.press("n")
    for step, controller in enumerate(("lqg", "off", "off", "lqr", "lqg", "lqg", "lqr"), 1):
        assert f"{step} of 7" in page.inner_text(".tour .note")
        if step > 1:
            page.keyboard.press("Enter")
        page.wait_for_function(f"upright.store.changed.setup.controller === '{controller}'")
        page.keyboard.press("n")
    assert page.evaluate("upright.store.changed.setup.payload") > 0
    page.click("[data-key=tour-back]")
    assert page.evaluate("upright.store.changed.setup.payload") == 0


@marked
def test_a_phone_does_the_tour_where_it_is_read(browser, site):
    """What a step names is in its card, and does what the real control does; a tap makes a curve large."""
    context = browser.new_context(viewport={"width": 390, "height": 844}, has_touch=True, offline=True)
    page = context.new_page()
    page.goto(site.as_uri())
    page.wait_for_function("window.upright?.page.drawnFirst")
    page.click("[data-key=invitation]")
    page.wait_for_selector(".scene.pinned")
    page.click("[data-key='act-0.3']")
    assert page.evaluate("upright.store.last.push") == ["impulse", 0.3]
    assert page.input_value("[data-key=knock]") == page.input_value("[data-key=act-size]") == "0.3"
    assert page.inner_text("[data-key=impulse]").split() == ["Knock", "0.30", "N", "s"]
    page.fill("[data-key=act-size]", "0.1")
    page.click("[data-key=impulse]")
    assert page.evaluate("upright.store.last.push") == ["impulse", 0.1]
    span = "(({min, max}) => max - min)(upright.page.charts.strips[0].plot.scales.x)"
    for large in (True, False):
        page.click(".slot .strip:first-child .plot")
        page.wait_for_function(f"{'' if large else '!'}document.querySelector('.slot .strip.large')")
        page.wait_for_function(f"Math.abs({span} - 10) < 0.01")  # [s] that are shown, large or small
        box = page.locator(".slot .plot").first.bounding_box()
        assert (box["height"] >= 150 and box["width"] > 350) == large  # [px] of a page 390 wide
    page.click("[data-key=curves]")  # beside the names of the bodies
    page.wait_for_function("document.querySelectorAll('.charts .strip').length === 4")
    assert page.locator(".charts .strip").last.is_visible()
    assert page.locator(".charts .strip").last.bounding_box()["y"] < 844
    page.evaluate("upright.page.bring('Tour')")
    while not page.locator("[data-key=act-tilt]").count():
        page.click("[data-key=tour-next]")
    page.click("[data-key=act-tilt]")
    page.wait_for_function("upright.store.last.push?.[0] === 'tilt'")
    context.close()


@marked
def test_a_robot_that_sets_off_by_itself_is_marked_so(page, site):
    """Once, where the wheels begin to roll; not where somebody has pushed it before, or has changed it."""
    send(page, kind="Play", paused=True, speed=1)
    page.evaluate("upright.store.change({ noise: 3 })")  # soon enough
    for push in (False, True):
        send(page, kind="StandUp", pitch=0)
        if push:
            send(page, kind="Strike", what="impulse", size=0.05)
        send(page, kind="Step", periods=1)
        for _ in range(100):
            send(page, kind="Step", periods=10)
        marks = page.evaluate("upright.store.traces.marks.map(m => m.what)")
        assert marks == (["stood", "self", "stood", "impulse"] if push else ["stood", "self"])


@marked
def test_a_link_with_a_knock_sets_its_size(page):
    page.evaluate("location.hash = '#robot=nxtway-gs&controller=lqg&push=impulse:0.3'")
    page.wait_for_function("document.querySelector('[data-key=knock]').value === '0.3'")


@marked
def test_every_controller_of_every_robot_stands_up_again_from_a_lean(page):
    """A lean of 0.05 rad; the one of the true state alone cannot bear TWIPR's dead time of 53 ms, as in Python."""
    fell: list[str] = []
    send(page, kind="Play", paused=True, speed=1)
    for robot in ROBOTS:
        for name in page.evaluate(f"Object.keys(upright.exported.laws['{robot}'])"):
            page.evaluate(f"upright.store.change({{ robot: '{robot}', controller: '{name}', gains: [] }})")
            send(page, kind="StandUp", pitch=0.05)
            send(page, kind="Step", periods=400)
            fell += [f"{robot} {name}"] if page.evaluate("upright.store.snapshot.x[0][8]") else []
    assert fell == ["twipr lqr-state"]


@marked
def test_it_is_pushed_by_mouse_key_and_button(page):
    at = page.evaluate("upright.page.grasp()")
    box = page.locator(".room").bounding_box()
    page.mouse.move(box["x"] + at["x"], box["y"] + at["y"])
    page.mouse.down()
    page.mouse.move(box["x"] + at["x"] + 60, box["y"] + at["y"], steps=4)
    page.wait_for_function("upright.store.snapshot.f[0] > 0.05")
    page.mouse.up()
    page.wait_for_function("upright.store.snapshot.f[0] === 0")
    said, link = page.evaluate("[upright.store.last.kept, upright.page.address()]")
    assert ("push=impulse:" in link) == (said == "knockPush")  # a short push goes as a knock, a long one not at all
    assert said in ("knockPush", "heldPush")
    page.keyboard.down("b")
    page.wait_for_function("upright.store.snapshot.f[0] > 0.05")
    page.keyboard.up("b")
    page.click("[data-key=stand]")
    stood = page.evaluate("upright.store.snapshot.t")
    page.click("[data-key=impulse]")
    page.wait_for_function(LEANT.format(stood))  # a knock forward at its middle


@marked
def test_two_knocks_are_no_record_and_one_has_the_size_of_the_slider(page):
    send(page, kind="Play", paused=True, speed=1)
    page.fill("[data-key=knock]", "0.2")
    for count, record in ((2, ""), (1, "best knock 0.2 N s")):
        send(page, kind="StandUp", pitch=0)
        for _ in range(count):
            page.click("[data-key=impulse]")
            send(page, kind="Step", periods=70)  # it stands, and moves on
        send(page, kind="Step", periods=400)
        assert page.inner_text(".most").replace("\N{NO-BREAK SPACE}", " ") == record
        assert ("not from a single push" in page.inner_text(".fell")) == (count == 2)


@marked
@pytest.mark.parametrize(
    ("setup", "lean"),
    [
        ({"robot": "nxtway-gs", "controller": "lqg"}, 0.05),
        ({"robot": "nxtway-gs", "controller": "gains", "noise": 3, "delay": 0.01, "slope": 0.02}, 0.0),
        ({"robot": "twipr", "controller": "hinf", "seed": 5}, 0.05),
        ({"robot": "nxtway-gs", "controller": "lqi", "payload": 0.3, "payload_height": 0.3}, 0.0),
    ],
)
def test_what_a_student_hands_in_is_run_again(page, tmp_path, setup, lean):
    """Noise and all: the page counts its random numbers, and the rerun counts the same. Two digits of the peak are the
    grades' tolerance; a part in ten thousand is what differences in the last bit have become after 5 s, and more."""
    send(page, kind="Play", paused=True, speed=1)
    page.evaluate("(setup) => upright.store.change({ gains: [], ...setup })", setup)
    page.select_option("[data-key=language]", "en")
    page.click("#tab-Keep")
    page.fill("[data-key=student]", "José Ñandú")
    page.click("[data-key=keep-handin]")
    assert "press Stand up" in page.locator(".toast.error").inner_text()  # nothing to hand in yet
    send(page, kind="Step", periods=20)
    send(page, kind="Steer", speed=0.05, rate=0.1)
    send(page, kind="StandUp", pitch=lean)
    for periods, action in (
        (50, {"kind": "Strike", "what": "impulse", "size": 0.05}),
        (100, {"kind": "Drag", "force": 0.2, "height": 0.1}),
        (40, {"kind": "Drag", "force": 0, "height": 0.1}),
        (10, {"kind": "Strike", "what": "pull_left", "size": 0.3}),
    ):
        send(page, kind="Step", periods=periods)
        send(page, **action)
    send(page, kind="Step", periods=300)
    with page.expect_download() as saved:
        page.click("[data-key=keep-handin]")
    saved.value.save_as(tmp_path / "hand-in.json")
    done = read_hand_in(tmp_path / "hand-in.json")
    assert done.sealed
    assert done.student == "José Ñandú"
    assert [type(action).__name__ for _, action in done.actions] == ["Steer", "Strike", "Drag", "Drag", "Strike"]
    replayed = rerun(done)
    assert (replayed.fell, replayed.seconds, replayed.best) == (False, done.claimed.seconds, done.claimed.best)
    assert (replayed.peak, replayed.travel) == pytest.approx((done.claimed.peak, done.claimed.travel), rel=1e-4)
    assert grade_file(tmp_path / "hand-in.json").verdict == "ok"


@marked
def test_the_traces_are_kept_as_a_log_that_upright_reads(page, tmp_path):
    send(page, kind="Play", paused=True, speed=1)
    send(page, kind="StandUp", pitch=0.05)
    send(page, kind="Step", periods=100)
    page.click("#tab-Keep")
    with page.expect_download() as saved:
        page.click("[data-key=keep-csv]")
    saved.value.save_as(tmp_path / "run.csv")
    log = Log.load(tmp_path / "run.csv")
    assert log["truth/pitch"][-1] == page.evaluate("upright.store.snapshot.x[0][0]")
    assert log.t[-1] == page.evaluate("upright.store.snapshot.t")
    assert (log.units["truth/yaw_rate"], log.units["applied/left"]) == ("rad/s", "V")


@marked
def test_what_this_page_lacks_is_said_where_it_is_looked_for(page):
    """In one plain sentence each: strictness under Controller, report and replay under Keep."""
    page.click("#tab-Controller")
    assert "To change something here, choose Gains by hand." in page.inner_text("#panel")
    page.click("#tab-Keep")
    assert "A report and a replay page need Python" in page.inner_text("#panel")


@marked
def test_a_link_that_is_opened_in_slow_motion_runs_at_full_speed(page):
    page.select_option("[data-key=speed]", "0.1")
    page.evaluate("location.hash = '#robot=nxtway-gs&controller=lqr&push=impulse:0.05'")
    page.wait_for_function("upright.store.setup.controller === 'lqr'")
    assert page.input_value("[data-key=speed]") == "1"
    page.wait_for_function(LEANT.format(0))  # its push comes after a second


EXCITED = "upright example excited -o run.csv"
DRIVEN = (
    "upright simulate -r twipr -b twin -c lqg --start pitch=0.1 --drive 0.5,start=1,until=4 --turn 1,start=2,until=5 "
    "-s 6 -o run.csv"  # 0.5 m/s: 8 rad/s of wheels of 63 mm
)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in preset_names() if name != "nxtway-gs"])
def test_the_log_of_the_recipe_is_one_to_calibrate_from(tmp_path, name):
    """Its robot stands all the time, and moves by more than the steps of its gyro."""
    speed = f"{8 * Robot.preset(name).wheel_radius:.2g}"
    command = DRIVEN.replace("twipr", name).replace("0.5,", f"{speed},").replace("run.csv", str(tmp_path / "run.csv"))
    assert main(shlex.split(command)[1:]) == 0
    log = Log.load(tmp_path / "run.csv")
    assert log.t[-1] > 5.9
    robot = Robot.preset(name)
    problem, _ = prepared([log], robot, find_kit(robot.kit), (), 0.25)
    assert too_quiet(problem) == ""


@marked
def test_what_needs_python_says_so_with_its_command(page):
    for language in ("en", "es"):
        page.select_option("[data-key=language]", language)
        page.click("#tab-Python")
        commands = page.locator(".commands code").all_inner_texts()
        assert "upright calibrate run.csv --robot nxtway-gs" in commands
        for robot, first in (("twipr", DRIVEN), ("nxtway-gs", EXCITED)):
            page.evaluate("(robot) => upright.store.change({ robot })", robot)
            page.click("#tab-Python")
            commands = page.locator(".commands code").all_inner_texts()
            assert commands[0] == first  # a log that moves enough for an inertia, of this robot
            for line in commands:
                name, *arguments = shlex.split(line)[1:]
                group().commands[name].make_context(name, arguments)  # raises where it is no such call


@pytest.mark.parametrize("scheme", ["light", "dark"])
@marked
def test_axe_core_finds_nothing_serious_in_any_tab(browser, site, axe, scheme):
    page = browser.new_page(color_scheme=scheme)
    page.goto(site.as_uri())
    page.wait_for_function("window.upright?.page.drawnFirst")
    page.add_script_tag(path=str(axe))
    serious: list[str] = []
    for tab in ("Controller", "Robot", "See", "Python"):
        page.click(f"#tab-{tab}")
        for rule in page.evaluate("axe.run().then((result) => result.violations)"):
            if rule["impact"] in ("serious", "critical"):
                serious += [f"{tab}: {rule['id']}: {node['html'][:200]}" for node in rule["nodes"]]
    page.close()
    assert not serious


# Bad input


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
    export(tmp_path, ["nxtway-gs", "twipr"], ["lqg", "lqr"], say=said.append, progress=done.append)
    assert [line.partition(":")[0] for line in said] == ["nxtway-gs", "twipr"]  # while it takes its time
    assert done == [0, 0.25, 0.5, 0.75]  # before each of two methods of each of two robots
    export(tmp_path, ["nxtway-gs"], ["lqr"], say=said.append)  # an exported lab may be written again
    assert sorted(path.name for path in tmp_path.iterdir()) == ["index.html", "notes.txt"]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("--export", "{}/page.html"), "names a page"),
        (("--export", "{}/file"), "is no folder"),
        (("--export", "{}/site", "-r", "nobody"), "nobody"),
        (("--export", "{}/site", "-c", "nothing"), "nothing"),
        (("--export", "{}/site", "-r", "twipr", "-r", "twipr"), "two robots are called twipr"),
        (("--export", "{}/site", "-r", "twipr", "-c", "lqr-complementary"), "no controller"),
        (("--export", "{}/site", "--class"), "--export with --class"),
        (("-r", "twipr"), "--robot without --export"),
    ],
)
def test_what_cannot_be_exported_is_refused_in_a_line(tmp_path, capsys, arguments, words):
    (tmp_path / "file").write_text("", "utf-8")
    assert main(["lab", *(a.format(tmp_path) for a in arguments)]) == 2
    assert words in capsys.readouterr().err.strip().splitlines()[-1]
    assert not (tmp_path / "site").exists()
