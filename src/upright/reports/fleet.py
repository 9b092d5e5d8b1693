"""Pages of push maps and basins, and of a fleet's saved results."""

from __future__ import annotations

from typing import TYPE_CHECKING

from upright.reports.basins import basin_page
from upright.reports.maps import push_map_page
from upright.reports.page import Page

if TYPE_CHECKING:
    from xarray import Dataset


def page_of(result: Dataset) -> Page:
    """The page of a push map or a basin, not yet written."""
    return push_map_page(result) if "impulse" in result else basin_page(result)
