"""Named signals and logs: the common currency of every room."""

from upright.signals.log import Log as Log
from upright.signals.signal import SIDES as SIDES
from upright.signals.signal import STATE as STATE
from upright.signals.signal import STATE_NAMES as STATE_NAMES
from upright.signals.signal import TRUE_STATE as TRUE_STATE
from upright.signals.signal import Signal as Signal
