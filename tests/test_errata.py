"""Every misprint is proved by the derivation, and a misprint that is none is refused."""

import dataclasses
import math

import numpy as np
import pytest

from upright.paper import printed
from upright.paper.derivation import derive
from upright.paper.errata import ERRATA, WITNESS, prove

PROVABLE = [e for e in ERRATA if e.misprint is not None]


def proof_of(erratum, derivation=None):
    proof = prove(erratum, derivation)
    assert proof is not None
    return proof


def test_every_row_of_the_list_is_there():
    # every equation that the list of misprints of the paper names; (16) and (24) have several each
    for equation in (1, 2, 3, 10, 12, 13, 14, 15, 16, 19, 22, 24, 30, 31):
        assert any(f"({equation})" in e.equations for e in ERRATA), equation
    assert any("Δ" in e.equations for e in ERRATA)
    assert any("(25)" in e.printed and "(37)" in e.corrected for e in ERRATA)
    assert len(PROVABLE) == len(ERRATA) - 3  # Δ̇_e, the factor ½ and the wrong reference are slips of notation


@pytest.mark.parametrize("erratum", PROVABLE, ids=lambda e: f"{e.equations}: {e.printed[:20]}")
def test_the_corrected_form_is_derived_and_the_printed_one_is_not(erratum):
    proof = proof_of(erratum)
    assert proof.holds
    # identical expressions evaluated in another order: a hundred roundings at most, 100 ε
    assert proof.corrected_residual < 2.3e-14
    # the smallest misprint, the sign of the gyroscopic term, moves φ̈ by 4ML²ψ̇φ̇ sinψ cosψ / a33: see below
    assert proof.printed_residual > 5e-3
    assert erratum.printed != erratum.corrected
    assert erratum.why
    assert proof.derived


def test_the_size_of_a_misprint_is_what_arithmetic_says():
    # (24) by hand at WITNESS: J_m for J_w takes
    # W²/(2R²)(J_w − J_m) from a33 = 2.94e-4 + 1.06e-3 + 6.125·3.4e-5 + 3.1104e-3 sin²ψ
    (hub,) = [e for e in ERRATA if "(J_m + n² J_m)" in e.printed]
    a33 = 0.03 * 0.14**2 / 2 + 0.6 * (0.14**2 + 0.04**2) / 12 + 6.125 * 3.4e-5 + 3.1104e-3 * math.sin(0.1) ** 2
    lost = 6.125 * 1.4e-5
    # φ̈ = N/a33 becomes N/(a33 − lost); ten roundings of the closed form
    assert proof_of(hub).printed_residual == pytest.approx(lost / (a33 - lost), rel=1e-12)


def test_the_sign_of_the_gyroscopic_term_is_twice_the_term():
    (sign,) = [e for e in ERRATA if e.equations == "(16), (24)"]
    alpha = 0.317 / 6.69
    beta = alpha * 0.468 + 0.0022
    gyro = 2 * 0.6 * 0.072**2 * 0.5 * 3 * math.sin(0.1) * math.cos(0.1)
    motors = 1.75 * alpha * 2 - 6.125 * beta * 3  # W/(2R) = 1.75, v_r − v_l = 2 V, φ̇ = 3 rad/s
    assert (WITNESS["pitch"], WITNESS["yaw_rate"], WITNESS["right"] - WITNESS["left"]) == (0.1, 3.0, 2.0)
    # a dozen roundings and one cancellation of 5:1
    assert proof_of(sign).printed_residual == pytest.approx(2 * gyro / abs(motors - gyro), rel=1e-12)


def test_a_misprint_that_is_none_is_refused():
    assert not proof_of(dataclasses.replace(PROVABLE[0], misprint=lambda k: {})).holds


def test_the_corrected_equations_are_not_the_complete_model():
    # the paper's yaw equation lacks MLR φ̇θ̇ sinψ even when its misprints are mended
    (sign,) = [e for e in ERRATA if e.equations == "(16), (24)"]
    assert not proof_of(sign, derive("complete")).holds


def test_slips_of_notation_carry_a_reason_only():
    notes = [e for e in ERRATA if e.misprint is None]
    assert len(notes) == 3
    assert all(prove(e) is None and len(str(e.why)) > 20 for e in notes)


def test_the_printed_model_has_the_eigenvalues_computed_for_it():
    # known of (34): 1.0707, 1, 1, 0.9357, 0.0493, 0.0080, each to half a unit of its last digit
    eigenvalues = np.sort(np.linalg.eigvals(printed.A).real)
    assert np.abs(eigenvalues - [0.0080, 0.0493, 0.9357, 1, 1, 1.0707]).max() < 5e-5


def test_the_printed_pitch_gains_stabilise_the_printed_model():
    # known: |eigenvalues| 0.94, 0.94, 0.973, 0.02 of the pitch part, and yaw diverging at 1.0094
    pitch = np.abs(np.linalg.eigvals((printed.A - printed.B @ printed.K)[:4, :4]))
    assert np.sort(pitch) == pytest.approx([0.02, 0.94, 0.94, 0.973], abs=0.005)
    assert np.linalg.eigvals((printed.A - printed.B @ printed.K)[4:, 4:]).real.max() == pytest.approx(1.0094, abs=5e-4)


def test_printed_numbers_cannot_be_changed():
    for array in (printed.A, printed.B, printed.Q, printed.R, printed.K):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0
    assert (printed.SAMPLES, printed.PERIOD, printed.FRONT_PUSH, printed.BACK_PUSH) == (2000, 0.01, 0.1, -0.12)
