"""The messages between page and session: frozen dataclasses, which are also the types of the page.

Snapshots are of the moment: the latest wins, and a client holds at most one that it has not acknowledged. Everything
else is an event: ordered, never dropped. `web/src/messages.ts` is generated from this file by `lab.typescript`; `codec`
has pydantic check what a client sends against these types and their limits.
"""

from __future__ import annotations

from dataclasses import KW_ONLY, dataclass, field
from typing import Annotated, Any, ClassVar, Literal

from annotated_types import Interval, MaxLen

from upright.lab.message_types import (
    MOST_ITEMS,
    STRICT,
    Acted,
    ErrorParts,
    FamilyInfo,
    Head,
    Job,
    NamedNumbers,
    Numbers,
    Progress,
    RobotInfo,
    Student,
    Text,
    Whole,
    message,
)  # fmt: skip

VERSION = 10
"""Raised whenever a message changes; a page of another version is refused with a sentence that says what to do."""

BodyName = Literal["twin", "nonlinear", "linear", "published", "calibrated"]
Keep = Literal["csv", "parquet", "report", "compare", "replay", "controller", "robot", "handin"]
Language = Literal["en", "es"]
PushName = Literal["front", "back", "impulse", "pull_left", "pull_right"]


@dataclass(frozen=True, kw_only=True)
class Setup:
    """Everything that a link restores.

    `numbers` replaces parameters of `robot`, and the controller knows of it; `payload` [kg] at `payload_height` [m]
    above the axle and the `slope` [rad] it does not. `noise` scales the sensors' quanta, noise and bias; the numbers
    after it replace the kit's: dead time [s], battery [V], dead zone [V or N m]; negative is the kit's own. `largest`
    are Bryson's sizes of the six states and of the command; `gains` are the left motor's, for the family of that name.
    """

    robot: Text = "nxtway-gs"
    numbers: NamedNumbers = field(default_factory=dict[str, float])
    drive: Literal["", "voltage", "torque", "speed"] = ""
    kit: Text = "nxt"
    noise: Annotated[float, Interval(ge=0, le=20)] = 1.0
    delay: Annotated[float, Interval(ge=-1, le=0.2)] = -1.0
    voltage: Annotated[float, Interval(ge=-1, le=60)] = -1.0
    dead_zone: Annotated[float, Interval(ge=-1, le=5)] = -1.0
    grip: Annotated[float, Interval(ge=0.02, le=10)] = 10.0
    bodies: Annotated[tuple[BodyName, ...], MaxLen(MOST_ITEMS)] = ("twin", "nonlinear", "linear")
    controller: Text = "lqg"
    largest: Numbers = ()
    gains: Numbers = ()
    payload: Annotated[float, Interval(ge=0, le=5)] = 0.0
    payload_height: Annotated[float, Interval(ge=0, le=1)] = 0.15
    slope: Annotated[float, Interval(ge=-0.35, le=0.35)] = 0.0
    seed: Annotated[int, Interval(ge=0, le=2**31)] = 0

    __pydantic_config__: ClassVar[dict[str, Any]] = STRICT


@message
class Hello:
    """The first message of a page: its version, the session that it had, its token and name in a class."""

    version: Whole
    session: Text = ""
    token: Text = ""
    name: Text = ""
    setup: Setup | None = None


@message
class Ack:
    """Snapshot `n` has been drawn."""

    n: Whole


@message
class Change:
    """The whole set-up, as it should be from now on."""

    setup: Setup


@message
class Drag:
    """The mouse pushes the body with `force` [N] at `height` [m] above the axle until the next such message."""

    force: Annotated[float, Interval(ge=-500, le=500)]
    height: Annotated[float, Interval(ge=-3, le=3)]


@message
class Strike:
    """A push by name: the paper's holds to a pitch [rad], an impulse [N s], or a pull at one wheel [N]."""

    what: PushName
    size: Annotated[float, Interval(ge=-100, le=100)]


@message
class Steer:
    """Roll at `speed` [m/s] and turn at `rate` [rad/s] from now on."""

    speed: Annotated[float, Interval(ge=-3, le=3)]
    rate: Annotated[float, Interval(ge=-10, le=10)]


@message
class Play:
    """Pause, or run at `speed` times wall time."""

    paused: bool
    speed: Annotated[float, Interval(ge=0.01, le=4)] = 1.0


@message
class Step:
    """While paused: go on by so many of the controller's periods."""

    periods: Annotated[int, Interval(ge=1, le=1000)] = 1


@message
class Scrub:
    """While paused: show the moment `back` [s] before now."""

    back: Annotated[float, Interval(ge=0, le=60)]


@message
class StandUp:
    """Put the robot at rest at the lean `pitch` [rad]."""

    pitch: Annotated[float, Interval(ge=-1.2, le=1.2)] = 0.0


@message
class Start:
    """Begin a job; `file` names a log that was uploaded, '' the run that is being recorded."""

    job: Job
    file: Text = ""


@message
class Cancel:
    """Kill the job."""

    job: Job


@message
class Save:
    """Make a file of the run, to be downloaded: `name` is of the uploaded log that a report also compares, or the
    student's who hands in. A report is in `language`."""

    what: Keep
    name: Text = ""
    language: Language = "en"


@message
class Recall:
    """Send the history from `since` [s] on again: this page was too slow for some of it."""

    since: Annotated[float, Interval(ge=0, le=1e9)]


@message
class Broadcast:
    """The teacher gives everyone this set-up, and stands every robot up."""

    setup: Setup


ClientMessage = (
    Hello | Ack | Change | Drag | Strike | Steer | Play | Step | Scrub | StandUp | Start | Cancel | Save | Recall
    | Broadcast
)  # fmt: skip


@message
class Catalogue:
    """What there is to choose; `names` are those of parameters, by language."""

    robots: tuple[RobotInfo, ...]
    kits: tuple[str, ...]
    families: tuple[FamilyInfo, ...]
    units: dict[str, str]
    symbols: dict[str, str]
    names: dict[str, dict[str, str]]
    largest: tuple[float, ...]
    command: dict[str, float]


@message
class Welcome:
    """The answer to `Hello`. `files` is where the session's files are asked for, `invite` the students' token."""

    version: int
    session: str
    role: Literal["alone", "student", "teacher"]
    files: str
    invite: str = ""


@message
class Refused:
    """Why this page cannot go on, and what to do; the connection is closed after it. `reason` is for pages of before,
    which know no parts."""

    reason: str
    parts: dict[str, ErrorParts]


@dataclass(frozen=True, kw_only=True)
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


@message
class Changed:
    """The set-up as it is now, what the robot looks like and what stands in each row of the snapshots."""

    _: KW_ONLY
    setup: Setup
    look: Look
    bodies: tuple[str, ...]
    period: float
    kit: dict[str, float]
    busy: bool = False


@message
class Analysed:
    """The present loop: what a design's page says of it, by language; `gain` (2, 6) where it has one, closed-loop
    poles, and `L` broken at both motors: ω [rad/s], Re and Im in three rows."""

    _: KW_ONLY
    stable: bool
    heads: dict[str, Head]
    gain: tuple[tuple[float, ...], ...]
    poles: tuple[tuple[float, ...], ...] = ()
    L: tuple[tuple[float, ...], ...] = ()


@message
class Equations:
    """The numbers of the present model: upright a11, a12, a22, a33, α, β, M g L, M L R, what a lean adds to a33, W/2R,
    and the linear model about upright."""

    _: KW_ONLY
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


@message
class Light:
    """What the certificate's page says, by language; nothing while it is computed. The `light` is "none" then, and
    where there is no certificate."""

    light: Literal["green", "amber", "red", "unknown", "none"] = "none"
    heads: dict[str, Head] = field(default_factory=dict[str, Head])


@message
class JobResult:
    """What came of a job: the page of its result as HTML, and its first screen, by language."""

    job: Job
    heads: dict[str, Head]
    html: dict[str, str]


@message
class Made:
    """A file to be downloaded under `name`."""

    name: str
    url: str


@message
class Notice:
    """What went wrong, by language, or was done: in words of the page, which `key` names. `job` is what failed, or was
    stopped where nothing is said."""

    level: Literal["info", "error"]
    parts: dict[str, ErrorParts] = field(default_factory=dict[str, ErrorParts])
    key: str = ""
    job: str = ""


@message
class Recovered:
    """Pushes of `impulse` [N s] together from which the robot came back, or `fell`; their `effort` [u² s], and the
    largest `single` push so far."""

    impulse: float
    effort: float
    best: float
    fell: bool
    single: bool


@message
class History:
    """What was recorded before: time, ψ, ψ̇, θ, θ̇, φ, φ̇ of every body in turn, then of the first its estimated ψ, both
    applied commands, and which motors were at their limit."""

    t: tuple[float, ...]
    rows: tuple[tuple[float, ...], ...]


@message
class Snapshot:
    """A moment. `x`: a row for each body with the six states, both applied commands and whether it fell; `e`: the
    first controller's estimate; `f`: push [N], its height [m], slope [rad], pull at a wheel [N]; `r`: reference wheel
    and yaw angle [rad]; `s`: 1 and 2 for the left and right motor at its limit; `back` [s]: how long ago, scrubbing."""

    _: KW_ONLY
    n: int
    t: float
    x: tuple[tuple[float, ...], ...]
    e: tuple[float, ...]
    f: tuple[float, ...]
    r: tuple[float, ...]
    s: int
    paused: bool
    back: float = 0.0


@message
class Board:
    """Everybody in the class; like a snapshot, the latest wins."""

    students: tuple[Student, ...]


ServerMessage = (
    Welcome | Refused | Changed | Analysed | Equations | Light | Progress | JobResult | Made | Notice | Recovered
    | History | Snapshot | Board | Catalogue | Acted
)  # fmt: skip
