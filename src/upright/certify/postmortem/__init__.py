"""Why a robot fell, from the last seconds of its log."""

from upright.certify.postmortem.postmortem import PostMortem as PostMortem
from upright.certify.postmortem.postmortem import post_mortem as post_mortem
from upright.certify.postmortem.verdict import Cause as Cause
