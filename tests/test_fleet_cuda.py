"""The card's kernel: the same loop as the processor's, tried on a card or in Numba's simulator of one."""

import subprocess
import sys
import textwrap

import pytest

from upright.control import lqr
from upright.errors import MissingTool, SpecMismatch
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.cuda import simulate_cuda, why_not
from upright.robots import Kit, Robot

NXT = Robot.preset("nxtway-gs")

SCRIPT = """
import numpy as np
from upright.control import lqr
from upright.kernel.cuda import simulate_cuda
from upright.kernel.simulate import simulate
from upright.kernel.batch import FleetBatch, parameters_of
from upright.robots import Robot

robot = Robot.preset("nxtway-gs")
starts = np.zeros((3, 6))
starts[:, 0] = 0.02, 0.1, 1.2
batch = FleetBatch(
    parameters=parameters_of(robot, {"com_height": np.array([0.07, 0.072, 0.075])}),
    controller=lqr(robot), start=starts, pushes=np.array([[[0.3, np.nan, 0.03, 0.05]]]), slope=np.array([[0.02, 0.0]]),
)
ours, theirs = simulate(batch, 0.1), simulate_cuda(batch, 0.1)
for name in ("final", "lived", "peak", "effort", "saturated"):
    # equal but for rounding (the card rounds a product and a sum each, or both at once), grown by the unstable pole
    np.testing.assert_allclose(getattr(theirs, name), getattr(ours, name), rtol=1e-9, atol=1e-11, err_msg=name)
assert list(ours.fell) == list(theirs.fell)
print("equal")
"""


@pytest.mark.needs("module:numba_cuda")
def test_it_equals_the_processor_s_kernel_in_numba_s_simulator():
    run = subprocess.run(
        [sys.executable, "-c", textwrap.dedent(SCRIPT)],
        env={"NUMBA_ENABLE_CUDASIM": "1", "PATH": ""},
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert run.stdout.strip() == "equal", run.stderr[-2000:]


def test_on_a_card_it_equals_the_processor_s_kernel_and_elsewhere_it_says_why_not():
    if not why_not():
        exec(SCRIPT, {"__name__": "example"})  # it asserts
        return
    with pytest.raises(MissingTool, match=r"fleet\.simulate"):
        simulate_cuda(FleetBatch(parameters=parameters_of(NXT), controller=lqr(NXT)), 0.1)


def test_what_it_cannot_do_is_refused(monkeypatch):
    monkeypatch.setattr("upright.kernel.cuda.why_not", lambda: "")
    batch = FleetBatch(parameters=parameters_of(NXT), controller=lqr(NXT), kit=Kit.preset("nxt"))
    with pytest.raises(SpecMismatch, match="delay or jitter"):
        simulate_cuda(batch, 0.1)
