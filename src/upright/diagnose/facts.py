"""Plain facts of a fall: commands and readings that stood still, commands that were changed by an exact number, lost
rows."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from upright.checkup.finding import instant, plain
from upright.diagnose.causes import DEAD, DROPPED, HIGH, JAMMED, LOW, NONE, OFF, SATURATION, STUCK, Blow
from upright.diagnose.chances import PEGGED, fits_badly, sound_until, step, toppled, unexplained
from upright.diagnose.evidence import Evidence
from upright.diagnose.fall import USUALLY_HELD
from upright.diagnose.words import ALMOST, began, percent, sensor
from upright.pages import Quantity, Say

FACT = 0.98  # probability of what the commands themselves show
GAIN_STEP = 0.03  # |ln| of a gain from which it is another one
BEFORE = 0.1  # [s] by which a sensor stands still before the commands do: after that it is the loop that stood
EXACT = 0.9999  # fraction of the difference between commands and file that a changed gain explains
LOST_ROWS, LOST_WIDTH = 0.14, 0.02  # fraction of periods without a row that these robots' loops hardly survive
FEW_LOST = 0.05  # below which lost rows are no cause
LOST_BEFORE = 1.2  # times the fraction before: a loop that always loses so many rows has survived them
IDLE = 0.3  # of the probability of a wheel that stands still, for a motor without torque: a log shows no difference
TEMPER = 6.0  # nats that count as one between two faults: neighbouring rows share what is wrong with the model


LAST, USUAL = 0.05, 0.98  # [s] before commands end, and the quantile of the pitch rates that are usual till then
FEWEST_BALANCING = 100  # rows with commands, of which the pitch rate is taken for usual
TURNED = 0.3  # [rad] least turn of the body, after commands ended, that is its fall


@dataclass(frozen=True)
class Answer:
    """What one question gives for a cause before it is weighed against the others."""

    probability: float
    name: str
    onset: float
    evidence: Say
    push: Blow | None = None


def switched_off(evidence: Evidence) -> list[Answer]:
    """Whether both commands are 0 from a time before the fall to the last row. A program that gives up a robot which
    falls already does so as the body turns faster than it does while it balances, or where its readings are wrong; one
    that put out nothing for a third as long before may do so again."""
    log, asked = evidence.run.log, evidence.run.asked
    working = np.flatnonzero(asked.any(axis=1))
    if not len(working) or working[-1] + 1 >= len(log):
        return []
    since = float(log.t[working[-1] + 1])
    began_at = float(log.t[working[0]])
    rate = np.abs(log["sensor/gyro"])
    idle = float(np.diff(log.t[working]).max(initial=0.0))
    balancing = (log.t >= began_at) & (log.t < since)
    last = (log.t >= since - LAST) & (log.t <= since)
    falling = (log.t >= since) & (log.t <= evidence.fell_at)
    if balancing.sum() < FEWEST_BALANCING or evidence.fell_at - since < USUALLY_HELD * idle:
        return []
    turned = abs(float(np.nansum(log["sensor/gyro"][falling]))) * log.period
    if np.nanmedian(rate[last]) > np.nanquantile(rate[balancing], USUAL) or turned < TURNED:
        return []
    text = Say("Both commands are 0 from {since} to the last row, before the body turned fast.", since=instant(since))
    return [Answer(FACT * sound_until(evidence, since), OFF, since, text)]


def stuck(evidence: Evidence) -> list[Answer]:
    """Whether the motors got one and the same command all through the fall. That commands stood still is plain; that
    they did before the fall, and could have stopped it, follows from a lean that the filter has only of a sound robot:
    a program may stand still because its robot fell."""
    held = evidence.motors.held
    still = evidence.stuck
    if held is not None and still is not None and still.start < held[0] - BEFORE:  # commands follow what it shows
        held = None
    if held is not None and not evidence.motors.pegged > PEGGED:
        start, stop = map(instant, held)
        text = Say(
            "Both commands stood still from {start} to {stop}, while they could have saved it.", start=start, stop=stop
        )
        return [Answer(FACT * sound_until(evidence, held[0]), DROPPED, held[0], text)]
    if not evidence.motors.stuck or (still is not None and still.start < began(evidence) - BEFORE):
        return []
    seconds = Quantity(evidence.excursion, "s", digits=2)
    if not evidence.motors.pegged > PEGGED:
        text = Say("No command changed in the last {seconds} of the fall: the loop did not run.", seconds=seconds)
        return [Answer(FACT * sound_until(evidence, began(evidence)), DROPPED, began(evidence), text)]
    text = Say("No command changed in the last {seconds} of the fall: the motors were at their limit.", seconds=seconds)
    # motors that are at their limit because something else changed, or by a push that topples, are no cause
    changed = max(fits_badly(evidence, evidence.pushes_only.nis), toppled(evidence)[0])
    return [Answer(FACT * (1 - changed), SATURATION, began(evidence), text)]


def stuck_sensor(evidence: Evidence) -> list[Answer]:
    """Whether a sensor gave one and the same reading up to the fall, while another moved."""
    still = evidence.stuck
    if still is None:
        return []
    seconds = Quantity(evidence.fell_at - still.start, "s", digits=2)
    facts = {"sensor": sensor(still.channel), "reading": plain(still.reading), "seconds": seconds}
    text = Say("The {sensor} reads {reading} in all of the last {seconds}, while the wheels turn.", **facts)
    if still.clipped or still.beyond:
        ends = Say("The {sensor} reads {reading} in all of the last {seconds}: its range ends there.", **facts)
        return [Answer(FACT, NONE, still.start, ends)]
    if evidence.jam is None:
        return [Answer(FACT, STUCK, still.start, text)]
    held, blind, leaves = evidence.jam
    side = "left" if still.channel.endswith("left") else "right"
    dead_ones = [fit for fit in evidence.fits if fit.fault == "motor" and (side in fit.way or "both" in fit.way)]
    idle, left = max(((fit.score, fit.nis) for fit in dead_ones), default=(-math.inf, math.inf))
    leaves = left if idle > max(held, blind) else leaves
    jammed = step(max(held, idle) - blind, TEMPER)
    dead = IDLE * step(idle - held, TEMPER)
    facts |= {"nats": plain(max(held, idle) - blind)}
    jam = Say("A held wheel explains the motion better than a stuck {sensor}, by {nats} nats.", **facts)
    no_torque = Say("A motor without torque explains the motion better than a stuck {sensor}, by {nats} nats.", **facts)
    unknown = unexplained(evidence, leaves)
    more = Say("The {sensor} stands still, but something else is wrong, too (NIS {nis}).", **facts, nis=plain(leaves))
    known = FACT * (1 - unknown)
    return [
        Answer(known * (1 - jammed), STUCK, still.start, text),
        Answer(known * jammed * (1 - dead), JAMMED, still.start, jam),
        Answer(known * jammed * dead, DEAD, still.start, no_torque),
        Answer(FACT * unknown, NONE, still.start, more),
    ]


def changed_gain(evidence: Evidence) -> list[Answer]:
    """Whether the recorded commands are the file's times a number."""
    match = evidence.match
    if match is None or match.explained < EXACT or abs(math.log(max(match.gain, 1e-9))) < GAIN_STEP:
        return []
    text = Say(
        "The commands are {gain} times those of the controller's file on the same readings.",
        gain=plain(match.gain),
        explained=Quantity(min(match.explained, ALMOST), "fraction"),
        misfit=percent(match.misfit),
    )
    return [Answer(FACT, LOW if match.gain < 1 else HIGH, began(evidence), text)]


def lost_rows(evidence: Evidence) -> list[Answer]:
    """Whether the loop did not run."""
    lost, before, since = evidence.lost
    if lost <= LOST_BEFORE * before and before > LOST_ROWS / 2:
        lost = min(lost, LOST_ROWS)
    if lost <= FEW_LOST:
        return []
    text = Say(
        "Since {since} {part} of the periods have no row, before that {before}: the loop did not run.",
        since=instant(since),
        part=percent(lost),
        before=percent(before),
    )
    return [Answer(step(lost - LOST_ROWS, LOST_WIDTH), DROPPED, since, text)]
