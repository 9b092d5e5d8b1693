"""What counts as a fall is the generated program's own stop, in every simulation."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.control import lqg, lqr_state
from upright.execution.executed import Readings, calibrated
from upright.execution.executor import HostExecutor
from upright.experiment import Impulse, outcome_of, run
from upright.firmware import generate
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot
from upright.robots.uncertainty import draw

TWIPR, KIT = Robot.preset("twipr"), Kit.preset("twipr")
KNOCK = Impulse(impulse=0.9, start=1.0, duration=0.02)  # [N s] leans some of the drawn robots beyond 0.8 rad, some not


def program_ends(executor: HostExecutor, readings: Readings, robot: Robot, seed: int) -> bool:
    """Whether the robot lies within 2 s after the knock, under a program that stops its motors by itself."""
    body = Electronics(NonlinearBody(robot), KIT)
    now, names = body.reset(seed=seed), [signal.name for signal in body.spec.channels]
    calibrated(executor, readings, KIT.period)
    status = 0
    for _ in range(round(3.0 / KIT.period)):
        out = executor.step(readings.raw(dict(zip(names, now.numbers, strict=True)), readings.offset))
        status = status or int(out["status"])
        command = (0.0, 0.0) if status else (out["applied_left"], out["applied_right"])
        for _ in range(round(KIT.period / body.spec.period)):
            now = body.step(command, KNOCK.at(now.t, robot))
        if now.fallen:
            return True
    return False


@pytest.mark.needs("gcc")
def test_who_falls_is_who_falls_under_the_generated_program(tmp_path: Path) -> None:
    """C on drawn bodies against the kernel, which certificates, fleets and push maps count with. The program stops at
    the pitch that it estimates, the kernel at the true one, and both draw other noise: a few of 12 lie between.
    Were they not the same robots that fall, 2 or fewer would differ in 2 % of cases (binomial, 12 of 1/2)."""
    controller = lqg(TWIPR, KIT)
    made = generate(controller, TWIPR, KIT, "c", number="double")
    executor = HostExecutor(made.write(tmp_path / "balance.c")[0], made.program, "double")
    robots = draw(TWIPR, 12, seed=5)
    readings = Readings(made.program, KIT, "double")
    ends = np.array([program_ends(executor, readings, robot, k) for k, robot in enumerate(robots)])
    executor.close()
    pushes = [[KNOCK.impulse / KNOCK.duration, math.nan, KNOCK.start, KNOCK.duration]]
    batch = FleetBatch(parameters=parameters_of(robots), controller=controller, kit=KIT, pushes=pushes)
    result = simulate(batch, 3.0)
    assert 2 < ends.sum() < 10  # the knock parts them
    assert (ends != result.fell).sum() <= 2


def test_a_run_ends_its_commands_at_the_stop_and_its_log_on_the_floor() -> None:
    """0.8 rad is where every program says 1, fallen (docs/firmware.md): what it commands after it is nothing."""
    push = Impulse(impulse=3.0, start=0.1, duration=0.02)
    log = run(Electronics(NonlinearBody(TWIPR), KIT), lqg(TWIPR, KIT), push, seconds=5.0)
    outcome, lean = outcome_of(log), np.abs(log["truth/pitch"])
    after = log.t > outcome.seconds - 1e-9
    assert outcome.fell
    assert lean[~after].max() <= 0.8 < lean[after].min()
    assert np.abs(log["command/left"][~after]).max() > 0
    assert not log["command/left"][after].any()
    assert lean[-1] > 1.2  # its last row before 1.4 rad, where the frame lies


def test_who_starts_beyond_the_stop_has_fallen_in_run_and_kernel() -> None:
    # twipr's motors are ten times stronger than its weight (docs/extend.md): without a stop it comes back
    start = (0.85, 0, 0, 0, 0, 0)
    controller = lqr_state(TWIPR, KIT.period)
    log = run(NonlinearBody(TWIPR), controller, seconds=2.0, start=start)
    result = simulate(FleetBatch(parameters=parameters_of(TWIPR), controller=controller, start=start), 2.0)
    assert outcome_of(log).fell
    assert result.fell[0]
    assert not log["command/left"].any()
