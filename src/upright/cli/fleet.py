"""`upright fleet`, `push-map`, `basin` and `sweep`: many robots at once."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from upright.cli import options
from upright.cli.fleet_options import Asked, asked_alike
from upright.cli.options import (
    DriveOption,
    JsonOption,
    PushOption,
    ReportOption,
    StartOption,
    TurnOption,
)
from upright.cli.output import check_targets, finish, progress
from upright.errors import InvalidScenario
from upright.fleets.usual import BASIN_POINTS, FLEET, MAP_POINTS, MAP_ROBOTS

if TYPE_CHECKING:
    from upright.fleets.ensemble import Ensemble
    from upright.fleets.fleet import Fleet
    from upright.fleets.maps import Basin, PushMap


WAYS = {"forward": (1,), "backward": (-1,), "both": (1, -1)}
"""Direction of a push → its signs."""


def _default(sizes: tuple[int, int]) -> str:
    compiled, called = sizes
    return f" (default: {compiled}; {called} of a controller called in Python)"


@asked_alike
def fleet(
    *,
    asked: Asked,
    samples: Annotated[
        int | None,
        typer.Option("--samples", "-n", min=1, max=options.MOST_ROBOTS, help=f"Robots drawn{_default(FLEET)}."),
    ] = None,
    push: PushOption = None,
    drive: DriveOption = None,
    turn: TurnOption = None,
    start: StartOption = "",
    seconds: Annotated[float, typer.Option("--seconds", "-s", help="Length of each run [s].")] = 10.0,
) -> None:
    """Simulate many different robots and count the falls.

    Prints the probability of a fall with its 95 % interval, and quantiles of pitch, settling, effort and travel.
    """
    from upright.fleets.fleet import fleet as simulate

    asked.check()
    pushes, references = map(tuple, options.pushes_and_references(push, drive, turn))
    ensemble = asked.ensemble(pushes=pushes, references=references, start=_state(start), seconds=seconds)
    number = FLEET[ensemble.called] if samples is None else samples
    _say_how_long(asked, ensemble, {f"-n {n}": n * seconds for n in (number, *FLEET)})
    with progress("simulating") as show:
        result = simulate(ensemble, number, threads=asked.threads, progress=show)
    _finish(result, asked)


@asked_alike
def push_map(
    *,
    asked: Asked,
    direction: Annotated[
        str, typer.Option(help="Direction: forward, backward or both.", autocompletion=options.completed(lambda: WAYS))
    ] = "both",
    heights: Annotated[
        str | None, typer.Option(metavar="LOW..HIGH", help="Height above the axle [m] (default: up to the body's).")
    ] = None,
    durations: Annotated[str, typer.Option(metavar="LOW..HIGH", help="Duration of the push [s].")] = "0.01..0.5",
    points: Annotated[
        int | None, typer.Option(min=2, max=1000, help=f"Number of heights, and of durations{_default(MAP_POINTS)}.")
    ] = None,
    samples: Annotated[
        int | None,
        typer.Option(
            "--samples", "-n", min=0, max=100_000, help=f"Robots drawn for the band; 0: none{_default(MAP_ROBOTS)}."
        ),
    ] = None,
    tolerance: Annotated[float, typer.Option(help="Relative accuracy of each impulse.")] = 0.01,
    watch: Annotated[float, typer.Option(help="Time to stand after the push [s], to count as recovered.")] = 5.0,
) -> None:
    """Find the largest push a robot recovers from.

    By direction, height and duration, with a 95 % band over the uncertain parameters (default: --vary spread). A search
    that Ctrl-C stops leaves nothing: fewer --points and -n take less time.
    """
    import numpy as np

    from upright.fleets.push_map import PushGrid, robot_seconds
    from upright.fleets.push_map import push_map as search

    asked.check()
    if direction not in WAYS:
        raise InvalidScenario(f"--direction {direction}", expected=" or ".join(WAYS))
    ensemble = asked.ensemble(vary=() if asked.posterior else ("spread",))
    ranges = [
        _range(heights or f"0..{ensemble.family.robot.body_height}", "--heights"),
        _range(durations, "--durations"),
    ]

    def grid_of(each: int) -> PushGrid:
        heights, lasting = (np.linspace(*ends, each) for ends in ranges)
        return PushGrid(directions=WAYS[direction], heights=heights, durations=lasting)

    count = MAP_POINTS[ensemble.called] if points is None else points
    drawn = MAP_ROBOTS[ensemble.called] if samples is None else samples
    grid = grid_of(count)
    sizes = ((count, drawn), *zip(MAP_POINTS, MAP_ROBOTS, strict=True))
    work = {
        f"--points {p} -n {n}": robot_seconds(ensemble, grid_of(p), n, tolerance=tolerance, watch=watch)
        for p, n in sizes
    }
    _say_how_long(asked, ensemble, work)
    with progress("searching") as show:
        result = search(
            ensemble, grid, samples=drawn, tolerance=tolerance, watch=watch, threads=asked.threads, progress=show
        )
    _finish(result, asked)


@asked_alike
def basin(
    *,
    asked: Asked,
    across: Annotated[str, typer.Option(metavar="STATE=LOW..HIGH", help="First state.")] = "pitch=-1..1",
    up: Annotated[str, typer.Option(metavar="STATE=LOW..HIGH", help="Second state.")] = "pitch_rate=-10..10",
    points: Annotated[
        int | None, typer.Option(min=2, max=3000, help=f"Number of values of each state{_default(BASIN_POINTS)}.")
    ] = None,
    samples: Annotated[
        int, typer.Option("--samples", "-n", min=1, max=100_000, help="Robots drawn at each point; 1: nominal.")
    ] = 1,
    start: StartOption = "",
    seconds: Annotated[float, typer.Option("--seconds", "-s", help="Time to stand [s], to count as recovered.")] = 5.0,
) -> None:
    """Find the states from which a robot recovers.

    On a grid of any two of the six states; with samples, the fraction of the robots that recover.
    """
    from upright.fleets.basin import Axis
    from upright.fleets.basin import basin as cut

    asked.check()
    axes = [_axis(across, "--across"), _axis(up, "--up")]
    ensemble = asked.ensemble(start=_state(start), seconds=seconds)
    number = BASIN_POINTS[ensemble.called] if points is None else points
    first, second = (Axis(name, low, high, number) for name, low, high in axes)
    _say_how_long(asked, ensemble, {f"--points {p}": p * p * samples * seconds for p in (number, *BASIN_POINTS)})
    with progress("simulating") as show:
        result = cut(ensemble, first, second, samples=samples, threads=asked.threads, progress=show)
    _finish(result, asked)


def sweep(
    spec: Annotated[Path, typer.Argument(help="Campaign in TOML (see docs/fleet.md).")],
    *,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder of the results (default: the file's name).")
    ] = None,
    cluster: Annotated[
        str | None, typer.Option("--cluster", metavar="ADDRESS", help="Dask scheduler, such as tcp://host:8786.")
    ] = None,
    workers: Annotated[
        int | None,
        typer.Option(
            "--workers", min=0, max=1024, help="Processes on this machine (default: one per processor); 0: none."
        ),
    ] = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Run a campaign of robots, controllers and scenarios.

    Runs in chunks, in several processes. A stopped campaign goes on from its finished chunks when it is started again.
    """
    from upright.fleets.campaign import run_campaign
    from upright.fleets.sweep import read_campaign

    check_targets(report)
    campaign = read_campaign(spec)
    place = output or spec.with_suffix("")
    with progress("campaign") as show:
        cases = run_campaign(
            campaign, place, workers=workers, cluster=cluster, progress=lambda done, total, _: show(done / total)
        )
    finish(cases, as_json, page=report, written=(place,), folder=str(place))


def _say_how_long(asked: Asked, ensemble: Ensemble, work: Mapping[str, float]) -> None:
    """Before a controller is called in Python: how long what is asked takes on this machine, and the usual sizes.

    `work` has the options of each size and its robot seconds, what is asked first.
    """
    if not ensemble.called:
        return
    pace = ensemble.pace()
    (chosen, own), *others = ((options, _clock(pace * seconds)) for options, seconds in work.items())
    instead = "".join(f"; {options}: {time}" for options, time in others)
    typer.echo(f"{asked.controller} is called in Python, not compiled. {chosen}: {own}{instead}", err=True)


def _clock(seconds: float) -> str:
    for unit, length in (("h", 3600.0), ("min", 60.0)):
        if seconds >= 2 * length:
            return f"about {seconds / length:.0f} {unit}"
    return f"about {max(1.0, seconds):.0f} s"


def _state(text: str) -> tuple[float, ...]:
    from upright.signals import STATE_NAMES

    return tuple(options.vector(text, STATE_NAMES, "--start"))


def _range(text: str, option: str) -> tuple[float, float]:
    low, dots, high = text.partition("..")
    if not dots:
        raise InvalidScenario(f"{option} '{text}'", expected="LOW..HIGH, such as 0..0.1")
    return options.number(low, option), options.number(high, option)


def _axis(text: str, option: str) -> tuple[str, float, float]:
    name, _, ends = (part.strip() for part in text.partition("="))
    return (name, *_range(ends, option))


def _finish(result: Fleet | PushMap | Basin, asked: Asked) -> None:
    from upright.fleets.results import save

    if asked.output:
        save(result.data, asked.output)
    finish(result, asked.as_json, page=asked.report, written=[asked.output])
