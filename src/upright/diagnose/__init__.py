"""Why a robot fell, from the last seconds of its log."""

from upright.diagnose.post_mortem import PostMortem as PostMortem
from upright.diagnose.post_mortem import post_mortem as post_mortem
from upright.diagnose.verdict import Cause as Cause
