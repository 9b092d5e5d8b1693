"""A program on a brick: upload, start, follow, fetch the log."""

from upright.flight.flight import Flight as Flight
from upright.flight.fly import fetch as fetch
from upright.flight.fly import fly as fly
from upright.flight.follow import follow as follow
