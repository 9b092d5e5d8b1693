"""A film shows what a log holds: as many pictures as its time asks for, and a body that leans as the log says."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from upright.cli.main import main
from upright.errors import InvalidLog, UprightError
from upright.reports.film import film
from upright.robots import Robot
from upright.signals import Log

ROBOT = Robot.preset("nxtway-gs")
T = 0.01 * np.arange(201)  # [s]


def leaning(lean: float) -> Log:
    """Two seconds at one lean [rad], the wheels still."""
    return Log(T, {"truth/pitch": np.full(len(T), lean), "truth/wheel": np.zeros(len(T))})


def frames(path: Path) -> list[np.ndarray]:
    with Image.open(path) as image:
        pictures = []
        for k in range(image.n_frames):  # pyright: ignore[reportAttributeAccessIssue]
            image.seek(k)
            pictures.append(np.asarray(image.convert("RGB"), dtype=float))
        return pictures


@pytest.mark.parametrize("suffix", [".gif", ".webp"])
def test_a_film_has_its_pictures_a_second_and_its_size(suffix: str, tmp_path: Path) -> None:
    path = film(leaning(0.1), tmp_path / f"run{suffix}", ROBOT, frames=5, width=480)
    pictures = frames(path)
    # 2 s at 5 a second from the first row to the last; an encoder may drop pictures that equal the one before.
    assert len(pictures) == 11 if suffix == ".gif" else len(pictures) <= 11
    assert pictures[0].shape == (270, 480, 3)


@pytest.mark.parametrize("lean", [-0.3, 0.0, 0.3])
def test_the_body_leans_as_the_log_says(lean: float, tmp_path: Path) -> None:
    """The middle of the coloured rows between the corners runs along it: 0.02 rad are two pixels in 100 rows."""
    picture = frames(film(leaning(lean), tmp_path / "run.gif", ROBOT, stop=0.1, frames=10, width=960))[0]
    scene = picture[: picture.shape[0] // 2]
    rows, columns = np.nonzero((scene[..., 2] - scene[..., 0]) > 40)  # blue, above the panels
    rows, columns = rows[rows < 150], columns[rows < 150]  # above the wheel, which is round
    centres = [columns[rows == r].mean() for r in np.unique(rows)[20:-20]]
    slope = np.polyfit(np.unique(rows)[20:-20], centres, 1)[0]
    assert math.atan(-slope) == pytest.approx(lean, abs=0.02)


def test_a_raw_log_is_filmed_by_its_gyro_and_encoders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["example", "pushed"]) == 0
    assert (
        main(["film", "pushed.csv", "-r", "nxtway-gs", "--from", "2", "--until", "3", "-o", "a.gif", "--frames", "5"])
        == 0
    )
    assert len(frames(tmp_path / "a.gif")) == 6


@pytest.mark.needs("module:imageio_ffmpeg")
def test_an_mp4_is_read_back_by_ffmpeg(tmp_path: Path) -> None:
    import imageio_ffmpeg

    path = film({"robot": leaning(0.1), "ghost": leaning(0.0)}, tmp_path / "run.mp4", ROBOT, frames=10, width=480)
    seconds = imageio_ffmpeg.count_frames_and_secs(str(path))[1]
    assert seconds == pytest.approx(2.1, abs=0.11)  # 21 pictures of 1/10 s, to within one


@pytest.mark.parametrize(
    ("log", "options", "says"),
    [
        (Log(T, {"truth/pitch": T}), {}, "encoder"),
        (Log(T, {"sensor/battery": T}), {}, "gyro"),
        (leaning(0.0), {"start": 5.0}, "nothing between"),
        (leaning(0.0), {"speed": 0.0}, "a speed of 0.001"),
        (leaning(0.0), {"speed": 0.001}, "at most 3000"),
    ],
)
def test_what_cannot_be_filmed_is_reported(log: Log, options: dict[str, float], says: str, tmp_path: Path) -> None:
    with pytest.raises((InvalidLog, UprightError), match=says):
        film(log, tmp_path / "run.gif", ROBOT, **options)
    assert list(tmp_path.iterdir()) == []
