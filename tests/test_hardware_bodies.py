"""Bodies of hardware keep the contract as far as hardware can, and say what they cannot: tried on virtual robots."""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from upright.bodies import BODIES, Body, Electronics, make_body
from upright.bricks.lcp import VirtualBrick
from upright.bricks.line import Line
from upright.bricks.virtual_robot import virtual_flight, virtual_hub
from upright.bricks.world import World
from upright.cli.main import main
from upright.control import CONTROLLERS, ControllerSpec
from upright.errors import InvalidScenario, NotPermitted, SpecMismatch
from upright.experiment import Hold, run
from upright.links.brick import LEFT, RIGHT, BrickLost
from upright.links.hub import HubLost
from upright.links.nxt_body import NxtBody
from upright.links.pybricks_body import PybricksBody
from upright.physics.dynamics import Disturbance
from upright.robots import Kit, Robot

ROBOT = Robot.preset("nxtway-gs")
REAL = [name for name in BODIES if make_body(name, ROBOT).spec.real]
SMALL = 0.4  # [V], 5 % of duty: moves the wheels without throwing the robot down at once


@dataclass
class Slow:
    """The same voltage in every period, as an open-loop measurement sends it."""

    period: float
    volts: float = SMALL

    @property
    def spec(self) -> ControllerSpec:
        return ControllerSpec("open loop", ("sensor/encoder_left", "sensor/encoder_right"), self.period)

    def reset(self) -> None: ...

    def step(self, measurement: Any, reference: Any) -> tuple[float, float]:
        return self.volts, self.volts

    def estimate(self) -> tuple[()]:
        return ()

    def applied(self, command: Any) -> None: ...

    def to_json(self) -> dict[str, Any]:
        return {"kind": "open loop", "volts": self.volts}


@pytest.fixture(
    params=[
        pytest.param("nxt", marks=pytest.mark.needs("module:nxt")),
        pytest.param("pybricks", marks=pytest.mark.needs("module:pybricksdev", "module:micropython_unix")),
    ]
)
def robot(request: pytest.FixtureRequest) -> Iterator[tuple[Body, World, Any]]:
    """A body on a virtual robot, the world round that, and what tells the duties [%] of its motors."""
    if request.param == "nxt":
        with virtual_flight(ROBOT, Kit.preset("nxt")) as flight:
            body: Body = NxtBody(ROBOT, flight.path, wait=flight.robot.wait)
            motors = flight.brick.hardware.motors
            yield body, flight.robot.world, lambda: [motor.duty for motor in motors]
            body.close()
    else:
        with virtual_hub(ROBOT, Kit.preset("spike")) as hub:
            body = PybricksBody(ROBOT, hub)
            yield body, hub.world, lambda: list(hub.duties)
            body.close()


def test_hardware_is_registered_and_says_what_it_cannot_do_before_it_is_connected() -> None:
    assert set(REAL) == {"nxt", "pybricks"}
    for name in REAL:
        spec = make_body(name, ROBOT).spec
        assert (spec.real, spec.settable, spec.pushable) == (True, False, False)
        assert spec.period >= 0.05  # [s]: 20 Hz at most
        assert math.isfinite(spec.limit)
        assert not [signal for signal in spec.channels if signal.name.startswith("truth")]


@pytest.mark.parametrize("name", ["nxt", "pybricks"])
def test_a_balancing_controller_is_refused_in_one_line_before_anything_is_connected(name: str) -> None:
    controller = CONTROLLERS["lqg"](ROBOT, Kit.preset("nxt"), 0.01)
    with pytest.raises(SpecMismatch, match=r"100 times a second, and a .* answers") as caught:
        run(make_body(name, ROBOT), controller)
    assert "\n" not in str(caught.value)
    assert "upright fly" in str(caught.value)


@pytest.mark.parametrize("name", ["nxt", "pybricks"])
def test_what_hardware_cannot_do_is_refused(name: str) -> None:
    body = make_body(name, ROBOT)
    slow = Slow(body.spec.period)
    with pytest.raises(InvalidScenario, match="cannot be pushed by a number"):
        run(body, slow, Hold(pitch=0.1, until=1.0))
    with pytest.raises(SpecMismatch, match="cannot be put into a state"):
        run(body, slow, start=(0.1, 0, 0, 0, 0, 0))
    with pytest.raises(SpecMismatch, match="electronics of its own"):
        Electronics(body, Kit.preset("nxt"))
    with pytest.raises(SpecMismatch, match=r"commanded in N m"):
        make_body(name, Robot.preset("twipr"))
    with pytest.raises(NotPermitted):
        run(body, slow, certificate=Red())


class Red:
    """A certificate of a controller under which every robot fell."""

    def refuses(self, controller: object = None, robot: object = None, kit: object = None) -> str:
        return "red: 100 of 100 robots fell"


@pytest.mark.parametrize("kit", ["ideal", "nxt"])
@pytest.mark.parametrize("name", ["nxt", "pybricks"])
def test_the_command_that_simulates_drives_no_hardware(name: str, kit: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", "--body", name, "--kit", kit, "--feedback", "1,1,1,1,1,1"]) != 0
    said = capsys.readouterr().err
    assert len(said.strip().splitlines()) == 1


@pytest.mark.needs("module:nxt")
def test_a_brick_that_is_not_there_is_one_line() -> None:
    body = NxtBody(ROBOT, "/dev/nothing")
    with pytest.raises(BrickLost, match="no brick at /dev/nothing"):
        body.reset()
    body.close()


def test_it_keeps_the_contract(robot: tuple[Body, World, Any]) -> None:
    body, world, duties = robot
    assert isinstance(body, Body)
    assert "twin" in body.spec.kind
    assert not body.spec.real  # a stand-in is not hardware
    samples = [body.reset()]
    assert not world.released  # held still while the gyro's offset is found
    samples += [body.step((SMALL, -SMALL)) for _ in range(6)]
    names = [signal.name for signal in body.spec.channels]
    assert all(sample.values.shape == (len(names),) for sample in samples)
    assert [s.t for s in samples] == pytest.approx([k * body.spec.period for k in range(7)])
    with pytest.raises(ValueError, match="read-only"):
        samples[0].values[0] = 1.0
    table = np.array([s.values for s in samples])
    # at rest: encoders at zero, the gyro's offset of 3 °/s taken off but for its noise, the battery as the kit has it
    assert table[0, :2] == pytest.approx([0.0, 0.0])
    assert abs(table[0, 2]) < math.radians(3)
    assert 7.0 < table[0, 3] < 8.5
    # what was applied is what was asked for, to a step of duty
    assert samples[-1].applied == pytest.approx((SMALL, -SMALL), abs=0.01 * table[-1, 3])
    # positive rolls a wheel forward: they turn apart
    assert table[-1, 0] > table[0, 0]
    assert table[-1, 1] < table[0, 1]
    assert any(duties())
    body.close()
    assert not any(duties())
    body.close()  # closing twice is allowed


def test_commands_and_pushes_it_cannot_take_are_refused(robot: tuple[Body, World, Any]) -> None:
    body, world, _ = robot
    body.reset()
    for bad in ((math.nan, 0.0), (0.0,)):
        with pytest.raises(SpecMismatch):
            body.step(bad)
    with pytest.raises(SpecMismatch, match="cannot be pushed"):
        body.step((0.0, 0.0), Disturbance(1.0, 0.05))
    assert not world.released


def test_a_slow_measurement_gives_a_log(robot: tuple[Body, World, Any]) -> None:
    body, _, _ = robot
    slow = Slow(2 * body.spec.period)
    log = run(body, slow, seconds=1.0)
    assert len(log) == round(1.0 / slow.period)
    assert log.origin["body"]["kind"] == body.spec.kind
    assert np.ptp(log["sensor/encoder_left"]) > 0


class Bench:
    """A virtual brick on the bench, its motors free or `blocked`: they turn by 980 °/s on 8 V at once (a back EMF of
    0.468 V s/rad: Watanabe 2007). `least` is the smallest duty [%] either had in a millisecond."""

    def __init__(self) -> None:
        self.brick, self.blocked, self.least, self._angles = VirtualBrick(), False, 100, [0.0, 0.0, 0.0]
        self.brick.hardware.inputs[0].raw = 600

    def wait(self, seconds: float) -> None:
        for _ in range(round(1000 * seconds)):
            self.least = min([self.least, *self.duties()])
            for i, motor in enumerate(self.brick.hardware.motors):
                self._angles[i] += 0 if self.blocked else 0.0098 * motor.duty
                motor.count = round(self._angles[i])
            self.brick.hardware.tick(1)

    def duties(self) -> list[int]:
        return [abs(self.brick.hardware.motors[port].duty) for port in (LEFT, RIGHT)]

    def turned(self) -> list[int]:
        return [self.brick.hardware.motors[port].count for port in (LEFT, RIGHT)]


@pytest.mark.needs("module:nxt")
@pytest.mark.parametrize("volts", [(6.0, -6.0), (0.4, 0.4), (0.1, -8.0)])
def test_an_nxt_that_hears_nothing_stops_motors_that_turn(volts: tuple[float, float]) -> None:
    """After half a second, or 10° where that is more; 1 % fades in a millisecond, in 50 ms on average at full duty."""
    bench = Bench()
    with Line(bench.brick) as line:
        body = NxtBody(ROBOT, line.path, wait=bench.wait)
        body.reset()
        for _ in range(30):  # orders in time renew it, without a gap: the ends do not add up either
            body.step(volts)
        assert all(bench.duties())
        before = bench.turned()
        line.cut()
    bench.wait(1.3)
    assert bench.duties() == [0, 0]
    for u, a, b in zip(volts, before, bench.turned(), strict=True):
        half_second = 0.5 * 980 * abs(u) / 8
        assert 0 < (b - a) * math.copysign(1, u) <= max(half_second, 10) * 1.05 + 980 * 0.05 * abs(u) / 8 + 1
    with pytest.raises(BrickLost):
        body.step(volts)
    body.close()


@pytest.mark.needs("module:nxt")
def test_orders_in_time_drive_an_nxt_without_a_gap() -> None:
    bench = Bench()
    with Line(bench.brick) as line:
        body = NxtBody(ROBOT, line.path, wait=bench.wait)
        body.reset()
        for volts in (4.0, 8.0, -8.0, -0.8, 0.8, 4.0):  # less, more, the other way
            bench.least = 100
            for _ in range(20):
                body.step((volts, volts))
            assert bench.least == round(100 * abs(volts) / 8)
        body.step((0.0, 0.0))
        assert bench.duties() == [0, 0]
        body.close()


@pytest.mark.needs("module:nxt")
def test_a_blocked_motor_of_an_nxt_keeps_its_duty_and_stops_once_it_is_free() -> None:
    bench = Bench()
    with Line(bench.brick) as line:
        body = NxtBody(ROBOT, line.path, wait=bench.wait)
        body.reset()
        bench.blocked = True
        for _ in range(60):
            body.step((2.0, 2.0))
        line.cut()
    bench.wait(5.0)
    assert bench.duties() == [25, 25]
    bench.blocked = False
    bench.wait(1.1)  # twice its half second, as the ends of blocked orders creep on, and 25 ms
    assert bench.duties() == [0, 0]
    body.close()


def test_the_virtual_brick_takes_a_tacho_limit_as_lego_s_firmware_does() -> None:
    """A limit counts from where the last one ended, and from the motor after an order without one (d_output.c)."""
    brick = VirtualBrick()
    motor = brick.hardware.motors[0]

    def order(power: int, limit: int) -> None:
        brick.telegram(struct.pack("<BBBbBBbBI", 0x80, 4, 0, power, 3, 0, 0, 0x20, limit))

    def stops_at() -> int:
        while motor.state:
            motor.count += 1 if motor.power > 0 else -1
            brick.hardware.tick(1)
        return motor.count

    order(50, 100)
    order(50, 100)
    assert stops_at() == 200  # they add up
    assert motor.duty == 50  # and fades by 1 % a millisecond
    brick.hardware.tick(30)
    assert motor.duty == 20
    brick.hardware.tick(30)
    assert motor.duty == 0
    motor.count = 500  # turned by hand
    order(50, 100)
    assert stops_at() == 501  # the end is behind it: at once
    order(-50, 0)
    brick.hardware.tick(1)  # its end goes along
    order(-50, 100)
    assert stops_at() == 401


@pytest.mark.needs("module:pybricksdev", "module:micropython_unix")
def test_a_hub_that_hears_nothing_stops_its_motors() -> None:
    with virtual_hub(ROBOT, Kit.preset("spike")) as hub:
        body = PybricksBody(ROBOT, hub)
        body.reset()
        body.step((1.0, 1.0))
        assert any(hub.duties)
        hub.cut()
        hub.run(1.0)  # twice its patience
        assert hub.duties == (0.0, 0.0)
        with pytest.raises(HubLost):
            body.step((1.0, 1.0))
        body.close()


@pytest.mark.needs("module:pybricksdev", "module:micropython_unix")
def test_a_damaged_order_is_not_obeyed() -> None:
    with virtual_hub(ROBOT, Kit.preset("spike")) as hub:
        body = PybricksBody(ROBOT, hub)
        body.reset()
        for order in (b"50 50*0000\n", b"50 50\n", b"\xff\xff*\n", b"*\n", b"1e9 x*12\n"):
            hub.type(order)
        assert body.step((0.0, 0.0)).applied == (0.0, 0.0)
        body.close()
