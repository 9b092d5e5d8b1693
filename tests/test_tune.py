"""Tuning: it finds a known optimum, judges on robots of their own, resumes to the same bytes, and is never worse."""

from __future__ import annotations

import itertools
import math
import re
import threading
import time
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.stats import binomtest

from upright.bodies import Electronics, NonlinearBody
from upright.certification.checks import TrialSetup, kernel_controller
from upright.certification.recovery import KNOCK_DURATION
from upright.certification.verdict import LinearMargins, linear_margins
from upright.cli.main import main
from upright.control import CONTROLLERS, controller_hash, lqg, make_controller
from upright.control.files import read_controller
from upright.control.tunable import UNITS, WIDTH
from upright.errors import UprightError
from upright.experiment import Impulse, outcome_of, run
from upright.loops.analysis import analyse
from upright.loops.margins import margins
from upright.reports import report
from upright.robots import Robot, Sensor, find_kit
from upright.robots.uncertainty import draw
from upright.tuning import tune as room
from upright.tuning.figures import MEASURES, WATCHED, Figures, chance_of, fell_once, knock, slack
from upright.tuning.parallel import working
from upright.tuning.score import NONE, CandidateScore, Scorer, modulus_and_delay, row_of, score_from
from upright.tuning.search import SearchRecord, search
from upright.tuning.tune import CHOSEN, JUDGED, SEARCHED, Point, Tuned, tune

pytestmark = pytest.mark.needs("module:cma")

NXT = Robot.preset("nxtway-gs")
KIT = find_kit(NXT.kit)
FUSED = replace(KIT, sensors=KIT.sensors | {"sensor/pitch": Sensor()})  # for all methods
TUNABLE = [name for name, method in CONTROLLERS.items() if method.tunable]
GOOD = CandidateScore(fell=0.0, down=0.0, knock=0.3, settling=1.0, effort=100.0, over=-0.5, modulus=0.4, excess=0.0)


def test_the_methods_with_weights_can_be_tuned() -> None:
    assert TUNABLE == ["lqr", "lqi", "lqg", "pid", "pid-angle", "hinf", "mpc", "sliding"]


@pytest.mark.parametrize("name", TUNABLE)
def test_the_default_weights_give_the_default_controller(name: str) -> None:
    method = CONTROLLERS[name]
    assert method.tunable
    weights = method.tunable.defaults(NXT, FUSED, KIT.period)
    assert all(value > 0 and weight in UNITS for weight, value in weights.items())
    tuned, plain = method.tuned(NXT, FUSED, KIT.period, weights), make_controller(name, NXT, FUSED, KIT.period)
    assert controller_hash(tuned) == controller_hash(plain)


@pytest.mark.parametrize("name", TUNABLE)
def test_every_weight_changes_the_controller(name: str) -> None:
    """By a fifth, which no weight is allowed to ignore."""
    method = CONTROLLERS[name]
    assert method.tunable
    weights = method.tunable.defaults(NXT, FUSED, KIT.period)
    plain = controller_hash(method.tuned(NXT, FUSED, KIT.period, weights))
    for weight in weights:
        other = method.tuned(NXT, FUSED, KIT.period, weights | {weight: 1.2 * weights[weight]})
        assert controller_hash(other) != plain, weight


def test_a_weighted_method_of_a_file_is_tuned_by_the_sizes_of_the_pitch_plane(tmp_path: Path) -> None:
    text = "from upright.control.methods import CONTROLLERS, Method\n"
    text += "Mine = Method(make=CONTROLLERS['lqg'].make, weighted=True)\n"
    (tmp_path / "mine.py").write_text(text)
    method = CONTROLLERS[f"{tmp_path / 'mine.py'}:Mine"]
    assert method.tunable
    weights = method.tunable.defaults(NXT, KIT, KIT.period)
    assert list(weights) == ["pitch", "pitch_rate", "wheel", "wheel_rate"]
    tuned = method.tuned(NXT, KIT, KIT.period, weights)
    assert controller_hash(tuned) == controller_hash(lqg(NXT, KIT))


OPTIMUM = {"a": 3.0, "b": 0.2, "c": 1.4}


def bowl(weights: Mapping[str, float]) -> CandidateScore:
    """The less falls, the nearer every weight is to `OPTIMUM` in its logarithm."""
    away = sum(math.log(weights[name] / value) ** 2 for name, value in OPTIMUM.items())
    return replace(GOOD, fell=min(1.0, away / 30), down=min(1.0, away / 30))


def test_the_search_finds_a_known_optimum() -> None:
    """CMA-ES takes some 100 evaluations for each number of a quadratic to come within a few per cent (Hansen 2016)."""
    done = search(dict.fromkeys(OPTIMUM, 1.0), bowl, 300, 0, SearchRecord(""))
    assert len(done) <= 300
    best = min(done, key=lambda one: one.score.fell).weights
    for name, value in OPTIMUM.items():
        assert best[name] == pytest.approx(value, rel=0.05)


def test_the_search_stays_within_its_bounds_and_tries_the_default_first() -> None:
    def far(weights: Mapping[str, float]) -> CandidateScore:
        return replace(GOOD, fell=1 / (1 + weights["a"]))

    done = search({"a": 2.0, "b": 1.0}, far, 120, 0, SearchRecord(""))
    assert done[0].weights == {"a": 2.0, "b": 1.0}
    most = max(one.weights["a"] for one in done)
    assert most <= 2.0 * WIDTH * (1 + 1e-9)  # rounding of exp(log)
    assert most > WIDTH


@pytest.mark.parametrize("known", [1, 4, 20])
def test_a_resumed_search_asks_for_what_is_missing_and_ends_alike(tmp_path: Path, known: int) -> None:
    file, names = tmp_path / "x.search", dict.fromkeys(OPTIMUM, 1.0)
    whole = search(names, bowl, 60, 7, SearchRecord("this"))
    SearchRecord("this", file, [one.score for one in whole[:known]]).keep()
    asked: list[Mapping[str, float]] = []

    def counted(weights: Mapping[str, float]) -> CandidateScore:
        asked.append(weights)
        return bowl(weights)

    assert search(names, counted, 60, 7, SearchRecord("this", file).resumed()) == whole
    assert asked == [one.weights for one in whole[known:]]


def test_threads_change_nothing_of_a_search() -> None:
    """Though the scores of a generation come in another order: the first weights take the longest."""

    def slow(weights: Mapping[str, float]) -> CandidateScore:
        time.sleep(0.01 * min(1.0, weights["a"]))
        return bowl(weights)

    names = dict.fromkeys(OPTIMUM, 1.0)
    alone, together = SearchRecord("this"), SearchRecord("this")
    assert search(names, bowl, 40, 7, alone) == search(names, slow, 40, 7, together, threads=4)
    assert alone.scores == together.scores


def test_what_has_not_begun_when_a_search_is_stopped_is_given_up() -> None:
    begun, free = list[int](), threading.Event()

    def work(number: int) -> None:
        begun.append(number)
        free.wait(60)

    with pytest.raises(KeyboardInterrupt), working(work, 2) as results:  # noqa: PT012 (the work is asked for inside)
        results(range(9))
        raise KeyboardInterrupt  # which has to come through while both threads are at work
    free.set()
    assert len(begun) <= 2


def test_a_search_leaves_numpys_own_random_numbers_alone() -> None:
    np.random.seed(1)
    before = np.random.get_state()[1].copy()  # type: ignore[union-attr]
    search(dict.fromkeys(OPTIMUM, 1.0), bowl, 30, 0, SearchRecord(""))
    assert (np.random.get_state()[1] == before).all()


def test_weights_without_a_design_cost_more_than_any_other() -> None:
    def broken(weights: Mapping[str, float]) -> CandidateScore:
        return NONE if weights["a"] > 1.5 else replace(GOOD, fell=1 / weights["a"])

    done = search({"a": 1.0, "b": 1.0}, broken, 100, 0, SearchRecord(""))
    best = min((one for one in done if one.score.stable), key=lambda one: one.score.fell)
    assert best.weights["a"] == pytest.approx(1.5, rel=0.03)  # the border, from the side that has a design


def test_scores_survive_a_file() -> None:
    for score in (GOOD, NONE):
        assert score_from(row_of(score)) == score


def test_search_rule_and_figures_see_other_robots() -> None:
    """Also other than those of a certificate with the same seed."""
    drawn = [{r.com_height for r in draw(NXT, 200, base + 3)} for base in (0, SEARCHED, CHOSEN, JUDGED)]
    assert len(set[float]().union(*drawn)) == 4 * 200


def some(**changes: Any) -> Figures:
    linear = LinearMargins(0.99, 0.7, 1.3, 0.01)
    given: dict[str, Any] = {
        "samples": 1000, "fallen": tuple(range(10)), "knock": 0.3, "settling": 1.0, "effort": 9.0, "saturated": 0.1,
        "travel": 0.5, "sway": 0.01, "linear": linear, "light": "green", "reasons": (),
    }  # fmt: skip
    return Figures(**given | changes)


@pytest.mark.parametrize(
    ("changes", "worse"),
    [
        ({"fallen": tuple(range(9)), "knock": 0.4, "effort": 99.0}, []),
        ({"fallen": tuple(range(14))}, []),  # 4 of 4 by chance: 1/16
        ({"fallen": tuple(range(15))}, ["falls"]),  # 5 of 5: 1/32
        ({"fallen": tuple(range(10, 20))}, []),  # as many others
        ({"light": "amber"}, ["light"]),
        ({"knock": 0.29}, ["knock"]),
        ({"knock": 0.297}, []),
        ({"linear": LinearMargins(0.99, 0.72, 1.4, 0.01)}, ["gain margin"]),
        ({"linear": LinearMargins(0.99, 0.6, 1.9, 0.009)}, ["delay margin"]),
        ({"linear": LinearMargins(1.01, 1.0, 1.0, 0.0)}, ["stability"]),
    ],
)
def test_worse_names_what_is(changes: dict[str, Any], worse: list[str]) -> None:
    assert some(**changes).worse(some()) == worse


@pytest.mark.parametrize(
    ("before", "after", "lost"),
    [
        ({}, {"settling": 1.01}, []),  # within 2 %
        ({}, {"settling": 1.5}, ["settling"]),
        ({}, {"effort": 12.0, "sway": 0.02}, ["effort", "sway"]),
        ({}, {"travel": 0.6, "saturated": 0.2}, ["saturated", "travel"]),
        # the rule goes by the least margin, which is that of motors that are stronger
        ({"linear": LinearMargins(0.99, 0.6, 1.2, 0.01)}, {"linear": LinearMargins(0.99, 0.75, 1.25, 0.01)},
         ["weaker"]),
        ({"linear": LinearMargins(0.99, 0.9, 1.9, 0.01)}, {"linear": LinearMargins(0.99, 0.8, 1.3, 0.01)},
         ["stronger"]),
        ({"linear": LinearMargins(0.99, 0.9, 1.2, 0.01)}, {"linear": LinearMargins(0.99, 0.8, 1.3, 0.01)}, []),
    ],
)  # fmt: skip
def test_what_is_worse_although_the_rule_does_not_compare_it_is_named(
    before: dict[str, Any], after: dict[str, Any], lost: list[str]
) -> None:
    assert not some(**after).worse(some(**before))
    assert [m.name for m in MEASURES if m.change(some(**before), some(**after)) == "paid"] == lost


def test_falls_are_compared_on_the_same_robots_by_an_exact_test() -> None:
    """scipy's own sign test of the robots that fell once; how many fell under both tells nothing."""
    for here, there in itertools.product(range(12), range(12)):
        one = some(fallen=(*range(5), *range(100, 100 + here)))
        other = some(fallen=(*range(5), *range(200, 200 + there)))
        assert fell_once(one, other) == (here, there)
        exact = binomtest(here, here + there, alternative="greater").pvalue if here + there else 1.0
        assert chance_of(here, there) == pytest.approx(exact)
        assert one.falls_more(other) == (exact < 0.05)


def test_of_falls_that_cannot_be_told_apart_the_rest_decides() -> None:
    """7 against 6 falls were refused, though the effort is smaller; 16 against 6 are more falls."""
    default = Point({}, some(fallen=tuple(range(6))))
    calm = Point({}, some(fallen=tuple(range(7)), effort=6.0))
    risky = Point({}, some(fallen=tuple(range(16)), effort=3.0))
    assert room._picked([default, calm, risky]) is calm
    assert room._picked([default, risky]) is default


def tuned_of(default: Figures, candidate: Figures, *, refused: bool = False) -> Tuned:
    """A tuning of one candidate beside the default, which is chosen unless `refused`."""
    points = (Point({"pitch": 0.15}, default), Point({"pitch": 0.1}, candidate))
    picked = 0 if refused else 1
    return Tuned(
        method="lqg", robot="nxtway-gs", kit="nxt", seed=0, budget=2, evaluated=2, controller=lqg(NXT, KIT),
        defaults=points[0].weights, weights=points[picked].weights, default=default, chosen=points[picked].figures,
        front=points, picked=picked, refused=candidate if refused else None,
    )  # fmt: skip


@pytest.mark.parametrize(("light", "title", "change"), [
    ("green", "A better light: green instead of amber", "better"), ("amber", "Effort 6", "alike"),
])  # fmt: skip
def test_a_light_is_better_or_worse_and_says_so(light: str, title: str, change: str) -> None:
    default, chosen = some(light="amber"), some(light=light, effort=9.0 if light == "green" else 6.0)
    page = tuned_of(default, chosen).page()
    assert str(page.title).startswith(title)
    (row,) = [row for row in page.blocks[0].rows if str(row[0]) == "light"]
    assert str(row[-1].text if hasattr(row[-1], "text") else row[-1]) == change
    assert default.light_beside(chosen) == ("paid" if light == "green" else "")


def test_what_is_refused_is_told_in_numbers() -> None:
    """25 of 1000 fell where 18 did under the default: the page had said "worse in falls", without either."""
    default, refused = some(fallen=tuple(range(18))), some(fallen=tuple(range(25)), effort=6.0)
    tuned = tuned_of(default, refused, refused=True)
    page = tuned.page()
    assert [str(fact) for fact in page.title.facts["worse"]] == ["falls"]
    assert str(page.numbers[0].value) == "18 → 25"
    told = tuned.to_json()
    assert (told["changes"]["falls"], told["changes"]["effort"], told["changes"]["knock"]) == ("paid", "won", "")
    assert told["refused"]["fell"] == 25
    assert told["paired"]["more_by_chance"] == pytest.approx(1 / 2**7)  # all seven on one side
    assert len(tuned.plot().axes[0].patches) == len(MEASURES)


def test_modulus_and_delay_are_those_of_the_analysis() -> None:
    """1 / Ms there is refined between frequencies; the grid's steps of 3 % miss a peak by less than 2 %. A delay is one
    of the readings and of both motors, by their phase."""
    controller = lqg(NXT, KIT)
    analysis = analyse(controller, NXT, KIT, robots=[NXT])
    peaks = [analysis.both().Ms, *(m.Ms for m in analysis.outputs)]
    modulus, delay = modulus_and_delay(analysis.loop)
    assert modulus == pytest.approx(1 / max(peaks), rel=0.02)
    directions = [(analysis.loop.at_input, [1.0, 1.0])] + [(analysis.loop.at_output, row) for row in np.eye(3)]
    phases = [margins(model, direction, peaks=False).delay for model, direction in directions]
    assert delay == pytest.approx(min(phases), rel=0.01)


def test_margins_below_the_defaults_are_seen_without_their_computation() -> None:
    method, default = CONTROLLERS["lqg"], CONTROLLERS["lqg"].tunable
    assert default
    weights = default.defaults(NXT, KIT, KIT.period)
    floor = linear_margins(lqg(NXT, KIT), NXT, KIT)
    assert floor
    scorer = Scorer(method, NXT, KIT, [NXT], period=KIT.period, seed=0, threads=1, floor=floor)
    seen: set[bool] = set()
    for name, factor in (("pitch", 0.3), ("motor_noise", 3.0), ("motor_noise", 0.2), ("wheel", 4.0)):
        other = {**weights, name: factor * weights[name]}
        mine = linear_margins(method.tuned(NXT, KIT, KIT.period, other), NXT, KIT)
        assert mine
        more = slack(mine) > 1.01 * slack(floor) and mine.delay > 1.01 * floor.delay
        less = slack(mine) < slack(floor) or mine.delay < floor.delay
        if more or less:  # neither: within a per cent of the floor
            assert (scorer(other).excess > 0) == less
            seen.add(less)
    assert True in seen


def test_the_largest_knock_is_that_of_single_runs() -> None:
    """The loop of `run` on the nonlinear body, knock by knock, which shares nothing with the kernel but the equations;
    its noise is another, and sizes are 1.2 % apart in one, 2 % in the other."""
    controller = lqg(NXT, KIT)
    found = knock(TrialSetup(NXT, [NXT], KIT, controller=kernel_controller(controller, NXT, KIT), threads=1))
    body = Electronics(NonlinearBody(NXT), KIT)

    def stands(size: float) -> bool:
        ways = [Impulse(impulse=way * size, start=0.5, duration=KNOCK_DURATION) for way in (1, -1)]
        logs = [run(body, controller, push, seconds=0.5 + KNOCK_DURATION + WATCHED, seed=3) for push in ways]
        return not any(outcome_of(log).fell for log in logs)

    assert stands(0.96 * found)
    assert not stands(1.04 * found)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """A tuning of seconds: few robots and few finalists."""
    for name, value in (("ROBOTS", 6), ("DRAWN", 12), ("CHOICE", 100), ("FINALISTS", 1)):
        monkeypatch.setattr(room, name, value)


@pytest.mark.evidence
@pytest.mark.usefixtures("small")
def test_an_interrupted_tuning_goes_on_to_the_same_bytes(tmp_path: Path) -> None:
    given: dict[str, Any] = {"budget": 18, "samples": 100, "seed": 5, "threads": 1}
    whole = tune("lqg", NXT, **given)
    state = tmp_path / "tuned.json.search"

    def stop(fraction: float) -> None:
        if fraction > 0.6:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        tune("lqg", NXT, **given, state=state, progress=stop)
    assert state.exists()
    with pytest.raises(UprightError, match="another search"):
        tune("lqg", NXT, **given | {"seed": 6}, state=state, resume=True)
    resumed = tune("lqg", NXT, **given | {"threads": 3}, state=state, resume=True)
    assert resumed.to_json() == whole.to_json()
    assert not state.exists()
    assert whole.check() == ()
    assert not whole.chosen.worse(whole.default)
    path = whole.save(tmp_path / "tuned.json")
    assert controller_hash(read_controller(path)) == controller_hash(whole.controller) == whole.to_json()["hash"]
    page = report(whole, tmp_path / "tune.html").read_text("utf-8")
    assert "Weights" in page
    assert whole.to_json()["changes"].keys() == {m.name for m in MEASURES}


@pytest.mark.parametrize(
    ("method", "changes", "part"),
    [
        ("lqgg", {}, "lqg"),
        ("robust", {}, "lqr, lqi, lqg, pid, pid-angle, hinf, mpc, sliding"),
        ("lqg", {"budget": 0}, "candidates"),
        ("lqg", {"samples": 5}, "100"),
        ("lqg", {"seed": -1}, "seed"),
        ("lqg", {"seconds": 0.0}, "more than zero"),
        ("lqg", {"seconds": math.nan}, "more than zero"),
        ("lqg", {"resume": True}, "-o"),
        ("lqg", {"resume": True, "state": "missing.search"}, "missing.search"),
        ("lqg", {"resume": True, "state": __file__}, "JSON"),
        ("lqg", {"state": "/nowhere/x.search"}, "nowhere"),
    ],
)
def test_what_cannot_be_tuned_is_reported(method: str, changes: dict[str, Any], part: str) -> None:
    with pytest.raises(UprightError, match=part):
        tune(method, NXT, **changes)


def test_the_help_names_every_method_that_can_be_tuned(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tune", "--help"]) == 0
    listed = re.search(r"Method: ([^.]+)\.", " ".join(capsys.readouterr().out.split()))
    assert listed
    assert set(re.split(r", | or ", listed[1])) == {name for name, method in CONTROLLERS.items() if method.tunable}
