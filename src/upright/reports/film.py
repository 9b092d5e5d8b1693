"""A film of runs: the robots from their side on one floor, and below them their lean and the place of their wheels.

    film({"twin": log, "linear": other}, "run.gif") → Path

The first log is the robot, the others are ghosts beside it. A GIF needs nothing else; an MP4 needs the package
imageio-ffmpeg (`pip install 'upright[film]'`).
"""

from __future__ import annotations

import io
import math
from collections.abc import Generator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon
from numpy.typing import NDArray

from upright.arrays import Array
from upright.atomic import TemporaryFolder, write_bytes
from upright.comparison import active_intervals
from upright.diagnose.post_mortem import robot_of
from upright.errors import InvalidLog, UprightError, require
from upright.languages import localised, translated
from upright.logs.raw import GYRO, RATES
from upright.plotting import COLOURS, FOOT, HEAD, INK, LEFT, RIGHT, line, numbered, span, styled
from upright.progress import Progress, unwatched
from upright.robots import Robot
from upright.robots.drawing import FLOOR, height_of, outline
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.artist import Artist


WIDTH, HEIGHT, PANEL = 9.6, 5.4, 1.35  # [inches] of the figure; height of a panel
KINDS = (".gif", ".webp", ".mp4")
FRAMES, MOST_FRAMES = 25.0, 3000  # a second; in all: two minutes at that rate, held in memory by a GIF's encoder
ROOM = 1.25  # height of the view over that of the tallest robot
HELD = 0.7  # fraction of the view within which a fixed camera shows all travel
COLOUR_COUNT = 48  # of a GIF: lines and flat areas need no more
SHOWN_PUSH = 0.15  # [s] for which an arrow is shown at least: a blow of 10 ms would be in no frame

Frame = NDArray[np.uint8]


@dataclass(frozen=True)
class _Run:
    """What a film shows of a log: lean and wheel [rad] and the axle's place [m] at the times `t` [s], and the force."""

    label: str
    robot: Robot
    t: Array
    lean: Array
    wheel: Array
    force: Array

    @property
    def x(self) -> Array:
        return self.robot.wheel_radius * self.wheel

    def at(self, time: float) -> int:
        """The row that is the last at `time`."""
        return max(0, int(np.searchsorted(self.t, time, side="right")) - 1)


def film(
    logs: Mapping[str, Log] | Log,
    path: str | Path,
    robot: Robot | None = None,
    *,
    start: float | None = None,
    stop: float | None = None,
    speed: float = 1.0,
    frames: float = FRAMES,
    width: int = 960,
    progress: Progress = unwatched,
) -> Path:
    """Write a film of `logs` to `path` (.gif, .webp or .mp4): `frames` a second, `width` pixels wide (16:9).

    `start` and `stop` [s] choose a part; `speed` 0.5 shows it at half of its speed. `robot` is the robot of all logs
    (default: each log's own). Raises `InvalidLog` for a log without lean or wheels, `UprightError` for another suffix,
    `MissingTool` where an MP4 cannot be written.
    """
    target = Path(path)
    if target.suffix.lower() not in KINDS:
        raise UprightError(f"a film is not written as '{target.suffix}'", expected=" or ".join(KINDS))
    runs = [_run(label, log, robot) for label, log in (logs if isinstance(logs, Mapping) else {"": logs}).items()]
    if not runs:
        raise InvalidLog("there is no log", expected="one or more")
    times = _times(runs, (start, stop), speed, frames)
    drawn = _Drawing(runs, (float(times[0]), float(times[-1])), width)
    return write_bytes(target, _encoded(drawn.frames(times, progress), target.suffix.lower(), frames))


def _times(runs: list[_Run], ends: tuple[float | None, float | None], speed: float, frames: float) -> Array:
    start, stop = ends
    if not (0.001 <= speed <= 1000 and 0.1 <= frames <= 100):
        raise UprightError(
            f"a speed of {speed:g} and {frames:g} pictures a second",
            expected="a speed of 0.001 to 1000, and 0.1 to 100 pictures",
        )
    step = speed / frames
    first = max(start if start is not None else -math.inf, float(runs[0].t[0]))
    last = min(stop if stop is not None else math.inf, max(float(run.t[-1]) for run in runs))
    if not last > first:
        raise InvalidLog(
            f"there is nothing between {first:g} and {last:g} s", expected=f"a part of {runs[0].t[-1]:g} s"
        )
    count = math.floor((last - first) / step) + 1
    if count > MOST_FRAMES:
        raise UprightError(
            f"the film would have {count} frames", expected=f"at most {MOST_FRAMES}", hint="--from, --until or --speed"
        )
    return np.asarray(first + step * np.arange(count), dtype=np.float64)


def _run(label: str, log: Log, robot: Robot | None) -> _Run:
    lean = next((log[name] for name in ("truth/pitch", "estimate/pitch") if name in log), None)
    lean = _swing(label, log) if lean is None else lean
    wheel = next((log[name] for name in ("truth/wheel", "estimate/wheel") if name in log), None)
    wheel = _rolled(label, log, lean) if wheel is None else wheel
    force = log["push/force"] if "push/force" in log else np.zeros(len(log))
    return _Run(label, robot or robot_of(log), log.t, _filled(label, lean), _filled(label, wheel), np.nan_to_num(force))


def _filled(label: str, values: Array) -> Array:
    """`values` with a straight line over rows that hold no number."""
    good = np.isfinite(values)
    rows = np.arange(len(values))
    if not good.any():
        raise InvalidLog(f"{_called(label)} has no numbers where its lean and wheels should be")
    return values if good.all() else np.interp(rows, rows[good], values[good])


def _swing(label: str, log: Log) -> Array:
    """The lean by integrating the gyro without its mean, since a robot that balances does not turn on."""
    if GYRO not in log:
        raise InvalidLog(f"{_called(label)} has no {GYRO}", expected="a lean, or a gyro")
    rate = log[GYRO] - np.median(log[GYRO])
    return np.asarray(np.cumsum(rate * np.diff(log.t, prepend=log.t[0])), dtype=np.float64)


def _rolled(label: str, log: Log, lean: Array) -> Array:
    """The wheels' mean angle by the encoders, which sit on the body."""
    sides: list[Array] = []
    for angle, rate in RATES.items():
        if angle in log:
            sides.append(log[angle])
        elif rate in log:
            sides.append(np.cumsum(log[rate] * np.diff(log.t, prepend=log.t[0])))
    if not sides:
        raise InvalidLog(f"{_called(label)} has no encoder", expected="the angle or rate of one wheel at least")
    return np.asarray(np.mean(sides, axis=0) + lean, dtype=np.float64)


def _called(label: str) -> str:
    return f"log '{label}'" if label else "the log"


class _Artists:
    """One robot that moves: a body, a wheel and its hand."""

    def __init__(self, ax: Axes, run: _Run, colour: str, ghost: bool) -> None:
        self.run = run
        shown: dict[str, Any] = {"animated": True, "zorder": 2 if ghost else 3}
        self.body = Polygon(
            [(0, 0)] * 4, facecolor=colour, alpha=0.15 if ghost else 0.35, edgecolor=colour, linewidth=1.4, **shown
        )
        dashes = (0, (3, 2)) if ghost else "-"
        self.wheel = Circle((0, 0), run.robot.wheel_radius, fill=False, edgecolor=colour, linewidth=1.6, **shown)
        self.wheel.set_linestyle(dashes)
        self.body.set_linestyle(dashes)
        ax.add_patch(self.body)
        ax.add_patch(self.wheel)
        (self.hand,) = ax.plot([], [], color=colour, linewidth=1.4, **shown)

    def place(self, row: int, camera: float) -> list[Artist]:
        robot = self.run.robot
        x = float(self.run.x[row]) - camera
        lean = float(self.run.lean[row])
        turned = float(self.run.wheel[row])
        radius = robot.wheel_radius
        self.body.set_xy(outline(robot, lean, x))
        self.wheel.set_center((x, radius))
        self.hand.set_data([x, x + radius * math.sin(turned)], [radius, radius + radius * math.cos(turned)])
        return [self.body, self.wheel, self.hand]


class _Drawing:
    """The figure of a film: what stands still is drawn once, the rest into each frame."""

    def __init__(self, runs: list[_Run], times: tuple[float, float], width: int) -> None:
        self.figure, self.scene, traces = scene((translated("pitch [rad]"), translated("position [m]")), times)
        self.figure.set_dpi(max(160, min(width, 3840)) / self.figure.get_figwidth())
        self.runs = runs
        tall = max(2 * run.robot.wheel_radius + height_of(run.robot) for run in runs)
        box = self.scene.get_position()
        aspect = box.width * self.figure.get_figwidth() / (box.height * self.figure.get_figheight())
        self.half = ROOM * tall * aspect / 2
        below = 0.12 * tall
        self.scene.set(xlim=(-self.half, self.half), ylim=(-below, ROOM * tall - below))
        self.scene.axhline(0, color=INK, linewidth=1)
        rows = [slice(run.at(times[0]), run.at(times[1]) + 1) for run in runs]
        travel = np.concatenate([run.x[part] for run, part in zip(runs, rows, strict=True)])
        middle = (float(travel.min()) + float(travel.max())) / 2
        self.fixed = middle if np.ptp(travel) < 2 * HELD * self.half else None
        for run, part in zip(runs, rows, strict=True):
            line(traces[0], run.label, run.t[part], run.lean[part])
            line(traces[1], run.label, run.t[part], run.x[part])
        if any(run.label for run in runs):
            self.figure.legend(*traces[0].get_legend_handles_labels(), loc="upper right", ncols=min(len(runs), 4))
        self.pushes = active_intervals(runs[0].t, runs[0].force)
        for begin, end in self.pushes:
            span(traces, begin, min(end, float(runs[0].t[-1])), "push")
        ghosts = [(run, COLOURS[i % len(COLOURS)], i > 0) for i, run in enumerate(runs)]
        self.robots = [_Artists(self.scene, run, colour, ghost) for run, colour, ghost in reversed(ghosts)]
        (self.marks,) = self.scene.plot([], [], color=INK, linewidth=1, animated=True)
        self.arrow = self.scene.annotate(
            "", (0, 0), (0, 0), arrowprops={"arrowstyle": "-|>", "color": COLOURS[1], "linewidth": 2}, animated=True
        )
        self.clock = self.scene.text(0.01, 0.94, "", transform=self.scene.transAxes, animated=True, va="top")
        self.cursors = [ax.axvline(times[0], color=INK, linewidth=1, animated=True) for ax in traces]
        self.canvas = FigureCanvasAgg(self.figure)
        self.canvas.draw()
        self.still: Any = self.canvas.copy_from_bbox(self.figure.bbox)  # pyright: ignore[reportAttributeAccessIssue]

    def frames(self, times: Array, progress: Progress) -> Generator[Frame]:
        """The pictures at `times` [s]."""
        for k, time in enumerate(times.tolist(), start=1):
            yield self.frame(time)
            progress(k / len(times))

    def frame(self, time: float) -> Frame:
        """The picture at `time` [s], (height, width, 3)."""
        self.canvas.restore_region(self.still)  # pyright: ignore[reportAttributeAccessIssue]
        lead = self.runs[0]
        camera = float(lead.x[lead.at(time)]) if self.fixed is None else self.fixed
        moving: list[Artist] = [self._floor(camera)]
        for robot in self.robots:
            moving += robot.place(robot.run.at(time), camera)
        moving += self._push(time, camera)
        self.clock.set_text(localised(f"{time:.1f} s"))
        for cursor in self.cursors:
            cursor.set_xdata([time, time])
        for artist in (*moving, self.clock, *self.cursors):
            (artist.axes or self.scene).draw_artist(artist)
        return np.asarray(self.canvas.buffer_rgba())[..., :3].copy()

    def _floor(self, camera: float) -> Artist:
        """Marks on the floor every 5 cm, each second one longer, so that rolling is seen."""
        first = math.ceil((camera - self.half) / FLOOR)
        last = math.floor((camera + self.half) / FLOOR)
        x = np.repeat(FLOOR * np.arange(first, last + 1) - camera, 3)
        deep = self.scene.get_ylim()[0]
        y = np.array([part for k in range(first, last + 1) for part in (0, deep * (0.35 if k % 2 else 0.6), np.nan)])
        self.marks.set_data(x, y)
        return self.marks

    def _push(self, time: float, camera: float) -> list[Artist]:
        run = self.runs[0]
        near = [(a, b) for a, b in self.pushes if a <= time <= max(b, a + SHOWN_PUSH)]
        if not near:
            return []
        row = run.at(near[0][0])
        direction = math.copysign(1.0, float(run.force[row]) or 1.0)
        now = run.at(time)
        robot = run.robot
        lean = float(run.lean[now])
        x = float(run.x[now]) - camera
        tip = (x + robot.com_height * math.sin(lean), robot.wheel_radius + robot.com_height * math.cos(lean))
        self.arrow.xy = tip
        self.arrow.set_position((tip[0] - direction * 0.3 * self.half, tip[1]))
        return [self.arrow]


@styled
def scene(labels: tuple[str, str], times: tuple[float, float]) -> tuple[Figure, Axes, list[Axes]]:
    """A figure of 16:9: a plane to one scale above two panels over `times` [s] beside each other."""
    figure = Figure(figsize=(WIDTH, HEIGHT), facecolor="white")
    low = (FOOT + PANEL + HEAD) / HEIGHT
    plane = figure.add_axes((0.0, low, 1.0, 1.0 - low))
    plane.set_axis_off()
    each = (WIDTH / 2 - LEFT - RIGHT) / WIDTH
    panels = list[Axes]()
    for k, label in enumerate(labels):
        ax = figure.add_axes((k / 2 + LEFT / WIDTH, FOOT / HEIGHT, each, PANEL / HEIGHT))
        ax.set_xlim(times[0], max(times[1], math.nextafter(times[0], math.inf)))
        ax.set_title(label)
        ax.set_xlabel(translated("time [s]"), loc="right")
        numbered(ax.xaxis, ax.yaxis)
        panels.append(ax)
    return figure, plane, panels


def _encoded(pictures: Generator[Frame], suffix: str, frames: float) -> bytes:
    if suffix == ".mp4":
        return _mp4(pictures, frames)
    from PIL import Image

    images = (Image.fromarray(picture) for picture in pictures)
    first = next(images)
    stream = io.BytesIO()
    held = round(1000 / frames)  # [ms]
    options: dict[str, Any] = {"save_all": True, "duration": held, "loop": 0}
    if suffix == ".gif":
        first = first.quantize(COLOUR_COUNT)
        palette = first
        images = (image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images)
        options |= {"optimize": True, "duration": 10 * max(2, round(held / 10))}  # a GIF counts hundredths of a second
    first.save(stream, suffix[1:], append_images=images, **options)
    return stream.getvalue()


def _mp4(pictures: Generator[Frame], frames: float) -> bytes:
    require("a film as .mp4", "imageio_ffmpeg")
    import imageio_ffmpeg  # pyright: ignore[reportMissingTypeStubs]

    first = next(pictures)
    height, width = (side - side % 2 for side in first.shape[:2])  # H.264 halves the resolution of colours
    folder = TemporaryFolder()
    with folder:
        target = folder.path / "film.mp4"
        rate: Any = frames  # any number, whatever the package's annotation says
        writer = imageio_ffmpeg.write_frames(str(target), (width, height), fps=rate, macro_block_size=2)
        writer.send(None)
        writer.send(np.ascontiguousarray(first[:height, :width]))
        for picture in pictures:
            writer.send(np.ascontiguousarray(picture[:height, :width]))
        writer.close()
        return target.read_bytes()
