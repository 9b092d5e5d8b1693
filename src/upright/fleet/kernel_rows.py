"""The layout of a block and of its plan: names for numbers, shared by what fills blocks and what runs them.

A block is one array of rows; each row holds one number for each of up to `LANES` robots, and rows start `ROW` apart.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from upright.fleet.generated import C0, CONSTANTS

JITTER = 6  # purposes of random numbers: 0, 1 noise, 2, 3 walk and 4, 5 bias of four sensors each; 6 jitter
NEVER = 1 << 60  # [steps] longer than any run

LIMIT, DEAD_ZONE, QUANTUM, VOLTAGE, SAG, KIT_SIZE = range(6)  # numbers of a kit
S_QUANTUM, S_NOISE, S_BIAS, S_WALK, S_RANGE, S_PLAY, SENSOR_SIZE = range(7)  # numbers of a sensor, and after them:
S_OFFSET, S_SAID, S_TOUCH, S_WHEEL, S_LINE = range(
    SENSOR_SIZE, SENSOR_SIZE + 5
)  # offset, reading, encoder, wheel, delay line
ENCODER_LEFT, ENCODER_RIGHT, GYRO, COMPASS, ACCEL_FORWARD, ACCEL_UP = range(6)  # kinds of sensors
PEAK_PITCH, PEAK_WHEEL, PEAK_YAW, OUTSIDE, EFFORT, SATURATED, SQUARE, COUNTED = range(8)  # what is counted
S_KIND, S_LATE, S_EVERY, S_ROW, S_PLACES, S_READING, S_SLACK, S_LOUD, SENSOR_COLUMNS = range(9)
"""Columns of the table of sensors: kind, delay and period [steps], first row, places in the delay line, row of the
reading, and whether it has play and noise."""


KIT = C0 + CONSTANTS  # rows that every block has, after the state, what is held and the constants
COUNTS = KIT + KIT_SIZE
REFERENCE = COUNTS + COUNTED  # 6
COMMAND = REFERENCE + 6  # 2: asked for
DRIVEN = COMMAND + 2  # 2: what the electronics make of it
HOLD = DRIVEN + 2  # 8: see `kernel_block.arrive`
LATE = HOLD + 8  # 3: see `kernel_block.arrive`
NOISE = LATE + 3  # 4 and 4: noise and walk
FELT = NOISE + 8  # 2: accelerometer
FLOOR = FELT + 2  # 3: see `kernel_block.tilt`
FREE = FLOOR + 3


class Rows(NamedTuple):
    """Where the rows start whose number varies, and how many there are."""

    pushes: int  # 4 each
    push_count: int
    ramps: int  # 4 each
    ramp_count: int
    reading: int  # one for each channel that the controller reads
    memory: int  # the controller's state, and as many rows for the next one
    memory_count: int
    ring: int  # 2 for each command on its way
    slots: int


class Plan(NamedTuple):
    """Times that all robots share, and the compiled functions that suit them."""

    periods: int
    stride: int  # steps of a body in a period
    substeps: int  # Runge-Kutta steps in one of those
    every: int  # periods from one recorded row to the next, 0: none
    own_gains: int  # 1: each robot has its own controller
    slope: int  # 1: some floor slopes
    alike: int  # 1: every command is equally late for all robots
    advance: int  # address of `advance_…`
    feel: int  # address of `specific_force_…`, 0 where no accelerometer is read
    seed: Any
    step: float  # [s] of a body
    h: float  # [s] of Runge and Kutta
    fallen: float  # [rad]
