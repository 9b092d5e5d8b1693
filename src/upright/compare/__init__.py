"""Numbers from logs: what one run shows, and how two runs differ."""

from upright.compare.comparison import Comparison as Comparison
from upright.compare.comparison import Metrics as Metrics
from upright.compare.comparison import compare as compare
from upright.compare.metrics import Peak as Peak
from upright.compare.metrics import active_intervals as active_intervals
from upright.compare.metrics import effort as effort
from upright.compare.metrics import nrmse_fit as nrmse_fit
from upright.compare.metrics import overshoot as overshoot
from upright.compare.metrics import peak as peak
from upright.compare.metrics import rms as rms
from upright.compare.metrics import saturated_share as saturated_share
from upright.compare.metrics import settling_time as settling_time
