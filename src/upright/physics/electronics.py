"""What a kit's electronics make of a command and of a reading, written once.

Generic like `dynamics`, over the numbers of motor, battery and sensor (anything with the fields of `Motor`, `Battery`
and `Sensor`) and over the maths namespace `xp`, which here gives `absolute`, `whole` (towards zero), `nearest` (halves
to the even) and `choose(left, right, then, other)`: `then` where left < right, else `other`. There are no branches:
`compiled.electronics` records what is computed, for bodies, the kernel and a page.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def limited(value: Any, low: Any, high: Any, xp: Any) -> Any:
    return xp.choose(value, low, low, xp.choose(high, value, high, value))


def awake(command: Sequence[Any], motor: Any, xp: Any) -> list[Any]:
    """Both commands without those that the dead zone swallows."""
    return [xp.choose(motor.dead_zone, xp.absolute(u), u, 0.0) for u in command]


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
    commands = awake(command, motor, xp)
    limit = largest(loaded(commands, battery, xp), motor, xp, volts=volts)
    given = [stepped(limited(u, -limit, limit, xp), motor.quantum, xp.whole, xp) for u in commands]
    return [dropped(u, motor.drop, xp) for u in given]


def dropped(value: Any, drop: Any, xp: Any) -> Any:
    """sign(u) max(0, |u| − drop): what is left of a command u of which the driver keeps `drop`; u itself where that is
    zero."""
    return xp.choose(-drop, 0.0, value - limited(value, -drop, drop, xp), value)


def stepped(value: Any, quantum: Any, rounded: Any, xp: Any) -> Any:
    """`value` in whole steps of `quantum`, as it is where that is zero."""
    step = xp.choose(-quantum, 0.0, quantum, 1.0)
    return xp.choose(-quantum, 0.0, rounded(value / step) * step, value)


def turned(applied: Sequence[Any], motor: Any) -> tuple[Any, Any]:
    """What each motor makes of what is applied to it."""
    return applied[0] * motor.left, applied[1] * motor.right


def slackened(touch: Any, value: Any, play: Any, xp: Any) -> Any:
    """Backlash: the encoder, which stood at `touch`, moves only where the wheel reaches the end of the play."""
    return limited(touch, value - play, value + play, xp)


def walked(offset: Any, normal: Any, sensor: Any) -> Any:
    """A sensor's offset after a walk that lasts t, for a `normal` number times √t."""
    return offset + sensor.bias_walk * normal


def response(value: Any, sensor: Any) -> Any:
    """What a sensor makes of the ideal `value`, which estimators that know the sensor count with; linear in `value`."""
    return sensor.gain * value


def measured(value: Any, offset: Any, normal: Any, sensor: Any, xp: Any) -> Any:
    """A fresh reading of the ideal `value`: response, offset, noise (a `normal` number), quantum, range."""
    reading = response(value, sensor) + offset + sensor.noise * normal
    return limited(stepped(reading, sensor.quantum, xp.nearest, xp), -sensor.range, sensor.range, xp)
