"""Figures and pages from numbers that other rooms computed."""

from upright.report.comparing import comparison_page as comparison_page
from upright.report.figure import Figure as Figure
from upright.report.figure import Panel as Panel
from upright.report.figure import PointFigure as PointFigure
from upright.report.figure import PointSet as PointSet
from upright.report.figure import Trace as Trace
from upright.report.page import Maths as Maths
from upright.report.page import Page as Page
from upright.report.page import Section as Section
from upright.report.page import Table as Table
from upright.report.page import Verdict as Verdict
