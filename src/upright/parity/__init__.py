"""Whether a generated program does what was designed: its executors, and the comparison."""

from upright.parity.parity import Parity as Parity
from upright.parity.parity import executed_parity as executed_parity
from upright.parity.parity import parity as parity
