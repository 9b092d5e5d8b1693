"""Why a robot fell, from the last seconds of its log."""

from upright.diagnose.causes import Cause as Cause
from upright.diagnose.post_mortem import PostMortem as PostMortem
from upright.diagnose.post_mortem import post_mortem as post_mortem
