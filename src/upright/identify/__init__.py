"""What a log tells about the robot it came from."""

from upright.identify.regression import LeastSquares as LeastSquares
from upright.identify.regression import least_squares as least_squares
from upright.identify.regression import rebuild_states as rebuild_states
