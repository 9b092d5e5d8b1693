"""A sensor effect is one formula: a gyro that counts too much, in the twin, the kernel, the predictor and a program."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from interpreter import Interpreter, evaluate
from upright.bodies import Electronics, NonlinearBody
from upright.calibration.filter_log import filter_log
from upright.compiled.electronics import formulas
from upright.control import make_controller
from upright.experiment import Drive, run
from upright.firmware.generate import trace
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot

ROBOT, NXT, GYRO = Robot.preset("nxtway-gs"), Kit.preset("nxt"), "sensor/gyro"
GAIN = 1.2  # far beyond what a gyro's data sheet allows, so that nothing else explains it


def counting(gain: float, **changes: float) -> Kit:
    """The kit whose gyro reads `gain` times what turns it."""
    return replace(NXT, sensors=NXT.sensors | {GYRO: replace(NXT.sensors[GYRO], gain=gain, **changes)})


def still(kit: Kit) -> Kit:
    """Without noise, and with no step or dead zone in which rounding would grow."""
    faults = {"noise": 0.0, "bias": 0.0, "bias_walk": 0.0, "quantum": 0.0}
    sensors = {name: replace(sensor, **faults) for name, sensor in kit.sensors.items()}
    return replace(kit, jitter=0.0, sensors=sensors, motor=replace(kit.motor, quantum=0.0, dead_zone=0.0))


@pytest.mark.parametrize("name", ["drive", "turn", "slacken", "settle", "swing", "fuse", "measure"])
def test_the_printed_formulas_are_their_statements(name: str) -> None:
    """Python's text of each formula, and its statements one by one: the same bits."""
    formula, rng = formulas()[name], np.random.default_rng(1)
    for given in rng.uniform(0.01, 2.0, (20, len(formula.inputs))) * rng.choice([-1.0, 1.0], (20, 1)):
        values = dict(zip(formula.inputs, given.tolist(), strict=True))
        for step in formula.block.steps:
            values[step.target] = evaluate(step, values)
        assert formula.function()(*given.tolist()) == tuple(values[value] for _, value in formula.block.commit)


def test_the_twin_s_gyro_counts_too_much() -> None:
    body = Electronics(NonlinearBody(ROBOT), still(counting(GAIN)))
    names = [signal.name for signal in body.spec.channels]
    body.reset((0.0, 0.5, 0.0, 0.0, 0.0, 0.0))
    for _ in range(20):
        values = dict(zip(names, body.step((1.0, 1.0)).values.tolist(), strict=True))
    assert values[GYRO] == pytest.approx(GAIN * values["truth/pitch_rate"], rel=1e-12)  # of one product


def test_the_kernel_reads_the_same() -> None:
    kit, start = still(counting(GAIN)), (0.05, 0.0, 0.0, 0.0, 0.0, 0.0)
    lqg = make_controller("lqg", ROBOT, kit, kit.period)
    log = run(Electronics(NonlinearBody(ROBOT), kit), lqg, seconds=1.0, start=start)
    batch = FleetBatch(parameters=parameters_of(ROBOT), controller=lqg, start=start, kit=kit)
    result = simulate(batch, 1.0, record=1, channels=(GYRO, "truth/pitch"))
    for k, name in enumerate(result.channels):
        assert np.abs(log[name] - result.trace[0, : len(log), k]).max() < 1e-9  # the kernel's bar
    changed = FleetBatch(parameters=parameters_of(ROBOT), controller=lqg, start=start, kit=still(NXT),
                         kit_changes={"sensors.gyro.gain": [1.0, GAIN]})  # fmt: skip
    assert np.array_equal(simulate(changed, 1.0).final[1], result.final[0])  # a fleet varies it like any number


def test_the_predictor_explains_a_log_where_it_knows_the_gyro() -> None:
    kit = counting(GAIN)
    lqg = make_controller("lqg", ROBOT, kit, kit.period)
    drive = Drive(speed=0.2, start=0.5, until=1.5)
    log = run(Electronics(NonlinearBody(ROBOT), kit), lqg, reference=drive, seconds=3.0, seed=1)

    def misfit(known: Kit) -> float:
        path = filter_log(log, ROBOT, known, delay=0.0, disturbance=0.01)
        gyro = path.row == path.rows.index(GYRO)
        return float(np.mean(path.innovation[gyro] ** 2 / path.variance[gyro]))

    assert misfit(kit) < 2  # 1 of 300 white readings, give or take 0.1
    assert misfit(NXT) > 2 * misfit(kit)


def test_a_program_commands_the_same_from_a_gyro_that_counts_in_another_unit() -> None:
    """Counts, and noise with them, larger by one factor: the same measurement, so the same command."""
    known, sizes = NXT.sensors[GYRO], ("noise", "quantum", "bias", "bias_walk")
    walk = {"bias_walk": 0.01}  # above the design's own figure, so that the kit's counts
    kits = [counting(g, **{n: g * ({**vars(known), **walk})[n] for n in sizes}) for g in (1.0, GAIN)]
    commands = []
    for kit, factor in zip(kits, (1.0, GAIN), strict=True):
        program = trace(make_controller("lqg", ROBOT, kit, kit.period), ROBOT, kit, "c")
        machine, rng, sent = Interpreter(program), np.random.default_rng(1), []
        scale = {name: factor if "gyro" in name else 1.0 for name in program.channels}
        rest = {name: 9.0 if "battery" in name else 0.0 for name in program.channels}
        for _ in range(101):
            machine.calibrate(rest)
        for _ in range(50):
            raw = {name: rest[name] + scale[name] * 0.02 * rng.standard_normal() for name in rest}
            sent.append(machine.command(raw)["command_left"])
            machine.update()
        commands.append(sent)
    assert np.std(commands[0]) > 0.1  # [V] it acts
    assert commands[1] == pytest.approx(commands[0], rel=1e-6)  # two Riccati equations, solved to 1e-8
