"""The next experiment: the excitation that tells most about a robot within limits."""

from upright.excitation.design import excite as excite
from upright.excitation.plan import ExcitationPlan as ExcitationPlan
from upright.excitation.plan import read_plan as read_plan
from upright.excitation.planned import Limits as Limits
