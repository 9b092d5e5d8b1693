"""A log is a value: copied, read-only, compared by content, and impossible to make wrongly."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

from upright.errors import InvalidLog
from upright.signals import STATE_NAMES, Log, Signal


@pytest.fixture
def log() -> Log:
    return Log(
        [0.0, 0.1, 0.2], {"truth/pitch": [1.0, 2.0, 3.0], "mine": [0.0, np.nan, -1.0]}, {"mine": "N m"}, {"a": 1}
    )


def test_a_log_does_not_share_memory_with_what_it_was_made_of() -> None:
    t, pitch, origin = np.array([0.0, 1.0]), np.array([5.0, 6.0]), {"seeds": [1]}
    log = Log(t, {"truth/pitch": pitch}, origin=origin)
    t[0], pitch[0] = -9.0, -9.0
    origin["seeds"].append(2)
    assert log.t.tolist() == [0.0, 1.0]
    assert log["truth/pitch"].tolist() == [5.0, 6.0]
    assert log.origin == {"seeds": [1]}


def test_its_arrays_cannot_be_written(log: Log) -> None:
    for array in (log.t, log["truth/pitch"]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


def test_equal_content_is_equal_and_nan_equals_nan(log: Log) -> None:
    assert log == Log(log.t, dict(reversed(log.channels.items())), log.units, log.origin)


@pytest.mark.parametrize(
    "other",
    [
        Log([0.0, 0.1, 0.3], {"a": [1, 2, 3]}, {"a": "V"}, {"seed": 1}),
        Log([0.0, 0.1, 0.2], {"a": [1, 2, 4]}, {"a": "V"}, {"seed": 1}),
        Log([0.0, 0.1, 0.2], {"a": [1, 2, np.nan]}, {"a": "V"}, {"seed": 1}),
        Log([0.0, 0.1, 0.2], {"b": [1, 2, 3]}, {"b": "V"}, {"seed": 1}),
        Log([0.0, 0.1, 0.2], {"a": [1, 2, 3]}, {"a": "A"}, {"seed": 1}),
        Log([0.0, 0.1, 0.2], {"a": [1, 2, 3]}, {"a": "V"}, {"seed": 2}),
        Log([0.0, 0.1], {"a": [1, 2]}, {"a": "V"}, {"seed": 1}),
        "not a log",
    ],
    ids=["time", "value", "NaN", "name", "unit", "origin", "length", "kind"],
)
def test_any_difference_makes_logs_unequal(other: object) -> None:
    assert Log([0.0, 0.1, 0.2], {"a": [1, 2, 3]}, {"a": "V"}, {"seed": 1}) != other


def test_between_keeps_the_start_and_leaves_out_the_stop(log: Log) -> None:
    part = log.between(0.1, 0.2)
    assert part == Log([0.1], {"truth/pitch": [2.0], "mine": [np.nan]}, {"mine": "N m"}, {"a": 1})
    with pytest.raises(InvalidLog, match="no samples"):
        log.between(5.0, 6.0)


def test_the_period_is_the_median_step() -> None:
    # One dropped sample in ten must not shift it, as it would the mean (0.011).
    t = np.delete(np.arange(12) * 0.01, 5)
    assert Log(t, {}).period == pytest.approx(0.01, rel=1e-12)  # rounding of the products by 0.01
    with pytest.raises(InvalidLog, match="single sample"):
        _ = Log([0.0], {}).period


def test_the_state_is_in_the_papers_order_whatever_the_order_of_the_channels() -> None:
    channels = {f"truth/{name}": [float(i), i + 0.5] for i, name in enumerate(STATE_NAMES)}
    state = Log([0.0, 0.1], dict(reversed(channels.items()))).state()
    assert state.tolist() == [[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], [0.5, 1.5, 2.5, 3.5, 4.5, 5.5]]


def test_a_missing_state_is_named_and_truth_is_never_put_for_an_estimate() -> None:
    log = Log([0.0], {f"truth/{name}": [0.0] for name in STATE_NAMES})
    with pytest.raises(InvalidLog, match="no channel 'estimate/pitch'"):
        log.state("estimate")


def test_units_come_from_the_catalogue_unless_said(log: Log) -> None:
    assert (log.unit("truth/pitch"), log.unit("mine")) == ("rad", "N m")
    assert Log([0.0], {"truth/pitch": [0.0], "other": [0.0]}, {"truth/pitch": "deg"}).units == {
        "truth/pitch": "deg",
        "other": "",
    }
    assert log.signal("truth/pitch") == Signal("truth/pitch", "rad", "ψ")
    with pytest.raises(InvalidLog, match="no channel 'yours'; expected one of mine, truth/pitch"):
        log.unit("yours")


def test_it_has_a_length_and_knows_its_channels(log: Log) -> None:
    assert len(log) == 3
    assert "mine" in log
    assert "t" not in log


@pytest.mark.parametrize(
    ("t", "channels", "says"),
    [
        ([], {}, "no samples"),
        ([0.0, 1.0], {"a": [1.0]}, "'a' has 1 samples but t has 2"),
        ([0.0, 1.0], {"a": [[1.0], [2.0]]}, r"'a' has shape \(2, 1\)"),
        (0.0, {}, r"'t' has shape \(\)"),
        ([0.0, np.nan], {}, "t is nan at row 1"),
        ([0.0, np.inf], {}, "t is inf at row 1"),
        ([0.0, 1.0, 1.0], {}, "from 1 to 1 s at row 2"),
        ([0.0, 1.0, 0.5], {}, "from 1 to 0.5 s at row 2"),
    ],
)
def test_what_is_no_log_is_refused(t: object, channels: dict[str, object], says: str) -> None:
    with pytest.raises(InvalidLog, match=says) as caught:
        Log(t, channels)  # pyright: ignore[reportArgumentType]
    assert "\n" not in str(caught.value)


def run_of_two_units() -> Log:
    channels = {"truth/pitch": [0.0, 0.1, math.nan], "sensor/gyro": [1.0, 2.0, 3.0], "truth/wheel": [3.0, 2.0, 1.0]}
    return Log([0.0, 0.01, 0.03], channels, origin={"seed": 7})


def test_pandas_has_the_channels_over_time() -> None:
    frame = run_of_two_units().to_pandas()
    assert frame.index.name == "t"
    assert list(frame.columns) == ["truth/pitch", "sensor/gyro", "truth/wheel"]
    assert frame.loc[0.01, "sensor/gyro"] == 2.0
    assert frame["truth/pitch"].isna().tolist() == [False, False, True]


def test_xarray_keeps_units_and_origin() -> None:
    data = run_of_two_units().to_xarray()
    assert data["sensor/gyro"].attrs["units"] == "rad/s"
    assert data["t"].attrs["units"] == "s"
    assert data["truth/wheel"].sel(t=0.03).item() == 1.0
    assert json.loads(data.attrs["origin"]) == {"seed": 7}


def test_a_plot_has_a_panel_for_each_quantity() -> None:
    """A pitch of a degree beside a wheel that turns once would be a line."""
    log = run_of_two_units()
    panels = log.plot("truth/pitch", "sensor/gyro", "truth/wheel").axes
    assert [panel.get_ylabel() for panel in panels] == ["pitch (truth) [rad]", "gyro [rad/s]", "wheel (truth) [rad]"]
    drawn = {line.get_label(): line for panel in panels for line in panel.lines}
    assert drawn.keys() == {"pitch (truth)", "wheel (truth)", "gyro"}
    assert drawn["gyro"].get_ydata().tolist() == [1.0, 2.0, 3.0]
    assert len(log.plot().axes) == 2  # pitch and wheel
    both = Log(log.t, {f"applied/{side}": log["sensor/gyro"] for side in ("left", "right")}, {})
    assert [len(panel.lines) for panel in both.plot().axes] == [2]
    with pytest.raises(InvalidLog, match="no channel 'pitch'"):
        log.plot("pitch")


def test_a_log_is_short_in_a_notebook() -> None:
    log = run_of_two_units()
    assert repr(log) == "Log(3 samples, 0.03 s, 3 channels)"
    row = '<code>sensor/gyro</code></td><td>rad/s</td><td class="number">1</td><td class="number">3</td>'
    assert row in log._repr_html_()
