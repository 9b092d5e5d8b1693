"""The next experiment: the excitation that tells most about a robot within limits."""

from upright.excite.design import excite as excite
from upright.excite.plan import ExcitationPlan as ExcitationPlan
from upright.excite.plan import Limits as Limits
from upright.excite.plan import read_plan as read_plan
