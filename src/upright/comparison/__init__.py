"""Numbers from logs: what one run shows, and how two runs differ."""

from upright.comparison.comparison import Comparison as Comparison
from upright.comparison.comparison import compare as compare
from upright.comparison.metrics import Peak as Peak
from upright.comparison.metrics import active_intervals as active_intervals
from upright.comparison.metrics import effort as effort
from upright.comparison.metrics import nrmse_fit as nrmse_fit
from upright.comparison.metrics import overshoot as overshoot
from upright.comparison.metrics import peak as peak
from upright.comparison.metrics import rms as rms
from upright.comparison.metrics import saturated_fraction as saturated_fraction
from upright.comparison.metrics import settling_time as settling_time
from upright.comparison.runs import Metrics as Metrics
