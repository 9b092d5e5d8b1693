"""Messages of the lab: exact, bounded, and the same in Python and TypeScript."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any, get_args, get_type_hints

import pytest
from annotated_types import Interval

from upright.lab import messages
from upright.lab.codec import KINDS, InvalidMessage, decode, encode, plain
from upright.lab.message_types import ErrorParts
from upright.lab.messages import (
    Ack,
    Change,
    Drag,
    Hello,
    Notice,
    Play,
    Save,
    Scrub,
    Setup,
    Snapshot,
    StandUp,
    Start,
    Steer,
    Step,
    Strike,
)  # fmt: skip
from upright.lab.typescript import SCRIPT, generate, script

TARGET = Path(__file__).resolve().parents[1] / "src/upright/lab/web/src/messages.ts"

GOOD = [
    Hello(1, "abc", "token", "Ana", Setup(controller="pid")), Ack(3), Change(Setup(numbers={"body_mass": 0.7})),
    Drag(1.5, 0.1), Strike("front", 0.1), Steer(0.2, -1.0), Play(True), Step(5), Scrub(3.5), StandUp(0.1),
    Start("certify"), Save("report"),
]  # fmt: skip


@pytest.mark.parametrize("message", GOOD, ids=lambda m: type(m).__name__)
def test_a_message_comes_back_as_it_was(message):
    assert decode(encode(message)) == message


def test_typescript_is_what_the_dataclasses_say():
    """Run `python -m upright.lab.typescript` after a change of a message."""
    assert TARGET.read_text("utf-8") == generate()
    assert generate().startswith("// Generated")


def test_the_script_of_a_result_s_page_is_the_same_in_the_lab():
    """Run `python -m upright.lab.typescript` after a change of pages/hover.js."""
    assert SCRIPT.read_text("utf-8") == script()


def test_every_message_of_the_server_has_a_type_in_the_page():
    text = TARGET.read_text("utf-8")
    for kind in (*get_args(messages.ClientMessage), *get_args(messages.ServerMessage)):
        assert f'export interface {kind.__name__} {{\n  kind: "{kind.__name__}";' in text


BAD = [
    "", "null", "[]", "1", '"x"', "{", "{}", '{"kind":1}', '{"kind":"Nothing"}', '{"kind":"__class__"}',
    '{"kind":"Uploaded","what":"log","path":"/etc/passwd","name":"x"}',  # only the server says so
    '{"kind":"Drag"}', '{"kind":"Drag","force":1}', '{"kind":"Drag","force":"1","height":0}',
    '{"kind":"Drag","force":true,"height":0}', '{"kind":"Drag","force":NaN,"height":0}',
    '{"kind":"Drag","force":Infinity,"height":0}', '{"kind":"Drag","force":1e999,"height":0}',
    '{"kind":"Drag","force":501,"height":0}', '{"kind":"Drag","force":null,"height":0}',
    '{"kind":"Drag","force":1,"height":0,"more":1}', '{"kind":"Step","periods":1.5}', '{"kind":"Step","periods":0}',
    '{"kind":"Step","periods":1000000}', '{"kind":"Play","paused":1}', '{"kind":"Play","paused":true,"speed":1000}',
    '{"kind":"Strike","what":"hammer","size":1}', '{"kind":"Strike","what":["front"],"size":1}',
    '{"kind":"Start","job":"rm"}', '{"kind":"Start","job":"doctor","file":"' + "x" * 201 + '"}',
    '{"kind":"Start","job":"doctor","file":"a\\nb"}', '{"kind":"Change","setup":[]}', '{"kind":"Change","setup":null}',
    '{"kind":"Change","setup":{"bodies":["twin","dragon"]}}', '{"kind":"Change","setup":{"bodies":"twin"}}',
    '{"kind":"Change","setup":{"gains":[' + ",".join("1" * 1 for _ in range(65)) + "]}}",
    '{"kind":"Change","setup":{"numbers":{"body_mass":"heavy"}}}', '{"kind":"Change","setup":{"noise":-1}}',
    '{"kind":"Change","setup":{"noise":21}}', '{"kind":"Change","setup":{"seed":1e9}}',
    '{"kind":"Hello","version":"1"}', "[" * 5000, '{"kind":"Ack","n":' + "9" * 5000 + "}",
    '{"kind":"Drag","force":1,"height":0}' + " " * 70000,
]  # fmt: skip


@pytest.mark.parametrize("text", BAD, ids=lambda text: text[:40] or "nothing")
def test_what_is_no_message_is_refused_in_one_line(text):
    with pytest.raises(InvalidMessage) as refused:
        decode(text)
    assert "\n" not in str(refused.value)
    assert len(str(refused.value)) < 400


def test_numbers_that_json_lacks_become_null():
    shot = Snapshot(n=1, t=0.0, x=((float("nan"), 1.0),), e=(), f=(float("inf"),), r=(), s=0, paused=False)
    sent = json.loads(encode(shot))
    assert sent["x"] == [[None, 1.0]]
    assert sent["f"] == [None]


def test_a_message_is_plain_data_whatever_it_holds():
    parts = {"came": "π ψ", "expected": "", "likely": "", "hint": "", "verb": ""}
    assert plain(Notice("info", {"en": ErrorParts("π ψ")})) == {
        "level": "info", "parts": {"en": parts}, "key": "", "job": "", "kind": "Notice",
    }  # fmt: skip
    assert "π" in encode(Notice("info", {"en": ErrorParts("π")}))


def hostile(rng: random.Random) -> str:
    """A good message with something wrong in it, or anything at all."""
    data = json.loads(encode(rng.choice(GOOD)))
    for _ in range(rng.randint(1, 3)):
        data = _spoilt(data, rng)
    text = json.dumps(data)
    if rng.random() < 0.3:
        at = rng.randrange(len(text) + 1)
        text = (
            text[:at]
            + rng.choice(["", "\x00", '"', "}", "[[[", "\ud800", "9" * 400, "é"])
            + text[at + rng.randint(0, 4) :]
        )
    return text


def _spoilt(data: Any, rng: random.Random) -> Any:
    values = [None, True, -1, 0, 2**63, 1e308, -1e-320, "", "x" * 300, "../../etc", [], [[]], {}, {"kind": "Hello"}]
    if isinstance(data, dict) and data and rng.random() < 0.9:
        key = rng.choice(list(data))
        choice = rng.random()
        if choice < 0.15:
            del data[key]
        elif choice < 0.3:
            data[rng.choice(["__proto__", "kind", "x", key + " "])] = rng.choice(values)
        else:
            data[key] = _spoilt(data[key], rng)
        return data
    return rng.choice(values)


def test_hostile_text_is_a_message_within_its_bounds_or_refused():
    """Whatever passes is a message that encodes again: 5000 spoilt ones with a fixed seed."""
    rng = random.Random(1)
    passed = 0
    for _ in range(5000):
        try:
            message = decode(hostile(rng))
        except InvalidMessage:
            continue
        passed += 1
        assert type(message) in KINDS.values()
        for name, hint in get_type_hints(type(message), include_extras=True).items():
            for limit in getattr(hint, "__metadata__", ()):
                if isinstance(limit, Interval):
                    assert limit.ge <= getattr(message, name) <= limit.le
        assert decode(encode(message)) == message
    assert 0 < passed < 2500  # both happen
