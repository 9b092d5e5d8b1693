"""Linear models from a log by the paper's and the field's methods, with intervals, judged in the loop."""

from upright.identification.identify import identify as identify
from upright.identification.identify import identify_all as identify_all
from upright.identification.identify import study_of as study_of
from upright.identification.methods import IDENTIFIERS as IDENTIFIERS
