"""Whether a generated program does what was designed: its executors, and the comparison."""

from upright.execution.parity import Parity as Parity
from upright.execution.parity import executed_parity as executed_parity
from upright.execution.parity import parity as parity
