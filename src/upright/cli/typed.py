"""What was typed: the words of the command that runs, and its parameters by name."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextvars import ContextVar
from types import MappingProxyType
from typing import Any

TYPED: ContextVar[Sequence[str]] = ContextVar("TYPED", default=())
"""The arguments of the command that runs."""

GIVEN: ContextVar[Mapping[str, Any]] = ContextVar("GIVEN", default=MappingProxyType({}))
"""Its parameters that were typed, by their names in Python, as values."""
