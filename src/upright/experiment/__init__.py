"""Pushes, references, and `run`: the one loop in which a body meets a controller."""

from upright.experiment.outcome import RunOutcome as RunOutcome
from upright.experiment.outcome import motionless as motionless
from upright.experiment.outcome import outcome_of as outcome_of
from upright.experiment.outcome import undisturbed as undisturbed
from upright.experiment.pushes import Hold as Hold
from upright.experiment.pushes import Impulse as Impulse
from upright.experiment.pushes import Push as Push
from upright.experiment.pushes import Slope as Slope
from upright.experiment.references import Drive as Drive
from upright.experiment.references import Turn as Turn
from upright.experiment.run import run as run
