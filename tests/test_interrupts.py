"""An interrupted run ends at once, with 128 and the signal's number, and leaves nothing, whatever computes."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from conftest import PATIENCE
from planted.abuse import interrupts as abuse
from upright import interrupts
from upright.cli.main import main
from upright.control import make_controller
from upright.kernel.batch import FleetBatch, idle, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot

SLEEPS = {
    "Python": "time.sleep(600)",
    "C that lets other threads run": "import ctypes; ctypes.CDLL(None).sleep(600)",
    "a handler that swallows": """
while True:
    try:
        time.sleep(600)
    except BaseException:
        pass
""",
    "a callback from C, whose exceptions are lost": """
import ctypes
def called(a, b):
    time.sleep(600)
    return 0
made = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(called)
ctypes.CDLL(None).qsort(ctypes.create_string_buffer(16), 2, 8, made)
""",
    "a finalizer, whose exceptions are lost": """
class Held:
    def __del__(self):
        ready()
        time.sleep(600)
held = Held()
del held
time.sleep(600)
""",
    "a pool of threads": """
from concurrent.futures import ThreadPoolExecutor
with ThreadPoolExecutor(2) as pool:
    list(pool.map(time.sleep, [600] * 4))
""",
    "what waits for threads at the end": """
import threading
threading.Thread(target=time.sleep, args=(600,)).start()
time.sleep(600)
""",
}


def child(body: str, folder: Path, before: str = "") -> subprocess.Popen[str]:
    """A process that has a file under way and a temporary folder, and then does `body`."""
    text = f"""
import sys, time
{before}
from upright import interrupts
from upright.atomic import TemporaryFolder, together, write_text
interrupts.watch()
folder = TemporaryFolder()
code = interrupts.exit_code()
def ready():
    print("ready", flush=True)
def run():
    with together():
        write_text("result.txt", "result")
        {"" if "ready()" in body else "ready()"}
{"".join(f"        {line}{chr(10)}" for line in body.strip().splitlines())}
try:
    run()
    code = 0
except KeyboardInterrupt:
    code = interrupts.exit_code()
interrupts.leave(code)
"""
    process = subprocess.Popen(
        [sys.executable, "-c", text], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env=os.environ | {"TMPDIR": "."},
    )  # fmt: skip
    assert process.stdout
    assert process.stdout.readline() == "ready\n"
    return process


SENT = dict.fromkeys(SLEEPS, signal.SIGINT) | {"Python": signal.SIGTERM, "a pool of threads": signal.SIGHUP}
"""What a run does, and the signal that ends it: one handler and one thread take them all."""


@pytest.mark.parametrize("name", SLEEPS)
def test_a_run_ends_whatever_it_does_and_leaves_nothing(name: str, tmp_path: Path) -> None:
    process, number = child(SLEEPS[name], tmp_path), SENT[name]
    process.send_signal(number)
    said = process.communicate(timeout=PATIENCE)[1]
    assert process.returncode == 128 + number
    assert list(tmp_path.iterdir()) == []
    assert said in ("", interrupts.STOPPED)  # no traceback


def test_a_run_that_swallows_the_signal_and_ends_still_writes_nothing(tmp_path: Path) -> None:
    process = child("try:\n    time.sleep(600)\nexcept BaseException:\n    pass", tmp_path)
    process.send_signal(signal.SIGINT)
    assert process.wait(PATIENCE) == 130
    assert list(tmp_path.iterdir()) == []


STOPPABLE = """
from upright.fleets.unfinished import stoppable
try:
    with interrupts.keeping(lambda: None), stoppable(lambda: "half"):
        ready()
        time.sleep(600)
except interrupts.Stopped as stopped:
    print(stopped.result, flush=True)
    time.sleep(0.8)  # longer than the grace
"""


def test_what_keeps_a_part_of_its_result_is_left_the_time_to_write_it(tmp_path: Path) -> None:
    process = child(STOPPABLE, tmp_path)
    process.send_signal(signal.SIGINT)
    assert process.communicate(timeout=PATIENCE) == ("half\n", "")
    assert [p.name for p in tmp_path.iterdir()] == ["result.txt"]


def test_a_second_signal_ends_what_keeps_a_part_of_its_result(tmp_path: Path) -> None:
    process = child(STOPPABLE.replace("0.8", "600"), tmp_path)
    process.send_signal(signal.SIGINT)
    assert process.stdout
    assert process.stdout.readline() == "half\n"
    process.send_signal(signal.SIGINT)
    assert process.wait(PATIENCE) == 130
    assert list(tmp_path.iterdir()) == []


def test_what_goes_wrong_at_the_first_signal_does_not_keep_the_second_from_ending_the_run(tmp_path: Path) -> None:
    """As where the terminal is closed; the thread that waits is the only one."""
    process = child(STOPPABLE.replace("lambda: None", "lambda: 1 / 0").replace("0.8", "600"), tmp_path)
    process.send_signal(signal.SIGINT)
    assert process.stdout
    assert process.stdout.readline() == "half\n"
    process.send_signal(signal.SIGINT)
    said = process.communicate(timeout=PATIENCE)[1]
    assert process.returncode == 130
    assert "Traceback" not in said


def test_what_the_parent_had_it_ignore_stays_ignored(tmp_path: Path) -> None:
    ignored = "import signal; signal.signal(signal.SIGHUP, signal.SIG_IGN)"  # as nohup does
    process = child("time.sleep(0.3)", tmp_path, before=ignored)
    process.send_signal(signal.SIGHUP)
    assert process.wait(PATIENCE) == 0
    assert [p.name for p in tmp_path.iterdir()] == ["result.txt"]


def test_a_motor_is_stopped_first(tmp_path: Path) -> None:
    body = """
with interrupts.MOTORS:
    try:
        ready()
        time.sleep(600)
    finally:
        time.sleep(0.8)  # longer than the grace
        open("stopped", "w").close()
"""
    process = child(body, tmp_path)
    process.send_signal(signal.SIGTERM)
    assert process.wait(PATIENCE) == 143
    assert [p.name for p in tmp_path.iterdir()] == ["stopped"]


SLOW_REMOVAL = """
import os
unlink = os.unlink
def slow(path, **options):
    time.sleep(0.8)
    unlink(path, **options)
os.unlink = slow
"""


def test_a_run_that_ends_while_a_file_is_removed_leaves_nothing(tmp_path: Path) -> None:
    """Removal takes longer than the grace here, so the thread that waits ends the process in the middle of it."""
    process = child("time.sleep(600)", tmp_path, before=SLOW_REMOVAL)
    process.send_signal(signal.SIGTERM)
    assert process.wait(PATIENCE) == 143
    assert list(tmp_path.iterdir()) == []


def test_a_command_that_signals_end_has_the_code_of_its_signal_too(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def follow(*_: object, **__: object) -> None:
        monkeypatch.setattr(interrupts.Run, "number", int(signal.SIGTERM))
        raise KeyboardInterrupt

    monkeypatch.setattr(import_module("upright.flight.follow"), "follow", follow)
    assert main(["monitor", "nothing"]) == 128 + signal.SIGTERM
    assert capsys.readouterr().err == interrupts.STOPPED


def test_a_controller_in_the_compiled_loop_is_interrupted() -> None:
    """Compiled code calls Python here, and an exception that is raised there does not pass."""
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    controller = make_controller("sliding", robot, kit, kit.period)
    table = parameters_of(robot)
    batch = FleetBatch(parameters=table, controller=idle(controller.spec), called=controller, start=(0.0,) * 6, kit=kit)
    kind, calls = type(controller), [0]
    step = kind.step

    def interrupted(self: Any, *given: Any) -> Any:
        calls[0] += 1
        if calls[0] == 3:
            raise KeyboardInterrupt
        return step(self, *given)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(kind, "step", interrupted)
        with pytest.raises(KeyboardInterrupt):
            simulate(batch, 0.5)
    assert calls[0] == 3


@pytest.mark.parametrize(("name", "number"), [("push-map", signal.SIGINT), ("reproduce", signal.SIGTERM)])
def test_a_long_command_is_interrupted_at_a_random_moment(name: str, number: signal.Signals) -> None:
    draw = np.random.default_rng([number, len(name)])
    end = abuse.interrupted(abuse.COMMANDS[name].split(), number, draw.uniform(0.2, 3.0))
    assert end.early or abuse.held(end, number), end


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux tells which signals a process blocks")
def test_workers_never_get_ctrl_c(tmp_path: Path) -> None:
    """A terminal sends it to all processes: a worker that is importing then would print a traceback."""
    from upright.fleets.workers import connected

    with connected(workers=1) as (worker,):
        assert blocks_ctrl_c(worker.submit(os.getpid).result())
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, ())


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux tells which signals a process blocks")
def test_processes_of_the_lab_never_get_ctrl_c() -> None:
    """Ctrl-C while `upright lab` starts printed the traceback of a stage, which was still importing."""
    from upright.lab.stage import Options
    from upright.lab.stage_process import StageProcess

    stage = StageProcess(Options(certified=False))
    try:
        assert stage._process.pid
        assert blocks_ctrl_c(stage._process.pid)
    finally:
        stage.close()


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux tells which signals a process blocks")
def test_processes_that_grade_never_get_ctrl_c(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-C in `upright grade` printed the tracebacks of processes that were importing, or waiting for a hand-in."""
    from upright.classwork import grading

    monkeypatch.setattr(grading, "grade_file", blocks_ctrl_c_here)
    with grading.new_pool(1, grading._modest) as pool:
        assert grading._begun(pool, Path("hand-in.json")).result()


def blocks_ctrl_c_here(_: Path) -> bool:
    return blocks_ctrl_c(os.getpid())


def blocks_ctrl_c(process: int) -> bool:
    blocked = re.search(r"SigBlk:\s*(\w+)", Path(f"/proc/{process}/status").read_text("utf-8"))
    assert blocked
    return bool(int(blocked[1], 16) & 1 << (signal.SIGINT - 1))
