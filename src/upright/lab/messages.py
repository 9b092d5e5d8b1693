"""What page and session say to each other: frozen dataclasses, which are also the types of the page.

Snapshots are of the moment: the latest wins, and a client holds at most one that it has not acknowledged. Everything
else is an event: ordered, never dropped. `web/src/messages.ts` is generated from this file by `lab.typescript`.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any, Literal

VERSION = 2
"""Raised whenever a message changes; a page of another version is refused with a sentence that says what to do."""

LONGEST_TEXT = 200
MOST_ITEMS = 64


def number(low: float, high: float, default: float | None = None) -> Any:
    """A field whose number is refused outside [low, high]."""
    metadata = {"low": low, "high": high}
    return field(metadata=metadata) if default is None else field(default=default, metadata=metadata)


BodyName = Literal["twin", "nonlinear", "linear", "published", "calibrated"]
Family = Literal[
    "lqg", "lqr", "lqr-complementary", "lqr-state", "lqi", "pid", "hinf", "mpc", "sliding", "robust", "gains", "off"
]
Job = Literal["certify", "doctor", "calibrate", "design"]
Keep = Literal["csv", "parquet", "report", "replay", "controller", "robot"]
Blow = Literal["front", "back", "impulse", "tug_left", "tug_right"]


@dataclass(frozen=True)
class Setup:
    """Everything that a link restores.

    `numbers` replaces parameters of `robot`, and the controller knows of it; `payload` [kg] at `payload_height` [m]
    above the axle and the `slope` [rad] it does not. `noise` scales the sensors' quanta, noise and bias; the numbers
    after it replace the kit's: dead time [s], battery [V], dead zone [V or N m]; negative is the kit's own. `largest`
    are Bryson's sizes of the six states and of the command; `gains` are the left motor's, for the family of that name.
    """

    robot: str = "nxtway-gs"
    numbers: dict[str, float] = field(default_factory=dict[str, float])
    drive: Literal["", "voltage", "torque"] = ""
    kit: str = "nxt"
    noise: float = number(0, 20, 1.0)
    delay: float = number(-1, 0.05, -1.0)
    voltage: float = number(-1, 60, -1.0)
    dead_zone: float = number(-1, 5, -1.0)
    grip: float = number(0.02, 10, 10.0)
    bodies: tuple[BodyName, ...] = ("twin", "nonlinear", "linear")
    controller: Family = "lqg"
    largest: tuple[float, ...] = ()
    gains: tuple[float, ...] = ()
    payload: float = number(0, 5, 0.0)
    payload_height: float = number(0, 1, 0.15)
    slope: float = number(-0.35, 0.35, 0.0)
    seed: int = number(0, 2**31, 0)


@dataclass(frozen=True)
class Hello:
    """The first message of a page: its version, the session that it had, its token and name in a class."""

    version: int
    session: str = ""
    token: str = ""
    name: str = ""
    setup: Setup | None = None


@dataclass(frozen=True)
class Ack:
    """Snapshot `n` has been drawn."""

    n: int


@dataclass(frozen=True)
class Change:
    """The whole set-up, as it should be from now on."""

    setup: Setup


@dataclass(frozen=True)
class Drag:
    """The mouse pushes the body with `force` [N] at `height` [m] above the axle until the next such message."""

    force: float = number(-500, 500)
    height: float = number(-3, 3)


@dataclass(frozen=True)
class Strike:
    """A push by name: the paper's holds to a pitch [rad], an impulse [N s], or a tug on one wheel [N]."""

    what: Blow
    size: float = number(-100, 100)


@dataclass(frozen=True)
class Steer:
    """Roll at `speed` [m/s] and turn at `rate` [rad/s] from now on."""

    speed: float = number(-3, 3)
    rate: float = number(-10, 10)


@dataclass(frozen=True)
class Play:
    """Pause, or run at `speed` times wall time."""

    paused: bool
    speed: float = number(0.01, 4, 1.0)


@dataclass(frozen=True)
class Step:
    """While paused: go on by so many of the controller's periods."""

    periods: int = number(1, 1000, 1)


@dataclass(frozen=True)
class Scrub:
    """While paused: show the moment `back` [s] before now."""

    back: float = number(0, 60)


@dataclass(frozen=True)
class StandUp:
    """Put the robot at rest at the lean `pitch` [rad]."""

    pitch: float = number(-1.2, 1.2, 0.0)


@dataclass(frozen=True)
class Start:
    """Begin a job; `file` names a log that was uploaded, '' the run that is being recorded."""

    job: Job
    file: str = ""


@dataclass(frozen=True)
class Cancel:
    """Kill the job."""

    job: Job


@dataclass(frozen=True)
class Save:
    """Make a file of the run so far, to be downloaded."""

    what: Keep


@dataclass(frozen=True)
class Broadcast:
    """The teacher gives everyone this set-up, and stands every robot up."""

    setup: Setup


@dataclass(frozen=True)
class Uploaded:
    """A file that lies in the session's folder; only the server says so."""

    what: Literal["log", "robot"]
    path: str
    name: str


ClientMessage = (
    Hello | Ack | Change | Drag | Strike | Steer | Play | Step | Scrub | StandUp | Start | Cancel | Save | Broadcast
)


@dataclass(frozen=True)
class FamilyInfo:
    """A controller family: whether `largest` and `gains` mean anything to it."""

    name: str
    weights: bool
    truth: bool


@dataclass(frozen=True)
class RobotInfo:
    """A robot to choose: its numbers with unit and symbol, and its own kit."""

    name: str
    title: str
    kit: str
    drive: str
    numbers: dict[str, float]


@dataclass(frozen=True)
class Catalogue:
    """What there is to choose."""

    robots: tuple[RobotInfo, ...]
    kits: tuple[str, ...]
    families: tuple[FamilyInfo, ...]
    units: dict[str, str]
    symbols: dict[str, str]
    largest: tuple[float, ...]
    command: dict[str, float]


@dataclass(frozen=True)
class Welcome:
    """The answer to `Hello`. `files` is where the session's files are asked for."""

    version: int
    session: str
    role: Literal["alone", "student", "teacher"]
    files: str


@dataclass(frozen=True)
class Refused:
    """Why this page cannot go on, and what to do; the connection is closed after it."""

    reason: str


@dataclass(frozen=True)
class Look:
    """What the page draws the robot from [m, kg], and what the command is limited to."""

    wheel_radius: float
    track: float
    body_height: float
    body_depth: float
    com_height: float
    payload: float
    payload_height: float
    command_unit: str
    limit: float | None
    weight: float


@dataclass(frozen=True)
class Changed:
    """The set-up as it is now, what the robot looks like and what stands in each row of the snapshots."""

    setup: Setup
    look: Look
    bodies: tuple[str, ...]
    period: float
    controller: str
    truth: bool
    kit: dict[str, float]
    busy: bool = False


@dataclass(frozen=True)
class Analysed:
    """The present loop: `gain` (2, 6) where it has one, margins, closed-loop poles, and `L` broken at both motors: ω
    [rad/s], Re and Im in three rows."""

    stable: bool
    words: str
    gain: tuple[tuple[float, ...], ...]
    gain_low: float | None
    gain_high: float | None
    phase: float | None
    delay: float | None
    poles: tuple[tuple[float, ...], ...]
    L: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Equations:
    """The numbers of the present model: upright a11, a12, a22, a33, α, β, M g L, M L R, what a lean adds to a33, W/2R,
    and the linear model about upright."""

    inertias: tuple[float, ...]
    alpha: float
    beta: float
    weight: float
    lever: float
    swing: float
    half_track: float
    A: tuple[tuple[float, ...], ...]
    B: tuple[tuple[float, ...], ...]
    poles: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Lit:
    """The certificate's light: "green", "amber", "red", or "none" while it is computed, with its reasons."""

    light: Literal["green", "amber", "red", "none"]
    reasons: tuple[str, ...]


@dataclass(frozen=True)
class Progress:
    """How far a job is, from 0 to 1."""

    job: Job
    share: float


@dataclass(frozen=True)
class Found:
    """What a job found, as text for people, and the rows of its table."""

    job: Job
    title: str
    text: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    ok: bool


@dataclass(frozen=True)
class Made:
    """A file to be downloaded under `name`."""

    what: str
    name: str
    url: str


@dataclass(frozen=True)
class Said:
    """A sentence for the user: what went wrong, or what was done."""

    level: Literal["info", "error"]
    text: str


@dataclass(frozen=True)
class Recovered:
    """A push of `impulse` [N s] from which the robot came back, its `effort` [u² s], and the largest so far."""

    impulse: float
    effort: float
    best: float
    fell: bool


@dataclass(frozen=True)
class History:
    """What was recorded before the page came: time, and ψ, ψ̇, θ, θ̇, φ, φ̇ of every body in turn."""

    t: tuple[float, ...]
    rows: tuple[tuple[float, ...], ...]


@dataclass(frozen=True)
class Snapshot:
    """A moment. `x`: a row for each body with the six states, both applied commands and whether it fell; `e`: the
    first controller's estimate; `f`: push [N], its height [m], slope [rad], tug [N]; `r`: reference wheel and yaw angle
    [rad]; `s`: 1 and 2 for the left and right motor at its limit; `back` [s]: how long ago, while scrubbing."""

    n: int
    t: float
    x: tuple[tuple[float, ...], ...]
    e: tuple[float, ...]
    f: tuple[float, ...]
    r: tuple[float, ...]
    s: int
    paused: bool
    back: float = 0.0


@dataclass(frozen=True)
class Student:
    """One line of the board: lean of the robot [rad], largest recovered push [N s], effort of the whole run [u² s]."""

    name: str
    pitch: float
    fallen: bool
    best: float
    effort: float
    here: bool
    controller: str


@dataclass(frozen=True)
class Board:
    """Everybody in the class; like a snapshot, the latest wins."""

    students: tuple[Student, ...]


ServerMessage = (
    Welcome | Refused | Changed | Analysed | Equations | Lit | Progress | Found | Made | Said | Recovered | History
    | Snapshot | Board | Catalogue
)  # fmt: skip
