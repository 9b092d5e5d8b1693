"""What a generated program costs on each chip: instructions, cycles and time of a period, flash and memory.

Run: python benchmarks/firmware.py [--controller NAME ...] [--robot NAME] [--kit NAME]. Each program drives the twin
through both of the paper's pushes for 20 s; the row is its most expensive period, beside 10 ms. Cycles are counted,
so that the figures do not depend on this machine: on the ARM7TDMI from the code that ran, at most what the manual
allows and with memory that never waits; on the ATmega328P by simavr. Bus and converter are in the figures of a
sketch, not in those of C. The NXT runs NXC as bytecode: the instructions are those of its virtual machine, and the
time an estimate, at `COST` each.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import harness

from planted.measured_arm import CLOCK, MeasuredArm
from upright.bricks.virtual_robot import COST
from upright.control import CONTROLLERS, make_controller
from upright.errors import UprightError
from upright.execution import execute_avr, executed_parity
from upright.execution.execute import execute
from upright.firmware import generate
from upright.robots import Kit, Robot

ROWS = (
    ("c", "float", "arm7"), ("c", "fixed", "arm7"), ("c", "double", "arm7"), ("c", "float", "avr"),
    ("c", "fixed", "avr"), ("arduino", "float", "avr"), ("arduino", "fixed", "avr"), ("nxc", "float", "nxt"),
)  # fmt: skip


def main() -> None:
    names = ("lqr", "lqi", "lqg", "pid", "hinf", "robust", "sliding")
    options = harness.options(__doc__, controller=names, robot="nxtway-gs", kit="nxt")
    assert set(options.controller) <= set(CONTROLLERS)
    robot, kit = Robot.preset(options.robot), Kit.preset(options.kit)
    print(f"{robot.name} with kit {kit.name}, controllers every {kit.period * 1e3:g} ms")
    print(f"{'controller':<11}{'target':<9}{'number':<8}{'chip':<6}{'products':>9}{'instructions':>14}{'cycles':>9}{'time':>10}"
          f"{'of period':>11}{'flash':>8}{'RAM':>6}  parity")  # fmt: skip
    for name in options.controller:
        for target, number, chip in ROWS:
            print(row(name, robot, kit, target, number, chip), flush=True)


def row(name: str, robot: Robot, kit: Kit, target: str, number: str, chip: str) -> str:
    """One line of the table, or why there is none."""
    head = f"{name:<11}{target:<9}{number:<8}{chip:<6}"
    try:
        controller = make_controller(name, robot, kit, kit.period)
        made = generate(controller, robot, kit, target, number=number)
        with tempfile.TemporaryDirectory() as folder:
            source = made.write(Path(folder) / f"balance{next(iter(made.files))}")[0]
            make: Any = MeasuredArm if chip == "arm7" else partial(execute, chip=chip)
            executor = make(source, made.program, number)
            found = executed_parity(executor, controller, made, robot, kit)
            cost = COSTS[chip](executor, kit.period)
            executor.close()
    except UprightError as error:
        return f"{head}  {str(error)[:90]}"
    said = f"{found.worst:.1e} of {found.tolerance:.1e} {found.unit}" if found.passed else "NOT EQUAL"
    return f"{head}{made.program.operations():>9}{cost}  {said}"


def on_arm(executor: Any, period: float) -> str:
    cost, time = executor.worst, executor.worst.cycles / CLOCK
    counts = f"{cost.instructions:>14}{cost.cycles:>9}"
    return f"{counts}{time * 1e3:>7.3f} ms{time / period:>11.1%}{executor.code_bytes:>8}{'':>6}"


def on_avr(executor: Any, period: float) -> str:
    time = executor.worst / execute_avr.CLOCK
    sizes = f"{executor.code_bytes:>8}{executor.memory_bytes:>6}"
    return f"{'':>14}{executor.worst:>9}{time * 1e3:>7.3f} ms{time / period:>11.1%}{sizes}"


def on_nxt(executor: Any, period: float) -> str:
    time = executor.instructions * COST * 1e-6
    return f"{executor.instructions:>14}{'':>9}{time * 1e3:>6.1f}~ms{time / period:>11.0%}{'':>8}{'':>6}"


COSTS: dict[str, Callable[[Any, float], str]] = {"arm7": on_arm, "avr": on_avr, "nxt": on_nxt}

if __name__ == "__main__":
    main()
