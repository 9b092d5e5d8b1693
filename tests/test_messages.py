"""What the command line says in one line is found in its catalogue, and shown in Spanish where that is asked for."""

from __future__ import annotations

import gettext
import re
from pathlib import Path

import pytest

import messages
from upright import errors
from upright.cli.help import EXAMPLES
from upright.cli.main import main
from upright.languages import chosen, speaking
from upright.messages import HOLE, catalogue, in_language, sections
from upright.progress import progress

SYSTEM = ("UPRIGHT_LANG", "LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")
FACT = "x7"


def filled(template: str) -> str:
    return " ".join(template.replace(HOLE, FACT).split())


def test_every_message_has_a_translation_and_none_is_left_over() -> None:
    here = sections("es")["here"]
    assert messages.missing(here) == {}
    assert messages.left_over(here) == []


def test_a_translation_has_the_facts_of_its_message() -> None:
    held = {text: other for text, other in catalogue("es").items() if HOLE in text}
    wrong = [text for text, other in held.items() if text.count(HOLE) != len(messages.holes(other))]
    assert wrong == []


def test_every_message_is_found_by_itself() -> None:
    """The template that is meant, and not another that fits its line, too; nothing of it stays English."""
    with speaking("es"):
        told = {text: in_language(filled(text)) for text in messages.found()}
    assert {text: line for text, line in told.items() if messages.still_english(line)} == {}
    here = sections("es")["here"]
    plain = {text: other for text, other in here.items() if text in told and "{{" not in other}
    assert {text: told[text] for text, other in plain.items() if told[text] != filled(other)} == {}


def test_help_is_spanish() -> None:
    with speaking("es"):
        told = {sentence: in_language(sentence) for sentence, _ in messages.helped()}
    assert {sentence: line for sentence, line in told.items() if messages.still_english(line)} == {}
    assert [sentence for sentence, line in told.items() if line == sentence and messages.worded(sentence)] == []


@pytest.mark.parametrize(
    ("typed", "line"),
    [
        ("simulate --robot nxtwai", "no hay robot con el nombre 'nxtwai'; se esperaba uno de balrob, "),
        ("simulate --sedes 1", "no existe la opción --sedes"),
        ("simulate -s abc", "--seconds: 'abc'; se esperaba un número"),
        ("identify a.csv --order 99", "--order: '99'; se esperaba 50 o menos"),
        ("design", "falta el argumento 'method'; pruebe: upright design lqg -o controller.json"),  # a command stays
        ("design lqg --gains kp=1", "lqg no recibe números propios; se esperaba un método como pid-angle; "
         "pruebe: upright design --help"),
        ("robots new mine --gear x", "Engranaje, vueltas del motor en una de la rueda: 'x'; se esperaba un número"),
        ("start film", "no se puede escribir film: el archivo ya existe"),
        ("simulat", "no existe el comando 'simulat'. ¿Quiso decir 'simulate'?"),
        ("doctor log", "no existe el archivo log; pruebe: revise la ruta"),  # a name is no word of ours
        ("design lqg --save no/k.json", "no existe la carpeta no para k.json; pruebe: mkdir -p no"),
        ("certify broken.json", "broken.json no es JSON (falta un nombre entre comillas dobles: línea 2 columna 1"),
        ("compare empty.csv", "empty.csv: "),
        ("simulate --excite x.json", "x.json: JSON sin «schema»; se esperaba upright/excite/"),
        ("simulate --robot bad.toml", 'bad.toml es TOML dañado: "Expected '),  # tomllib's own words
        ("simulate -c my.py:Rod", "controlador my.py:Rod da Rod sin applied, "),
        ("doctor my.py", "my.py: las filas no se pueden leer ("),
        ("simulate --lying 1.5", "nxtway-gs no puede levantarse desde 1.5 rad: 7.68 V lo regresan desde"),
    ],
)  # fmt: skip
def test_a_mistake_is_answered_in_spanish(
    typed: str, line: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("broken.json").write_text("{\n")
    Path("empty.csv").write_text("")
    Path("film").write_text("")
    Path("x.json").write_text('{"a": 1}')
    Path("bad.toml").write_text("[body\n")
    Path("my.py").write_text("class Rod:\n    def __init__(self, *a): self.a, self.b, self.c = 1, 2, 3\n")
    monkeypatch.setenv("UPRIGHT_LANG", "es")
    assert main(typed.split()) == 2
    told = capsys.readouterr().err
    assert told.startswith(f"upright: {line}")
    assert not messages.still_english(told)


def test_a_command_to_type_stays_and_the_words_beside_it_do_not() -> None:
    """Every example of the help, behind which a message says more."""
    with speaking("es"):
        for line in (line for lines in EXAMPLES.values() for line in lines):
            assert in_language(f"no; try: {line}") == f"ningún; pruebe: {line}"
            assert (
                in_language(f"no; try: {line}, which tries it again")
                == f"ningún; pruebe: {line}, que lo intenta de nuevo"
            )


def test_what_is_waited_for_is_said_in_spanish(monkeypatch, capsys: pytest.CaptureFixture[str]) -> None:
    monkeypatch.setattr("upright.progress.QUIET", -1.0)
    with speaking("es"), progress("identifying") as show:
        show(0.5)
    assert capsys.readouterr().err.startswith("identificando: 50 %, faltan unos")


def test_help_is_translated_and_names_are_not(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("UPRIGHT_LANG", "es")
    main(["example", "--help"])
    told = capsys.readouterr().out
    assert told.startswith("Uso: upright example [OPCIONES]")
    assert "Opciones:\n" in told
    assert "Ejemplos:\n    upright example\n" in told
    main(["--help"])
    told = capsys.readouterr().out
    assert re.search(r"^  film +Hace una película", told, re.M)  # "film" is also a word of ours


def test_in_english_nothing_is_looked_up() -> None:
    sections.cache_clear()
    with speaking("en"):
        text = "no robot is called 'a'; expected one of b\n  its second  line"
        assert in_language(text) is text
    assert sections.cache_info().misses == 0


@pytest.mark.parametrize(
    "text",
    [
        "a plug-in's own words; expected something of it",
        "no robot is called 'log'",
        "/home/a/of the log.csv: no file",
        "",
    ],
)
def test_what_is_no_message_stays(text: str) -> None:
    with speaking("es"):
        told = in_language(text)
    for name in ("a plug-in's own words", "something of it", "'log'", "/home/a/of the log.csv"):
        assert (name in told) == (name in text)


@pytest.mark.parametrize(
    "stated",
    [
        {"LANG": "es_EC.UTF-8"},
        {"LANG": "en_US.UTF-8"},
        {"LANG": "C"},
        {"LANG": "de_DE"},
        {"LANG": "es", "LC_ALL": "C.UTF-8"},
        {"LANG": "C", "LC_ALL": "es_ES@euro"},
        {"LANG": "en_GB", "LC_MESSAGES": "es_MX"},
        {"LANG": "es_EC", "LC_MESSAGES": "en_GB", "LC_ALL": ""},
        {"LANG": "en_GB", "LANGUAGE": "qu:es:en"},
        {"LANG": "es_EC", "LANGUAGE": "en:es"},
        {"LANG": "es_EC", "LANGUAGE": "C:es"},
        {"LANG": "estonian"},
        {},
    ],
    ids=str,
)  # fmt: skip
def test_the_systems_language_is_that_of_gettext(
    stated: dict[str, str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Python's gettext, asked which of two catalogues it would read, agrees."""
    for name in SYSTEM:
        monkeypatch.delenv(name, raising=False)
    for name, value in stated.items():
        monkeypatch.setenv(name, value)
    for language in ("en", "es"):
        (tmp_path / language / "LC_MESSAGES").mkdir(parents=True)
        (tmp_path / language / "LC_MESSAGES" / "upright.mo").touch()
    path = gettext.find("upright", tmp_path)
    assert chosen() == (Path(path).relative_to(tmp_path).parts[0] if path else "en")
    monkeypatch.setenv("UPRIGHT_LANG", "en")  # which counts more
    assert chosen() == "en"


def test_data_stay_english(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    def told(language: str) -> tuple[str, str]:
        monkeypatch.setenv("UPRIGHT_LANG", language)
        path = tmp_path / "model.json"
        assert main(["linearise", "--json", "--save", str(path)]) == 0
        return capsys.readouterr().out, path.read_text("utf-8")

    assert told("es") == told("en")


def test_an_error_has_its_parts() -> None:
    error = errors.InvalidLog("no time", expected="a column", likely="another file", hint="name it")
    assert error.parts == {"came": "no time", "expected": "a column", "likely": "another file", "hint": "name it"}
    assert str(error) == "no time; expected a column; likely another file; try: name it"
