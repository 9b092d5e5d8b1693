"""The bare loop on an NVIDIA card: one thread a robot, moved by the same trace as the processor's kernel.

It needs the package numba-cuda (`pip install 'upright[cuda]'`) and a card. Sensors are ideal and commands arrive at
once: noise, delays and quanta stay with `fleet.simulate`, which this refuses to replace silently. Float64 only.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies.body import FALLEN
from upright.errors import InvalidScenario, MissingTool, SpecMismatch
from upright.kernel.batch import NAMES, FleetBatch, FleetResult
from upright.kernel.pack import constants, pushes_of
from upright.kernel.simulate import substeps_for
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

THREADS = 128  # of a block of the card: four warps, so that their waiting for memory overlaps
MOST_STATES, MOST_READS = 24, 8  # of a controller, which live in each thread's own memory

_READINGS = {
    **{f"truth/{name}": (row, 0.0) for row, name in enumerate(STATE_NAMES)},
    "sensor/encoder_left": (6, -1.0),
    "sensor/encoder_right": (6, 1.0),
    "sensor/gyro": (1, 0.0),
    "sensor/compass": (4, 0.0),
}
"""Channel → the row of the state it reads, or 6 for an encoder with the sign of its side."""


def why_not() -> str:
    """Why no card can be used here, '' where one can."""
    try:
        from numba import cuda
    except ImportError:
        return "the package numba-cuda is not installed (pip install 'upright[cuda]')"
    return "" if cuda.is_available() else "no NVIDIA card or driver was found"


def simulate_cuda(batch: FleetBatch, seconds: float = 10.0) -> FleetResult:
    """What `fleet.simulate` gives for robots with ideal sensors, computed on the card; nothing is recorded.

    Of the kit only the command's limit is used. Raises `MissingTool` without a card, `SpecMismatch` for what only the
    processor's kernel can do, `InvalidScenario` for times that make no sense.
    """
    if reason := why_not():
        raise MissingTool(reason, hint="use fleet.simulate, which needs no card")
    from numba import cuda

    from upright.kernel.cuda_loop import kernel

    limit = _refuse(batch)
    gains, substeps = batch.gains, batch.substeps or substeps_for(batch.parameters, batch.model, batch.period)
    stride = round(gains.period / batch.period)
    if not (stride >= 1 and math.isclose(stride * batch.period, gains.period, rel_tol=1e-9) and seconds > 0):
        raise InvalidScenario(f"{seconds:g} s in periods of {gains.period:g} s on steps of {batch.period:g} s")
    periods = round(seconds / gains.period)
    pushes = pushes_of(batch).reshape(-1, batch.pushes.shape[1], 4)
    reads = np.array([_READINGS[name] for name in gains.reads], dtype=np.float64)
    tables = (constants(batch), batch.start, pushes, gains.A, gains.By, gains.Ba, gains.C, gains.Dy, reads)
    given = [cuda.to_device(np.ascontiguousarray(table)) for table in (*tables, batch.slope)]
    out: Any = cuda.device_array((batch.n, 12), np.float64)
    times = (periods, stride, substeps, batch.period / substeps, batch.period, limit, FALLEN)
    rough, sloped = batch.parameters[:, NAMES.index("coulomb_friction")].any(), batch.slope[:, 0].any()
    variant = {(0, 0): "smooth", (1, 0): "coulomb", (0, 1): "slope", (1, 1): "coulomb_slope"}[int(rough), int(sloped)]
    kernel(variant)[-(-batch.n // THREADS), THREADS](*given, *times, out)
    return _result(out.copy_to_host(), gains.period, substeps)


def _refuse(batch: FleetBatch) -> float:
    """The limit of a command; `SpecMismatch` where the batch asks for what this kernel has not."""
    kit, gains = batch.kit, batch.gains
    wants = {
        "a moving reference": batch.reference.shape[1] > 0,
        "kit_changes": len(batch.kit_changes) > 0,
        f"a controller of more than {MOST_STATES} states": gains.A.shape[1] > MOST_STATES,
        f"more than {MOST_READS} readings": len(gains.reads) > MOST_READS,
        "accelerometers": any(name not in _READINGS for name in gains.reads),
    }
    if kit is not None:
        wants["delay or jitter"] = kit.delay > 0 or kit.jitter > 0
        wants["a driver's quantum or dead zone"] = kit.motor.quantum > 0 or kit.motor.dead_zone > 0
        wants["a sagging battery"] = kit.battery.sag > 0
        wants["sensors with faults"] = any(vars(s) != vars(type(s)()) for s in kit.sensors.values())
    missing = [name for name, wanted in wants.items() if wanted]
    if missing:
        raise SpecMismatch(f"the card's kernel has no {', '.join(missing)}", hint="use fleet.simulate")
    return math.inf if kit is None else min(kit.motor.limit, kit.battery.voltage)


def _result(out: Array, period: float, substeps: int) -> FleetResult:
    lived, effort, saturated, square = out[:, 9], out[:, 10], out[:, 11], np.full(len(out), np.nan)
    counted = np.maximum(1, np.ceil(lived / period - 1e-6))
    return FleetResult(
        final=out[:, :6].copy(), fell=~(np.abs(out[:, 0]) <= FALLEN), lived=lived.copy(), peak=out[:, 6:9].copy(),
        settled=np.full(len(out), np.nan), rms_pitch=square, effort=effort * period, saturated=saturated / counted,
        t=np.zeros(0), channels=(), trace=np.zeros((len(out), 0, 0)), substeps=substeps,
    )  # fmt: skip
