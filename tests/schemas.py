"""The schemas of results, made from real runs and the types of their classes: `python tests/schemas.py` writes them.

What a key of the JSON is called like, an attribute of the result has its type, its unit and its sentence; where what
was written does not fit the type, what was written counts. A file of the same version is never changed.
"""

from __future__ import annotations

import contextlib
import inspect
import io
import json
import os
import re
import shutil
import sys
import tempfile
import types
import typing
from collections.abc import Mapping, Sequence
from dataclasses import fields, is_dataclass
from functools import cache, reduce
from pathlib import Path
from typing import Any, Literal, Union, get_args, get_origin

from jsonschema import Draft202012Validator

from upright.certification.verdict import AMBER, GREEN, RED, UNKNOWN
from upright.checkup.finding import SEVERITIES
from upright.pages import Say
from upright.signals import Log

FOLDER = Path(__file__).resolve().parents[1] / "src" / "upright" / "pages" / "schemas"
Schema = dict[str, Any]

PLAIN: dict[Any, Schema] = {
    str: {"type": "string"}, Say: {"type": "string"}, int: {"type": "integer"}, bool: {"type": "boolean"},
    type(None): {"type": "null"}, float: {"type": ["null", "number"]},
}  # fmt: skip
"""A float that JSON does not have, infinite or not known, is null."""

OPEN = {"origin", "subject", "numbers", "facts"}
"""What says where a result comes from, as much as is known, and what each claim on the paper and each sentence has of
its own."""

NAMED = {
    "logs", "in_the_loop", "effects", "drawn", "outcomes", "changes", "columns", "fit", "fit_answered", "units",
    "computing_time", "by_hand", "labels", "shares", "correlations", "ranges", "likelier", "noise", "counts",
    "weakest", "settling", "fits", "versions",
}  # fmt: skip
"""Objects whose keys are names of robots, logs, methods, parameters or signals."""

TEXT = {"log", "file", "folder", "repaired", "law"}
"""What is text where it is not null."""

ATTRIBUTES = {
    "unstable_pole": "pole",
    "in_the_loop": "trials",
    "let_go": "release",
    "design": "record",
    "grades": "rows",
}
"""Key → the attribute that it shows, where that has another name."""

CHOICES = {"light": [GREEN, AMBER, RED, UNKNOWN], "severity": list(SEVERITIES)}
"""Words of which there are no others."""

VARIED = {"record"}
"""What each method says in its own words."""

PARTS = ("summary",)
"""Attributes whose own keys stand among those of the result."""

NUMBERS = {
    "doubling", "settling_2", "settling_5", "overshoot", "release", "pitch_apart", "explained", "breaks", "fell_at",
    "deviations",
}  # fmt: skip
"""Numbers of plain objects that no run of those below has, and whose type is therefore not known otherwise."""

HEAD: Schema = {
    "type": "object",
    "description": "What the page begins with, in words; of a command's --json alone.",
    "properties": {
        "title": {"type": "string"},
        "verdict": {
            "type": ["null", "object"],
            "properties": {"text": {"type": "string"}, "level": {"enum": ["good", "warn", "bad", "unknown", "info"]}},
            "required": ["text", "level"],
        },
        "numbers": {"type": "array", "items": {"type": "array", "items": {"type": "string"}}},
        "next": {"type": "array", "items": {"type": "string"}, "description": "Commands to run next."},
    },
    "required": ["title", "verdict", "numbers", "next"],
}

BESIDE = ("head", "files")
"""What a command adds to its result."""

WRITTEN_BESIDE: Schema = {
    "type": "array",
    "items": {"type": "string"},
    "description": "Files that the command wrote beside, such as that of -o; of --json and --save.",
}


def fits(schema: Schema, value: Any) -> bool:
    return Draft202012Validator(schema).is_valid(value)


def merged(one: Schema | None, other: Schema | None) -> Schema | None:
    """What is one or the other."""
    if one is None or other is None or one == other:
        return one if other is None or one == other else other
    known = sorted({*kinds(one), *kinds(other)})
    both: Schema = {"type": known[0] if len(known) == 1 else known}
    if "number" in known and "integer" in known:
        both["type"] = [kind for kind in known if kind != "integer"]
    for schema in (one, other):
        both |= {key: value for key, value in schema.items() if key == "description"}
    if items := merged(one.get("items"), other.get("items")):
        both["items"] = items
    more = merged(*(_object(schema.get("additionalProperties")) for schema in (one, other)))
    if more:
        both["additionalProperties"] = more
    if "properties" in one or "properties" in other:
        first, second = one.get("properties", {}), other.get("properties", {})
        both["properties"] = {name: merged(first.get(name), second.get(name)) for name in {**first, **second}}
        needed = [schema.get("required", []) for schema in (one, other) if "properties" in schema]
        both["required"] = [name for name in needed[0] if all(name in some for some in needed)]
        both["additionalProperties"] = more or False
    return both


def _object(schema: Any) -> Schema | None:
    return schema if isinstance(schema, dict) else None


def kinds(schema: Schema) -> list[str]:
    found = schema.get("type", [])
    return [found] if isinstance(found, str) else found


def of_type(kind: Any) -> Schema | None:  # noqa: PLR0911
    """The schema of a type; None of one whose JSON does not follow from it."""
    origin, inner = get_origin(kind), get_args(kind)
    if kind in PLAIN:
        return dict(PLAIN[kind])
    if origin in (Union, types.UnionType):
        parts = [of_type(part) for part in inner]
        return None if None in parts else reduce(merged, parts)
    if origin is Literal:
        return {"type": "string", "enum": list(inner)}
    if isinstance(origin, type) and issubclass(origin, Mapping) and len(inner) == 2:
        values = of_type(inner[1])
        return values and {"type": "object", "additionalProperties": values}
    if isinstance(origin, type) and issubclass(origin, Sequence):
        items = [of_type(part) for part in inner if part is not Ellipsis]
        return None if None in items or not items else {"type": "array", "items": reduce(merged, items)}
    if is_dataclass(kind) and not hasattr(kind, "to_json"):
        parts = {field.name: attribute(kind, field.name) for field in fields(kind)}
        return None if None in parts.values() else record(kind, parts)
    return None


def record(kind: Any, properties: Mapping[str, Schema | None]) -> Schema:
    known = kind.__module__.startswith("upright") and kind.__doc__
    about = {"description": sentence(kind.__doc__)} if known else {}
    return {
        "type": "object", **about, "properties": dict(properties), "required": list(properties),
        "additionalProperties": False,
    }  # fmt: skip


@cache
def hint(kind: type, name: str) -> Any:
    """The type of a class's attribute, property or method without arguments; None where it has none."""
    for base in kind.__mro__:
        found = base.__dict__.get(name)
        found = getattr(found, "func", getattr(found, "fget", found))
        annotated = found.__annotations__.get("return") if inspect.isfunction(found) else None
        text = annotated or inspect.get_annotations(base).get(name)
        if text:
            try:
                return eval(str(text), vars(sys.modules[base.__module__]), vars(typing))
            except (NameError, AttributeError, TypeError, SyntaxError):  # of a module that only type checkers import
                return None
    return None


def attribute(kind: type, name: str) -> Schema | None:
    """The schema of an attribute by its type, with its unit and sentence."""
    schema = of_type(hint(kind, name)) if hint(kind, name) is not None else None
    return schema and described(schema, kind, name)


def described(schema: Schema, kind: type, name: str) -> Schema:
    if words := about(kind, name):
        return {"type": schema.get("type"), "description": words} | schema | {"description": words}
    return schema


def sentence(text: str | None) -> str:
    """The first sentence of a docstring."""
    plain = " ".join((text or "").split()).replace("`", "")
    return re.split(r"(?<=[.:;]) ", plain)[0].rstrip(":;")


@cache
def about(kind: type, name: str) -> str:
    """What the class says of an attribute: a property's own sentence, or the unit in brackets behind a field's name."""
    for base in kind.__mro__:
        found = base.__dict__.get(name)
        if isinstance(found, property) or hasattr(found, "func") or inspect.isfunction(found):
            return sentence(found.__doc__)
        own = [f for f in fields(base) if f.name == name and "unit" in f.metadata] if is_dataclass(base) else []
        if own:
            return f"[{own[0].metadata['unit']}]"
        unit = re.search(rf"`{name}`[^`\[\],;.]{{0,40}}\[(?!unit)([^\]`]{{1,12}})\]", base.__doc__ or "")
        if not unit and is_dataclass(base) and base.__module__.startswith("upright"):
            unit = re.search(rf"^    {name}: .*# \[([^\]]+)\]", inspect.getsource(base), re.MULTILINE)
        if unit:
            return f"[{unit[1]}]"
    return ""


def of_value(value: Any, thing: Any = None, name: str = "") -> Schema:
    """The schema of a value in JSON, which was made of a `thing`."""
    if isinstance(value, dict):
        return of_object(value, thing, name)
    if isinstance(value, list | tuple):
        same = isinstance(thing, Sequence) and not isinstance(thing, str) and len(thing) == len(value)
        items = [of_value(v, t, name) for v, t in zip(value, thing if same else [None] * len(value), strict=True)]
        return {"type": "array", "items": reduce(merged, items)} if items else {"type": "array"}
    if value is None:
        return {"type": ["null", "string"]} if name in TEXT else {"type": "null"}
    return dict(PLAIN[type(value)])


def of_object(value: Mapping[str, Any], thing: Any, name: str) -> Schema:
    if name in OPEN or name in VARIED:
        return {"type": "object"}  # of anything
    if name in NAMED or (isinstance(thing, Mapping) and {str(k) for k in thing} == set(value)):
        things = {str(k): v for k, v in thing.items()} if isinstance(thing, Mapping) else {}
        parts = [of_value(v, things.get(k)) for k, v in value.items()]
        return {"type": "object", "additionalProperties": reduce(merged, parts)} if parts else {"type": "object"}
    if not value:
        return {"type": "object"}
    same = sum(hasattr(thing, key) for key in value) > len(value) / 2
    return record(type(thing) if same else dict, {key: of_key(key, v, thing) for key, v in value.items()})


def of_key(key: str, value: Any, thing: Any) -> Schema:
    if key == "schema":
        return {"const": value}
    if key in CHOICES:
        return {"type": "string", "enum": CHOICES[key]}
    if key in TEXT and not isinstance(value, dict):
        return {"type": ["null", "string"]}
    key = ATTRIBUTES.get(key, key)
    owners = (thing, *(getattr(thing, part, None) for part in PARTS))
    thing = next((owner for owner in owners if hasattr(owner, key)), thing)
    kind = type(thing)
    declared = attribute(kind, key)
    if declared and fits(declared, value):
        if not value and "object" in kinds(declared.get("items", {})):
            declared.pop("items")  # of which nothing was written to compare with
        return declared
    owned = getattr(thing, key, None)
    if inspect.ismethod(owned) and not inspect.signature(owned).parameters:
        owned = owned()
    schema = of_value(value, owned, key)
    if value is None and hint(kind, key) is not None and not declared:
        schema = {"type": ["null", "object"]}
    if type(None) in get_args(hint(kind, key)):
        schema = merged(schema, {"type": "null"}) or schema
    return described(schema, kind, key)


def schema_of(data: Mapping[str, Any], result: Any) -> Schema:
    """The schema of what a command printed as JSON of its result."""
    made = record(type(result), {key: of_key(key, value, result) for key, value in data.items() if key not in BESIDE})
    # a command adds what it wrote
    return made | {"required": [key for key in made["required"] if key in result.to_json()]}


def numbers_too(schema: Any, at: str = "") -> Any:
    """With numbers where only null was written; raises where neither a type nor `NUMBERS` says that it is one."""
    if isinstance(schema, list):
        return [numbers_too(part, at) for part in schema]
    if not isinstance(schema, dict):
        return schema
    if schema.get("type") == "null":
        assert NUMBERS & set(at.split("/")), f"what is{at} where it is not null?"
        return schema | {"type": ["null", "number"]}
    return {key: numbers_too(part, f"{at}/{key}") for key, part in schema.items()}


def written(schema: Schema) -> Schema:
    """The file of a schema, which may begin with the head of a command's JSON."""
    named = schema["properties"]["schema"]["const"]
    schema = numbers_too(schema)
    first = {"$schema": "https://json-schema.org/draft/2020-12/schema", "$id": named, "title": named}
    return first | schema | {"properties": {"head": HEAD} | schema["properties"] | {"files": WRITTEN_BESIDE}}


MADE = {
    "run.csv": "example excited", "standing.csv": "example standing", "fall.csv": "example fall",
    "pushed.csv": "example pushed",
    "handed-in": "example handed-in", "lqg.json": "design lqg", "balance.c": "firmware --target c lqg.json",
    "a.csv": "simulate --push impulse:0.1 --seconds 2", "b.csv": "simulate --push impulse:1 --seconds 2",
    "foreign.csv": "", "damaged": "example handed-in",
}  # fmt: skip
"""File that a run reads → the command that writes it, with -o; a foreign log says nothing of where it comes from."""

SWEEP = """
robots = ["nxtway-gs"]
controllers = ["lqr", "lqg"]
n = 40
seconds = 1.0
vary = ["spread"]

[grid]
"motor.dead_zone" = [0.0, 0.4]

[[scenario]]
name = "knock"
push = [{ kind = "impulse", impulse = 0.3, start = 0.1 }]
"""

OWN = (FOLDER.parents[3] / "docs" / "extend.md").read_text("utf-8").partition("```python\n")[2].partition("```")[0]
"""The first program of that page: a controller of one's own."""

WRITTEN = {"own.py": OWN, "sweep.toml": SWEEP, "kept.toml": f'keep = ["peak_pitch"]\n{SWEEP}'}

QUICK = """
simulate --seconds 1
simulate --push impulse:0.1 --seconds 2
simulate --push impulse:1 --seconds 2 -o log.csv
compare a.csv b.csv
compare a.csv run.csv
linearise -o model.json
doctor run.csv
doctor standing.csv --robot nxtway-gs
robots show nxtway-gs
doctor fall.csv --fix fixed.csv
fleet --samples 40 --seconds 1
fleet --samples 40 --seconds 1 --vary com_height=±10% --push impulse:0.3
fleet --samples 300 --vary com_height=±10% --push impulse:0.3
push-map --points 3 --samples 0
push-map --points 3 --samples 2 --watch 1
basin --points 5 --watch 1
basin --points 5 --watch 1 --across pitch=0.5..1
simulate --robot stepper --push impulse:2 --seconds 2
compare a.csv foreign.csv
push-map --points 3 --samples 0 --direction forward
fleet --samples 40 --seconds 1 --push impulse:9
sweep sweep.toml --workers 0
sweep kept.toml --workers 0
certify lqg --samples 100
""".strip().splitlines()

LONG = """
design lqr -o lqr.json
design own.py:Quiet
design lqg
design pid-angle --robot balrob
design sliding
design mpc
design lqg --kit ideal
design pid-angle --robot balrob --gains kp=5,ki=1,kd=0.1
tune lqr --budget 8 --samples 100 --time-limit 2
bench-controllers lqg sliding
certify pid-angle --samples 100 --robot balrob
certify lqg --samples 100 --log standing.csv
calibrate run.csv
calibrate standing.csv
validate nxtway-gs run.csv
identify run.csv --method subspace --repeats 2
identify run.csv --repeats 2
excite --seconds 2 --samples 300
post-mortem fall.csv
post-mortem run.csv
parity balance.c lqg.json
grade handed-in
grade damaged
reproduce --log pushed.csv --robot nxtway-gs --push impulse:0.06,start=3 --push impulse:-0.06,start=7 -o mine
""".strip().splitlines()
"""Commands that together write every key of every result, those of a second or two apart."""


def make(file: str) -> None:
    """Write a file that a run reads into this folder, unless it is there."""
    from upright.cli.main import main

    if Path(file).exists() or file not in MADE | WRITTEN:
        return
    if file in WRITTEN:
        Path(file).write_text(WRITTEN[file], "utf-8")
        return
    if file == "damaged":
        make("handed-in")
        shutil.copytree("handed-in", file)
        Path(file, "zz.json").write_text("{", "utf-8")
        return
    if file == "foreign.csv":
        make("a.csv")
        log = Log.load("a.csv")
        Log(log.t, log.channels, log.units).save(file)
        return
    command = MADE[file].split()
    for word in command[2:]:
        make(word)
    assert main([*command, "-o", file]) == 0


def ran(command: str) -> tuple[dict[str, Any], Any]:
    """The JSON that a command prints in this folder, and the result that it is of."""
    from upright.cli.destination import Destination
    from upright.cli.main import main
    from upright.cli.output import AGAINST

    results: list[Any] = []
    finish = Destination.finish

    def kept(self: Destination, result: Any, *written: Path | None, **facts: Any) -> None:
        results.append(result)
        finish(self, result, *written, **facts)

    raw = io.BytesIO()
    with contextlib.redirect_stdout(io.StringIO()):
        for word in command.split():
            make(word.partition(":")[0])
    Destination.finish = kept
    try:
        with contextlib.redirect_stdout(io.TextIOWrapper(raw, "utf-8", write_through=True)):
            code = main([*command.split(), "--json"])
    finally:
        Destination.finish = finish
    assert code in (0, AGAINST), (command, code)
    return json.loads(raw.getvalue()), results[0]


def write_all() -> None:
    """Write the schema of every kind; one of the same version stays, but for --again."""
    found: dict[str, Schema] = {}
    os.chdir(tempfile.mkdtemp())
    for command in (*QUICK, *LONG):
        print(command, file=sys.stderr)
        data, result = ran(command)
        schema = schema_of(data, result)
        found[data["schema"]] = merged(found.get(data["schema"]), schema) or schema
    for named, schema in found.items():
        target = FOLDER / f"{named.split('/')[1]}.json"
        text = json.dumps(written(schema), indent=1, ensure_ascii=False) + "\n"
        old = target.read_text("utf-8") if target.exists() else ""
        if old and json.loads(old)["$id"] == named and "--again" not in sys.argv:
            print(f"{named}: {'as it was' if old == text else 'has changed, and needs another version'}")
            continue
        target.write_text(text, "utf-8")


if __name__ == "__main__":
    write_all()
