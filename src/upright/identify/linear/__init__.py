"""Linear models from a log by the paper's and the field's methods, with intervals, judged in the loop."""

from upright.identify.linear.methods import IDENTIFIERS as IDENTIFIERS
from upright.identify.linear.side_by_side import identify as identify
from upright.identify.linear.side_by_side import identify_all as identify_all
from upright.identify.linear.side_by_side import study_of as study_of
