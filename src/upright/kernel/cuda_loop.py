"""The loop of one thread of an NVIDIA card, and the traced step that it takes."""

from __future__ import annotations

import inspect
import math
from functools import cache
from typing import Any

from numba import cuda as _cuda
from numba import float64

from upright.compiled import generated_motion as motion
from upright.compiled.generated import C0 as CONSTANTS_AT
from upright.compiled.generated import CONSTANTS
from upright.kernel.cuda import MOST_READS, MOST_STATES

cuda: Any = _cuda  # Numba's stubs do not know what a kernel may call
device: Any = cuda.jit(device=True)

ROWS = CONSTANTS_AT + CONSTANTS  # numbers of one robot, as in a row of the processor's blocks
SAME_TIME = 1e-9  # [s] as in `experiment.pushes`


def fma(a: Any, b: Any, c: Any) -> Any:
    return a * b + c  # the card's compiler fuses it


def mul(a: Any, b: Any) -> Any:
    return a * b


def reciprocal(a: Any) -> Any:
    return 1.0 / a


def absolute(a: Any) -> Any:
    return math.fabs(a)


def sqrt(a: Any) -> Any:
    return math.sqrt(a)


def sincos(x: Any) -> Any:
    return math.sin(x), math.cos(x)


def get(w: Any, row: Any, lane: Any) -> Any:  # noqa: ARG001 (the processor's kernel has several)
    return w[row]


def put(w: Any, row: Any, lane: Any, value: Any) -> None:  # noqa: ARG001
    w[row] = value


def positive(a: Any) -> bool:
    return a > 0.0


ARITHMETIC = (fma, mul, reciprocal, absolute, sqrt, sincos, get, put, positive)


@cache
def traced_step(variant: str) -> Any:
    """One step of Runge and Kutta: the text of `generated_motion.step_…`, with a robot's own memory for a block."""
    words: dict[str, Any] = {function.__name__: device(function) for function in ARITHMETIC}
    words |= {"inlined": device, "sincos_any": words["sincos"]}
    inner = [getattr(motion, f"{name}_{variant}").py_func for name in ("held", "moved")]
    moves = [*inner, getattr(motion, f"step_{variant}")]
    exec("".join(inspect.getsource(move) for move in moves), words)  # our own generated module, checked by a test
    return device(words[f"step_{variant}"])


@device
def read(w: Any, reads: Any, y: Any) -> None:
    """y: states, or encoders, of the robot `w`."""
    for j in range(reads.shape[0]):
        row, side = int(reads[j, 0]), reads[j, 1]
        y[j] = w[row] if row < 6 else w[2] + side * w[CONSTANTS_AT] * w[4] - w[0]


@device
def add_product(matrix: Any, gain: int, vector: Any, out: Any) -> None:
    """out += matrix[gain] vector."""
    for i in range(matrix.shape[1]):
        for j in range(matrix.shape[2]):
            out[i] += matrix[gain, i, j] * vector[j]


@device
def disturb(w: Any, pushes: Any, push: int, floors: Any, floor: int, now: int, t: float) -> None:
    """Force, moment and slope at body step `now`, which is `t` [s]."""
    w[10], w[11] = 0.0, 0.0
    for j in range(pushes.shape[1]):
        if pushes[push, j, 2] <= now < pushes[push, j, 3]:
            w[10] += pushes[push, j, 0]
            w[11] += pushes[push, j, 1]
    angle = floors[floor, 0] if floors[floor, 1] <= t + SAME_TIME else 0.0
    w[12], w[13] = math.sin(angle), math.cos(angle)


@device
def begin(w: Any, z: Any, starts: Any, own: int, table: Any, row: int, h: float) -> None:
    """The robot as it starts: state, step, constants; the controller remembers nothing."""
    for j in range(6):
        w[j] = starts[own, j]
    for j in range(CONSTANTS):
        w[CONSTANTS_AT + j] = table[row, j]
    for j in range(MOST_STATES):
        z[j] = 0.0
    w[6], w[7] = h, 0.0


@device
def command(w: Any, u: Any, limit: float) -> float:
    """Both commands `u` within the limit, into the motors; 1 where one was cut."""
    w[8], w[9] = min(max(u[0], -limit), limit), min(max(u[1], -limit), limit)
    return 1.0 if w[8] != u[0] or w[9] != u[1] else 0.0


@cache
def kernel(variant: str) -> Any:
    """The loop of one thread: read, command, remember, push, move, count."""
    advance = traced_step(variant)

    @cuda.jit
    def loop(
        table: Any, starts: Any, pushes: Any, A: Any, By: Any, Ba: Any, C: Any, Dy: Any, reads: Any, floors: Any,
        periods: int, stride: int, substeps: int, h: float, step: float, limit: float, fallen: float, out: Any,
    ) -> None:  # fmt: skip
        robot = cuda.grid(1)
        if robot >= out.shape[0]:
            return
        w, z = cuda.local.array(ROWS, float64), cuda.local.array(MOST_STATES, float64)
        new, y, u = (
            cuda.local.array(MOST_STATES, float64),
            cuda.local.array(MOST_READS, float64),
            cuda.local.array(2, float64),
        )
        gain, push = min(robot, A.shape[0] - 1), min(robot, pushes.shape[0] - 1)
        floor = min(robot, floors.shape[0] - 1)
        begin(w, z, starts, min(robot, starts.shape[0] - 1), table, min(robot, table.shape[0] - 1), h)
        pitch, wheel, yaw, effort, cut = 0.0, 0.0, 0.0, 0.0, 0.0
        for k in range(periods):
            if w[6] == 0.0:
                break
            read(w, reads, y)
            u[0], u[1] = 0.0, 0.0
            add_product(C, gain, z, u)
            add_product(Dy, gain, y, u)
            cut += command(w, u, limit)
            u[0], u[1] = w[8], w[9]
            pitch, wheel, yaw = max(pitch, abs(w[0])), max(wheel, abs(w[2])), max(yaw, abs(w[4]))
            for j in range(A.shape[1]):
                new[j] = 0.0
            add_product(A, gain, z, new)
            add_product(By, gain, y, new)
            add_product(Ba, gain, u, new)
            for j in range(A.shape[1]):
                z[j] = new[j]
            for s in range(stride):
                now = k * stride + s
                disturb(w, pushes, push, floors, floor, now, now * step)
                for r in range(substeps):
                    advance(w, 1, fallen, (now * substeps + r + 1) * h)
            effort += w[8] ** 2 + w[9] ** 2 if w[6] > 0.0 else 0.0
        for j in range(6):
            out[robot, j] = w[j]
        out[robot, 6], out[robot, 7], out[robot, 8], out[robot, 9] = pitch, wheel, yaw, w[7]
        out[robot, 10], out[robot, 11] = effort, cut

    return loop
