"""Linear models from a log by the paper's and the field's methods, with intervals, judged in the loop."""

from upright.identify.identify import identify as identify
from upright.identify.identify import identify_all as identify_all
from upright.identify.identify import study_of as study_of
from upright.identify.methods import IDENTIFIERS as IDENTIFIERS
