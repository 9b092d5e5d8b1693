"""The next experiment: the excitation that tells most about a robot within limits."""

from upright.identify.excite.design import excite as excite
from upright.identify.excite.plan import ExcitationPlan as ExcitationPlan
from upright.identify.excite.plan import Limits as Limits
from upright.identify.excite.plan import read_plan as read_plan
