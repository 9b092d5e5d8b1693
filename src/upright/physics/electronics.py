"""What a kit's electronics make of a command and of a reading, written once.

Generic like `dynamics`, over the numbers of motor, battery and sensor (anything with the fields of `Motor`, `Battery`
and `Sensor`) and over the maths namespace `xp`, which here gives `absolute`, `whole` (towards zero), `nearest` (halves
to the even), `limit(value, low, high)` and `choose(left, right, then, other)`: `then` where left < right, else `other`.
There are no branches: what is computed is recorded for bodies, the kernel, a page, the predictor of a calibration, and
the programs of bricks.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def awake(command: Any, motor: Any, xp: Any) -> Any:
    """The command to one motor; zero where the dead zone swallows it."""
    return xp.choose(motor.dead_zone, xp.absolute(command), command, 0.0)


def loaded(command: Sequence[Any], battery: Any, xp: Any) -> Any:
    """The battery's voltage [V] while it gives both commands, which end at its open-circuit voltage."""
    full = battery.voltage
    left, right = (xp.choose(size, full, size, full) for size in map(xp.absolute, command))
    return full - battery.sag * (left + right)


def largest(voltage: Any, motor: Any, xp: Any, *, volts: bool = True) -> Any:
    """The largest command that the driver gives; only commands in `volts` end at the battery's voltage."""
    return xp.choose(motor.limit, voltage, motor.limit, voltage) if volts else motor.limit


def driven(command: Sequence[Any], motor: Any, battery: Any, xp: Any, *, volts: bool = True) -> list[Any]:
    """What reaches both motors: after the dead zone, the battery's sag under both commands, saturation, the driver's
    quantum and its drop, in this order."""
    commands = [awake(u, motor, xp) for u in command]
    limit = largest(loaded(commands, battery, xp), motor, xp, volts=volts)
    given = [switched(u, limit, motor.quantum, xp) for u in commands]
    return [dropped(u, motor.drop, xp) for u in given]


def switched(command: Any, limit: Any, quantum: Any, xp: Any) -> Any:
    """What a driver gives of a command: ±`limit` at most, in whole steps of `quantum` towards zero."""
    return stepped(xp.limit(command, -limit, limit), quantum, xp.whole, xp)


def dropped(value: Any, drop: Any, xp: Any) -> Any:
    """sign(u) max(0, |u| − drop): what is left of a command u of which the driver keeps `drop`; u itself where that is
    zero."""
    return xp.choose(-drop, 0.0, value - xp.limit(value, -drop, drop), value)


def stepped(value: Any, quantum: Any, rounded: Any, xp: Any) -> Any:
    """`value` in whole steps of `quantum`, as it is where that is zero."""
    step = xp.choose(-quantum, 0.0, quantum, 1.0)
    return xp.choose(-quantum, 0.0, rounded(value / step) * step, value)


def turned(applied: Sequence[Any], motor: Any) -> tuple[Any, Any]:
    """What each motor makes of what is applied to it."""
    return applied[0] * motor.left, applied[1] * motor.right


def slackened(touch: Any, value: Any, play: Any, xp: Any) -> Any:
    """Backlash: the encoder, which stood at `touch`, moves only where the wheel reaches the end of the play."""
    return xp.limit(touch, value - play, value + play)


def swung(rate: Any, first: Any, second: Any, gyro: Any) -> tuple[Any, Any, Any]:
    """z, which a gyro that swings or is filtered makes of the pitch `rate` v, and its two memories after a step:
    z̈ = ω² (v − z) − 2ζω ż, exactly for a v that is straight over each step.

    `gyro` has the coefficients of its transfer function (b0 + b1 q + b2 q²) / (1 − a1 q − a2 q²), q being a step back;
    the memories are those of its transposed direct form II (Oppenheim and Schafer, Discrete-time signal processing).
    """
    z = gyro.b0 * rate + first
    return z, gyro.b1 * rate + gyro.a1 * z + second, gyro.b2 * rate + gyro.a2 * z


def settled(rate: Any, gyro: Any) -> tuple[Any, Any]:
    """Both memories of `swung` after a long time at this `rate`."""
    second = gyro.b2 * rate + gyro.a2 * rate
    return gyro.b1 * rate + gyro.a1 * rate + second, second


def tilted(rate: Any, yaw_rate: Any, gyro: Any) -> Any:
    """What a gyro shows that is tilted: `gyro.tilt` of the yaw rate beside the pitch rate."""
    return rate + gyro.tilt * yaw_rate


def fused(angle: Any, direction: Sequence[Any], motion: Sequence[Any], gravity: Any, sensor: Any) -> Any:
    """The angle that a filter makes of gyro and accelerometer, after one of its steps of `sensor.spell` [s]:
    angle + h (ψ̇ + sin(α − angle) |f| / (g τ)), with α the direction of the specific force f.

    `direction` is cosine and sine of `angle` before it, `motion` the pitch rate and the specific force forward and up.
    Where the robot accelerates, f is not along gravity, and the angle leans. Mahony, Hamel and Pflimlin (2008), section
    II, in the plane; to first order the complementary filter of this time constant.
    """
    cosine, sine = direction
    rate, forward, up = motion
    error = forward * cosine + up * sine
    return angle + sensor.spell * (rate - error / (gravity * sensor.time_constant))


def walked(drift: Any, normal: Any, sensor: Any) -> Any:
    """A sensor's bias after a walk that lasts t, for a `normal` number times √t."""
    return drift + sensor.bias_walk * normal


def response(value: Any, sensor: Any) -> Any:
    """What a sensor makes of the ideal `value`, which estimators that know the sensor count with; linear in `value`."""
    return sensor.gain * value


def measured(value: Any, drift: Any, normal: Any, sensor: Any, xp: Any) -> Any:
    """A fresh reading of the ideal `value`: response, offset, bias, noise (a `normal` number), quantum, range."""
    reading = response(value, sensor) + sensor.offset + drift + sensor.noise * normal
    return xp.limit(stepped(reading, sensor.quantum, xp.nearest, xp), -sensor.range, sensor.range)
