"""Whether the kernel, the loop of `run` and the printed C in double precision are one: every preset, four controllers.

    python benchmarks/one_text.py [--runs 100] [--robot nxtway-gs] [--controllers lqg mpc]
    python benchmarks/one_text.py --noise --runs 1000 --robot twipr --controllers lqi    # each run with its own seed

With `--noise` only the falls are compared, under the kit's own noise; else noise is off. First figures: the largest
difference of any state under a push, without quanta over 10 s, with them over 2 s (rounding that falls to the other
side parts runs after that), and how fast any difference grows while quantised readings do not see it. Then `--runs`
runs with all quanta under pushes up to what throws the robot: in how many the kernel and the loop say alike whether it
fell.
"""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import harness
import numpy as np

from upright.bodies import Electronics, NonlinearBody
from upright.compiled.print_c import CPrinter
from upright.compiled.program import Kind
from upright.control import make_controller
from upright.control.controller import Controller
from upright.control.law import as_law, near_rest, program
from upright.errors import UprightError
from upright.experiment import Push, run
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.loops.loop import Loop, robot_loop
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot, preset_names
from upright.signals import STATE_NAMES

CONTROLLERS = ("lqg", "hinf", "sliding", "mpc")
CHANNELS = tuple(f"truth/{name}" for name in STATE_NAMES)
STARTS, LASTS = 0.3, 0.1  # [s] when a push begins, and how long it lasts
SMALL, THROWN = 0.05, 1.2  # [m/s] of the body by a push: one that any controller survives, and one that throws


def still(kit: Kit, *, quanta: bool) -> Kit:
    """The kit without what is random; without `quanta` neither steps nor dead zone."""
    none = {"noise": 0.0, "bias": 0.0, "bias_walk": 0.0} | ({} if quanta else {"quantum": 0.0})
    sensors = {name: replace(sensor, **none) for name, sensor in kit.sensors.items()}
    motor = kit.motor if quanta else replace(kit.motor, quantum=0.0, dead_zone=0.0)
    return replace(kit, sensors=sensors, motor=motor, jitter=0.0)


class InC:
    """A controller whose printed C decides, in place of the one it is printed from."""

    def __init__(self, controller: Controller, folder: Path) -> None:
        text = program(as_law(controller))
        c = CPrinter(text, "double")
        lines = [c.helpers()]
        for name, kind in (("in", Kind.INPUT), ("s", Kind.STATE), ("out", Kind.OUTPUT)):
            lines.append(f"struct {name} {{ {' '.join(c.fields(kind))} char none; }};")
        for block in (text.command, text.update):
            lines.append(f"void {block.name}(struct s *s, const struct in *in, struct out *out)")
            lines += ["{", *c.lines(block), "}"]
        source = folder / f"{id(self)}.c"
        source.write_text("\n".join(lines), "utf-8")
        flags = ["-O1", "-ffp-contract=off", "-shared", "-fPIC"]  # a sum and its product are rounded one by one
        subprocess.run(["gcc", *flags, str(source), "-o", str(source.with_suffix(".so"))], check=True)
        self.spec, self._library = controller.spec, ctypes.CDLL(str(source.with_suffix(".so")))
        self._inputs, outputs = [v.name for v in text.of(Kind.INPUT)], [v.name for v in text.of(Kind.OUTPUT)]
        self._out, self._sides = (ctypes.c_double * len(outputs))(), [outputs.index(f"command_{s}") for s in SIDES]
        self._starts = [v.start for v in text.of(Kind.STATE)] + [0.0] * (len(text.carried()) + 1)
        self._channels, self._design = text.channels, controller

    def reset(self) -> None:
        self._design.reset()
        self._state, self._given = (ctypes.c_double * len(self._starts))(*self._starts), {}

    def step(self, measurement: Sequence[float], reference: Sequence[float]) -> tuple[float, float]:
        y = dict(zip(self.spec.reads, measurement, strict=True))
        self._given = {name: y[channel] for name, channel in self._channels.items()}
        self._given |= {f"reference_{name}": value for name, value in zip(STATE_NAMES, reference, strict=True)}
        self._call("command")
        return self._out[self._sides[0]], self._out[self._sides[1]]

    def applied(self, command: Sequence[float]) -> None:
        self._given |= {f"applied_{side}": value for side, value in zip(SIDES, command, strict=True)}
        self._call("update")

    def estimate(self) -> Sequence[float]:
        return self._design.estimate()  # which stays as it began

    def to_json(self) -> dict[str, object]:
        return {"kind": self.spec.kind}

    def _call(self, block: str) -> None:
        numbers = (ctypes.c_double * len(self._inputs))(*(self._given.get(name, 0.0) for name in self._inputs))
        self._library[block](self._state, numbers, self._out)


SIDES = ("left", "right")


def push_of(robot: Robot, speed: float) -> Push:
    return Push(force=robot.body_mass * speed / LASTS, start=STARTS, duration=LASTS)


def largest(robot: Robot, kit: Kit, controller: Controller, seconds: float, folder: Path) -> list[float]:
    """Largest difference of a state between the loop and the kernel, and between the loop and C in the loop."""
    push, body = push_of(robot, SMALL), Electronics(NonlinearBody(robot), kit)
    logs = [run(body, one, push, seconds=seconds) for one in (controller, InC(controller, folder))]
    loop, c = (np.column_stack([log[name] for name in CHANNELS]) for log in logs)
    rows = np.array([[[push.force, np.nan, STARTS, LASTS]]])
    batch = FleetBatch(parameters=parameters_of(robot), controller=controller, kit=kit, pushes=rows)
    kernel = simulate(batch, seconds, record=1, channels=CHANNELS).trace[0, : len(loop)]
    same = min(len(loop), len(c))
    return [float(np.abs(loop - kernel).max()), float(np.abs(loop[:same] - c[:same]).max())]


def growth(robot: Robot, kit: Kit, controller: Controller) -> float:
    """How fast [1/s] a difference grows near rest while quantised readings stay the same: they count as cut off."""
    loop, linear = robot_loop(controller, robot, kit), near_rest(controller)
    K, fine = loop.controller, np.diag([float(kit.sensors[name].quantum == 0) for name in linear.reads])
    poles = Loop(loop.plant, LinearModel(K.A, K.B @ fine, K.C, K.D @ fine, K.dt)).closed.poles()
    return float(np.log(np.abs(poles).max()) / K.dt)


def alike(robot: Robot, kit: Kit, controller: Controller, runs: int, seconds: float) -> tuple[int, int]:
    """In how many runs kernel and loop say alike whether it fell, and in how many it did."""
    speeds = np.linspace(-THROWN, THROWN, runs)
    rows = np.array([[[push_of(robot, v).force, np.nan, STARTS, LASTS]] for v in speeds])
    batch = FleetBatch(parameters=parameters_of(robot), controller=controller, kit=kit, pushes=rows)
    kernel, body = simulate(batch, seconds).fell, Electronics(NonlinearBody(robot), kit)
    logs = (run(body, controller, push_of(robot, float(v)), seconds=seconds) for v in speeds)
    loop = np.array([bool(log.origin["outcome"]["fell"]) for log in logs])
    return int((kernel == loop).sum()), int(loop.sum())


def noisy(robot: Robot, kit: Kit, controller: Controller, runs: int, seconds: float) -> None:
    """Prints how often kernel and loop say alike whether it fell under noise, and where they do not."""
    speeds = np.random.default_rng(0).permutation(np.linspace(0.0, THROWN, runs))  # so that any part has all sizes
    body, clock, fallen, apart = Electronics(NonlinearBody(robot), kit), harness.Clock(), 0, list[str]()
    for seed, speed in enumerate(speeds):
        push = push_of(robot, float(speed))
        log = run(body, controller, push, seconds=seconds, seed=seed)
        rows = [[push.force, np.nan, STARTS, LASTS]]
        batch = FleetBatch(parameters=parameters_of(robot), controller=controller, kit=kit, pushes=rows, seed=seed)
        loop, kernel = bool(log.origin["outcome"]["fell"]), bool(simulate(batch, seconds).fell[0])
        fallen += loop
        if loop != kernel:
            apart.append(f"seed {seed}, {speed:.4f} m/s: the loop {'falls' if loop else 'stands'}")
        if (seed + 1) % 100 == 0 or seed + 1 == runs:
            same = harness.share(seed + 1 - len(apart), seed + 1)
            print(f"{robot.name} {controller.spec.kind}: alike {same}, {fallen} fell; {clock} {apart}", flush=True)


def main() -> None:
    options = harness.options(__doc__, runs=100, robot="", controllers=CONTROLLERS, noise=False)
    if options.noise:
        for name in [options.robot] if options.robot else preset_names():
            robot = Robot.preset(name)
            kit = Kit.preset(robot.kit_name)
            for family in options.controllers:
                noisy(robot, kit, make_controller(family, robot, kit, kit.period), options.runs, 2.0)
        return
    print(f"{'':34}{'no quanta, 10 s':>24}{'quanta, 2 s':>24}{'grows by':>12}{'fell alike':>16}")
    print(f"{'':34}{'kernel':>12}{'C':>12}{'kernel':>12}{'C':>12}{'1/s':>12}")
    for name in [options.robot] if options.robot else preset_names():
        robot = Robot.preset(name)
        kit = Kit.preset(robot.kit_name)
        for family in options.controllers:
            clock = harness.Clock()
            try:
                controller = make_controller(family, robot, kit, kit.period)
            except UprightError as error:
                print(f"{name:22}{family:12}{error}")
                continue
            with tempfile.TemporaryDirectory() as folder:
                cases = ((still(kit, quanta=False), 10.0), (still(kit, quanta=True), 2.0))
                found = [d for k, s in cases for d in largest(robot, k, controller, s, Path(folder))]
            same, fell = alike(robot, still(kit, quanta=True), controller, options.runs, 2.0)
            numbers = "".join(f"{d:12.1e}" for d in found)
            rate = growth(robot, kit, controller)
            print(f"{name:22}{family:12}{numbers}{rate:12.1f}   {same} of {options.runs} ({fell} fell)", end="")
            print(f"  {clock.cpu:.0f} s", flush=True)


if __name__ == "__main__":
    main()
