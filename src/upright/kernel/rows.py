"""The layout of a block and of its plan: names of row numbers, common to packing and to the compiled loop.

A block is one array of rows; each row holds one number for each of up to `LANES` robots, and rows start `ROW` apart.
"""

from __future__ import annotations

from typing import NamedTuple

from upright.compiled.electronics import FUSED_NUMBERS, GYRO_NUMBERS, SENSOR_NUMBERS
from upright.compiled.generated import WORK, WORK_ROWS

NEVER = 1 << 60  # [steps] longer than any run

S_OWN = len(SENSOR_NUMBERS)  # those of every sensor; from here on those of its kind
SENSOR_SIZE = S_OWN + len(GYRO_NUMBERS)
S_FUSED = S_OWN + len(FUSED_NUMBERS)  # 3: of the readings of which an angle is made
S_NOISE, S_BIAS, S_WALK = map(SENSOR_NUMBERS.index, ("noise", "bias", "bias_walk"))
S_DRIFT, S_VALUE, S_SENSED, S_MEMORY, S_IDEAL, S_NORMAL, S_STEP, S_LINE = (
    SENSOR_SIZE + place for place in (0, 1, 2, 3, 5, 6, 7, 8)
)
"""Bias, reading, what is sensed (of an encoder what it touches, of a filter its angle), 2: wheel, memory of a gyro, or
cosine and sine of that angle; delayed reading, normal numbers of noise and of the bias's walk, delay line."""
ENCODER_LEFT, ENCODER_RIGHT, GYRO, COMPASS, ACCEL_FORWARD, ACCEL_UP, ANGLE = range(7)  # kinds of sensors
PLAIN, SLACK, SWUNG, FUSED = range(4)  # what a sensor senses, besides of what its kind says
S_KIND, S_DELAY, S_EVERY, S_WALKS, S_SENSES, S_PACE = range(6)
S_SPELL, S_ROW, S_PLACES, S_READING, S_LOUD, SENSOR_COLUMNS = range(6, 12)
"""Columns of the table of sensors: kind, delay, period and that of its walk [steps], how it senses, in which steps it
has to (0: only where it is sampled), in which a fused angle reads it (0: it is the controller's), first row, places in
the delay line, row of the reading, and the sum of its random parts:"""
LOUD_NOISE, LOUD_WALK, LOUD_BIAS = 1, 2, 4

KIT = WORK + WORK_ROWS  # rows that every block has, after those of the motion
LIMIT, DEAD_ZONE, QUANTUM, DROP, VOLTAGE, SAG, STRENGTH = range(KIT, KIT + 7)  # of a kit; 2 strengths; then counts:
COUNTS = STRENGTH + 2
PEAK_PITCH, PEAK_WHEEL, PEAK_YAW, OUTSIDE, EFFORT, SATURATED, SQUARE, REFERENCE = range(COUNTS, COUNTS + 8)
KIT_SIZE, COUNTED = COUNTS - KIT, REFERENCE - COUNTS
COMMAND = REFERENCE + 6  # 2: of the controller, and what is added to it; the reference has 6
DECIDED = COMMAND + 2  # 2: the controller's alone, where something is added
DRIVEN = DECIDED + 2  # 2: after the electronics
HOLD = DRIVEN + 2  # 8: see `block.arrive`
DEAD_TIME = HOLD + 8  # 3: see `block.arrive`
NOISE = DEAD_TIME + 3  # 8: one for each kind of sensor
WALK = NOISE + 8  # 8
SPECIFIC_FORCE = WALK + 8  # 2: accelerometer
FLOOR = SPECIFIC_FORCE + 2  # 3: see `block.tilt`
APPLIED = FLOOR + 3  # 2: what is applied to motors that make more or less of it; else the motors' own rows have it
BEYOND = APPLIED + 2  # 1 where a motor could not give what was commanded
FIXED = BEYOND + 1  # rows that every block has; those of `Rows` come after them


class Rows(NamedTuple):
    """First rows and lengths of the parts of a block whose length depends on the batch."""

    pushes: int  # 4 each
    push_count: int
    ramps: int  # 4 each
    ramp_count: int
    excitation: int  # 2 each: what is added to both commands
    excitation_count: int
    excitation_hold: int  # for how many periods each of them is added
    reading: int  # one for each channel that the controller reads, then its states and what it carries over
    ring: int  # 2 for each command on its way
    slots: int


class Plan(NamedTuple):
    """Times common to all robots, and the addresses of the compiled functions that move them."""

    periods: int
    stride: int  # steps of a body in a period
    substeps: int  # Runge-Kutta steps in one of those
    every: int  # periods from one recorded row to the next, 0: none
    decide: int  # address of the controller's `command`
    update: int  # and of its `update`, 0 where it remembers nothing
    slope: int  # 1: some floor slopes
    alike: int  # 1: all robots have the same dead time, without jitter
    advance: int  # address of `advance_…`
    accelerometer: int  # address of `specific_force_…`, 0 where no accelerometer is read
    applied_row: int  # of the two rows of what is applied the first: `APPLIED`, or where motors are alike their own
    drive: int  # addresses of the functions of `electronics`
    turn: int
    slacken: int
    settle: int
    swing: int
    fuse: int
    measure: int
    called: int  # address of the controller that is called instead (see `work.Lanes`), 0: none
    seed: int  # its 64 bits as a signed number


class Sizes(NamedTuple):
    """Lengths of the tables of the compiled loop."""

    robots: int
    all_rows: int  # of a block
    varied: int  # rows that differ from robot to robot
    held: int  # recorded rows of a robot
    truths: int
    sensors: int
    before: int  # channels recorded at the start of a period
    after: int  # and at its end


class Times(NamedTuple):
    """Real numbers of the plan."""

    step: float  # [s] of a body
    h_step: float  # [s] of Runge-Kutta
    fallen_at: float  # [rad]


PUSHES, PUSH_COUNT, RAMPS, RAMP_COUNT, EXCITATION, EXCITATION_COUNT, EXCITATION_HOLD = range(7)
READING, RING, SLOTS = range(7, 10)
PERIODS, STRIDE, SUBSTEPS, EVERY, DECIDE, UPDATE, SLOPE, ALIKE, ADVANCE, ACCELEROMETER = range(10, 20)
APPLIED_ROW, DRIVE, TURN, SLACKEN, SETTLE, SWING, FUSE, MEASURE, CALLED, SEED = range(20, 30)
ROBOTS, ALL_ROWS, VARIED, HELD, TRUTHS, SENSORS, BEFORE, AFTER = range(30, 38)
"""Places of the fields of `Rows`, `Plan` and `Sizes` in the one array that compiled functions get."""
STEP, H_STEP, FALLEN_AT = range(3)
"""Places of the fields of `Times`."""
