"""Robots and kits: the presets say what their sources say, and what is no robot is refused in one sentence."""

from __future__ import annotations

import dataclasses
import json
import math
import tomllib
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm

from upright.errors import InvalidRobot, UnknownName, UprightError
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain
from upright.physics.linear import unstable_pole
from upright.robots import PARAMETERS, FittedLog, Kit, Provenance, Robot, find_kit, find_robot, kit_names, preset_names
from upright.signals.signal import FUSED, KNOWN, SENSORS

NXTWAY = {
    "gravity": 9.81,
    "wheel_mass": 0.03,
    "wheel_radius": 0.04,
    "wheel_inertia": 2.4e-5,
    "body_mass": 0.6,
    "track": 0.14,
    "body_depth": 0.04,
    "body_height": 0.144,
    "com_height": 0.072,
    "pitch_inertia": 1.0368e-3,
    "yaw_inertia": 1.06e-3,
    "rotor_inertia": 1e-5,
    "motor_resistance": 6.69,
    "back_emf": 0.468,
    "torque_constant": 0.317,
    "gear_ratio": 1.0,
    "motor_friction": 0.0022,
    "wheel_friction": 0.0,
}  # Yamamoto (2008), table of parameters

EFFECTIVE = {"a11": 2.943e-4, "a12": 1.5645e-3, "a22": 1.4460e-2, "MgL": 0.81336}  # SI; fitted to (34) and (35)

PRINTED_A = [
    [1.0037, 0.0092, 0.0, 0.0008],
    [0.6347, 0.9004, 0.0, 0.1034],
    [-0.01, 0.0071, 1.0, 0.0029],
    [-1.09, 0.8795, 0.0, 0.1103],
]  # Herrera et al. (2015), eq. (34), pitch block
PRINTED_B = [-0.0008, -0.1005, 0.0069, 0.8647]  # eq. (35), one motor
LAST_DIGIT = 1e-4  # both matrices are printed to four decimals


def preset_file(kind: str, name: str) -> dict[str, Any]:
    return tomllib.loads((resources.files("upright.robots") / kind / f"{name}.toml").read_text(encoding="utf-8"))


def number_tables(table: dict[str, Any], path: str = "") -> list[tuple[str, dict[str, Any]]]:
    """Every table that holds a value, and every bare number that should have been one, besides weights."""
    found: list[tuple[str, dict[str, Any]]] = []
    for key, entry in table.items():
        if not path and key == "weights":
            continue
        if isinstance(entry, dict) and "value" not in entry:
            found += number_tables(entry, f"{path}{key}.")
        elif not isinstance(entry, str):
            found.append((path + key, entry))
    return found


@pytest.mark.parametrize("name", preset_names())
def test_every_robot_preset_loads_under_its_own_name_and_fits_a_kit(name: str) -> None:
    robot = Robot.preset(name)
    assert robot.name == name
    assert Kit.preset(robot.kit).name == robot.kit


@pytest.mark.parametrize("name", kit_names())
def test_every_kit_preset_loads_and_names_channels_of_the_catalogue(name: str) -> None:
    kit = Kit.preset(name)
    assert kit.name == name
    assert set(kit.sensors) <= set(KNOWN)
    assert {"sensor/encoder_left", "sensor/encoder_right", "sensor/gyro"} <= set(kit.sensors)  # enough to balance


@pytest.mark.parametrize(
    ("kind", "name"), [("presets", n) for n in preset_names()] + [("kits", n) for n in kit_names()]
)
def test_every_number_of_a_preset_has_a_unit_a_source_and_a_spread_or_the_word_guess(kind: str, name: str) -> None:
    numbers = number_tables(preset_file(kind, name))
    assert numbers
    for key, entry in numbers:
        assert set(entry) == {"value", "unit", "source", "spread"}, key
        assert len(entry["source"]) > 10, key  # a source is more than a word
        spread = entry["spread"]
        assert spread == "guess" or (not isinstance(spread, str) and 0 <= spread < math.inf), key


@pytest.mark.parametrize("name", preset_names())
def test_provenance_covers_every_number_that_the_file_gives(name: str) -> None:
    given = set(preset_file("presets", name)) & set(PARAMETERS)
    assert set(Robot.preset(name).provenance) == given


def test_nxtway_gs_is_the_published_table() -> None:
    numbers = Robot.preset("nxtway-gs").numbers()
    assert {key: numbers[key] for key in NXTWAY} == NXTWAY


def test_the_inertias_of_nxtway_gs_follow_from_its_box_and_disc() -> None:
    p = Robot.preset("nxtway-gs")
    assert p.wheel_inertia == pytest.approx(p.wheel_mass * p.wheel_radius**2 / 2)
    assert p.pitch_inertia == pytest.approx(p.body_mass * p.com_height**2 / 3)
    assert p.yaw_inertia == pytest.approx(p.body_mass * (p.track**2 + p.body_depth**2) / 12)
    assert p.roll_inertia == pytest.approx(p.body_mass * (p.track**2 + p.body_height**2) / 12)


def test_nxtway_gs_measured_differs_in_the_rotor_alone() -> None:
    measured = Robot.preset("nxtway-gs-measured")
    assert measured == Robot.preset("nxtway-gs").replace(name="nxtway-gs-measured", rotor_inertia=1.5e-3)


def test_the_inertias_of_ev3way_follow_nxtways_formulas() -> None:
    p = Robot.preset("ev3way")
    assert p.wheel_inertia == pytest.approx(p.wheel_mass * p.wheel_radius**2 / 2)
    assert p.com_height == pytest.approx(p.body_height / 2)
    assert p.pitch_inertia == pytest.approx(p.body_mass * p.com_height**2 / 3)
    assert p.yaw_inertia == pytest.approx(p.body_mass * (p.track**2 + p.body_depth**2) / 12)
    assert p.roll_inertia == pytest.approx(p.body_mass * (p.track**2 + p.body_height**2) / 12)


def test_the_ev3way_on_large_wheels_weighs_what_its_authors_say() -> None:
    """0.777 kg in all (README of their logs), on wheels that fits of several logs put between 37 and 50 mm."""
    p, small = Robot.preset("ev3way-large-wheels"), Robot.preset("ev3way")
    assert 2 * p.wheel_mass + p.body_mass == pytest.approx(0.777)
    assert p.wheel_inertia == pytest.approx(p.wheel_mass * p.wheel_radius**2 / 2)
    assert 0.037 < p.wheel_radius < 0.050
    assert p.name in small.title  # who finds one of the two finds the other
    assert "21.5 mm" in small.title


def test_herrera2015_has_the_four_effective_numbers_of_the_printed_matrices() -> None:
    p = Robot.preset("herrera2015")
    a11, a12, a22, _ = mass_matrix(1.0, 0.0, p)
    weight = p.gravity * p.body_mass * p.com_height
    got = {"a11": a11, "a12": a12, "a22": a22, "MgL": weight}
    assert got == pytest.approx(EFFECTIVE, rel=1e-6)  # the file has 12 digits; a12 is a difference


def test_herrera2015_turns_as_the_printed_matrices_do() -> None:
    p = Robot.preset("herrera2015")
    a33 = mass_matrix(1.0, 0.0, p)[3]
    half_track = p.track / (2 * p.wheel_radius)
    pole = 2 * half_track**2 * motor_damping(p) / a33
    gain = half_track * motor_gain(p) / a33
    decay = math.exp(-0.01 * pole)
    # A66 and B62 of (34) and (35), from which the preset is solved: rounding of its twelve digits only
    assert decay == pytest.approx(0.0493, rel=1e-6)
    assert gain * (1 - decay) / pole == pytest.approx(0.2637, rel=1e-6)
    # facts of the paper: a pole of e^(−3.01) a period and 83.5 rad/s² a volt, to their printed digits
    assert 0.01 * pole == pytest.approx(3.01, abs=0.005)
    assert gain == pytest.approx(83.5, abs=0.05)


def test_herrera2015_at_10_ms_is_the_printed_pitch_model() -> None:
    a, b = pitch_model(Robot.preset("herrera2015"))
    block = np.zeros((5, 5))
    block[:4, :4], block[:4, 4] = a, b
    held = expm(0.01 * block)  # zero-order hold
    assert np.abs(held[:4, :4] - PRINTED_A).max() < LAST_DIGIT
    assert np.abs(held[:4, 4] - PRINTED_B).max() < LAST_DIGIT


def pitch_model(p: Robot) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """ẋ = Ax + Bu of [ψ, ψ̇, θ, θ̇] for one motor's voltage, from the four effective numbers in closed form."""
    a11, a12, a22, weight = EFFECTIVE.values()
    alpha = p.gear_ratio * p.torque_constant / p.motor_resistance
    beta = alpha * p.back_emf + p.motor_friction
    inertia = np.array([[a12, a11], [a22, a12]])  # times [ψ̈, θ̈]: the θ equation, then the ψ equation
    forces = np.array([[0, 2 * beta, 0, -2 * beta, alpha], [weight, -2 * beta, 0, 2 * beta, -alpha]])
    pitch_acc, wheel_acc = np.linalg.solve(inertia, forces)
    rates = np.array([[0, 1, 0, 0], pitch_acc[:4], [0, 0, 0, 1], wheel_acc[:4]])
    return rates, np.array([0, pitch_acc[4], 0, wheel_acc[4]])


def grows(inertia: list[list[float]], weight: float, brake: float, drag: float) -> float:
    """The rate [1/s] at which a lean grows: largest root of |E s² + D s − G|, E of [wheel, body], with a `brake`
    between body and wheels and a `drag` of the floor."""
    E, G = np.array(inertia), np.diag([0.0, weight])
    D = brake * np.array([[1, -1], [-1, 1]]) + np.diag([drag, 0])
    first = np.block([[np.zeros((2, 2)), np.eye(2)], [np.linalg.solve(E, G), -np.linalg.solve(E, D)]])
    return float(np.linalg.eigvals(first).real.max())


def test_balrob_falls_as_in_the_script_of_its_course() -> None:
    """Its matrices, in which a rotor turns with the body too, (1 − n)² for n², and hangs 7 mm below the axle: 1 % of
    the pole each, in opposite senses."""
    n, rotor, mass, R, K_t, K_e = 30, 8.8076e-6, 0.07525, 12 / 5, 110 / 30 * 0.706e-2 / 5, 10.2587e-3
    r, M, zb = 0.034, 1.0555, 0.0460478
    lever = M * zb - 2 * mass * 0.007
    a11 = 2 * 0.05 / 2 * r**2 + 2 * n**2 * rotor + (M + 2 * 0.05 + 2 * mass) * r**2
    a12 = 2 * n * (1 - n) * rotor + lever * r
    a22 = 2.20489e-3 + 2 * (1 - n) ** 2 * rotor + M * zb**2 + 2 * mass * 0.007**2
    brake = 2 * (n**2 * K_t * K_e / R + 0.025)
    published = grows([[a11, a12], [a12, a22]], 9.81 * lever, brake, 2 * 0.0015)
    assert unstable_pole(Robot.preset("balrob")) == pytest.approx(published, rel=0.02)


def test_tumbller_without_what_is_guessed_is_the_published_cart_and_pendulum() -> None:
    guessed = {"wheel_inertia": 1e-12, "rotor_inertia": 0.0, "back_emf": 0.0}
    m_c, m_p, lever, inertia, r = 0.493, 0.312, 0.04, 2.4e-4, 0.0335
    a12 = m_p * lever * r
    a = [[(m_c + m_p) * r**2, a12], [a12, m_p * lever**2 + inertia]]
    published = grows(a, 9.81 * m_p * lever, 0.0, 0.01 * r**2)
    # a wheel's inertia may not be zero: 1e-12 beside 9e-4 kg m²; 0.01 N s/m is written with two digits, 5.6e-6
    assert unstable_pole(Robot.preset("tumbller").replace(**guessed)) == pytest.approx(published, rel=1e-6)


@pytest.mark.parametrize("name", preset_names())
def test_a_robot_written_and_read_again_is_the_same_with_the_same_sources(name: str, tmp_path: Path) -> None:
    robot = Robot.preset(name)
    again = Robot.load(robot.save(tmp_path / "robot.toml"))
    assert again == robot
    assert dict(again.provenance) == dict(robot.provenance)


@pytest.mark.parametrize("name", preset_names())
def test_what_is_changed_loses_its_source_and_nothing_else_is_lost(name: str, tmp_path: Path) -> None:
    robot = Robot.preset(name)
    changed = robot.replace(body_mass=1.1 * robot.body_mass)
    again = Robot.load(changed.save(tmp_path / "robot.toml"))
    assert again == changed
    assert again.provenance == {key: source for key, source in robot.provenance.items() if key != "body_mass"}
    assert (again.title, again.kit, again.weights) == (robot.title, robot.kit, robot.weights)


def test_a_robot_saved_elsewhere_finds_its_kit_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for folder in ("here", "there", "elsewhere"):
        (tmp_path / folder).mkdir()
    (tmp_path / "here" / "kit.toml").write_text(Kit.preset("nxt").to_toml())
    path = Robot.preset("nxtway-gs").replace(kit="kit.toml").save(tmp_path / "here" / "mine.toml")
    saved = Robot.load(path).replace(track=0.15).save(tmp_path / "there" / "mine.toml")
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert find_kit(Robot.load(saved).kit) == Kit.preset("nxt")


def test_correlations_are_written_and_read_again_and_go_with_a_number_that_is_changed(tmp_path: Path) -> None:
    pairs = {("com_height", "body_mass"): -0.1 / 3, ("track", "body_mass"): 0.5, ("track", "com_height"): 1.0}
    robot = dataclasses.replace(Robot.preset("nxtway-gs"), correlation=pairs)
    assert dict(Robot.load(robot.save(tmp_path / "robot.toml")).correlation) == pairs
    assert dict(robot.replace(track=0.15).correlation) == {("com_height", "body_mass"): -0.1 / 3}


@pytest.mark.parametrize(
    ("lines", "word"),
    [
        ("[correlation.track]\nbody_mass = 1.5", "from −1 to 1"),
        ("[correlation.track]\ntrack = 0.5", "two names"),
        ("[correlation.track]\nbody_mas = 0.5", "did you mean 'correlation.track.body_mass'"),
        ("[correlation.trak]\nbody_mass = 0.5", "did you mean 'correlation.track'"),
        ("[correlation]\ntrack = 0.5", "a table"),
    ],
)
def test_wrong_correlations_are_named(lines: str, word: str, tmp_path: Path) -> None:
    path = Robot.preset("nxtway-gs").save(tmp_path / "robot.toml")
    path.write_text(path.read_text(encoding="utf-8") + "\n" + lines + "\n", encoding="utf-8")
    with pytest.raises(InvalidRobot, match=word):
        Robot.load(path)


HOSTILE = [
    'a "name"', "it's", "a\nb", "a\rb", "*/ int x; /*", '"""', "a\\", "a;b", "{{ a }}", "<b>", "a\x00b", "a\u2028b",
    "\ud800", "a\u202eb", "", " ", "x" * 41, 7, None,
]  # fmt: skip
"""What ends a comment, a string or a line in some language, turns text around, or is no name at all."""


@pytest.mark.parametrize("name", HOSTILE)
def test_a_name_that_would_break_a_program_is_refused_wherever_it_comes_from(name: Any, tmp_path: Path) -> None:
    robot = Robot.preset("nxtway-gs")
    with pytest.raises(InvalidRobot, match="name"):
        robot.replace(name=name)
    with pytest.raises(InvalidRobot, match="name"):
        Kit(name=name)
    if isinstance(name, str) and name.isascii():
        path = robot.save(tmp_path / "robot.toml")
        path.write_text(path.read_text("utf-8").replace('"nxtway-gs"', json.dumps(name).replace("\x7f", "")), "utf-8")
        with pytest.raises(InvalidRobot, match="name"):
            Robot.load(path)


@pytest.mark.parametrize(
    "name", ["Niño 2.0", "nxtway-gs_measured", "균형 로봇", "Ünal's".replace("'", ""), "x" * 40, "नमस्ते"]
)
def test_a_name_in_any_script_is_kept(name: str, tmp_path: Path) -> None:
    assert Robot.load(Robot.preset("nxtway-gs").replace(name=name).save(tmp_path / "robot.toml")).name == name


def test_sources_and_titles_survive_quotes_backslashes_and_line_breaks(tmp_path: Path) -> None:
    awkward = 'a "name"\\ with\nψ and \x7f'
    robot = Robot.preset("nxtway-gs").replace(title=awkward, provenance={"track": Provenance(awkward, 0.1 + 0.2)})
    again = Robot.load(robot.save(tmp_path / "robot.toml"))
    assert again == robot
    assert again.title == awkward
    assert dict(again.provenance) == dict(robot.provenance)


def test_writing_where_there_is_no_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UprightError, match="no folder"):
        Robot.preset("nxtway-gs").save(tmp_path / "nowhere" / "robot.toml")


def test_a_robot_and_a_kit_are_found_by_name_or_by_path(tmp_path: Path) -> None:
    robot = Robot.preset("ev3way")
    path = robot.save(tmp_path / "mine.toml")
    assert find_robot("ev3way") == find_robot(path) == find_robot(str(path)) == robot
    kit = tmp_path / "kit.toml"
    kit.write_text('name = "mine"\n[sensors.gyro.noise]\nvalue = 0.01\nunit = "rad/s"\n')
    assert find_kit(str(kit)).sensors["sensor/gyro"].noise == 0.01  # the number written a line above
    assert find_kit("nxt") == Kit.preset("nxt")


def test_a_kit_may_lie_beside_the_robot_s_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """`-r folder/mine.toml` looked for the kit's file where the command ran only."""
    (tmp_path / "kit.toml").write_text(Kit.preset("nxt").to_toml())
    path = Robot.preset("nxtway-gs").replace(kit="kit.toml").save(tmp_path / "mine.toml")
    assert find_kit(find_robot(path).kit) == Kit.preset("nxt")
    monkeypatch.chdir(tmp_path)
    assert find_robot("mine.toml").kit == "kit.toml"


@pytest.mark.parametrize("find", [find_robot, find_kit, Robot.preset, Kit.preset])
def test_an_unknown_name_lists_what_there_is(find: Any) -> None:
    with pytest.raises(UnknownName, match="is called 'nxtt'; expected one of"):
        find("nxtt")


def test_a_close_name_is_suggested() -> None:
    with pytest.raises(UnknownName, match="did you mean 'nxtway-gs'"):
        Robot.preset("nxtway-g")


def test_a_path_without_toml_is_distinguished_from_a_name() -> None:
    with pytest.raises(InvalidRobot, match=r"ends in \.toml"):
        find_robot("robots/mine")


IMPOSSIBLE: list[tuple[dict[str, Any], str]] = [
    ({"body_mass": -0.6}, "body_mass is -0.6 kg; expected more than zero"),
    ({"wheel_radius": 0.0}, "wheel_radius is 0 m"),
    ({"track": math.nan}, "track is nan; expected a finite number"),
    ({"track": math.inf}, "track is inf; expected a finite number"),
    ({"track": True}, "track is True"),
    ({"track": "0.14"}, "track is '0.14'"),
    ({"roll_inertia": 1.0}, "roll_inertia 1 kg m² exceeds the sum of the other two"),
    ({"com_height": -0.07}, "no unstable pole"),
    ({"com_height": 0.0}, "no unstable pole"),
    ({"drive": "torque"}, "a torque drive with motor_resistance = "),
    ({"drive": "current"}, "drive is 'current'"),
]


@pytest.mark.parametrize(("changes", "fragment"), IMPOSSIBLE)
def test_what_no_balancing_robot_can_be_is_refused(changes: dict[str, Any], fragment: str) -> None:
    with pytest.raises(InvalidRobot) as refusal:
        Robot.preset("nxtway-gs").replace(**changes)
    assert fragment in str(refusal.value)


BROKEN_ROBOTS: list[tuple[str, str, str]] = [
    ("[track]\nvalue = 0.14", "[track]\nvalue = nan", "track is nan; expected a number [m]"),
    ("[track]\nvalue = 0.14", "[track]\nvalue = inf", "track is inf; expected a finite number [m]"),
    ("[track]\nvalue = 0.14", "[track]\nvalue = '0.14'", "track is '0.14'; expected a number [m]"),
    ("[track]\nvalue = 0.14", "[track]\nvalue = true", "track is True; expected a number [m]"),
    ("[track]\nvalue = 0.14", "[track]\nvalue =", "is broken TOML"),
    ("[track]\nvalue = 0.14\n", "[track]\n", "track has no value; expected value and unit [m]"),
    ('0.14\nunit = "m"', '140\nunit = "mm"', "track has unit 'mm'; expected [m]; likely millimetres"),
    ('0.14\nunit = "m"', '5.5\nunit = "inch"', "track has unit 'inch'; expected [m]"),
    ('0.14\nunit = "m"', "0.14\nunit = 7", "track has unit 7; expected [m]"),
    ('0.14\nunit = "m"', "0.14", "track has no unit"),
    ('0.14\nunit = "m"', '0.14\nunits = "m"', "unknown key 'track.units'"),
    ("spread = 0.0036", 'spread = "5 %"', "the spread of com_height is '5 %'; expected one standard deviation"),
    ("spread = 0.0036", "spread = -1.0", "the spread of com_height is -1.0"),
    ("spread = 0.0036", "spread = inf", "the spread of com_height is inf"),
    ("[wheel_mass]", "[whel_mass]", "unknown key 'whel_mass'"),
    ("[wheel_mass]", "[whel_mass]", "did you mean 'wheel_mass'?"),
    ('name = "nxtway-gs"', "", "lacks name"),
    ('name = "nxtway-gs"', "name = 3", "name is 3; expected text in quotes"),
    ('name = "nxtway-gs"', 'name = "a"\ntrack = 0.14', "is broken TOML"),
    ('name = "nxtway-gs"', 'name = "a"\nstiction_rate = 1', "a table with value and unit [rad/s]"),
    ("value = 0.6", "value = -0.6", "body_mass is -0.6 kg"),
    ("value = 0.072", "value = -0.072", "no unstable pole"),
    ("value = 2.0168e-3", "value = 1.0", "exceeds the sum of the other two"),
    ('drive = "voltage"', 'drive = "torque"', "a torque drive with motor_resistance = "),
]


@pytest.mark.parametrize(("old", "new", "fragment"), BROKEN_ROBOTS)
def test_a_broken_robot_file_is_refused_in_one_line(old: str, new: str, fragment: str, tmp_path: Path) -> None:
    text = (resources.files("upright.robots") / "presets" / "nxtway-gs.toml").read_text(encoding="utf-8")
    assert old in text
    path = tmp_path / "robot.toml"
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InvalidRobot) as refusal:
        Robot.load(path)
    assert fragment in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_a_required_parameter_that_is_missing_is_named_with_its_unit(tmp_path: Path) -> None:
    path = tmp_path / "robot.toml"
    path.write_text('name = "mine"\n[track]\nvalue = 0.14\nunit = "m"\n')
    with pytest.raises(InvalidRobot, match=r'lacks body_mass, com_height, .*unit = "kg"'):
        Robot.load(path)


@pytest.mark.parametrize("read", [Robot.load, Kit.load])
def test_a_path_that_is_no_text_file_is_refused(read: Any, tmp_path: Path) -> None:
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    with pytest.raises(InvalidRobot, match="No such file"):
        read(tmp_path / "missing.toml")
    with pytest.raises(InvalidRobot, match="Is a directory"):
        read(tmp_path)
    with pytest.raises(InvalidRobot, match="not text in UTF-8"):
        read(tmp_path / "binary.toml")


@pytest.mark.parametrize("unit", ["kg m^2", "kg*m^2", "kg·m²", "kg m**2", " kg  m² "])
def test_a_unit_may_be_spelt_without_special_characters(unit: str, tmp_path: Path) -> None:
    robot = Robot.preset("nxtway-gs")
    path = robot.save(tmp_path / "robot.toml")
    path.write_text(path.read_text(encoding="utf-8").replace('"kg m²"', f'"{unit}"'), encoding="utf-8")
    assert Robot.load(path) == robot


def test_numbers_without_a_source_are_read_and_have_no_provenance(tmp_path: Path) -> None:
    bare = Robot.preset("nxtway-gs").replace(provenance={})
    again = Robot.load(bare.save(tmp_path / "robot.toml"))
    assert again == bare
    assert dict(again.provenance) == {}


def test_a_guess_has_no_stated_spread() -> None:
    provenance = Robot.preset("nxtway-gs").provenance
    assert provenance["rotor_inertia"].spread is None  # the file says "guess"
    assert provenance["wheel_mass"].spread == 0.001  # [kg], weighed to a gram


BROKEN_KITS: list[tuple[str, str]] = [
    ("[sensors.gyr]", "did you mean 'sensors.gyro'?"),
    ('[sensors.gyro.noize]\nvalue = 1\nunit = "rad/s"', "unknown key 'sensors.gyro.noize'"),
    ('[sensors.gyro.noise]\nvalue = 1\nunit = "deg/s"', "expected [rad/s]; likely degrees"),
    ('[sensors.gyro.noise]\nvalue = -1\nunit = "rad/s"', "sensor noise is -1; expected zero or more"),
    ('[sensors.gyro.noise]\nvalue = nan\nunit = "rad/s"', "sensors.gyro.noise is nan"),
    ('[period]\nvalue = 10\nunit = "ms"', "period has unit 'ms'; expected [s]; likely milliseconds"),
    ('[period]\nvalue = 10\nunit = "s"', "kit period is 10 s"),
    ("period = 0.01", "period is 0.01; expected a table"),
    ('[delay]\nvalue = 1e9\nunit = "s"', "kit delay is 1e+09 s; expected at most 1 s; likely milliseconds"),
    ('[sensors.gyro.period]\nvalue = 2\nunit = "s"', "sensor period is 2 s; expected at most 1 s"),
    ('[motor.quantum]\nvalue = 1e-300\nunit = "V"', "motor quantum is 1e-300; expected zero for none"),
    ("sensors = 3", "sensors is 3; expected a table"),
    ('[motor.limit]\nvalue = 1\nunit = "A"', "expected [V] or [N m]"),
    ('[battery.voltage]\nvalue = 0\nunit = "V"', "battery voltage is 0 V"),
    ("[motr]", "did you mean 'motor'?"),
]


@pytest.mark.parametrize(("text", "fragment"), BROKEN_KITS)
def test_a_broken_kit_file_is_refused_in_one_line(text: str, fragment: str, tmp_path: Path) -> None:
    path = tmp_path / "kit.toml"
    path.write_text(f'name = "mine"\n{text}\n', encoding="utf-8")
    with pytest.raises(InvalidRobot) as refusal:
        Kit.load(path)
    assert fragment in str(refusal.value)
    assert "\n" not in str(refusal.value)


def test_a_kit_without_a_name_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "kit.toml"
    path.write_text("[sensors.gyro]\n")
    with pytest.raises(InvalidRobot, match="lacks name"):
        Kit.load(path)


def test_the_ideal_kit_has_every_sensor_and_no_fault() -> None:
    ideal = Kit.preset("ideal")
    # an endless battery has no voltage to read
    assert set(ideal.sensors) == {sensor.name for sensor in (*SENSORS, *FUSED)} - {"sensor/battery"}
    assert ideal == Kit(name="ideal", sensors={name: type(s)() for name, s in ideal.sensors.items()})


@pytest.mark.parametrize("name", ["nxt", "ev3", "spike"])
def test_lego_encoders_step_by_one_degree(name: str) -> None:
    kit = Kit.preset(name)
    for side in ("left", "right"):
        assert kit.sensors[f"sensor/encoder_{side}"].quantum == pytest.approx(math.radians(1), rel=1e-5)  # six digits


def test_the_logs_of_a_calibration_stay_in_the_file(tmp_path: Path) -> None:
    """With names of any kind, and none, one or several marks of 32 bits."""
    logs = (FittedLog('a "run".csv', -0.5, 7.4, (0, 1, 2**32 - 1)), FittedLog("día 2.parquet", 0.0, 1e3))
    robot = Robot.preset("ev3way").replace(fitted=logs)
    path = robot.save(tmp_path / "robot.toml")
    assert Robot.load(path).fitted == logs
    assert Robot.load(path) == Robot.preset("ev3way")  # what it was fitted to is no part of what it is
    for lines, word in (
        ('[[fitted]]\nlog = "a.csv"\nstart = "0"\nstop = 1', "expected tables"),
        ('[[fitted]]\nlogs = "a.csv"', "fitted.log"),
        ('[[fitted]]\nlog = "a.csv"\nstart = 0\nstop = 1\nmarks = "xyz"', "expected hexadecimal"),
        ("[fitted]", "expected tables"),
    ):
        path.write_text(f"{Robot.preset('ev3way').to_toml()}\n{lines}\n", encoding="utf-8")
        with pytest.raises(InvalidRobot, match=word):
            Robot.load(path)


def test_the_noise_of_a_calibration_stays_in_the_file(tmp_path: Path) -> None:
    robot = Robot.preset("ev3way").replace(noise={"gyro": 0.64, "motor": 0.2})
    path = robot.save(tmp_path / "robot.toml")
    assert dict(Robot.load(path).noise) == {"gyro": 0.64, "motor": 0.2}
    for line, word in (("gyro = 0", "positive standard deviation"), ("giro = 1", "did you mean 'noise.gyro'")):
        path.write_text(Robot.preset("ev3way").to_toml() + f"\n[noise]\n{line}\n", encoding="utf-8")
        with pytest.raises(InvalidRobot, match=word):
            Robot.load(path)
