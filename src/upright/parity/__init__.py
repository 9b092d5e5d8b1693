"""Whether a generated program does what was designed: what executes it, and the comparison."""

from upright.parity.parity import Parity as Parity
from upright.parity.parity import parity as parity
