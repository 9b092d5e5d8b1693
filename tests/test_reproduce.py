"""The paper from end to end: what is written, and the claims against facts computed outside this code.

The facts are of the printed matrices themselves (anybody can compute them again from eqs. 34 to 38), of statics, and
of MuJoCo; none of them was read off this program's own page.
"""

from __future__ import annotations

import json
import math
import os
import re
import sys
from html import escape
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsonschema import Draft202012Validator
from matplotlib.figure import Figure as Drawing
from scipy.linalg import solve_discrete_are

from heads import shown_alike
from schemas import FOLDER
from upright.bodies import Electronics
from upright.bodies.models import NonlinearBody
from upright.comparison import compare
from upright.control import Estimated, kalman, lqr_state
from upright.errors import UprightError
from upright.experiment import Hold, Impulse, run
from upright.pages import Picture, Say, Table
from upright.paper import as_built, controllers, equations, printed, pushes, regulator, turning
from upright.paper.claim import BADGES, BEYOND, IN_PART, NOT_AS_PRINTED, REPRODUCED, UNKNOWN, Claim, judged
from upright.paper.reproduce import Reproduction, reproduce
from upright.robots import Kit, Robot
from upright.signals import STATE, Log

VERDICTS = {
    "1a": REPRODUCED, "1b": NOT_AS_PRINTED, "2a": BEYOND, "2b": BEYOND, "3a": IN_PART, "3b": BEYOND,
    "3c": BEYOND,
    "4": NOT_AS_PRINTED, "5a": REPRODUCED, "5b": REPRODUCED, "5c": REPRODUCED, "5d": REPRODUCED,
}  # fmt: skip
"""What the paper's text allows: known before this program ran. 5e and 5f depend on the twin, and are tested below."""

PUSHED = ("5a", "5b", "5c", "5d")
FEW_WORDS = 120  # above the folds of a page


@pytest.fixture(scope="session")
def done(tmp_path_factory: pytest.TempPathFactory) -> Reproduction:
    """What `upright reproduce` wrote into the folder `UPRIGHT_REPRODUCED`, where CI has run it; or else computed."""
    if folder := os.environ.get("UPRIGHT_REPRODUCED"):
        return read(Path(folder))
    shares: list[float] = []
    result = reproduce(tmp_path_factory.mktemp("paper") / "herrera2015", shares.append)
    assert shares == sorted(shares)  # progress never runs backwards
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    return result


def read(folder: Path) -> Reproduction:
    """Every claim without its figures, from results.json and the logs."""
    claims: list[Claim] = []
    for found in json.loads((folder / "results.json").read_text("utf-8"))["findings"]:
        logs = {name: Log.load(folder / "logs" / f"{name}.parquet") for name in found.pop("logs")}
        found |= {name: Say("{words}", words=found[name]) for name in ("title", "summary")}
        claims.append(Claim(**found, logs=logs))
    return Reproduction(claims, folder)


@pytest.fixture(scope="session")
def parts(done: Reproduction) -> dict[str, Claim]:
    return {claim.part: claim for claim in done.claims}


class Links(HTMLParser):
    """Everything that a page would fetch."""

    def __init__(self) -> None:
        super().__init__()
        self.found: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found += [value or "" for name, value in attrs if name in ("src", "href", "xlink:href", "data", "action")]


def test_the_page_fetches_nothing(done: Reproduction) -> None:
    text = (done.folder / "report.html").read_text("utf-8")
    links = Links()
    links.feed(text)
    assert all(link.startswith("#") for link in links.found)
    named = set(re.findall(r"https?://[^\s\"'<)]+", text))
    assert named <= {"http://www.w3.org/2000/svg"}  # a name, never fetched
    assert "@import" not in text
    assert "url(" not in re.sub(r"url\(#[\w-]+\)", "", text)


def test_the_page_shows_every_finding_and_no_bad_number(done: Reproduction) -> None:
    text = (done.folder / "report.html").read_text("utf-8")
    for claim in done.claims:
        assert escape(str(claim.title)) in text
    body = re.sub(r"<(script|style)\b.*?</\1>", "", text, flags=re.DOTALL)
    said = re.sub(r"<[^>]+>", " ", body)
    assert not re.search(r"\bnan\b|\binf\b|\bNone\b(?! of)|\bTrue\b|\bFalse\b", said)
    assert not re.search(r"(?<![\w.–-])-\d", said)  # a minus sign is −, not a hyphen
    assert not re.search(r"\d[eE][-+]\d", said)  # powers of ten are written out


def test_results_are_json_without_nan(done: Reproduction) -> None:
    def refuse(constant: str) -> float:
        raise AssertionError(f"{constant} is not JSON")

    results = json.loads((done.folder / "results.json").read_text("utf-8"), parse_constant=refuse)
    assert [f["part"] for f in results["findings"]] == [*VERDICTS, "5e", "5f", "6"]
    assert results["versions"]["upright"]
    schema = json.loads((FOLDER / "reproduce.json").read_text("utf-8"))
    Draft202012Validator(schema).validate(results)


def test_logs_are_written_whole(done: Reproduction) -> None:
    same_logs(done)


def same_logs(done: Reproduction) -> None:
    named = {name: log for claim in done.claims for name, log in claim.logs.items()}
    assert {path.stem for path in (done.folder / "logs").iterdir()} == set(named)
    for name, log in named.items():
        again = Log.load(done.folder / "logs" / f"{name}.parquet")
        assert dict(again.origin) == json.loads(json.dumps(dict(log.origin)))
        assert {"robot", "body", "controller", "scenario", "versions"} <= set(again.origin)
        np.testing.assert_array_equal(again.t, log.t)
        assert again.channels.keys() == log.channels.keys()


def test_what_the_chapters_give_is_written_and_read_whole(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A claim that was not computed: log and numbers come back as they were."""
    log = run(
        NonlinearBody(Robot.preset("nxtway-gs")), lqr_state("nxtway-gs", 0.01), Impulse(impulse=0.01), seconds=2.0
    )
    nothing = Picture(Say("Nothing"), Drawing)
    claim = Claim("1a", Say("Held"), REPRODUCED, Say("It holds."), {"hold": 0.1}, [nothing], {"held": log})
    monkeypatch.setattr(sys.modules[reproduce.__module__], "chapters", lambda progress: [claim])
    done = reproduce(tmp_path)
    same_logs(done)
    (again,) = read(tmp_path).claims
    assert again.to_json() == claim.to_json()
    np.testing.assert_array_equal(again.logs["held"].t, log.t)


@pytest.mark.parametrize(("part", "verdict"), VERDICTS.items())
def test_verdicts(parts: dict[str, Claim], part: str, verdict: str) -> None:
    assert parts[part].verdict == verdict
    assert len(str(parts[part].summary)) > 20  # it says why


def test_the_first_screen_has_the_verdict_three_numbers_and_every_claim_of_the_paper(done: Reproduction) -> None:
    page = done.page()
    table = page.blocks[0]
    assert isinstance(table, Table)
    assert [row[0] for row in table.rows] == [claim.part for claim in done.claims if claim.verdict != BEYOND]
    assert page.verdict
    assert page.verdict.level == "warn"
    # of the printed matrices: the gain of their weights, and the printed one; 13 misprints, counted below
    assert [str(number.value) for number in page.numbers[1:]] == ["−65.2", "13"]
    shown_alike(done)


def test_few_words_stand_above_the_folds(done: Reproduction) -> None:
    text = (done.folder / "report.html").read_text("utf-8")
    text = re.sub(r"<details\b.*</details>", "", text, flags=re.DOTALL)  # folds stand in folds
    text = re.sub(r"<(head|script|style|svg|footer)\b.*?</\1>", "", text, flags=re.DOTALL)
    assert len(re.findall(r"[A-Za-z]{2,}", re.sub(r"<[^>]+>", " ", text))) <= FEW_WORDS


# Chapter 1


@pytest.mark.parametrize("model", ["published", "complete"])
def test_the_equations_are_the_derived_ones(parts: dict[str, Claim], model: str) -> None:
    # 20 terms and a 2×2 solve that loses a factor of 10, at ε = 2e-16: 4e-14, with room for cancelling terms
    assert parts["1a"].numbers["largest_relative_difference"][model] < 1e-12


def test_a_wrong_equation_would_be_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    right = equations.accelerations
    bent = lambda x, u, p, **options: right(x, u, p.replace(track=p.track * 1.0001), **options)  # noqa: E731
    monkeypatch.setattr(equations, "accelerations", bent)
    assert equations.disagreement("published", Robot.preset("nxtway-gs")) > 1e-6


def test_every_misprint_of_motion_is_proved(parts: dict[str, Claim]) -> None:
    numbers = parts["1b"].numbers
    # facts: (1); J_w; (3); (10); (13); sign of (16); α of (16); 2J_w of (19); J_m and L_2 of (24): ten in equations,
    # and three of notation: the dot of (19), the ½ of (30), the number in section 3.1
    assert (numbers["proved"], numbers["provable"], len(numbers["errata"])) == (10, 10, 13)
    for record in numbers["errata"]:
        if record["proof"]:
            assert record["proof"]["printed_residual"] > 1e-3
            assert record["proof"]["corrected_residual"] < 1e-12  # rounding


# Chapter 2


def test_terms_of_each_equation_add_up_to_nothing() -> None:
    # the terms are written out a second time here, and must balance with the accelerations of physics.dynamics
    robot = Robot.preset("nxtway-gs")
    log = turning.drive(NonlinearBody(robot), lqr_state(robot, turning.PERIOD), 6.0)
    equations = turning.terms(robot, log)
    assert set(equations) == set("θψφ")
    for equation in equations.values():
        assert equation.left_out
        listed = [*equation.kept, *equation.left_out.values()]
        assert np.abs(np.sum(listed, axis=0)).max() < 1e-12 * np.abs(listed).max()  # rounding of some 10 terms


def test_left_out_terms_grow_with_the_yaw_rate(parts: dict[str, Claim]) -> None:
    shares = parts["2a"].numbers["share_of_largest_kept_term"]
    spin = shares["M L R φ̇² sin ψ"]
    # φ̇² at nearly the same lean: 36 times from 1 to 6 rad/s, less where the turn itself changes the motion
    assert 20 < spin["6"] / spin["1"] < 40
    assert shares["M L R φ̇ θ̇ sin ψ"]["3"] > 0.1  # of the size of what is kept, as the facts say of several rad/s


@pytest.mark.parametrize("state", ["pitch", "wheel_rate"])
def test_mujoco_sides_with_the_complete_model(parts: dict[str, Claim], state: str) -> None:
    off = parts["2b"].numbers["off_the_twin"]
    for rate in ("3", "6"):
        assert off[rate]["published"][state]["rms"] > 2 * off[rate]["complete"][state]["rms"]
    assert off["3"]["complete"][state]["rms"] < 0.002  # the bar set for the twin: 0.2 % of the peak
    assert off["6"]["published"][state]["rms"] > 0.01  # facts: 0.9 % at 3.3 rad/s, and growing with φ̇²


def test_stiffer_contact_goes_to_the_complete_model_only(parts: dict[str, Claim]) -> None:
    limits = list(parts["2b"].numbers["pitch_rms_by_contact_time"].values())
    soft, stiff = limits[0], limits[-1]
    assert stiff["complete"] < soft["complete"] / 2.5  # first order in the contact time, which is four times shorter
    assert stiff["published"] > 0.9 * soft["published"]


def test_difference_from_the_twin_is_measured_right() -> None:
    t = np.arange(5) * 0.1
    twin = Log(t, {"truth/pitch": [0, 1, -2, 1, 0]}, {"truth/pitch": "rad"})
    model = Log(t, {"truth/pitch": [0.1, 1.1, -1.9, 1.1, -0.1]}, {"truth/pitch": "rad"})
    assert turning.deviation(model, twin, "pitch") == turning.Deviation(
        pytest.approx(0.05), pytest.approx(0.05)
    )  # 0.1 of 2


# Chapter 3


def test_the_printed_linear_model_is_found_again(parts: dict[str, Claim]) -> None:
    numbers = parts["3a"].numbers
    blocks = list(numbers["misfit"].values())
    assert blocks[0]["last_digits"] <= 2  # facts: four physical numbers fit all 24 entries to 0.8 of the last digit
    assert blocks[1]["last_digits"] <= 2
    assert blocks[2]["last_digits"] > 1000  # with the sign as printed: twice 0.2637 off
    assert (blocks[0]["entries"], numbers["samples"]) == (24, 2000)
    assert numbers["rank"] == 9  # 1, six states and two commands
    assert numbers["largest_offset"] < 1e-6  # no independent term in a model about its equilibrium
    # facts: the largest eigenvalue of the printed A
    assert np.abs(np.linalg.eigvals(np.array(numbers["A"]))).max() == pytest.approx(1.0707, abs=5e-4)


def test_real_sensors_bias_the_regression(parts: dict[str, Claim]) -> None:
    numbers = parts["3b"].numbers
    # log(1.0707)/0.01: the unstable pole of the printed model
    assert numbers["true_unstable_pole"] == pytest.approx(math.log(1.0707) / 0.01, rel=0.005)
    assert abs(numbers["unstable_pole"] - numbers["true_unstable_pole"]) > 0.1 * numbers["true_unstable_pole"]


# Chapter 4


def test_the_regulator_of_the_printed_weights_is_another(parts: dict[str, Claim]) -> None:
    clean = np.array(parts["4"].numbers["dlqr_without_noise"])[0]
    # facts, half a unit of the last digit each
    assert (np.abs(clean[:4] - [-65.2, -8.56, -0.0066, -0.976]) < [0.05, 0.005, 0.00005, 0.0005]).all()
    assert abs(clean[4]) == pytest.approx(0.0071, abs=0.00005)
    noisy = np.array(parts["4"].numbers["dlqr_as_printed"])
    np.testing.assert_allclose(noisy[:, 0], [-60.8, -69.1], atol=0.05)
    assert parts["4"].numbers["nearest_relative_distance"] > 0.1  # facts: no permutation of Q with any r gives them


def test_where_the_printed_gains_hold(parts: dict[str, Claim]) -> None:
    loops = parts["4"].numbers["largest_eigenvalue"]
    assert loops["printed A, B as printed"] == pytest.approx(1.0094, abs=5e-5)  # facts: yaw slowly diverges
    assert loops["printed A, B, yaw inputs turned"] < 1
    assert loops["nxtway-gs"] == pytest.approx(5, abs=0.5)  # facts: an eigenvalue near −5


def test_the_search_finds_a_gain_that_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    diagonal, price = [1.0, 80.0, 1.0, 1.0, 800.0, 1.0], 100.0
    model = regulator.without_noise(printed.A, printed.B)
    A, B, R = model.A, model.B, price * np.eye(2)
    P = solve_discrete_are(A, B, np.diag(diagonal), R)
    planted = np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)[0]
    monkeypatch.setattr(printed, "KU1", planted)
    monkeypatch.setattr(regulator, "PRICES", (0.3 * price, price, 3.0 * price))
    distance, order, r = regulator.nearest_gain()
    assert distance < 1e-6  # two Riccati solvers' residues
    assert (order, r) == (diagonal, pytest.approx(price))


# Chapter 5


@pytest.mark.parametrize("part", PUSHED)
def test_nothing_falls_and_the_hold_is_reached(parts: dict[str, Claim], part: str) -> None:
    claim = parts[part]
    hold = claim.numbers["hold"]
    robot = Robot.preset("nxtway-gs" if part in ("5a", "5b") else "herrera2015")
    weight = robot.body_mass * robot.gravity * robot.com_height
    # statics with the force at the centre of mass: MgL sin ψ = −F (L cos ψ + R)
    force = -weight * math.sin(hold) / (robot.com_height * math.cos(hold) + robot.wheel_radius)
    assert claim.numbers["force"] == pytest.approx(force, rel=1e-12)
    assert len(claim.logs) == 3
    for name, log in claim.logs.items():
        assert log.t[-1] == pytest.approx(pushes.SECONDS - printed.PERIOD)  # to the end: it did not fall
        held = (log.t > pushes.RELEASE - 1) & (log.t < pushes.RELEASE)
        # 5 %: the linear model has sin ψ = ψ, 0.3 %, and the regulator still creeps; the twin also has its sensors
        assert np.mean(log["truth/pitch"][held]) == pytest.approx(hold, rel=0.05), name
        assert np.abs(log["truth/pitch"][-100:]).max() < 0.1 * abs(hold)  # and it came back


def test_claims_follow_from_their_cases(parts: dict[str, Claim]) -> None:
    numbers = parts["5e"].numbers
    cases, claims = numbers["cases"], numbers["claims"]
    assert len(cases) == 4
    for case in cases.values():
        assert len(case["correlation"]) == len(case["largest_yaw"]) == len(case["settling"]["twin"]) == 6
        assert min(case["correlation"]) > 0.99  # two curves of one shape, whatever the noise
    # the models have the same equations at small angles, and the settling times of both are one to the sample: 0.01 s
    models = [[case["settling"][name][0] for name in pushes.MODELS] for case in cases.values()]
    assert all(abs(one - other) < 0.01 for one, other in models)
    assert claims["the linear model settles fastest"] is False
    assert claims["shapes are alike"] is True
    assert claims["yaw is negligible"] is (max(max(case["largest_yaw"]) for case in cases.values()) <= math.radians(1))
    # a rest that the noise of the sensors reaches later or earlier than the models, by chance, decides nothing
    twins = [[s is None or s > max(of) for s in case["settling"]["twin"]]
             for case, of in zip(cases.values(), models, strict=True)]  # fmt: skip
    assert (claims["settling times differ"] is None) == any(len(set(later)) == 2 for later in twins)
    assert parts["5e"].verdict == IN_PART
    held = list(claims.values()).count(True)
    assert str(parts["5e"].summary).startswith(f"{held} of {len(claims)} conclusions hold")


def planted(decay: float, yaw: float = 0.0, sign: float = 1.0) -> Log:
    """Held at 0.1 rad until the release, then an exponential of `decay` [1/s]; yaw a constant."""
    t = np.arange(0, pushes.SECONDS, 0.01)
    after = np.clip(t - pushes.RELEASE, 0, None)
    pitch = sign * 0.1 * np.exp(-decay * after)
    values: dict[str, Any] = {f"truth/{s.name}": np.zeros_like(t) for s in STATE}
    values |= {"truth/pitch": pitch, "truth/wheel": -pitch, "truth/yaw": np.full_like(t, yaw)}
    values |= {"push/force": np.where(t < pushes.RELEASE, -0.4, 0.0)}
    values |= {f"{kind}/{side}": -pitch for kind in ("command", "applied") for side in ("left", "right")}
    units = {name: "V" if "/left" in name or "/right" in name else "rad" for name in values}
    return Log(t, values, units)


def measured(**options: dict[str, float]) -> pushes.Measured:
    logs = {"twin": {"decay": 2.0}, "nonlinear": {"decay": 2.0}, "linear": {"decay": 2.0}} | options
    return pushes.measure([compare({name: planted(**given) for name, given in logs.items()})])


def test_a_robot_that_falls_has_no_rest_and_never_settles() -> None:
    """With guessed friction and backlash the robot of 5f is near its limit, and one run in sixteen falls."""
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    controller = Estimated(lqr_state(robot, 0.01), kalman(robot, kit))
    fallen, held = (
        run(Electronics(NonlinearBody(robot), kit), controller, Hold(pitch=pitch, until=8.0), seconds=16.0, seed=1)
        for pitch in (0.6, 0.05)
    )
    assert fallen.t[-1] < 14.0
    others = {name: [held] for name in as_built.OTHERS}
    one = as_built.settled({as_built.AS_BUILT: [fallen, held], **others})
    assert one.rest[as_built.AS_BUILT][0] == math.inf
    assert 0 < one.rest[as_built.AS_BUILT][1] < 0.05
    assert one.settling["5 %"][as_built.AS_BUILT][0] == math.inf


def test_friction_keeps_a_robot_from_settling_as_fast_as_its_models(parts: dict[str, Claim]) -> None:
    numbers = parts["5f"].numbers
    assert parts["5f"].verdict == REPRODUCED
    for side in pushes.PUSHES:
        case, ideal = numbers["cases"][f"{side} push"], parts["5e"].numbers["cases"][f"herrera2015, {side} push"]
        # statics: a stuck wheel stays stuck until the gains of pitch, 85 V/rad on two motors of 0.047 N m/V, exceed
        # two dry frictions of 5 mN m, at 1.3 mrad; without friction and noise nothing keeps pitch off zero
        swings = [rest for rest in case["rest"][as_built.AS_BUILT] if rest is not None]  # one run in sixteen falls
        assert swings
        assert min(swings) > 1.3e-3 > max(case["rest"]["nonlinear"])
        for name in as_built.MODELS:
            assert case["settling"]["5 %"][name] == ideal["settling"][name]


@pytest.mark.parametrize(
    ("times", "slower"),
    [([2.0, 3.0], True), ([2.0, 1.005], None), ([1.0, 1.005], False), ([math.inf, 3.0], True)],
)
def test_a_robot_is_slower_where_every_seed_is(times: list[float], slower: bool | None) -> None:
    settling = {as_built.AS_BUILT: times, "nonlinear": [1.0], "linear": [0.9], "twin": [5.0]}
    assert as_built.Settled({"5 %": settling}, {}).slower is slower  # a sample is 0.01 s


@pytest.mark.parametrize(
    ("twins", "differs"),
    [
        ([2.0, 3.0, math.inf], True),  # all later than the models
        ([0.5, 0.8], True),  # all earlier
        ([0.8, 1.5], None),  # the noise decides
        ([1.0, 1.4], None),
        ([1.0, 1.005], False),  # within a sample of 0.01 s
    ],
)
def test_settling_times_differ_where_the_noise_does_not_decide(twins: list[float], differs: bool | None) -> None:
    settling = {"twin": twins, "nonlinear": [1.0], "linear": [1.001]}
    assert pushes.Measured([], settling, []).settling_differs is differs


def test_a_planted_decay_settles_when_it_must() -> None:
    claims = measured(linear={"decay": 4.0})
    # 5 % of an exponential: log(20)/decay, to a sample
    assert claims.settling["twin"] == [pytest.approx(math.log(20) / 2, abs=0.011)]
    assert claims.settling["linear"] == [pytest.approx(math.log(20) / 4, abs=0.011)]
    assert claims.linear_fastest
    assert not measured(twin={"decay": 4.0}).linear_fastest


def test_planted_shapes_and_yaw_are_distinguished() -> None:
    same = measured()
    assert same.correlation == [pytest.approx(1)]
    assert same.alike
    assert same.yaw_negligible
    assert measured(linear={"decay": 2.0, "sign": -1.0}).correlation == [pytest.approx(-1)]
    assert not measured(linear={"decay": 2.0, "sign": -1.0}).alike
    assert not measured(nonlinear={"decay": 2.0, "yaw": 0.02}).yaw_negligible  # 1.15°, which a compass shows
    assert measured(nonlinear={"decay": 2.0, "yaw": -0.02}).largest_yaw == [pytest.approx(0.02)]


def test_a_folder_that_cannot_be_made_is_one_clear_line(tmp_path: Any) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(UprightError, match=r"cannot write .*herrera2015.*; try: ") as caught:
        reproduce(tmp_path / "file" / "herrera2015")
    assert "\n" not in str(caught.value)


def test_a_finding_keeps_its_numbers_as_plain_json(parts: dict[str, Claim]) -> None:
    for claim in parts.values():
        json.dumps(claim.to_json(), allow_nan=False)


@pytest.mark.parametrize(
    ("holds", "says"),
    [
        ((True, True), REPRODUCED),
        ((True, False), IN_PART),
        ((True, False, None), IN_PART),  # whatever the unknown one is
        ((False, False), NOT_AS_PRINTED),
        ((True, None), UNKNOWN),
        ((False, None), UNKNOWN),
    ],
)
def test_one_rule_judges_every_claim_that_says_several_things(holds: tuple[bool | None, ...], says: str) -> None:
    assert judged(holds) == says
    assert (BADGES[says].level == "good") == all(holds)  # a claim reproduced in part is not green


# Chapter 6


def test_every_kind_of_controller_is_in_the_table(parts: dict[str, Claim]) -> None:
    rows = parts["6"].numbers["rows"]
    assert parts["6"].verdict == BEYOND
    assert {row["controller"] for row in rows} == set(controllers.METHODS)
    assert len(rows) == 2 * len(controllers.METHODS)  # two pushes each
    for row in rows:  # a row has its numbers, or says why it has none
        assert row["outcome"] == "yes" or row["outcome"].startswith(("fell", "no design"))
        assert (row["peak"] is None) == row["outcome"].startswith("no design")
